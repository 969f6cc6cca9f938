// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "brash/analysis/summary_tables.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/core/input_file.hpp"
#include "brash/io/campaign_plan.hpp"

namespace brash::analysis {
namespace {

/// How many cases of a setting are done without a mean load, and why; nothing where all have one.
std::string without_mean(const std::string& name, const nlohmann::ordered_json& setting) {
  const auto& statistics = setting.at("statistics");
  const int n_done = setting.at("n_done").get<int>();
  for (const char* const column : {"horizontal.mean", "vertical.mean"}) {
    if (!statistics.contains(column)) continue;
    const int n_with = statistics.at(column).at("n").get<int>(), n_counted = n_done - n_repeated(setting);
    if (n_with == n_counted) return "";
    const int n = n_with == 0 ? n_done : n_counted - n_with;
    return fmt::format("{:<36} {:>4}  of {} cases without a mean: over before output.statistics_from\n", name, n,
                       n_done);
  }
  return "";
}

/// The columns of the table: all of a plan that chose a few, else the two that people look at first.
std::vector<std::string> shown_columns(const nlohmann::ordered_json& statistics) {
  constexpr std::size_t kFew = 6;
  std::vector<std::string> columns{"horizontal.mean", "vertical.mean"};
  if (statistics.size() > kFew) return columns;
  columns.clear();
  for (const auto& item : statistics.items()) columns.push_back(item.key());
  return columns;
}

/// The unit in which a column is shown: newtons and joules by the size of the largest mean, others as they are.
std::map<std::string, TableUnit> units_of(const nlohmann::ordered_json& settings) {
  std::map<std::string, std::vector<double>> means;  // by unit
  for (const auto& setting : settings)
    for (const auto& [column, statistic] : setting.at("statistics").items())
      if (statistic.at("mean").is_number())
        means[statistic.value("unit", "1")].push_back(statistic.at("mean").get<double>());
  std::map<std::string, TableUnit> units;
  for (const auto& [unit, values] : means)
    units[unit] = unit == "N" || unit == "J" ? unit_for(values, unit.c_str()) : TableUnit{1.0, unit == "1" ? "" : unit};
  return units;
}

/// "120.4 kN  [101.3, 139.5]". Where a number cannot be negative, neither can an end of its interval.
std::string mean_text(const nlohmann::ordered_json& statistic, const std::string& column, const TableUnit& unit) {
  const auto number = [&](double value) {
    return unit.one != 1.0 ? fmt::format("{:.1f}", value / unit.one) : fmt::format("{:.6g}", value);
  };
  std::string text = fmt::format("{:>12} {}", number(statistic.at("mean").get<double>()), unit.name);
  const auto& interval = statistic.at("mean_95");
  if (interval.is_null()) return text;
  const bool is_positive = column.find("deviation") != std::string::npos || column.starts_with("n_");
  const double lower = interval[0].get<double>();
  return text + fmt::format("{:{}}[{}, {}]", "", 6 - std::min<std::size_t>(5, unit.name.size()),
                            number(is_positive ? std::max(0.0, lower) : lower), number(interval[1].get<double>()));
}

/// The warnings of all cases, each once.
std::string warnings_text(const nlohmann::ordered_json& settings) {
  std::map<std::string, std::pair<int, int>> found;  // cases and settings
  for (const auto& setting : settings) {
    const auto warnings = setting.value("warnings", nlohmann::ordered_json::object());
    for (const auto& [id, n] : warnings.items()) {
      found[id].first += n.get<int>();
      ++found[id].second;
    }
  }
  std::string text;
  for (const auto& [id, n] : found)
    text += fmt::format("warning: {}: {} cases of {} settings\n", id, n.first, n.second);
  return text;
}

}  // namespace

int n_repeated(const nlohmann::ordered_json& setting) {
  return setting.value("warnings", nlohmann::ordered_json::object()).value(io::kRepeated, 0);
}

std::string means_table(const std::string& summary_file) {
  const auto summary = nlohmann::ordered_json::parse(read_json_text(summary_file, "the summary of a campaign"));
  const auto& settings = summary.at("settings");
  const auto units = units_of(settings);
  std::string text = origin_text(summary) + fmt::format("{:<36} {:>4}  {}\n", "setting", "n", "mean and 95 % interval");
  for (const auto& setting : settings) {
    const std::string name = setting.at("setting");
    std::string shown = name;
    for (const std::string& column : shown_columns(setting.at("statistics"))) {
      if (!setting.at("statistics").contains(column)) continue;
      const auto& statistic = setting.at("statistics").at(column);
      if (statistic.at("mean").is_null()) continue;
      text += fmt::format("{:<36} {:>4}  {:<30} {}\n", shown, statistic.at("n").get<int>(), column,
                          mean_text(statistic, column, units.at(statistic.value("unit", "1"))));
      shown.clear();
    }
    text += without_mean(shown, setting);
  }
  return text + warnings_text(settings);
}

}  // namespace brash::analysis
