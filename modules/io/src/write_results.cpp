// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>

#include "brash/core/version.hpp"
#include "brash/io/case.hpp"
#include "brash/io/result_columns.hpp"
#include "brash/io/results.hpp"
#include "result_tables.hpp"

namespace brash::io {
namespace {

std::string netcdf_bytes(const std::string& path, const model::Case& resolved, const model::RunResults& results) {
  NetcdfWriter file(path);
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

std::string history_csv(const std::vector<model::LoadRow>& loads) {
  std::set<std::string> used;
  std::string text;
  visit_used(loads, [&](const std::string& name, const auto&...) {
    used.insert(name);
    text += name + ',';
  });
  text.back() = '\n';
  for (const model::LoadRow& row : loads) {
    Columns<model::LoadRow>::visit([&](const std::string& name, const char*, const std::string&, auto member) {
      if (!used.contains(name)) return;
      append(text, member(row));
      text += ',';
    });
    text.back() = '\n';
  }
  return text;
}

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

void write_results(const std::string& directory, const model::Case& resolved, const model::RunResults& results) {
  const std::filesystem::path folder(directory);
  const std::string path = (folder / "run.nc").string();
  write_file(path, netcdf_bytes(path, resolved, results));
  write_history(directory, results);
  write_file((folder / "events.csv").string(), events_csv(results));
}

void write_history(const std::string& directory, const model::RunResults& results) {
  write_file((std::filesystem::path(directory) / "history.csv").string(), history_csv(results.loads));
}

}  // namespace brash::io
