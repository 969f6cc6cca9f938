// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "brash/core/constants.hpp"
#include "brash/hydrodynamics/water.hpp"
#include "shapes.hpp"

namespace {

using namespace brash;
using namespace brash::test;
using hydrodynamics::Displacement;
using hydrodynamics::Drag;
using hydrodynamics::DragLaw;
using hydrodynamics::FormDragAlong;
using hydrodynamics::StepInertia;
using hydrodynamics::Water;
using hydrodynamics::water_load;
using hydrodynamics::WaterLoad;

const Pose kDeep{{0.0, 0.0, -10.0}, {}};

Water without_skin_friction(DragLaw law = DragLaw::kSurface) {
  Water water;
  water.drag_law = law;
  water.skin_friction = 0.0;
  return water;
}

/// The half-spaces of an upright box.
std::array<Plane, 6> solid_box(Vec3 lower, Vec3 upper) {
  return {Plane{{-1, 0, 0}, -lower.x}, {{1, 0, 0}, upper.x},   {{0, -1, 0}, -lower.y},
          Plane{{0, 1, 0}, upper.y},   {{0, 0, -1}, -lower.z}, {{0, 0, 1}, upper.z}};
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
  water.current = {0.4, -0.3, 0.0};
  const WaterLoad load = water_load(box(3.0, 2.0, 0.5), kDeep, {{0.4, -0.3, 0.0}, {}}, water);
  BOOST_CHECK(load.drag == Wrench{});
  BOOST_CHECK(load.skin_friction == Wrench{});
}

BOOST_AUTO_TEST_CASE(form_drag_of_a_box_is_equation_13_with_the_leading_faces_only) {
  // Fully submerged, moving askew: the faces +x, -y and +z lead.
  const Vec3 velocity{1.5, -0.7, 0.2};
  const double speed = norm(velocity);
  const double projected = (2.0 * 0.5 * 1.5 + 3.0 * 0.5 * 0.7 + 3.0 * 2.0 * 0.2) / speed;
  for (const DragLaw law : {DragLaw::kSurface, DragLaw::kPaper}) {
    Water water = without_skin_friction(law);
    water.form_drag = 0.8;
    const WaterLoad load = water_load(box(3.0, 2.0, 0.5), kDeep, {velocity, {}}, water);
    const Vec3 expected = -0.5 * 0.8 * water.density * projected * speed * velocity;
    BOOST_CHECK_SMALL(norm(load.drag.force - expected), 1e-12 * norm(expected));  // rounding
    if (law == DragLaw::kPaper) BOOST_CHECK_SMALL(norm(load.drag.moment), 1e-12 * norm(expected));
  }
}

BOOST_AUTO_TEST_CASE(pressure_on_the_faces_of_a_box_acts_along_their_normals_with_the_normal_velocity) {
  Water water = without_skin_friction();
  water.form_drag = 0.8;
  water.form_drag_along = FormDragAlong::kNormal;
  const double scale = 0.5 * 0.8 * water.density;
  // Fully submerged, moving askew: the faces +x, -y and +z lead.
  const WaterLoad load = water_load(box(3.0, 2.0, 0.5), kDeep, {{1.5, -0.7, 0.2}, {}}, water);
  const Vec3 expected = scale * Vec3{-1.0 * 1.5 * 1.5, 1.5 * 0.7 * 0.7, -6.0 * 0.2 * 0.2};
  BOOST_CHECK_SMALL(norm(load.drag.force - expected), 1e-12 * norm(expected));  // rounding
  BOOST_CHECK_SMALL(norm(load.drag.moment), 1e-12 * norm(expected));

  // A plate that turns about its middle, 3 m long: each half leads with one face, on L^4 / 32 in all.
  const double spin = 0.7;
  const WaterLoad turning = water_load(box(3.0, 2.0, 1e-5), kDeep, {{}, {0.0, spin, 0.0}}, water);
  BOOST_CHECK_CLOSE_FRACTION(turning.drag.moment.y, -scale * spin * spin * 2.0 * 81.0 / 32.0, 1e-10);
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
  Water water = without_skin_friction(DragLaw::kPaper);
  water.rotational_drag = 0.7;
  const Vec3 spin{0.0, 0.3, -0.4};
  const WaterLoad load = water_load(box(3.0, 2.0, 0.5), kDeep, {{}, spin}, water);
  const double l_avg = (3.0 + 2.0 + 0.5) / 3.0;
  const double wetted = 2.0 * (6.0 + 1.5 + 1.0);
  const Vec3 expected = -0.5 * 0.7 * water.density * l_avg * l_avg * l_avg * wetted * 0.5 * spin;
  BOOST_CHECK_SMALL(norm(load.drag.moment - expected), 1e-12 * norm(expected));
  BOOST_CHECK_SMALL(norm(load.drag.force), 1e-9);  // the centre of buoyancy rests, to rounding
}

BOOST_AUTO_TEST_CASE(a_plate_that_turns_about_its_middle_is_braked_strip_by_strip) {
  const Water water = without_skin_friction();
  const double length = 3.0, breadth = 2.0, spin = 0.7;
  const double scale = 0.5 * water.density * spin * spin * breadth;
  for (const double h : {0.5, 1e-5}) {
    const WaterLoad load = water_load(box(length, breadth, h), kDeep, {{}, {0.0, spin, 0.0}}, water);
    // The power over the spin: |n . u| |u|^2 with u = Omega (z, 0, -x) over the leading half of each face.
    const double l2 = length * length, h2 = h * h;
    const double exact = scale * (l2 * l2 / 32.0 + l2 * h2 / 8.0 + h2 * h2 / 32.0);
    BOOST_CHECK_CLOSE_FRACTION(-load.drag.moment.y, exact, 1e-13);  // rounding: the quadrature is exact
    BOOST_CHECK_SMALL(norm(load.drag.force), 1e-12 * scale);
  }
  // Thin: strips alone, 0.5 rho C_d Omega^2 B L^4 / 32; thickness adds 4 (h / L)^2, 4e-11 here.
  const WaterLoad thin = water_load(box(length, breadth, 1e-5), kDeep, {{}, {0.0, spin, 0.0}}, water);
  BOOST_CHECK_CLOSE_FRACTION(-thin.drag.moment.y, scale * std::pow(length, 4) / 32.0, 1e-10);
  // About its edge every strip leads on the same side: 0.5 rho C_d Omega^2 B L^4 / 4 about that edge.
  const WaterLoad swung =
      water_load(box(length, breadth, 1e-5), kDeep, {{0.0, 0.0, -0.5 * length * spin}, {0.0, spin, 0.0}}, water);
  const double about_edge = -swung.drag.moment.y + 0.5 * length * swung.drag.force.z;
  BOOST_CHECK_CLOSE_FRACTION(about_edge, scale * std::pow(length, 4) / 4.0, 1e-10);
}

BOOST_AUTO_TEST_CASE(how_a_plan_is_divided_into_parts_does_not_change_its_drag) {
  Prism whole = notched_plate(0.6), divided = whole;
  divided.parts.clear();
  for (const auto& part : whole.parts) {  // rectangles, cut askew into four triangles each
    const Vec2 centre = 0.45 * part[0] + 0.55 * part[2];
    for (std::size_t i = 0; i < 4; ++i) divided.parts.push_back({part[i], part[(i + 1) % 4], centre});
  }
  for (int k = 0; k < 50; ++k) {
    const Pose pose{{0.0, 0.0, 0.5 - 0.02 * k}, turn({1.0, 0.3 * k - 3.0, 0.5}, 0.2 * k)};
    const Twist twist{{std::cos(0.9 * k), std::sin(1.7 * k), std::cos(2.3 * k)}, {std::sin(k), std::cos(3.0 * k), 0.3}};
    const WaterLoad a = water_load(whole, pose, twist, without_skin_friction());
    const WaterLoad b = water_load(divided, pose, twist, without_skin_friction());
    // Each part is integrated exactly between waterline and lee; rounding is left.
    const double scale = norm(a.drag.force) + norm(a.drag.moment);
    BOOST_CHECK_SMALL(norm(a.drag.force - b.drag.force), 1e-12 * scale);
    BOOST_CHECK_SMALL(norm(a.drag.moment - b.drag.moment), 1e-12 * scale);
  }
}

BOOST_AUTO_TEST_CASE(a_box_has_the_same_drag_whichever_of_its_faces_are_taken_for_top_and_bottom) {
  // Sides are integrated on trapezoids between waterline and lee, top and bottom on triangles: both exactly.
  const Prism flat = box(3.0, 2.0, 0.9), upright = box(3.0, 0.9, 2.0);
  const double c = std::sqrt(0.5);
  for (int k = 0; k < 200; ++k) {
    const Quaternion q = turn({1.0, 0.3 * k - 3.0, 0.5}, 0.2 * k);
    const Quaternion turned{c * (q.w - q.x), c * (q.w + q.x), c * (q.y + q.z), c * (q.z - q.y)};  // a quarter about x
    const Vec3 position{0.0, 0.0, 1.0 - 0.01 * k};
    const Twist twist{{std::cos(0.9 * k), std::sin(1.7 * k), std::cos(2.3 * k)}, {std::sin(k), std::cos(3.0 * k), 0.3}};
    const WaterLoad a = water_load(flat, {position, q}, twist, without_skin_friction());
    const WaterLoad b = water_load(upright, {position, turned}, twist, without_skin_friction());
    const double scale = norm(a.drag.force) + norm(a.drag.moment);
    BOOST_CHECK_SMALL(norm(a.drag.force - b.drag.force), 1e-12 * scale);  // rounding
    BOOST_CHECK_SMALL(norm(a.drag.moment - b.drag.moment), 1e-12 * scale);
  }
}

BOOST_AUTO_TEST_CASE(skin_friction_of_a_sliding_box_acts_on_the_faces_along_the_motion) {
  for (const DragLaw law : {DragLaw::kSurface, DragLaw::kPaper}) {
    Water water;
    water.drag_law = law;
    water.skin_friction = 0.01;
    const WaterLoad load = water_load(box(3.0, 2.0, 0.5), kDeep, {{2.0, 0.0, 0.0}, {}}, water);
    // Top, bottom and the two long sides; the ends meet the water head-on.
    const double expected = -0.5 * water.density * 0.01 * (2.0 * 6.0 + 2.0 * 1.5) * 4.0;
    BOOST_CHECK_CLOSE_FRACTION(load.skin_friction.force.x, expected, 1e-13);
    BOOST_CHECK_SMALL(norm(load.skin_friction.moment), 1e-12 * std::abs(expected));
  }
}

BOOST_AUTO_TEST_CASE(the_water_never_gives_power_to_a_floe_that_translates) {
  const Prism floe = notched_plate(0.6);
  for (int k = 0; k < 100; ++k) {
    const Pose pose{{0.0, 0.0, 0.6 - 0.02 * k}, turn({1.0, 0.3 * k - 3.0, 0.5}, 0.2 * k)};
    const Vec3 velocity{std::cos(0.9 * k), std::sin(1.7 * k), std::cos(2.3 * k)};
    for (const DragLaw law : {DragLaw::kSurface, DragLaw::kPaper}) {
      const WaterLoad load = water_load(floe, pose, {velocity, {}}, {.drag_law = law});
      BOOST_CHECK_LE(dot(load.drag.force, velocity), 0.0);
      BOOST_CHECK_LE(dot(load.skin_friction.force, velocity), 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(drag_on_the_surface_takes_energy_from_every_motion_and_never_reverses_one) {
  const Prism floe = notched_plate(0.6);
  const double mass = 7000.0;
  const Vec3 inertia{9000.0, 12000.0, 20000.0};
  for (int k = 0; k < 100; ++k) {
    const Pose pose{{0.0, 0.0, 0.6 - 0.02 * k}, turn({1.0, 0.3 * k - 3.0, 0.5}, 0.2 * k)};
    const Vec3 velocity{std::cos(0.9 * k), std::sin(1.7 * k), std::cos(2.3 * k)};
    const Vec3 spin{std::sin(1.1 * k), std::cos(0.7 * k), std::sin(3.1 * k)};
    const Water water = without_skin_friction();
    // From the drag of the instant to a step in which hardly anything would be left.
    for (const double dt : {0.0, 0.01, 1000.0}) {
      // Weightless in a step: weight takes buoyancy away, which may not turn the floe either.
      const Wrench now = water_load(floe, pose, {velocity, spin}, water).drag;
      BOOST_CHECK_LE(dot(now.force, velocity) + dot(now.moment, spin), 0.0);
      if (norm(pose.position) == 0.0 || dt == 0.0) continue;
      const Pose deep{{0.0, 0.0, -10.0}, pose.rotation};
      const double weight = water.density * kGravity * 13.0 * 0.6;
      const Wrench f = water_load(floe, deep, {velocity, spin}, water, {dt, mass, inertia, weight}).drag;
      const Vec3 end = velocity + dt / mass * f.force;
      const Quaternion to_axes = conjugate(pose.rotation);
      const Vec3 turned = rotate(to_axes, f.moment), start = rotate(to_axes, spin);
      const Vec3 end_spin = start + dt * Vec3{turned.x / inertia.x, turned.y / inertia.y, turned.z / inertia.z};
      const auto energy = [&](Vec3 v, Vec3 w) {
        return 0.5 * mass * dot(v, v) + 0.5 * (inertia.x * w.x * w.x + inertia.y * w.y * w.y + inertia.z * w.z * w.z);
      };
      BOOST_CHECK_LT(energy(end, end_spin), energy(velocity, start));
      // The momenta before and after share a direction: M V . M^-1 M V' >= 0.
      BOOST_CHECK_GT(mass * dot(velocity, end) + inertia.x * start.x * end_spin.x + inertia.y * start.y * end_spin.y +
                         inertia.z * start.z * end_spin.z,
                     0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_plate_behind_another_has_the_drag_of_one_that_water_does_not_reach) {
  Water water{};
  water.shading_gap = 0.2;
  const Prism plate = box(3.0, 2.0, 0.4);
  const auto sinking = [&](std::vector<std::array<Plane, 6>> solids, Water how) {
    std::vector<Solid> neighbours(solids.begin(), solids.end());
    return water_load(plate, kDeep, {{0.0, 0.0, -1.2}, {}}, how, {}, neighbours);
  };
  const double free = 0.5 * water.density * 6.0 * 1.2 * 1.2;
  const double bottom = -10.2;
  const auto below = [&](double gap) { return solid_box({-2, -2, bottom - gap - 0.4}, {2, 2, bottom - gap}); };
  BOOST_CHECK_CLOSE_FRACTION(sinking({}, water).drag.force.z, free, 1e-13);
  // Against a neighbour, and up to half the gap: nothing. At the gap: half. Beyond one and a half gaps: all of it.
  for (const auto& [gap, share] : {std::pair{-0.05, 0.0},
                                   {0.0, 0.0},
                                   {0.0999, 0.0},
                                   {0.15, 0.25},
                                   {0.2, 0.5},
                                   {0.25, 0.75},
                                   {0.3001, 1.0},
                                   {5.0, 1.0}})
    BOOST_CHECK_SMALL(sinking({below(gap)}, water).drag.force.z - share * free, 1e-12 * free);
  // The edges of the plate stay in the free stream for skin friction; the face itself has none either way.
  Water open = water;
  open.shading_gap = 0.0;
  BOOST_CHECK_CLOSE_FRACTION(sinking({below(0.0)}, open).drag.force.z, free, 1e-13);
  // A neighbour of two parts is as tight as one of a piece; one on the lee side does nothing.
  const auto left = solid_box({-2, -2, bottom - 0.4}, {0.3, 2, bottom});
  const auto right = solid_box({0.3, -2, bottom - 0.4}, {2, 2, bottom});
  BOOST_CHECK_SMALL(sinking({left, right}, water).drag.force.z, 1e-12 * free);
  BOOST_CHECK_CLOSE_FRACTION(sinking({solid_box({-2, -2, -9.8}, {2, 2, -9.4})}, water).drag.force.z, free, 1e-13);
  // Covered up to the middle: half of it, to the resolution of four points in each triangle.
  const double half = sinking({solid_box({-2, -2, bottom - 0.4}, {0, 2, bottom})}, water).drag.force.z;
  BOOST_CHECK_SMALL(half - 0.5 * free, 0.1 * free);
}

BOOST_AUTO_TEST_CASE(shade_turns_with_the_bodies) {
  Water water{};
  water.shading_gap = 0.2;
  const Prism plate = box(3.0, 2.0, 0.4);
  const auto solid = solid_box({-1, -2, -0.9}, {2, 2, -0.25});
  const Quaternion q = turn({1.0, 2.0, -1.0}, 0.8);
  const Pose pose{{1.0, 2.0, -20.0}, q};
  std::array<Plane, 6> placed = solid, level = solid;
  for (Plane& plane : placed) {
    plane.normal = rotate(q, plane.normal);
    plane.offset += dot(plane.normal, pose.position);
  }
  for (Plane& plane : level) plane.offset += dot(plane.normal, kDeep.position);
  const Vec3 velocity{0.4, 0.2, -1.0}, spin{0.3, -0.2, 0.1};
  const Solid here = level, there = placed;
  const Wrench a = water_load(plate, kDeep, {velocity, spin}, water, {}, std::span(&here, 1)).drag;
  const Wrench b =
      water_load(plate, pose, {rotate(q, velocity), rotate(q, spin)}, water, {}, std::span(&there, 1)).drag;
  BOOST_CHECK_SMALL(norm(rotate(q, a.force) - b.force), 1e-11 * norm(a.force));
  BOOST_CHECK_SMALL(norm(rotate(q, a.moment) - b.moment), 1e-11 * norm(a.force));
  const Wrench whole = water_load(plate, kDeep, {velocity, spin}, water).drag;
  BOOST_TEST(norm(a.force) < 0.8 * norm(whole.force));
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
  const Water water = without_skin_friction(DragLaw::kPaper);
  const double length = 3.0, breadth = 3.0, thickness = 0.33, mass = 1.5 * 900.0 * length * breadth * thickness;
  const Prism floe = box(length, breadth, thickness);
  const Vec3 inertia = mass / 12.0 *
                       Vec3{breadth * breadth + thickness * thickness, length * length + thickness * thickness,
                            length * length + breadth * breadth};
  const double l_avg = (length + breadth + thickness) / 3.0;
  const double wetted = 2.0 * (length * breadth + (length + breadth) * thickness);
  const double rate = 0.5 * water.density * l_avg * l_avg * l_avg * wetted / inertia.x;  // Omega' = -rate Omega^2

  const double dt = 0.01;
  const double lift = water.density * kGravity * length * breadth * thickness;  // neither rises nor sinks
  double instant = 8.0, step = 8.0;
  for (int i = 1; i <= 100; ++i) {
    const auto brake = [&](double spin, const StepInertia& how) {
      // The floe is held level, so that nothing but the spin changes.
      return spin + water_load(floe, kDeep, {{}, {spin, 0.0, 0.0}}, water, how).drag.moment.x / inertia.x * dt;
    };
    if (i == 1) instant = brake(instant, {});
    step = brake(step, {dt, mass, inertia, lift});
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

BOOST_AUTO_TEST_CASE(drag_scales_with_the_speed_and_takes_energy_from_every_motion) {
  const Prism floe = notched_plate(0.6);
  const Pose pose{{0.0, 0.0, -0.1}, turn({1.0, 0.4, 0.5}, 0.6)};
  const Displacement wet = hydrodynamics::displacement(floe, pose);
  std::mt19937_64 engine(12);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto motion = [&] {
    const auto vector = [&] { return Vec3{unit(engine), unit(engine), unit(engine)}; };
    return Twist{vector(), vector()};
  };
  const auto power = [](const Wrench& w, const Twist& t) { return dot(w.force, t.linear) + dot(w.moment, t.angular); };
  for (const DragLaw law : {DragLaw::kSurface, DragLaw::kPaper}) {
    Water water;
    water.drag_law = law;
    for (int k = 0; k < 50; ++k) {
      const Twist slow = motion(), fast{4.0 * slow.linear, 4.0 * slow.angular}, other = motion();
      const Drag drag = hydrodynamics::drag(floe, pose, slow, water, {}, wet);
      const WaterLoad exact = water_load(floe, pose, fast, water);
      const WaterLoad scaled = water_load(pose, fast, water, {}, wet, drag.scaled(4.0));
      BOOST_CHECK_SMALL(norm(scaled.drag.force - exact.drag.force), 1e-12 * norm(exact.drag.force));
      BOOST_CHECK_SMALL(norm(scaled.drag.moment - exact.drag.moment), 1e-12 * norm(exact.drag.moment));
      BOOST_CHECK_SMALL(norm(scaled.skin_friction.force - exact.skin_friction.force), 1e-12 * norm(exact.drag.force));
      const WaterLoad kept = water_load(pose, other, water, {}, wet, drag);
      BOOST_TEST(power(kept.drag, other) <= 0.0);
      BOOST_TEST(power(kept.skin_friction, other) <= 0.0);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
