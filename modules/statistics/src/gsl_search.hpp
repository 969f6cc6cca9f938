// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gsl/gsl_math.h>

#include <optional>

namespace brash::statistics {

/// Root of `function` inside a bracket with a change of sign, to the relative `tolerance`; nothing when there is no
/// change of sign.
std::optional<double> find_root(gsl_function& function, double lower, double upper, double tolerance = 1e-14);

/// Place of a minimum of `function` between `lower` and `upper`, to `tolerance`; `middle` when it is not below both
/// ends.
double find_minimum(gsl_function& function, double lower, double middle, double upper, double tolerance);

}  // namespace brash::statistics
