// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace brash::hydrodynamics {

/// Carlson's R_D(x, y, z) by duplication, to rounding (B. C. Carlson, Numer. Algorithms 10, 1995). All > 0.
inline double elliptic_rd(double x, double y, double z) {
  constexpr double kSmall = 1e-3;  // the series leaves its sixth power
  double sum = 0.0, scale = 1.0;
  for (;;) {
    const double mean = (x + y + 3.0 * z) / 5.0;
    const double dx = 1.0 - x / mean, dy = 1.0 - y / mean, dz = 1.0 - z / mean;
    if (std::max({std::abs(dx), std::abs(dy), std::abs(dz)}) < kSmall) {
      const double xy = dx * dy, zz = dz * dz;
      const double e2 = xy - 6.0 * zz, e3 = (3.0 * xy - 8.0 * zz) * dz, e4 = 3.0 * (xy - zz) * zz, e5 = xy * zz * dz;
      const double series = 1.0 - 3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0 - 3.0 * e4 / 22.0 -
                            9.0 * e2 * e3 / 52.0 + 3.0 * e5 / 26.0;
      return 3.0 * sum + scale * series / (mean * std::sqrt(mean));
    }
    const double rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z);
    const double step = rx * ry + ry * rz + rz * rx;
    sum += scale / (rz * (z + step));
    scale *= 0.25;
    x = 0.25 * (x + step);
    y = 0.25 * (y + step);
    z = 0.25 * (z + step);
  }
}

}  // namespace brash::hydrodynamics
