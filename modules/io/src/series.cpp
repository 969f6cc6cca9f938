// SPDX-License-Identifier: GPL-3.0-or-later
#include "series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "quantity.hpp"
#include "series_head.hpp"

namespace brash::io {
namespace {

/// More lines than a logger writes above its table.
constexpr std::size_t kMostLinesOfHead = 100;

/// The first line: names, or values of columns that are then called 1, 2, ...
/// @return whether it held names.
bool begin(Series& series, const std::vector<std::string_view>& cells, Layout& layout) {
  const bool named =
      std::ranges::any_of(cells, [&](std::string_view cell) { return !number_in(cell, layout) && !iso_time(cell); });
  if (named) layout.decimal_mark = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    series.heads.push_back(named ? std::string(cells[i]) : std::to_string(i + 1));
    const auto [name, unit] = name_and_unit(series.heads.back());
    series.names.push_back(name);
    series.units.push_back(unit);
  }
  series.columns.resize(cells.size());
  return named;
}

/// Where the times may be: the column with such a name, else the first of several.
std::optional<std::size_t> time_column(const std::vector<std::string>& names) {
  const auto found = std::ranges::find_if(names, [](const std::string& name) { return is_text_time_name(name); });
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  return names.size() > 1 ? std::optional<std::size_t>(0) : std::nullopt;
}

/// Whether a unit is one of time. UDUNITS converts frequencies too, to their inverse.
bool is_unit_of_time(const std::string& unit) {
  const auto one = read_quantity("1 " + unit, "s"), two = read_quantity("2 " + unit, "s");
  return one && two && *two > *one;
}

/// Whether a column with a name holds times: its name or its unit says so. A first line of anything else may be a
/// preamble, or of places.
bool holds_times(const Series& series, std::size_t column) {
  return is_text_time_name(series.names[column]) ||
         (!series.units[column].empty() && is_unit_of_time(series.units[column]));
}

/// Whether a unit under a name is the one in the name.
bool is_same_unit(const std::string& one, const std::string& other) {
  const auto ratio = read_quantity("1 " + one, other);
  return ratio && *ratio == 1.0;
}

/// Takes a line of units under the names, when the one of the times is a unit of time.
/// @param place  of the line, for messages.
/// @return whether it was one.
bool take_units(Series& series, const std::vector<std::string_view>& cells, const std::string& place) {
  const auto times = time_column(series.names);
  if (!times || cells.size() != series.names.size()) return false;
  std::vector<std::string> units;
  for (const std::string_view cell : cells) {
    const auto [outside, bracketed] = name_and_unit(std::string(cell));
    units.push_back(outside.empty() ? bracketed : std::string(cell));
  }
  if (!is_unit_of_time(units[*times])) return false;
  for (std::size_t i = 0; i < units.size(); ++i) {
    std::string& in_name = series.units[i];
    if (in_name.empty())
      in_name = units[i];
    else if (!units[i].empty() && units[i] != "-" && !is_same_unit(units[i], in_name))
      throw InputError(Complaint{
          fmt::format("{}: column '{}'", place, printable(series.heads[i])),
          fmt::format("has the unit '{}' under a name that ends with '{}'", printable(units[i]), printable(in_name)),
          "one unit", "take the wrong one out of the name or out of the line of units"});
  }
  return true;
}

/// Times that are written as dates: seconds after the first date.
struct Dates {
  std::optional<Instant> first;
  std::string text{};  ///< of the first, as it is written

  std::optional<double> seconds(std::string_view cell, bool is_first_row) {
    const std::optional<Instant> time = iso_time(cell);
    if (time && is_first_row) {
      first = time;
      text = cell;
    }
    if (!time || !first) return std::nullopt;
    return time->since(*first);
  }
};

/// Whether a cell in the place of a time is a date or a clock's time in another form than iso_time() reads.
bool is_like_a_date(std::string_view cell) {
  const auto has_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  return !cell.empty() && has_digit(cell.front()) && cell.find_first_of(".-/:") != std::string_view::npos &&
         std::ranges::count_if(cell, has_digit) >= 4;
}

[[noreturn]] void refuse_date(const std::string& place, const std::string& cell) {
  throw InputError(
      Complaint{place, fmt::format("'{}' is not a time that is read", printable(cell)),
                "seconds, or dates with the year first: 2024-02-01T12:00:00.5 (ISO 8601; a blank for the T, "
                "and Z or +01:00 behind, are allowed)",
                "write the dates so, or the seconds since the first one"});
}

void add_row(Series& series, const std::vector<std::string_view>& cells, std::size_t line, Layout& layout,
             Dates& dates) {
  series.rows.add(line);
  const auto place = [&] { return series.place(series.rows.size() - 1); };
  if (cells.size() != series.names.size())
    throw InputError(Complaint{
        place(), fmt::format("{} values in a table of {} columns", cells.size(), series.names.size()),
        "as many values in each line as in the first", "correct the line; a preamble before the table begins with #"});
  const auto times = time_column(series.names);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::optional<double> value = number_in(cells[i], layout);
    if (!value && times == i) value = dates.seconds(cells[i], series.rows.size() == 1);
    if (!value && times == i && is_like_a_date(cells[i])) refuse_date(place(), std::string(cells[i]));
    if (!value)
      throw InputError(
          Complaint{place(),
                    fmt::format("column '{}': '{}' is not a finite number", printable(series.names[i]),
                                printable(std::string(cells[i]))),
                    "numbers with a decimal point, or all with a decimal comma between semicolons or tabs; "
                    "nothing, NaN, NA or - where a value is missing",
                    "correct the value; a line that is no part of the table, such as a preamble, begins with #"});
    series.columns[i].push_back(*value);
  }
}

