// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/history_comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "brash/analysis/history_statistics.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/core/error.hpp"
#include "brash/core/text.hpp"
#include "brash/simulation/warnings.hpp"
#include "brash/statistics/events.hpp"
#include "brash/statistics/extreme_analysis.hpp"
#include "brash/statistics/hypothesis.hpp"
#include "brash/statistics/intervals.hpp"
#include "brash/statistics/moments.hpp"

namespace brash::analysis {
namespace {

using nlohmann::ordered_json;
using statistics::Summary;
using Samples = std::vector<double>;

constexpr double kConfidence = 0.95;

ordered_json interval(const statistics::Interval& i) { return {i.lower, i.upper}; }

constexpr std::size_t kFewestReplicates = 3;  // whose spread gives an error

/// The summary of the squared deviations of a load from `mean`.
Summary squares_of(const LoadHistory& load, double mean) {
  LoadHistory squared = load;
  const auto square = [&](double& value) { value = (value - mean) * (value - mean); };
  std::ranges::for_each(squared.history.values, square);
  for (Samples& piece : squared.even.resampled) std::ranges::for_each(piece, square);
  return statistics::summarise(squared.history, squared.even);
}

/// Summary of peaks above the mean `of`: independent of each other, but all moved by the error of that mean.
Summary peak_summary(const Samples& peaks, const Summary& of) {
  const statistics::Moments m = statistics::moments(peaks);
  const double error = of.standard_deviation * of.standard_deviation / of.effective_sample_size;
  const double of_mean = m.variance / static_cast<double>(m.n) + error;
  Summary s;
  s.n = m.n;
  s.mean = m.mean;
  // Peaks of one height count as one: their mean is as uncertain as the mean above which they are taken.
  s.effective_sample_size = std::max(1.0, m.variance / of_mean);
  s.standard_deviation = std::sqrt(s.effective_sample_size * of_mean);
  return s;
}

Samples peaks_in(const LoadHistory& load, double dead_band) {
  const double mean = statistics::moments(load.history.values, load.even.weights).mean;
  Samples peaks;
  for (const statistics::LoadEvent& event : statistics::load_events(
           load.history, load.even, statistics::event_levels(load.history, load.even, mean, dead_band)))
    peaks.push_back(event.peak);
  return peaks;
}

/// The statistics of one side that the comparison needs. The errors are of one history by its correlation, or of
/// several by their spread.
struct Side {
  LoadHistory all;
  std::size_t histories = 1;
  Summary load;                        ///< of all samples
  Summary mean;                        ///< of the mean, also below
  Summary squares;                     ///< of the squared deviations
  statistics::Interval of_replicates;  ///< of the mean, of several histories
  Samples peaks;                       ///< of load events
  std::optional<Summary> mean_peak, peak_rate;
  Samples independent;

  /// @param dead_band  of load events, unit of the load; the same for both sides.
  Side(const std::vector<LoadHistory>& loads, double dead_band)
      : all(joined(loads)),
        histories(loads.size()),
        load(statistics::summarise(all.history, all.even)),
        mean(load),
        squares(squares_of(all, load.mean)),
        peaks(peaks_in(all, dead_band)) {
    if (histories > 1)
      take_spread(loads, dead_band);
    else
      take_peaks();
    // Four times: at two, neighbours of a first-order process still correlate by 0.13.
    const double apart = std::ceil(4.0 * load.autocorrelation_time / all.even.sampling.step);
    for (const auto piece : all.even.pieces(all.history))
      for (std::size_t i = 0; i < piece.size(); i += static_cast<std::size_t>(std::max(1.0, apart)))
        independent.push_back(piece[i]);
  }

  double peaks_per_second() const { return static_cast<double>(peaks.size()) / all.even.duration; }
  bool bears_verdict() const {
    return histories > 1 ? histories >= kFewestReplicates : load.effective_sample_size >= simulation::kFewSamples;
  }

 private:
  void take_peaks() {
    if (peaks.size() < 2) return;
    mean_peak = peak_summary(peaks, load);
    // Counts are taken as Poisson's, a relative error of 1/sqrt(count): wide for regular peaks.
    Summary rate;
    rate.mean = rate.standard_deviation = peaks_per_second();
    rate.effective_sample_size = static_cast<double>(peaks.size());
    peak_rate = rate;
  }

