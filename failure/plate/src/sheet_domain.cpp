// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet_domain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "production_sizes.hpp"

namespace brash::plate {

namespace {

/// A corner is re-entrant when the ice around it spans this much more than half a turn [rad].
constexpr double kReentrant = 10.0 * std::numbers::pi / 180.0;

/// How much more than half a turn the ice around an inner point of the edge spans [rad].
double turn_at(const std::vector<Vec2>& edge, std::size_t i) {
  const Vec2 before = edge[i] - edge[i - 1];
  const Vec2 after = edge[i + 1] - edge[i];
  return std::atan2(cross(before, after), dot(before, after));
}

double distance_to_focus(const std::vector<Segment>& focus, Vec2 place) {
  double distance = std::numeric_limits<double>::infinity();
  for (const Segment& s : focus) distance = std::min(distance, distance_to_stretch(place, s.from, s.to));
  return distance;
}

/// Ends the crack where the x-axis leaves the ice; that place becomes a point of the edge.
tl::expected<double, std::string> end_crack(SheetEdge& edge, double far) {
  if (!edge.origin) return tl::unexpected(std::string("the edge misses B"));
  auto& points = edge.points;
  double end = far;
  std::size_t segment = points.size();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 a = points[i];
    const Vec2 b = points[i + 1];
    if (i == *edge.origin || i + 1 == *edge.origin || std::min(a.y, b.y) > 0.0 || std::max(a.y, b.y) < 0.0) continue;
    const double x = a.y == b.y ? std::min(a.x, b.x) : a.x + (b.x - a.x) * (a.y / (a.y - b.y));
    if (x > 0.0 && x < end) {
      end = x;
      segment = i;
    }
  }
  if (segment == points.size()) return end;
  constexpr double kSame = 1e-6;
  for (const std::size_t i : {segment, segment + 1}) {
    if (norm(points[i] - Vec2{end, 0.0}) > kSame) continue;
    points[i].y = 0.0;
    return points[i].x;
  }
  points.insert(points.begin() + static_cast<std::ptrdiff_t>(segment) + 1, Vec2{end, 0.0});
  for (auto& [from, to] : edge.loads) {
    if (from > segment) ++from;
    if (to > segment) ++to;
  }
  if (*edge.origin > segment) ++*edge.origin;
  return end;
}

void add_sizes(SheetDomain& result, const LoadedSheet& sheet, const SheetEdge& edge, const SheetSizes& sizes) {
  auto& sources = result.domain.sizes;
  // Features far from the places that are looked at need not be fine.
  const auto add = [&](Vec2 from, Vec2 to, double size) {
    const double distance = std::min(distance_to_focus(result.lines, from), distance_to_focus(result.lines, to));
    sources.push_back({from, to, std::max(size, sizes.distance_share * distance), sizes.gradation});
  };
  for (const auto& [first, last] : edge.loads) {
    const Vec2 from = edge.points[first];
    const Vec2 to = edge.points[last];
    const double tip = std::min(sizes.tip, sizes.tip_share * norm(to - from));
    for (std::size_t i = first; i < last; ++i) {
      // In pieces of l_c at most: of a long contact only the middle need be fine.
      const Vec2 whole = edge.points[i + 1] - edge.points[i];
      const double n = std::ceil(norm(whole));
      for (double piece = 0.0; piece < n; ++piece)
        add(edge.points[i] + piece / n * whole, edge.points[i] + (piece + 1.0) / n * whole, tip);
    }
    add(from, from, sizes.tip_corner * tip);
    add(to, to, sizes.tip_corner * tip);
  }
  for (std::size_t i = 1; i + 1 < edge.points.size(); ++i) {
    const Vec2 point = edge.points[i];
    const double distance = distance_to_focus(result.focus, point);
    if (distance > sizes.near) continue;
    const bool is_loaded = std::ranges::any_of(
        edge.loads, [i](const auto& load) { return i >= load.first && i < load.second; });  // has its own size
    if (!is_loaded && distance_to_focus(result.focus, edge.points[i + 1]) <= sizes.near)
      add(point, edge.points[i + 1], sizes.side);
    if (turn_at(edge.points, i) > kReentrant) add(point, point, sizes.root);
  }
  const double centre = sheet.split ? sizes.crack : sizes.centre;
  for (const Segment& line : result.lines) sources.push_back({line.from, line.to, centre, sizes.gradation});
}

}  // namespace

