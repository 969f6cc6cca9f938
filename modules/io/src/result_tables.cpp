// SPDX-License-Identifier: GPL-3.0-or-later
#include "result_tables.hpp"

#include "tables.hpp"

namespace brash::io {
namespace {

/// The rings of each of `owners`, for write_polygons().
template <typename Owner>
auto rings_of_each(const std::vector<Owner>& owners) {
  return [&owners](const auto& take) {
    for (const Owner& owner : owners) take(owner.rings);
  };
}

/// Floes with their outlines.
void write_floes(NetcdfWriter& file, const std::vector<model::FloeRecord>& floes) {
  write_rows(file, floes, "floe_outline");
  write_polygons<Vec2>(file, "floe_outline", "floe", {"m", "body frame of the floe"}, rings_of_each(floes));
}

/// The sheet after every step with cracks.
void write_cracked_sheets(NetcdfWriter& file, const std::vector<model::CrackedSheet>& sheets) {
  write_rows(file, sheets, "cracked_sheet_outline");
  write_polygons<Vec2>(file, "cracked_sheet_outline", "cracked_sheet", {"m", "sheet frame"}, rings_of_each(sheets));
}

std::vector<model::CrackedSheet> read_cracked_sheets(const NetcdfReader& file) {
  std::vector<model::CrackedSheet> sheets = read_rows<model::CrackedSheet>(file);
  auto polygons = read_polygons<Vec2>(file, "cracked_sheet_outline", "cracked_sheet");
  for (std::size_t i = 0; i < sheets.size(); ++i) sheets[i].rings = std::move(polygons[i]);
  return sheets;
}

/// Poses frame after frame. CF's `sample_dimension` would call the file one of a feature type, which it is not.
void write_frames(NetcdfWriter& file, const std::vector<model::Frame>& frames) {
  std::vector<std::int32_t> counts;
  std::size_t n_poses = 0;
  for (const model::Frame& frame : frames) {
    counts.push_back(static_cast<std::int32_t>(frame.floes.size()));
    n_poses += frame.floes.size();
  }
  const auto for_each_pose = [&frames](const auto& take) {
    for (const model::Frame& frame : frames)
      for (const model::FloePose& pose : frame.floes) take(pose);
  };
  file.expect_repeats("pose");
  write_rows(file, frames);
  file.variable("frame_pose_count", "frame", {"1", "number of poses of each frame, one frame after the other"}, counts);
  Columns<model::FloePose>::visit(column_writer<model::FloePose>(file, n_poses, for_each_pose));
}

std::vector<model::Frame> read_frames(const NetcdfReader& file) {
  std::vector<model::Frame> frames = read_rows<model::Frame>(file);
  std::vector<std::int32_t> counts;
  file.read("frame_pose_count", "frame", counts);
  auto poses = split(file, "frame_pose_count", read_rows<model::FloePose>(file), counts);
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i].floes = std::move(poses[i]);
  return frames;
}

}  // namespace

void write_tables(NetcdfWriter& file, const model::RunResults& results) {
  write_rows(file, results.loads);
  write_rows(file, results.events);
  if (!results.splits.empty()) write_rows(file, results.splits);
  write_floes(file, results.floes);
  write_frames(file, results.frames);
  write_cracked_sheets(file, results.cracked_sheets);
  const NodeFrame sheet_frame{"m", "sheet frame"};
  write_rings(file, "initial_sheet", sheet_frame, results.initial_sheet);
  write_rings(file, "final_sheet", sheet_frame, results.final_sheet);
}

model::RunResults read_tables(const NetcdfReader& file) {
  model::RunResults results;
  results.loads = read_rows<model::LoadRow>(file);
  results.events = read_rows<model::CrackEvent>(file);
  if (file.has("split_time")) results.splits = read_rows<model::SheetSplit>(file);
  results.floes = read_rows<model::FloeRecord>(file);
  auto outlines = read_polygons<Vec2>(file, "floe_outline", "floe");
  for (std::size_t i = 0; i < results.floes.size(); ++i) results.floes[i].rings = std::move(outlines[i]);
  results.frames = read_frames(file);
  results.cracked_sheets = read_cracked_sheets(file);
  results.initial_sheet = read_rings<Vec2>(file, "initial_sheet");
  results.final_sheet = read_rings<Vec2>(file, "final_sheet");
  return results;
}

}  // namespace brash::io
