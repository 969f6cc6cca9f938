// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "brash/core/version.hpp"
#include "brash/core/write_pieces.hpp"
#include "brash/io/case.hpp"
#include "brash/io/result_columns.hpp"
#include "brash/io/results.hpp"
#include "result_tables.hpp"
#include "tables.hpp"

namespace brash::io {
namespace {

FileImage netcdf_image(const std::string& path, const model::Case& resolved, const model::RunResults& results,
                       const std::vector<std::string>& earlier) {
  NetcdfWriter file(path);
  file.continue_files(earlier);
  file.attribute("Conventions", "CF-1.9");
  file.attribute("title", "brash run of the case " + resolved.name);
  file.attribute("source", std::string("brash ") + kVersion);
  file.attribute(
      "comment",
      "Loads act on the structure in load axes: x against the structure's heading (as the ice drifts, if it does not "
      "turn), y to starboard, z upwards; moments are about the structure's origin on the waterplane. Places are in "
      "the sheet frame: x along the structure's track, y to port, z upwards from the waterplane.");
  file.attribute("case", to_toml(resolved));
  write_tables(file, results);
  return file.finish();
}

/// Text of `value` in a CSV file: the shortest that reads back to the same number, flags as 1 and 0.
template <typename T>
void append(std::string& text, const T& value) {
  if constexpr (std::is_same_v<T, bool>)
    text += value ? '1' : '0';
  else
    fmt::format_to(std::back_inserter(text), "{}", value);
}

/// The columns' names, each with a comma after it.
template <typename Row>
std::string header() {
  std::string text;
  Columns<Row>::visit([&](const std::string& name, const auto&...) { text += name + ','; });
  return text;
}

/// The columns' values, each with a comma after it.
template <typename Row>
std::string cells(const Row& row) {
  std::string text;
  Columns<Row>::visit([&](const std::string&, const char*, const std::string&, auto member) {
    append(text, member(row));
    text += ',';
  });
  return text;
}

/// Rows of a piece of history.csv.
constexpr std::size_t kRowsOfPiece = 1000;

/// history.csv in pieces: its text takes as much memory as the rows do.
class HistoryText {
 public:
  HistoryText(const std::vector<model::LoadRow>& loads, const std::vector<std::string>& earlier)
      : last_(loads), earlier_(earlier) {
    std::set<std::string> before;
    for (const std::string& file : earlier) before.merge(NetcdfReader(file).variables());
    visit_used(
        loads,
        [&](const std::string& name, const auto&...) {
          used_.insert(name);
          names_ += name + ',';
        },
        [&](const std::string& name) { return before.contains(name); });
    names_.back() = '\n';
  }

  bool next(std::string_view& piece) {
    text_ = std::exchange(names_, {});
    while (text_.empty() && next_ == loads_->size())
      if (!take_loads()) return false;
    const std::size_t end = std::min(next_ + kRowsOfPiece, loads_->size());
    for (; next_ < end; ++next_) add_row(text_, (*loads_)[next_]);
    piece = text_;
    return true;
  }

 private:
  /// Goes on to the loads of the next file, and after all files to the last ones; false: there are none.
  bool take_loads() {
    if (loads_ == &last_) return false;
    next_ = 0;
    if (n_read_ == earlier_.size())
      loads_ = &last_;
    else
      read_ = read_rows<model::LoadRow>(NetcdfReader(earlier_[n_read_++]));
    return true;
  }
  void add_row(std::string& text, const model::LoadRow& row) const {
    Columns<model::LoadRow>::visit([&](const std::string& name, const char*, const std::string&, auto member) {
      if (!used_.contains(name)) return;
      append(text, member(row));
      text += ',';
    });
    text.back() = '\n';
  }

  const std::vector<model::LoadRow>& last_;
  const std::vector<std::string>& earlier_;
  std::vector<model::LoadRow> read_{};                 ///< of an earlier file
  const std::vector<model::LoadRow>* loads_ = &read_;  ///< whose lines are made
  std::size_t n_read_ = 0;                             ///< files
  std::set<std::string> used_{};
  std::string names_{}, text_{};
  std::size_t next_ = 0;  ///< row
};

/// A line of events.csv, and when it happened.
struct EventLine {
  double time = 0.0;
  std::string text;
};

/// The cells of a split: the columns that it shares with a crack, by their names, and nothing in the others.
std::string split_cells(const model::SheetSplit& split) {
  const std::map<std::string, double> known{{"time", split.time},
                                            {"x", split.at.x},
                                            {"y", split.at.y},
                                            {"area_before", split.area_before},
                                            {"area_after", split.area_after},
                                            {"pieces", split.pieces},
                                            {"towards_x", split.towards.x},
                                            {"towards_y", split.towards.y},
                                            {"thickness", split.thickness}};
  std::string text;
  Columns<model::CrackEvent>::visit([&](const std::string& name, const auto&...) {
    if (const auto cell = known.find(name); cell != known.end()) append(text, cell->second);
    text += ',';
  });
  return text;
}

std::string events_csv(const model::RunResults& results) {
  std::vector<EventLine> lines;
  for (const model::CrackEvent& event : results.events) lines.push_back({event.time, cells(event) + "break,,,,\n"});

  for (const model::SheetSplit& split : results.splits)
    lines.push_back({split.time, split_cells(split) + "split,toughness,,,\n"});

  // The end of a floe has a time, and no crack of the sheet: the cells between stay empty.
  const std::string names = header<model::CrackEvent>();
  const std::string no_crack(static_cast<std::size_t>(std::count(names.begin(), names.end(), ',')), ',');
  for (const model::FloeRecord& floe : results.floes) {
    if (floe.end == model::FloeEnd::kAlive) continue;
    const char* const event = floe.end == model::FloeEnd::kCrushed ? "deleted,crushed" : "broken,bending";
    lines.push_back({floe.death, fmt::format("{}{}{},{},{},{}\n", floe.death, no_crack, event, floe.id, floe.area,
                                             floe.peak_stress)});
  }
  std::stable_sort(lines.begin(), lines.end(), [](const EventLine& a, const EventLine& b) { return a.time < b.time; });
  std::string text = names + "event,cause,floe,floe_area,peak_stress\n";
  for (const EventLine& line : lines) text += line.text;
  return text;
}

}  // namespace

void write_results(const std::string& directory, const model::Case& resolved, const model::RunResults& results,
                   const std::vector<std::string>& earlier) {
  const std::filesystem::path folder(directory);
  const std::string path = (folder / "run.nc").string();
  write_image(path, netcdf_image(path, resolved, results, earlier));
  write_history(directory, results, earlier);
  write_file((folder / "events.csv").string(), events_csv(results));
}

void write_history(const std::string& directory, const model::RunResults& results,
                   const std::vector<std::string>& earlier) {
  HistoryText text(results.loads, earlier);
  write_pieces((std::filesystem::path(directory) / "history.csv").string(),
               [&text](std::string_view& piece) { return text.next(piece); });
}

}  // namespace brash::io
