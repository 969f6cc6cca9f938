// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/load_history.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>

#include "brash/core/error.hpp"
#include "brash/core/text.hpp"
#include "brash/io/file_names.hpp"
#include "brash/io/run_summary.hpp"
#include "brash/io/series.hpp"

namespace brash::analysis {
namespace {

/// Refuses a name that several columns have: the first column would be a guess.
/// @param spelled  the heads of the series, or its names without their units.
void refuse_doubled(const io::Series& series, const std::string& path, const std::vector<std::string>& spelled,
                    const std::string& name) {
  if (std::ranges::count(spelled, name) < 2) return;
  const bool units_tell = std::ranges::count(series.heads, name) == 0;
  throw InputError(Complaint{path, fmt::format("has several columns '{}'", printable(name)),
                             units_tell ? fmt::format("one of: {}", fmt::join(series.heads, ", "))
                                        : "a name of its own for each column that is read",
                             units_tell ? "name the column with its unit" : "rename all but one"});
}

std::size_t load_column(const io::Series& series, const std::string& wanted, const std::string& path) {
  if (wanted.empty()) {
    const std::size_t first = series.time == std::size_t{0} ? 1 : 0;
    if (first < series.names.size()) {
      refuse_doubled(series, path, series.heads, series.heads[first]);
      return first;
    }
    throw InputError(Complaint{path, "holds no column but the times", "a column of times and one of loads",
                               "check that it is the right file"});
  }
  for (const std::vector<std::string>& spelled : {series.heads, series.names})
    if (const auto found = std::ranges::find(spelled, wanted); found != spelled.end()) {
      refuse_doubled(series, path, spelled, wanted);
      return static_cast<std::size_t>(found - spelled.begin());
    }
  const std::string nearest = nearest_name(wanted, series.names);
  throw InputError(Complaint{path, fmt::format("has no column '{}'", printable(wanted)),
                             fmt::format("one of: {}", fmt::join(series.heads, ", ")),
                             nearest.empty() ? "name another column" : "name another column, such as " + nearest});
}

void require_rising(const io::Series& series, const std::vector<double>& times) {
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (!(times[i] > times[i - 1]))
      throw InputError(Complaint{series.place(i), fmt::format("time {} after {}", times[i], times[i - 1]),
                                 "times that rise", "sort the rows and remove doubled ones"});
  }
}

/// Beyond these a sum of squares is not a number any more, or a time not a time.
void require_ordinary(const io::Series& series, std::size_t column) {
  constexpr double kMostLoad = 1e30;   // in the unit of the column
  constexpr double kMostTime = 1e12;   // [s]
  constexpr double kLeastStep = 1e-9;  // [s]
  const auto refuse = [&](std::size_t row, double value, const std::string& allowed) {
    throw InputError(Complaint{series.place(row), fmt::format("{:.6g} is absurd", value), allowed,
                               "check the column's unit, and that the file is whole"});
  };
  for (std::size_t row = 0; row < series.columns[column].size(); ++row) {
    if (const double value = series.columns[column][row]; std::abs(value) > kMostLoad)
      refuse(row, value, fmt::format("loads within +-{:g}", kMostLoad));
    if (!series.time) continue;
    const std::vector<double>& times = series.columns[*series.time];
    if (std::abs(times[row]) > kMostTime) refuse(row, times[row], fmt::format("times within +-{:g} s", kMostTime));
    if (row > 0 && times[row] - times[row - 1] < kLeastStep)
      refuse(row, times[row] - times[row - 1], fmt::format("steps of {:g} s or more between two times", kLeastStep));
  }
}

/// A file whose name says that it is not a history gets no line of it blamed.
void refuse_other_files(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr std::array<std::string_view, 5> kOthers{".toml", ".json", ".html", ".svg", ".wkt"};
  if (std::ranges::find(kOthers, fs::path(path).extension().string()) == kOthers.end()) return;
  throw InputError(Complaint{path, "is not a history",
                             "a history: CSV or netCDF with a column of times and one of loads",
                             "name a history, such as the history.csv of a run or the table of a logger"});
}

/// With a time step the file is one without times, and all its columns are loads. The first of several columns without
/// names may be of times, and is not a load by default.
void leave_times_to_step(io::Series& series, const std::string& path, const std::vector<std::string>& wanted) {
  if (!series.time) return;
  const std::string& head = series.heads[*series.time];
  if (head != "1")  // as io::read_series calls a first column without a name
    throw InputError(Complaint{path, fmt::format("has times in column '{}', and a time step is given", printable(head)),
                               "a time step for a file without times",
                               "leave the time step out; if these are not times, give their column another name"});
  if (wanted.front().empty())
    throw InputError(Complaint{path, "has several columns without names, of which the first may be of times",
                               "a column by its number, or no time step",
                               "name the column of the load, such as 2, or leave the time step out"});
  series.time.reset();
}

/// Times of the rows: of the file, or counted with the step of `choice`.
std::vector<double> times_of(const io::Series& series, const HistoryChoice& choice) {
  if (series.time) return series.columns[*series.time];
  std::vector<double> times(series.rows.size());
  for (std::size_t row = 0; row < times.size(); ++row) times[row] = choice.dt * static_cast<double>(row);
  return times;
}

/// @param ends_steps  whether the samples are the ends of steps, as of a run: one rule, whoever says where it begins.
/// @param slack       of other times that somebody gave [s].
bool is_early(double time, const HistoryChoice& choice, bool ends_steps, double slack) {
  if (!choice.has_from) return false;
  return ends_steps ? time <= choice.from : time < choice.from - slack;
}

/// Leaves out the rows outside the span of `choice` and the ones without a value.
void keep_chosen(LoadHistory& load, const HistoryChoice& choice) {
  const bool ends_steps = choice.after || io::start_beside(load.file).has_value();
  std::vector<double>&times = load.history.times, &values = load.history.values;
  // A thousandth of a step absorbs the rounding of printed times.
  const double slack = 1e-3 * (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  std::size_t kept = 0;
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (is_early(times[row], choice, ends_steps, slack)) continue;
    if (choice.to && times[row] > *choice.to + slack) continue;
    if (std::isnan(values[row])) {
      ++load.n_missing;
      continue;
    }
    times[kept] = times[row];
    values[kept++] = values[row];
  }
  times.resize(kept);
  values.resize(kept);
}

std::string span_text(const HistoryChoice& choice) {
  const std::string option = choice.after ? "statistics_from = {} of the summary" : "--from {}";
  const std::string from = choice.has_from ? fmt::format(fmt::runtime(option), choice.from) : "";
  const std::string to = choice.to ? fmt::format("--to {}", *choice.to) : "";
  return from + (from.empty() || to.empty() ? "" : " and ") + to;
}

/// @param last  whether the series is not needed any more.
LoadHistory history_of(io::Series& series, const std::string& path, const std::string& name,
                       const HistoryChoice& choice, bool last) {
  LoadHistory load;
  const std::size_t column = load_column(series, name, path);
  require_ordinary(series, column);
  load.file = path;
  load.column = series.names[column];
  load.unit = series.units[column];
  load.start = series.start;
  load.history.values = last && series.time != column ? std::move(series.columns[column]) : series.columns[column];
  load.history.times = last && series.time ? std::move(series.columns[*series.time]) : times_of(series, choice);
  keep_chosen(load, choice);
  if (load.history.values.size() < 2) {
    const std::string span = span_text(choice);
    throw InputError(Complaint{path,
                               span.empty()
                                   ? fmt::format("column '{}' has fewer than two values", printable(load.column))
                                   : fmt::format("{} leaves fewer than two values", span),
                               "two values at least",
                               choice.after   ? "give an earlier --from"
                               : span.empty() ? "name another column"
                                              : "give a longer span of times"});
  }
  load.even = statistics::make_even(load.history, choice.longest_interval);
  load.marker = missing_marker(load.history.values, series.factors[column]);
  return choice.negate ? negated(std::move(load)) : std::move(load);
}

}  // namespace

