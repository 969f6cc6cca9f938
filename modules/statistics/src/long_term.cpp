// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/long_term.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brash/core/contract.hpp"
#include "gsl_checked.hpp"
#include "gsl_search.hpp"

namespace brash::statistics {
namespace {

constexpr int kPoints = 64;         // of a curve of bounds; between them a bound errs by up to 1 % for the shape 0.8
constexpr double kCommonest = 0.9;  // probability of exceedance at which a curve begins
constexpr double kHoursToSeconds = 3600.0;

}  // namespace

LongTerm::LongTerm(const std::vector<IceState>& states, double rarest, double confidence) : states_(states) {
  BRASH_EXPECTS(!states.empty() && rarest > 0.0, states.size(), rarest);
  for (const IceState& state : states) {
    BRASH_EXPECTS(state.rate > 0.0 && state.hours > 0.0, state.rate, state.hours);
    Curve curve;
    curve.a_year = kHoursToSeconds * state.hours * state.rate;
    // A tenth of the rarest share, so that a state that matters little has a curve there too.
    const double last = std::log(std::min(0.1 * rarest / curve.a_year, 0.1 * kCommonest)), first = std::log(kCommonest);
    for (int i = 0; i < kPoints; ++i) {
      const double logarithm = first + (last - first) * i / (kPoints - 1.0);
      const Estimate at = level_with_interval(state.fit, std::exp(logarithm), confidence);
      // The bounds of a curve rise with the level.
      const double floor = curve.lower.empty() ? -std::numeric_limits<double>::infinity() : curve.lower.back();
      curve.log_exceedance.push_back(logarithm);
      curve.lower.push_back(std::max(floor, at.interval.lower));
      curve.upper.push_back(std::max(curve.upper.empty() ? at.interval.upper : curve.upper.back(), at.interval.upper));
    }
    curves_.push_back(std::move(curve));
  }
}

double LongTerm::Curve::exceedances(const std::vector<double>& levels, double x) const {
  if (x <= levels.front()) return a_year;
  // Beyond the last point the curve continues straight.
  const auto above = static_cast<std::size_t>(std::ranges::lower_bound(levels, x) - levels.begin());
  const std::size_t i = std::min(above, levels.size() - 1);
  const double width = levels[i] - levels[i - 1];
  if (!std::isfinite(width)) return a_year * std::exp(log_exceedance[i - 1]);
  if (width <= 0.0) return a_year * std::exp(log_exceedance[i]);
  const double share = (x - levels[i - 1]) / width;
  return a_year * std::exp(log_exceedance[i - 1] + share * (log_exceedance[i] - log_exceedance[i - 1]));
}

double LongTerm::exceedances(double x) const {
  double sum = 0.0;
  for (const double share : shares(x)) sum += share;
  return sum;
}

std::vector<double> LongTerm::shares(double x) const {
  std::vector<double> shares;
  for (std::size_t i = 0; i < states_.size(); ++i)
    shares.push_back(curves_[i].a_year * states_[i].fit.distribution.exceedance(x));
  return shares;
}

double LongTerm::central(double expected) const {
  // At `low` one state alone has the expected number, at `high` each has less than its even part.
  double low = -std::numeric_limits<double>::infinity(), high = low, commonest = -low;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const Distribution& law = states_[i].fit.distribution;
    const double share = expected / curves_[i].a_year;
    if (share < 1.0) low = std::max(low, law.level(share));
    high = std::max(high, law.level(std::min(0.5 * share / static_cast<double>(states_.size()), kCommonest)));
    commonest = std::min(commonest, law.level(kCommonest));
  }
  if (states_.size() == 1 || !std::isfinite(low)) return std::max(low, commonest);
  struct Problem {
    const LongTerm& all;
    double expected;
  } problem{*this, expected};
  gsl_function excess{[](double x, void* context) {
                        const auto& p = *static_cast<Problem*>(context);
                        return std::log(std::max(p.all.exceedances(x), 1e-300) / p.expected);
                      },
                      &problem};
  return find_root(excess, low, high, 1e-10).value_or(low);
}

double LongTerm::solve(std::vector<double> Curve::*levels, double expected) const {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  double reachable = 0.0;  // exceedances of any level, where a bound has no end
  for (const Curve& curve : curves_) {
    const std::vector<double>& l = curve.*levels;
    const auto end = std::ranges::find_if(l, [](double x) { return !std::isfinite(x); });
    if (end == l.begin()) return std::numeric_limits<double>::infinity();
    if (end != l.end())
      reachable += curve.a_year * std::exp(curve.log_exceedance[static_cast<std::size_t>(end - l.begin()) - 1]);
    low = std::min(low, l.front());
    high = std::max(high, *(end - 1));
  }
  if (reachable > expected) return std::numeric_limits<double>::infinity();
  struct Problem {
    const LongTerm& all;
    std::vector<double> Curve::*levels;
    double expected;
  } problem{*this, levels, expected};
  gsl_function excess{[](double x, void* context) {
                        const auto& p = *static_cast<Problem*>(context);
                        double sum = 0.0;
                        for (const Curve& curve : p.all.curves_) sum += curve.exceedances(curve.*p.levels, x);
                        return std::log(std::max(sum, 1e-300) / p.expected);
                      },
                      &problem};
  const double margin = std::max(high - low, 1e-9 * std::abs(high));
  return find_root(excess, low, high + margin, 1e-10).value_or(low);
}

Estimate LongTerm::level(double probability) const {
  BRASH_EXPECTS(probability > 0.0 && probability < 1.0, probability);
  const double expected = -std::log1p(-probability);
  return {central(expected), {solve(&Curve::lower, expected), solve(&Curve::upper, expected)}};
}

}  // namespace brash::statistics
