// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace brash::plate {

/// Point and weight on the interval [0, 1].
struct LinePoint {
  double s = 0.0;
  double weight = 0.0;
};

/// Point and weight on the reference triangle (0,0), (1,0), (0,1).
struct TrianglePoint {
  double xi = 0.0;
  double eta = 0.0;
  double weight = 0.0;
};

/// Gauss-Legendre rule with `n` points on [0, 1], exact for degree 2n - 1.
std::vector<LinePoint> line_rule(int n);

/// Product rule on the collapsed square, `n * n` points, exact for degree 2n - 2 on the reference triangle.
std::vector<TrianglePoint> triangle_rule(int n);

}  // namespace brash::plate
