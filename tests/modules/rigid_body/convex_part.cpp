// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../../modules/rigid_body/src/convex_part.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "brash/core/constants.hpp"

using namespace brash;
using namespace brash::rigid_body;

namespace {

const auto kExact = boost::test_tools::tolerance(1e-12);

/// By the flux of the position through the faces, which have to close.
double volume(const ConvexPart& part) {
  double sum = 0.0;
  for (const std::vector<int>& face : part.faces)
    for (std::size_t i = 2; i < face.size(); ++i) {
      const auto at = [&](std::size_t k) { return part.vertices[static_cast<std::size_t>(face[k])]; };
      sum += dot(at(0), cross(at(i - 1), at(i))) / 6.0;
    }
  return sum;
}

/// Euler's formula, and no point outside of a face.
void check_solid(const ConvexPart& part, std::span<const Vec3> points, double tolerance) {
  BOOST_TEST(part.vertices.size() + part.faces.size() == part.edges.size() + 2);
  BOOST_TEST(part.planes.size() == part.faces.size());
  double most = 0.0;
  for (const Plane& plane : part.planes)
    for (const Vec3& p : points) most = std::max(most, dot(plane.normal, p) - plane.offset);
  BOOST_TEST(most <= tolerance);
}

Vec3 rounded(Vec3 v) {
  return {static_cast<double>(static_cast<float>(v.x)), static_cast<double>(static_cast<float>(v.y)),
          static_cast<double>(static_cast<float>(v.z))};
}

/// A barge with a round bottom, decks and sides that bend by less than a float shows, and a bow.
std::vector<Vec3> barge(int n_along, int n_around, double length) {
  std::vector<Vec3> points;
  for (int i = 0; i <= n_along; ++i)
    for (int k = 0; k <= n_around; ++k) {
      const double x = length * (static_cast<double>(i) / n_along - 0.5), angle = kPi * k / n_around;
      const double half = 0.1 * length * std::min(1.0, 6.0 * (0.5 - x / length));
      points.push_back(rounded({x, half * std::cos(angle), -0.05 * length * std::pow(std::sin(angle), 0.3)}));
      points.push_back(rounded({x, half * std::cos(angle), 0.03 * length}));
    }
  return points;
}

BOOST_AUTO_TEST_SUITE(convex_part)

BOOST_AUTO_TEST_CASE(a_box_has_six_faces_whatever_points_lie_on_them) {
  std::vector<Vec3> points;
  for (int i = 0; i < 27; ++i) points.push_back({1.0 * (i % 3), 0.7 * (i / 3 % 3), 0.3 * (i / 9)});
  const ConvexPart part = convex_hull(points);
  BOOST_TEST(part.faces.size() == 6u);
  BOOST_TEST(volume(part) == 2.0 * 1.4 * 0.6, kExact);
  check_solid(part, points, 1e-12);
}

BOOST_AUTO_TEST_CASE(a_hull_in_single_precision_closes) {
  for (const double length : {9.0, 90.0, 300.0})
    for (const int n_along : {5, 8, 13, 21})
      for (const int n_around : {6, 7, 10}) {
        const std::vector<Vec3> points = barge(n_along, n_around, length);
        check_solid(convex_hull(points), points, 1e-8 * length);
      }
}

BOOST_AUTO_TEST_CASE(points_at_the_tolerance_of_a_plane_close_a_solid) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 300; ++trial) {
    const double noise = std::pow(10.0, -12.0 + 6.0 * trial / 300.0);
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0), shift(-noise, noise);
    std::vector<Vec3> points;
    for (int i = 0; i < 60; ++i) {
      const double x = anywhere(random), y = anywhere(random);
      points.push_back({x, y, (i % 2 == 0 ? 1.0 : -1.0) + shift(random)});
      if (i % 3 == 0) points.push_back({(i % 2 == 0 ? 1.0 : -1.0) + shift(random), y, x});
    }
    const ConvexPart part = convex_hull(points);
    check_solid(part, points, 4.0 * std::max(noise, 1e-8));
    BOOST_TEST(volume(part) > 5.0);
  }
}

BOOST_AUTO_TEST_CASE(many_corners_of_a_ball_close_a_solid_of_nearly_its_volume) {
  std::vector<Vec3> points;
  for (int i = 0; i < 2000; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / 2000, r = std::sqrt(1.0 - z * z);
    points.push_back(rounded({r * std::cos(2.4 * i), r * std::sin(2.4 * i), z}));
  }
  const ConvexPart part = convex_hull(points);
  BOOST_TEST(volume(part) == 4.0 / 3.0 * kPi, boost::test_tools::tolerance(0.01));
  check_solid(part, points, 1e-8);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
