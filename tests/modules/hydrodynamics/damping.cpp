// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/hydrodynamics/damping.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

namespace {

using namespace brash;
using hydrodynamics::Damping;
using hydrodynamics::StepInertia;

BOOST_AUTO_TEST_CASE(the_velocity_after_a_step_is_that_at_which_the_dampers_act) {
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&] { return Vec3{unit(engine), unit(engine), unit(engine)}; };
  for (int k = 0; k < 500; ++k) {
    Damping damping;
    // From no damping to many times the damping that stops the floe in one step.
    const double most = k % 10 == 0 ? 0.0 : std::pow(10.0, 6.0 * unit(engine));
    for (int i = 0; i < k % 7; ++i) damping.add(most * (1.0 + unit(engine)), 2.0 * vector());
    if (k % 3 == 0) damping.rotation = most;
    const StepInertia step{.dt = 0.01, .mass = 1200.0, .inertia = {300.0, 500.0, 700.0}};
    const Twist before{vector(), vector()};
    const Wrench load{1e4 * vector(), 1e3 * vector()};
    const Twist after = damping.velocity_after(before, load, step);
    const Wrench drag = damping.load(after);

    const Vec3 linear = step.mass * (after.linear - before.linear) - step.dt * (load.force + drag.force);
    const auto change = after.angular - before.angular;
    const Vec3 angular =
        Vec3{300.0 * change.x, 500.0 * change.y, 700.0 * change.z} - step.dt * (load.moment + drag.moment);
    // Rounding of the terms: dampers of up to 1e7 kg/s at 2 m, loads of 1e4 N.
    const double scale = 1e4 + most;
    BOOST_TEST(norm(linear) < 1e-12 * scale);
    BOOST_TEST(norm(angular) < 1e-12 * scale);
  }
}

/// A damper along the normal `n` in the point `x`, by its definition.
void add_along(Damping& damping, double c, Vec3 n, Vec3 x) {
  const Vec3 w = cross(x, n);
  auto& d = damping.normal;
  d.squares += c * Vec3{n.x * n.x, n.y * n.y, n.z * n.z};
  d.products += c * Vec3{n.y * n.z, n.z * n.x, n.x * n.y};
  d.with_x += c * n.x * w;
  d.with_y += c * n.y * w;
  d.with_z += c * n.z * w;
  d.turning_squares += c * Vec3{w.x * w.x, w.y * w.y, w.z * w.z};
  d.turning_products += c * Vec3{w.y * w.z, w.z * w.x, w.x * w.y};
}

BOOST_AUTO_TEST_CASE(a_damper_along_a_normal_acts_there_and_along_it_alone) {
  Damping damping;
  const Vec3 n = normalized(Vec3{1.0, -2.0, 0.5}), x{0.7, 0.2, -1.1};
  add_along(damping, 30.0, n, x);
  const Twist twist{{0.4, 1.0, -0.2}, {0.3, -0.6, 0.9}};
  const Vec3 force = -30.0 * dot(n, velocity_at(twist, x)) * n;
  const Wrench load = damping.load(twist);
  BOOST_TEST(norm(load.force - force) < 1e-13);  // rounding
  BOOST_TEST(norm(load.moment - cross(x, force)) < 1e-13);
}

BOOST_AUTO_TEST_CASE(the_velocity_after_a_step_is_that_at_which_dampers_along_normals_act_with_mass_by_direction) {
  std::mt19937_64 engine(12);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&] { return Vec3{unit(engine), unit(engine), unit(engine)}; };
  for (int k = 0; k < 500; ++k) {
    Damping damping;
    const double most = std::pow(10.0, 6.0 * unit(engine));
    for (int i = 0; i < k % 5; ++i)
      add_along(damping, most * (1.0 + unit(engine)), normalized(vector()), 2.0 * vector());
    if (k % 3 == 0) damping.add(most, vector());
    const StepInertia step{.dt = 0.01, .mass = 1200.0, .inertia = {300.0, 500.0, 700.0}, .added_across = 2500.0};
    const Twist before{vector(), vector()};
    const Wrench load{1e4 * vector(), 1e3 * vector()};
    const Twist after = damping.velocity_after(before, load, step);
    const Wrench drag = damping.load(after);

    const Vec3 gained = after.linear - before.linear, turned = after.angular - before.angular;
    const Vec3 linear =
        Vec3{1200.0 * gained.x, 1200.0 * gained.y, 3700.0 * gained.z} - step.dt * (load.force + drag.force);
    const Vec3 angular =
        Vec3{300.0 * turned.x, 500.0 * turned.y, 700.0 * turned.z} - step.dt * (load.moment + drag.moment);
    BOOST_TEST(norm(linear) < 1e-12 * (1e4 + most));  // rounding of the terms
    BOOST_TEST(norm(angular) < 1e-12 * (1e4 + most));
  }
}

}  // namespace
