// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>
#include <vector>

#include "brash/report/pictures.hpp"
#include "brash/structure/hull.hpp"
#include "brash/structure/motion.hpp"
#include "chart.hpp"
#include "drawing.hpp"

namespace brash::report {
namespace {

constexpr double kWidth = 900.0, kMargin = 40.0, kTitle = 30.0;  // [pixels]
/// Sections of the hull on each side of the middle one, and waterlines below and above the water's surface.
constexpr int kSections = 4;

using structure::Outline;

/// A drawing over the width of the page, under its title.
class Panel {
 public:
  /// @param top  of the panel on the page.
  Panel(double top, Vec2 lower, Vec2 upper, const std::string& title)
      : top_(top + kTitle),
        drawing_({kMargin, top_}, (kWidth - 2.0 * kMargin) / (upper.x - lower.x), lower, upper),
        width_(upper.x - lower.x) {
    drawing_.add(fmt::format("<text x=\"{}\" y=\"{:.1f}\" class=\"title\">{}</text>\n", kMargin, top + 18.0, title));
  }

  double bottom() const { return top_ + drawing_.size().y + 12.0; }
  const std::string& svg() const { return drawing_.svg(); }

  void rings(const std::vector<Outline>& outlines, const char* style) { drawing_.rings(outlines, of_class(style)); }
  void rings_within(const std::vector<Outline>& outlines, const char* style) {
    drawing_.rings_within(outlines, of_class(style));
  }
  void box(Vec2 lower, Vec2 upper, const char* style) { drawing_.box(lower, upper, of_class(style)); }
  void line(const std::vector<Vec2>& places, const char* style) { drawing_.line(places, of_class(style)); }
  /// A length of one, two or five times a power of ten, a fifth of the panel at most.
  void scale_bar() {
    const double most = 0.2 * width_, power = std::pow(10.0, std::floor(std::log10(most)));
    const double length = most >= 5.0 * power ? 5.0 * power : most >= 2.0 * power ? 2.0 * power : power;
    const double x = kWidth - kMargin - drawing_.pixels(length), y = top_ - 12.0;
    drawing_.add(
        fmt::format("<path d=\"M{:.1f} {:.1f}h{:.1f}\" class=\"bar\"/><text x=\"{:.1f}\" y=\"{:.1f}\" "
                    "class=\"scale\">{:g} m</text>\n",
                    x, y, drawing_.pixels(length), x - 6.0, y + 5.0, length));
  }

 private:
  static std::string of_class(const char* style) { return fmt::format("class=\"{}\"", style); }

