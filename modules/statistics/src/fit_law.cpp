// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "brash/core/contract.hpp"
#include "brash/statistics/laws.hpp"
#include "gsl_checked.hpp"
#include "gsl_search.hpp"
#include "samples.hpp"

namespace brash::statistics {
namespace {

constexpr std::size_t kFewest = 10;  // values; fewer do not determine two parameters
constexpr double kLightest = -0.5;   // shape at which the likelihood of GEV and Pareto stops being regular
constexpr double kHeaviest = 1.0;    // shape from which on the mean is infinite
constexpr double kForbidden = 1e10;  // cost outside the support

using Values = std::vector<double>;
using Fitted = tl::expected<Distribution, FitError>;

/// Derivative of Weibull's likelihood with respect to k, the scale eliminated: falls from positive to negative.
double weibull_score(double k, void* values) {
  double weight = 0.0, weighted = 0.0, sum = 0.0;
  const auto& z = *static_cast<const Values*>(values);
  for (const double value : z) {
    const double w = std::pow(value, k), logarithm = std::log(value);
    weight += w;
    weighted += w * logarithm;
    sum += logarithm;
  }
  return 1.0 / k + sum / static_cast<double>(z.size()) - weighted / weight;
}

/// Values above the level, divided by their largest one.
Values above(const Values& values, double level, double unit) {
  Values z;
  for (const double value : values) z.push_back((value - level) / unit);
  return z;
}

Fitted weibull(const Values& values, double level) {
  const double unit = values.back() - level;
  Values z = above(values, level, unit);
  gsl_function score{&weibull_score, &z};
  const auto k = find_root(score, 0.05, 200.0);
  if (!k) return tl::unexpected(FitError{"the Weibull likelihood has no maximum"});
  double sum = 0.0;
  for (const double value : z) sum += std::pow(value, *k);
  const double scale = unit * std::pow(sum / static_cast<double>(z.size()), 1.0 / *k);
  return Distribution{Law::kWeibull, level, scale, *k};
}

Fitted rayleigh(const Values& values, double level) {
  double sum = 0.0;
  for (const double value : values) sum += (value - level) * (value - level);
  return Distribution{Law::kRayleigh, level, std::sqrt(0.5 * sum / static_cast<double>(values.size())), 0.0};
}

Fitted gumbel(const Values& values) {
  const auto fit = fit_gumbel(values);
  if (!fit) return tl::unexpected(fit.error());
  return Distribution{Law::kGumbel, fit->location, fit->scale, 0.0};
}

/// Minus the mean log likelihood of values; kForbidden outside the support.
double cost_of(const Distribution& law, const Values& values) {
  double sum = 0.0;
  for (const double value : values) sum -= law.log_density(value);
  return std::isfinite(sum) ? sum / static_cast<double>(values.size()) : kForbidden;
}

/// The simplex starts at Gumbel's fit, with a shape of either sign; values in units of Gumbel's scale.
Fitted gev(const Values& values) {
  const Fitted start = gumbel(values);
  if (!start) return start;
  const Values z = above(values, start->location, start->scale);
  const auto cost = [&](const Values& at) {
    if (at[2] < kLightest || at[2] > kHeaviest) return kForbidden;
    return cost_of({Law::kGev, at[0], std::exp(at[1]), at[2]}, z);
  };
  const auto light = find_simplex_minimum(cost, {0.0, 0.0, -0.1}, 0.1, 1e-7);
  const auto heavy = find_simplex_minimum(cost, {0.0, 0.0, 0.1}, 0.1, 1e-7);
  const SimplexMinimum& best = light.cost < heavy.cost ? light : heavy;
  if (best.cost >= kForbidden || best.at[2] > 0.999 * kHeaviest)
    return tl::unexpected(FitError{"the GEV likelihood has no maximum with a shape below 1"});
  return Distribution{Law::kGev, start->location + start->scale * best.at[0], start->scale * std::exp(best.at[1]),
                      best.at[2]};
}

/// Pareto's law of the lightest shape that counts: the likelihood of a lighter one has no regular maximum.
Fitted bounded_pareto(const Values& values, double threshold) {
  const double unit = values.back() - threshold;
  const Values z = above(values, threshold, unit);
  // The end of the tail, scale/0.5, lies beyond the largest value.
  const auto law = [](const Values& at) {
    return Distribution{Law::kPareto, 0.0, -kLightest * (1.0 + std::exp(at[0])), kLightest};
  };
  const auto best = find_simplex_minimum([&](const Values& at) { return cost_of(law(at), z); }, {0.0}, 0.5, 1e-7);
  return Distribution{Law::kPareto, threshold, unit * law(best.at).scale, kLightest};
}

Fitted pareto(const Values& values, double threshold) {
  const auto fit = fit_generalised_pareto(values, threshold);
  if (!fit) return bounded_pareto(values, threshold);
  return Distribution{Law::kPareto, threshold, fit->scale, fit->shape};
}

Fitted fitted(Law law, const Values& values, double origin) {
  switch (law) {
    case Law::kGumbel:
      return gumbel(values);
    case Law::kGev:
      return gev(values);
    case Law::kPareto:
      return pareto(values, origin);
    case Law::kWeibull:
      return weibull(values, origin);
    case Law::kRayleigh:
      break;
  }
  return rayleigh(values, origin);
}

}  // namespace

tl::expected<LawFit, FitError> fit_law(Law law, std::span<const double> values, double origin) {
  BRASH_EXPECTS(all_finite(values) && std::isfinite(origin));
  quiet_gsl();
  LawFit fit;
  for (const double value : values)
    if (is_of_blocks(law) || value > origin) fit.values.push_back(value);
  std::ranges::sort(fit.values);
  const std::size_t fewest = law == Law::kGumbel ? 3 : kFewest;
  if (fit.values.size() < fewest)
    return tl::unexpected(FitError{fmt::format("a {} fit needs at least {} {}, and has {}", name_of(law), fewest,
                                               is_of_blocks(law) ? "block maxima" : "peaks", fit.values.size())});
  if (fit.values.front() == fit.values.back()) return tl::unexpected(FitError{"all values are equal"});
  const Fitted distribution = fitted(law, fit.values, origin);
  if (!distribution) return tl::unexpected(distribution.error());
  fit.distribution = *distribution;
  return fit;
}

}  // namespace brash::statistics
