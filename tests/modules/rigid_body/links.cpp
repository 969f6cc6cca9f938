// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cstring>
#include <ostream>

#include "brash/core/contract.hpp"
#include "helpers.hpp"

using namespace brash;
using namespace brash::rigid_body;
using namespace brash::rigid_body::testing;

namespace brash::rigid_body {

std::ostream& operator<<(std::ostream& out, Engine engine) {
  return out << (engine == Engine::kBrash ? "brash" : "bullet");
}

}  // namespace brash::rigid_body

namespace {

constexpr double kStep = 0.01;
constexpr Vec3 kPull{1500.0, 900.0, 0.0};
constexpr Engine kEngines[] = {Engine::kBrash, Engine::kBullet};

WorldSettings breakable(Engine engine = Engine::kBrash) {
  return {.ice_structure = {0.027, 0.5e6}, .ice_ice = {0.3, 0.5e6}, .engine = engine};
}

/// Two floes side by side, the first moored at its outer corner, the second tied to it and pulled.
struct Chain {
  explicit Chain(Engine engine = Engine::kBrash) : world(breakable(engine)) {
    first = add_floe(world, rectangle({0, 0}, {2, 2}), 0.5);
    second = add_floe(world, rectangle({2.1, 0}, {4.1, 2}), 0.5);
    mooring = world.moor({first, {-1, -1, 0}}, {0, 0, 0});
    tie = world.link({first, {1.05, 0, 0}}, {second, {-1.05, 0, 0}});
  }

  void step() {
    world.apply(second, {kPull, {}});
    world.step(kStep);
    work += kStep * dot(kPull, world.mean_twist(second).linear);
    for (const LinkLoad& load : world.links()) {
      given += kStep * power(load);
      worst_gap = std::max(worst_gap, load.gap);
    }
  }

  World world;
  BodyId first, second;
  LinkId mooring, tie;
  double work = 0.0;       ///< of the pull [J]
  double given = 0.0;      ///< by the links [J]
  double worst_gap = 0.0;  ///< [m]
};

bool same_bytes(const World& a, const World& b, BodyId id) {
  const Pose p = a.pose(id), q = b.pose(id);
  const Twist u = a.twist(id), v = b.twist(id);
  return std::memcmp(&p, &q, sizeof p) == 0 && std::memcmp(&u, &v, sizeof u) == 0;
}

}  // namespace

BOOST_DATA_TEST_CASE(Linked_and_moored_floes_hold_a_pull_and_their_energies_close, kEngines, engine) {
  Chain chain(engine);
  for (int i = 0; i < 500; ++i) chain.step();
  BOOST_TEST_MESSAGE("worst gap " << 1e6 * chain.worst_gap << " um, work of the pull " << chain.work
                                  << " J, given by the links " << chain.given << " J, kinetic energy "
                                  << chain.world.kinetic_energy() << " J");
  BOOST_TEST(chain.world.links().size() == 2U);
  // A step turns a floe by 0.01 rad at most, which opens a joint by an arm of 1.4 m times half its square.
  BOOST_TEST(chain.worst_gap < 70e-6);
  // Plane motion has no gyroscopic loss, so only rounding is left.
  BOOST_TEST(chain.work + chain.given == chain.world.kinetic_energy(), boost::test_tools::tolerance(1e-9));
  // Links take back gaps, which is not free of work.
  BOOST_TEST(std::abs(chain.given) < 0.01 * chain.work);
  // The chain hangs in the direction of the pull, and the mooring bears it.
  const Vec3 along = chain.world.pose(chain.second).position;
  BOOST_TEST(dot(along, kPull) > 0.0);
}

BOOST_AUTO_TEST_CASE(Links_made_again_from_stored_states_give_the_same_bytes) {
  Chain whole, stored;
  for (int i = 0; i < 200; ++i) whole.step();
  stored.world.set_state(stored.first, whole.world.pose(whole.first), whole.world.twist(whole.first));
  stored.world.set_state(stored.second, whole.world.pose(whole.second), whole.world.twist(whole.second));
  for (int i = 0; i < 100; ++i) {
    whole.step();
    stored.step();
  }
  BOOST_TEST(same_bytes(whole.world, stored.world, whole.first));
  BOOST_TEST(same_bytes(whole.world, stored.world, whole.second));
}

