// SPDX-License-Identifier: GPL-3.0-or-later
// Floes on the bed of shallow water: docs/theory/contacts-and-bodies.md, (C9).
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "brash/core/constants.hpp"
#include "brash/simulation/run.hpp"
#include "pool.hpp"

namespace {

using namespace brash;
using namespace brash::simulation;
using namespace brash::simulation::testing;

constexpr double kStep = 0.01;
constexpr double kFriction = 0.4;
/// The solver ends when it changes no velocity by 1e-8 m/s: 1e-3 N on the block.
const auto kSolved = boost::test_tools::tolerance(1e-6);

/// Floes of the validation case over a bed, in water without drag.
struct Shallows : Pool {
  Shallows(double depth, std::vector<std::string> overrides) : Pool(with_still_water(std::move(overrides))) {
    resolved.water.depth = depth;
    world = rigid_body::World({.ice_structure = {0.027, 0.5e6},
                               .ice_ice = {0.3, 0.5e6},
                               .bed = rigid_body::Bed{.height = -depth, .law = {kFriction, 0.5e6}},
                               .iterations = 200,
                               .release_speed = resolved.time.settle_speed});
  }
  static std::vector<std::string> with_still_water(std::vector<std::string> overrides) {
    for (const char* const none : {"hydrodynamics.form_drag=0", "hydrodynamics.rotational_drag=0",
                                   "hydrodynamics.skin_friction=0", "hydrodynamics.structure_flow=false"})
      overrides.push_back(none);
    return overrides;
  }

  /// A block of 2 m by 2 m that lies on the bed.
  BodyId add_grounded(double speed = 0.0) {
    const BodyId block = add({-1, -1}, {1, 1}, {});
    Pose pose = world.pose(block);
    pose.position.z = 0.5 * resolved.ice.thickness - *resolved.water.depth - 1e-6;
    world.set_state(block, pose, {{speed, 0.0, 0.0}, {}});
    return block;
  }

