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

}  // namespace
