// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/shared_tail.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "brash/core/contract.hpp"
#include "brash/statistics/random.hpp"
#include "gsl_checked.hpp"
#include "gsl_search.hpp"

namespace brash::statistics {
namespace {

using Peaks = std::vector<double>;

constexpr double kLightestFit = -0.5;  // shape below which the likelihood is not regular
constexpr double kLightest = -0.98;    // of the profile; at -1 the likelihood has no bound
constexpr double kHeaviest = 1.0;      // shape from which on the mean is infinite
constexpr int kShapes = 100;           // of the profile
constexpr int kSearched = 30;          // steps of shape in the search for the best one
constexpr double kNoShape = 1e-9;      // a shape nearer to 0 is 0: its powers are rounding
constexpr int kResamples = 100;

double sum_of(const Peaks& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// ln P(Y > y) of Pareto's law; -infinity beyond its end.
double log_exceedance(double y, double scale, double shape) {
  if (y <= 0.0) return 0.0;
  if (std::abs(shape) < kNoShape) return -y / scale;
  const double t = 1.0 + shape * y / scale;
  return t > 0.0 ? -std::log(t) / shape : -std::numeric_limits<double>::infinity();
}

/// The excess that is exceeded with a probability in (0, 1).
double excess_of(double probability, double scale, double shape) {
  return std::abs(shape) < kNoShape ? -scale * std::log(probability)
                                    : scale * std::expm1(-shape * std::log(probability)) / shape;
}

/// Whether a scale can be found: three excesses that are not all equal.
bool is_spread(const Peaks& y) {
  return y.size() >= SharedTail::kFewestOfState && std::ranges::max(y) > std::ranges::min(y);
}

/// Peaks of one record after another, less the threshold.
Peaks excesses_of(const StatePeaks& state) {
  Peaks all;
  for (const Peaks& record : state.over)
    for (const double peak : record) all.push_back(peak - state.threshold);
  return all;
}

}  // namespace

double StatePeaks::duration() const { return sum_of(durations); }

SharedTail::Scale SharedTail::best_scale(const Peaks& y, double shape) {
  const double end = shape < 0.0 ? -shape * *std::ranges::max_element(y) : 0.0;  // the scale is larger
  const auto n = static_cast<double>(y.size());
  struct Score {
    const Peaks& y;
    double shape, end;
  } score{y, shape, end};
  // Derivative of the likelihood by ln(scale); it falls.
  gsl_function derivative{[](double beyond, void* context) {
                            const auto& s = *static_cast<Score*>(context);
                            double sum = 0.0;
                            for (const double excess : s.y) sum += excess / (s.end + beyond + s.shape * excess);
                            return (1.0 + s.shape) * sum - static_cast<double>(s.y.size());
                          },
                          &score};
  const double most = (1.0 + shape) * sum_of(y) / n;
  const double scale = end + find_root(derivative, 1e-12 * most, most, 1e-10).value_or(most);
  double information = 0.0, likelihood = -n * std::log(scale);
  for (const double value : y) {
    const double t = scale + shape * value;
    information += (1.0 + shape) * value * scale / (t * t);
    likelihood -= std::abs(shape) < kNoShape ? value / scale : (1.0 + 1.0 / shape) * std::log(t / scale);
  }
  return {scale, likelihood, 1.0 / information};
}

SharedTail::AtShape SharedTail::at_shape(const std::vector<Peaks>& excesses, double shape) {
  AtShape at{shape, 0.0, {}};
  for (const Peaks& y : excesses) {
    at.scales.push_back(best_scale(y, shape));
    at.log_likelihood += at.scales.back().log_likelihood;
  }
  return at;
}

/// The best regular maximum of the likelihood; without one, the better limit. Below the lightest shape it may grow
/// again.
SharedTail::AtShape SharedTail::best_shape(const std::vector<Peaks>& excesses) {
  gsl_function cost{[](double shape, void* of) {
                      return -at_shape(*static_cast<const std::vector<Peaks>*>(of), shape).log_likelihood;
                    },
                    const_cast<std::vector<Peaks>*>(&excesses)};
  constexpr double kStep = (kHeaviest - kLightestFit) / kSearched;
  const auto shape = [](int i) { return kLightestFit + kStep * i; };
  Peaks costs;
  for (int i = 0; i <= kSearched; ++i) costs.push_back(GSL_FN_EVAL(&cost, shape(i)));
  int best = costs.front() < costs.back() ? 0 : kSearched;
  bool regular = false;
  for (int i = 1; i < kSearched; ++i)
    if (costs[i] <= costs[i - 1] && costs[i] <= costs[i + 1] && (!regular || costs[i] < costs[best]))
      best = i, regular = true;
  if (!regular) return at_shape(excesses, shape(best));
  return at_shape(excesses, find_minimum(cost, shape(best - 1), shape(best), shape(best + 1), 1e-5));
}

tl::expected<SharedTail, FitError> SharedTail::fit(std::vector<StatePeaks> states) {
  BRASH_EXPECTS(!states.empty());
  quiet_gsl();
  SharedTail tail;
  tail.states_ = std::move(states);
  for (const StatePeaks& state : tail.states_) {
    BRASH_EXPECTS(state.over.size() == state.durations.size() && state.duration() > 0.0, state.over.size());
    tail.excesses_.push_back(excesses_of(state));
    const Peaks& y = tail.excesses_.back();
    BRASH_EXPECTS(y.size() >= kFewestOfState && std::ranges::min(y) > 0.0, y.size());
    if (!is_spread(y)) return tl::unexpected(FitError{"all peaks of a state are equal"});
  }
  if (tail.n_peaks() < kFewestPeaks)
    return tl::unexpected(
        FitError{fmt::format("all states together have {} peaks over their thresholds, and {} are the fewest",
                             tail.n_peaks(), kFewestPeaks)});
  tail.best_ = best_shape(tail.excesses_);
  for (int i = 0; i < kShapes; ++i)
    tail.profile_.push_back(at_shape(tail.excesses_, kLightest + (kHeaviest - kLightest) * i / (kShapes - 1.0)));
  tail.profile_.push_back(tail.best_);
  tail.dispersion_ = tail.find_dispersion();
  return tail;
}

double SharedTail::find_dispersion() const {
  double records = 0.0;
  for (const StatePeaks& state : states_) {
    if (state.over.size() < 2) return 1.0;
    records += static_cast<double>(state.over.size()) / static_cast<double>(states_.size());
  }
  RandomStream stream(1, "shared tail", 0, "records");
  Peaks shapes;
  for (int b = 0; b < kResamples; ++b) {
    std::vector<Peaks> drawn;
    for (const StatePeaks& state : states_) {
      StatePeaks again{state.threshold, {}, {}};
      const auto last = static_cast<int>(state.over.size()) - 1;
      for (int r = 0; r <= last; ++r) again.over.push_back(state.over[stream.uniform_int(0, last)]);
      drawn.push_back(excesses_of(again));
    }
    if (std::ranges::all_of(drawn, is_spread)) shapes.push_back(best_shape(drawn).shape);
  }
  if (shapes.size() < kResamples / 2) return 1.0;
  // Few records differ less among themselves than from the truth.
  const double variance = gsl_stats_variance(shapes.data(), 1, shapes.size()) * records / (records - 1.0);
  const double independent = (1.0 + best_.shape) * (1.0 + best_.shape) / static_cast<double>(n_peaks());
  return std::max(1.0, variance / independent);
}

std::size_t SharedTail::n_peaks() const {
  std::size_t n = 0;
  for (const Peaks& y : excesses_) n += y.size();
  return n;
}

/// Twice the logarithm of the likelihood ratio that an interval allows, as in (S10).
double SharedTail::allowed(double confidence) const {
  BRASH_EXPECTS(confidence > 0.0 && confidence < 1.0, confidence);
  const auto n = static_cast<double>(n_peaks());
  const double freedom = std::max(1.0, n - static_cast<double>(states_.size()) - 1.0);
  const double t = gsl_cdf_tdist_Pinv(0.5 + 0.5 * confidence, freedom);
  return dispersion_ * n * std::log1p(t * t / freedom);
}

double SharedTail::deviance(const AtShape& at) const {
  const double most = std::ranges::max_element(profile_, {}, &AtShape::log_likelihood)->log_likelihood;
  return 2.0 * (most - at.log_likelihood);
}

Interval SharedTail::shape_interval(double confidence) const {
  Interval interval{best_.shape, best_.shape};
  for (const AtShape& at : profile_)
    if (deviance(at) <= allowed(confidence)) {
      interval.lower = std::min(interval.lower, at.shape);
      interval.upper = std::max(interval.upper, at.shape);
    }
  return interval;
}

TestResult SharedTail::one_shape() const {
  if (states_.size() == 1) return {0.0, 1.0};
  double own = 0.0;
  for (const Peaks& y : excesses_) own += best_shape({y}).log_likelihood;
  const double ratio = std::max(0.0, 2.0 * (own - best_.log_likelihood));
  return {ratio, gsl_cdf_chisq_Q(ratio, static_cast<double>(states_.size()) - 1.0)};
}

Peaks SharedTail::shares_at(const AtShape& at, const Peaks& peaks, double x) const {
  Peaks shares;
  for (std::size_t i = 0; i < states_.size(); ++i)
    shares.push_back(peaks[i] * std::exp(log_exceedance(x - states_[i].threshold, at.scales[i].scale, at.shape)));
  return shares;
}

/// @param peaks  over the thresholds, expected in the exposure of each state.
std::optional<double> SharedTail::level_at(const AtShape& at, const Peaks& peaks, double expected) const {
  // At `low` one state alone has the expected number, at `high` each has less than its even part.
  const double part = 0.5 * expected / static_cast<double>(states_.size());
  double low = -std::numeric_limits<double>::infinity(), high = low;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const auto level = [&](double number) {
      return states_[i].threshold + excess_of(number / peaks[i], at.scales[i].scale, at.shape);
    };
    if (peaks[i] > expected) low = std::max(low, level(expected));
    if (peaks[i] > part) high = std::max(high, level(part));
  }
  if (!std::isfinite(low)) return std::nullopt;
  if (!(high > low)) return low;
  struct Problem {
    const SharedTail& tail;
    const AtShape& at;
    const Peaks& peaks;
    double expected;
  } problem{*this, at, peaks, expected};
  gsl_function excess{[](double x, void* context) {
                        const auto& p = *static_cast<Problem*>(context);
                        const double sum = sum_of(p.tail.shares_at(p.at, p.peaks, x));
                        return std::log(std::max(sum, 1e-300) / p.expected);
                      },
                      &problem};
  return find_root(excess, low, high, 1e-10).value_or(low);
}

/// The level `x` at a given shape, moved by so many deviations of its own: those of the scales are of the logarithm of
/// the excess over the thresholds, those of the rates of the excess.
double SharedTail::moved(const AtShape& at, const Peaks& peaks, double x, double deviations) const {
  const Peaks shares = shares_at(at, peaks, x);
  const double sum = sum_of(shares);
  double by_scale = 0.0, by_rate = 0.0;  // variances of ln N
  double slope = 0.0, over = 0.0;        // of ln N by x; mean excess
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (shares[i] <= 0.0) continue;
    const double excess = std::max(0.0, x - states_[i].threshold), share = shares[i] / sum;
    const double rate = 1.0 / (at.scales[i].scale + at.shape * excess);
    by_scale += std::pow(share * rate * excess, 2) * at.scales[i].variance;
    by_rate += share * share / static_cast<double>(excesses_[i].size());
    slope += share * rate;
    over += share * excess;
  }
  const double of_rate = deviations * std::sqrt(by_rate) / slope;
  const double of_scale = over > 0.0 ? over * std::expm1(deviations * std::sqrt(by_scale) / (slope * over)) : 0.0;
  return x + std::copysign(std::hypot(of_rate, of_scale), deviations);
}

