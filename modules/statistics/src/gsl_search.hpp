// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gsl/gsl_math.h>

#include <functional>
#include <optional>
#include <vector>

namespace brash::statistics {

/// Root of `function` inside a bracket with a change of sign, to the relative or the absolute tolerance; nothing when
/// there is no change of sign.
std::optional<double> find_root(gsl_function& function, double lower, double upper, double relative = 1e-14,
                                double absolute = 0.0);

/// Place of a minimum of `function` between `lower` and `upper`, to `tolerance`; `middle` when it is not below both
/// ends.
double find_minimum(gsl_function& function, double lower, double middle, double upper, double tolerance);

/// A minimum of a function of one number.
struct Minimum {
  double at = 0.0, value = 0.0;
};

/// The minimum that a walk downhill from `start` reaches, to `tolerance`. Steps grow from `step` on and stay within
/// [lower, upper].
Minimum find_minimum_from(gsl_function& function, double start, double step, double lower, double upper,
                          double tolerance);

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
