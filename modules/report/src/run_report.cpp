// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "blocks.hpp"
#include "brash/core/error.hpp"
#include "brash/core/version.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/case.hpp"
#include "brash/io/origin.hpp"
#include "brash/io/result_columns.hpp"
#include "brash/io/result_pieces.hpp"
#include "brash/io/results.hpp"
#include "brash/report/live.hpp"
#include "brash/report/report.hpp"
#include "brash/structure/hull.hpp"
#include "brash/structure/motion.hpp"
#include "long_history.hpp"
#include "page.hpp"

namespace brash::report {
namespace {

using nlohmann::ordered_json;
using Rings = std::vector<std::vector<Vec2>>;

// Drawn values are rounded far below the visible size; values that the user reads stay exact.
constexpr double kOutlineUnit = 1e-4;   ///< of floe outlines [m]
constexpr double kPlaceUnit = 1e-3;     ///< of poses and sheets [m]
constexpr double kAttitudeUnit = 5e-5;  ///< of quaternions; half a millimetre at 5 m
constexpr double kForceUnit = 10.0;     ///< of contact forces [N]

constexpr bool is_any(const std::string&) { return true; }

/// Whether the page draws this column of a load history: a load of the whole structure, or an area of the ledger.
bool is_drawn(const std::string& column) {
  if (column == "time" || column.starts_with("area_")) return true;
  const std::size_t from = column.size() < 2 ? 0 : column.size() - 2;
  const bool is_load = std::ranges::find(kLoadNames, column.substr(from)) != kLoadNames.end();
  return is_load && !column.starts_with("bed_");
}

/// The columns of `rows` that `is_wanted` as blocks named `of`.column; loads in single precision.
template <typename Row>
void add_columns(Blocks& blocks, const std::string& of, const std::vector<Row>& rows,
                 bool (*is_wanted)(const std::string& name) = &is_any) {
  io::visit_used(rows, [&](const std::string& name, const char*, const std::string&, auto member) {
    if (!is_wanted(name)) return;
    std::vector<double> values;
    values.reserve(rows.size());
    for (const Row& row : rows) values.push_back(static_cast<double>(member(row)));
    const bool drawn_only = std::is_same_v<Row, model::LoadRow> && name != "time";
    if (drawn_only)
      blocks.add_single(of + '.' + name, values);
    else
      blocks.add(of + '.' + name, values);
  });
}

/// Rings one after another, and how many rings each polygon has.
void add_polygons(Blocks& blocks, const std::string& name, const std::vector<const Rings*>& polygons, double unit) {
  std::vector<std::int32_t> n_rings, n_nodes;
  std::vector<double> x, y;
  for (const Rings* rings : polygons) {
    n_rings.push_back(static_cast<std::int32_t>(rings->size()));
    for (const std::vector<Vec2>& ring : *rings) {
      n_nodes.push_back(static_cast<std::int32_t>(ring.size()));
      for (const Vec2 node : ring) {
        x.push_back(node.x);
        y.push_back(node.y);
      }
    }
  }
  blocks.add(name + ".rings", n_rings);
  blocks.add(name + ".nodes", n_nodes);
  blocks.add_rounded(name + ".x", x, unit);
  blocks.add_rounded(name + ".y", y, unit);
}

constexpr std::size_t kTrackColumns = 8;
constexpr std::array<const char*, kTrackColumns> kTrackNames{"x", "y", "z", "qw", "qx", "qy", "qz", "force"};
constexpr std::array<double, kTrackColumns> kTrackUnits{kPlaceUnit,    kPlaceUnit,    kPlaceUnit,    kAttitudeUnit,
                                                        kAttitudeUnit, kAttitudeUnit, kAttitudeUnit, kForceUnit};
using RoundedPose = std::array<std::int32_t, kTrackColumns>;

RoundedPose rounded(const model::FloePose& at) {
  const auto& [p, q] = at.pose;
  const std::array<double, kTrackColumns> values{p.x, p.y, p.z, q.w, q.x, q.y, q.z, at.contact_force};
  RoundedPose pose;
  for (std::size_t i = 0; i < kTrackColumns; ++i) pose[i] = rounded_to(kTrackUnits[i], values[i]);
  return pose;
}

/// A pose of a floe in a frame.
struct TrackPose {
  std::int32_t frame;
  RoundedPose pose;
};

/// Adds a pose. A floe at rest keeps the first and the last of equal poses, between which the page interpolates.
void extend(std::vector<TrackPose>& track, const TrackPose& next) {
  const std::size_t n = track.size();
  if (n >= 2 && track[n - 1].pose == next.pose && track[n - 2].pose == next.pose)
    track.back().frame = next.frame;
  else
    track.push_back(next);
}

/// For each floe its poses one after another.
using Tracks = std::unordered_map<std::int64_t, std::vector<TrackPose>>;

/// The frames turned about: for each floe its poses one after another, with the frame of each.
void add_tracks(Blocks& blocks, const std::vector<model::FloeRecord>& floes, Tracks& tracks) {
  std::vector<std::int32_t> count, frame;
  std::array<std::vector<std::int32_t>, kTrackColumns> columns;
  for (const model::FloeRecord& floe : floes) {
    const std::vector<TrackPose>& track = tracks[floe.id];
    count.push_back(static_cast<std::int32_t>(track.size()));
    for (const TrackPose& at : track) {
      frame.push_back(at.frame);
      for (std::size_t i = 0; i < kTrackColumns; ++i) columns[i].push_back(at.pose[i]);
    }
  }
  blocks.add("track.count", count);
  blocks.add("track.frame", frame);
  for (std::size_t i = 0; i < kTrackColumns; ++i)
    blocks.add(std::string("track.") + kTrackNames[i], columns[i], kTrackUnits[i]);
}

/// The sheet at the start, after every step with cracks, and at the end.
void add_sheets(Blocks& blocks, const model::RunResults& results) {
  std::vector<double> times{0.0};
  std::vector<const Rings*> polygons{&results.initial_sheet};
  for (const model::CrackedSheet& sheet : results.cracked_sheets) {
    times.push_back(sheet.time);
    polygons.push_back(&sheet.rings);
  }
  times.push_back(results.loads.empty() ? 0.0 : results.loads.back().time);
  polygons.push_back(&results.final_sheet);
  blocks.add("sheet.time", times);
  add_polygons(blocks, "sheet", polygons, kPlaceUnit);
}

/// The pose of a load row.
Pose pose_of(const model::LoadRow& row) {
  const auto [cr, sr] = std::pair(std::cos(0.5 * row.attitude.x), std::sin(0.5 * row.attitude.x));
  const auto [cp, sp] = std::pair(std::cos(0.5 * row.attitude.y), std::sin(0.5 * row.attitude.y));
  const auto [ch, sh] = std::pair(std::cos(0.5 * row.attitude.z), std::sin(0.5 * row.attitude.z));
  return {{row.structure.x, row.structure.y, row.height},
          {ch * cp * cr + sh * sp * sr, ch * cp * sr - sh * sp * cr, ch * sp * cr + sh * cp * sr,
           sh * cp * cr - ch * sp * sr}};
}

/// Where the structure is at the end of a run, whose last frame may be older: it continues as between the last two
/// frames, and where it turns, the last load row gives its pose. Without frames it has gone where nothing resists it.
Pose pose_at_end(const model::Case& resolved, const model::RunResults& results) {
  const std::vector<model::Frame>& frames = results.frames;
  const double end = results.loads.empty() ? 0.0 : results.loads.back().time;
  if (!results.loads.empty() && results.loads.back().attitude != Vec3{}) return pose_of(results.loads.back());
  if (frames.size() < 2) return structure::unresisted(resolved.structure, end);
  const model::Frame &before = frames[frames.size() - 2], &last = frames.back();
  Pose pose = last.structure;
  const double share = std::max(0.0, end - last.time) / (last.time - before.time);
  pose.position += share * (last.structure.position - before.structure.position);
  return pose;
}

/// The structure's mesh, its waterline as it floats at rest, both in its frame, and its pose at the end.
void add_structure(Blocks& blocks, const structure::Hull& hull, const Pose& end) {
  std::vector<double> x, y, z;
  for (const Vec3 v : hull.mesh().vertices) {
    x.push_back(v.x);
    y.push_back(v.y);
    z.push_back(v.z);
  }
  std::vector<std::int32_t> corners;
  for (const auto& triangle : hull.mesh().triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
  blocks.add_rounded("mesh.x", x, kPlaceUnit);
  blocks.add_rounded("mesh.y", y, kPlaceUnit);
  blocks.add_rounded("mesh.z", z, kPlaceUnit);
  blocks.add("mesh.triangles", corners);
  const Rings waterline = hull.footprint({}, 0.0, 0.0).leading;
  add_polygons(blocks, "waterline", {&waterline}, kPlaceUnit);
  const auto& [p, q] = end;
  blocks.add("structure.end", std::vector<double>{p.x, p.y, p.z, q.w, q.x, q.y, q.z});
}

void add_land(Blocks& blocks, const std::vector<Rings>& land) {
  std::vector<const Rings*> polygons;
  for (const Rings& rings : land) polygons.push_back(&rings);
  add_polygons(blocks, "land", polygons, kPlaceUnit);
}

/// A run's results as its page needs them, which of a long run are far fewer than in its files.
struct PageResults {
  model::RunResults results;  ///< with the loads to draw, and frames without floes
  LongHistory history;
  Tracks tracks;
};

PageResults read_for_page(const std::string& path) {
  PageResults page;
  std::vector<model::Frame> frames;
  page.results =
      io::read_results(path, {.loads = [&](auto&& rows, std::size_t n) { page.history.take(std::move(rows), n); },
                              .frame =
                                  [&](model::Frame&& frame) {
                                    const auto i = static_cast<std::int32_t>(frames.size());
                                    for (const model::FloePose& at : frame.floes)
                                      extend(page.tracks[at.floe], {i, rounded(at)});
                                    frames.push_back({frame.time, frame.structure, {}});
                                  }});
  page.results.loads = page.history.drawn();
  page.results.frames = std::move(frames);
  return page;
}

void add_run(Blocks& blocks, const model::Case& resolved, PageResults& page) {
  const model::RunResults& results = page.results;
  add_structure(blocks, *structure::make_hull(resolved.structure), pose_at_end(resolved, results));
  add_columns(blocks, "load", results.loads, is_drawn);
  add_columns(blocks, "event", results.events);
  add_columns(blocks, "split", results.splits);
  add_columns(blocks, "floe", results.floes);
  add_columns(blocks, "frame", results.frames);
  std::vector<const Rings*> outlines;
  for (const model::FloeRecord& floe : results.floes) outlines.push_back(&floe.rings);
  add_polygons(blocks, "outline", outlines, kOutlineUnit);
  add_tracks(blocks, results.floes, page.tracks);
  add_sheets(blocks, results);
}

/// The run's files as JSON, its arrays in `blocks` under names that begin with `prefix`.
ordered_json run_json(const RunSource& run, const std::string& prefix, Blocks& blocks) {
  PageResults page = read_for_page(run.directory + "/run.nc");
  const ordered_json summary = read_json(run.directory + "/summary.json");
  if (!summary.is_object() || !summary.value("statistics_from", ordered_json(0.0)).is_number())
    throw InputError(Complaint{run.directory + "/summary.json", "has no number `statistics_from`",
                               "the summary.json of a run", "copy it again, or run the case again"});
  blocks.begin(prefix);
  add_run(blocks, case_of_run(run.directory), page);
  add_land(blocks, run.land);
  return {{"kind", "run"},
          {"origin", io::origin_line(io::origin_in(run.directory + "/manifest.json"))},
          {"manifest", read_json(run.directory + "/manifest.json")},
          {"summary", summary},
          {"closed_forms", ordered_json::parse(run.closed_forms)},
          {"drawn_rows", {{"n", page.results.loads.size()}, {"span", page.history.span()}}},
          {"loads", drawn_statistics(
                        ordered_json::parse(run.loads()), page.history.samples(), summary.value("statistics_from", 0.0),
                        summary.value("statistics_until", std::numeric_limits<double>::infinity()), blocks)}};
}

/// The measured history: its name and statistics as JSON, its samples as blocks.
ordered_json measured_json(const std::optional<MeasuredHistory>& measured, Blocks& blocks) {
  if (!measured) return nullptr;
  blocks.add("measured.time", measured->times);
  blocks.add_single("measured.value", measured->values);
  return {{"name", measured->name}, {"statistics", ordered_json::parse(measured->statistics)}};
}

void write_page(ordered_json data, const Blocks& blocks, const std::string& path) {
  data["format"] = "brash-report-1";
  data["schema"] = ordered_json::parse(io::case_schema());
  data["blocks"] = blocks.directory();
  write_file(path, page_with(data, blocks.packed()));
}

}  // namespace

model::Case case_of_run(const std::string& directory) {
  const std::string path = directory + "/manifest.json";
  const ordered_json manifest = read_json(path);
  try {
    const ordered_json& described = manifest.at("case");
    // Showing a case needs no failure model: its file may be gone. Its mesh lies in the folder, or in its campaign's.
    const std::filesystem::path folder = std::filesystem::absolute(directory);
    const std::filesystem::path base = std::filesystem::exists(folder / "inputs") ? folder : folder / "../..";
    return io::parse_case(described.at("toml").get<std::string>(),
                          (base / (described.at("name").get<std::string>() + ".toml")).string(), {"failure.file=''"});
  } catch (const InputError& error) {
    throw InputError(path + ": the case in it:\n" + error.what());
  } catch (const ordered_json::exception& error) {
    throw InputError(Complaint{path, std::string("holds no case: ") + error.what(), "the manifest.json of a run",
                               "copy it again, or run the case again"});
  }
}

std::string write_run_report(const RunSource& run) {
  Blocks blocks;
  ordered_json data = run_json(run, "", blocks);
  data["measured"] = measured_json(run.measured, blocks);
  const std::string path = run.directory + "/report.html";
  write_page(std::move(data), blocks, path);
  return path;
}

void write_comparison(const RunSource& run, const RunSource& other, const std::string& path) {
  Blocks blocks;
  ordered_json data = run_json(run, "", blocks);
  data["measured"] = measured_json(run.measured, blocks);
  data["other"] = run_json(other, "other.", blocks);
  write_page(std::move(data), blocks, path);
}

std::string live_page(const model::Case& resolved, const std::vector<Rings>& land) {
  Blocks blocks;
  add_land(blocks, land);
  add_structure(blocks, *structure::make_hull(resolved.structure), {});
  const ordered_json data{{"format", "brash-report-1"},
                          {"kind", "live"},
                          {"origin", io::origin_line(io::origin_of(resolved))},
                          {"manifest",
                           {{"program", {{"name", "brash"}, {"version", kVersion}}},
                            {"seeds", {{"seed", resolved.random.seed}}},
                            {"case", {{"name", resolved.name}, {"toml", io::to_toml(resolved)}}}}},
                          {"schema", ordered_json::parse(io::case_schema())},
                          {"blocks", blocks.directory()}};
  return live_page_with(data, blocks.packed());
}

}  // namespace brash::report
