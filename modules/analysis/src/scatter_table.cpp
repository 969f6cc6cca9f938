// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "brash/analysis/design.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/core/error.hpp"
#include "brash/core/text.hpp"

namespace brash::analysis {
namespace {

constexpr double kYear = 8784.0;  // of the longest year [h]
constexpr const char* kTable = "a scatter table: CSV of the campaign's varied keys and `hours` a year";

/// Whether a cell means the value of a varied key.
bool means(const std::string& cell, const nlohmann::ordered_json& value) {
  if (!value.is_number()) return value.get<std::string>() == cell;
  const auto number = number_in(cell);
  return number && std::abs(*number - value.get<double>()) <= 1e-6 * std::abs(value.get<double>());
}

/// The keys among the columns.
std::vector<std::size_t> keys_in(const TextTable& table, const SettingHistories& setting) {
  std::vector<std::size_t> keys;
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    if (table.names[c] == "hours") continue;
    if (!setting.values.contains(table.names[c])) {
      std::vector<std::string> varied;
      for (const auto& [key, value] : setting.values.items()) varied.push_back(key);
      throw InputError(Complaint{table.path, fmt::format("column '{}' is not a varied key", printable(table.names[c])),
                                 fmt::format("`hours` and: {}", fmt::join(varied, ", ")),
                                 "name the columns as the plan's grid does"});
    }
    keys.push_back(table.column(table.names[c]));
  }
  return keys;
}

bool matches(const TextTable& table, const TextTable::Row& row, const std::vector<std::size_t>& keys,
             const SettingHistories& setting) {
  for (const std::size_t key : keys)
    if (!means(row[key], setting.values[table.names[key]])) return false;
  return true;
}

}  // namespace

std::vector<double> read_scatter(const std::string& path, const std::vector<SettingHistories>& settings) {
  const TextTable table = read_text_table(path, kTable, "write a line of names, then one line a state");
  const std::size_t hours = table.column("hours");
  const std::vector<std::size_t> keys = keys_in(table, settings.front());
  std::vector<double> of_settings(settings.size(), 0.0);
  double sum = 0.0;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const TextTable::Row& row = table.rows[r];
    const std::string place = fmt::format("{}:{}", path, r + 2);
    const auto value = number_in(row[hours]);
    if (!value || *value < 0.0 || *value > kYear)
      throw InputError(Complaint{place, fmt::format("hours '{}'", printable(row[hours])), "hours of a year, 0 to 8784",
                                 "correct the number"});
    std::size_t found = settings.size(), n = 0;
    for (std::size_t i = 0; i < settings.size(); ++i)
      if (matches(table, row, keys, settings[i])) found = i, ++n;
    if (n == 0 && *value > 0.0)
      throw InputError(Complaint{place,
                                 fmt::format("the campaign has no setting of the state '{}'",
                                             printable(fmt::format("{}", fmt::join(row, ",")))),
                                 "a state whose keys have values of the grid, in SI",
                                 "add the state to the plan and run the campaign with `--resume`, or merge bins"});
    if (n > 1)
      throw InputError(Complaint{place, fmt::format("{} settings have these values", n), "one setting for each state",
                                 "name all varied keys as columns"});
    if (n == 1) of_settings[found] += *value;
    sum += *value;
  }
  // A millionth absorbs the rounding of hours that are shares of a year.
  if (sum > (1.0 + 1e-6) * kYear)
    throw InputError(Complaint{path, fmt::format("all states together last {:g} hours a year", sum),
                               "hours of a year, 8784 together at most", "correct the hours"});
  return of_settings;
}

}  // namespace brash::analysis
