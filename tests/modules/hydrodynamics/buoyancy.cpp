// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "brash/hydrodynamics/water.hpp"
#include "shapes.hpp"

namespace {

using namespace brash;
using namespace brash::test;
using hydrodynamics::Displacement;
using hydrodynamics::displacement;
using hydrodynamics::Water;
using hydrodynamics::water_load;

const Water kWater{};

/// Submerged volume and moments by columns of the plan: along each column the height is linear, so its wetted length
/// and first moment are exact; over the plan the midpoint rule on n x n cells per convex part.
Displacement by_columns(const Prism& prism, const Pose& pose, int n) {
  const double half = 0.5 * prism.thickness;
  double volume = 0.0;
  Vec3 moment{};
  for (const auto& part : prism.parts) {
    BOOST_REQUIRE_EQUAL(part.size(), 4U);
    const double dx = (part[1].x - part[0].x) / n;
    const double dy = (part[3].y - part[0].y) / n;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const double x = part[0].x + (i + 0.5) * dx, y = part[0].y + (j + 0.5) * dy;
        const double bottom = to_world(pose, {x, y, -half}).z, top = to_world(pose, {x, y, half}).z;
        double from = -half, to = half;
        if (bottom > 0.0 && top > 0.0) continue;
        if (bottom < 0.0 && top > 0.0) to = -half + 2.0 * half * bottom / (bottom - top);
        if (bottom > 0.0 && top < 0.0) from = -half + 2.0 * half * bottom / (bottom - top);
        const double dv = dx * dy * (to - from);
        volume += dv;
        moment += dv * Vec3{x, y, 0.5 * (from + to)};
      }
    }
  }
  return {volume, to_world(pose, moment / volume)};
}

/// The same, as the sum over the convex parts, each as a solid of its own.
Displacement by_parts(const Prism& prism, const Pose& pose) {
  double volume = 0.0;
  Vec3 moment{};
  for (const auto& part : prism.parts) {
    const Displacement piece = displacement({{part}, {part}, prism.thickness}, pose);
    volume += piece.volume;
    moment += piece.volume * piece.centre;
  }
  return {volume, moment / volume};
}

/// Potential energy of the water displaced, whose gradient is minus the buoyancy.
double water_energy(const Prism& prism, const Pose& pose) {
  const Displacement d = displacement(prism, pose);
  return -kWater.density * kGravity * d.volume * d.centre.z;
}

void check_close(Vec3 a, Vec3 b, double tolerance) { BOOST_CHECK_SMALL(norm(a - b), tolerance); }

}  // namespace

BOOST_AUTO_TEST_SUITE(buoyancy)

BOOST_AUTO_TEST_CASE(a_level_floe_floats_at_rest_with_the_draft_of_archimedes) {
  const double density = 900.0, thickness = 0.33;
  const Prism floe = notched_plate(thickness);
  const double draft = density / kWater.density * thickness;
  // Bisect the height at which weight and buoyancy balance.
  double low = -thickness, high = thickness;
  const double weight = density * 13.0 * thickness * kGravity;
  for (int i = 0; i < 60; ++i) {
    const double z = 0.5 * (low + high);
    const double lift = water_load(floe, {{3.0, -2.0, z}, {}}, {}, kWater).buoyancy.force.z;
    (lift > weight ? low : high) = z;
  }
  // 1e-9 of the thickness is asked for; rounding in 13 m2 x 0.33 m leaves about 1e-15.
  BOOST_CHECK_SMALL(0.5 * (low + high) - (0.5 * thickness - draft), 1e-9 * thickness);
}

BOOST_AUTO_TEST_CASE(a_level_floe_displaces_area_times_draft_centred_at_half_draft) {
  const Prism floe = notched_plate(0.4);
  const Displacement d = displacement(floe, {{7.0, 5.0, -0.05}, turn({0, 0, 1}, 0.7)});
  BOOST_CHECK_CLOSE_FRACTION(d.volume, 13.0 * 0.25, 1e-14);  // sums of a dozen terms of the same size
  check_close(d.centre, {7.0, 5.0, -0.125}, 1e-14 * 10.0);
}

BOOST_AUTO_TEST_CASE(a_floe_in_the_air_displaces_nothing_and_feels_nothing) {
  const Prism floe = box(2.0, 1.0, 0.5);
  const Pose pose{{0.0, 0.0, 0.251}, {}};
  BOOST_TEST(displacement(floe, pose).volume == 0.0);
  const auto load = water_load(floe, pose, {{1.0, 2.0, 3.0}, {1.0, 0.0, 0.0}}, kWater);
  BOOST_CHECK(load.buoyancy == Wrench{});
  BOOST_CHECK(load.drag == Wrench{});
  BOOST_CHECK(load.skin_friction == Wrench{});
}