std::optional<MissingMarker> missing_marker(std::span<const double> values, double factor) {
  constexpr std::array<double, 13> kUsual{99.0,  999.0,  9999.0,  99999.0, 999999.0, 9999999.0, 999.25,
                                          999.9, 9999.9, 32767.0, 32768.0, 1e20,     1e30};
  const auto is_near = [&](double value, double marker) {
    return std::abs(value - factor * marker) <= 1e-12 * std::abs(value);  // the rounding of the factor
  };
  const auto [least, largest] = std::ranges::minmax(values);
  for (const double end : {least, largest})
    for (const double usual : kUsual) {
      const double marker = std::copysign(usual, end);
      if (!is_near(end, marker)) continue;
      double low = INFINITY, high = -INFINITY;
      std::size_t n = 0;
      for (const double value : values) {
        if (is_near(value, marker)) {
          ++n;
        } else {
          low = std::min(low, value);
          high = std::max(high, value);
        }
      }
      const double apart = end == least ? low - end : end - high;
      if (low < high && apart > 0.1 * (high - low)) return MissingMarker{marker, n};
    }
  return std::nullopt;
}

std::string marker_warning(const std::optional<MissingMarker>& marker) {
  if (!marker) return "";
  return fmt::format(
      "{} {} {:g}, far from all others, as loggers write missing values: `--missing {:g}`, in Python missing=[{:g}], "
      "leaves them out",
      marker->n, marker->n == 1 ? "sample is" : "samples are", marker->value, marker->value, marker->value);
}

