// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/core/vec.hpp"

namespace brash::report {

/// Outlines to scale, as part of an SVG picture: y upwards in metres, downwards on the page.
class Drawing {
 public:
  /// @param corner        upper left one, on the page [pixels].
  /// @param scale         pixels in a metre.
  /// @param lower, upper  corners of the drawn plan [m].
  Drawing(Vec2 corner, double scale, Vec2 lower, Vec2 upper)
      : corner_(corner), scale_(scale), lower_(lower), upper_(upper) {}

  Vec2 on_page(Vec2 p) const { return {corner_.x + scale_ * (p.x - lower_.x), corner_.y + scale_ * (upper_.y - p.y)}; }
  Vec2 size() const { return scale_ * (upper_ - lower_); }  ///< [pixels]
  double pixels(double length) const { return scale_ * length; }

  /// Rings as one path.
  /// @param attributes  of SVG, such as class="hull".
  void rings(const std::vector<std::vector<Vec2>>& rings, const std::string& attributes);
  /// The same, as far as it lies in the drawing.
  void rings_within(const std::vector<std::vector<Vec2>>& rings, const std::string& attributes);
  void box(Vec2 lower, Vec2 upper, const std::string& attributes);
  void line(const std::vector<Vec2>& places, const std::string& attributes);
  /// Elements of SVG in the pixels of the page.
  void add(const std::string& elements) { svg_ += elements; }

  const std::string& svg() const { return svg_; }

 private:
  std::string path_along(const std::vector<Vec2>& places) const;

  Vec2 corner_;
  double scale_;
  Vec2 lower_, upper_;
  std::string svg_{};
};

}  // namespace brash::report
