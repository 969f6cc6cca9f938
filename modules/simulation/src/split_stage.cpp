// SPDX-License-Identifier: GPL-3.0-or-later
// The stage of a step in which floes break again.
#include <utility>

#include "brash/simulation/scales.hpp"
#include "simulation_impl.hpp"

namespace brash::simulation {

/// A floe splits in a section. Its pieces move on as it did, so mass, momentum and energy stay with them, but for
/// pieces too small for a body.
void Simulation::Impl::split(const Fracture& fracture, StepReport& report) {
  const BodyId body = fracture.body;
  const Pose pose = world.pose(body);
  const Twist twist = world.twist(body);
  energy.remove(world, floes, body);
  sleep.forget(floes, body);
  bearings.forget(body);
  bending.forget(body);
  const Floe parent = floes.remove(world, body);
  report.deaths.push_back({parent.id, model::FloeEnd::kBroken, parent.stress.peak_compression});

  const auto in_plate = [&](double along) {
    const Section& s = fracture.section;
    const Vec2 place = s.offset * s.normal + along * perpendicular(s.normal);
    return plan(to_world(parent.laid, {place.x, place.y, 0.0}));
  };
  for (ice::Plate& piece : field.split(parent.plate, in_plate(-1.0), in_plate(1.0), resolved.failure.smallest_floe)) {
    auto record = floes.add_piece(world, std::move(piece), parent, pose, twist, time());
    if (!record) {
      field.to_brash(piece);
      continue;
    }
    const BodyId born = world.floes().back();
    energy.add_piece(world, floes, born);
    watchdog.add_piece(floes.energy(world, born, floes.at(born)), born, body);
    if (floes.at(born).collision_time < resolved.time.step) ++report.n_steps_too_long;
    report.births.push_back(std::move(*record));
  }
  watchdog.remove(body, parent.weight);
}

/// Floes split whose bending tension exceeds the flexural strength.
void Simulation::Impl::split_floes(StepReport& report) {
  if (resolved.failure.pieces == model::Pieces::kWhole) return;
  const StageTimer::Scope clock(timer, times.cutting);
  for (const Fracture& fracture : bending.fractures(floes)) split(fracture, report);
}

}  // namespace brash::simulation
