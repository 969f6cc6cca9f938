// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/history_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <type_traits>

#include "brash/analysis/tables.hpp"
#include "brash/core/text.hpp"
#include "brash/simulation/warnings.hpp"
#include "brash/statistics/events.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/summary.hpp"

namespace brash::analysis {
namespace {

using nlohmann::ordered_json;
using Samples = std::vector<double>;

ordered_json interval(const statistics::Interval& i) { return {i.lower, i.upper}; }

/// How many load events there are and how high.
ordered_json peaks_json(const statistics::ExtremeValues& v) {
  ordered_json out{{"count", v.n_events},
                   {"per_second", static_cast<double>(v.n_events) / v.duration},
                   {"level", v.mean},
                   {"dead_band", v.dead_band}};
  if (v.peaks.size() >= 2) {
    const statistics::Moments m = statistics::moments(v.peaks);
    out["mean"] = m.mean;
    out["standard_deviation"] = std::sqrt(m.variance);
    out["maximum"] = m.maximum;
  }
  return out;
}

statistics::ExtremeAnalysis analysed(const LoadHistory& load, double memory,
                                     const statistics::ExtremeSettings& settings) {
  statistics::GoodnessOfFit goodness;
  return statistics::analyse_extremes(
      statistics::extreme_values({{&load.history, &load.even, memory, load.clipping}}, settings), settings, goodness);
}

/// Where the spectrum is highest.
ordered_json spectral_peak(const LoadHistory& load, double segment) {
  const auto spectrum = spectrum_of(load, segment);
  if (!spectrum) return nullptr;
  const auto highest = std::max_element(spectrum->density.begin() + 1, spectrum->density.end());
  const auto line = static_cast<std::size_t>(highest - spectrum->density.begin());
  return {{"frequency", spectrum->frequency[line]},
          {"resolution", spectrum->frequency[1]},
          {"density", *highest},
          {"segments", spectrum->n_segments}};
}

ordered_json sampling_json(const LoadHistory& load) {
  const statistics::Sampling& sampling = load.even.sampling;
  ordered_json gaps = ordered_json::array();
  double unknown = 0.0;
  for (const statistics::Gap& gap : sampling.gaps) {
    gaps.push_back({gap.from, gap.to});
    unknown += gap.to - gap.from;
  }
  return {{"even", sampling.even},
          {"step", sampling.step},
          {"lost_samples", sampling.n_lost},
          {"shortest_step", sampling.shortest},
          {"longest_step", sampling.longest},
          {"missing_values", load.n_missing},
          {"gaps", gaps},
          {"time_in_gaps", unknown}};
}

std::string sampling_text(const ordered_json& s) {
  std::string text;
  if (const std::size_t n_lost = s["lost_samples"].get<std::size_t>(); !s["even"].get<bool>()) {
    const std::string how = n_lost > 0 ? fmt::format("every {:.4g} s, {} samples lost", s["step"].get<double>(), n_lost)
                                       : fmt::format("uneven, {:.4g} to {:.4g} s", s["shortest_step"].get<double>(),
                                                     s["longest_step"].get<double>());
    text += fmt::format(
        "  sampling             {}: statistics weigh each sample with its time; spectrum and\n"
        "                       autocorrelation from values interpolated every {:.4g} s\n",
        how, s["step"].get<double>());
  }
  const std::size_t n_missing = s["missing_values"].get<std::size_t>();
  if (n_missing > 0 || !s["gaps"].empty())
    text += fmt::format("  gaps                 {} ({:.6g} s together), {} values missing\n", s["gaps"].size(),
                        s["time_in_gaps"].get<double>(), n_missing);
  return text;
}

/// The largest number up to `n` without a prime factor above 5: a transform of such a length is fast.
std::size_t fast_length(std::size_t n) {
  for (; n > 1; --n) {
    std::size_t rest = n;
    for (const std::size_t factor : {2, 3, 5})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) break;
  }
  return n;
}

std::string interval_text(const ordered_json& mean_95) {
  if (mean_95[0].is_null()) return "no interval";
  return fmt::format("95 % interval [{:.6g}, {:.6g}]", mean_95[0].get<double>(), mean_95[1].get<double>());
}

/// A line for each row of the statistics in this unit.
std::string rows_of(const ordered_json& s, std::string_view unit) {
  std::string text;
  std::string_view row;
  statistics::Summary::visit([&](const statistics::Statistic& of, auto) {
    if (of.unit != unit || *of.row == '\0') return;
    text += row == of.row ? "   " : fmt::format("{}  {:<21}", row.empty() ? "" : "\n", of.row);
    row = of.row;
    const ordered_json& value = s[of.name];
    if (value.is_array())
      text += interval_text(value);
    else
      text += fmt::format("{:.{}g}{}", value.get<double>(), unit.empty() ? 6 : 4, of.note);
  });
  return text + "\n";
}

}  // namespace

std::vector<statistics::LoadEvent> events_of(const LoadHistory& load, std::optional<double> dead_band) {
  const statistics::Moments m = statistics::moments(load.history.values, load.even.weights);
  if (dead_band) *dead_band *= std::sqrt(m.variance);
  return statistics::load_events(load.history, load.even,
                                 statistics::event_levels(load.history, load.even, m.mean, dead_band));
}

statistics::ExtremeAnalysis extremes_of(const LoadHistory& load, const statistics::ExtremeSettings& settings) {
  const double memory = statistics::autocorrelation_time(load.history, load.even).tau;
  return analysed(load, memory, settings);
}