  void take_spread(const std::vector<LoadHistory>& loads, double dead_band) {
    Samples means, mean_squares, rates, heights;
    for (const LoadHistory& one : loads) {
      means.push_back(statistics::moments(one.history.values, one.even.weights).mean);
      mean_squares.push_back(squares_of(one, load.mean).mean);
      const Samples its_peaks = peaks_in(one, dead_band);
      rates.push_back(static_cast<double>(its_peaks.size()) / one.even.duration);
      if (its_peaks.size() >= 2) heights.push_back(statistics::moments(its_peaks).mean);
    }
    mean = over_replicates(means);
    of_replicates = statistics::mean_interval(means, kConfidence);
    squares = over_replicates(mean_squares);
    if (heights.size() == loads.size()) mean_peak = over_replicates(heights);
    peak_rate = over_replicates(rates);
  }
};

ordered_json side_json(const Side& side) {
  const Summary& s = side.load;
  ordered_json out{{"column", side.all.column},
                   {"unit", side.all.unit.empty() ? ordered_json() : ordered_json(side.all.unit)},
                   {"histories", side.histories},
                   {"from", side.all.history.times.front()},
                   {"duration", side.all.even.duration},
                   {"n", s.n},
                   {"gaps", side.all.even.sampling.gaps.size() + 1 - side.histories}};
  add_summary(s, out);
  if (side.histories > 1) {
    out["mean"] = side.mean.mean;
    out["mean_95"] = interval(side.of_replicates);
  }
  out["peaks"] = side.peaks.size();
  out["peaks_per_second"] = side.peaks_per_second();
  add_origin(side.all.origin, out);
  return out;
}

ordered_json ratio_json(const statistics::RatioComparison& ratio) {
  return {{"ratio", ratio.ratio}, {"ratio_95", interval(ratio.interval)}, {"p", ratio.test.p_value}};
}

/// Whether two histories are columns of one file, such as two sensors: they have the same times, and are not
/// independent.
bool are_paired(const Side& a, const Side& b) {
  return a.histories == 1 && b.histories == 1 && !a.all.file.empty() && a.all.file == b.all.file &&
         a.all.history.times == b.all.history.times;
}

/// Statistics of the differences of two paired histories.
Summary differences_of(const Side& a, const Side& b) {
  LoadHistory difference = a.all;
  for (std::size_t i = 0; i < difference.history.values.size(); ++i)
    difference.history.values[i] -= b.all.history.values[i];
  return statistics::summarise(difference.history, difference.even);
}

ordered_json mean_json(const Side& run, const Side& measured) {
  const bool paired = are_paired(run, measured);
  const statistics::MeanComparison c = paired
                                           ? statistics::compare_with_zero(differences_of(run, measured), kConfidence)
                                           : statistics::compare_means(run.mean, measured.mean, kConfidence);
  ordered_json out{{"difference", c.difference}, {"difference_95", interval(c.interval)}, {"p", c.test.p_value}};
  out["paired"] = paired;
  if (paired) {
    // The error of the second mean acts on the difference alone, and is of second order here.
    if (const double one = measured.mean.mean; one > 0.0) {
      out["ratio"] = 1.0 + c.difference / one;
      out["ratio_95"] = {1.0 + c.interval.lower / one, 1.0 + c.interval.upper / one};
    }
    return out;
  }
  if (run.mean.mean > 0.0 && measured.mean.mean > 0.0) {
    const statistics::RatioComparison ratio = statistics::compare_ratio(run.mean, measured.mean, kConfidence);
    out["ratio"] = ratio.ratio;
    out["ratio_95"] = interval(ratio.interval);
  }
  return out;
}

/// Heights of peaks, and how many there are.
void add_peaks(const Side& run, const Side& measured, ordered_json& out) {
  const auto positive = [](const std::optional<Summary>& s) { return s && s->mean > 0.0; };
  if (positive(run.mean_peak) && positive(measured.mean_peak))
    out["mean_peak"] = ratio_json(statistics::compare_ratio(*run.mean_peak, *measured.mean_peak, kConfidence));
  if (positive(run.peak_rate) && positive(measured.peak_rate))
    out["peak_rate"] = ratio_json(statistics::compare_ratio(*run.peak_rate, *measured.peak_rate, kConfidence));
}

/// The largest relative difference that the interval of each ratio still holds.
ordered_json hidden(const ordered_json& out) {
  ordered_json could_hide = ordered_json::object();
  for (const char* name : {"mean", "deviation", "mean_peak", "peak_rate", "growth"}) {
    if (!out.contains(name) || !out[name].contains("ratio_95")) continue;
    const ordered_json& ends = out[name]["ratio_95"];
    could_hide[name] = std::max(1.0 - ends[0].get<double>(), ends[1].get<double>() - 1.0);
  }
  return could_hide;
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
  for (const char* name : {"mean", "deviation", "mean_peak", "peak_rate", "growth", "distribution"}) {
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

/// Whether the larger loads of a side are its lowest.
bool acts_downwards(const ordered_json& side) {
  return statistics::acts_downwards(side["mean"].get<double>(), side["minimum"].get<double>(),
                                    side["maximum"].get<double>());
}

std::string ratio_row(const char* name, const ordered_json& out, const char* key) {
  if (!out.contains(key) || !out[key].contains("ratio")) return fmt::format("  {:<20} cannot be compared\n", name);
  const ordered_json& c = out[key];
  return fmt::format("  {:<20}{:8.3f}  [{:.3f}, {:.3f}]   {}\n", name, c["ratio"].get<double>(),
                     c["ratio_95"][0].get<double>(), c["ratio_95"][1].get<double>(),
                     p_text(c["p_adjusted"].get<double>()));
}

/// Means of the windows of both sides.
std::string growth_text(const ordered_json& c) {
  if (!c.contains("growth")) return "";
  const ordered_json& g = c["growth"];
  const auto means = [&](const char* side) {
    std::vector<std::string> found;
    for (const ordered_json& window : g["windows"][side])
      found.push_back(window["mean"].is_null() ? "-" : fmt::format("{:.4g}", window["mean"].get<double>()));
    return fmt::format("{}", fmt::join(found, ", "));
  };
  const auto [first, second] = side_names(c);
  return fmt::format(
      "  growth              second half over first: {:.3g} and {:.3g}; means of quarters of {:.4g} {}\n"
      "                      {}: {}\n                      {}: {}\n",
      g["growth"][0].get<double>(), g["growth"][1].get<double>(), g["travel"].get<double>(),
      g["unit"].get<std::string>(), first, means("run"), second, means("measured"));
}

}  // namespace

Summary over_replicates(const std::vector<double>& values) {
  const statistics::Moments m = statistics::moments(values);
  Summary s;
  s.n = m.n;
  s.mean = m.mean;
  s.standard_deviation = std::sqrt(m.variance);
  s.effective_sample_size = static_cast<double>(m.n);
  return s;
}

LoadHistory joined(const std::vector<LoadHistory>& loads) {
  if (loads.size() == 1) return loads.front();
  LoadHistory all{loads.front().column, {}, {}, 0, loads.front().unit, loads.front().file};
  double longest = 0.0;
  for (const LoadHistory& load : loads) longest = std::max(longest, load.even.sampling.longest);
  double end = loads.front().history.times.front() - 4.0 * longest;
  for (const LoadHistory& load : loads) {
    if (load.unit != all.unit)
      throw InputError(
          Complaint{load.file, fmt::format("column '{}' is in '{}'", printable(load.column), printable(load.unit)),
                    fmt::format("'{}', as in {}", printable(all.unit), all.file), "give the same unit in all files"});
    const double shift = end + 4.0 * longest - load.history.times.front();
    for (const double time : load.history.times) all.history.times.push_back(time + shift);
    all.history.values.insert(all.history.values.end(), load.history.values.begin(), load.history.values.end());
    all.n_missing += load.n_missing;
    end = all.history.times.back();
  }
  all.even = statistics::make_even(all.history, 2.0 * longest);
  all.origin = origin_of(loads);
  return all;
}

ordered_json compare_histories(const LoadHistory& run, const LoadHistory& measured, const IceSpeeds& speeds) {
  return compare_histories(std::vector{run}, std::vector{measured}, speeds);
}

ordered_json compare_histories(const std::vector<LoadHistory>& runs, const std::vector<LoadHistory>& measured_runs,
                               const IceSpeeds& speeds) {
  double dead_band = 0.0;
  for (const auto* loads : {&runs, &measured_runs})
    for (const LoadHistory& load : *loads)
      dead_band = std::max(dead_band, statistics::noise_band(load.history, load.even));
  const Side run(runs, dead_band), measured(measured_runs, dead_band);
  ordered_json out{{"run", side_json(run)}, {"measured", side_json(measured)}, {"dead_band", dead_band}};
  out["mean"] = mean_json(run, measured);
  if (run.squares.mean > 0.0 && measured.squares.mean > 0.0)
    out["deviation"] = ratio_json(statistics::compare_deviations(run.squares, measured.squares, kConfidence));
  add_peaks(run, measured, out);
  if (const ordered_json growth = compare_growth(runs, measured_runs, speeds); !growth.is_null())
    out["growth"] = growth;
  const statistics::TestResult ks = statistics::kolmogorov_smirnov(run.independent, measured.independent);
  out["distribution"] = {{"largest_distance", ks.statistic},
                         {"p", ks.p_value},
                         {"independent_samples", {run.independent.size(), measured.independent.size()}}};
  out["spectrum"] = spectrum_json(run.all, measured.all);
  const ordered_json differs = differences(out);
  out["differs"] = run.bears_verdict() && measured.bears_verdict() ? differs : ordered_json();
  out["could_hide"] = hidden(out);
  return out;
}

std::array<std::string, 2> side_names(const ordered_json& comparison) {
  const auto kind = [&](const char* side) { return comparison[side].contains("origin") ? "run" : "measured"; };
  const std::string first = kind("run"), second = kind("measured");
  if (first != second) return {first, second};
  return {first + " 1", second + " 2"};
}

std::string comparison_text(const ordered_json& c) {
  const auto [first, second] = side_names(c);
  const ordered_json& unit = c["run"]["unit"];
  std::string text =
      origin_text(c["run"], first + ": ") + origin_text(c["measured"], second + ": ") +
      fmt::format("  {:<17} {:>12} {:>12}\n",
                  unit.is_null() ? "" : fmt::format("loads [{}]", printable(unit.get<std::string>())), first, second);
  const auto row = [&](const char* name, const char* key) {
    text += fmt::format("  {:<17} {:>12.6g} {:>12.6g}\n", name, c["run"][key].get<double>(),
                        c["measured"][key].get<double>());
  };
  if (c["run"]["histories"].get<int>() > 1 || c["measured"]["histories"].get<int>() > 1) row("histories", "histories");
  row("mean", "mean");
  row("deviation", "standard_deviation");
  if (acts_downwards(c["run"]) || acts_downwards(c["measured"])) row("1 %", "quantile_1"), row("minimum", "minimum");
  row("99 %", "quantile_99");
  row("maximum", "maximum");
  row("peaks a second", "peaks_per_second");
  row("duration [s]", "duration");
  row("independent", "effective_sample_size");
  if (c["run"]["histories"].get<int>() == 1) text += short_note(first.c_str(), c["run"]);
  if (c["measured"]["histories"].get<int>() == 1) text += short_note(second.c_str(), c["measured"]);
  text += fmt::format("{} over {}, 95 % interval, p-value of the test of equality (after Holm)\n", first, second);
  text += ratio_row("mean", c, "mean") + ratio_row("deviation", c, "deviation") +
          ratio_row("mean peak", c, "mean_peak") + ratio_row("peaks a second", c, "peak_rate") +
          ratio_row("growth", c, "growth");
  const ordered_json& d = c["distribution"];
  text += fmt::format("  distributions       largest distance {:.3f} (Kolmogorov-Smirnov), {}\n",
                      d["largest_distance"].get<double>(), p_text(d["p_adjusted"].get<double>()));
  text +=
      fmt::format("  peaks               of load events beyond {:.3g} about the mean, the larger noise floor of both\n",
                  c["dead_band"].get<double>());
  text += growth_text(c);
  if (c["mean"]["paired"].get<bool>())
    text +=
        "  two columns of one file: the means are compared by their differences in time; the other tests take the "
        "columns "
        "as independent\n";
  if (const ordered_json& s = c["spectrum"]; !s.is_null())
    text += fmt::format(
        "  spectra             {:.0f} % of {} lines outside the 95 % band ({:.0f} % in shape alone), correlation of "
        "the "
        "shapes {:.2f},\n                      mean frequency {:.3g} against {:.3g} Hz\n",
        100.0 * s["outside_95"].get<double>(), s["lines"].get<std::size_t>(),
        100.0 * s["shape_outside_95"].get<double>(), s["shape_correlation"].get<double>(),
        s["mean_frequency"][0].get<double>(), s["mean_frequency"][1].get<double>());
  if (c["differs"].is_null()) return text + "no verdict: a history is too short, or there are two replicates\n";
  const auto differs = c["differs"].get<std::vector<std::string>>();
  if (!differs.empty()) return text + fmt::format("different at 5 %: {}\n", fmt::join(differs, ", "));
  std::vector<std::string> sizes;
  for (const auto& [name, size] : c["could_hide"].items())
    sizes.push_back(fmt::format("{} {:.2g} %", name, 100.0 * size.get<double>()));
  return text + fmt::format("no difference at 5 %; differences of this size could hide: {}\n", fmt::join(sizes, ", "));
}

}  // namespace brash::analysis
