// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons that the tests share.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string_view>
#include <vector>

#include "brash/core/constants.hpp"
#include "brash/geometry/polygon.hpp"
#include "brash/geometry/text.hpp"

namespace brash::geometry::shapes {

inline Ring box(double x0, double y0, double x1, double y1) {
  return ring(std::vector<Vec2>{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

inline Ring reversed(Ring r) {
  std::reverse(r.begin() + 1, r.end());
  return r;
}

/// The polygons of a valid WKT or GeoJSON text.
inline std::vector<Polygon> in_text(std::string_view text) { return polygons_of(read_polygons(text).value().features); }

/// Integer grid units: for cases where every unit counts.
inline Ring units(std::initializer_list<std::pair<std::int64_t, std::int64_t>> points) {
  Ring ring;
  for (const auto& [x, y] : points) ring.push_back(Point::of_units(x, y));
  return ring;
}

/// A number in [0, 1) that is the same on every machine; std::uniform_real_distribution is not.
inline double uniform(std::mt19937_64& generator) { return static_cast<double>(generator() >> 11) * 0x1p-53; }

/// A star-shaped ring about `centre` with radii between `low` and 1 m.
inline Ring star(std::mt19937_64& generator, int n, double low, Vec2 centre = {}) {
  std::vector<Vec2> vertices;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * (i + 0.8 * uniform(generator)) / n;
    const double radius = low + (1.0 - low) * uniform(generator);
    vertices.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return ring(vertices);
}

/// `n` stars at random places of a square of 6 m: many overlap.
inline std::vector<Polygon> scattered(std::mt19937_64& generator, int n) {
  std::vector<Polygon> polygons;
  for (int i = 0; i < n; ++i) {
    const double x = 6.0 * uniform(generator), y = 6.0 * uniform(generator);
    polygons.push_back({star(generator, 3 + i % 9, 0.2, {x, y}), {}});
  }
  return polygons;
}

/// A wedge as a crack event leaves it: two radial sides, an outer arc and a ragged or concave inner edge.
inline Ring wedge(std::mt19937_64& generator) {
  const double span = 0.4 + 1.2 * uniform(generator);
  const int outer = 2 + static_cast<int>(5 * uniform(generator)), inner = 2 + static_cast<int>(5 * uniform(generator));
  std::vector<Vec2> vertices;
  for (int i = 0; i <= outer; ++i) {
    const double angle = span * i / outer;
    vertices.push_back({2.0 * std::cos(angle), 2.0 * std::sin(angle)});
  }
  for (int i = inner; i >= 0; --i) {
    const double angle = span * i / inner, radius = 0.3 + 1.0 * uniform(generator);
    vertices.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring(vertices);
}

}  // namespace brash::geometry::shapes
