// SPDX-License-Identifier: GPL-3.0-or-later
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/statistics/extremes.hpp"
#include "gsl_checked.hpp"
#include "gsl_search.hpp"
#include "samples.hpp"

namespace brash::statistics {
namespace {

/// Excesses divided by their largest one.
using Excesses = std::vector<double>;

Excesses scaled(std::span<const double> excesses, double unit) {
  Excesses y;
  for (const double value : excesses) y.push_back(value / unit);
  return y;
}

/// xi as a function of t = xi/sigma (largest excess), by Grimshaw.
double shape_at(const Excesses& y, double t) {
  double sum = 0.0;
  for (const double value : y) sum += std::log1p(t * value);
  return sum / static_cast<double>(y.size());
}

/// sigma in units of the largest excess.
double scale_at(const Excesses& y, double t) {
  return t == 0.0 ? gsl_stats_mean(y.data(), 1, y.size()) : shape_at(y, t) / t;
}

/// Minus the mean log likelihood at the best xi for t.
double grimshaw_cost(double t, void* excesses) {
  const auto& y = *static_cast<const Excesses*>(excesses);
  return std::log(scale_at(y, t)) + shape_at(y, t) + 1.0;
}

/// Values of t from just above -1 (bounded tail) through 0 (exponential) to heavy tails.
std::vector<double> search_grid() {
  std::vector<double> grid;
  for (int i = 0; i < 60; ++i) grid.push_back(-1.0 + std::pow(10.0, -6.0 + 0.1 * i));
  grid.push_back(0.0);
  for (int i = -30; i <= 60; ++i) grid.push_back(std::pow(10.0, 0.1 * i));
  return grid;
}

/// t of the best regular maximum of the likelihood: xi > -0.5.
std::optional<double> best_ratio(Excesses& y) {
  gsl_function cost{&grimshaw_cost, &y};
  const std::vector<double> grid = search_grid();
  std::vector<double> costs;
  for (const double t : grid) costs.push_back(grimshaw_cost(t, &y));
  std::optional<double> best;
  double best_cost = 0.0;
  for (std::size_t i = 1; i + 1 < grid.size(); ++i) {
    if (costs[i] > costs[i - 1] || costs[i] > costs[i + 1]) continue;
    // A minimum is flat: its place is known to the root of the rounding only.
    const double t = find_minimum(cost, grid[i - 1], grid[i], grid[i + 1], 1e-9);
    const double refined = grimshaw_cost(t, &y);
    if (shape_at(y, t) <= -0.5 || (best && refined >= best_cost)) continue;
    best = t;
    best_cost = refined;
  }
  return best;
}

/// (m^xi - 1)/xi: the level that one of m excesses passes, in units of sigma.
double growth(double shape, double log_m) { return shape == 0.0 ? log_m : std::expm1(shape * log_m) / shape; }

/// The likelihood of a return level x (above the threshold), all in units of the largest excess.
struct Profile {
  Excesses y;
  double log_m = 0.0;
  double heaviest = 2.0;  ///< largest shape tried
  double x = 0.0;         ///< the level
  double allowed = 0.0;   ///< greatest mean cost inside the interval

