// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <span>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/formats/maps.hpp"

namespace brash::formats {
namespace {

/// The frame at a time, or the last one before it. The time of a frame is a product, which a written number may miss.
std::size_t frame_at(const Replay& run, double time) {
  constexpr double kRounding = 1e-9;  // [s]
  const std::vector<model::Frame>& frames = run.results.frames;
  const auto after = std::ranges::upper_bound(frames, time + kRounding, {}, &model::Frame::time);
  if (after != frames.begin()) return static_cast<std::size_t>(after - frames.begin()) - 1;
  throw InputError(Complaint{fmt::format("--time={}", time), "is before the first frame of the run",
                             frames.empty() ? "a run with frames (output.frames_per_second)"
                                            : fmt::format("{} s or later", frames.front().time),
                             frames.empty() ? "run it again with frames" : "raise it"});
}

/// A floe laid flat where it is, in the heading that is nearest to its attitude.
std::optional<geometry::Polygon> laid_flat(const model::FloeRecord& floe, const Pose& pose) {
  const Vec2 along = plan(rotate(pose.rotation, {1.0, 0.0, 0.0})),
             across = plan(rotate(pose.rotation, {0.0, 1.0, 0.0}));
  const Vec2 nearest{along.x + across.y, along.y - across.x};  // of all rotations, by least squares
  const Vec2 heading = norm(nearest) > 0.0 ? normalized(nearest) : Vec2{1.0, 0.0};
  std::vector<std::vector<Vec2>> rings = floe.rings;
  for (std::vector<Vec2>& ring : rings)
    for (Vec2& p : ring)
      p = plan(pose.position) + Vec2{p.x * heading.x - p.y * heading.y, p.x * heading.y + p.y * heading.x};
  std::vector<geometry::Polygon> polygons = polygons_of(rings);
  if (!geometry::IceSheet::from_polygons(polygons)) return std::nullopt;  // the grid has closed a notch
  return std::move(polygons.front());
}

/// The member `crs` of the map that the ice came from, where that file is still there.
std::string crs_of(const std::string& file) {
  if (file.empty() || !std::filesystem::is_regular_file(file)) return {};
  const auto map = geometry::read_map(read_characters(file, "file of the ice", kMostMebibytes));
  return map ? map->crs : std::string{};
}

}  // namespace

geometry::Map ice_map(const Replay& run, double time) {
  const std::size_t wanted = frame_at(run, time);
  SheetReplay sheets(run);
  std::vector<geometry::Polygon> level_ice;
  for (std::size_t i = 0; i <= wanted; ++i) level_ice = sheets.at(run.results.frames[i]);

  geometry::Map map;
  map.origin = geometry::origin_from_metres(run.resolved.field.origin);
  map.crs = crs_of(run.resolved.field.file);
  std::map<std::int64_t, const model::FloeRecord*> records;
  for (const model::FloeRecord& floe : run.results.floes) records[floe.id] = &floe;
  std::int64_t next_id = records.empty() ? 0 : records.rbegin()->first + 1;  // that no floe has in any frame
  for (geometry::Polygon& polygon : level_ice) map.features.push_back({std::move(polygon), "sheet", next_id++});
  for (const model::FloePose& floe : run.results.frames[wanted].floes) {
    const model::FloeRecord& record = *records.at(floe.floe);
    if (auto polygon = laid_flat(record, floe.pose))
      map.features.push_back({std::move(*polygon), "floe", floe.floe, record.thickness});
  }
  return map;
}

}  // namespace brash::formats
