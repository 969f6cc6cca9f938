// SPDX-License-Identifier: GPL-3.0-or-later
#include "collect.hpp"

#include <fmt/format.h>
#include <gnu/libc-version.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "brash/core/input_file.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/version.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/origin.hpp"
#include "brash/io/results.hpp"
#include "brash/io/table.hpp"
#include "brash/statistics/intervals.hpp"
#include "brash/statistics/moments.hpp"
#include "case_results.hpp"

namespace brash::campaign {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// One case with its numbers, in the order of the plan's columns.
struct Row {
  CaseKey key;
  bool failed = false;
  std::vector<double> values;
  std::vector<model::Warning> warnings;
  model::Origin origin{};    ///< of a case that is done
  bool is_repeated = false;  ///< an earlier replicate has the same numbers to the last digit
};

std::vector<Row> read_rows(const io::CampaignPlan& plan, const Folder& folder, const Schedule& schedule) {
  std::vector<Row> rows;
  std::set<std::pair<std::size_t, std::string>> seen;  // settings and their numbers
  for (const auto& [key, state] : schedule.cases()) {
    if (state == CaseState::kMissing) continue;
    Row row{key, state == CaseState::kFailed, std::vector<double>(plan.columns.size(), kMissing), {}};
    if (!row.failed) {
      const std::string path = folder.case_folder(key) + "/summary.json";
      const std::string text = read_text(path);
      const auto numbers = columns_of(path, text);
      row.warnings = warnings_in(text);
      row.is_repeated = !seen.emplace(key.setting, fingerprint(numbers)).second;
      if (row.is_repeated) row.warnings.push_back({io::kRepeated, ""});
      row.origin = io::origin_in(folder.case_folder(key) + "/manifest.json");
      for (std::size_t i = 0; i < plan.columns.size(); ++i)
        if (const auto found = numbers.find(plan.columns[i]); found != numbers.end()) row.values[i] = found->second;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Whether a spreadsheet takes a text for a formula. Numbers, also several, are none.
bool is_formula(const std::string& text) {
  if (text.empty() || std::string_view("=+-@\t\r").find(text.front()) == std::string_view::npos) return false;
  return text.find_first_not_of("0123456789+-.eE; ") != std::string::npos;
}

/// A cell of a CSV file: quoted where it has to be. One that a spreadsheet would compute begins with an apostrophe.
std::string cell(const std::string& text) {
  const bool formula = is_formula(text);
  if (!formula && text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = formula ? "\"'" : "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

/// The presets and the programs of all cases that are done.
model::Origin origin_of(const std::vector<Row>& rows) {
  model::Origin origin;
  for (const Row& row : rows) model::add(origin, row.origin);
  return origin;
}

/// The one name of a run; "" where there is none, as of a case that failed.
std::string one_of(const std::vector<std::string>& names) { return names.empty() ? "" : names.front(); }

std::string csv(const io::CampaignPlan& plan, const Folder& folder, const std::vector<Row>& rows) {
  std::string text = "case,setting,replicate,status";
  for (const io::VariedKey& key : plan.keys) text += ',' + cell(key.name);
  for (const std::string& column : plan.columns) text += ',' + cell(column);
  text += ",warnings,preset,program\n";
  for (const Row& row : rows) {
    const io::Setting& setting = plan.settings[row.key.setting];
    text += fmt::format("{},{},{},{}", cell(folder.id(row.key)), cell(setting.name), row.key.replicate,
                        row.failed ? "failed" : "done");
    for (const io::SettingValue& value : setting.values) text += ',' + cell(value.text);
    for (const double value : row.values) text += std::isnan(value) ? "," : fmt::format(",{}", value);
    std::vector<std::string> ids;
    for (const model::Warning& warning : row.warnings) ids.push_back(warning.id);
    text += fmt::format(",{},{},{}\n", fmt::join(ids, " "), cell(one_of(row.origin.presets)),
                        cell(one_of(row.origin.programs)));
  }
  return text;
}

/// A column of names as numbers with flags; -1 where a case has none. Blanks separate the flags, so they have none.
io::TableIndex names_of(const std::vector<Row>& rows, const char* name, const char* meaning,
                        std::vector<std::string> model::Origin::*part) {
  io::TableIndex index{name, meaning, {}, {}};
  for (const Row& row : rows) {
    std::string flag = one_of(row.origin.*part);
    std::ranges::replace(flag, ' ', '_');
    auto found = std::ranges::find(index.flags, flag);
    if (found == index.flags.end() && !flag.empty()) found = index.flags.insert(found, flag);
    index.values.push_back(flag.empty() ? -1 : static_cast<std::int32_t>(found - index.flags.begin()));
  }
  return index;
}

io::Table table(const io::CampaignPlan& plan, const std::vector<Row>& rows) {
  io::Table all{.dimension = "case",
                .attributes = {{"Conventions", "CF-1.9"},
                               {"title", "brash campaign"},
                               {"source", fmt::format("{}", fmt::join(origin_of(rows).programs, ", "))},
                               {"comment", "One entry a case; loads in load axes, SI units."}},
                .indices = {{"setting", "setting", {}, {}},
                            {"replicate", "replicate", {}, {}},
                            {"status", "how the case ended", {}, {"done", "failed"}}},
                .columns = {}};
  for (const io::Setting& setting : plan.settings) all.indices[0].flags.push_back(setting.name);
  for (const Row& row : rows) {
    all.indices[0].values.push_back(static_cast<std::int32_t>(row.key.setting));
    all.indices[1].values.push_back(row.key.replicate);
    all.indices[2].values.push_back(row.failed ? 1 : 0);
  }
  all.indices.push_back(names_of(rows, "preset", "preset of the case", &model::Origin::presets));
  all.indices.push_back(names_of(rows, "program", "program that made the case", &model::Origin::programs));
  for (std::size_t k = 0; k < plan.keys.size(); ++k) {
    const auto is_number = [&](const io::Setting& setting) { return setting.values[k].number.has_value(); };
    if (std::ranges::none_of(plan.settings, is_number)) continue;
    io::TableColumn column{plan.keys[k].name, plan.keys[k].unit, "varied by the grid", {}};
    for (const Row& row : rows)
      column.values.push_back(plan.settings[row.key.setting].values[k].number.value_or(kMissing));
    all.columns.push_back(std::move(column));
  }
  for (std::size_t c = 0; c < plan.columns.size(); ++c) {
    io::TableColumn column{plan.columns[c], unit_of(plan.columns[c]), "of the summary of each run", {}};
    for (const Row& row : rows) column.values.push_back(row.values[c]);
    all.columns.push_back(std::move(column));
  }
  return all;
}

/// Mean of one column over the replicates of a setting. Its interval ends where no value is possible.
Json statistic(const std::string& column, const std::vector<double>& values) {
  Json out{{"n", values.size()},
           {"mean", nullptr},
           {"standard_deviation", nullptr},
           {"mean_95", nullptr},
           {"unit", unit_of(column)}};
  if (values.size() == 1) out["mean"] = values.front();
  if (values.size() < 2) return out;
  const statistics::Moments moments = statistics::moments(values);
  const statistics::Interval interval = statistics::mean_interval(values);
  out["mean"] = moments.mean;
  out["standard_deviation"] = std::sqrt(moments.variance);
  const auto [least, most] = possible_values(column);
  out["mean_95"] = {std::max(interval.lower, least), std::min(interval.upper, most)};
  return out;
}

/// Why a setting has no more replicates.
const char* stopped_by(const io::CampaignPlan& plan, std::size_t setting, const Schedule& schedule) {
  if (schedule.is_missing_cases(setting)) return "missing";
  if (!plan.stop) return "replicates";
  if (!schedule.has_statistic(setting)) return "no_statistic";
  return schedule.is_narrow_enough(setting) ? "half_width" : "most_replicates";
}

Json setting_summary(const io::CampaignPlan& plan, std::size_t setting, const std::vector<Row>& rows,
                     const Schedule& schedule) {
  const io::Setting& s = plan.settings[setting];
  Json out{{"setting", s.name}, {"case", s.resolved.name}, {"values", Json::object()}};
  for (std::size_t k = 0; k < plan.keys.size(); ++k) {
    const io::SettingValue& value = s.values[k];
    out["values"][plan.keys[k].name] = value.number ? Json(*value.number) : Json(value.text);
  }
  std::vector<std::vector<double>> by_column(plan.columns.size());
  int n_failed = 0;
  int n_done = 0;
  std::map<std::string, int> warnings;
  for (const Row& row : rows) {
    if (row.key.setting != setting) continue;
    ++(row.failed ? n_failed : n_done);
    for (const model::Warning& warning : row.warnings) ++warnings[warning.id];
    if (row.is_repeated) continue;  // it says nothing new about the mean
    for (std::size_t c = 0; c < plan.columns.size(); ++c)
      if (std::isfinite(row.values[c])) by_column[c].push_back(row.values[c]);
  }
  out["n_done"] = n_done;
  out["n_failed"] = n_failed;
  out["warnings"] = warnings;
  out["stopped_by"] = stopped_by(plan, setting, schedule);
  out["statistics"] = Json::object();
  for (std::size_t c = 0; c < plan.columns.size(); ++c)
    out["statistics"][plan.columns[c]] = statistic(plan.columns[c], by_column[c]);
  return out;
}

/// The words of each warning, of the first case that has it.
Json warning_texts(const Folder& folder, const std::vector<Row>& rows) {
  Json texts = Json::object();
  for (const Row& row : rows)
    for (const auto& [id, text] : row.warnings)
      if (!text.empty() && !texts.contains(id)) texts[id] = {{"case", folder.id(row.key)}, {"text", text}};
  return texts;
}

std::string summary(const io::CampaignPlan& plan, const Folder& folder, const std::vector<Row>& rows,
                    const Schedule& schedule) {
  const Counts counts = schedule.counts();
  Json out{{"format", "brash-campaign-1"},
           {"units", "SI"},
           {"origin", origin_of(rows)},
           {"n_cases", counts.n_cases},
           {"n_done", counts.n_done},
           {"n_failed", counts.n_failed},
           {"warnings", warning_texts(folder, rows)},
           {"settings", Json::array()}};
  for (std::size_t s = 0; s < plan.settings.size(); ++s)
    out["settings"].push_back(setting_summary(plan, s, rows, schedule));
  return out.dump(2) + "\n";
}

/// The files that a case read besides its setting: its copy, or the name of a model that comes with the program.
Json files_read(const Json& manifest) {
  Json files = Json::array();
  const Json inputs = manifest.is_object() ? manifest.value("inputs", Json()) : Json();
  for (std::size_t i = 1; inputs.is_array() && i < inputs.size(); ++i) {
    const Json& input = inputs[i];
    if (!input.is_object() || !input.value("path", Json()).is_string()) continue;
    const std::string name = std::filesystem::path(input["path"].get<std::string>()).filename().string();
    files.push_back({{"name", input.value("copy", Json(name))}, {"sha256", input.value("sha256", Json())}});
  }
  return files;
}

/// The origin of the cases: each combination of program and files, and how many cases it made.
Json makers(const Folder& folder, const std::vector<Row>& rows) {
  Json all = Json::array();
  for (const Row& row : rows) {
    if (row.failed) continue;
    const std::string path = folder.case_folder(row.key) + "/manifest.json";
    const std::string text = read_text(path);
    refuse_deep_json(text, path, "the manifest of a run");
    const Json manifest = Json::parse(text, nullptr, /*allow_exceptions=*/false);
    const Json program = manifest.is_object() ? manifest.value("program", Json()) : Json();
    Json maker{{"program", program}, {"inputs", files_read(manifest)}, {"n_cases", 1}};
    const auto same = std::find_if(all.begin(), all.end(), [&](const Json& other) {
      return other["program"] == maker["program"] && other["inputs"] == maker["inputs"];
    });
    if (same == all.end())
      all.push_back(std::move(maker));
    else
      (*same)["n_cases"] = (*same)["n_cases"].get<int>() + 1;
  }
  return all;
}

void write_campaign_manifest(const Folder& folder, const Campaign& campaign, const std::vector<Row>& rows) {
  // Hashed as they were read; the folder has the copies.
  Json inputs = Json::array();
  for (const CopiedFile& file : folder.copied_files())
    inputs.push_back({{"path", file.path}, {"sha256", file.sha256}, {"copy", file.copy}});
  const io::CampaignPlan& plan = campaign.plan;
  const Json options{{"set", plan.overrides},
                     {"quick", plan.quick},
                     {"replicates", plan.replicates_in_place ? Json(*plan.replicates_in_place) : Json()}};
  Json manifest{{"format", kManifestFormat},
                {"program", {{"name", "brash"}, {"version", kVersion}}},
                {"glibc", gnu_get_libc_version()},
                {"plan", {{"path", campaign.plan_file}, {"sha256", sha256(campaign.plan.sources.front().text)}}},
                {"options", options},
                {"inputs", std::move(inputs)},
                {"cases_made_by", makers(folder, rows)},
                {"outputs", Json::array()}};
  for (const ToolVersion& tool : kBuiltWith) manifest["built_with"][tool.name] = tool.version;
  for (const char* const name : {"campaign.csv", "campaign.nc", "summary.json"})
    manifest["outputs"].push_back({{"path", name}, {"sha256", sha256_of_file(folder.directory() + "/" + name)}});
  write_file(folder.directory() + "/manifest.json",
             manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace

void collect(const Campaign& campaign, const Folder& folder, const Schedule& schedule) {
  const io::CampaignPlan& plan = campaign.plan;
  const std::vector<Row> rows = read_rows(plan, folder, schedule);
  write_file(campaign.directory + "/campaign.csv", csv(plan, folder, rows));
  io::write_table(campaign.directory + "/campaign.nc", table(plan, rows));
  write_file(campaign.directory + "/summary.json", summary(plan, folder, rows, schedule));
  write_campaign_manifest(folder, campaign, rows);
  write_crate(campaign.directory);
}

}  // namespace brash::campaign
