// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>

#include "pool.hpp"

namespace {

using namespace brash;
using namespace brash::simulation;
using namespace brash::simulation::testing;

BOOST_AUTO_TEST_CASE(a_floe_squeezed_at_the_bound_has_the_stress_sigma_c_R_and_is_not_deleted) {
  // Two walls close on a floe of 2 m by 1 m. The ice yields at the bound over both whole faces, so the mean stress is
  // sigma_c R, less the share d / L that the points, at the middle of the overlaps, stand nearer to each other.
  Pool pool;
  const BodyId floe = pool.add({-1, -0.5}, {1, 0.5}, {});
  const std::vector<Vec3> block{{-1, -2, -1}, {0, -2, -1}, {0, 2, -1}, {-1, 2, -1},
                                {-1, -2, 1},  {0, -2, 1},  {0, 2, 1},  {-1, 2, 1}};
  Pose left{{-1.0, 0.0, 0.0}, {}};
  Pose right{{2.0, 0.0, 0.0}, {}};
  const BodyId from_left = pool.world.add_structure(std::span(&block, 1), left);
  const BodyId from_right = pool.world.add_structure(std::span(&block, 1), right);
  // When two walls close this slowly, each sweep of the solver adds about m v to their impulse: 30 sweeps are too few
  // in steps of 10 ms.
  const double dt = 0.005;
  const double speed = 0.02;
  const int n_steps = 100;
  for (int i = 0; i < n_steps; ++i) {
    left.position.x += speed * dt;
    right.position.x -= speed * dt;
    pool.world.move_structure(from_left, left, {{speed, 0, 0}, {}});
    pool.world.move_structure(from_right, right, {{-speed, 0, 0}, {}});
    (void)pool.step(dt);
    pool.take_stress(dt);
  }
  const double bound = 0.5e6;
  const double depth = n_steps * dt * speed;
  // Half a second is ten collision times (47 ms); of the depth's growth the average sees the last tenth late.
  BOOST_TEST(pool.floes.at(floe).stress.peak_compression == bound * (1.0 - depth / 2.0),
             boost::test_tools::tolerance(2e-3));
  BOOST_TEST(floes::overstressed(pool.world, pool.floes, 1.0e6).empty());
  BOOST_TEST(floes::overstressed(pool.world, pool.floes, 0.98 * bound).size() == 1u);
}

/// Mean compression [Pa] of a floe of 2 m by 1 m that a load of 10 kN presses against a wall, both in uniform motion.
double compression_against_a_wall(double speed) {
  Pool pool({"hydrodynamics.form_drag=0", "hydrodynamics.skin_friction=0"});
  const double dt = 0.01;
  const BodyId floe = pool.add({0, -0.5}, {2, 0.5}, {{speed, 0, 0}, {}});
  const std::vector<Vec3> block{{-1, -2, -1}, {0, -2, -1}, {0, 2, -1}, {-1, 2, -1},
                                {-1, -2, 1},  {0, -2, 1},  {0, 2, 1},  {-1, 2, 1}};
  Pose wall{{0.001, 0.0, 0.0}, {}};
  const BodyId body = pool.world.add_structure(std::span(&block, 1), wall);
  for (int i = 0; i < 100; ++i) {
    wall.position.x += speed * dt;
    pool.world.move_structure(body, wall, {{speed, 0, 0}, {}});
    pool.world.apply(floe, {{-1e4, 0, 0}, {}});
    (void)pool.step(dt);
    pool.take_stress(dt);
  }
  return pool.floes.at(floe).stress.peak_compression;
}

/// Force of a wall on a floe of 1 m by 1 m that 1 MN presses 1 mm into it, in the first step [N].
double force_of_a_wall(const std::string& bound) {
  Pool pool({"contact.crushing_bound=" + bound});
  const BodyId floe = pool.add({0, -0.5}, {1, 0.5}, {});
  const std::vector<Vec3> block{{-1, -2, -1}, {0, -2, -1}, {0, 2, -1}, {-1, 2, -1},
                                {-1, -2, 1},  {0, -2, 1},  {0, 2, 1},  {-1, 2, 1}};
  pool.world.add_structure(std::span(&block, 1), {{0.001, 0.0, 0.0}, {}});
  pool.world.apply(floe, {{-1e6, 0.0, 0.0}, {}});
  (void)pool.step(0.01);
  double force = 0.0;
  for (const rigid_body::ContactLoad& contact : pool.world.contacts()) force += contact.normal_force;
  return force;
}

BOOST_AUTO_TEST_CASE(floes_are_rigid_where_the_crushing_bound_is_of_level_ice_alone) {
  // sigma_c R on a face of 1 m by 0.33 m; a rigid floe at rest carries its whole load.
  BOOST_TEST(force_of_a_wall("all") == 0.5e6 * 0.33, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(force_of_a_wall("level-ice") == 1e6, boost::test_tools::tolerance(1e-3));
}

/// A floe of 2 m by 1 m at rest before a wall that is 0.5 m wide and covers 1 mm of it.
struct Pressed : Pool {
  explicit Pressed(const std::string& law) : Pool({"contact.floe_stress=" + law}), floe(add({0, -0.5}, {2, 0.5}, {})) {
    const std::vector<Vec3> block{{-1, -0.25, -1}, {0, -0.25, -1}, {0, 0.25, -1}, {-1, 0.25, -1},
                                  {-1, -0.25, 1},  {0, -0.25, 1},  {0, 0.25, 1},  {-1, 0.25, 1}};
    world.add_structure(std::span(&block, 1), {{0.001, 0.0, 0.0}, {}});
  }
  /// Its compression after a step under `force` [Pa].
  double step_under(double force) {
    world.apply(floe, {{-force, 0, 0}, {}});
    (void)step(0.01);
    take_stress(0.01);
    return floes.at(floe).compression;
  }
  BodyId floe;
};

BOOST_AUTO_TEST_CASE(the_stress_of_a_floe_is_of_a_step_or_of_a_contact_or_averaged) {
  const double mean = 1e4 / (2.0 * 0.33);  // 10 kN at 1 m from the middle, over the volume
  const double at_contact = 1e4 / (0.5 * 0.33);
  const auto close = boost::test_tools::tolerance(0.01);  // the floe turns a little
  Pressed step("step"), contact("contact"), averaged("averaged");
  BOOST_TEST(step.step_under(1e4) == mean, close);
  BOOST_TEST(contact.step_under(1e4) == at_contact, close);
  const double share = floes::averaging_share(averaged.floes.at(averaged.floe), 0.01);
  BOOST_TEST(averaged.step_under(1e4) == share * mean, close);
  // The step after has no load, and the largest compression stays on record.
  BOOST_TEST(step.step_under(0.0) < 0.01 * mean);
  BOOST_TEST(contact.step_under(0.0) < 0.01 * at_contact);
  BOOST_TEST(contact.floes.at(contact.floe).stress.peak_compression == at_contact, close);
  BOOST_TEST(averaged.step_under(0.0) > 0.5 * share * mean);
}

BOOST_AUTO_TEST_CASE(a_floe_held_at_one_end_has_the_same_stress_at_rest_and_on_its_way) {
  // The wall bears 10 kN at 1 m from the middle, so the mean stress is 10 kN m over the volume.
  const double expected = 1e4 / (2.0 * 0.33);
  BOOST_TEST(compression_against_a_wall(0.0) == expected, boost::test_tools::tolerance(0.01));
  BOOST_TEST(compression_against_a_wall(10.0) == expected, boost::test_tools::tolerance(0.01));
}

}  // namespace
