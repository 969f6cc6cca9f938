// SPDX-License-Identifier: GPL-3.0-or-later
#include "history_comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "brash/simulation/warnings.hpp"
#include "brash/statistics/hypothesis.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/peaks.hpp"
#include "history_statistics.hpp"

namespace brash::cli {
namespace {

using nlohmann::ordered_json;
using statistics::Summary;
using Samples = std::vector<double>;

constexpr double kConfidence = 0.95;

ordered_json interval(const statistics::Interval& i) { return {i.lower, i.upper}; }

/// The statistics of one history that the comparison needs.
struct Side {
  Summary load;
  Summary squares;  ///< of the squared deviations
  Samples peaks;    ///< between upward crossings of the mean
  Samples independent;

  explicit Side(const LoadHistory& history) : load(statistics::summarise(history.history, history.even)) {
    LoadHistory squared = history;
    const auto square = [&](double& value) { value = (value - load.mean) * (value - load.mean); };
    std::ranges::for_each(squared.history.values, square);
    for (Samples& piece : squared.even.pieces) std::ranges::for_each(piece, square);
    squares = statistics::summarise(squared.history, squared.even);
    for (const auto piece : statistics::raw_pieces(history.history, history.even))
      for (const statistics::Peak& peak : statistics::peaks_between_crossings(piece, load.mean))
        peaks.push_back(peak.value);
    // Four times: at two, neighbours of a first-order process still correlate by 0.13.
    const double apart = std::ceil(4.0 * load.autocorrelation_time / history.even.sampling.step);
    for (const Samples& piece : history.even.pieces)
      for (std::size_t i = 0; i < piece.size(); i += static_cast<std::size_t>(std::max(1.0, apart)))
        independent.push_back(piece[i]);
  }

