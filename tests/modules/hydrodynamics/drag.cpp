// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/hydrodynamics/water.hpp"
#include "shapes.hpp"

namespace {

using namespace brash;
using namespace brash::test;
using hydrodynamics::Water;
using hydrodynamics::water_load;
using hydrodynamics::WaterLoad;

const Pose kDeep{{0.0, 0.0, -10.0}, {}};

Water without_skin_friction() {
  Water water;
  water.skin_friction = 0.0;
  return water;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(drag)

BOOST_AUTO_TEST_CASE(water_at_rest_does_not_drag_a_floe_at_rest) {
  const WaterLoad load = water_load(box(3.0, 2.0, 0.5), kDeep, {}, Water{});
  BOOST_CHECK(load.drag == Wrench{});
  BOOST_CHECK(load.skin_friction == Wrench{});
}

BOOST_AUTO_TEST_CASE(a_floe_that_drifts_with_the_current_feels_no_drag) {
  Water water;
  water.current = {0.4, -0.3};
  const WaterLoad load = water_load(box(3.0, 2.0, 0.5), kDeep, {{0.4, -0.3, 0.0}, {}}, water);
  BOOST_CHECK(load.drag == Wrench{});
  BOOST_CHECK(load.skin_friction == Wrench{});
}

BOOST_AUTO_TEST_CASE(form_drag_of_a_box_is_equation_13_with_the_leading_faces_only) {
  Water water = without_skin_friction();
  water.form_drag = 0.8;
  // Fully submerged, moving askew: the faces +x, -y and +z lead.
  const Vec3 velocity{1.5, -0.7, 0.2};
  const WaterLoad load = water_load(box(3.0, 2.0, 0.5), kDeep, {velocity, {}}, water);
  const double speed = norm(velocity);
  const double projected = (2.0 * 0.5 * 1.5 + 3.0 * 0.5 * 0.7 + 3.0 * 2.0 * 0.2) / speed;
  const Vec3 expected = -0.5 * 0.8 * water.density * projected * speed * velocity;
  BOOST_CHECK_SMALL(norm(load.drag.force - expected), 1e-12 * norm(expected));  // rounding
  BOOST_CHECK_SMALL(norm(load.drag.moment), 1e-12 * norm(expected));            // acts at the centre
}

BOOST_AUTO_TEST_CASE(the_drag_of_a_floating_box_counts_its_draft_and_acts_at_the_centre_of_buoyancy) {
  const Water water = without_skin_friction();
  const double draft = 0.4;
  const Pose pose{{0.0, 0.0, 0.25 - draft}, {}};
  const WaterLoad load = water_load(box(3.0, 2.0, 0.5), pose, {{-2.0, 0.0, 0.0}, {}}, water);
  const double expected = 0.5 * water.density * (2.0 * draft) * 4.0;
  BOOST_CHECK_CLOSE_FRACTION(load.drag.force.x, expected, 1e-13);
  // The centre of buoyancy lies at -draft/2, the centre of mass at 0.25 - draft: arm -0.05 m.
  BOOST_CHECK_CLOSE_FRACTION(load.drag.moment.y, -0.05 * expected, 1e-12);
}

BOOST_AUTO_TEST_CASE(a_box_lifted_out_of_the_water_has_no_drag_on_its_dry_top) {
  const Water water = without_skin_friction();
  const Pose floating{{0.0, 0.0, 0.1}, {}};
  const Prism floe = box(3.0, 2.0, 0.5);
  BOOST_TEST(water_load(floe, floating, {{0.0, 0.0, 1.0}, {}}, water).drag.force.z == 0.0);
  BOOST_CHECK_CLOSE_FRACTION(water_load(floe, floating, {{0.0, 0.0, -1.0}, {}}, water).drag.force.z,
                             0.5 * water.density * 6.0, 1e-13);
}

BOOST_AUTO_TEST_CASE(drag_turns_with_the_floe) {
  const Water water{};
  const Prism floe = notched_plate(0.6);
  const Quaternion q = turn({1.0, 2.0, -1.0}, 0.8);
  const Vec3 velocity{1.0, -2.0, 0.5}, spin{0.2, 0.1, -0.4};
  const WaterLoad level = water_load(floe, kDeep, {velocity, spin}, water);
  const WaterLoad turned = water_load(floe, {kDeep.position, q}, {rotate(q, velocity), rotate(q, spin)}, water);
  BOOST_CHECK_SMALL(norm(turned.drag.force - rotate(q, level.drag.force)), 1e-11 * norm(level.drag.force));
  BOOST_CHECK_SMALL(norm(turned.drag.moment - rotate(q, level.drag.moment)), 1e-11 * norm(level.drag.moment));
  BOOST_CHECK_SMALL(norm(turned.skin_friction.force - rotate(q, level.skin_friction.force)),
                    1e-11 * norm(level.skin_friction.force));
}

BOOST_AUTO_TEST_CASE(a_turning_box_is_braked_by_equation_14) {
  Water water = without_skin_friction();
  water.rotational_drag = 0.7;
  const Vec3 spin{0.0, 0.3, -0.4};
  const WaterLoad load = water_load(box(3.0, 2.0, 0.5), kDeep, {{}, spin}, water);
  const double l_avg = (3.0 + 2.0 + 0.5) / 3.0;
  const double wetted = 2.0 * (6.0 + 1.5 + 1.0);
  const Vec3 expected = -0.5 * 0.7 * water.density * l_avg * l_avg * l_avg * wetted * 0.5 * spin;
  BOOST_CHECK_SMALL(norm(load.drag.moment - expected), 1e-12 * norm(expected));
  BOOST_CHECK_SMALL(norm(load.drag.force), 1e-9);  // the centre of buoyancy rests, to rounding
}

BOOST_AUTO_TEST_CASE(skin_friction_of_a_sliding_box_acts_on_the_faces_along_the_motion) {
  Water water;
  water.skin_friction = 0.01;
  const WaterLoad load = water_load(box(3.0, 2.0, 0.5), kDeep, {{2.0, 0.0, 0.0}, {}}, water);
  // Top, bottom and the two long sides; the ends meet the water head-on.
  const double expected = -0.5 * water.density * 0.01 * (2.0 * 6.0 + 2.0 * 1.5) * 4.0;
  BOOST_CHECK_CLOSE_FRACTION(load.skin_friction.force.x, expected, 1e-13);
  BOOST_CHECK_SMALL(norm(load.skin_friction.moment), 1e-12 * std::abs(expected));
}

BOOST_AUTO_TEST_CASE(the_water_never_gives_power_to_a_floe_that_translates) {
  const Prism floe = notched_plate(0.6);
  for (int k = 0; k < 100; ++k) {
    const Pose pose{{0.0, 0.0, 0.6 - 0.02 * k}, turn({1.0, 0.3 * k - 3.0, 0.5}, 0.2 * k)};
    const Vec3 velocity{std::cos(0.9 * k), std::sin(1.7 * k), std::cos(2.3 * k)};
    const WaterLoad load = water_load(floe, pose, {velocity, {}}, Water{});
    BOOST_CHECK_LE(dot(load.drag.force, velocity), 0.0);
    BOOST_CHECK_LE(dot(load.skin_friction.force, velocity), 0.0);
  }
}

BOOST_AUTO_TEST_CASE(a_sinking_plate_approaches_its_terminal_velocity_as_tanh) {
  // A plate heavier than water, so that it falls; m v' = (m - rho V) g - k v^2.
  const Water water{};
  const double length = 2.0, breadth = 1.0, thickness = 0.1, density = 1500.0;
  const Prism plate = box(length, breadth, thickness);
  const double mass = density * length * breadth * thickness;
  const double k = 0.5 * water.density *
                   (water.form_drag * length * breadth + water.skin_friction * 2.0 * (length + breadth) * thickness);
  const double net_weight = (density - water.density) * length * breadth * thickness * kGravity;
  const double terminal = std::sqrt(net_weight / k);
  const double rise_time = mass / (k * terminal);

  const double dt = 1e-4 * rise_time;
  double z = -1.0, velocity = 0.0;
  const auto advance = [&](double duration) {
    const int steps = static_cast<int>(std::lround(duration / dt));
    for (int i = 0; i < steps; ++i) {
      const WaterLoad load = water_load(plate, {{0.0, 0.0, z}, {}}, {{0.0, 0.0, velocity}, {}}, water);
      const double force = load.buoyancy.force.z + load.drag.force.z + load.skin_friction.force.z - mass * kGravity;
      velocity += force / mass * dt;
      z += velocity * dt;
    }
  };
  advance(rise_time);
  BOOST_CHECK_CLOSE_FRACTION(-velocity, terminal * std::tanh(1.0), 1e-3);  // Euler errs by dt / rise time = 1e-4
  advance(7.0 * rise_time);
  BOOST_CHECK_CLOSE_FRACTION(-velocity, terminal, 1e-3);  // 1 - tanh(8) = 2e-7
}

BOOST_AUTO_TEST_CASE(a_step_s_drag_follows_the_exact_decay_where_the_instant_s_drag_overshoots) {
  const Water water = without_skin_friction();
  const double length = 3.0, breadth = 3.0, thickness = 0.33, mass = 1.5 * 900.0 * length * breadth * thickness;
  const Prism floe = box(length, breadth, thickness);
  const Vec3 inertia = mass / 12.0 *
                       Vec3{breadth * breadth + thickness * thickness, length * length + thickness * thickness,
                            length * length + breadth * breadth};
  const double l_avg = (length + breadth + thickness) / 3.0;
  const double wetted = 2.0 * (length * breadth + (length + breadth) * thickness);
  const double rate = 0.5 * water.density * l_avg * l_avg * l_avg * wetted / inertia.x;  // Omega' = -rate Omega^2

  const double dt = 0.01;
  double instant = 8.0, step = 8.0;
  for (int i = 1; i <= 100; ++i) {
    const auto brake = [&](double spin, const hydrodynamics::StepInertia& how) {
      // The floe is held level, so that nothing but the spin changes.
      return spin + water_load(floe, kDeep, {{}, {spin, 0.0, 0.0}}, water, how).drag.moment.x / inertia.x * dt;
    };
    if (i == 1) instant = brake(instant, {});
    step = brake(step, {dt, mass, inertia});
    // Repeating the exact map of one step gives the exact decay.
    BOOST_CHECK_CLOSE_FRACTION(step, 8.0 / (1.0 + rate * 8.0 * i * dt), 1e-12);
  }
  BOOST_TEST(instant < -8.0);  // turned round, and faster
}

BOOST_AUTO_TEST_CASE(a_step_s_drag_tends_to_the_instant_s_drag_as_the_step_vanishes) {
  const Prism floe = notched_plate(0.6);
  const Pose pose{{0.0, 0.0, -0.1}, turn({1.0, 0.4, 0.5}, 0.6)};
  const Twist twist{{1.0, -2.0, 0.5}, {0.2, 0.1, -0.4}};
  const WaterLoad instant = water_load(floe, pose, twist, Water{});
  double last = 0.0;
  for (const double dt : {1e-3, 1e-4, 1e-5}) {
    const WaterLoad step = water_load(floe, pose, twist, Water{}, {dt, 7000.0, {9000.0, 12000.0, 20000.0}});
    const double error = norm(step.drag.force - instant.drag.force) / norm(instant.drag.force);
    BOOST_TEST(error > 0.0);
    if (last > 0.0) BOOST_TEST(error < 0.11 * last);  // first order: a tenth, and a little for the second order
    last = error;
    BOOST_CHECK(step.buoyancy == instant.buoyancy);
  }
}

BOOST_AUTO_TEST_SUITE_END()
