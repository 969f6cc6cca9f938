// SPDX-License-Identifier: GPL-3.0-or-later
// Lines as cracks.
#include "brash/geometry/lines.hpp"

#include <algorithm>
#include <cmath>

namespace brash::geometry {
namespace {

/// Rounding moves a line and the edge that it meets by two units of the grid, 2 nm, at most: this meets at angles above
/// 1 degree.
constexpr double kBeyond = 1e-7;  // [m]

/// `end` of the crack from `start`, moved away from there; as it is at the rim of the grid.
Point beyond(Point start, Point end) {
  const Vec2 along = metres(end) - metres(start);
  const Vec2 moved = metres(end) + (kBeyond / norm(along)) * along;
  return std::max(std::abs(moved.x), std::abs(moved.y)) <= kMaxCoordinate ? snap(moved) : end;
}

/// Shorter tails of a line are errors of drawing: they part nothing and change nothing [m].
constexpr double kShortestTail = 1e-3;
/// A line that parts the ice lies on the new edges to the rounding of the grid, far within this distance [m].
constexpr double kOnEdge = 1e-6;

}  // namespace

std::vector<Crack> beyond_free_ends(std::vector<Crack> cracks) {
  Ring ends;
  for (const Crack& crack : cracks) ends.insert(ends.end(), {crack.from, crack.to});
  std::sort(ends.begin(), ends.end());
  const auto is_free = [&](Point end) {
    const auto [first, last] = std::equal_range(ends.begin(), ends.end(), end);
    return last - first == 1;
  };
  for (Crack& crack : cracks) {
    const Crack given = crack;
    if (given.from == given.to) continue;
    if (is_free(given.from)) crack.from = beyond(given.to, given.from);
    if (is_free(given.to)) crack.to = beyond(given.from, given.to);
  }
  return cracks;
}

double distance_to_edges(const Polygon& polygon, Vec2 place) {
  double least = Extent::kFar;
  visit_edges(polygon, [&](Point from, Point to) {
    const Vec2 a = metres(from), along = metres(to) - a;
    const double t = std::clamp(dot(place - a, along) / dot(along, along), 0.0, 1.0);
    least = std::min(least, norm(place - (a + t * along)));
  });
  return least;
}

bool are_apart(const Extent& box, Vec2 a, Vec2 b) {
  return std::max(a.x, b.x) < box.lower.x || std::min(a.x, b.x) > box.upper.x || std::max(a.y, b.y) < box.lower.y ||
         std::min(a.y, b.y) > box.upper.y;
}

std::optional<Tail> tail_in(const Polygon& part, const IceSheet& ice, Vec2 a, Vec2 b) {
  const Vec2 line = b - a;
  std::vector<double> places{0.0, 1.0};
  visit_edges(part, [&](Point from, Point to) {
    const Vec2 c = metres(from), d = metres(to);
    const double slope = cross(line, d - c);
    if (slope == 0.0) return;
    const double t = cross(c - a, d - c) / slope, s = cross(c - a, line) / slope;
    if (t > 0.0 && t < 1.0 && s >= 0.0 && s <= 1.0) places.push_back(t);
  });
  std::ranges::sort(places);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    if ((places[i + 1] - places[i]) * norm(line) < kShortestTail) continue;
    const Vec2 middle = a + 0.5 * (places[i] + places[i + 1]) * line;
    if (ice.contains(middle) && distance_to_edges(part, middle) > kOnEdge) {
      const Vec2 from = a + places[i] * line, to = a + places[i + 1] * line;
      // Its end in the ice comes last.
      if (distance_to_edges(part, from) > distance_to_edges(part, to)) return Tail{to, from};
      return Tail{from, to};
    }
  }
  return std::nullopt;
}

}  // namespace brash::geometry
