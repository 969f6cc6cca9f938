// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace brash::statistics {

/// Quantiles of `values` at `levels` in [0, 1], linear between order statistics (Hyndman and Fan's type 7).
/// @return shape=(n_levels,); empty when there are no values.
std::vector<double> quantiles(std::vector<double> values, std::span<const double> levels);

}  // namespace brash::statistics
