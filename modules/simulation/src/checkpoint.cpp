// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/model/checkpoint.hpp"

#include "brash/core/error.hpp"
#include "simulation_impl.hpp"

namespace brash::simulation {
namespace {

/// The ice of `checkpoint`, once it is known to be of this case.
ice::Field field_of(const model::Case& resolved, const model::Checkpoint& checkpoint) {
  model::Case renamed = checkpoint.resolved;
  renamed.name = resolved.name;
  if (renamed == resolved && renamed != checkpoint.resolved)
    throw InputError(Complaint{"the checkpoint",
                               "is of case \"" + checkpoint.resolved.name + "\", and this one has the name \"" +
                                   resolved.name + "\", which its random numbers depend on",
                               "a checkpoint of a case with the same name", "give the case file its old name"});
  if (checkpoint.resolved != resolved)
    throw InputError(Complaint{"the checkpoint",
                               "is of case \"" + checkpoint.resolved.name + "\" with other values than this one",
                               "a checkpoint of this case with the same values",
                               "resume with the case file and the --set options of the interrupted run, or start again "
                               "without --resume"});
  return {resolved.field, ice_properties(resolved), ice::Variation(resolved), checkpoint};
}

}  // namespace

Simulation::Impl::Impl(const model::Case& c, const model::Checkpoint& checkpoint, int threads)
    : Impl(c, field_of(c, checkpoint), threads) {
  model::restore(checkpoint, "progress", *this);
  model::restore(checkpoint, "energy", energy);
  motion->restore(checkpoint);
  world.set_state(structure_body, motion->now().pose, {});
  sheets.restore(field.level_ice(), checkpoint);
  floes.restore(world, field.level_ice(), checkpoint);
  edges.restore(checkpoint);
  verdicts.restore(checkpoint);
  bearings.restore(floes, checkpoint);
  bending.restore(floes, checkpoint);
  sleep.restore(floes, checkpoint);
  for (const auto& [body, floe] : floes.floes()) lay_sheet_near(body);  // one asleep may be run into at once
  watchdog.restore(floes, checkpoint);
}

model::Checkpoint Simulation::Impl::checkpoint() const {
  model::Checkpoint saved{.resolved = resolved, .tables = {}, .results = {}};
  model::save(saved, "progress", *this);
  motion->save(saved);
  model::save(saved, "energy", energy);
  field.save(saved);
  sheets.save(saved);
  floes.save(world, saved);
  edges.save(saved);
  verdicts.save(saved);
  bearings.save(floes, saved);
  bending.save(floes, saved);
  sleep.save(floes, saved);
  watchdog.save(floes, saved);
  return saved;
}

}  // namespace brash::simulation
