// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "brash/analysis/history_statistics.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/core/error.hpp"
#include "brash/io/series.hpp"
#include "brash/statistics/rainflow.hpp"

namespace brash::analysis {
namespace {

/// A crack of a run.
struct Crack {
  double time = 0.0;
  std::string place;  ///< "x,y"
};

/// The breaks in the events.csv beside a history; none where there is no such file.
std::vector<Crack> cracks_beside(const std::string& history) {
  const std::string path = (std::filesystem::path(history).parent_path() / "events.csv").string();
  std::vector<Crack> cracks;
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return cracks;
  const TextTable table = read_text_table(path, "the events.csv of a run", "repeat the run");
  const std::size_t time = table.column("time"), x = table.column("x"), y = table.column("y");
  const std::size_t kind = table.column("event");
  for (const TextTable::Row& row : table.rows)
    if (const auto at = number_in(row[time]); row[kind] == "break" && at)
      cracks.push_back({*at, row[x] + "," + row[y]});
  return cracks;
}

/// The parts of a load by cause.
struct Causes {
  io::Series series;
  std::vector<std::size_t> columns;
  double sign;  ///< of the load against the file

  explicit Causes(const LoadHistory& load) : series(io::read_series(load.file)), sign(load.is_negated ? -1.0 : 1.0) {
    const std::string end = "_" + load.column.substr(load.is_negated ? 1 : 0);
    for (std::size_t i = 0; i < series.names.size(); ++i)
      if (series.names[i].ends_with(end) && series.time) columns.push_back(i);
  }

  /// "crushing": the cause with the largest part of a load at a time; "" where the file has no parts.
  std::string largest(double time) const {
    if (columns.empty()) return "";
    const std::vector<double>& times = series.columns[*series.time];
    const auto at = static_cast<std::size_t>(std::ranges::lower_bound(times, time) - times.begin());
    const std::size_t row = std::min(at, times.size() - 1);
    const std::size_t best =
        *std::ranges::max_element(columns, {}, [&](std::size_t c) { return sign * series.columns[c][row]; });
    return series.names[best].substr(0, series.names[best].rfind('_'));
  }
};

/// "time,x,y" of the crack within an event that is nearest to its peak; ",," when there is none.
std::string crack_of(const statistics::LoadEvent& event, const std::vector<Crack>& cracks) {
  const Crack* nearest = nullptr;
  for (const Crack& crack : cracks) {
    if (crack.time < event.start || crack.time > event.end) continue;
    const auto distance = [&](const Crack& c) { return std::abs(c.time - event.peak_time); };
    if (nearest == nullptr || distance(crack) < distance(*nearest)) nearest = &crack;
  }
  return nearest == nullptr ? ",," : fmt::format("{},{}", nearest->time, nearest->place);
}

}  // namespace

CsvTable events_table(const LoadHistory& load, std::optional<double> dead_band) {
  CsvTable table{"start,end,peak_time,peak,impulse,rise,fall,cause,crack_time,crack_x,crack_y\n", ""};
  const Causes causes(load);
  const std::vector<Crack> cracks = cracks_beside(load.file);
  for (const statistics::LoadEvent& e : events_of(load, dead_band))
    table.lines += fmt::format("{},{},{},{},{},{},{},{},{}\n", e.start, e.end, e.peak_time, e.peak, e.impulse, e.rise(),
                               e.fall(), causes.largest(e.peak_time), crack_of(e, cracks));
  return table;
}

CsvTable exceedance_table(const LoadHistory& load, std::optional<double> dead_band) {
  constexpr int kLevels = 50;
  CsvTable table{"level,time_above,share,events_above\n", ""};
  const auto& values = load.history.values;
  const auto [low, high] = std::ranges::minmax(values);
  const auto events = events_of(load, dead_band);
  for (int i = 0; i < kLevels; ++i) {
    const double level = low + (high - low) * i / (kLevels - 1.0);
    double time = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) time += values[k] > level ? load.even.weight(k) : 0.0;
    const auto above = std::ranges::count_if(events, [&](const auto& e) { return e.peak > level; });
    table.lines += fmt::format("{},{},{},{}\n", level, time, time / load.even.duration, above);
  }
  return table;
}

CsvTable cycles_table(const LoadHistory& load) {
  CsvTable table{"range,mean,count,end\n", ""};
  std::size_t first = 0;
  for (const auto piece : statistics::raw_pieces(load.history, load.even)) {
    for (const statistics::Cycle& c : statistics::rainflow(piece))
      table.lines += fmt::format("{},{},{},{}\n", c.range, c.mean, c.count, load.history.times[first + c.index]);
    first += piece.size();
  }
  return table;
}

CsvTable spectrum_table(const LoadHistory& load, double segment) {
  const auto spectrum = spectrum_of(load, segment);
  if (!spectrum) throw InputError("--spectrum: the history or the segment is shorter than 16 samples");
  const statistics::Interval factors = statistics::spectrum_factors(*spectrum);
  CsvTable table{"frequency,density,lower_95,upper_95\n", ""};
  for (std::size_t k = 0; k < spectrum->frequency.size(); ++k) {
    const double density = spectrum->density[k];
    table.lines +=
        fmt::format("{},{},{},{}\n", spectrum->frequency[k], density, factors.lower * density, factors.upper * density);
  }
  return table;
}

}  // namespace brash::analysis
