// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <limits>

#include "pool.hpp"

namespace {

using namespace brash;
using namespace brash::simulation;
using namespace brash::simulation::testing;

constexpr double kStep = 0.01;  // s
constexpr double kSlow = 0.05;  // m/s
constexpr double kEverywhere = std::numeric_limits<double>::infinity();
const std::vector<std::string> kSleeping{"time.settle_speed=0.05", "time.step=0.01"};

/// What lies before x = `limit` [m].
floes::Clear before(double limit) { return {.origin = {limit, 0.0}, .course = {1.0, 0.0}}; }

/// Steps for `seconds`. @return the kinetic energy that falling asleep took [J].
double advance(Pool& pool, double seconds, double astern = kEverywhere) {
  double taken = 0.0;
  for (int i = 0; i < std::lround(seconds / kStep); ++i) {
    (void)pool.step(kStep);
    taken += pool.sleep.update(pool.world, pool.floes, before(astern));
  }
  return taken;
}

/// The level ice that the pool's floes are taken to have broken off from.
std::vector<ice::Plate> one_level_ice(const model::Case& resolved) {
  std::vector<ice::Plate> plates;
  plates.emplace_back(0, ice::Hold::kFast, edge::ice_properties(resolved), std::vector<geometry::Polygon>{});
  return plates;
}

double speed(const Pool& pool, BodyId floe) { return pool.world.twist(floe).linear.x; }

BOOST_AUTO_TEST_SUITE(sleep)

BOOST_AUTO_TEST_CASE(a_floe_that_stays_slow_falls_asleep_and_its_kinetic_energy_is_accounted_for) {
  Pool pool(kSleeping);
  const BodyId slow = pool.add({-1, -1}, {1, 1}, {{0.9 * kSlow, 0, 0}, {}});
  const BodyId fast = pool.add({-1, 4}, {1, 6}, {{10 * kSlow, 0, 0}, {}});
  const BodyId ahead = pool.add({19, -1}, {21, 1}, {{0.9 * kSlow, 0, 0}, {}});
  BOOST_TEST(advance(pool, 1.98, 10.0) == 0.0);
  BOOST_TEST(!pool.world.is_settled(slow));
  const double kinetic = pool.world.kinetic_energy(slow);
  BOOST_TEST(advance(pool, 0.05, 10.0) == kinetic, boost::test_tools::tolerance(0.02));  // the drag of three steps
  BOOST_TEST(pool.world.is_settled(slow));
  BOOST_TEST(!pool.world.is_settled(fast));
  BOOST_TEST(!pool.world.is_settled(ahead));
  const Pose fixed = pool.world.pose(slow);
  // Afloat as before: nothing but heave is left.
  BOOST_TEST(pool.floes.energy(pool.world, slow, pool.floes.floes().at(slow)) < 0.01 * kinetic);
  (void)advance(pool, 1.0, 10.0);
  BOOST_TEST((pool.world.pose(slow) == fixed));
}

BOOST_AUTO_TEST_CASE(a_floe_that_falls_asleep_keeps_nothing_of_its_last_step_in_the_water) {
  Pool pool(kSleeping);
  const BodyId body = pool.add({-1, -1}, {1, 1}, {});
  pool.floes.at(body).shed = 3.0;  // J: a step that wakes it by a blow books what it sheds before it meets the water
  pool.floes.put_to_sleep(pool.world, body);
  BOOST_TEST(pool.floes.at(body).shed == 0.0);
}

BOOST_AUTO_TEST_CASE(a_sleeping_floe_wakes_where_the_structure_may_come) {
  Pool pool(kSleeping);
  const BodyId near = pool.add({6, -1}, {8, 1}, {}), far = pool.add({-4, -1}, {-2, 1}, {});
  (void)advance(pool, 2.5);
  BOOST_REQUIRE(pool.world.is_settled(near));
  BOOST_REQUIRE(pool.world.is_settled(far));
  pool.sleep.wake_beyond(pool.world, pool.floes, before(7.0));
  BOOST_TEST(!pool.world.is_settled(near));
  BOOST_TEST(pool.world.is_settled(far));
  // The structure turns about.
  pool.sleep.wake_beyond(pool.world, pool.floes, {.course = {-1.0, 0.0}});
  BOOST_TEST(!pool.world.is_settled(far));
}

BOOST_AUTO_TEST_CASE(floes_of_a_field_sleep_from_the_start_all_around_the_structure) {
  Pool pool(kSleeping);
  const BodyId near = pool.add({6, -1}, {8, 1}, {}), ahead = pool.add({11, -1}, {13, 1}, {});
  const BodyId beside = pool.add({-1, 10.5}, {1, 12.5}, {}), astern = pool.add({-13, -1}, {-11, 1}, {});
  const floes::Clear clear{.course = {1.0, 0.0}, .distance = 10.0, .all_around = true};
  pool.sleep.begin(pool.world, pool.floes, clear);
  BOOST_TEST(!pool.world.is_settled(near));
  for (const BodyId far : {ahead, beside, astern}) BOOST_TEST(pool.world.is_settled(far));
  BOOST_TEST(pool.floes.potential_energy(pool.world) == 0.0);
  // The structure comes nearer.
  pool.sleep.wake_beyond(pool.world, pool.floes, {.origin = {2.5, 0.0}, .distance = 10.0, .all_around = true});
  BOOST_TEST(!pool.world.is_settled(ahead));
  BOOST_TEST(pool.world.is_settled(beside));
  BOOST_TEST(pool.world.is_settled(astern));
  // It is faster, and stirs more water.
  pool.sleep.wake_beyond(pool.world, pool.floes, {.origin = {2.5, 0.0}, .distance = 11.0, .all_around = true});
  BOOST_TEST(!pool.world.is_settled(beside));
  BOOST_TEST(pool.world.is_settled(astern));
}

BOOST_AUTO_TEST_CASE(a_sleeping_floe_that_is_pushed_goes_on_as_if_it_had_never_slept) {
  // A drifting floe runs into one at rest, which wakes before the blow: no speed is off by more than kSlow.
  Pool with(kSleeping), without;
  for (Pool* pool : {&with, &without}) {
    const BodyId rests = pool->add({-1, -1}, {1, 1}, {});
    (void)advance(*pool, 2.5);
    const BodyId comes = pool->add({-5, -1}, {-3, 1}, {{0.8, 0, 0}, {}});
    (void)advance(*pool, 4.0);
    BOOST_TEST(speed(*pool, rests) > 3 * kSlow);
    BOOST_TEST_MESSAGE(speed(*pool, rests) << ' ' << speed(*pool, comes));
  }
  for (const BodyId floe : with.world.floes()) BOOST_TEST(std::abs(speed(with, floe) - speed(without, floe)) < kSlow);
}

BOOST_AUTO_TEST_CASE(a_gentle_push_leaves_a_floe_asleep) {
  Pool pool(kSleeping);
  const BodyId rests = pool.add({-1, -1}, {1, 1}, {});
  (void)advance(pool, 2.5);
  (void)pool.add({-3.05, -1}, {-1.05, 1}, {{0.9 * kSlow, 0, 0}, {}});
  (void)advance(pool, 1.9);
  BOOST_TEST(pool.world.is_settled(rests));
}

/// Only the smaller of the two floes of a stack lies wholly below this [m].
constexpr double kSmallAlone = 1.5;

/// A floe that sleeps on a larger one, which moves. @return the lower, the upper.
std::pair<BodyId, BodyId> add_stack(Pool& pool) {
  const BodyId lower = pool.add({-2, -2}, {2, 2}, {});
  const BodyId upper = pool.add({-1, -1}, {1, 1}, {});
  const double h = pool.resolved.ice.thickness;
  const double afloat = -0.2933;  // where the stack floats [m]
  for (const auto& [floe, height] : {std::pair(lower, afloat), std::pair(upper, afloat + h)}) {
    Pose pose = pool.world.pose(floe);
    pose.position.z = height;
    pool.world.set_state(floe, pose, {});
  }
  (void)advance(pool, 15.0, kSmallAlone);
  BOOST_REQUIRE(!pool.world.is_settled(lower));
  BOOST_REQUIRE(pool.world.is_settled(upper));
  return {lower, upper};
}

BOOST_AUTO_TEST_CASE(a_floe_stays_asleep_on_the_one_that_bears_it) {
  Pool pool(kSleeping);
  const auto [lower, upper] = add_stack(pool);
  for (int i = 0; i < 2000; ++i) {
    (void)advance(pool, kStep, kSmallAlone);
    BOOST_REQUIRE(pool.world.is_settled(upper));
  }
  double push = 0.0;  // by which the lower one bears it
  for (const rigid_body::ContactLoad& contact : pool.world.contacts()) push += contact.normal_force;
  BOOST_TEST(push > 5 * pool.floes.floes().at(upper).inertia.mass * kSlow / 2.0);
}

BOOST_AUTO_TEST_CASE(a_floe_wakes_when_the_one_that_bears_it_leaves) {
  Pool pool(kSleeping);
  const auto [lower, upper] = add_stack(pool);
  const double height = pool.world.pose(upper).position.z;
  pool.remove(lower);
  (void)advance(pool, 0.5);
  BOOST_TEST(!pool.world.is_settled(upper));
  BOOST_TEST(pool.world.pose(upper).position.z < height - 0.1);
}

BOOST_AUTO_TEST_CASE(a_floe_wakes_where_the_sheet_breaks) {
  Pool pool(kSleeping);
  const BodyId near = pool.add({-1, -1}, {1, 1}, {});
  const BodyId far = pool.add({4, -1}, {6, 1}, {});
  (void)advance(pool, 2.5);
  pool.sleep.wake_within(pool.world, pool.floes, {-3, 0}, 2.5);
  BOOST_TEST(!pool.world.is_settled(near));
  BOOST_TEST(pool.world.is_settled(far));
  BOOST_TEST(pool.floes.floes().at(near).kept_drag.left == 0.0);  // its drag at rest is forgotten
  BOOST_TEST(pool.floes.floes().at(far).kept_drag.left > 0.0);
}

BOOST_AUTO_TEST_CASE(a_sleeping_floe_that_is_restored_goes_on_to_the_last_bit) {
  Pool pool(kSleeping), restored(kSleeping);
  const BodyId rests = pool.add({-1, -1}, {1, 1}, {});
  const BodyId comes = pool.add({-7, -1}, {-5, 1}, {{0.8, 0, 0}, {}});
  (void)advance(pool, 3.0);
  BOOST_REQUIRE(pool.world.is_settled(rests));
  model::Checkpoint checkpoint;
  pool.floes.save(pool.world, checkpoint);
  pool.sleep.save(pool.floes, checkpoint);
  const std::vector<ice::Plate> level_ice = one_level_ice(pool.resolved);
  restored.floes.restore(restored.world, level_ice, checkpoint);
  restored.sleep.restore(restored.floes, checkpoint);
  for (Pool* each : {&pool, &restored}) (void)advance(*each, 8.0);
  for (const BodyId floe : {rests, comes}) BOOST_TEST((pool.world.pose(floe) == restored.world.pose(floe)));
  BOOST_TEST(speed(pool, rests) > 0.0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
