// SPDX-License-Identifier: GPL-3.0-or-later
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "brash/core/contract.hpp"
#include "brash/statistics/extremes.hpp"
#include "gsl_checked.hpp"
#include "gsl_search.hpp"
#include "samples.hpp"

namespace brash::statistics {
namespace {

using std::numbers::egamma;
using std::numbers::pi;

double normal_quantile(double confidence) {
  BRASH_EXPECTS(confidence > 0.0 && confidence < 1.0, confidence);
  return gsl_cdf_ugaussian_Pinv(0.5 + 0.5 * confidence);
}

Estimate normal_estimate(double value, double variance, double confidence) {
  const double half_width = normal_quantile(confidence) * std::sqrt(variance);
  return {value, {value - half_width, value + half_width}};
}

/// Maxima moved to the least one and divided by their deviation, so that exponentials stay in range.
struct ScaledMaxima {
  std::vector<double> z;
  double shift = 0.0;
  double unit = 1.0;
  double mean = 0.0;
};

ScaledMaxima scale(std::span<const double> maxima) {
  ScaledMaxima scaled;
  scaled.shift = *std::ranges::min_element(maxima);
  scaled.unit = gsl_stats_sd(maxima.data(), 1, maxima.size());
  for (const double x : maxima) scaled.z.push_back((x - scaled.shift) / scaled.unit);
  scaled.mean = gsl_stats_mean(scaled.z.data(), 1, scaled.z.size());
  return scaled;
}

/// Derivative of the Gumbel likelihood with respect to the scale, mu eliminated: rises from negative to positive.
double gumbel_score(double scale, void* maxima) {
  const auto& scaled = *static_cast<const ScaledMaxima*>(maxima);
  double weight = 0.0, weighted = 0.0;
  for (const double z : scaled.z) {
    const double w = std::exp(-z / scale);
    weight += w;
    weighted += w * z;
  }
  return scale - scaled.mean + weighted / weight;
}

}  // namespace

tl::expected<Gumbel, FitError> fit_gumbel(std::span<const double> maxima) {
  BRASH_EXPECTS(all_finite(maxima));
  quiet_gsl();
  if (maxima.size() < 3) return tl::unexpected(FitError{"a Gumbel fit needs at least 3 maxima"});
  const auto [low, high] = std::ranges::minmax_element(maxima);
  if (*low == *high) return tl::unexpected(FitError{"all maxima are equal"});
  ScaledMaxima scaled = scale(maxima);
  gsl_function score{&gumbel_score, &scaled};
  // The score is negative as the scale vanishes and positive at the mean of z, since z >= 0.
  const std::optional<double> beta = find_root(score, 1e-6 * scaled.mean, scaled.mean);
  if (!beta) return tl::unexpected(FitError{"the Gumbel likelihood has no maximum"});
  double weight = 0.0;
  for (const double z : scaled.z) weight += std::exp(-z / *beta);
  const double mu = -*beta * std::log(weight / static_cast<double>(maxima.size()));
  return Gumbel{scaled.shift + scaled.unit * mu, scaled.unit * *beta, maxima.size()};
}

Estimate return_level(const Gumbel& fit, double return_period, double confidence) {
  BRASH_EXPECTS(return_period > 1.0, return_period);
  BRASH_EXPECTS(fit.n > 0 && fit.scale > 0.0, fit.n, fit.scale);
  quiet_gsl();
  const double y = -std::log(-std::log1p(-1.0 / return_period));
  const double lever = 1.0 - egamma + y;
  const double variance = fit.scale * fit.scale / static_cast<double>(fit.n) * (1.0 + 6.0 / (pi * pi) * lever * lever);
  return normal_estimate(fit.location + fit.scale * y, variance, confidence);
}

}  // namespace brash::statistics
