// SPDX-License-Identifier: GPL-3.0-or-later
#include "laid_floes.hpp"

#include <fmt/format.h>

#include <utility>

#include "brash/core/error.hpp"
#include "brash/ice/floe_field.hpp"
#include "brash/ice/floe_file.hpp"
#include "brash/simulation/initial_floes.hpp"
#include "brash/structure/motion.hpp"
#include "edge_contact.hpp"
#include "plan.hpp"
#include "simulation_impl.hpp"

namespace brash::simulation {
namespace {

using geometry::Polygon;
using geometry::Ring;

/// The plan of the structure within the ice at the start.
std::vector<Ring> structure_at_start(const model::Case& resolved, const structure::Hull& hull) {
  const Freeboard heights = freeboard(resolved);
  const Pose start = structure::unresisted(resolved.structure, 0.0);
  std::vector<Ring> rings;
  for (const structure::Outline& outline : hull.footprint(start, heights.bottom, heights.top).leading)
    rings.push_back(geometry::ring(outline));
  return rings;
}

/// Refuses ice under `window`, which is `name`.
void expect_clear(const geometry::IceSheet& ice, const Ring& window, const std::string& where, const std::string& name,
                  const std::string& remedy) {
  const std::vector<Polygon> under = ice.within(window);
  if (under.empty()) return;
  const Vec2 at = geometry::centroid(under.front());
  throw InputError(Complaint{where, fmt::format("{} starts inside a floe, at ({:.6g}, {:.6g}) m", name, at.x, at.y),
                             "open water there", remedy});
}

std::vector<ice::GivenFloe> floes_of_file(const model::Case& resolved, const std::vector<Ring>& structure) {
  const std::string& file = resolved.field.floes.file;
  std::vector<ice::GivenFloe> floes = ice::read_floes(file, resolved.field);
  std::vector<Polygon> outlines;
  for (const ice::GivenFloe& floe : floes) outlines.push_back(floe.outline);
  const auto all = geometry::IceSheet::from_polygons(outlines);
  for (const Ring& ring : structure)
    expect_clear(*all, ring, file, "the structure", "change structure.start_distance, or remove the floe");
  return floes;
}

std::vector<ice::GivenFloe> packed_floes(const model::Case& resolved, const std::vector<Ring>& keep_out) {
  auto packing = ice::pack_floes(resolved.field, keep_out,
                                 {resolved.random.seed, resolved.name, resolved.random.replicate, "floe-field"});
  if (!packing) {
    const ice::FloeFieldError& error = packing.error();
    throw InputError(Complaint{fmt::format("{} = {}", error.key, resolved.field.floes.concentration.value_or(0.0)),
                               error.what, error.allowed, error.remedy});
  }
  std::vector<ice::GivenFloe> floes;
  for (Polygon& outline : packing->floes) floes.push_back({std::move(outline), {}, {}});
  return floes;
}

/// The land of the shore, which generated floes keep clear of and given ones may not meet.
std::vector<Ring> land_of(const model::Case& resolved) {
  std::vector<Ring> land;
  if (resolved.field.floes.shore.empty()) return land;
  for (const Polygon& outline : ice::read_outlines(resolved.field.floes.shore))
    for (Ring& part : geometry::convex_parts(outline)) land.push_back(std::move(part));
  return land;
}

}  // namespace

std::vector<ice::Plate> laid_floes(const model::Case& resolved, const structure::Hull& hull,
                                   const ice::Variation& variation) {
  std::vector<Ring> keep_out = structure_at_start(resolved, hull);
  const bool from_file = !resolved.field.floes.file.empty();
  for (Ring& part : land_of(resolved)) keep_out.push_back(std::move(part));
  std::vector<ice::Plate> plates;
  const failure::IceProperties ice = ice_properties(resolved);
  for (ice::GivenFloe& floe : from_file ? floes_of_file(resolved, keep_out) : packed_floes(resolved, keep_out)) {
    failure::IceProperties own = variation.mean(ice, floe.outline);
    own.thickness = floe.thickness.value_or(own.thickness);
    own.flexural_strength = floe.flexural_strength.value_or(own.flexural_strength);
    plates.emplace_back(0, ice::Hold::kAfloat, own, std::vector{std::move(floe.outline)});
  }
  return plates;
}

InitialField initial_field(const model::Case& resolved) {
  InitialField field;
  if (resolved.field.kind != model::FieldKind::kFloes) return field;
  const auto hull = structure::make_hull(resolved.structure.shape);
  for (const ice::Plate& plate : laid_floes(resolved, *hull, ice::Variation(resolved)))
    for (const Polygon& outline : plate.outline()) {
      field.floes.push_back(rings_in_metres(outline));
      field.area += geometry::area(outline).square_metres();
    }
  return field;
}

/// Floes drift with the water that they begin in: docs/theory/floe-fields.md, (F7).
void Simulation::Impl::lay_floes() {
  const structure::State drift{{}, {{resolved.water.current.x, resolved.water.current.y, 0.0}, {}}};
  for (ice::Plate& plate : laid_floes(resolved, *hull, field.variation())) {
    field.add_floe(plate);
    auto record = floes.add(world, std::move(plate), 0.0, drift);
    if (record)
      initial_births.push_back(std::move(*record));
    else
      field.to_brash(plate);
  }
}

}  // namespace brash::simulation
