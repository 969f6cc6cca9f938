// SPDX-License-Identifier: GPL-3.0-or-later
#include "laid_floes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <utility>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/edge/drifting_sheets.hpp"
#include "brash/edge/edge_contact.hpp"
#include "brash/floes/plan.hpp"
#include "brash/geometry/text.hpp"
#include "brash/ice/floe_field.hpp"
#include "brash/ice/floe_file.hpp"
#include "brash/model/case_keys.hpp"
#include "brash/simulation/initial_floes.hpp"
#include "brash/structure/motion.hpp"

namespace brash::simulation {
namespace {

using geometry::Polygon;
using geometry::Ring;

/// The plan of the structure within the ice at the start.
std::vector<Ring> structure_at_start(const model::Case& resolved, const structure::Hull& hull) {
  const edge::Freeboard heights = edge::freeboard(resolved);
  const Pose start = structure::unresisted(resolved.structure, 0.0);
  std::vector<Ring> rings;
  for (const structure::Outline& outline : hull.footprint(start, heights.bottom, heights.top).leading)
    rings.push_back(geometry::ring(outline));
  return rings;
}

/// Refuses ice under `window`; `what` is the fault then.
void expect_clear(const geometry::IceSheet& ice, const Ring& window, const std::string& where, const std::string& what,
                  const std::string& remedy) {
  const std::vector<Polygon> under = ice.within(window);
  if (under.empty()) return;
  const Vec2 at = geometry::centroid(under.front());
  throw InputError(
      Complaint{where, fmt::format("{}, at ({:.6g}, {:.6g}) m", what, at.x, at.y), "open water there", remedy});
}

/// Level ice of files does not lie under the structure at the start, nor do its floes.
void expect_clear_start(const model::Case& resolved, const structure::Hull& hull,
                        const std::vector<Polygon>& outlines) {
  std::string files;
  model::visit_files_of_field(resolved.field, [&](const char* key, const std::string& file) {
    if (!file.empty()) files += fmt::format("{}field.{} = {}", files.empty() ? "" : ", ", key, file);
  });
  for (const Polygon& outline : outlines) {
    const geometry::IceSheet ice = geometry::checked_sheet({&outline, 1});
    for (const Ring& ring : structure_at_start(resolved, hull))
      expect_clear(ice, ring, files, "the structure starts inside the ice",
                   "change structure.start_distance, or take the ice away there");
  }
}

/// The land of the shore, in convex parts.
std::vector<Ring> land_of(const model::Case& resolved) {
  std::vector<Ring> land;
  if (resolved.field.shore.empty()) return land;
  for (const Polygon& outline : ice::read_outlines(resolved.field.shore, resolved.field.origin))
    for (Ring& part : geometry::convex_parts(outline)) land.push_back(std::move(part));
  return land;
}

std::vector<ice::GivenFloe> floes_of_file(const model::Case& resolved, const std::vector<Ring>& structure) {
  const std::string& file = resolved.field.file;
  std::vector<ice::GivenFloe> floes = ice::read_floes(file, resolved.field);
  std::vector<Polygon> outlines;
  for (const ice::GivenFloe& floe : floes) outlines.push_back(floe.outline);
  const geometry::IceSheet all = geometry::checked_sheet(outlines);
  for (const Ring& ring : structure)
    expect_clear(all, ring, file, "the structure starts inside a floe",
                 "change structure.start_distance, or remove the floe");
  for (const Ring& land : land_of(resolved))
    expect_clear(all, land, file, "a floe lies on the land of field.shore", "move or cut the floe, or the shore");
  return floes;
}

std::vector<ice::GivenFloe> packed_floes(const model::Case& resolved, const std::vector<Ring>& keep_out) {
  auto packing =
      ice::pack_floes(resolved.field, keep_out, {resolved.random.seed, resolved.random.replicate, "floe-field"});
  if (!packing) {
    const ice::FloeFieldError& error = packing.error();
    throw InputError(Complaint{fmt::format("{} = {}", error.key, resolved.field.floes.concentration.value_or(0.0)),
                               error.what, error.allowed, error.remedy});
  }
  std::vector<ice::GivenFloe> floes;
  for (Polygon& outline : packing->floes) floes.push_back({std::move(outline), {}, {}});
  return floes;
}

void lay_floes_of(const model::Case& resolved, ice::Field& field) {
  std::vector<Ring> keep_out = structure_at_start(resolved, *structure::make_hull(resolved.structure));
  const bool from_file = !resolved.field.file.empty();
  if (!from_file) std::ranges::move(land_of(resolved), std::back_inserter(keep_out));
  std::vector<ice::Plate> plates, floes;
  const failure::IceProperties ice = edge::ice_properties(resolved);
  const bool may_drift = resolved.contact.engine == model::ContactEngine::kBrash;
  for (ice::GivenFloe& floe : from_file ? floes_of_file(resolved, keep_out) : packed_floes(resolved, keep_out)) {
    const auto of_file = [&](failure::IceProperties own) {
      own.thickness = floe.thickness.value_or(own.thickness);
      own.flexural_strength = floe.flexural_strength.value_or(own.flexural_strength);
      return own;
    };
    const failure::IceProperties own = of_file(ice), mean = of_file(field.variation().mean(ice, floe.outline));
    std::vector outline{std::move(floe.outline)};
    if (may_drift && edge::is_plate(outline, own, resolved.field.smallest_plate))
      plates.emplace_back(static_cast<int>(plates.size()), ice::Hold::kDrifting, own, std::move(outline));
    else
      floes.emplace_back(0, ice::Hold::kAfloat, mean, std::move(outline));
  }
  field.lay_floes(std::move(plates), std::move(floes));
}

/// Height of a border, in thicknesses of the ice.
constexpr double kBorderHeight = 30.0;
/// Thickness of a wall [m]: a floe crosses no such way in a step.
constexpr double kWallThickness = 10.0;

std::vector<Vec2> box(Vec2 lower, Vec2 upper) { return {lower, {upper.x, lower.y}, upper, {lower.x, upper.y}}; }

}  // namespace

ice::Field laid_field(const model::Case& resolved) {
  ice::Field field(resolved.field, edge::ice_properties(resolved), ice::Variation(resolved));
  if (resolved.field.kind == model::FieldKind::kFloes) lay_floes_of(resolved, field);
  return field;
}

Vec2 drift_at_start(const model::Case& resolved) {
  return resolved.field.kind == model::FieldKind::kFloes ? resolved.water.current : Vec2{};
}

std::vector<ice::Plate> floes_beside(const model::Case& resolved, const structure::Hull& hull, ice::Field& field) {
  std::vector<ice::Plate> floes = field.take_loose();
  const bool of_field = resolved.field.kind == model::FieldKind::kFloes;  // it has kept clear
  if (of_field || !model::has_ice_files(resolved.field)) return floes;
  std::vector<Polygon> outlines = field.outlines();
  for (const ice::Plate& floe : floes) outlines.push_back(floe.outline().front());
  expect_clear_start(resolved, hull, outlines);
  return floes;
}

std::vector<std::vector<std::vector<Vec2>>> land_outlines(const model::Case& resolved) {
  std::vector<std::vector<std::vector<Vec2>>> land;
  if (resolved.field.shore.empty()) return land;
  for (const Polygon& outline : ice::read_outlines(resolved.field.shore, resolved.field.origin))
    land.push_back(floes::rings_in_metres(outline));
  return land;
}

double open_water(const model::Case& resolved) {
  const double length = resolved.field.length, half = 0.5 * resolved.field.width;
  if (resolved.field.shore.empty()) return length * resolved.field.width;
  const std::vector<Vec2> corners{{0.0, -half}, {length, -half}, {length, half}, {0.0, half}};
  const Polygon rectangle{geometry::ring(corners), {}};
  auto water = geometry::IceSheet::from_polygons(std::span(&rectangle, 1));
  BRASH_EXPECTS(water.has_value(), length, half);
  for (const Ring& land : land_of(resolved)) (void)water->cut(land);
  return water->area().square_metres();
}

InitialField initial_field(const model::Case& resolved) {
  InitialField start;
  start.land = land_outlines(resolved);
  const auto hull = structure::make_hull(resolved.structure);
  ice::Field field = laid_field(resolved);
  const std::vector<ice::Plate> floes = floes_beside(resolved, *hull, field);
  for (const ice::Plate& plate : floes)
    for (const Polygon& outline : plate.outline()) {
      start.floes.push_back(floes::rings_in_metres(outline));
      start.area += geometry::area(outline).square_metres();
    }
  for (const Polygon& outline : field.outlines()) {
    start.sheets.push_back(floes::rings_in_metres(outline));
    start.sheet_area += geometry::area(outline).square_metres();
  }
  return start;
}

double border_height(const model::Case& resolved) { return kBorderHeight * resolved.ice.thickness; }

std::vector<geometry::Extent> lay_borders(const model::Case& resolved, rigid_body::World& world) {
  std::vector<geometry::Extent> boxes;
  const auto lay = [&](const std::vector<Vec2>& ring, double height) {
    world.add_sheet_part(ring, -height, height);
    boxes.emplace_back();
    for (const Vec2 corner : ring) boxes.back().add(corner);
  };
  const double length = resolved.field.length, half = 0.5 * resolved.field.width;
  const double height = border_height(resolved);
  const bool has_floes = resolved.field.kind == model::FieldKind::kFloes;
  if (has_floes && resolved.field.floes.border == model::FloeBorder::kWalls) {
    for (const auto& wall : {box({0.0, -half - kWallThickness}, {length + kWallThickness, -half}),
                             box({0.0, half}, {length + kWallThickness, half + kWallThickness}),
                             box({length, -half}, {length + kWallThickness, half})})
      lay(wall, height);
  }
  if (resolved.field.shore.empty()) return boxes;
  for (const geometry::Polygon& land : ice::read_outlines(resolved.field.shore, resolved.field.origin))
    for (const geometry::Ring& part : geometry::convex_parts(land)) lay(floes::to_metres(part), height);
  return boxes;
}

}  // namespace brash::simulation
