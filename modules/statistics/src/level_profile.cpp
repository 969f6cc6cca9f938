// SPDX-License-Identifier: GPL-3.0-or-later
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "brash/core/contract.hpp"
#include "brash/statistics/laws.hpp"
#include "gsl_checked.hpp"
#include "gsl_search.hpp"

namespace brash::statistics {
namespace {

constexpr double kForbidden = 1e10;      // cost outside the support
constexpr double kLightestFit = -0.499;  // shape of a fit at its limit
constexpr double kLightest = -0.98;      // shape; at -1 the likelihood has no bound
constexpr double kHeaviest = 3.0;        // shape; the level grows with its power
constexpr double kFarthest = 1e6;        // end of an interval, in deviations of the values
constexpr double kFirstStep = 0.05;      // of the search for an end, in deviations
constexpr double kStepGrowth = 1.5;
constexpr double kShapeStep = 0.05;   // of the search for a shape; of Weibull's logarithm
constexpr double kTolerance = 1e-5;   // of a shape: the cost is then exact to 1e-9
constexpr double kNearEnd = 1.0;      // from a fit to the end of a bounded tail, in deviations
constexpr double kExactPlace = 1e-5;  // of a rate on its line: the cost is then exact to 1e-10
constexpr double kNoShape = 1e-9;     // a shape nearer to 0 is 0: its powers are rounding

std::size_t n_parameters(Law law) { return law == Law::kRayleigh ? 1 : law == Law::kGev ? 3 : 2; }

/// The likelihood of block maxima along their rate 1/scale, with a level x and a shape that stay.
///
/// Where the support ends at a rate, the place on the line is the logit of the share of that rate; else the logarithm
/// of the rate. So no place is outside the support, and none is lost in rounding beside its end.
class RateLine {
 public:
  /// @param reach  of the level, in scales from the location.
  RateLine(const std::vector<double>& values, double x, double shape, double reach)
      : values_(values), x_(x), shape_(std::abs(shape) < kNoShape ? 0.0 : shape), reach_(reach) {
    outermost_ = std::max({0.0, -shape_ * (values.back() - x), -shape_ * (values.front() - x)});
  }

  /// Derivative of the cost by the logarithm of the rate, without its pole at the end of the support; it rises.
  double score(double place) const {
    const Point at = point(place);
    double sum = 0.0;
    for (const double value : values_)
      sum += (value - x_) * at.rate / t(value, at) * (1.0 + shape_ - std::exp(-w(value, at)));
    return at.left * (sum / static_cast<double>(values_.size()) - 1.0);
  }

  /// Minus the mean log likelihood.
  double cost(double place) const {
    const Point at = point(place);
    double sum = 0.0;
    for (const double value : values_) {
      const double w_of = w(value, at);
      sum += (1.0 + shape_) * w_of + std::exp(-w_of);
    }
    return sum / static_cast<double>(values_.size()) - std::log(at.rate);
  }

  /// Where the cost is least, searched from a place on.
  double best(double from) const {
    double low = from, high = from;
    for (double step = 0.5; score(low) > 0.0 && step < kFarthest; step *= 2.0) high = std::exchange(low, low - step);
    for (double step = 0.5; score(high) <= 0.0 && step < kFarthest; step *= 2.0) low = std::exchange(high, high + step);
    gsl_function zero{[](double place, void* line) { return static_cast<RateLine*>(line)->score(place); },
                      const_cast<RateLine*>(this)};
    return find_root(zero, low, high, 0.0, kExactPlace).value_or(from);
  }

 private:
  struct Point {
    double rate = 0.0;
    double left = 1.0;  ///< share of the end of the support that is left beyond the rate
  };

  Point point(double place) const {
    if (outermost_ == 0.0) return {std::exp(place), 1.0};
    return {(1.0 + shape_ * reach_) / outermost_ / (1.0 + std::exp(-place)), 1.0 / (1.0 + std::exp(place))};
  }
  /// 1 + shape z of a value; z counts scales from the location.
  double t(double value, const Point& at) const {
    return (1.0 + shape_ * reach_) * at.left + at.rate * (outermost_ + shape_ * (value - x_));
  }
  /// ln(t)/shape, z for the shape 0.
  double w(double value, const Point& at) const {
    return shape_ == 0.0 ? reach_ + (value - x_) * at.rate : std::log(t(value, at)) / shape_;
  }

