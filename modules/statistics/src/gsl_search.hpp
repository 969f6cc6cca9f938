// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gsl/gsl_math.h>

#include <optional>

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

}  // namespace brash::statistics
