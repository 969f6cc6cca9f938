// SPDX-License-Identifier: GPL-3.0-or-later
#include "series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "quantity.hpp"

namespace brash::io {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// More columns than anyone measures, and few enough to make room for.
constexpr std::size_t kMostColumns = 10'000;

/// Cells of a line: between commas, semicolons or tabs where there are any, else between blanks. Of too many, the
/// first.
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
    if (end == std::string_view::npos || cells.size() > kMostColumns) return cells;
    line.remove_prefix(end + 1);
  }
}

/// A finite number, not a number for a missing one, nothing for anything else.
std::optional<double> number(std::string_view cell) {
  constexpr std::array<std::string_view, 6> kMissingWords{"", "nan", "NaN", "NA", "-", "NAN"};
  if (std::ranges::find(kMissingWords, cell) != kMissingWords.end()) return kMissing;
  if (cell.front() == '+') cell.remove_prefix(1);
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
bool begin(Series& series, const std::vector<std::string_view>& cells) {
  const bool named = std::ranges::any_of(cells, [](std::string_view cell) { return !number(cell); });
  for (std::size_t i = 0; i < cells.size(); ++i)
    series.names.push_back(named ? unquoted(cells[i]) : std::to_string(i + 1));
  series.columns.resize(cells.size());
  return named;
}

void add_row(Series& series, const std::vector<std::string_view>& cells, std::size_t line) {
  series.rows.push_back(line);
  const auto place = [&] { return series.place(series.rows.size() - 1); };
  if (cells.size() != series.names.size())
    throw InputError(Complaint{place(),
                               fmt::format("{} values in a table of {} columns", cells.size(), series.names.size()),
                               "as many values in each line as in the first", "correct the line; # begins a comment"});
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::optional<double> value = number(cells[i]);
    if (!value)
      throw InputError(Complaint{place(),
                                 fmt::format("column '{}': '{}' is not a finite number", printable(series.names[i]),
                                             printable(std::string(cells[i]))),
                                 "numbers with a decimal point; nothing, NaN, NA or - where a value is missing",
                                 "correct the value, or begin the line with #"});
    series.columns[i].push_back(*value);
  }
}

/// A name such as "time [ms]" as name and unit.
std::pair<std::string, std::string> name_and_unit(const std::string& text) {
  const std::size_t open = text.find_first_of("[(");
  if (open == std::string::npos || !(text.back() == ']' || text.back() == ')')) return {text, ""};
  std::string name = text.substr(0, open);
  while (!name.empty() && name.back() == ' ') name.pop_back();
  return {name, text.substr(open + 1, text.size() - open - 2)};
}

void find_times(Series& series, const std::string& path) {
  std::string unit;
  for (std::size_t i = 0; i < series.names.size() && !series.time; ++i) {
    const auto [name, written] = name_and_unit(series.names[i]);
    if (!is_time_name(name)) continue;
    series.time = i;
    unit = written;
  }
  if (!series.time && series.names.size() > 1) series.time = 0;
  if (!series.time) return;
  const double factor = seconds_in(unit, fmt::format("{}, column '{}'", path, series.names[*series.time]));
  std::vector<double>& times = series.columns[*series.time];
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (std::isnan(times[i])) refuse_missing_time(series.place(i));
    times[i] *= factor;
  }
}

Series read_text_series(const std::string& path) {
  std::istringstream file(read_text_file(path, "a history (CSV)"));
  Series series;
  series.row_prefix = path + ":";
  std::size_t line_number = 0;
  for (std::string line; std::getline(file, line);) {
    ++line_number;
    const std::vector<std::string_view> cells = cells_of(line);
    if (cells.empty() || (cells.size() == 1 && cells[0].empty()) || cells[0].starts_with('#')) continue;
    if (cells.size() > kMostColumns)
      throw InputError(Complaint{fmt::format("{}:{}", path, line_number), "has more columns than a history has",
                                 fmt::format("at most {} columns", kMostColumns), "check that it is the right file"});
    if (series.names.empty() && begin(series, cells)) continue;
    add_row(series, cells, line_number);
  }
  if (series.rows.size() < 2)
    throw InputError(Complaint{path, fmt::format("{} rows of numbers", series.rows.size()),
                               "lines of numbers, 2 at least, after one of names",
                               "check that it is the right file and whole"});
  find_times(series, path);
  return series;
}

}  // namespace

void refuse_missing_time(const std::string& place) {
  throw InputError(Complaint{place, "the time is missing", "a finite time in each line or sample",
                             "write the time, or remove the line or sample"});
}

bool is_time_name(std::string_view name) {
  std::string lower(name);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == "time" || lower == "t";
}

double seconds_in(const std::string& unit, const std::string& place) {
  if (unit.empty()) return 1.0;
  const auto seconds = read_quantity("1 " + unit.substr(0, unit.find(" since ")), "s");
  if (!seconds)
    throw InputError(Complaint{place, fmt::format("the times' unit '{}': {}", printable(unit), seconds.error().what),
                               "a unit of time in UDUNITS-2, such as s, ms, min or \"seconds since 2020-01-01\"",
                               seconds.error().remedy});
  return *seconds;
}

Series read_series(const std::string& path) {
  return path.ends_with(".nc") ? read_netcdf_series(path) : read_text_series(path);
}

}  // namespace brash::io