  /// Minus the mean log likelihood of level x and shape xi; sigma follows from both.
  double cost(double shape) const {
    const double inverse_scale = growth(shape, log_m) / x;
    double sum = 0.0;
    for (const double value : y) {
      const double a = value * inverse_scale;
      if (shape * a <= -1.0) return 1e6;  // beyond the end of the tail
      const double log_term = std::log1p(shape * a);
      sum += log_term + (shape == 0.0 ? a : log_term / shape);
    }
    return sum / static_cast<double>(y.size()) - std::log(inverse_scale);
  }
};

double cost_of_shape(double shape, void* profile) { return static_cast<const Profile*>(profile)->cost(shape); }

/// Cost of a level at its best shape, less the cost that the interval allows.
double level_cost(double x, void* context) {
  auto& profile = *static_cast<Profile*>(context);
  profile.x = x;
  constexpr int kSteps = 30;
  constexpr double kLightest = -0.98;  // at -1 the likelihood has no bound
  const double step = (profile.heaviest - kLightest) / kSteps;
  int best = 0;
  double least = profile.cost(kLightest);
  for (int i = 1; i <= kSteps; ++i) {
    const double cost = profile.cost(kLightest + i * step);
    if (cost < least) best = i, least = cost;
  }
  if (best > 0 && best < kSteps) {
    gsl_function cost{&cost_of_shape, &profile};
    const double middle = kLightest + best * step;
    least = std::min(least, profile.cost(find_minimum(cost, middle - step, middle, middle + step, 1e-7)));
  }
  return least - profile.allowed;
}

/// End of the profile interval on one side of the estimate: `factor` > 1 looks above, < 1 below.
double interval_end(Profile& profile, double estimate, double factor) {
  gsl_function cost{&level_cost, &profile};
  double inside = estimate;
  for (int i = 0; i < 400; ++i) {
    const double outside = inside * factor;
    if (level_cost(outside, &profile) > 0.0) {
      const auto end = find_root(cost, std::min(inside, outside), std::max(inside, outside));
      return end.value_or(outside);
    }
    inside = outside;
  }
  throw RunError("return level: the likelihood does not bound the interval");
}

}  // namespace

tl::expected<GeneralisedPareto, FitError> fit_generalised_pareto(std::span<const double> peaks, double threshold) {
  BRASH_EXPECTS(all_finite(peaks));
  quiet_gsl();
  GeneralisedPareto fit;
  fit.threshold = threshold;
  for (const double peak : peaks)
    if (peak > threshold) fit.excesses.push_back(peak - threshold);
  if (fit.excesses.size() < 10) {
    return tl::unexpected(FitError{"a generalised Pareto fit needs at least 10 peaks above the threshold"});
  }
  const double largest = *std::ranges::max_element(fit.excesses);
  Excesses y = scaled(fit.excesses, largest);
  const std::optional<double> t = best_ratio(y);
  if (!t) return tl::unexpected(FitError{"the generalised Pareto likelihood has no regular maximum"});
  fit.scale = largest * scale_at(y, *t);
  fit.shape = shape_at(y, *t);
  return fit;
}

Estimate return_level(const GeneralisedPareto& fit, double duration, double return_period, double confidence) {
  BRASH_EXPECTS(!fit.excesses.empty() && fit.scale > 0.0 && fit.shape > -0.5, fit.scale, fit.shape);
  BRASH_EXPECTS(duration > 0.0, duration);
  BRASH_EXPECTS(confidence > 0.0 && confidence < 1.0, confidence);
  quiet_gsl();
  const auto n = static_cast<double>(fit.excesses.size());
  const double expected = n / duration * return_period;  // lambda T
  BRASH_EXPECTS(expected > 1.0, expected);

  Profile profile;
  profile.log_m = std::log(expected);
  profile.heaviest = std::max(2.0, fit.shape + 2.0);
  const double unit = *std::ranges::max_element(fit.excesses);
  profile.y = scaled(fit.excesses, unit);
  const double estimate = fit.scale / unit * growth(fit.shape, profile.log_m);
  profile.x = estimate;
  // Twice the fall of the log likelihood follows chi squared with one degree of freedom.
  profile.allowed = profile.cost(fit.shape) + 0.5 * gsl_cdf_chisq_Pinv(confidence, 1.0) / n;
  const double lower = interval_end(profile, estimate, 1.0 / 1.05), upper = interval_end(profile, estimate, 1.05);

  // The number of peaks is independent of their sizes: its error adds in quadrature.
  const double z = gsl_cdf_ugaussian_Pinv(0.5 + 0.5 * confidence);
  const double by_rate = z * fit.scale / unit * std::exp(fit.shape * profile.log_m) / std::sqrt(n);
  const double value = fit.threshold + unit * estimate;
  return {value,
          {value - unit * std::hypot(estimate - lower, by_rate), value + unit * std::hypot(upper - estimate, by_rate)}};
}

}  // namespace brash::statistics
