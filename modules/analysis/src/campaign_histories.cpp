// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/campaign_histories.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "brash/analysis/tables.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/io/campaign_plan.hpp"
#include "brash/io/case.hpp"
#include "brash/io/result_columns.hpp"
#include "brash/io/run_summary.hpp"

namespace brash::analysis {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* kSummary = "the summary.json of a campaign that is done";
constexpr const char* kRunSummary = "the summary.json of a run, with a number `statistics_from`";
constexpr const char* kTable = "the campaign.csv of a campaign that is done";
constexpr const char* kResume = "run the campaign with `--resume`, which writes it again";

ordered_json read_settings(const std::string& folder) {
  const std::string path = folder + "/summary.json";
  const auto json = ordered_json::parse(read_json_text(path, kSummary), nullptr, /*allow_exceptions=*/false);
  const auto is_setting = [](const ordered_json& s) {
    return s.is_object() && s.contains("setting") && s["setting"].is_string() && s.contains("values") &&
           s["values"].is_object();
  };
  if (!json.is_object() || !json.contains("settings") || !json["settings"].is_array() || json["settings"].empty() ||
      !std::ranges::all_of(json["settings"], is_setting))
    throw InputError(Complaint{path, "is not a summary of a campaign", kSummary, kResume});
  return json["settings"];
}

/// The unit of a column of a run's history, whose CSV names none; "" for other columns.
std::string unit_of_column(const std::string& column) {
  std::string found;
  io::Columns<model::LoadRow>::visit([&](const std::string& name, const char* unit, const auto&...) {
    if (name == column) found = unit;
  });
  return found;
}

LoadHistory replicate(const fs::path& run, HistoryChoice choice) {
  begin_as_summary(choice, (run / "summary.json").string());
  for (const char* name : {"history.csv", "run.nc"}) {
    if (!fs::exists(run / name)) continue;
    LoadHistory load = read_history((run / name).string(), choice);
    if (load.unit.empty()) load.unit = unit_of_column(load.column);
    return load;
  }
  throw InputError(Complaint{run.string(), "holds no history", "a history.csv or run.nc",
                             "run the campaign with output.keep = \"history\" in its plan"});
}

/// @param once  replicates that coincide count once.
std::map<std::string, std::vector<std::string>> done_cases_of(const std::string& folder, bool once) {
  const TextTable table = read_text_table((fs::path(folder) / "campaign.csv").string(), kTable, kResume);
  const std::size_t name = table.column("case"), setting = table.column("setting"), status = table.column("status");
  std::map<std::string, std::vector<std::string>> found;
  for (const TextTable::Row& row : table.rows)
    if (row[status] == "done" && !(once && is_repeated(table, row))) found[row[setting]].push_back(row[name]);
  return found;
}

}  // namespace

std::optional<model::Case> case_of_setting(const std::string& campaign, const std::string& setting) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(campaign + "/settings", ignored))
    if (entry.path().stem().string().ends_with("_" + setting)) return io::read_case(entry.path().string(), {});
  return std::nullopt;
}

void begin_as_summary(HistoryChoice& choice, const std::string& summary) {
  if (choice.has_from) return;
  const std::optional<double> start = io::start_in(summary);
  if (!start)
    throw InputError(
        Complaint{summary, "holds no number `statistics_from`", kRunSummary, "copy it again, or give --from"});
  choice.from = *start;
  if (!choice.to) choice.to = io::end_in(summary);
  choice.has_from = choice.after = true;
}

void begin_as_run(HistoryChoice& choice, const std::string& history) {
  if (choice.has_from) return;
  const std::optional<double> start = io::start_beside(history);
  if (!start) return;
  choice.from = *start;
  if (!choice.to) choice.to = io::end_beside(history);
  choice.has_from = choice.after = true;
}

std::map<std::string, std::vector<std::string>> done_cases(const std::string& folder) {
  return done_cases_of(folder, false);
}

std::map<std::string, std::vector<std::string>> counted_cases(const std::string& folder) {
  return done_cases_of(folder, true);
}

bool is_repeated(const TextTable& table, const TextTable::Row& row) {
  const auto column = static_cast<std::size_t>(std::ranges::find(table.names, "warnings") - table.names.begin());
  return column < row.size() && row[column].find(io::kRepeated) != std::string::npos;
}

std::vector<SettingHistories> read_campaign_histories(const std::string& folder, const HistoryChoice& choice,
                                                      const std::string& where) {
  if (!io::is_campaign(folder))
    throw InputError(Complaint{folder, "is not a campaign: it has no campaign.csv", "the folder of a campaign",
                               "give the folder that `brash campaign` wrote; `--resume` writes its table again"});
  std::vector<SettingHistories> settings;
  std::vector<std::string> names;
  std::map<std::string, std::vector<std::string>> done = counted_cases(folder);
  for (const ordered_json& given : read_settings(folder)) {
    SettingHistories setting{given["setting"].get<std::string>(), given["values"], {}, {}};
    names.push_back(setting.name);
    if (!where.empty() && fnmatch(where.c_str(), setting.name.c_str(), 0) != 0) continue;
    for (const std::string& name : done[setting.name])
      setting.replicates.push_back(replicate(fs::path(folder) / "cases" / name, choice));
    if (setting.replicates.empty())
      throw InputError(Complaint{folder, fmt::format("setting '{}' has no case that is done", printable(setting.name)),
                                 "one case of each setting at least", kResume});
    setting.resolved = case_of_setting(folder, setting.name);
    settings.push_back(std::move(setting));
  }
  if (settings.empty())
    throw InputError(Complaint{folder, fmt::format("no setting matches '{}'", printable(where)),
                               fmt::format("one of: {}", fmt::join(names, ", ")), "choose another --where"});
  return settings;
}

}  // namespace brash::analysis