  double top_;
  Drawing drawing_;
  double width_;  ///< [m]
};

/// The hull on its side: its z lies along the world's y and its y points down, so that a level section is one along it.
Pose on_its_side() { return {{}, {std::sqrt(0.5), -std::sqrt(0.5), 0.0, 0.0}}; }

/// Height of the bed of the water, if a picture of a hull that reaches down to `keel` has room for it: its height below
/// the keel at most [m].
std::optional<double> bed_in_sight(const model::Case& c, double keel, double height) {
  if (!c.water.depth || *c.water.depth > height - keel) return std::nullopt;
  return -*c.water.depth;
}

/// The section of the hull in the plane y, as x and z.
std::vector<Outline> section_along(const structure::Hull& hull, double y) {
  return hull.footprint(on_its_side(), -y, -y).leading;
}

Panel side_view(const model::Case& c, const structure::Hull& hull, double top) {
  const auto [least, most] = hull.bounds();
  const double border = 0.1 * (most.x - least.x);
  const std::optional<double> bed = bed_in_sight(c, least.z, most.z - least.z);
  const double bottom = std::min(least.z, bed.value_or(0.0)) - 0.2 * border;
  Panel panel(top, {least.x - border, bottom}, {most.x + border, most.z + 0.2 * border},
              bed ? "Sections along the hull, the water's surface, its bed and the ice"
                  : "Sections along the hull, the water's surface and the ice");
  if (bed) panel.box({least.x - border, bottom}, {most.x + border, *bed}, "land");
  const double draught = c.ice.thickness * c.ice.density / c.water.density;
  panel.box({most.x - 0.5 * border, -draught}, {most.x + border, c.ice.thickness - draught}, "ice");
  for (int i = -kSections; i <= kSections; ++i) {
    const double y = least.y + (most.y - least.y) * (0.5 + 0.5 * i / (kSections + 0.5));
    panel.rings(section_along(hull, y), i == 0 ? "hull" : "thin");
  }
  panel.line({{least.x - border, 0.0}, {most.x + border, 0.0}}, "surface");
  panel.scale_bar();
  return panel;
}

Panel plan(const structure::Hull& hull, double top) {
  const auto [least, most] = hull.bounds();
  const double border = 0.1 * (most.x - least.x);
  Panel panel(top, {least.x - border, least.y - 0.2 * border}, {most.x + border, most.y + 0.2 * border},
              "Waterlines from above; the bow is on the right");
  panel.rings(hull.footprint({}, 0.0, 0.0).leading, "hull");
  for (int i = 0; i < 2 * kSections; ++i) {
    const double z = least.z + (most.z - least.z) * (i + 0.5) / (2 * kSections);
    panel.rings(hull.footprint({}, z, z).leading, "thin");
  }
  panel.scale_bar();
  return panel;
}

Panel field(const model::Case& c, const structure::Hull& hull, const PicturedIce& ice, double top) {
  const auto* const towed = std::get_if<model::Towed>(&c.structure.motion);
  const int n_parts = towed != nullptr && !towed->path.empty() ? 100 : 1;
  const double half = 0.5 * c.field.width;
  const auto [least, most] = hull.bounds();
  Vec2 lower{0.0, -half}, upper{c.field.length, half};
  std::vector<Pose> poses;
  std::vector<Vec2> way;
  for (int i = 0; i <= n_parts; ++i) {
    const Pose pose = structure::unresisted(c.structure, c.time.duration * i / n_parts);
    poses.push_back(pose);
    way.push_back(plan(pose.position));
    for (const Vec2 corner : {plan(least), Vec2{most.x, least.y}, plan(most), Vec2{least.x, most.y}}) {
      const Vec2 at = plan(to_world(pose, {corner.x, corner.y, 0.0}));
      lower = {std::min(lower.x, at.x), std::min(lower.y, at.y)};
      upper = {std::max(upper.x, at.x), std::max(upper.y, at.y)};
    }
  }
  lower = lower - Vec2{2.0, 2.0};
  upper = upper + Vec2{2.0, 2.0};
  Panel panel(top, lower, upper, "The field; the structure at the start, and without resistance at the end");
  panel.box(lower, upper, "water");
  for (const std::vector<Outline>& land : ice.land) panel.rings_within(land, "land");
  for (const std::vector<Outline>& sheet : ice.sheets) panel.rings(sheet, "ice sheet");
  for (const std::vector<Outline>& floe : ice.floes) panel.rings(floe, "ice floe");
  panel.rings(hull.footprint(poses.front(), 0.0, 0.0).leading, "hull");
  panel.line(way, "way");
  panel.rings(hull.footprint(poses.back(), 0.0, 0.0).leading, "end");
  panel.scale_bar();
  return panel;
}

constexpr const char* kStyle =
    "<style>text{font:13px sans-serif;fill:#222}.title{font-weight:600}.scale{text-anchor:end}"
    ".hull{fill:#d98032;fill-opacity:.35;stroke:#7a3f0c;stroke-width:1.6}.thin{fill:none;stroke:#7a3f0c;stroke-width:."
    "6}"
    ".ice{fill:#dbe9f0;stroke:#5b7c8d}.sheet{fill-rule:evenodd}.floe{stroke-width:.4;fill-rule:evenodd}.land{fill:#"
    "8a7f6a;fill-rule:evenodd}.water{fill:#"
    "2c5f7c}.surface{stroke:#"
    "1d6fa5;stroke-width:1.2}"
    ".way{fill:none;stroke:#7a3f0c;stroke-dasharray:6 4}.end{fill:none;stroke:#7a3f0c;stroke-dasharray:4 3}"
    ".bar{stroke:#222;stroke-width:3}</style>\n";

}  // namespace

std::string case_picture(const model::Case& resolved, const PicturedIce& of_start) {
  const auto hull = structure::make_hull(resolved.structure);
  const Panel side = side_view(resolved, *hull, 10.0);
  const Panel above = plan(*hull, side.bottom());
  const Panel ice = field(resolved, *hull, of_start, above.bottom());
  return svg_page(kWidth, ice.bottom() + 10.0, side.svg() + above.svg() + ice.svg(), kStyle);
}

}  // namespace brash::report
