// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_source.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/simulation/initial_floes.hpp"
#include "brash/statistics/moments.hpp"
#include "closed_forms.hpp"
#include "history_statistics.hpp"
#include "run_summary.hpp"

namespace brash::cli {
namespace {

using nlohmann::ordered_json;

ordered_json statistics_and_events(const LoadHistory& load) {
  ordered_json out = statistics_of(load);
  out["events"] = ordered_json::array();
  for (const statistics::LoadEvent& e : events_of(load))
    out["events"].push_back(
        {{"start", e.start}, {"end", e.end}, {"peak_time", e.peak_time}, {"peak", e.peak}, {"impulse", e.impulse}});
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
ordered_json of_lower_end(const LoadHistory& load) {
  ordered_json out = statistics_and_events(negated(load));
  out["column"] = load.column;
  std::swap(out["minimum"], out["maximum"]);
  turn(out, {"mean", "mean_95", "minimum", "maximum", "skewness", "quantile_50", "quantile_95", "quantile_99"});
  turn(out["peaks"], {"level", "mean", "maximum"});
  turn(out["extremes"], {"threshold", "level", "level_95"});
  turn(out["block_maxima"], {"location", "level", "level_95"});
  for (ordered_json& law : out["laws"]) turn(law, {"location", "level", "level_95"});
  turn(out["recommended"], {"level", "level_95"});
  for (ordered_json& event : out["events"]) turn(event, {"peak", "impulse"});
  return out;
}

ordered_json with_events(const LoadHistory& load) {
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
  HistoryChoice choice;
  choice.from = summary[from].get<double>();
  choice.to = end_in(path);
  choice.has_from = choice.after = true;
  const std::vector<std::string> names{"Fx", "Fy", "Fz", "Mx", "My", "Mz"};
  const bool has_interval = summary.contains(lower) && summary[lower].is_number();
  ordered_json loads;
  for (const LoadHistory& load : read_histories(directory + "/run.nc", choice, names)) {
    loads[load.column] = with_events(load);
    if (!has_interval) loads[load.column]["mean_95"] = {nullptr, nullptr};  // the run is too short for it
  }
  return loads;
}

}  // namespace

report::RunSource report_source(const std::string& directory) {
  const model::Case resolved = report::case_of_run(directory);
  return {.directory = directory,
          .closed_forms = closed_form_loads(resolved).dump(),
          .loads = [directory] { return loads_of_run(directory).dump(); },
          .land = simulation::land_outlines(resolved)};
}

report::MeasuredHistory measured_history(const std::string& file, const HistoryChoice& choice) {
  LoadHistory load = read_history(history_file(file), choice);
  if (!load.unit.empty() && load.unit != "N")
    throw InputError(Complaint{file,
                               fmt::format("column '{}' is in '{}'", printable(load.column), printable(load.unit)),
                               "a force, to be drawn over the horizontal load",
                               "correct the unit in the file, or name another column with --measured-column"});
  return {.name = std::filesystem::path(file).filename().string() + ": " + load.column,
          .times = load.history.times,
          .values = load.history.values,
          .statistics = with_events(load).dump()};
}

}  // namespace brash::cli