Peaks SharedTail::peaks_in(const Peaks& seconds) const {
  BRASH_EXPECTS(seconds.size() == states_.size(), seconds.size());
  Peaks peaks;
  for (std::size_t i = 0; i < states_.size(); ++i)
    peaks.push_back(seconds[i] * static_cast<double>(excesses_[i].size()) / states_[i].duration());
  return peaks;
}

Peaks SharedTail::shares(double x, const Peaks& seconds) const { return shares_at(best_, peaks_in(seconds), x); }

std::optional<Estimate> SharedTail::level(const Exposure& asked, double confidence) const {
  BRASH_EXPECTS(asked.expected > 0.0, asked.expected);
  const Peaks peaks = peaks_in(asked.seconds);
  const auto level = level_at(best_, peaks, asked.expected);
  if (!level) return std::nullopt;
  Interval ends{*level, *level};
  for (const AtShape& at : profile_) {
    const double left = allowed(confidence) - deviance(at);
    const auto middle = left < 0.0 ? std::nullopt : level_at(at, peaks, asked.expected);
    if (!middle) continue;
    ends.lower = std::min(ends.lower, moved(at, peaks, *middle, -std::sqrt(left)));
    ends.upper = std::max(ends.upper, moved(at, peaks, *middle, std::sqrt(left)));
  }
  return Estimate{*level, ends};
}

}  // namespace brash::statistics