BOOST_AUTO_TEST_CASE(a_floe_deep_under_water_displaces_its_volume_in_any_attitude) {
  const Prism floe = notched_plate(0.4);
  for (int k = 0; k < 20; ++k) {
    const Pose pose{{100.0, -200.0, -10.0 - k}, turn({1.0, 0.3 * k, -0.2}, 0.4 * k)};
    const Displacement d = displacement(floe, pose);
    BOOST_CHECK_CLOSE_FRACTION(d.volume, 13.0 * 0.4, 1e-12);  // cones of up to 30 m x 13 m2 cancel to 5 m3
    check_close(d.centre, pose.position, 1e-12 * 200.0);
  }
}

BOOST_AUTO_TEST_CASE(a_floe_that_touches_the_waterplane_from_below_is_wholly_wet) {
  const Displacement d = displacement(box(2.0, 1.0, 0.5), {{0.0, 0.0, -0.25}, {}});
  BOOST_CHECK_CLOSE_FRACTION(d.volume, 1.0, 1e-15);
  check_close(d.centre, {0.0, 0.0, -0.25}, 1e-15);
}

BOOST_AUTO_TEST_CASE(an_almost_level_floe_keeps_its_volume_to_rounding) {
  // Tilts down to the smallest numbers: the clip line runs far away or through a face that is level.
  const Prism floe = box(4.0, 3.0, 0.5);
  for (double tilt = 1e-2; tilt > 1e-300; tilt *= 1e-3) {
    for (const double z : {-0.25, 0.0, 0.2, 0.25}) {
      const Displacement d = displacement(floe, {{1.0, 1.0, z}, turn({1.0, 2.0, 0.0}, tilt)});
      // A tilt of 1e-2 changes the volume by at most tilt x half diagonal x area = 0.3 m3, and in proportion.
      BOOST_CHECK_SMALL(d.volume - 12.0 * (0.25 - z), 31.0 * tilt + 1e-14);
      BOOST_CHECK(std::isfinite(d.centre.x + d.centre.y + d.centre.z));
    }
  }
}

BOOST_AUTO_TEST_CASE(tilted_floes_agree_with_an_integration_by_columns) {
  const Prism floe = notched_plate(0.8);
  for (int k = 0; k < 12; ++k) {
    const Pose pose{{2.0, -1.0, -0.3 + 0.1 * (k % 5)}, turn({1.0, 0.5 * k - 2.0, 0.1 * k}, 0.25 * k)};
    const Displacement exact = displacement(floe, pose);
    const Displacement columns = by_columns(floe, pose, 400);
    // The midpoint rule errs by about cell^2 = (4/400)^2 of the range of a column where the surface cuts it.
    BOOST_CHECK_SMALL(exact.volume - columns.volume, 2e-4);
    check_close(exact.centre, columns.centre, 4e-4);
  }
}

BOOST_AUTO_TEST_CASE(floes_cut_in_their_sides_alone_agree_with_an_integration_by_columns) {
  const Prism floe = notched_plate(0.8);
  for (const double angle : {0.06, kPi - 0.06}) {  // either side up
    const Pose pose{{2.0, -1.0, -0.1}, turn({1.0, 0.7, 0.0}, angle)};
    const Displacement exact = displacement(floe, pose);
    const Displacement columns = by_columns(floe, pose, 400);
    BOOST_CHECK_SMALL(exact.volume - columns.volume, 1e-12);  // linear on every column: rounding
    check_close(exact.centre, columns.centre, 2e-6);          // the midpoint rule of a quadratic
  }
}

BOOST_AUTO_TEST_CASE(rings_and_convex_parts_give_the_same_displacement) {
  const Prism floe = notched_plate(0.8);
  for (int k = 0; k < 200; ++k) {
    const Pose pose{{2.0, -1.0, -1.5 + 0.015 * k}, turn({1.0, 0.5 * k - 2.0, 0.1 * k}, 0.25 * k)};
    const Displacement rings = displacement(floe, pose);
    if (rings.volume < 1e-3) continue;  // the centroid of a sliver is ill-conditioned
    const Displacement parts = by_parts(floe, pose);
    BOOST_CHECK_SMALL(rings.volume - parts.volume, 1e-13);  // rounding of volumes up to 10 m3
    check_close(rings.centre, parts.centre, 1e-11);         // the same, divided by at least 1e-3 m3
  }
}