BOOST_DATA_TEST_CASE(A_spring_comes_to_rest_where_it_bears_the_pull, kEngines, engine) {
  World world(breakable(engine));
  const BodyId floe = add_floe(world, rectangle({-1, -1}, {1, 1}), 0.5);
  const double mass = kDensity * 4 * 0.5, stiffness = 2e4, pull = 3000.0;
  world.moor({floe, {}}, {0, 0, 0}, {.stiffness = stiffness, .damping = 2.0 * std::sqrt(stiffness * mass)});
  for (int i = 0; i < 1000; ++i) {
    world.apply(floe, {{pull, 0, 0}, {}});
    world.step(kStep);
  }
  // Critically damped with 0.3 s: after 10 s exp(-33) is left.
  BOOST_TEST(world.pose(floe).position.x == pull / stiffness, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(world.links()[0].gap == pull / stiffness, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(world.links()[0].force.x == -pull, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(world.links()[0].elastic_energy == 0.5 * pull * pull / stiffness, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(An_undamped_spring_swings_with_its_period) {
  World world(breakable());
  const BodyId floe = add_floe(world, rectangle({-1, -1}, {1, 1}), 0.5);
  const double mass = kDensity * 4 * 0.5, omega = 2.0, dt = 0.001;
  world.moor({floe, {}}, {-0.1, 0, 0}, {.stiffness = mass * omega * omega});
  double crossing = 0.0;  // the second time that it passes the middle
  for (int i = 1, n = 0; n < 2; ++i) {
    const double before = world.pose(floe).position.x + 0.1;
    world.step(dt);
    const double after = world.pose(floe).position.x + 0.1;
    if (before * after < 0.0 && ++n == 2) crossing = (i - 1 + before / (before - after)) * dt;
  }
  // A quarter and a half of the period; implicit Euler delays it by less than omega dt.
  BOOST_TEST(crossing == 0.75 * 2.0 * kPi / omega, boost::test_tools::tolerance(omega * dt));
}

BOOST_AUTO_TEST_CASE(Linked_bodies_do_not_touch_until_they_are_let_go) {
  World world(breakable());
  const BodyId one = add_floe(world, rectangle({0, 0}, {2, 2}), 0.5, {{1, 0, 0}, {}});
  const BodyId other = add_floe(world, rectangle({1.99, 0}, {4, 2}), 0.5);
  const LinkId tie = world.link({one, {1, 0, 0}}, {other, {-1, 0, 0}}, {.stiffness = 1.0});
  world.step(kStep);
  BOOST_TEST(world.contacts().empty());
  world.unlink(tie);
  world.step(kStep);
  BOOST_TEST(!world.contacts().empty());
  BOOST_TEST(world.links().empty());
  BOOST_CHECK_THROW(world.unlink(tie), ContractViolation);
}

BOOST_AUTO_TEST_CASE(Links_go_with_their_bodies_and_keep_floes_from_settling) {
  Chain chain;
  BOOST_CHECK_THROW(chain.world.set_settled(chain.first, true), ContractViolation);
  chain.world.remove(chain.second);
  chain.world.step(kStep);
  BOOST_TEST(chain.world.links().size() == 1U);
  BOOST_TEST((chain.world.links()[0].link == chain.mooring));
  chain.world.unlink(chain.mooring);
  BOOST_CHECK_NO_THROW(chain.world.set_settled(chain.first, true));
  BOOST_CHECK_THROW(chain.world.moor({chain.first, {}}, {}), ContractViolation);
}

BOOST_AUTO_TEST_CASE(Sheets_that_drift_and_their_parts_take_no_links) {
  World world(breakable());
  const BodyId floe = add_floe(world, rectangle({0, 0}, {2, 2}), 0.5);
  const BodyId sheet = world.add_drifting_sheet();
  const BodyId tile = world.add_sheet_part(rectangle({4, 0}, {8, 4}), -0.25, 0.25, {}, sheet);
  const BodyId wall = world.add_sheet_part(rectangle({-4, 0}, {-2, 4}), -0.25, 0.25);
  world.set_sheet(sheet, {.mass = 7200.0, .inertia = 19200.0, .centre = {6, 2}});
  for (const BodyId drifts : {sheet, tile}) {
    BOOST_CHECK_THROW(world.link({floe, {}}, {drifts, {}}), ContractViolation);
    BOOST_CHECK_THROW(world.link({drifts, {}}, {floe, {}}), ContractViolation);
    BOOST_CHECK_THROW(world.moor({drifts, {}}, {}), ContractViolation);
  }
  BOOST_CHECK_NO_THROW(world.link({floe, {}}, {wall, {}}));
}
