// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "brash/analysis/summary_tables.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/io/campaign_plan.hpp"
#include "brash/statistics/intervals.hpp"

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

/// "120.4 kN  [101.3, 139.5]": two digits of the half width.
std::string mean_text(const nlohmann::ordered_json& statistic, const TableUnit& unit) {
  const double mean = statistic.at("mean").get<double>() / unit.one;
  const auto& interval = statistic.at("mean_95");
  if (interval.is_null()) return fmt::format("{:>12.6g}{}{}", mean, unit.name.empty() ? "" : " ", unit.name);
  const double lower = interval[0].get<double>() / unit.one, upper = interval[1].get<double>() / unit.one;
  const double half_width = std::max(upper - mean, mean - lower);
  const int digits = half_width > 0.0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(half_width))), 0, 9) : 0;
  return fmt::format("{:>12.{}f} {:<6} [{:.{}f}, {:.{}f}]", mean, digits, unit.name, lower, digits, upper, digits);
}

std::string counted(int n, const char* one, const char* several) {
  return fmt::format("{} {}", n, n == 1 ? one : several);
}

/// The warnings of all cases, each once.
std::string warnings_text(const nlohmann::ordered_json& summary, const std::set<std::string>& told) {
  std::map<std::string, std::pair<int, int>> found;  // cases and settings
  for (const auto& setting : summary.at("settings")) {
    const auto warnings = setting.value("warnings", nlohmann::ordered_json::object());
    for (const auto& [id, n] : warnings.items()) {
      found[id].first += n.get<int>();
      ++found[id].second;
    }
  }
  const auto texts = summary.value("warnings", nlohmann::ordered_json::object());
  std::string text;
  for (const auto& [id, n] : found) {
    text += fmt::format("warning: {}: {} of {}", printable(id), counted(n.first, "case", "cases"),
                        counted(n.second, "setting", "settings"));
    if (texts.contains(id) && !told.contains(id))
      text += fmt::format(", such as {}: {}", printable(texts[id].at("case").get<std::string>()),
                          escaped(texts[id].at("text").get<std::string>()));
    text += '\n';
  }
  return text;
}

/// How many replicates halve the intervals, or give any: the largest number that a setting needs.
std::string replicates_text(const nlohmann::ordered_json& settings, const std::string& command) {
  std::size_t most = 0, needed = 0;
  bool is_single = false;
  for (const auto& setting : settings)
    for (const auto& statistic : setting.at("statistics")) {
      const auto n = statistic.at("n").get<std::size_t>();
      is_single = is_single || n == 1;
      if (n < 2 || n <= most) continue;
      most = n;
      needed = statistics::values_for_half_interval(n);
    }
  if (needed > 0)
    return fmt::format("{} replicates instead of {} about halve the intervals: `{} --resume --replicates {}`\n", needed,
                       most, command, needed);
  if (!is_single) return "";
  return fmt::format("one replicate has no interval: `{} --resume --replicates 3`\n", command);
}

}  // namespace

int n_repeated(const nlohmann::ordered_json& setting) {
  return setting.value("warnings", nlohmann::ordered_json::object()).value(io::kRepeated, 0);
}

std::string means_table(const std::string& summary_file, const std::string& command,
                        const std::set<std::string>& told) {
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
                          mean_text(statistic, units.at(statistic.value("unit", "1"))));
      shown.clear();
    }
    text += without_mean(shown, setting);
  }
  return text + replicates_text(settings, command) + warnings_text(summary, told);
}

}  // namespace brash::analysis
