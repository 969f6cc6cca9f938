// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "brash/statistics/summary.hpp"

namespace brash::statistics {

inline bool all_finite(std::span<const double> samples) {
  return std::all_of(samples.begin(), samples.end(), [](double x) { return std::isfinite(x); });
}

/// Summary of samples that represent the times `weights` [s]; shape=(n,), or (1,) when all are equal.
Summary summarise_weighted(std::span<const double> samples, std::span<const double> weights,
                           const AutocorrelationTime& correlation);

}  // namespace brash::statistics