void find_times(Series& series, const std::string& path, bool named, const Dates& dates) {
  series.time = time_column(series.names);
  if (!series.time) return;
  std::string& unit = series.units[*series.time];
  if (named && !dates.first && !holds_times(series, *series.time)) {
    // Seconds that nobody named would be a guess.
    series.time.reset();
    return;
  }
  if (dates.first) {
    unit = "s";
    series.start = dates.text;
  }
  const double factor = seconds_in(unit, fmt::format("{}, column '{}'", path, printable(series.heads[*series.time])));
  unit = "s";
  std::vector<double>& times = series.columns[*series.time];
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (std::isnan(times[i])) refuse_missing_time(series.place(i));
    times[i] *= factor;
  }
}

/// Whether a line in the place of a row is a remark, such as the one with which HydroDyn closes its tables: words
/// without a number.
bool is_remark(const std::vector<std::string_view>& cells, Layout layout) {
  if (cells.empty() || cells.front().empty() || std::isalpha(static_cast<unsigned char>(cells.front().front())) == 0)
    return false;
  double infinite = 0.0;
  const char* const last = cells.front().data() + cells.front().size();
  return std::from_chars(cells.front().data(), last, infinite).ptr != last &&
         std::ranges::none_of(cells, [&](std::string_view cell) { return number_in(cell, layout).has_value(); });
}

/// A line of a text.
struct NumberedLine {
  std::string text;
  std::size_t number;  ///< in the file
};

bool is_row(std::string_view line) {
  Layout layout{separator_of(line)};
  bool has_number = false;
  for (const std::string_view cell : cells_of(line, layout.separator)) {
    const auto value = number_in(cell, layout);
    if (!value && !iso_time(cell)) return false;
    has_number = has_number || !value || !std::isnan(*value);
  }
  return has_number;
}

bool names_times(const std::vector<std::string_view>& cells) {
  return std::ranges::any_of(
      cells, [](std::string_view cell) { return is_text_time_name(name_and_unit(std::string(cell)).first); });
}

/// Which of the lines up to the first row of numbers has the names. A title may stand above them, and units below: the
/// names are as many as the numbers and contain none. The first such line that names times wins.
std::size_t line_of_names(const std::vector<NumberedLine>& lines) {
  if (lines.size() < 3 || !is_row(lines.back().text)) return 0;
  Layout layout{separator_of(lines.back().text)};
  const std::size_t n = cells_of(lines.back().text, layout.separator).size();
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    std::vector<std::string_view> cells = cells_of(lines[i].text, layout.separator);
    if (layout.separator == ' ') cells = with_units(cells);
    const auto is_number = [&](std::string_view cell) {
      const auto value = number_in(cell, layout);
      return value && !std::isnan(*value);
    };
    if (cells.size() != n || std::ranges::any_of(cells, is_number)) continue;
    if (names_times(cells)) return i;
    if (!first) first = i;
  }
  return first.value_or(0);
}

/// Makes a series of the lines of a text.
class TextSeries {
 public:
  /// The text output of OpenFAST has a preamble without a mark before the names, of which Time is the first.
  TextSeries(const std::string& path, const std::vector<double>& missing)
      : path_(path), missing_(missing), preamble_(path.ends_with(".out")) {
    series_.row_prefix = path + ":";
  }

  void take(std::string_view line) {
    const std::string_view content = without_blanks(line);
    ++line_number_;
    if (content.empty() || content.starts_with('#')) return;
    preamble_ = preamble_ && !content.starts_with("Time");
    if (preamble_) return;
    if (has_begun_) return take_content(content, line_number_);
    head_.push_back({std::string(content), line_number_});
    if (is_row(content) || head_.size() > kMostLinesOfHead) begin_table();
  }

  Series finished() && {
    if (!has_begun_) begin_table();
    if (series_.rows.size() < 2)
      throw InputError(Complaint{path_, fmt::format("{} rows of numbers", series_.rows.size()),
                                 "lines of numbers, 2 at least, after one of names",
                                 "check that it is the right file and whole"});
    if (remark_)
      series_.notes.push_back(
          fmt::format("line {} is not a row and was left out: {}", remark_->number, printable(remark_->text)));
    find_times(series_, path_, named_, dates_);
    leave_out(series_, missing_);
    convert_to_si(series_);
    return std::move(series_);
  }

