// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/extreme_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "brash/core/contract.hpp"

namespace brash::statistics {
namespace {

constexpr std::array<Law, 5> kLaws{Law::kGumbel, Law::kGev, Law::kPareto, Law::kWeibull, Law::kRayleigh};
constexpr double kRejected = 0.05;           // p below which a law does not fit
constexpr double kLightestShape = -0.5;      // of a regular likelihood
constexpr std::size_t kFewestForShape = 30;  // maxima, to estimate a shape
constexpr std::size_t kFewestMaxima = 10;    // for a level
constexpr std::size_t kEnoughEvents = 55;    // for ten blocks of five load cycles, with some cut at the ends
constexpr double kPeaksCorrelated = 0.3;     // successive peaks are then far from independent

const std::vector<double>& values_for(Law law, const ExtremeValues& values) {
  if (is_of_blocks(law)) return values.maxima;
  return law == Law::kPareto ? values.over : values.peaks;
}

/// Whether the record holds too few values for a law with a free shape.
bool is_short(const ExtremeValues& v) {
  return v.n_events < kFewestEvents || (v.maxima.size() < kFewestMaxima && v.over.size() < kFewestForShape);
}

/// The rule that a short record fails, with a length that suffices. Replicates lose the ends of their blocks.
std::string reason_of_short(const ExtremeValues& v) {
  const double cycle = v.duration / std::max<double>(1.0, v.n_events);
  const double needed = std::max(kEnoughEvents * cycle, (kFewestMaxima + 1.0) * v.block);
  const std::string rule =
      v.n_events < kFewestEvents
          ? fmt::format("{} load events in {:.3g} s, and {} are the fewest", v.n_events, v.duration, kFewestEvents)
          : fmt::format(
                "{} whole blocks of {:.3g} s and {} separate peaks over the threshold do not show the shape of "
                "the tail, {} blocks or {} peaks do",
                v.maxima.size(), v.block, v.over.size(), kFewestMaxima, kFewestForShape);
  return fmt::format("{}: about {:.3g} s are needed in one record", rule, needed);
}

/// Why a law cannot be fitted or cannot answer; "" when it can.
std::string refusal_of_law(Law law, const ExtremeValues& v, const ExtremeSettings& settings) {
  if (is_of_blocks(law) && v.block < v.cycle)
    return fmt::format("a block of {:.3g} s is shorter than the load cycle of {:.3g} s", v.block, v.cycle);
  if (is_of_blocks(law) && v.maxima.size() < kFewestMaxima)
    return fmt::format("{} blocks of {:.3g} s, and {} are needed", v.maxima.size(), v.block, kFewestMaxima);
  if (is_of_blocks(law) && settings.return_period <= v.block) return "the return period is shorter than a block";
  if (!is_of_blocks(law) && static_cast<double>(values_for(law, v).size()) * settings.return_period <= v.duration)
    return "the return period is shorter than the time between peaks";
  return "";
}

std::string refusal_of_period(const ExtremeValues& v, const ExtremeSettings& settings) {
  const double records = settings.return_period / v.duration;
  if (settings.return_period <= kLongestPeriod * v.duration || settings.extrapolate) return "";
  return fmt::format(
      "the return period is {:.4g} times the record, and {:g} times is the most: about {:.3g} s of record", records,
      kLongestPeriod, settings.return_period / kLongestPeriod);
}

ExtremeEstimate estimate(Law law, const ExtremeValues& v, const ExtremeSettings& settings, GoodnessOfFit& goodness) {
  ExtremeEstimate out;
  out.law = law;
  out.refusal = refusal_of_law(law, v, settings);
  if (!out.refusal.empty()) return out;
  const std::vector<double>& values = values_for(law, v);
  auto fit = fit_law(law, values, law == Law::kPareto ? v.threshold : v.mean);
  if (!fit) {
    out.refusal = fit.error().reason;
    return out;
  }
  out.fit = *std::move(fit);
  out.rate = is_of_blocks(law) ? 1.0 / v.block : static_cast<double>(out.fit->values.size()) / v.duration;
  out.goodness = goodness.test(*out.fit);
  out.refusal = refusal_of_period(v, settings);
  // There Pareto's interval holds the true level in half of the cases or fewer, if the tail is not that light.
  if (law == Law::kPareto && out.fit->distribution.shape <= kLightestShape)
    out.refusal = "the shape is at its limit of -0.5: the load seems bounded";
  if (out.refusal.empty()) out.level = level_of(out, settings.return_period, settings.confidence);
  return out;
}

/// Far beyond the record the interval of a level may have no upper end; a user who extrapolates is informed of that.
bool usable(const ExtremeEstimate& e, bool extrapolate) {
  return e.level && (extrapolate || std::isfinite(e.level->interval.upper)) && e.goodness.p_value >= kRejected;
}

/// Chooses one law: a law of the tail with a free shape. A fixed shape gives a narrower interval that covers less, and
/// Pareto's covers less than GEV's when the load is bounded.
void recommend(ExtremeAnalysis& analysis, bool extrapolate) {
  const ExtremeEstimate &gev = analysis.of(Law::kGev), &pareto = analysis.of(Law::kPareto);
  const auto choose = [&](const ExtremeEstimate& e, const char* values) {
    const double shape = e.fit->distribution.shape;
    analysis.recommended = e.law;
    analysis.reason =
        fmt::format("{} {} fit (p = {:.2f}) and show the shape of the tail, {:.2f}{}", e.fit->values.size(), values,
                    e.goodness.p_value, shape, shape <= kLightestShape ? " or lighter: the load seems bounded" : "");
  };
  const bool regular = pareto.fit && pareto.fit->distribution.shape > kLightestShape;
  if (usable(gev, extrapolate))
    choose(gev, "block maxima");
  else if (usable(pareto, extrapolate) && regular && pareto.fit->values.size() >= kFewestForShape)
    choose(pareto, "peaks over the threshold");
  else
    analysis.reason = "no law with a free shape fits the extremes of this record with a bounded interval";
}

void warn(const ExtremeValues& v, ExtremeAnalysis& analysis) {
  const double records = analysis.return_period / v.duration;
  if (v.acts_downwards) analysis.warnings.emplace_back(kNegativeMean);
  if (analysis.recommended && records > kMarkedPeriod)
    analysis.warnings.push_back(fmt::format(
        "the return period is {:.3g} times the record: the level rests on the law more than on data", records));
  if (v.clipping)
    analysis.warnings.push_back(
        fmt::format("{} samples stay at the largest value, {:.6g}: the sensor seems to clip, and larger loads are lost",
                    v.clipping->samples, v.clipping->value));
  if (std::string correlated = correlation_warning(v); !correlated.empty())
    analysis.warnings.push_back(std::move(correlated));
}

}  // namespace

std::string correlation_warning(const ExtremeValues& values) {
  if (values.correlation_of_peaks <= kPeaksCorrelated) return "";
  return fmt::format("successive peaks correlate by {:.2f}: the intervals are too short, and longer blocks help",
                     values.correlation_of_peaks);
}

std::optional<Estimate> level_of(const ExtremeEstimate& estimate, double return_period, double confidence) {
  if (!estimate.fit || !(estimate.rate * return_period > 1.0)) return std::nullopt;
  return level_with_interval(*estimate.fit, 1.0 / (estimate.rate * return_period), confidence);
}

ExtremeAnalysis analyse_extremes(ExtremeValues values, const ExtremeSettings& settings, GoodnessOfFit& goodness) {
  BRASH_EXPECTS(settings.return_period > 0.0, settings.return_period);
  ExtremeAnalysis analysis;
  analysis.return_period = settings.return_period;
  // Without a law for any; a record between both limits has laws, but none to recommend.
  const std::string refusal = values.n_events < kFewestEvents ? reason_of_short(values) : "";
  for (std::size_t i = 0; i < kLaws.size(); ++i) {
    analysis.estimates[i].law = kLaws[i];
    analysis.estimates[i].refusal = refusal;
    if (refusal.empty()) analysis.estimates[i] = estimate(kLaws[i], values, settings, goodness);
  }
  if (const std::string too_long = refusal_of_period(values, settings); !refusal.empty() || !too_long.empty())
    analysis.reason = refusal.empty() ? too_long : refusal;
  else if (is_short(values))
    analysis.reason = reason_of_short(values);
  else if (values.clipping)
    analysis.reason = "the largest loads are clipped";
  else
    recommend(analysis, settings.extrapolate);
  warn(values, analysis);
  analysis.values = std::move(values);
  return analysis;
}

std::vector<ThresholdFit> threshold_stability(const ExtremeValues& values, double return_period, double confidence) {
  constexpr int kThresholds = 8;
  constexpr std::size_t kFewest = 12;  // peaks; below, the shape is a guess
  std::vector<double> peaks = values.peaks;
  std::ranges::sort(peaks);
  std::vector<ThresholdFit> fits;
  if (peaks.size() <= kFewest) return fits;
  // Counts of peaks fall by an equal factor from one threshold to the next.
  const double factor =
      std::pow(static_cast<double>(kFewest) / static_cast<double>(peaks.size()), 1.0 / (kThresholds - 1));
  for (int i = 0; i < kThresholds; ++i) {
    const auto count = static_cast<std::size_t>(std::round(static_cast<double>(peaks.size()) * std::pow(factor, i)));
    const double threshold = i == 0 ? values.mean : peaks[peaks.size() - count - 1];
    const auto fit = fit_law(Law::kPareto, peaks, threshold);
    if (!fit) continue;
    const double expected = static_cast<double>(fit->values.size()) * return_period / values.duration;
    if (expected <= 1.0) continue;
    fits.push_back({threshold, fit->values.size(), fit->distribution.shape,
                    level_with_interval(*fit, 1.0 / expected, confidence)});
  }
  return fits;
}

}  // namespace brash::statistics
