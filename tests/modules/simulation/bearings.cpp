// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/floes/bearings.hpp"

#include <boost/test/unit_test.hpp>

#include "pool.hpp"

namespace {

using namespace brash;
using namespace brash::simulation;
using namespace brash::simulation::testing;

constexpr double kStep = 0.01;  // s

/// A floe wedged between two walls, each the edge of its own level ice.
struct Gap {
  Gap() {
    const std::vector<Vec2> left{{-3, -5}, {-0.999, -5}, {-0.999, 5}, {-3, 5}};
    const std::vector<Vec2> right{{0.999, -5}, {3, -5}, {3, 5}, {0.999, 5}};
    left_wall = pool.world.add_sheet_part(left, -0.3, 0.05);
    pool.world.add_sheet_part(right, -0.3, 0.05);
    floe = pool.add({-1, -1}, {1, 1}, {{0.01, 0, 0}, {}});
  }

  void step() {
    (void)pool.step(kStep);
    bearings.average(
        pool.world, pool.floes, floes::contacts_by_place(pool.world),
        [&](BodyId part) { return part == left_wall ? 0 : 1; }, kStep);
  }

  Pool pool{{"time.settle_speed=0.05", "time.step=0.01"}};
  floes::Bearings bearings;
  BodyId left_wall, floe;
};

BOOST_AUTO_TEST_SUITE(bearings_of_floes)

BOOST_AUTO_TEST_CASE(what_a_floe_presses_is_kept_apart_for_each_level_ice) {
  Gap gap;
  for (int i = 0; i < 10; ++i) gap.step();
  BOOST_REQUIRE(gap.bearings.all().size() == 2u);
  const floes::Bearing &left = gap.bearings.all().at({gap.floe, 0}), &right = gap.bearings.all().at({gap.floe, 1});
  BOOST_TEST(left.thrust.x < 0.0);
  BOOST_TEST(right.thrust.x > 0.0);
  BOOST_TEST(left.first.x / left.weight == -1.0, boost::test_tools::tolerance(0.01));
  BOOST_TEST(right.first.x / right.weight == 1.0, boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(ice_that_breaks_takes_with_it_what_pressed_on_it) {
  Gap gap;
  for (int i = 0; i < 10; ++i) gap.step();
  gap.bearings.forget_within(1, {-1.0, 0.0}, 1.5);  // the other ice, too far off
  BOOST_TEST(gap.bearings.all().size() == 2u);
  gap.bearings.forget_within(0, {-1.0, 0.0}, 1.5);
  BOOST_REQUIRE(gap.bearings.all().size() == 1u);
  BOOST_TEST(gap.bearings.all().begin()->first.second == 1);
  gap.bearings.forget_within(1, geometry::Extent{{1.5, -5.0}, {3.0, 5.0}});  // ice behind the edge
  BOOST_TEST(gap.bearings.all().size() == 1u);
  gap.bearings.forget_within(1, geometry::Extent{{0.999, -5.0}, {3.0, 5.0}});
  BOOST_TEST(gap.bearings.all().empty());
}

BOOST_AUTO_TEST_CASE(a_floe_that_is_no_more_presses_on_nothing) {
  Gap gap;
  for (int i = 0; i < 10; ++i) gap.step();
  gap.bearings.forget(gap.floe);
  BOOST_TEST(gap.bearings.all().empty());
}

BOOST_AUTO_TEST_CASE(a_floe_that_sleeps_presses_on_nothing) {
  Gap gap;
  for (int i = 0; i < 10; ++i) gap.step();
  gap.pool.floes.put_to_sleep(gap.pool.world, gap.floe);
  gap.step();
  BOOST_TEST(gap.bearings.all().empty());
}

BOOST_AUTO_TEST_CASE(bearings_restore_what_they_saved) {
  Gap gap;
  for (int i = 0; i < 10; ++i) gap.step();
  model::Checkpoint checkpoint;
  gap.bearings.save(gap.pool.floes, checkpoint);
  floes::Bearings restored;
  restored.restore(gap.pool.floes, checkpoint);
  BOOST_TEST((restored.all() == gap.bearings.all()));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
