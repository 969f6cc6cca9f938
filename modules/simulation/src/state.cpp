// SPDX-License-Identifier: GPL-3.0-or-later
#include "state.hpp"

#include <limits>

#include "brash/core/error.hpp"
#include "brash/simulation/setup.hpp"
#include "laid_floes.hpp"
#include "stages.hpp"

namespace brash::simulation {
namespace {

/// None in deep water.
std::optional<rigid_body::Bed> bed_of(const model::Case& c, double crushing_pressure) {
  if (!c.water.depth) return std::nullopt;
  return rigid_body::Bed{
      .height = -*c.water.depth, .law = {c.water.bed_friction, crushing_pressure}, .velocity = bed_past_ice(c)};
}

/// Of each level ice; none where edges do not move.
std::vector<failure::EdgeDynamics> edge_dynamics(const model::Case& c, const ice::Field& field) {
  std::vector<failure::EdgeDynamics> dynamics;
  if (c.failure.edge == model::EdgeMotion::kStatic) return dynamics;
  for (const ice::Plate& plate : field.level_ice()) {
    const ice::Plate& first = field.level_ice().front();
    if (dynamics.empty())
      dynamics.push_back(failure::make_edge_dynamics(plate.ice(), c.ice.density));
    else if (plate.ice().thickness == first.ice().thickness)
      dynamics.push_back(failure::EdgeDynamics(dynamics.front()));
    else
      dynamics.push_back(dynamics.front().of_thickness(plate.ice().thickness));
  }
  return dynamics;
}

std::optional<const floes::Coverage> coverage_of(const model::Case& c, const structure::Hull& hull,
                                                 const std::optional<const structure::Regions>& regions) {
  if (!regions || !c.structure.legs.empty()) return std::nullopt;
  return floes::Coverage(hull, *regions, c.ice.thickness);
}

}  // namespace

rigid_body::WorldSettings world_settings(const model::Case& c) {
  // The edge of level ice has its bound from edge_contacts().
  const double crushing = c.contact.crushing_bound == model::CrushingBound::kAll
                              ? c.ice.compressive_strength * c.ice.crushing_factor
                              : std::numeric_limits<double>::infinity();
  return {.ice_structure = {c.ice.friction_structure, crushing},
          .ice_ice = {c.ice.friction_ice, crushing},
          .bed = bed_of(c, crushing),
          .restitution = c.contact.restitution,
          .iterations = c.contact.iterations,
          .collision_margin = c.contact.margin,
          .release_speed = c.time.settle_speed,
          .engine = c.contact.engine == model::ContactEngine::kBullet ? rigid_body::Engine::kBullet
                                                                      : rigid_body::Engine::kBrash};
}

Laws::Laws(const model::Case& c)
    : resolved(c),
      hull(structure::make_hull(c.structure)),
      hull_reach(hull->reach()),
      regions(structure::regions_of(c.structure, *hull)),
      coverage(coverage_of(c, *hull, regions)),
      pattern(ice::make_crack_pattern(c.failure)),
      water(resolved),
      stress(c.contact) {}

State::State(const Laws& laws, ice::Field laid, Workers& workers)
    : motion(structure::make_motion(laws.resolved, *laws.hull)),
      field(std::move(laid)),
      edges(edge_dynamics(laws.resolved, field)),
      verdicts(laws.resolved.failure.lateness),
      world(world_settings(laws.resolved)),
      sheets(laws.resolved, world, field.level_ice().front().hold() == ice::Hold::kDrifting),
      floes(laws.resolved),
      sleep(laws.resolved),
      watchdog(laws.resolved, laws.hull->bounds()),
      borders(lay_borders(laws.resolved, world)),
      tiles(laws.resolved) {
  structure_body = world.add_structure(laws.hull->parts(), motion->now().pose);
  world.share_work(workers);
  for (const ice::Plate& plate : field.level_ice()) {
    add_criterion(*this, laws, plate);
    sheets.add(plate, {.velocity = drift_at_start(laws.resolved)});
  }
}

void add_criterion(State& s, const Laws& laws, const ice::Plate& plate) {
  for (std::size_t i = 0; i < s.criteria.size(); ++i) {
    const failure::IceProperties& other = s.field.level_ice()[i].ice();
    if (other.thickness != plate.ice().thickness || other.flexural_strength != plate.ice().flexural_strength) continue;
    s.criteria.push_back(std::shared_ptr(s.criteria[i]));
    return;
  }
  s.criteria.push_back(edge::make_criterion(laws.resolved, plate.ice()));
}

ice::Field field_of(const model::Case& resolved, const model::Checkpoint& checkpoint) {
  model::Case renamed = checkpoint.resolved;
  renamed.name = resolved.name;
  if (renamed != resolved)
    throw InputError(Complaint{"the checkpoint",
                               "is of case \"" + checkpoint.resolved.name + "\" with other values than this one",
                               "a checkpoint of a case with the same values",
                               "resume with the case file and the --set options of the interrupted run, or start again "
                               "without --resume"});
  return {resolved.field, edge::ice_properties(resolved), ice::Variation(resolved), checkpoint};
}

void restore(State& s, const Laws& laws, const model::Checkpoint& checkpoint) {
  model::restore(checkpoint, "progress", s);
  model::restore(checkpoint, "energy", s.energy);
  s.motion->restore(checkpoint);
  s.world.set_state(s.structure_body, s.motion->now().pose, {});
  s.sheets.restore(s.field.level_ice(), checkpoint);
  s.floes.restore(s.world, s.field.level_ice(), checkpoint);
  s.edges.restore(checkpoint);
  s.verdicts.restore(checkpoint);
  s.bearings.restore(s.floes, checkpoint);
  s.bending.restore(s.floes, checkpoint);
  s.sleep.restore(s.floes, checkpoint);
  for (const auto& [body, floe] : s.floes.floes()) lay_sheet_near(s, laws, body);  // one asleep may be run into at once
  s.watchdog.restore(s.floes, checkpoint);
}

model::Checkpoint checkpoint_of(const State& s, const Laws& laws) {
  model::Checkpoint saved{.resolved = laws.resolved, .tables = {}, .results = {}};
  model::save(saved, "progress", s);
  s.motion->save(saved);
  model::save(saved, "energy", s.energy);
  s.field.save(saved);
  s.sheets.save(saved);
  s.floes.save(s.world, saved);
  s.edges.save(saved);
  s.verdicts.save(saved);
  s.bearings.save(s.floes, saved);
  s.bending.save(s.floes, saved);
  s.sleep.save(s.floes, saved);
  s.watchdog.save(s.floes, saved);
  return saved;
}

}  // namespace brash::simulation
