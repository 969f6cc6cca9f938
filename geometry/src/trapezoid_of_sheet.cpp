// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

#include "brash/core/contract.hpp"
#include "brash/geometry/trapezoid.hpp"

namespace brash::geometry {
namespace {

/// The point of the polylines that is nearest to `at`; there is one at least.
Vec2 nearest_point(const std::vector<std::vector<Vec2>>& lines, Vec2 at) {
  Vec2 nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<Vec2>& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vec2 along = line[i] - line[i - 1];
      const double length = dot(along, along);
      const double share = length > 0.0 ? std::clamp(dot(at - line[i - 1], along) / length, 0.0, 1.0) : 0.0;
      const Vec2 point = line[i - 1] + share * along;
      if (norm(point - at) < least) nearest = point, least = norm(point - at);
    }
  }
  return nearest;
}

}  // namespace

Trapezoid fit_trapezoid(const IceSheet& sheet, const FitRequest& request) {
  BRASH_EXPECTS(request.reach > 0.0, request.reach);
  // The circle around the window's corners.
  return fit_trapezoid(sheet.free_edge(request.at, std::numbers::sqrt2 * request.reach), request);
}

bool leads_into_ice(const IceSheet& sheet, const FitRequest& request) {
  constexpr double kBesideEdge = 0.01, kAtOnce = 0.1;  // of the reach
  constexpr int kSteps = 100;
  const auto edges = sheet.free_edge(request.at, request.reach);
  if (edges.empty()) return true;
  const Vec2 edge = nearest_point(edges, request.at);
  const bool on_edge = norm(edge - request.at) <= kBesideEdge * request.reach;
  const double way = (on_edge ? kAtOnce : 1.0) * request.reach;
  for (int i = 1; i <= kSteps; ++i)
    if (sheet.contains((on_edge ? edge : request.at) + (way * i / kSteps) * request.towards)) return true;
  return false;
}

}  // namespace brash::geometry
