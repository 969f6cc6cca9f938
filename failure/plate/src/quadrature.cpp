// SPDX-License-Identifier: GPL-3.0-or-later
#include "quadrature.hpp"

#include <cmath>
#include <numbers>

#include "brash/core/contract.hpp"

namespace brash::plate {

std::vector<LinePoint> line_rule(int n) {
  BRASH_EXPECTS(n >= 1, n);
  std::vector<LinePoint> rule(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    // Newton on the Legendre polynomial P_n from Tricomi's first guess; 20 rounds are far more than it needs.
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    double slope = 1.0;
    for (int round = 0; round < 20; ++round) {
      double previous = 1.0;
      double value = x;
      for (int j = 2; j <= n; ++j) {
        const double next = ((2 * j - 1) * x * value - (j - 1) * previous) / j;
        previous = value;
        value = next;
      }
      slope = n * (x * value - previous) / (x * x - 1.0);
      x -= value / slope;
    }
    rule[static_cast<std::size_t>(n - 1 - i)] = {0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope)};
  }
  return rule;
}

std::vector<TrianglePoint> triangle_rule(int n) {
  std::vector<TrianglePoint> rule;
  const auto line = line_rule(n);
  for (const auto& u : line) {
    for (const auto& v : line) rule.push_back({u.s, v.s * (1.0 - u.s), u.weight * v.weight * (1.0 - u.s)});
  }
  return rule;
}

}  // namespace brash::plate
