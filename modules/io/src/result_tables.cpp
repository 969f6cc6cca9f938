// SPDX-License-Identifier: GPL-3.0-or-later
#include "result_tables.hpp"

#include "tables.hpp"

namespace brash::io {
namespace {

/// Outlines of floes, parallel to the rows of floes.
void write_outlines(NetcdfWriter& file, const std::vector<FloeRecord>& floes) {
  std::vector<std::vector<std::vector<Vec2>>> outlines;
  for (const FloeRecord& floe : floes) outlines.push_back(floe.rings);
  write_polygons(file, "floe_outline", "floe", {"m", "body frame of the floe"}, outlines);
}

/// The sheet after every step with cracks.
void write_cracked_sheets(NetcdfWriter& file, const std::vector<CrackedSheet>& sheets) {
  std::vector<std::vector<std::vector<Vec2>>> polygons;
  for (const CrackedSheet& sheet : sheets) polygons.push_back(sheet.rings);
  write_rows(file, sheets);
  write_polygons(file, "cracked_sheet_outline", "cracked_sheet", {"m", "sheet frame"}, polygons);
}

std::vector<CrackedSheet> read_cracked_sheets(const NetcdfReader& file) {
  std::vector<CrackedSheet> sheets = read_rows<CrackedSheet>(file);
  auto polygons = read_polygons<Vec2>(file, "cracked_sheet_outline", "cracked_sheet");
  for (std::size_t i = 0; i < sheets.size(); ++i) sheets[i].rings = std::move(polygons[i]);
  return sheets;
}

/// Poses frame after frame: a contiguous ragged array of the CF conventions.
void write_frames(NetcdfWriter& file, const std::vector<Frame>& frames) {
  std::vector<std::int32_t> counts;
  std::vector<FloePose> poses;
  for (const Frame& frame : frames) {
    counts.push_back(static_cast<std::int32_t>(frame.floes.size()));
    poses.insert(poses.end(), frame.floes.begin(), frame.floes.end());
  }
  write_rows(file, frames);
  file.variable("frame_pose_count", "frame", {"1", "number of poses of each frame", {{"sample_dimension", "pose"}}},
                counts);
  write_rows(file, poses);
}

std::vector<Frame> read_frames(const NetcdfReader& file) {
  std::vector<Frame> frames = read_rows<Frame>(file);
  std::vector<std::int32_t> counts;
  file.read("frame_pose_count", "frame", counts);
  auto poses = split(file, "frame_pose_count", read_rows<FloePose>(file), counts);
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i].floes = std::move(poses[i]);
  return frames;
}

}  // namespace

void write_tables(NetcdfWriter& file, const RunResults& results) {
  write_rows(file, results.loads);
  write_rows(file, results.events);
  write_rows(file, results.floes);
  write_outlines(file, results.floes);
  write_frames(file, results.frames);
  write_cracked_sheets(file, results.cracked_sheets);
  const NodeFrame sheet_frame{"m", "sheet frame"};
  write_rings(file, "initial_sheet", sheet_frame, results.initial_sheet);
  write_rings(file, "final_sheet", sheet_frame, results.final_sheet);
}

RunResults read_tables(const NetcdfReader& file) {
  RunResults results;
  results.loads = read_rows<LoadRow>(file);
  results.events = read_rows<CrackEvent>(file);
  results.floes = read_rows<FloeRecord>(file);
  auto outlines = read_polygons<Vec2>(file, "floe_outline", "floe");
  for (std::size_t i = 0; i < results.floes.size(); ++i) results.floes[i].rings = std::move(outlines[i]);
  results.frames = read_frames(file);
  results.cracked_sheets = read_cracked_sheets(file);
  results.initial_sheet = read_rings<Vec2>(file, "initial_sheet");
  results.final_sheet = read_rings<Vec2>(file, "final_sheet");
  return results;
}

}  // namespace brash::io
