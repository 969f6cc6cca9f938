// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "brash/analysis/load_history.hpp"
#include "brash/core/vec.hpp"
#include "brash/model/case.hpp"
#include "brash/recording/run_folder.hpp"

namespace brash::report {

/// Whether this build carries the page; without Node.js it does not, and no report can be written.
bool has_page();

/// The resolved case of the run in `directory`, from its manifest.
/// @throws InputError when there is no manifest or it holds no case.
model::Case case_of_run(const std::string& directory);

/// A measured history that is drawn over a run's loads.
struct MeasuredHistory {
  std::string name;            ///< file and column, as the reader knows them
  std::vector<double> times;   ///< [s], rising; shape=(n,)
  std::vector<double> values;  ///< [N], as Fx of a run; shape=(n,)
  std::string statistics;      ///< JSON, as of one load of RunSource::loads
};

/// A run's folder, and what its page shows besides the run's own files.
struct RunSource {
  std::string directory;
  std::string closed_forms;  ///< of the run's case, as JSON (`brash loads --json`)
  /// Makes a JSON object: for each load (Fx ... Mz) its statistics with the keys of `brash stats --json`, and its load
  /// `events` and `spectrum`; null where the run is over before its statistics begin. A load that acts towards its
  /// lower end has `lower_end` true: high quantiles, peaks and extremes are taken there. It is called once the run's
  /// files are known to be whole.
  std::function<std::string()> loads;
  /// Outlines of the land, each with its holes, sheet frame [m]; empty: none.
  std::vector<std::vector<std::vector<Vec2>>> land{};
  std::optional<MeasuredHistory> measured{};
};

/// Writes report.html into the run's folder, from its run.nc, summary.json and manifest.json: one file that needs no
/// network.
///
/// @return the path of the report.
/// @throws InputError naming the file that is missing or unreadable.
/// @throws RunError without a page, or when the report cannot be written.
std::string write_run_report(const RunSource& run);

/// Writes the page of a run with another beside it, under one slider, as `path`. Errors as of write_run_report().
void write_comparison(const RunSource& run, const RunSource& other, const std::string& path);

/// Writes report.html of the campaign in `directory`, from its summary.json, campaign.csv and manifest.json.
std::string write_campaign_report(const std::string& directory);

/// The run in `directory` with all that its page shows: closed forms, statistics of each load, load events.
/// @throws InputError naming a file that is missing or unreadable.
RunSource report_source(const std::string& directory);

/// The column of `file` that `choice` names, to be drawn over the horizontal load of a run.
/// @throws InputError as analysis::read_history(), and when the column is in a unit that is not of a force.
MeasuredHistory measured_history(const std::string& file, const analysis::HistoryChoice& choice);

/// Refuses a folder that is not of a run or a campaign.
/// @throws InputError when `directory` has no manifest.json.
void expect_manifest(const std::string& directory);

/// Writes report.html of the run in `directory`, or of the campaign and of every run that it kept whole.
/// @return its path. @throws InputError naming a file that is missing. @throws RunError in a build without the page.
std::string write_report(const std::string& directory);

/// Writes everything that a finished run leaves: its plan, results, summary, manifest and, in a build with the page,
/// the report. @throws StorageError naming the file that cannot be written.
void write_results(const recording::NewResults& results, const recording::Inputs& inputs, const simulation::Run& run);

}  // namespace brash::report
