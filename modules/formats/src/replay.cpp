// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/formats/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/io/recorded_case.hpp"
#include "brash/io/results.hpp"

namespace brash::formats {
namespace {

using geometry::IceSheet;

auto sheet_of(const geometry::Polygon& polygon) { return IceSheet::from_polygons(std::span(&polygon, 1)); }

/// Refuses polygons that cannot be drawn, before anything is written. Sheets that drift may overlap.
void check_polygons(const std::string& run_file, const model::RunResults& results) {
  const auto check = [&](const std::string& of, std::span<const std::vector<Vec2>> rings) {
    const std::vector<geometry::Polygon> polygons = polygons_of(rings);
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      const auto sheet = sheet_of(polygons[i]);
      if (sheet) continue;
      constexpr std::string_view kAlone = "polygon 0 ";  // its number among those that were looked at together
      std::string what = sheet.error().what;
      if (what.starts_with(kAlone)) what.replace(0, kAlone.size(), fmt::format("polygon {} ", i));
      throw InputError(Complaint{fmt::format("{}, {}", run_file, of), what, "polygons that do not cross themselves",
                                 "copy the run.nc again, or run the case again"});
    }
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
  // Neither the failure model nor the files of the ice are needed: they may be gone.
  replay.resolved =
      io::parse_recorded_case(io::read_case_of(run_file), run_file, {"failure.file=''"}, io::ModelFile::kInItsFolder);
  check_polygons(run_file, replay.results);
  replay.hull = structure::make_hull(replay.resolved.structure);
  return replay;
}

SheetReplay::SheetReplay(const Replay& replay) : replay_(replay) { take(replay.results.initial_sheet); }

std::vector<geometry::Polygon> SheetReplay::at(const model::Frame& frame) {
  const auto& cracked = replay_.results.cracked_sheets;
  const std::size_t before = next_;
  while (next_ < cracked.size() && cracked[next_].time <= frame.time) ++next_;
  has_cracked_ = next_ > before;
  const auto& loads = replay_.results.loads;
  if (!loads.empty() && frame.time >= loads.back().time) return polygons_of(replay_.results.final_sheet);
  if (has_cracked_) take(cracked[next_ - 1].rings);
  const structure::Footprint footprint = replay_.hull->footprint(frame.structure, 0.0, 0.0);
  std::vector<geometry::Polygon> all;
  for (IceSheet& sheet : sheets_) {
    for (const structure::Outline& outline : footprint.leading) sheet.crush(geometry::ring(outline));
    sheet.release_detached();
    std::ranges::move(sheet.polygons(), std::back_inserter(all));
  }
  return all;
}

void SheetReplay::take(std::span<const std::vector<Vec2>> rings) {
  sheets_.clear();
  for (const geometry::Polygon& polygon : polygons_of(rings)) {
    auto sheet = sheet_of(polygon);
    BRASH_EXPECTS(sheet.has_value(), sheet.error().what);
    sheets_.push_back(*std::move(sheet));
  }
}

double thickness_of(const model::FloeRecord& floe, const model::Case& resolved) {
  return floe.thickness > 0.0 ? floe.thickness : resolved.ice.thickness;
}

std::vector<geometry::Polygon> polygons_of(std::span<const std::vector<Vec2>> rings) {
  std::vector<geometry::Polygon> polygons;
  for (const std::vector<Vec2>& vertices : rings) {
    geometry::Ring ring;
    for (const Vec2 v : vertices) ring.push_back(geometry::snap(v));
    if (polygons.empty() || geometry::signed_area(ring) > geometry::ExactArea{})
      polygons.push_back({std::move(ring), {}});
    else
      polygons.back().holes.push_back(std::move(ring));
  }
  return polygons;
}

}  // namespace brash::formats
