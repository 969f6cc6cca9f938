// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "brash/statistics/extremes.hpp"

namespace brash::statistics {

/// y = factor x_1^powers[0] x_2^powers[1] ..., with intervals at the stated confidence.
struct PowerLaw {
  Estimate factor;
  std::vector<Estimate> powers;  ///< one an input
  double spread = 0.0;           ///< standard deviation of ln y about the law, with n - 1 - inputs
};

/// Fits a power law to independent values by least squares in their logarithms; Student's intervals.
///
/// @param inputs  shape=(k, n), > 0: one row an input.
/// @param values  shape=(n,), > 0.
/// @return nothing for fewer than k + 2 values, or inputs that determine no single law: a constant one, or two that
///         rise together.
std::optional<PowerLaw> fit_power_law(const std::vector<std::vector<double>>& inputs, std::span<const double> values,
                                      double confidence = 0.95);

}  // namespace brash::statistics