 private:
  /// Takes the lines that were kept until the first row, from the names on.
  void begin_table() {
    has_begun_ = true;
    const std::size_t names = line_of_names(head_);
    if (names > 0) {
      layout_ = Layout{separator_of(head_.back().text)};
      series_.notes.push_back(fmt::format("{} above the names, such as '{}', {} left out",
                                          names == 1 ? "a line" : fmt::format("{} lines", names),
                                          printable(head_.front().text), names == 1 ? "was" : "were"));
    }
    for (std::size_t i = names; i < head_.size(); ++i) take_content(head_[i].text, head_[i].number);
    head_.clear();
  }

  void take_content(std::string_view content, std::size_t number) {
    if (!layout_) layout_ = Layout{separator_of(content)};
    std::vector<std::string_view> cells = cells_of(content, layout_->separator);
    if (series_.names.empty() && layout_->separator == ' ') cells = with_units(cells);
    if (cells.size() > kMostColumns)
      throw InputError(Complaint{fmt::format("{}:{}", path_, number), "has more columns than a history has",
                                 fmt::format("at most {} columns", kMostColumns), "check that it is the right file"});
    if (series_.names.empty() && begin(series_, cells, *layout_)) {
      named_ = true;
      units_may_follow_ = true;
      return;
    }
    if (std::exchange(units_may_follow_, false) && take_units(series_, cells, fmt::format("{}:{}", path_, number)))
      return;
    if (series_.rows.size() >= 2 && is_remark(cells, *layout_)) {
      if (!remark_) remark_ = NumberedLine{std::string(content), number};
      return;
    }
    // Only the end of a table has remarks: within it the line is a broken row.
    if (remark_) add_row(series_, cells_of(remark_->text, layout_->separator), remark_->number, *layout_, dates_);
    add_row(series_, cells, number, *layout_, dates_);
  }

  std::string path_;
  std::vector<double> missing_;
  Series series_;
  std::optional<Layout> layout_;
  Dates dates_;
  std::vector<NumberedLine> head_;      ///< before the table has begun
  std::optional<NumberedLine> remark_;  ///< the first after the rows
  bool has_begun_ = false, named_ = false, units_may_follow_ = false, preamble_ = false;
  std::size_t line_number_ = 0;
};

/// Formats that hold histories and are no text.
void refuse_binary(const std::string& path) {
  struct Format {
    std::string_view ending;
    const char *name, *remedy;
  };
  for (const auto& [ending, name, remedy] :
       {Format{".outb", "OpenFAST's binary output", "let OpenFAST write text, with OutFileFmt = 1"},
        Format{".xlsx", "a workbook of a spreadsheet", "save the sheet as CSV"},
        Format{".xls", "a workbook of a spreadsheet", "save the sheet as CSV"},
        Format{".mat", "a file of MATLAB", "write the columns as CSV, with writetable"},
        Format{".tdms", "a binary log of LabVIEW", "export the channels as CSV"}})
    if (path.ends_with(ending))
      throw InputError(Complaint{path, fmt::format("is {}", name), "a history as text or netCDF", remedy});
}

Series read_text_series(const std::string& path, const std::vector<double>& missing) {
  TextSeries series(path, missing);
  for_each_line(path, "a history (CSV)", [&](std::string_view line) { series.take(line); });
  return std::move(series).finished();
}

}  // namespace

void RowNumbers::add(std::size_t number) {
  if (size_ == 0 || number != (*this)[size_ - 1] + 1) stretches_.push_back({size_, number});
  ++size_;
}

std::size_t RowNumbers::operator[](std::size_t row) const {
  const auto after = std::ranges::upper_bound(stretches_, row, {}, &Stretch::row);
  return (after - 1)->number + row - (after - 1)->row;
}

void refuse_missing_time(const std::string& place) {
  throw InputError(Complaint{place, "the time is missing", "a finite time in each line or sample",
                             "write the time, or remove the line or sample"});
}

bool is_time_name(std::string_view name) {
  std::string lower(name);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == "time" || lower == "t";
}

void leave_out(Series& series, const std::vector<double>& missing) {
  if (missing.empty()) return;
  for (std::size_t i = 0; i < series.columns.size(); ++i)
    if (series.time != i)
      for (double& value : series.columns[i])
        if (std::ranges::find(missing, value) != missing.end()) value = std::numeric_limits<double>::quiet_NaN();
}

void convert_to_si(Series& series) {
  series.factors.assign(series.units.size(), 1.0);
  for (std::size_t i = 0; i < series.units.size(); ++i) {
    if (series.units[i].empty() || series.time == i) continue;
    for (const char* const si : {"N", "N m", "Pa", "m", "m s-1", "m s-2", "rad"}) {
      const auto factor = read_quantity("1 " + series.units[i], si);
      if (!factor) continue;
      if (*factor == 1.0) break;  // as it is written: N m and J are the same
      for (double& value : series.columns[i]) value *= *factor;
      series.units[i] = si;
      series.factors[i] = *factor;
      break;
    }
  }
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

Series read_series(const std::string& path, const std::vector<double>& missing) {
  refuse_binary(path);
  return path.ends_with(".nc") ? read_netcdf_series(path, missing) : read_text_series(path, missing);
}

}  // namespace brash::io
