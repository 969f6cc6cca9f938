// SPDX-License-Identifier: GPL-3.0-or-later
#include "replay.hpp"

#include <fmt/format.h>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "brash/io/results.hpp"
#include "vtk_meshes.hpp"

namespace brash::cli {
namespace {

using geometry::IceSheet;

/// Refuses polygons that cannot be drawn, before anything is written.
void check_polygons(const std::string& run_file, const model::RunResults& results) {
  const auto check = [&](const std::string& of, std::span<const std::vector<Vec2>> rings) {
    const auto sheet = IceSheet::from_polygons(polygons_of(rings));
    if (sheet) return;
    throw InputError(Complaint{fmt::format("{}, {}", run_file, of), sheet.error().what,
                               "polygons that neither cross nor overlap",
                               "copy the run.nc again, or run the case again"});
  };
  check("initial_sheet", results.initial_sheet);
  check("final_sheet", results.final_sheet);
  for (const model::CrackedSheet& sheet : results.cracked_sheets)
    check(fmt::format("the sheet cracked at {} s", sheet.time), sheet.rings);
  for (const model::FloeRecord& floe : results.floes) check(fmt::format("floe {}", floe.id), floe.rings);
}

}  // namespace

Replay read_replay(const std::string& run_file) {
  Replay replay;
  replay.results = io::read_results(run_file);
  // The failure model is not needed: its file may be gone.
  replay.resolved = io::parse_case(io::read_case_of(run_file), run_file, {"failure.file=''"});
  check_polygons(run_file, replay.results);
  replay.hull = structure::make_hull(replay.resolved.structure.shape);
  return replay;
}

SheetReplay::SheetReplay(const Replay& replay) : replay_(replay) { take(replay.results.initial_sheet); }

std::vector<geometry::Polygon> SheetReplay::at(const model::Frame& frame) {
  const auto& cracked = replay_.results.cracked_sheets;
  const std::size_t before = next_;
  while (next_ < cracked.size() && cracked[next_].time <= frame.time) ++next_;
  has_cracked_ = next_ > before;
  if (&frame == &replay_.results.frames.back()) return polygons_of(replay_.results.final_sheet);
  if (has_cracked_) take(cracked[next_ - 1].rings);
  for (const structure::Outline& outline : replay_.hull->footprint(frame.structure, 0.0, 0.0).leading)
    sheet_->cut(geometry::ring(outline));
  sheet_->release_detached();
  return sheet_->polygons();
}

void SheetReplay::take(std::span<const std::vector<Vec2>> rings) {
  auto sheet = IceSheet::from_polygons(polygons_of(rings));
  BRASH_EXPECTS(sheet.has_value(), sheet.error().what);
  sheet_ = std::make_unique<IceSheet>(*std::move(sheet));
}

io::PolyData sheet_surface(const model::Case& resolved, const std::vector<geometry::Polygon>& polygons) {
  io::PolyData data;
  const double top = resolved.ice.thickness * (1.0 - resolved.ice.density / resolved.water.density);
  for (const geometry::Polygon& polygon : polygons) add_prism(data, polygon, top - resolved.ice.thickness, top);
  return data;
}

io::PolyData mesh_surface(const structure::TriangleMesh& mesh, const Pose& pose) {
  io::PolyData data;
  for (const Vec3& vertex : mesh.vertices) data.points.push_back(to_world(pose, vertex));
  for (const auto& [a, b, c] : mesh.triangles) data.faces.push_back({a, b, c});
  return data;
}

}  // namespace brash::cli
