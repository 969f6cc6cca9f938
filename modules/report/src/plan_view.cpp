// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/report/plan_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brash/structure/hull.hpp"

namespace brash::report {
namespace {

constexpr double kPixelsPerMetre = 18.0;
constexpr double kBorder = 2.0;  ///< open water shown around ice and structure [m]

struct View {
  Vec2 lower{1e300, 1e300};
  Vec2 upper{-1e300, -1e300};

  void include(Vec2 point) {
    lower = {std::min(lower.x, point.x), std::min(lower.y, point.y)};
    upper = {std::max(upper.x, point.x), std::max(upper.y, point.y)};
  }
  void grow(double border) {
    lower = lower - Vec2{border, border};
    upper = upper + Vec2{border, border};
  }
  /// y grows downwards on the page.
  Vec2 on_page(Vec2 point) const { return kPixelsPerMetre * Vec2{point.x - lower.x, upper.y - point.y}; }
};

std::string path_data(const View& view, const std::vector<Vec2>& ring) {
  std::string data;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 p = view.on_page(ring[i]);
    data += fmt::format("{}{:.1f} {:.1f}", i == 0 ? "M" : "L", p.x, p.y);
  }
  return data + "Z";
}

std::string rings_path(const View& view, const std::vector<std::vector<Vec2>>& rings, const std::string& style) {
  std::string data;
  for (const std::vector<Vec2>& ring : rings) data += path_data(view, ring);
  return fmt::format("<path d=\"{}\" fill-rule=\"evenodd\" {}/>\n", data, style);
}

/// The floe's mid-plane as it lies, seen from above.
std::vector<std::vector<Vec2>> seen_from_above(const model::FloeRecord& floe, const Pose& pose) {
  std::vector<std::vector<Vec2>> rings = floe.rings;
  for (std::vector<Vec2>& ring : rings)
    for (Vec2& v : ring) v = plan(to_world(pose, {v.x, v.y, 0.0}));
  return rings;
}

View view_of(const std::vector<structure::Outline>& waterline, const model::RunResults& results) {
  View view;
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
  view.grow(kBorder);
  return view;
}

std::string floes(const View& view, const model::Case& resolved, const model::RunResults& results) {
  std::vector<const model::FloePose*> lowest_first;
  for (const model::FloePose& floe : results.frames.back().floes) lowest_first.push_back(&floe);
  std::ranges::stable_sort(lowest_first, {}, [](const model::FloePose* f) { return f->pose.position.z; });
  std::string svg;
  for (const model::FloePose* floe : lowest_first) {
    const bool sunk = floe->pose.position.z < -resolved.ice.thickness;
    svg += rings_path(view, seen_from_above(results.floes[static_cast<std::size_t>(floe->floe)], floe->pose),
                      sunk ? "class=\"sunk\"" : "class=\"floe\"");
  }
  return svg;
}

std::string scale_bar(const View& view) {
  const Vec2 from = view.on_page(view.lower + Vec2{1.0, 0.8});
  return fmt::format(
      "<rect x=\"{4:.1f}\" y=\"{5:.1f}\" width=\"{6:.1f}\" height=\"32\" rx=\"4\" fill=\"#fff\"/>"
      "<path d=\"M{0:.1f} {1:.1f}h{2:.1f}\" stroke=\"#000\" stroke-width=\"3\"/>"
      "<text x=\"{0:.1f}\" y=\"{3:.1f}\" class=\"label\">5 m</text>\n",
      from.x, from.y, 5.0 * kPixelsPerMetre, from.y - 6.0, from.x - 8.0, from.y - 23.0, 5.0 * kPixelsPerMetre + 16.0);
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
  const View view = view_of(waterline, results);
  const Vec2 size = kPixelsPerMetre * (view.upper - view.lower);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\">\n{2}<rect class=\"water\" width=\"100%\" height=\"100%\"/>\n",
      size.x, size.y, kStyle);
  for (const std::vector<std::vector<Vec2>>& rings : land) svg += rings_path(view, rings, "class=\"land\"");
  svg += rings_path(view, results.final_sheet, "class=\"sheet\"");
  svg += floes(view, resolved, results);
  svg += rings_path(view, waterline, "class=\"structure\"");
  for (const model::CrackEvent& event : results.events) {
    const Vec2 at = view.on_page(event.at);
    svg += fmt::format("<circle class=\"break\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\"/>\n", at.x, at.y);
  }
  return svg + scale_bar(view) + "</svg>\n";
}

}  // namespace brash::report
