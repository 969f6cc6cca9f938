// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_history.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "brash/core/error.hpp"
#include "brash/core/vec.hpp"
#include "brash/io/results.hpp"

namespace brash::cli {
namespace {

struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
  std::vector<int> lines;  ///< of the file, for each row; rows of a run.nc count from 1
};

/// Cells of a line: between commas, semicolons or tabs where there are any, else between blanks.
std::vector<std::string_view> cells_of(std::string_view line) {
  const bool separated = line.find_first_of(",;\t") != std::string_view::npos;
  const std::string_view separators = separated ? ",;\t" : " ";
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t end = line.find_first_of(separators);
    std::string_view cell = line.substr(0, end);
    while (!cell.empty() && cell.front() == ' ') cell.remove_prefix(1);
    while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\r')) cell.remove_suffix(1);
    if (separated || !cell.empty()) cells.push_back(cell);
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

std::optional<double> number(std::string_view cell) {
  if (!cell.empty() && cell.front() == '+') cell.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string unquoted(std::string_view name) {
  if (name.size() >= 2 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
  return std::string(name);
}

/// The first line: names, or values of columns that are then called 1, 2, ...
/// @return whether it held names.
bool begin(Table& table, const std::vector<std::string_view>& cells) {
  const bool named = std::ranges::any_of(cells, [](std::string_view cell) { return !number(cell); });
  for (std::size_t i = 0; i < cells.size(); ++i) {
    table.names.push_back(named ? unquoted(cells[i]) : std::to_string(i + 1));
  }
  table.columns.resize(cells.size());
  return named;
}

void add_row(Table& table, const std::vector<std::string_view>& cells, const std::string& path, int line) {
  if (cells.size() != table.names.size()) {
    throw InputError(
        fmt::format("{}:{}: {} values in a table of {} columns", path, line, cells.size(), table.names.size()));
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::optional<double> value = number(cells[i]);
    if (!value) {
      throw InputError(
          fmt::format("{}:{}: column '{}': '{}' is not a finite number", path, line, table.names[i], cells[i]));
    }
    table.columns[i].push_back(*value);
  }
  table.lines.push_back(line);
}

Table read_table(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError(fmt::format("{}: cannot be read; give the path of a CSV file", path));
  Table table;
  int line_number = 0;
  for (std::string line; std::getline(file, line);) {
    ++line_number;
    const std::vector<std::string_view> cells = cells_of(line);
    if (cells.empty() || (cells.size() == 1 && cells[0].empty()) || cells[0].starts_with('#')) continue;
    if (table.names.empty() && begin(table, cells)) continue;
    add_row(table, cells, path, line_number);
  }
  if (table.lines.size() < 2)
    throw InputError(fmt::format("{}: {} rows of numbers; 2 are needed", path, table.lines.size()));
  return table;
}

/// The load history of a run, its columns named as in history.csv.
Table table_of_run(const std::string& path) {
  const std::vector<io::LoadRow> rows = io::read_results(path).loads;
  if (rows.size() < 2) throw InputError(fmt::format("{}: {} rows of loads; 2 are needed", path, rows.size()));
  Table table;
  const auto add = [&](const std::string& name, auto value) {
    table.names.push_back(name);
    std::vector<double>& column = table.columns.emplace_back();
    for (const io::LoadRow& row : rows) column.push_back(value(row));
  };
  add("time", [](const io::LoadRow& row) { return row.time; });
  const std::pair<const char*, Wrench io::LoadRow::*> causes[]{{"", &io::LoadRow::total},
                                                               {"crushing_", &io::LoadRow::crushing},
                                                               {"floe_normal_", &io::LoadRow::floe_normal},
                                                               {"floe_friction_", &io::LoadRow::floe_friction}};
  const std::pair<const char*, double Vec3::*> axes[]{{"x", &Vec3::x}, {"y", &Vec3::y}, {"z", &Vec3::z}};
  for (const auto& [cause, wrench] : causes) {
    for (const auto& [axis, member] : axes)
      add(fmt::format("{}F{}", cause, axis),
          [w = wrench, m = member](const io::LoadRow& r) { return (r.*w).force.*m; });
    for (const auto& [axis, member] : axes)
      add(fmt::format("{}M{}", cause, axis),
          [w = wrench, m = member](const io::LoadRow& r) { return (r.*w).moment.*m; });
  }
  table.lines.resize(rows.size());
  std::iota(table.lines.begin(), table.lines.end(), 1);
  return table;
}

std::size_t time_column(const Table& table, const std::string& path) {
  for (const char* name : {"time", "t", "Time"}) {
    const auto found = std::ranges::find(table.names, name);
    if (found != table.names.end()) return static_cast<std::size_t>(found - table.names.begin());
  }
  if (table.names.size() < 2) {
    throw InputError(fmt::format("{}: one column, so no times; give the time step with --dt", path));
  }
  return 0;
}

std::size_t load_column(const Table& table, const std::string& wanted, std::optional<std::size_t> time,
                        const std::string& path) {
  if (wanted.empty()) {
    const std::size_t first = time == std::size_t{0} ? 1 : 0;
    if (first < table.names.size()) return first;
  }
  const auto found = std::ranges::find(table.names, wanted);
  if (found == table.names.end()) {
    throw InputError(fmt::format("{}: no column '{}'; there are: {}", path, wanted, fmt::join(table.names, ", ")));
  }
  return static_cast<std::size_t>(found - table.names.begin());
}

/// Mean step of the times, checked.
double even_step(const std::vector<double>& times, const std::vector<int>& lines, const std::string& path) {
  const double dt = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (!(std::abs(times[i] - times[i - 1] - dt) <= 0.5 * std::abs(dt)) || dt <= 0.0) {
      throw InputError(
          fmt::format("{}:{}: time {} after {}: the times must rise evenly, by {} s on average; resample the "
                      "history first",
                      path, lines[i], times[i], times[i - 1], dt));
    }
  }
  return dt;
}

}  // namespace

LoadHistory read_history(const std::string& path, const HistoryChoice& choice) {
  const Table table = path.ends_with(".nc") ? table_of_run(path) : read_table(path);
  LoadHistory history;
  std::optional<std::size_t> time;
  if (choice.dt > 0.0) {
    history.dt = choice.dt;
  } else {
    time = time_column(table, path);
    history.dt = even_step(table.columns[*time], table.lines, path);
    history.start = table.columns[*time].front();
  }
  const std::size_t column = load_column(table, choice.column, time, path);
  history.column = table.names[column];
  history.samples = table.columns[column];
  if (choice.has_from && choice.from > history.start) {
    // A thousandth of a step absorbs the rounding of printed times.
    const double skipped = std::ceil((choice.from - history.start) / history.dt - 1e-3);
    if (skipped > static_cast<double>(history.samples.size()) - 2.0) {
      throw InputError(fmt::format("{}: --from {}: fewer than two samples are left", path, choice.from));
    }
    const auto first = static_cast<std::size_t>(skipped);
    history.samples.erase(history.samples.begin(), history.samples.begin() + static_cast<std::ptrdiff_t>(first));
    history.start = time ? table.columns[*time][first] : skipped * history.dt;
  }
  return history;
}

}  // namespace brash::cli
