// SPDX-License-Identifier: GPL-3.0-or-later
#include "stats_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "brash/statistics/extremes.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/peaks.hpp"
#include "brash/statistics/quantile.hpp"
#include "brash/statistics/spectrum.hpp"
#include "brash/statistics/summary.hpp"

namespace brash::cli {
namespace {

using nlohmann::ordered_json;
using Samples = std::vector<double>;

ordered_json interval(const statistics::Interval& i) { return {i.lower, i.upper}; }

/// Peaks between upward crossings of the mean: how many loading events there are and how high.
ordered_json crossing_peaks(const Samples& samples, double mean, double dt) {
  Samples values;
  for (const statistics::Peak& peak : statistics::peaks_between_crossings(samples, mean)) values.push_back(peak.value);
  ordered_json out{{"count", values.size()},
                   {"per_second", static_cast<double>(values.size()) / (static_cast<double>(samples.size()) * dt)}};
  if (values.size() >= 2) {
    const statistics::Moments m = statistics::moments(values);
    out["mean"] = m.mean;
    out["standard_deviation"] = std::sqrt(m.variance);
    out["maximum"] = m.maximum;
  }
  return out;
}

/// Level of a return period from peaks over the 90 % quantile, declustered by twice the autocorrelation time.
ordered_json extreme_level(const Samples& samples, double dt, double tau, double return_period) {
  const std::array<double, 1> level{0.9};
  const double threshold = statistics::quantiles(samples, level)[0];
  const auto separation = static_cast<std::size_t>(std::max(1.0, std::ceil(2.0 * tau / dt)));
  Samples peaks;
  for (const statistics::Peak& peak : statistics::peaks_above(samples, threshold, separation))
    peaks.push_back(peak.value);
  ordered_json out{{"threshold", threshold}, {"peaks", peaks.size()}, {"return_period", return_period}};
  const double duration = static_cast<double>(samples.size()) * dt;
  const auto fit = statistics::fit_generalised_pareto(peaks, threshold);
  if (!fit) {
    out["not_fitted"] = fit.error().reason;
  } else if (static_cast<double>(peaks.size()) * return_period <= duration) {
    out["not_fitted"] = "the return period is shorter than the time between peaks";
  } else {
    const statistics::Estimate estimate = statistics::return_level(*fit, duration, return_period);
    out["scale"] = fit->scale;
    out["shape"] = fit->shape;
    out["level"] = estimate.value;
    out["level_95"] = interval(estimate.interval);
  }
  return out;
}

/// Where the spectrum is highest; segments an eighth of the history, so that about 15 are averaged.
ordered_json spectral_peak(const Samples& samples, double dt) {
  const std::size_t segment = samples.size() / 8;
  if (segment < 16) return nullptr;
  const statistics::Spectrum spectrum = statistics::welch_spectrum(samples, dt, segment);
  const auto highest = std::max_element(spectrum.density.begin() + 1, spectrum.density.end());
  const auto line = static_cast<std::size_t>(highest - spectrum.density.begin());
  return {{"frequency", spectrum.frequency[line]}, {"resolution", spectrum.frequency[1]}, {"density", *highest}};
}

}  // namespace

ordered_json statistics_of(const LoadHistory& history, double return_period) {
  const Samples& samples = history.samples;
  const statistics::Summary s = statistics::summarise(samples, history.dt);
  ordered_json out{{"column", history.column},
                   {"from", history.start},
                   {"dt", history.dt},
                   {"n", s.n},
                   {"duration", static_cast<double>(s.n) * history.dt},
                   {"mean", s.mean},
                   {"mean_95", interval(s.mean_95)},
                   {"standard_deviation", s.standard_deviation},
                   {"minimum", s.minimum},
                   {"maximum", s.maximum},
                   {"skewness", s.skewness},
                   {"excess_kurtosis", statistics::moments(samples).excess_kurtosis},
                   {"quantile_50", s.quantile_50},
                   {"quantile_95", s.quantile_95},
                   {"quantile_99", s.quantile_99},
                   {"autocorrelation_time", s.autocorrelation_time},
                   {"effective_sample_size", s.effective_sample_size},
                   {"long_enough", s.long_enough}};
  out["peaks"] = crossing_peaks(samples, s.mean, history.dt);
  out["extremes"] = extreme_level(samples, history.dt, s.autocorrelation_time, return_period);
  out["spectrum_peak"] = spectral_peak(samples, history.dt);
  return out;
}

std::string statistics_text(const ordered_json& s) {
  const auto value = [&](const char* key) { return s[key].get<double>(); };
  std::string text =
      fmt::format("{}: {} samples every {:.6g} s, {:.6g} s from t = {:.6g} s\n", s["column"].get<std::string>(),
                  s["n"].get<std::size_t>(), value("dt"), value("duration"), value("from"));
  text += fmt::format("  mean                 {:.6g}   95 % interval [{:.6g}, {:.6g}]\n", value("mean"),
                      s["mean_95"][0].get<double>(), s["mean_95"][1].get<double>());
  text += fmt::format("  standard deviation   {:.6g}\n", value("standard_deviation"));
  text += fmt::format("  minimum, maximum     {:.6g}   {:.6g}\n", value("minimum"), value("maximum"));
  text += fmt::format("  50, 95, 99 %         {:.6g}   {:.6g}   {:.6g}\n", value("quantile_50"), value("quantile_95"),
                      value("quantile_99"));
  text += fmt::format("  skewness, kurtosis   {:.4g}   {:.4g} (excess)\n", value("skewness"), value("excess_kurtosis"));
  text += fmt::format("  autocorrelation time {:.4g} s, {:.4g} independent samples\n", value("autocorrelation_time"),
                      value("effective_sample_size"));
  const ordered_json& peaks = s["peaks"];
  text += fmt::format("  peaks above the mean {} ({:.4g} a second)", peaks["count"].get<std::size_t>(),
                      peaks["per_second"].get<double>());
  if (peaks.contains("mean")) {
    text += fmt::format(", mean {:.6g}, deviation {:.6g}", peaks["mean"].get<double>(),
                        peaks["standard_deviation"].get<double>());
  }
  text += '\n';
  if (const ordered_json& line = s["spectrum_peak"]; !line.is_null()) {
    text += fmt::format("  highest spectrum at  {:.4g} Hz (lines every {:.4g} Hz)\n", line["frequency"].get<double>(),
                        line["resolution"].get<double>());
  }
  const ordered_json& extremes = s["extremes"];
  text += fmt::format("  once in {:.6g} s       ", extremes["return_period"].get<double>());
  if (extremes.contains("level")) {
    text += fmt::format("{:.6g}   95 % interval [{:.6g}, {:.6g}], from {} peaks above {:.6g}\n",
                        extremes["level"].get<double>(), extremes["level_95"][0].get<double>(),
                        extremes["level_95"][1].get<double>(), extremes["peaks"].get<std::size_t>(),
                        extremes["threshold"].get<double>());
  } else {
    text += fmt::format("unknown: {}\n", extremes["not_fitted"].get<std::string>());
  }
  if (!s["long_enough"].get<bool>()) {
    text += "  note: shorter than 50 autocorrelation times; the intervals are themselves uncertain\n";
  }
  return text;
}

void add_stats_command(CLI::App& app) {
  struct Options {
    std::string file;
    HistoryChoice choice;
    double return_period = 3600.0;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("stats", "Statistics of a load history, simulated or measured");
  command->add_option("file", options->file, "CSV file with a column of times, or the run.nc of a run")->required();
  command->add_option("--column", options->choice.column, "which column [the first that is not the time]");
  CLI::Option* from = command->add_option("--from", options->choice.from, "leave out what is earlier [s]");
  command->add_option("--dt", options->choice.dt, "time step of a file without times [s]")->check(CLI::PositiveNumber);
  command->add_option("--return-period", options->return_period, "of the extreme level [s]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_flag("--json", options->json, "as JSON");
  command->footer("Example: brash stats results/cone/history.csv --column Fx --from 8");
  command->callback([options, from] {
    options->choice.has_from = from->count() > 0;
    const ordered_json out = statistics_of(read_history(options->file, options->choice), options->return_period);
    fmt::print("{}", options->json ? out.dump(2) + '\n' : statistics_text(out));
  });
}

}  // namespace brash::cli
