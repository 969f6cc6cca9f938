// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/model/checkpoint.hpp"

#include "brash/core/error.hpp"
#include "simulation_impl.hpp"

namespace brash::simulation {
namespace {

/// The ice of `checkpoint`, once it is known to be of this case.
ice::Field field_of(const model::Case& resolved, const model::Checkpoint& checkpoint) {
  if (checkpoint.resolved != resolved)
    throw InputError(Complaint{"the checkpoint",
                               "is of case \"" + checkpoint.resolved.name + "\" with other values than this one",
                               "a checkpoint of this case with the same values",
                               "resume with the case file and the --set options of the interrupted run, or start again "
                               "without --resume"});
  return {resolved.field, ice_properties(resolved), checkpoint};
}

/// The state of the structure's motion, a column for each number.
model::Table saved_motion(const structure::Motion& motion) {
  structure::Numbers numbers;
  motion.save(numbers);
  model::Table table{"structure", {}};
  model::SavedRow row(table);
  for (const auto& [name, number] : numbers) row(name, "1", "motion of the structure, SI", number);
  return table;
}

void restore_motion(structure::Motion& motion, const model::Table& table) {
  structure::Numbers numbers;
  model::RestoredRow row(table, 0);
  for (const model::Column& column : table.columns) row(column.name, "", "", numbers[column.name]);
  motion.restore(numbers);
}

}  // namespace

Simulation::Impl::Impl(const model::Case& c, const model::Checkpoint& checkpoint) : Impl(c, field_of(c, checkpoint)) {
  model::restore(checkpoint, "progress", *this);
  model::restore(checkpoint, "energy", energy);
  restore_motion(*motion, checkpoint.table("structure"));
  world.set_state(structure_body, motion->now().pose, {});
  floes.restore(world, field.level_ice(), checkpoint);
  bearings.restore(floes, checkpoint);
  sleep.restore(floes, checkpoint);
  for (const auto& [body, floe] : floes.floes()) lay_sheet_near(body);  // one asleep may be run into at once
  begin_watch();
}

model::Checkpoint Simulation::Impl::checkpoint() const {
  model::Checkpoint saved{.resolved = resolved, .tables = {}, .results = {}};
  model::save(saved, "progress", *this);
  saved.tables.push_back(saved_motion(*motion));
  model::save(saved, "energy", energy);
  field.save(saved);
  floes.save(world, saved);
  bearings.save(floes, saved);
  sleep.save(floes, saved);
  return saved;
}

}  // namespace brash::simulation
