// SPDX-License-Identifier: GPL-3.0-or-later
// Free edges with a known trapezoid.
#pragma once

#include <cmath>
#include <vector>

#include "shapes.hpp"

namespace brash::geometry::fit_cases {

using Polyline = std::vector<Vec2>;

/// The free edge of the paper's Fig. 2 in the frame of B, from +y to -y: ice on the left is ice at larger x.
inline Polyline trapezoid_edge(double b, double c, double theta, double half_width) {
  const double run = b * std::tan(0.5 * theta);
  return {{b, half_width}, {b, 0.5 * c + run}, {0.0, 0.5 * c}, {0.0, -0.5 * c}, {b, -0.5 * c - run}, {b, -half_width}};
}

/// `edge` with a vertex every `step` or so, each moved across the edge by a uniform number of standard deviation
/// `noise`, independent of the others [m].
inline Polyline roughened(const Polyline& edge, double step, double noise, std::mt19937_64& generator) {
  Polyline result;
  for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
    const Vec2 along = edge[i + 1] - edge[i];
    if (norm(along) == 0.0) continue;
    const int n = std::max(1, static_cast<int>(norm(along) / step));
    for (int k = 0; k < n; ++k) {
      const double off = noise * std::sqrt(3.0) * (2.0 * shapes::uniform(generator) - 1.0);
      result.push_back(edge[i] + along * (static_cast<double>(k) / n) + off * perpendicular(normalized(along)));
    }
  }
  result.push_back(edge.back());
  return result;
}

}  // namespace brash::geometry::fit_cases
