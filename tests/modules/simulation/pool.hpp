// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "afloat.hpp"
#include "brash/floes/floe_water.hpp"
#include "brash/floes/sleep.hpp"
#include "brash/io/case.hpp"
#include "energy_ledger.hpp"
#include "state.hpp"

namespace brash::simulation::testing {

/// With the laws of contact and water that most tests of floes have known answers for.
inline const std::string kValidation = BRASH_SOURCE_DIR "/experiments/validation/second_reading.toml";

/// Floes of the validation case, without sheet and structure.
struct Pool {
  explicit Pool(std::vector<std::string> overrides = {})
      : resolved(io::read_case(kValidation, overrides)),
        world(world_settings(resolved)),
        floes(resolved),
        water(resolved),
        sleep(resolved) {}

  BodyId add(Vec2 lower, Vec2 upper, const Twist& twist) {
    const std::vector<Vec2> ring{lower, {upper.x, lower.y}, upper, {lower.x, upper.y}};
    BOOST_REQUIRE(floes.add(world, afloat(resolved, ring), 0.0).has_value());
    const BodyId body = world.floes().back();
    world.set_state(body, world.pose(body), twist);
    return body;
  }

  /// Energies after a step of `dt`. The floes are not newborn.
  model::LoadRow step(double dt) {
    water.apply(world, floes, dt, {});
    world.step(dt);
    sleep.notice_woken(world, floes);
    ledger.book_step(world, floes, floes.next_id(), dt);
    model::LoadRow row;
    ledger.report(world, floes, row);
    return row;
  }

  /// The contacts of the last step, of `dt`, go into the stress of the floes.
  void take_stress(double dt) {
    floes::update_stress(world, floes::contacts_by_place(world), floes::StressLaw(resolved.contact), dt, floes);
  }

  void remove(BodyId floe) {
    sleep.forget(floes, floe);
    (void)floes.remove(world, floe);
  }

  model::Case resolved;
  rigid_body::World world;
  floes::FloePopulation floes;
  floes::FloeWater water;
  floes::Sleep sleep;
  EnergyLedger ledger;
};

}  // namespace brash::simulation::testing