  const std::vector<double>& values_;
  double x_, shape_, reach_;
  double outermost_ = 0.0;  // end of the support, less the level, in units of the shape; 0 where it has none
};

/// The likelihood of a level x, exceeded with a given probability, at the best scale and shape. Values are shifted and
/// scaled. Each search is along one line, so none can stall at the end of the support.
class LevelProfile {
 public:
  LevelProfile(const LawFit& fit, double exceedance) : exceedance_(exceedance), best_(fit.distribution) {
    const auto n = fit.values.size();
    unit_ = gsl_stats_sd(fit.values.data(), 1, n);
    shift_ = is_of_blocks(best_.law) ? gsl_stats_mean(fit.values.data(), 1, n) : best_.location;
    for (const double value : fit.values) z_.push_back((value - shift_) / unit_);
    best_.location = (best_.location - shift_) / unit_;
    best_.scale /= unit_;
    centre_ = best_.level(exceedance);
    start_again();
    seek_centre();
  }

  /// Where the likelihood of the level is largest: at the estimate, if the fit is not at a limit.
  double centre() const { return centre_; }
  double value_of(double x) const { return shift_ + unit_ * x; }
  void allow(double mean_cost) { allowed_ = cost(centre_) + mean_cost; }

  /// Cost of level x less the cost that the interval allows. The search for the shape begins at the last level that the
  /// interval allows, then at the fit: far from both the likelihood may have other maxima.
  double excess(double x) {
    const double shape = shape_, place = place_;
    double beyond = cost(x) - allowed_;
    if (beyond <= 0.0) return beyond;
    start_again();
    beyond = std::min(beyond, cost(x) - allowed_);
    if (beyond <= 0.0) return beyond;
    shape_ = shape;
    place_ = place;
    return beyond;
  }
  /// The next searches begin at the fit.
  void start_again() {
    shape_ = best_.law == Law::kWeibull ? std::log(best_.shape) : best_.shape;
    place_ = 0.0;
  }

 private:
  /// Minus the mean log likelihood of level x at the best scale and shape.
  double cost(double x) {
    if (best_.law == Law::kGumbel || best_.law == Law::kRayleigh) return cost(x, shape_);
    const double limit = std::log(1e-2);  // of Weibull's shape; the upper limit is for 1e4
    const bool weibull = best_.law == Law::kWeibull;
    struct Line {
      LevelProfile& profile;
      double x;
    } line{*this, x};
    gsl_function of_shape{[](double shape, void* on) {
                            const auto& l = *static_cast<Line*>(on);
                            return l.profile.cost(l.x, shape);
                          },
                          &line};
    const Minimum least = find_minimum_from(of_shape, shape_, kShapeStep, weibull ? limit : kLightest,
                                            weibull ? -2.0 * limit : kHeaviest, kTolerance);
    if (least.value < kForbidden) shape_ = least.at;
    return least.value;
  }

  /// The same of a given shape, of Weibull its logarithm.
  double cost(double x, double shape) {
    Distribution d{best_.law, 0.0, 1.0, best_.law == Law::kWeibull ? std::exp(shape) : shape};
    const double reach = d.level(exceedance_);  // of unit scale
    if (is_of_blocks(d.law)) {
      const RateLine line(z_, x, d.shape, reach);
      place_ = line.best(place_);
      return line.cost(place_);
    }
    d.scale = x / reach;
    if (!(d.scale > 0.0)) return kForbidden;
    double sum = 0.0;
    for (const double z : z_) sum -= d.log_density(z);
    return std::isfinite(sum) ? sum / static_cast<double>(z_.size()) : kForbidden;
  }

  /// The profile allows lighter tails than a fit does. When the fit is at that limit, the least cost is elsewhere: at a
  /// lighter shape, or at the lightest.
  void seek_centre() {
    const bool has_limit = best_.law == Law::kGev || best_.law == Law::kPareto;
    if (!has_limit || best_.shape > kLightestFit) return;
    gsl_function of_level{[](double x, void* profile) { return static_cast<LevelProfile*>(profile)->cost(x); }, this};
    const auto from = [&](double x) {
      return find_minimum_from(of_level, x, kFirstStep, x - kFarthest, x + kFarthest, kTolerance);
    };
    const Minimum near_fit = from(centre_);
    const double shape = std::exchange(shape_, kLightest);
    const Minimum near_end = from(std::max(z_.back(), near_fit.at - kNearEnd));
    centre_ = near_end.value < near_fit.value ? near_end.at : near_fit.at;
    if (centre_ == near_fit.at) shape_ = shape;
  }

  double exceedance_;
  Distribution best_;
  std::vector<double> z_;
  double shift_ = 0.0, unit_ = 1.0, centre_ = 0.0, allowed_ = 0.0;
  double shape_ = 0.0, place_ = 0.0;  // where the next search begins
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