  /// Weight of that block less the lift of its part under water [N].
  double net_weight() const {
    return 4.0 * kGravity *
           (resolved.ice.density * resolved.ice.thickness - resolved.water.density * (*resolved.water.depth + 1e-6));
  }
};

Vec3 from_bed(const rigid_body::World& world) {
  Vec3 sum{};
  for (const rigid_body::ContactLoad& c : world.contacts())
    if (c.other_kind == rigid_body::BodyKind::kBed) sum += force(c);
  return sum;
}

/// The validation cone, in water so shallow that floes which it turns under come to ground. It stands in the bed.
model::Case shallow_case(std::vector<std::string> overrides = {}) {
  overrides.push_back("time.duration=3.5");
  overrides.insert(overrides.begin(), "output.statistics_from=0");
  return io::read_case(kValidation, overrides);
}
const std::vector<std::string> kShallow{"water.depth=0.4", "water.bed_friction=0.5"};

std::vector<std::string> shallow_and(const char* setting) {
  std::vector<std::string> all = kShallow;
  all.push_back(setting);
  return all;
}

BOOST_AUTO_TEST_SUITE(bed)

BOOST_AUTO_TEST_CASE(a_block_in_less_water_than_its_draught_presses_with_its_weight_less_the_lift_of_its_wet_part) {
  for (const double depth : {0.1, 0.25}) {  // it floats with a draught of 0.29 m
    Shallows water(depth, {});
    (void)water.add_grounded();
    for (int i = 0; i < 50; ++i) (void)water.step(kStep);
    BOOST_TEST(from_bed(water.world).z == water.net_weight(), kSolved);
  }
}

BOOST_AUTO_TEST_CASE(in_deeper_water_the_block_floats_and_the_bed_carries_nothing) {
  Shallows water(0.3, {});
  const BodyId block = water.add({-1, -1}, {1, 1}, {});
  for (int i = 0; i < 50; ++i) (void)water.step(kStep);
  BOOST_TEST(water.world.contacts().empty());
  BOOST_TEST(std::abs(water.world.twist(block).linear.z) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_grounded_block_moves_when_it_is_pushed_by_more_than_its_friction) {
  for (const double share : {0.98, 1.5}) {
    Shallows water(0.2, {"hydrodynamics.added_mass_law=isotropic", "hydrodynamics.added_mass=0.5"});
    const BodyId block = water.add_grounded();
    const double holds = kFriction * water.net_weight();
    for (int i = 0; i < 100; ++i) {
      water.world.apply(block, {{share * holds, 0.0, 0.0}, {}});
      (void)water.step(kStep);
    }
    const double mass = 4.0 * water.resolved.ice.thickness * water.resolved.ice.density;
    const double moves = std::max(0.0, share - 1.0) * holds / (1.5 * mass);  // m/s2
    BOOST_TEST(std::abs(water.world.twist(block).linear.x - 100 * kStep * moves) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(a_block_that_slides_to_rest_leaves_its_energy_to_the_friction_of_the_bed) {
  Shallows water(0.2, {});
  const double speed = 0.3;
  const BodyId block = water.add_grounded(speed);
  const double kinetic = water.world.kinetic_energy();
  const double mass = 2.0 * kinetic / (speed * speed), slides = speed * mass / (kFriction * water.net_weight());  // s
  model::LoadRow row;
  const double start = water.world.pose(block).position.x;
  for (int i = 0; i < 2.0 * slides / kStep; ++i) row = water.step(kStep);
  BOOST_TEST(row.losses.bed_friction == kinetic, kSolved);
  BOOST_TEST(std::abs(row.losses.bed_contact) < 1e-6 * kinetic);
  BOOST_TEST(row.losses.total() == kinetic, kSolved);
  // Positions follow the velocity of the end of a step.
  BOOST_TEST(std::abs(water.world.pose(block).position.x - start - 0.5 * speed * slides) < 0.5 * speed * kStep);
}

BOOST_AUTO_TEST_CASE(a_structure_that_pushes_a_grounded_block_bears_the_friction_of_the_bed) {
  Shallows water(0.2, {});
  (void)water.add_grounded();
  const std::vector<Vec3> wall{{-3, -2, -1}, {-1, -2, -1}, {-3, 2, -1}, {-1, 2, -1},
                               {-3, -2, 1},  {-1, -2, 1},  {-3, 2, 1},  {-1, 2, 1}};
  const Vec3 velocity{0.1, 0.0, 0.0};
  Pose place;
  const BodyId structure = water.world.add_structure(std::span(&wall, 1), place);
  double on_structure = 0.0;
  for (int i = 0; i < 100; ++i) {
    place.position += kStep * velocity;
    water.world.move_structure(structure, place, {velocity, {}});
    (void)water.step(kStep);
    on_structure = 0.0;
    for (const rigid_body::ContactLoad& c : water.world.contacts())
      if (c.other == structure) on_structure -= force(c).x;
  }
  // The wall has a friction of 0.027, which carries or presses the block by its own share at most.
  const double expected = kFriction * water.net_weight();
  BOOST_TEST(-on_structure == expected, boost::test_tools::tolerance(0.027 * kFriction));
  BOOST_TEST(from_bed(water.world).x == on_structure, kSolved);
}

BOOST_AUTO_TEST_CASE(a_grounded_block_falls_asleep) {
  Shallows water(0.2, {"time.settle_speed=0.05", "time.step=0.01"});
  const BodyId block = water.add_grounded();
  const floes::Clear everywhere{.origin = {1e6, 0.0}, .course = {1.0, 0.0}};
  double taken = 0.0;
  for (int i = 0; i < 250; ++i) {
    (void)water.step(kStep);
    taken += water.sleep.update(water.world, water.floes, everywhere);
  }
  BOOST_TEST(water.world.is_settled(block));
  BOOST_TEST(taken < 1e-9);
  BOOST_TEST(water.floes.potential_energy(water.world) > 0.0);  // it lies higher than afloat
}

BOOST_AUTO_TEST_CASE(the_energies_of_a_run_over_a_bed_account_for_the_work_of_the_structure) {
  const Run run = simulation::run(shallow_case(kShallow));
  const auto grounds = [](const model::LoadRow& row) { return row.bed.force.z < 0.0; };
  BOOST_TEST(std::ranges::count_if(run.results.loads, grounds) > 50);
  for (const model::LoadRow& row : run.results.loads) BOOST_TEST_REQUIRE(row.bed.force.z <= 0.0);
  const EnergyBalance& e = run.summary.energy;
  BOOST_TEST(e.losses.bed_contact > 0.0);
  BOOST_TEST(e.losses.bed_friction > 0.0);
  BOOST_TEST_MESSAGE("bed: contact " << e.losses.bed_contact << " J, friction " << e.losses.bed_friction << " J; work "
                                     << e.work << " J, error " << e.error << " J");
  BOOST_TEST(std::abs(e.error) < 0.01 * e.work);  // as in deep water
}

BOOST_AUTO_TEST_CASE(the_bed_rests_with_the_ice_or_with_the_structure) {
  const auto on_bed = [](const char* frame) {
    const Run run = simulation::run(shallow_case(shallow_and(frame)));
    double sum = 0.0;
    for (const model::LoadRow& row : run.results.loads) sum += row.bed.force.x;
    BOOST_TEST_MESSAGE(frame << ": mean load along x " << sum / static_cast<double>(run.results.loads.size()) << " N");
    BOOST_TEST(std::abs(run.summary.energy.error) < 0.01 * run.summary.energy.work);
    return sum;
  };
  // x points against the heading, as the ice drifts. A structure that moves pushes floes ahead over the bed. Past a
  // structure at rest, ice that drifts pushes both.
  BOOST_TEST(on_bed("structure.motion.frame=structure-moves") < 0.0);
  BOOST_TEST(on_bed("structure.motion.frame=ice-drifts") > 0.0);
}

BOOST_AUTO_TEST_CASE(a_bed_that_no_floe_reaches_changes_nothing) {
  const Run deep = simulation::run(shallow_case()), over_bed = simulation::run(shallow_case({"water.depth=50"}));
  BOOST_TEST((deep.results == over_bed.results));
}

BOOST_AUTO_TEST_CASE(a_run_over_a_bed_is_the_same_on_two_threads_and_after_a_restart) {
  const model::Case resolved = shallow_case(shallow_and("structure.motion.frame=ice-drifts"));
  const Run whole = simulation::run(resolved);
  BOOST_TEST((simulation::run(resolved, {.threads = 2}).results == whole.results));
  std::optional<model::Checkpoint> kept;
  const CheckpointStore store{
      .name = "memory", .keep = [&](const model::Checkpoint& c) { kept = c; }, .newest = [&] { return kept; }};
  int done = 0;
  BOOST_TEST(!simulation::run(resolved, {.checkpoint = store, .interrupted = [&] { return ++done == 250; }}).complete);
  BOOST_TEST((simulation::run(resolved, {.checkpoint = store}).results == whole.results));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
