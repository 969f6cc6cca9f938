// SPDX-License-Identifier: GPL-3.0-or-later
// The engine kBullet: Bullet as it is, with the bound of the crushing ice.
#include <boost/test/unit_test.hpp>
#include <cstring>

#include "helpers.hpp"

using namespace brash;
using namespace brash::rigid_body;
using namespace brash::rigid_body::testing;

namespace {

constexpr double kPressure = 0.5e6;

WorldSettings bullet(double pressure = kPressure) {
  return {.ice_structure = {0.027, pressure}, .ice_ice = {0.3, pressure}, .engine = Engine::kBullet};
}

/// A cone runs into 3 x 4 floes against a fixed edge.
struct Scene {
  Scene() : world(bullet()), structure(add_structure(world, cone(6.8, radians(61.4), 5.68, 3.4))) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 4; ++j) {
        const Vec2 at{6.98 + 1.02 * i, -2.04 + 1.02 * j};
        floes.push_back(add_floe(world, rectangle(at, at + Vec2{1, 1}), 0.33));
      }
    world.add_sheet_part(rectangle({10.06, -5}, {13, 5}), -0.165, 0.165);
  }
  void step(double dt) {
    push(world, structure, {1.2, 0, 0}, dt);
    world.step(dt);
  }
  World world;
  BodyId structure;
  std::vector<BodyId> floes;
};

}  // namespace

BOOST_AUTO_TEST_CASE(Bullet_bears_the_bound_of_the_exact_overlap_and_no_more) {
  World world(bullet());
  const BodyId wall = add_structure(world, box({-1, -0.1, -0.1}, {0.05, 0.1, 0.1}));
  const BodyId floe = add_floe(world, rectangle({0, -1.5}, {3, 1.5}), 0.4, {}, 0.5);
  const double dt = 0.001, mass = 1.5 * kDensity * 9 * 0.4, area = 0.2 * 0.2;
  push(world, wall, {2.0, 0, 0}, dt);
  world.step(dt);
  BOOST_TEST(world.twist(floe).linear.x == kPressure * area * dt / mass, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(total_normal_force(world) == kPressure * area, boost::test_tools::tolerance(1e-9));
  double shares = 0.0;
  for (const ContactLoad& c : world.contacts()) {
    BOOST_TEST(c.at_bound);
    shares += c.area;
  }
  BOOST_TEST(shares == area, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(Bullet_pushes_with_the_velocity_of_the_structure_and_reports_the_load) {
  World world(bullet(std::numeric_limits<double>::infinity()));
  const BodyId wall = add_structure(world, box({-1, -2, -1}, {0, 2, 1}));
  const BodyId floe = add_floe(world, rectangle({0, -1}, {2, 1}), 0.3);
  double impulse = 0.0;
  for (int i = 0; i < 100; ++i) {
    push(world, wall, {0.7, 0, 0}, 0.01);
    world.step(0.01);
    impulse += 0.01 * total_normal_force(world);
  }
  // One point a step comes to the manifold, so the floe rattles a little before it moves along.
  BOOST_TEST(world.twist(floe).linear.x == 0.7, boost::test_tools::tolerance(0.02));
  BOOST_TEST(impulse == world.twist(floe).linear.x * kDensity * 4 * 0.3, boost::test_tools::tolerance(0.02));
  BOOST_TEST(world.pose(wall).position.x == 0.7, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(No_point_of_Bullet_bears_more_than_its_bound_in_a_jam_and_the_energies_close) {
  Scene scene;
  double energy = 0.0, given = 0.0;
  std::size_t at_bound = 0, points = 0, on_sheet = 0;
  for (int i = 0; i < 150; ++i) {
    scene.step(0.01);
    for (const ContactLoad& c : scene.world.contacts()) {
      BOOST_TEST(c.normal_force <= kPressure * c.area * (1.0 + 1e-12));
      const double mu = c.other == scene.structure ? 0.027 : 0.3;
      // Bullet bounds each of two directions, and leaves the friction of a point that has come to bear nothing.
      if (c.normal_force > 0.0)
        BOOST_TEST(norm(c.friction_force) <= std::sqrt(2.0) * mu * c.normal_force * (1.0 + 1e-9));
      given += 0.01 * (normal_power(c) + friction_power(c));
      if (c.other == scene.structure)
        given += 0.01 * dot(c.normal_force * c.normal + c.friction_force, c.other_velocity);
      at_bound += c.at_bound ? 1 : 0;
      on_sheet += c.other_kind == BodyKind::kSheet ? 1 : 0;
      ++points;
    }
    energy = scene.world.kinetic_energy();
  }
  BOOST_TEST_MESSAGE(points << " points, " << at_bound << " at their bound, " << on_sheet << " on the sheet, energy "
                            << energy << " J, given by contacts " << given << " J");
  BOOST_TEST(at_bound > 0U);
  BOOST_TEST(at_bound < points);
  BOOST_TEST(on_sheet > 0U);
  // The implicit gyroscopic term loses a little of the energy of turning.
  BOOST_TEST(given == energy, boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(Floes_born_with_a_common_edge_are_not_thrown_by_Bullet) {
  World world(bullet());
  std::vector<BodyId> floes;
  for (int i = 0; i < 3; ++i) floes.push_back(add_floe(world, rectangle({2.0 * i, 0}, {2.0 * i + 2, 1.5}), 0.33));
  world.add_sheet_part(rectangle({-3, 0}, {0, 1.5}), -0.165, 0.165);
  for (int i = 0; i < 100; ++i) world.step(0.01);
  BOOST_TEST(world.kinetic_energy() < 1e-12);
}

BOOST_AUTO_TEST_CASE(A_settled_floe_that_Bullet_sees_hit_is_let_go) {
  WorldSettings settings = bullet();
  settings.release_speed = 0.1;
  World world(settings);
  const BodyId rests = add_floe(world, rectangle({-1, -1}, {1, 1}), 0.5);
  add_floe(world, rectangle({1.02, -1}, {3, 1}), 0.5, {{-0.5, 0, 0}, {}});
  world.set_settled(rests, true);
  for (int i = 0; i < 30; ++i) world.step(0.01);
  BOOST_TEST(!world.is_settled(rests));
  BOOST_TEST(world.twist(rests).linear.x < -0.1);
}

BOOST_AUTO_TEST_CASE(A_repeated_run_of_Bullet_gives_the_same_bytes) {
  Scene one, other;
  for (int i = 0; i < 100; ++i) {
    one.step(0.01);
    other.step(0.01);
  }
  for (std::size_t i = 0; i < one.floes.size(); ++i) {
    const Pose p = one.world.pose(one.floes[i]), q = other.world.pose(other.floes[i]);
    BOOST_TEST(std::memcmp(&p, &q, sizeof p) == 0);
  }
}
