// SPDX-License-Identifier: GPL-3.0-or-later
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <cmath>
#include <limits>

#include "brash/core/contract.hpp"
#include "brash/statistics/laws.hpp"
#include "gsl_checked.hpp"
#include "gsl_search.hpp"
#include "gsl_simplex.hpp"

namespace brash::statistics {
namespace {

constexpr double kForbidden = 1e10;  // cost outside the support
constexpr double kLightest = -0.98;  // shape; at -1 the likelihood has no bound
constexpr double kHeaviest = 3.0;    // shape; the level grows with its power
constexpr double kFarthest = 1e6;    // end of an interval, in deviations of the values
constexpr double kFirstStep = 0.05;  // of the search for an end, in deviations
constexpr double kStepGrowth = 1.5;

using Values = std::vector<double>;

std::size_t n_parameters(Law law) { return law == Law::kRayleigh ? 1 : law == Law::kGev ? 3 : 2; }

/// The likelihood of a level x, exceeded with a given probability, at the best of the other parameters. Values are
/// shifted and scaled.
class LevelProfile {
 public:
  LevelProfile(const LawFit& fit, double exceedance) : exceedance_(exceedance), best_(fit.distribution) {
    const auto n = fit.values.size();
    unit_ = gsl_stats_sd(fit.values.data(), 1, n);
    shift_ = is_of_blocks(best_.law) ? gsl_stats_mean(fit.values.data(), 1, n) : best_.location;
    for (const double value : fit.values) z_.push_back((value - shift_) / unit_);
    best_.location = (best_.location - shift_) / unit_;
    best_.scale /= unit_;
    estimate_ = best_.level(exceedance);
    others_ = others_at_centre_ = others_of(best_);
    centre_ = estimate_;
    least_ = cost(best_);
    seek_least();
  }

  /// Where the likelihood of the level is largest: at the estimate, if the fit is not at a limit.
  double centre() const { return centre_; }
  double value_of(double x) const { return shift_ + unit_ * x; }
  double unit() const { return unit_; }
  void allow(double mean_cost) { allowed_ = least_ + mean_cost; }

  /// Cost of level x at its best other parameters, less the cost that the interval allows.
  double excess(double x) {
    if (others_.empty()) return cost(with_level(x, others_)) - allowed_;
    const auto minimum =
        find_simplex_minimum([&](const Values& others) { return cost(with_level(x, others)); }, others_, 0.1, 1e-4);
    if (minimum.cost < kForbidden) others_ = minimum.at;
    return minimum.cost - allowed_;
  }
  void start_again() { others_ = others_at_centre_; }

 private:
  /// Scale and shape of a distribution, without the one that the level replaces.
  static Values others_of(const Distribution& d) {
    switch (d.law) {
      case Law::kGumbel:
        return {std::log(d.scale)};
      case Law::kGev:
        return {std::log(d.scale), d.shape};
      case Law::kPareto:
        return {d.shape};
      case Law::kWeibull:
        return {std::log(d.shape)};
      case Law::kRayleigh:
        break;
    }
    return {};
  }

  Distribution with_level(double x, const Values& others) const {
    Distribution d{best_.law, 0.0, 1.0, 0.0};
    if (d.law == Law::kGev || d.law == Law::kPareto) d.shape = others.back();
    if (d.law == Law::kWeibull) d.shape = std::exp(others.back());
    if (d.law == Law::kWeibull && !(d.shape > 1e-2 && d.shape < 1e4)) return {d.law, 0.0, -1.0, 0.0};
    if (d.shape < kLightest || (d.shape > kHeaviest && d.law != Law::kWeibull)) return {d.law, 0.0, -1.0, 0.0};
    const double reach = d.level(exceedance_);  // of unit scale
    if (is_of_blocks(d.law)) {
      d.scale = std::exp(others.front());
      d.location = x - d.scale * reach;
    } else {
      d.scale = x / reach;
    }
    return d;
  }

  /// The profile allows lighter tails than a fit does. When the fit is at that limit, the profile's least cost is
  /// lower.
  void seek_least() {
    if (best_.law != Law::kGev && best_.law != Law::kPareto) return;
    Values start = others_;
    start.push_back(estimate_);
    const auto all = [this](const Values& at) { return cost(with_level(at.back(), {at.begin(), at.end() - 1})); };
    const auto found = find_simplex_minimum(all, start, 0.1, 1e-6);
    if (found.cost >= least_) return;
    least_ = found.cost;
    centre_ = found.at.back();
    others_at_centre_.assign(found.at.begin(), found.at.end() - 1);
  }

  /// Minus the mean log likelihood.
  double cost(const Distribution& d) const {
    if (!(d.scale > 0.0)) return kForbidden;
    double sum = 0.0;
    for (const double z : z_) sum -= d.log_density(z);
    return std::isfinite(sum) ? sum / static_cast<double>(z_.size()) : kForbidden;
  }

  double exceedance_;
  Distribution best_;
  Values z_, others_, others_at_centre_;
  double shift_ = 0.0, unit_ = 1.0, estimate_ = 0.0, centre_ = 0.0, least_ = 0.0, allowed_ = 0.0;
};

double excess_at(double x, void* profile) { return static_cast<LevelProfile*>(profile)->excess(x); }

/// End of the interval above (`side` 1) or below (-1) the estimate, scaled; infinite when there is none.
double interval_end(LevelProfile& profile, double side) {
  profile.start_again();
  double inside = profile.centre();
  for (double step = kFirstStep; step < kFarthest; step *= kStepGrowth) {
    const double outside = inside + side * step;
    if (profile.excess(outside) > 0.0) {
      gsl_function excess{&excess_at, &profile};
      return find_root(excess, std::min(inside, outside), std::max(inside, outside), 1e-4).value_or(outside);
    }
    inside = outside;
  }
  return side * std::numeric_limits<double>::infinity();
}

}  // namespace

Estimate level_with_interval(const LawFit& fit, double exceedance, double confidence) {
  BRASH_EXPECTS(exceedance > 0.0 && exceedance < 1.0, exceedance);
  BRASH_EXPECTS(confidence > 0.0 && confidence < 1.0, confidence);
  quiet_gsl();
  const Distribution& law = fit.distribution;
  const auto n = static_cast<double>(fit.values.size());
  const double freedom = n - static_cast<double>(n_parameters(law.law));
  BRASH_EXPECTS(freedom >= 1.0, n);
  const double t = gsl_cdf_tdist_Pinv(0.5 + 0.5 * confidence, freedom);
  LevelProfile profile(fit, exceedance);
  profile.allow(0.5 * std::log1p(t * t / freedom));
  const double value = law.level(exceedance);
  double below = std::max(0.0, value - profile.value_of(interval_end(profile, -1.0)));
  double beyond = std::max(0.0, profile.value_of(interval_end(profile, 1.0)) - value);
  if (!is_of_blocks(law.law)) {
    // One more peak in n raises the exceedance that is asked for by 1/n.
    const double share = std::min(0.1, 0.5 * (1.0 / exceedance - 1.0));
    const double slope = (law.level(exceedance / (1.0 + share)) - value) / std::log1p(share);
    const double by_number = gsl_cdf_ugaussian_Pinv(0.5 + 0.5 * confidence) * slope / std::sqrt(n);
    below = std::hypot(below, by_number);
    beyond = std::hypot(beyond, by_number);
  }
  return {value, {value - below, value + beyond}};
}

}  // namespace brash::statistics
