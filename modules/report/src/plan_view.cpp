// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brash/report/pictures.hpp"
#include "brash/structure/hull.hpp"
#include "chart.hpp"
#include "drawing.hpp"

namespace brash::report {
namespace {

constexpr double kPixelsPerMetre = 18.0;
constexpr double kBorder = 2.0;  ///< open water shown around ice and structure [m]

/// The least rectangle around points.
struct Extent {
  Vec2 lower{1e300, 1e300};
  Vec2 upper{-1e300, -1e300};

  void include(Vec2 point) {
    lower = {std::min(lower.x, point.x), std::min(lower.y, point.y)};
    upper = {std::max(upper.x, point.x), std::max(upper.y, point.y)};
  }
};

/// @param style  of the page.
std::string of_class(const char* style) { return fmt::format("fill-rule=\"evenodd\" class=\"{}\"", style); }

/// The floe's mid-plane as it lies, seen from above.
std::vector<std::vector<Vec2>> seen_from_above(const model::FloeRecord& floe, const Pose& pose) {
  std::vector<std::vector<Vec2>> rings = floe.rings;
  for (std::vector<Vec2>& ring : rings)
    for (Vec2& v : ring) v = plan(to_world(pose, {v.x, v.y, 0.0}));
  return rings;
}

Extent extent_of(const std::vector<structure::Outline>& waterline, const model::RunResults& results) {
  Extent view;
  for (const structure::Outline& outline : waterline)
    for (const Vec2 vertex : outline) view.include(vertex);
  for (const std::vector<Vec2>& ring : results.initial_sheet)
    for (const Vec2 vertex : ring) view.include(vertex);
  for (const model::FloePose& floe : results.frames.back().floes) {
    view.include(plan(floe.pose.position));
    if (!results.initial_sheet.empty()) continue;  // in level ice no floe lies farther out than the sheet
    for (const auto& ring : seen_from_above(results.floes[static_cast<std::size_t>(floe.floe)], floe.pose))
      for (const Vec2 vertex : ring) view.include(vertex);
  }
  const Vec2 border{kBorder, kBorder};
  return {view.lower - border, view.upper + border};
}

void draw_floes(const model::Case& resolved, const model::RunResults& results, Drawing& drawing) {
  std::vector<const model::FloePose*> lowest_first;
  for (const model::FloePose& floe : results.frames.back().floes) lowest_first.push_back(&floe);
  std::ranges::stable_sort(lowest_first, {}, [](const model::FloePose* f) { return f->pose.position.z; });
  for (const model::FloePose* floe : lowest_first) {
    const bool sunk = floe->pose.position.z < -resolved.ice.thickness;
    drawing.rings(seen_from_above(results.floes[static_cast<std::size_t>(floe->floe)], floe->pose),
                  of_class(sunk ? "sunk" : "floe"));
  }
}

/// @param lower  corner of the drawing [m].
void draw_scale_bar(Vec2 lower, Drawing& drawing) {
  const Vec2 from = drawing.on_page(lower + Vec2{1.0, 0.8});
  drawing.add(fmt::format(
      "<rect x=\"{4:.1f}\" y=\"{5:.1f}\" width=\"{6:.1f}\" height=\"32\" rx=\"4\" fill=\"#fff\"/>"
      "<path d=\"M{0:.1f} {1:.1f}h{2:.1f}\" stroke=\"#000\" stroke-width=\"3\"/>"
      "<text x=\"{0:.1f}\" y=\"{3:.1f}\" class=\"label\">5 m</text>\n",
      from.x, from.y, 5.0 * kPixelsPerMetre, from.y - 6.0, from.x - 8.0, from.y - 23.0, 5.0 * kPixelsPerMetre + 16.0));
}

constexpr const char* kStyle =
    "<style>.water{fill:#2c5f7c}.land{fill:#8a7f6a}.sheet{fill:#e9f1f5;stroke:#5b7c8d;stroke-width:1}"
    ".floe{fill:#bcd9e6;stroke:#1f3b4a;stroke-width:.8}.sunk{fill:#5d93ae;stroke:#1f3b4a;stroke-width:.8;opacity:.85}"
    ".structure{fill:#d98032;fill-opacity:.55;stroke:#7a3f0c;stroke-width:1.5}.break{fill:#b3261e}"
    ".label{font:15px sans-serif;fill:#000}</style>\n";

}  // namespace

std::string plan_view(const model::Case& resolved, const model::RunResults& results,
                      const std::vector<std::vector<std::vector<Vec2>>>& land) {
  const Pose& pose = results.frames.back().structure;
  const auto waterline = structure::make_hull(resolved.structure)->footprint(pose, 0.0, 0.0).leading;
  const Extent extent = extent_of(waterline, results);
  Drawing drawing({}, kPixelsPerMetre, extent.lower, extent.upper);
  for (const std::vector<std::vector<Vec2>>& rings : land) drawing.rings(rings, of_class("land"));
  drawing.rings(results.final_sheet, of_class("sheet"));
  draw_floes(resolved, results, drawing);
  drawing.rings(waterline, of_class("structure"));
  for (const model::CrackEvent& event : results.events) {
    const Vec2 at = drawing.on_page(event.at);
    drawing.add(fmt::format("<circle class=\"break\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\"/>\n", at.x, at.y));
  }
  draw_scale_bar(extent.lower, drawing);
  return svg_page(drawing.size().x, drawing.size().y, drawing.svg(), kStyle,
                  "class=\"water\" width=\"100%\" height=\"100%\"");
}

}  // namespace brash::report
