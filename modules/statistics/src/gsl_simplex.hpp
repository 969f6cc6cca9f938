// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

namespace brash::statistics {

/// A minimum that the simplex of Nelder and Mead found.
struct SimplexMinimum {
  std::vector<double> at;
  double cost = 0.0;
};

/// Minimum of `cost` from `start` on, to the size `tolerance` of the simplex.
///
/// @param start  shape=(n,), n >= 1.
/// @param step   size of the first simplex, the same in each direction.
SimplexMinimum find_simplex_minimum(const std::function<double(const std::vector<double>&)>& cost,
                                    std::vector<double> start, double step, double tolerance);

}  // namespace brash::statistics
