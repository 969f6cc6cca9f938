// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "brash/analysis/closed_forms.hpp"
#include "brash/analysis/history_statistics.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/io/run_summary.hpp"
#include "brash/report/pictures.hpp"
#include "brash/report/report.hpp"
#include "brash/simulation/initial_floes.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/spectrum.hpp"
#include "brash/statistics/summary.hpp"

namespace brash::report {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// The spectrum that `brash stats --spectrum` writes without a segment; null where the history is too short.
ordered_json spectrum_json(const analysis::LoadHistory& load) {
  const auto spectrum = analysis::spectrum_of(load, 0.0);
  if (!spectrum) return nullptr;
  const statistics::Interval factors = statistics::spectrum_factors(*spectrum);
  return {{"frequency", spectrum->frequency},
          {"density", spectrum->density},
          {"factors_95", {factors.lower, factors.upper}},
          {"n_segments", spectrum->n_segments}};
}

ordered_json statistics_and_events(const analysis::LoadHistory& load) {
  ordered_json out = analysis::statistics_of(load);
  out["events"] = ordered_json::array();
  for (const statistics::LoadEvent& e : analysis::events_of(load))
    out["events"].push_back(
        {{"start", e.start}, {"end", e.end}, {"peak_time", e.peak_time}, {"peak", e.peak}, {"impulse", e.impulse}});
  out["spectrum"] = spectrum_json(load);
  return out;
}

/// Numbers with the other sign, and intervals with the other order; nulls stay.
void turn(ordered_json& object, const std::vector<const char*>& keys) {
  const auto turned = [](const ordered_json& n) { return n.is_number() ? ordered_json(0.0 - n.get<double>()) : n; };
  for (const char* key : keys) {
    if (!object.contains(key)) continue;
    ordered_json& value = object[key];
    value = value.is_array() ? ordered_json{turned(value[1]), turned(value[0])} : turned(value);
  }
}

/// The statistics of a load that acts towards its lower end, whose peaks, high quantiles and extremes are there. They
/// are taken from the load with the other sign.
ordered_json of_lower_end(const analysis::LoadHistory& load) {
  ordered_json out = statistics_and_events(analysis::negated(load));
  out["column"] = load.column;
  std::swap(out["minimum"], out["maximum"]);
  statistics::Summary::visit([&](const statistics::Statistic& of, auto) {
    if (of.turns) turn(out, {of.name});
  });
  turn(out["peaks"], {"level", "mean", "maximum"});
  turn(out["extremes"], {"threshold", "level", "level_95"});
  turn(out["block_maxima"], {"location", "level", "level_95"});
  for (ordered_json& law : out["laws"]) turn(law, {"location", "level", "level_95"});
  turn(out["recommended"], {"level", "level_95"});
  for (ordered_json& event : out["events"]) turn(event, {"peak", "impulse"});
  return out;
}

ordered_json with_events(const analysis::LoadHistory& load) {
  const statistics::Moments m = statistics::moments(load.history.values, load.even.weights);
  const bool downwards = statistics::acts_downwards(m.mean, m.minimum, m.maximum);
  ordered_json out = downwards ? of_lower_end(load) : statistics_and_events(load);
  out["lower_end"] = downwards;
  return out;
}

/// Statistics of each load, from the start of the summary's statistics on; null where there are none.
ordered_json loads_of_run(const std::string& directory) {
  const std::string path = directory + "/summary.json";
  const auto summary = nlohmann::json::parse(read_json_text(path, "the summary of a run"), nullptr, false);
  const nlohmann::json::json_pointer from("/statistics_from"), mean("/horizontal/mean"), lower("/horizontal/mean_95/0");
  if (!summary.is_object() || !summary.contains(from) || !summary[from].is_number()) return nullptr;
  if (!summary.contains(mean) || !summary[mean].is_number()) return nullptr;
  analysis::HistoryChoice choice;
  choice.from = summary[from].get<double>();
  choice.to = io::end_in(path);
  choice.has_from = choice.after = true;
  const std::vector<std::string> names{"Fx", "Fy", "Fz", "Mx", "My", "Mz"};
  const bool has_interval = summary.contains(lower) && summary[lower].is_number();
  ordered_json loads;
  for (const analysis::LoadHistory& load : analysis::read_histories(directory + "/run.nc", choice, names)) {
    loads[load.column] = with_events(load);
    if (!has_interval) loads[load.column]["mean_95"] = {nullptr, nullptr};  // the run is too short for it
  }
  return loads;
}

}  // namespace

RunSource report_source(const std::string& directory) {
  const model::Case resolved = case_of_run(directory);
  return {.directory = directory,
          .closed_forms = analysis::closed_form_loads(resolved).dump(),
          .loads = [directory] { return loads_of_run(directory).dump(); },
          .land = simulation::land_outlines(resolved)};
}

MeasuredHistory measured_history(const std::string& file, const analysis::HistoryChoice& choice) {
  analysis::LoadHistory load = analysis::read_history(analysis::history_file(file), choice);
  if (!load.unit.empty() && load.unit != "N")
    throw InputError(Complaint{file,
                               fmt::format("column '{}' is in '{}'", printable(load.column), printable(load.unit)),
                               "a force, to be drawn over the horizontal load",
                               "correct the unit in the file, or name another column with --measured-column"});
  return {.name = fs::path(file).filename().string() + ": " + load.column,
          .times = load.history.times,
          .values = load.history.values,
          .statistics = with_events(load).dump()};
}

void expect_manifest(const std::string& directory) {
  if (!fs::exists(fs::path(directory) / "manifest.json"))
    throw InputError(Complaint{directory, fs::is_directory(directory) ? "holds no manifest.json" : "is not a folder",
                               "the folder of a run or a campaign",
                               "give the folder that `brash run` or `brash campaign` wrote"});
}

std::string write_report(const std::string& directory) {
  expect_manifest(directory);
  if (!io::is_campaign(directory)) return write_run_report(report_source(directory));
  std::error_code no_cases;
  for (const auto& entry : fs::directory_iterator(directory + "/cases", no_cases))
    if (!entry.is_symlink() && fs::exists(entry.path() / "run.nc"))
      write_run_report(report_source(entry.path().string()));
  return write_campaign_report(directory);
}

void write_results(const recording::NewResults& results, const recording::Inputs& inputs, const simulation::Run& run) {
  results.write(inputs, run,
                {{"plan.svg", plan_view(inputs.resolved, run.results, simulation::land_outlines(inputs.resolved))}});
  if (has_page()) write_report(results.directory());
}

}  // namespace brash::report
