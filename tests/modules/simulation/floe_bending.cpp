// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/floes/floe_bending.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "brash/core/constants.hpp"
#include "pool.hpp"

namespace {

using namespace brash;
using namespace brash::simulation;
using namespace brash::simulation::testing;
using boost::test_tools::tolerance;

constexpr double kDt = 0.01;
constexpr double kSupport = 0.1;  // length under an end of the floe [m]

/// A dry floe, 1 m broad, on two supports: its rear end, and a place `overhang` behind its front end. All move along x
/// with the same speed.
struct Bridge {
  explicit Bridge(double l, double overhang = 0.0, double along_x = 0.0) : length(l), speed(along_x) {
    body = pool.add({-0.5 * l, -0.5}, {0.5 * l, 0.5}, {});
    pool.world.set_state(body, {{0.0, 0.0, 3.0 + 0.5 * pool.resolved.ice.thickness}, {}}, {{speed, 0.0, 0.0}, {}});
    for (const double x : {-0.5 * l, 0.5 * l - kSupport - overhang}) {
      const std::vector<Vec2> ring{{x, -0.5}, {x + kSupport, -0.5}, {x + kSupport, 0.5}, {x, 0.5}};
      supports.push_back(pool.world.add_sheet_part(ring, 2.0, 3.0));
    }
  }

  void step() {
    way += speed * kDt;
    for (const BodyId support : supports)
      pool.world.move_sheet_part(support, {{way, 0.0, 0.0}, {}}, {{speed, 0.0, 0.0}, {}});
    (void)pool.step(kDt);
    bending.average(pool.world, pool.floes, floes::contacts_by_place(pool.world), kDt);
  }
  /// In the middle, with the supports' forces in the middles of the supports [Pa].
  double tension() const {
    const double weight = pool.floes.at(body).weight, h = pool.resolved.ice.thickness;
    return 6.0 * (0.25 * weight * (length - kSupport) - 0.125 * weight * length) / (h * h);
  }

  double length, speed;
  double way = 0.0;
  Pool pool;
  floes::FloeBending bending;
  BodyId body;
  std::vector<BodyId> supports;
};

BOOST_AUTO_TEST_SUITE(floe_bending)

BOOST_AUTO_TEST_CASE(a_dry_floe_on_two_supports_breaks_in_its_middle_under_its_own_weight) {
  Bridge bridge(6.0);
  BOOST_TEST(bridge.tension() > 539e3);
  for (int i = 0; i < 200; ++i) bridge.step();
  const std::vector<floes::Fracture> fractures = bridge.bending.fractures(bridge.pool.floes);
  BOOST_REQUIRE(fractures.size() == 1u);
  BOOST_TEST((fractures[0].body == bridge.body));
  BOOST_TEST(fractures[0].tension == bridge.tension(), tolerance(1e-3));
  BOOST_TEST(std::abs(fractures[0].section.offset) < 1e-9);
  BOOST_TEST(std::abs(fractures[0].section.normal.x) == 1.0, tolerance(1e-12));

  Bridge shorter(5.0);
  BOOST_TEST(shorter.tension() < 539e3);
  for (int i = 0; i < 200; ++i) shorter.step();
  BOOST_TEST(shorter.bending.fractures(shorter.pool.floes).empty());
}

BOOST_AUTO_TEST_CASE(a_floe_breaks_alike_on_supports_at_rest_and_on_supports_that_carry_it_along) {
  std::vector<floes::Fracture> breaks;
  for (const double speed : {0.0, 10.0}) {  // 0.1 m a step
    Bridge bridge(8.0, 1.0, speed);
    for (int i = 0; i < 200; ++i) bridge.step();
    const std::vector<floes::Fracture> fractures = bridge.bending.fractures(bridge.pool.floes);
    BOOST_REQUIRE(fractures.size() == 1u);
    breaks.push_back(fractures[0]);
  }
  BOOST_TEST(breaks[1].tension == breaks[0].tension, tolerance(1e-6));
  BOOST_TEST(breaks[1].section.offset == breaks[0].section.offset, tolerance(1e-12));
}

/// The impact of the fall lasts a step. The floe needs its collision time to feel the load.
BOOST_AUTO_TEST_CASE(a_single_step_breaks_nothing) {
  Bridge bridge(5.0);
  const Pose pose = bridge.pool.world.pose(bridge.body);
  bridge.pool.world.set_state(bridge.body, pose, {{0.0, 0.0, -0.3}, {}});
  bridge.step();  // it comes to overlap the supports
  bridge.step();
  double force = 0.0;
  for (const auto& contact : bridge.pool.world.contacts()) force += contact.normal_force;
  BOOST_TEST(force > 2.0 * bridge.pool.floes.at(bridge.body).weight);  // held, it would break the floe
  BOOST_TEST(bridge.bending.fractures(bridge.pool.floes).empty());
}

BOOST_AUTO_TEST_CASE(means_go_on_after_a_checkpoint_and_end_with_the_floe) {
  Bridge bridge(6.0);
  for (int i = 0; i < 200; ++i) bridge.step();
  model::Checkpoint checkpoint;
  bridge.bending.save(bridge.pool.floes, checkpoint);
  floes::FloeBending restored;
  restored.restore(bridge.pool.floes, checkpoint);
  BOOST_REQUIRE(restored.fractures(bridge.pool.floes).size() == 1u);
  BOOST_TEST(restored.fractures(bridge.pool.floes)[0].tension ==
             bridge.bending.fractures(bridge.pool.floes)[0].tension);
  restored.forget(bridge.body);
  BOOST_TEST(restored.fractures(bridge.pool.floes).empty());
}

BOOST_AUTO_TEST_CASE(loads_that_are_long_gone_are_forgotten) {
  Bridge bridge(6.0);
  for (int i = 0; i < 200; ++i) bridge.step();
  bridge.pool.world.set_state(bridge.body, {{0.0, 0.0, 5.0}, {}}, {});
  // From some 700 kPa to 1 Pa in a flight of fourteen collision times.
  const int n_steps = static_cast<int>(14.0 * bridge.pool.floes.at(bridge.body).collision_time / kDt);
  for (int i = 0; i < n_steps; ++i) bridge.bending.average(bridge.pool.world, bridge.pool.floes, {}, kDt);
  model::Checkpoint checkpoint;
  bridge.bending.save(bridge.pool.floes, checkpoint);
  BOOST_TEST(checkpoint.table("section_load").n_rows() == 0u);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
