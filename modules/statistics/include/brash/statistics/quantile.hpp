// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace brash::statistics {

/// Quantiles of `values` at `levels` in [0, 1], linear between order statistics (Hyndman and Fan's type 7).
/// @return shape=(n_levels,); empty when there are no values.
std::vector<double> quantiles(std::vector<double> values, std::span<const double> levels);

/// Quantiles of values that represent different times. The k-th smallest value has the level
/// C_k/C_n, C_k = sum_{j=2}^{k} (w_{j-1} + w_j)/2; linear between. Equal weights give the quantiles above.
///
/// @param weights  > 0; shape=(n,) as values, or (1,) when all are equal.
std::vector<double> quantiles(std::span<const double> values, std::span<const double> weights,
                              std::span<const double> levels);

/// Quantiles of values that are shares of one whole, such as the areas of floes: at each level the smallest value up to
/// which the weights sum to that share of all weights. A value counts with its whole weight.
///
/// @param values   shape=(n,), n >= 1.
/// @param weights  > 0; shape=(n,).
/// @param levels   in [0, 1].
std::vector<double> quantiles_of_shares(std::span<const double> values, std::span<const double> weights,
                                        std::span<const double> levels);

}  // namespace brash::statistics
