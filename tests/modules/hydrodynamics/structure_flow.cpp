// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/hydrodynamics/structure_flow.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

namespace {

using namespace brash;
using brash::hydrodynamics::StructureFlow;

constexpr Vec2 kVelocity{1.2, 0.0};

BOOST_AUTO_TEST_CASE(around_a_sphere_it_is_the_dipole) {
  const StructureFlow flow({2.0, 2.0, 2.0});
  // u = U R^3 / (2 r^3) (3 cos(theta) e_r - e_x)
  for (const Vec3 p : {Vec3{3.0, 0.0, 0.0}, Vec3{0.0, 2.5, 0.0}, Vec3{1.5, -2.0, -1.0}}) {
    const double r = norm(p);
    const Vec3 expected = 1.2 * 8.0 / (2.0 * r * r * r) * (3.0 * p.x / (r * r) * p - Vec3{1.0, 0.0, 0.0});
    BOOST_TEST(norm(flow.at(p, kVelocity) - expected) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(the_water_at_the_surface_moves_along_the_normal_as_the_structure_does) {
  for (const double depth : {0.5, 1.9995, 2.0005, 5.0}) {
    const StructureFlow flow({2.0, 2.0, depth});
    for (const double theta : {0.1, 0.7, 1.4})
      for (const double phi : {0.0, 1.0, 2.5}) {
        const double outside = 1.0 + 1e-9;
        const Vec3 p = outside * Vec3{2.0 * std::cos(theta) * std::cos(phi), 2.0 * std::cos(theta) * std::sin(phi),
                                      -depth * std::sin(theta)};
        const Vec3 n{p.x / 4.0, p.y / 4.0, p.z / (depth * depth)};
        BOOST_TEST(std::abs(dot(flow.at(p, kVelocity) - Vec3{1.2, 0.0, 0.0}, n)) / norm(n) < 1e-6);
      }
  }
}

BOOST_AUTO_TEST_CASE(the_water_at_the_surface_of_a_ship_moves_along_the_normal_as_the_ship_does) {
  const Vec3 axes{9.0, 2.0, 1.3};
  const StructureFlow flow(axes);
  for (const Vec2 velocity : {Vec2{1.2, 0.0}, Vec2{0.0, 0.4}, Vec2{-0.7, 0.9}})
    for (const double theta : {0.1, 0.7, 1.4})
      for (const double phi : {0.0, 1.0, 2.5}) {
        const Vec3 p = (1.0 + 1e-9) * Vec3{axes.x * std::cos(theta) * std::cos(phi),
                                           axes.y * std::cos(theta) * std::sin(phi), -axes.z * std::sin(theta)};
        const Vec3 n{p.x / (axes.x * axes.x), p.y / (axes.y * axes.y), p.z / (axes.z * axes.z)};
        BOOST_TEST(std::abs(dot(flow.at(p, velocity) - Vec3{velocity.x, velocity.y, 0.0}, n)) / norm(n) < 1e-6);
      }
}

BOOST_AUTO_TEST_CASE(a_deep_structure_has_the_flow_around_a_cylinder) {
  // Near the surface of an ellipse a, b, infinitely deep: at (x, 0) the closed form of the elliptic cylinder
  // (Lamb 1932, art. 71) is u = U b (a + b) / (l (k + l)) with k^2 = a^2 + lambda = x^2, l^2 = b^2 + lambda.
  const double a = 2.0, b = 1.0;
  const StructureFlow flow({a, b, 1e5});
  for (const double x : {2.5, 4.0}) {
    const double l = std::sqrt(b * b + x * x - a * a);
    BOOST_TEST(flow.at({x, 0.0, 0.0}, kVelocity).x == 1.2 * b * (a + b) / (l * (x + l)),
               boost::test_tools::tolerance(1e-6));
  }
  const StructureFlow round({2.0, 2.0, 1e5});
  BOOST_TEST(round.at({3.0, 0.0, 0.0}, kVelocity).x == 1.2 * 4.0 / 9.0, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(round.at({0.0, 3.0, 0.0}, kVelocity).x == -1.2 * 4.0 / 9.0, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(the_water_ahead_of_a_sphere_is_accelerated_as_bernoulli_says) {
  // In the sphere's frame the flow is steady: Du/Dt = grad(w^2 / 2), and on the axis w = U (1 - R^3 / r^3).
  const StructureFlow flow({2.0, 2.0, 2.0});
  for (const double r : {2.2, 3.0, 6.0}) {
    const double w = 1.2 * (1.0 - 8.0 / (r * r * r)), slope = 1.2 * 3.0 * 8.0 / (r * r * r * r);
    const Vec3 found = flow.acceleration({r, 0.0, 0.0}, kVelocity);
    BOOST_TEST(found.x == w * slope, boost::test_tools::tolerance(1e-5));
    BOOST_TEST(std::abs(found.y) + std::abs(found.z) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(no_water_is_made_and_none_turns) {
  const StructureFlow flow({6.8, 5.0, 5.2});
  constexpr double kStep = 1e-4;
  for (const Vec3 p : {Vec3{8.0, 1.0, -1.0}, Vec3{-3.0, 7.0, -2.0}, Vec3{1.0, 2.0, -9.0}}) {
    const auto slope = [&](Vec3 along) {
      return (flow.at(p + kStep * along, kVelocity) - flow.at(p - kStep * along, kVelocity)) / (2.0 * kStep);
    };
    const Vec3 x = slope({1, 0, 0}), y = slope({0, 1, 0}), z = slope({0, 0, 1});
    BOOST_TEST(std::abs(x.x + y.y + z.z) < 1e-7);  // central differences: the third derivative times 1e-8
    BOOST_TEST(norm(Vec3{z.y - y.z, x.z - z.x, y.x - x.y}) < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(nothing_passes_the_surface_and_far_away_the_water_is_at_rest) {
  const StructureFlow flow({6.8, 5.0, 5.2});
  BOOST_TEST(flow.at({9.0, 3.0, 0.0}, kVelocity).z == 0.0);
  BOOST_TEST(norm(flow.at({100.0, 50.0, 0.0}, kVelocity)) < 1e-3);
}

BOOST_AUTO_TEST_CASE(below_the_keel_of_a_ship_the_water_runs_aft_also_inside_the_ellipsoid) {
  // An icebreaker of 121 m by 23 m: its ellipsoid of the same volume is deeper than its keel at 7 m.
  const StructureFlow flow({60.5, 11.6, 8.41});
  for (const double x : {-25.0, 0.0, 25.0}) BOOST_TEST(flow.at({x, 2.0, -7.0}, kVelocity).x < -0.02);
  const Vec3 surface{0.0, 0.0, -8.41};
  BOOST_TEST(norm(flow.at(0.999999 * surface, kVelocity) - flow.at(1.000001 * surface, kVelocity)) < 1e-5);
  BOOST_TEST(flow.at({0.0, 0.0, -7.0}, kVelocity).x == flow.at(surface, kVelocity).x);
  BOOST_TEST(flow.at({}, kVelocity).x == 1.2);  // no ray leaves the centre
}

BOOST_AUTO_TEST_CASE(inside_a_sphere_the_water_has_the_velocity_of_the_surface) {
  // The dipole at r = R: u = U / 2 (3 cos(theta) e_r - e_x).
  const StructureFlow flow({2.0, 2.0, 2.0});
  for (const Vec3 p : {Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 0.5, -1.0}, Vec3{0.7, -0.9, -1.1}}) {
    const double r = norm(p);
    const Vec3 expected = 0.6 * (3.0 * p.x / (r * r) * p - Vec3{1.0, 0.0, 0.0});
    BOOST_TEST(norm(flow.at(p, kVelocity) - expected) < 1e-9);
  }
}

}  // namespace
