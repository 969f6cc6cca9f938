// SPDX-License-Identifier: GPL-3.0-or-later
#include "result_tables.hpp"

#include <algorithm>
#include <iterator>

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

/// Rows that are read together.
constexpr std::size_t kPiece = 1 << 14;

void read_loads(const NetcdfReader& file, const ResultPieces& pieces) {
  const std::size_t n = file.length(Columns<model::LoadRow>::dimension);
  for (std::size_t first = 0; first < n; first += kPiece)
    pieces.loads(read_rows<model::LoadRow>(file, first, std::min(kPiece, n - first)), n);
  // Also a table without rows has its columns.
  if (n == 0) read_rows<model::LoadRow>(file);
}

void read_frames(const NetcdfReader& file, const ResultPieces& pieces) {
  std::vector<model::Frame> frames = read_rows<model::Frame>(file);
  std::vector<std::int32_t> counts;
  file.read("frame_pose_count", "frame", counts);
  const std::size_t n_poses = file.length(Columns<model::FloePose>::dimension);
  const auto refuse = [&file] { file.refuse("frame_pose_count: the counts do not add up"); };
  std::size_t next = 0;  // pose
  std::vector<model::FloePose> poses;
  auto pose = poses.begin();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto left = static_cast<std::size_t>(poses.end() - pose);
    if (counts[i] < 0 || static_cast<std::size_t>(counts[i]) > left + (n_poses - next)) refuse();
    const auto count = static_cast<std::size_t>(counts[i]);
    if (count > left) {  // the poses of this frame, and of more
      std::vector<model::FloePose> more(pose, poses.end());
      const std::size_t n = std::min(std::max(kPiece, count - left), n_poses - next);
      const std::vector<model::FloePose> read = read_rows<model::FloePose>(file, next, n);
      more.insert(more.end(), read.begin(), read.end());
      poses = std::move(more);
      pose = poses.begin();
      next += n;
    }
    model::Frame next_frame = std::move(frames[i]);  // whoever takes it may leave its poses behind
    next_frame.floes.assign(pose, pose + counts[i]);
    pose += counts[i];
    pieces.frame(std::move(next_frame));
  }
  if (pose != poses.end() || next != n_poses) refuse();
  if (n_poses == 0) read_rows<model::FloePose>(file);
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

ResultPieces all_of(std::vector<model::LoadRow>& loads, std::vector<model::Frame>& frames) {
  return {.loads =
              [&loads](std::vector<model::LoadRow>&& rows, std::size_t n) {
                if (rows.size() == n) return loads.swap(rows);
                loads.reserve(n);
                std::ranges::move(rows, std::back_inserter(loads));
              },
          .frame = [&frames](model::Frame&& frame) { frames.push_back(std::move(frame)); }};
}

model::RunResults read_tables(const NetcdfReader& file) {
  std::vector<model::LoadRow> loads;
  std::vector<model::Frame> frames;
  model::RunResults results = read_tables(file, all_of(loads, frames), [](const model::RunResults&) {});
  results.loads = std::move(loads);
  results.frames = std::move(frames);
  return results;
}

model::RunResults read_tables(const NetcdfReader& file, const ResultPieces& pieces,
                              const std::function<void(const model::RunResults&)>& begin) {
  model::RunResults results;
  results.events = read_rows<model::CrackEvent>(file);
  if (file.has("split_time")) results.splits = read_rows<model::SheetSplit>(file);
  results.floes = read_rows<model::FloeRecord>(file);
  auto outlines = read_polygons<Vec2>(file, "floe_outline", "floe");
  for (std::size_t i = 0; i < results.floes.size(); ++i) results.floes[i].rings = std::move(outlines[i]);
  results.cracked_sheets = read_cracked_sheets(file);
  results.initial_sheet = read_rings<Vec2>(file, "initial_sheet");
  results.final_sheet = read_rings<Vec2>(file, "final_sheet");
  begin(results);
  read_loads(file, pieces);
  read_frames(file, pieces);
  return results;
}

}  // namespace brash::io