std::string history_file(const std::string& given) { return io::file_in(given, {"run.nc", "history.csv"}); }

LoadHistory negated(LoadHistory load) {
  load.column = "-" + load.column;
  load.is_negated = !load.is_negated;
  for (double& value : load.history.values) value = 0.0 - value;
  return load;
}

LoadHistory read_history(const std::string& path, const HistoryChoice& choice) {
  return std::move(read_histories(path, choice, {choice.column}).front());
}

std::vector<LoadHistory> read_histories(const std::string& path, const HistoryChoice& choice,
                                        const std::vector<std::string>& columns) {
  if (std::isnan(choice.from))
    throw InputError(Complaint{path, fmt::format("--from {} is not a time", choice.from), "seconds", "give a number"});
  if (choice.to && std::isnan(*choice.to))
    throw InputError(Complaint{path, fmt::format("--to {} is not a time", *choice.to), "seconds", "give a number"});
  refuse_other_files(path);
  const model::Origin origin =
      io::origin_of_history(path);  // reads a whole file, which is not to lie beside the series
  io::Series series = io::read_series(path, choice.missing);
  if (choice.notes)
    for (const std::string& note : series.notes) choice.notes(path + ": " + note);
  const std::vector<std::string> wanted = columns.empty() ? std::vector{choice.column} : columns;
  if (choice.dt > 0.0) leave_times_to_step(series, path, wanted);
  if (choice.dt <= 0.0 && !series.time)
    throw InputError(
        Complaint{path, "has no column of times: none is named time or t, or has a unit of time",
                  "a column `time [s]` or the like, or --dt",
                  "name the column of times and its unit, begin a preamble with #, or give the time step with --dt"});
  if (series.time) require_rising(series, series.columns[*series.time]);
  std::vector<LoadHistory> loads;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    loads.push_back(history_of(series, path, wanted[i], choice, i + 1 == wanted.size()));
  for (LoadHistory& load : loads) {
    load.warnings = io::warnings_beside(path);
    load.origin = origin;
  }
  return loads;
}

std::vector<std::string> run_warnings(std::span<const LoadHistory> loads) {
  std::vector<model::Warning> first;  // of each id
  std::map<std::string, std::size_t> runs;
  for (const LoadHistory& load : loads)
    for (const model::Warning& warning : load.warnings)
      if (++runs[warning.id] == 1) first.push_back(warning);
  std::vector<std::string> texts;
  for (const model::Warning& warning : first) {
    const std::string of = loads.size() == 1 ? "the run" : fmt::format("{} of {} runs", runs[warning.id], loads.size());
    texts.push_back(fmt::format("of {}: {}: {}", of, escaped(warning.id), escaped(warning.text)));
  }
  return texts;
}

model::Origin origin_of(std::span<const LoadHistory> loads) {
  model::Origin all;
  for (const LoadHistory& load : loads) model::add(all, load.origin);
  return all;
}

}  // namespace brash::analysis