SheetSizes sizes_of(Accuracy accuracy) {
  if (accuracy == Accuracy::kFine) {
    return {.tip = kTipSize,
            .tip_share = kTipShare,
            .tip_corner = kTipCornerShare,
            .root = kRootSize,
            .side = kSideSize,
            .centre = kCentreSize,
            .crack = kCentreSize,
            .distance_share = 0.0,
            .gradation = kGradation,
            .near = 3.0,
            .reach = kHalfWidth,
            .bending_reach = 2.0 * kHalfWidth,
            .tolerance = {0.006, 0.0},
            .most_vertices = 20000,
            .membrane_order = 3,
            .smallest_patch = 8};
  }
  const bool screens = accuracy == Accuracy::kCoarse;
  return {.tip = 0.1,
          .tip_share = 0.2,
          .tip_corner = 1.0,
          .root = 0.05,
          .side = 0.12,
          .centre = 0.22,
          .crack = 0.16,
          .distance_share = screens ? 0.25 : 0.12,
          .gradation = 0.8,
          .near = screens ? 1.0 : 1.5,
          .reach = 20.0,
          .bending_reach = 5.0,
          .tolerance = {screens ? 0.02 : 0.01, 0.05},
          .most_vertices = 1000,
          .membrane_order = 2,
          .bending_order = screens ? 2 : kOrder,
          .smallest_patch = 3};
}

tl::expected<SheetDomain, std::string> domain_of(const LoadedSheet& sheet, SheetEdge& edge, const SheetSizes& sizes) {
  edge.points.insert(edge.points.begin(), edge.points.front() - Vec2{0.0, sizes.reach});
  edge.points.push_back(edge.points.back() + Vec2{0.0, sizes.reach});
  for (auto& [from, to] : edge.loads) ++from, ++to;
  if (edge.origin) ++*edge.origin;
  double innermost = 0.0;
  double base = 0.0;
  for (const Vec2 point : edge.points) {
    innermost = std::max(innermost, point.x);
    if (norm(point) < sizes.near) base = std::max(base, point.x);
  }
  const Vec2 right{innermost + sizes.reach, edge.points.front().y};
  const Vec2 left{innermost + sizes.reach, edge.points.back().y};

  SheetDomain result;
  double crack = 0.0;
  if (sheet.split) {
    const auto end = end_crack(edge, right.x);
    if (!end) return tl::unexpected(end.error());
    crack = *end;
  }
  auto& segments = result.domain.segments;
  for (std::size_t i = 0; i + 1 < edge.points.size(); ++i)
    segments.push_back({edge.points[i], edge.points[i + 1], Side::kFree});
  for (const auto& [first, last] : edge.loads) {
    result.focus.push_back({edge.points[first], edge.points[last]});
    for (std::size_t i = first; i < last; ++i) segments[i].side = Side::kTip;
  }
  segments.push_back({edge.points.back(), left, Side::kFar});
  segments.push_back({left, right, Side::kFar});
  segments.push_back({right, edge.points.front(), Side::kFar});
  if (sheet.split) segments.push_back({{0.0, 0.0}, {crack, 0.0}, Side::kCrack});

  const Vec2 fine_end{base + kBreakingZone, 0.0};
  result.lines.push_back({{0.0, 0.0}, fine_end});
  for (const PatchLoad& patch : sheet.patch_loads) result.lines.push_back({patch.at, patch.at});
  result.focus.insert(result.focus.end(), result.lines.begin(), result.lines.end());
  result.domain.largest_size = sizes.reach;
  add_sizes(result, sheet, edge, sizes);
  return result;
}

}  // namespace brash::plate
