// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing.hpp"

#include <fmt/format.h>

namespace brash::report {

std::string Drawing::path_along(const std::vector<Vec2>& places) const {
  std::string data;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec2 p = on_page(places[i]);
    data += fmt::format("{}{:.1f} {:.1f}", i == 0 ? "M" : "L", p.x, p.y);
  }
  return data;
}

void Drawing::rings(const std::vector<std::vector<Vec2>>& rings, const std::string& attributes) {
  std::string data;
  for (const std::vector<Vec2>& ring : rings) data += path_along(ring) + "Z";
  svg_ += fmt::format("<path d=\"{}\" {}/>\n", data, attributes);
}

void Drawing::rings_within(const std::vector<std::vector<Vec2>>& within, const std::string& attributes) {
  const Vec2 corner = on_page({lower_.x, upper_.y});
  svg_ += fmt::format(
      "<svg x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{3:.1f}\" "
      "viewBox=\"{0:.1f} {1:.1f} {2:.1f} {3:.1f}\">\n",
      corner.x, corner.y, size().x, size().y);
  rings(within, attributes);
  svg_ += "</svg>\n";
}

void Drawing::box(Vec2 lower, Vec2 upper, const std::string& attributes) {
  rings({{lower, {upper.x, lower.y}, upper, {lower.x, upper.y}}}, attributes);
}

void Drawing::line(const std::vector<Vec2>& places, const std::string& attributes) {
  svg_ += fmt::format("<path d=\"{}\" {}/>\n", path_along(places), attributes);
}

}  // namespace brash::report