BOOST_AUTO_TEST_CASE(a_tilted_box_rights_itself_by_the_wall_sided_formula) {
  const double length = 5.0, breadth = 3.0, thickness = 1.0, draft = 0.6;
  const Prism floe = box(length, breadth, thickness);
  const double volume = length * breadth * draft;
  const double bm = length * breadth * breadth * breadth / 12.0 / volume;  // I / V
  const double gm = 0.5 * draft + bm - 0.5 * thickness;                    // KB + BM - KG
  for (const double heel : {1e-3, 0.05, 0.1, 0.2, -0.15}) {
    // With unchanged displacement the waterplane passes through the old waterline on the centre plane.
    const Pose pose{{0.0, 0.0, (0.5 * thickness - draft) * std::cos(heel)}, turn({1, 0, 0}, heel)};
    const auto load = water_load(floe, pose, {}, kWater);
    BOOST_CHECK_CLOSE_FRACTION(load.buoyancy.force.z, kWater.density * kGravity * volume, 1e-13);
    const double tangent = std::tan(heel);
    const double righting_arm = std::sin(heel) * (gm + 0.5 * bm * tangent * tangent);
    // Exact while deck and bottom stay off the waterplane; rounding of arms of order 1 m is left.
    BOOST_CHECK_SMALL(load.buoyancy.moment.x + kWater.density * kGravity * volume * righting_arm,
                      1e-12 * kWater.density * kGravity * volume);
  }
}

BOOST_AUTO_TEST_CASE(buoyancy_is_minus_the_gradient_of_the_energy) {
  const Prism floe = notched_plate(0.8);
  const double step = 1e-4;
  const Vec3 axes[3]{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int k = 0; k < 10; ++k) {
    const Pose pose{{1.0, 2.0, -0.35 + 0.08 * k}, turn({1.0, 0.7 * k - 2.0, 0.3}, 0.35 * k)};
    const Wrench buoyancy = water_load(floe, pose, {}, kWater).buoyancy;
    const auto energy_moved = [&](Vec3 shift, Vec3 axis, double angle) {
      // The body turns about its centre of mass: world rotation after the attitude.
      const Quaternion r = turn(axis, angle), q = pose.rotation;
      const Quaternion turned{
          r.w * q.w - r.x * q.x - r.y * q.y - r.z * q.z, r.w * q.x + r.x * q.w + r.y * q.z - r.z * q.y,
          r.w * q.y - r.x * q.z + r.y * q.w + r.z * q.x, r.w * q.z + r.x * q.y - r.y * q.x + r.z * q.w};
      return water_energy(floe, {pose.position + shift, turned});
    };
    const double scale = kWater.density * kGravity * 10.0;
    for (const Vec3 axis : axes) {
      const double force =
          -(energy_moved(step * axis, axis, 0.0) - energy_moved(-step * axis, axis, 0.0)) / (2.0 * step);
      const double moment = -(energy_moved({}, axis, step) - energy_moved({}, axis, -step)) / (2.0 * step);
      // Central differences err by step^2 times the third derivative (order one here): 1e-8, with margin for corners.
      BOOST_CHECK_SMALL(dot(buoyancy.force, axis) - force, 1e-6 * scale);
      BOOST_CHECK_SMALL(dot(buoyancy.moment, axis) - moment, 1e-6 * scale);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_floe_with_very_many_sides_is_whole) {
  std::vector<Vec2> ring;
  const int sides = 90;
  for (int i = 0; i < sides; ++i) ring.push_back({std::cos(2.0 * kPi * i / sides), std::sin(2.0 * kPi * i / sides)});
  const double area = 0.5 * sides * std::sin(2.0 * kPi / sides);
  const Prism floe{{ring}, {ring}, 0.4};
  BOOST_CHECK_CLOSE_FRACTION(displacement(floe, {{0.0, 0.0, -5.0}, turn({1, 1, 0}, 0.3)}).volume, 0.4 * area, 1e-13);
  BOOST_CHECK_CLOSE_FRACTION(displacement(floe, {{0.0, 0.0, 0.1}, {}}).volume, 0.1 * area, 1e-13);  // rounding
  const double drag = water_load(floe, {{0.0, 0.0, -5.0}, {}}, {{0.0, 0.0, 2.0}, {}}, kWater).drag.force.z;
  BOOST_CHECK_CLOSE_FRACTION(drag, -0.5 * kWater.density * kWater.form_drag * area * 4.0, 1e-13);  // likewise
}

BOOST_AUTO_TEST_CASE(a_prism_without_an_outline_breaks_the_contract) {
  BOOST_CHECK_THROW(displacement(Prism{}, Pose{}), ContractViolation);
}

BOOST_AUTO_TEST_SUITE_END()