  double peaks_per_second(const LoadHistory& history) const {
    return static_cast<double>(peaks.size()) / history.even.duration;
  }
};

ordered_json side_json(const LoadHistory& history, const Side& side) {
  const Summary& s = side.load;
  return {{"column", history.column},
          {"unit", history.unit.empty() ? ordered_json() : ordered_json(history.unit)},
          {"from", history.history.times.front()},
          {"duration", history.even.duration},
          {"n", s.n},
          {"gaps", history.even.sampling.gaps.size()},
          {"mean", s.mean},
          {"mean_95", interval_of_mean(s)},
          {"standard_deviation", s.standard_deviation},
          {"quantile_99", s.quantile_99},
          {"maximum", s.maximum},
          {"autocorrelation_time", s.autocorrelation_time},
          {"effective_sample_size", s.effective_sample_size},
          {"long_enough", s.long_enough},
          {"peaks", side.peaks.size()},
          {"peaks_per_second", side.peaks_per_second(history)}};
}

ordered_json ratio_json(const statistics::RatioComparison& ratio) {
  return {{"ratio", ratio.ratio}, {"ratio_95", interval(ratio.interval)}, {"p", ratio.test.p_value}};
}

ordered_json mean_json(const Side& run, const Side& measured) {
  const statistics::MeanComparison c = statistics::compare_means(run.load, measured.load, kConfidence);
  ordered_json out{{"difference", c.difference}, {"difference_95", interval(c.interval)}, {"p", c.test.p_value}};
  if (run.load.mean > 0.0 && measured.load.mean > 0.0) {
    const statistics::RatioComparison ratio = statistics::compare_ratio(run.load, measured.load, kConfidence);
    out["ratio"] = ratio.ratio;
    out["ratio_95"] = interval(ratio.interval);
  }
  return out;
}

/// Summary of peaks above the mean `of`: independent of each other, but all moved by the error of that mean.
Summary peak_summary(const Samples& peaks, const Summary& of) {
  const statistics::Moments m = statistics::moments(peaks);
  const double error = of.standard_deviation * of.standard_deviation / of.effective_sample_size;
  const double of_mean = m.variance / static_cast<double>(m.n) + error;
  Summary s;
  s.n = m.n;
  s.mean = m.mean;
  // Peaks of one height count as one: their mean is as uncertain as the mean that they stand on.
  s.effective_sample_size = std::max(1.0, m.variance / of_mean);
  s.standard_deviation = std::sqrt(s.effective_sample_size * of_mean);
  return s;
}

/// Heights of peaks, and how many there are: the counts taken as Poisson's, which is wide for regular peaks.
void add_peaks(const LoadHistory& run_history, const LoadHistory& measured_history, const Side& run,
               const Side& measured, ordered_json& out) {
  if (run.peaks.size() < 2 || measured.peaks.size() < 2) return;
  const Summary a = peak_summary(run.peaks, run.load), b = peak_summary(measured.peaks, measured.load);
  if (a.mean > 0.0 && b.mean > 0.0) out["mean_peak"] = ratio_json(statistics::compare_ratio(a, b, kConfidence));
  Summary rate_a, rate_b;
  rate_a.mean = run.peaks_per_second(run_history);
  rate_b.mean = measured.peaks_per_second(measured_history);
  rate_a.standard_deviation = rate_a.mean;  // a relative error of 1/sqrt(count)
  rate_b.standard_deviation = rate_b.mean;
  rate_a.effective_sample_size = static_cast<double>(run.peaks.size());
  rate_b.effective_sample_size = static_cast<double>(measured.peaks.size());
  out["peak_rate"] = ratio_json(statistics::compare_ratio(rate_a, rate_b, kConfidence));
}

ordered_json spectrum_json(const LoadHistory& run, const LoadHistory& measured) {
  // Segments as long for both: an eighth of the shorter history.
  const double segment = std::min(run.even.duration, measured.even.duration) / 8.0;
  const auto a = spectrum_of(run, segment), b = spectrum_of(measured, segment);
  if (!a || !b) return nullptr;
  const auto compared = statistics::compare_spectra(*a, *b, kConfidence);
  if (!compared) return nullptr;
  return {{"segment", segment},
          {"lines", compared->ratio.size()},
          {"outside_95", compared->outside},
          {"shape_outside_95", compared->shape_outside},
          {"shape_correlation", compared->shape_correlation},
          {"mean_frequency", {compared->mean_frequency_a, compared->mean_frequency_b}}};
}

/// Names the statistics that differ at 5 % after Holm's adjustment, which it adds to each test.
ordered_json differences(ordered_json& out) {
  std::vector<std::string> names;
  Samples p;
  for (const char* name : {"mean", "deviation", "mean_peak", "peak_rate", "distribution"}) {
    if (!out.contains(name)) continue;
    names.emplace_back(name);
    p.push_back(out[name]["p"].get<double>());
  }
  const Samples adjusted = statistics::holm(p);
  ordered_json differs = ordered_json::array();
  for (std::size_t i = 0; i < names.size(); ++i) {
    out[names[i]]["p_adjusted"] = adjusted[i];
    if (adjusted[i] < 1.0 - kConfidence) differs.push_back(names[i]);
  }
  return differs;
}

std::string ratio_row(const char* name, const ordered_json& out, const char* key) {
  if (!out.contains(key) || !out[key].contains("ratio")) return fmt::format("  {:<20} cannot be compared\n", name);
  const ordered_json& c = out[key];
  return fmt::format("  {:<20}{:8.3f}  [{:.3f}, {:.3f}]   p = {:.2g}\n", name, c["ratio"].get<double>(),
                     c["ratio_95"][0].get<double>(), c["ratio_95"][1].get<double>(), c["p_adjusted"].get<double>());
}

}  // namespace

ordered_json compare_histories(const LoadHistory& run_history, const LoadHistory& measured_history) {
  const Side run(run_history), measured(measured_history);
  ordered_json out{{"run", side_json(run_history, run)}, {"measured", side_json(measured_history, measured)}};
  out["mean"] = mean_json(run, measured);
  if (run.squares.mean > 0.0 && measured.squares.mean > 0.0)
    out["deviation"] = ratio_json(statistics::compare_deviations(run.squares, measured.squares, kConfidence));
  add_peaks(run_history, measured_history, run, measured, out);
  const statistics::TestResult ks = statistics::kolmogorov_smirnov(run.independent, measured.independent);
  out["distribution"] = {{"largest_distance", ks.statistic},
                         {"p", ks.p_value},
                         {"independent_samples", {run.independent.size(), measured.independent.size()}}};
  out["spectrum"] = spectrum_json(run_history, measured_history);
  const ordered_json differs = differences(out);
  const bool bears_verdict =
      std::min(run.load.effective_sample_size, measured.load.effective_sample_size) >= simulation::kFewSamples;
  out["differs"] = bears_verdict ? differs : ordered_json();
  return out;
}

std::string comparison_text(const ordered_json& c) {
  std::string text = "                           run     measured\n";
  const auto row = [&](const char* name, const char* key) {
    text += fmt::format("  {:<17} {:>12.6g} {:>12.6g}\n", name, c["run"][key].get<double>(),
                        c["measured"][key].get<double>());
  };
  row("mean", "mean");
  row("deviation", "standard_deviation");
  row("99 %", "quantile_99");
  row("maximum", "maximum");
  row("peaks a second", "peaks_per_second");
  row("duration [s]", "duration");
  row("independent", "effective_sample_size");
  text += short_note("the run", c["run"]) + short_note("the measurement", c["measured"]);
  text += "run over measured, 95 % interval, p-value of the test of equality (after Holm)\n";
  text += ratio_row("mean", c, "mean") + ratio_row("deviation", c, "deviation") +
          ratio_row("mean peak", c, "mean_peak") + ratio_row("peaks a second", c, "peak_rate");
  const ordered_json& d = c["distribution"];
  text += fmt::format("  distributions       largest distance {:.3f} (Kolmogorov-Smirnov), p = {:.2g}\n",
                      d["largest_distance"].get<double>(), d["p_adjusted"].get<double>());
  if (const ordered_json& s = c["spectrum"]; !s.is_null())
    text += fmt::format(
        "  spectra             {:.0f} % of {} lines outside the 95 % band ({:.0f} % in shape alone), correlation of "
        "the "
        "shapes {:.2f},\n                      mean frequency {:.3g} against {:.3g} Hz\n",
        100.0 * s["outside_95"].get<double>(), s["lines"].get<std::size_t>(),
        100.0 * s["shape_outside_95"].get<double>(), s["shape_correlation"].get<double>(),
        s["mean_frequency"][0].get<double>(), s["mean_frequency"][1].get<double>());
  if (c["differs"].is_null()) return text + "no verdict: a history is too short\n";
  const auto differs = c["differs"].get<std::vector<std::string>>();
  text += differs.empty() ? "no difference at 5 %\n" : fmt::format("different at 5 %: {}\n", fmt::join(differs, ", "));
  return text;
}

}  // namespace brash::cli