ordered_json interval_of_mean(const statistics::Summary& summary) {
  if (summary.effective_sample_size < simulation::kFewSamples) return {nullptr, nullptr};
  return interval(summary.mean_95);
}

void add_summary(const statistics::Summary& summary, ordered_json& out) {
  statistics::Summary::visit([&](const statistics::Statistic& of, auto member) {
    if constexpr (std::is_same_v<decltype(member), statistics::Interval statistics::Summary::*>)
      out[of.name] = interval_of_mean(summary);
    else
      out[of.name] = summary.*member;
  });
}

bool acts_downwards(const statistics::Summary& s) { return statistics::acts_downwards(s.mean, s.minimum, s.maximum); }

std::string short_note(const char* name, const ordered_json& side) {
  if (const double samples = side["effective_sample_size"].get<double>(); samples < simulation::kFewSamples)
    return fmt::format(
        "  note: {} has {:.1f} independent samples, too few for an interval: give one of {:.2g} s or more\n", name,
        samples, 2.0 * simulation::kFewSamples * side["autocorrelation_time"].get<double>());
  return side["long_enough"].get<bool>() ? "" : fmt::format("  note: {} is {}\n", name, kTooShort);
}

std::optional<statistics::Spectrum> spectrum_of(const LoadHistory& load, double segment) {
  const statistics::Pieces pieces = load.even.pieces(load.history);
  std::size_t longest = 0;
  for (const auto piece : pieces) longest = std::max(longest, piece.size());
  // An eighth of the history gives about 15 segments.
  const std::size_t given = static_cast<std::size_t>(std::round(segment / load.even.sampling.step));
  const std::size_t wanted = fast_length(segment > 0.0 ? given : longest / 8);
  if (wanted < 16 || wanted > longest) return std::nullopt;
  return statistics::welch_spectrum(pieces, load.even.sampling.step, wanted);
}

ordered_json statistics_of(const LoadHistory& load, const StatisticsSettings& settings) {
  const statistics::Summary s = statistics::summarise(load.history, load.even);
  ordered_json out{{"column", load.column},
                   {"unit", load.unit.empty() ? ordered_json() : ordered_json(load.unit)},
                   {"start", load.start.empty() ? ordered_json() : ordered_json(load.start)},
                   {"from", load.history.times.front()},
                   {"dt", load.even.sampling.step},
                   {"n", s.n},
                   {"duration", load.even.duration},
                   {"sampling", sampling_json(load)}};
  add_summary(s, out);
  add_origin(load.origin, out);
  out["warnings"] = ordered_json::array();
  if (const std::string gaps = statistics::gap_warning(load.history, load.even); !gaps.empty())
    out["warnings"].push_back(gaps);
  if (load.marker) out["warnings"].push_back(marker_warning(load.marker));
  const statistics::ExtremeAnalysis extremes = analysed(load, s.autocorrelation_time, settings.extremes);
  out["noise_floor"] = statistics::noise_floor(load.even.pieces(load.history));
  out["peaks"] = peaks_json(extremes.values);
  add_extremes(extremes, out);
  out["spectrum_peak"] = spectral_peak(load, settings.segment);
  out["fatigue"] = fatigue_json({&load}, settings.exponents, extremes.values.shortest_block, settings.frequency);
  return out;
}

std::string statistics_text(const ordered_json& s) {
  const auto value = [&](const char* key) { return s[key].get<double>(); };
  std::string text =
      fmt::format("{}{}: {} samples every {:.6g} s, {:.6g} s from t = {:.6g} s{}\n", s["column"].get<std::string>(),
                  s["unit"].is_null() ? "" : fmt::format(" [{}]", printable(s["unit"].get<std::string>())),
                  s["n"].get<std::size_t>(), value("dt"), value("duration"), value("from"),
                  s["start"].is_null() ? "" : " after " + printable(s["start"].get<std::string>()));
  if (s.contains("statistics_from"))
    text += fmt::format(
        "  begins               at statistics_from = {:.6g} s of summary.json; --from 0 takes the whole history\n",
        value("statistics_from"));
  text += origin_text(s, "  ");
  text += sampling_text(s["sampling"]);
  text += rows_of(s, "") + rows_of(s, "1");
  text += fmt::format("  autocorrelation time {:.4g} s, {:.4g} independent samples\n", value("autocorrelation_time"),
                      value("effective_sample_size"));
  const ordered_json& peaks = s["peaks"];
  text += fmt::format("  peaks above the mean {} ({:.4g} a second)", peaks["count"].get<std::size_t>(),
                      peaks["per_second"].get<double>());
  if (peaks.contains("mean"))
    text += fmt::format(", mean {:.6g}, deviation {:.6g}", peaks["mean"].get<double>(),
                        peaks["standard_deviation"].get<double>());
  text += fmt::format(", dead band {:.4g}\n", peaks["dead_band"].get<double>());
  if (const ordered_json& line = s["spectrum_peak"]; !line.is_null())
    text += fmt::format("  highest spectrum at  {:.4g} Hz (lines every {:.4g} Hz)\n", line["frequency"].get<double>(),
                        line["resolution"].get<double>());
  text += extremes_text(s) + fatigue_text(s["fatigue"]);
  for (const ordered_json& warning : s["warnings"]) text += fmt::format("  warning: {}\n", warning.get<std::string>());
  return text + short_note("the history", s);
}

}  // namespace brash::analysis
