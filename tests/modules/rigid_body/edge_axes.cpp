// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../../modules/rigid_body/src/edge_axes.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <limits>
#include <random>

#include "helpers.hpp"

using namespace brash;
using namespace brash::rigid_body;
using namespace brash::rigid_body::testing;

namespace {

// Depths of a few metres from coordinates of a few metres: some 1e-16 each.
constexpr double kRoundOff = 1e-12;

Quaternion turn(Vec3 axis, double angle) {
  const Vec3 a = std::sin(angle / 2) * normalized(axis);
  return {std::cos(angle / 2), a.x, a.y, a.z};
}

double depth_along(const PlacedPart& a, const PlacedPart& b, Vec3 normal) {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (const Vec3 v : a.vertices) least = std::min(least, dot(normal, v));
  for (const Vec3 v : b.vertices) greatest = std::max(greatest, dot(normal, v));
  return greatest - least;
}

/// Least depth along the normals of all pairs of edges, either way. The solids' difference has far fewer of these
/// normals.
double least_depth_over_edges(const PlacedPart& a, const PlacedPart& b) {
  const auto along = [](const PlacedPart& part, const Edge& edge) {
    return part.vertices[static_cast<std::size_t>(edge.to)] - part.vertices[static_cast<std::size_t>(edge.from)];
  };
  double least = std::numeric_limits<double>::infinity();
  for (const Edge& e : a.part->edges)
    for (const Edge& f : b.part->edges) {
      const Vec3 normal = cross(along(a, e), along(b, f));
      if (norm(normal) < 1e-6 * norm(along(a, e)) * norm(along(b, f))) continue;
      for (const double sign : {1.0, -1.0}) least = std::min(least, depth_along(a, b, sign / norm(normal) * normal));
    }
  return least;
}

/// A floe of three to nine corners on an ellipse.
ConvexPart random_floe(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const int n = 3 + static_cast<int>(6.999 * unit(random));
  const double breadth = 0.3 + unit(random);
  std::vector<Vec2> ring;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * kPi * (i + 0.8 * unit(random)) / n;
    ring.push_back({std::cos(t), breadth * std::sin(t)});
  }
  return convex_prism(ring, -0.15, 0.15);
}

}  // namespace

BOOST_AUTO_TEST_CASE(Two_crossed_edges_part_along_the_normal_of_both) {
  const ConvexPart beam = convex_prism(rectangle({-3, -1}, {3, 1}), -1, 1);
  // Each stands on an edge, one along x and one along y, and they overlap by 0.1.
  const PlacedPart lower = placed(beam, {{}, turn({1, 0, 0}, kPi / 4)});
  const Quaternion quarter = turn({0, 0, 1}, kPi / 2), q = turn({0, 1, 0}, kPi / 4);
  const Quaternion both{q.w * quarter.w, q.y * quarter.z, q.y * quarter.w, q.w * quarter.z};
  const PlacedPart upper = placed(beam, {{0, 0, 2 * std::sqrt(2.0) - 0.1}, both});
  OverlapFinder finder;
  finder.find(upper, lower);
  EdgeAxes edges;
  const auto axes = edges.find(finder, upper, lower, 1.0);
  BOOST_TEST_REQUIRE(!axes.empty());
  BOOST_TEST(axes[0].depth == 0.1, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(norm(axes[0].normal - Vec3{0, 0, 1}) < kRoundOff);
}

BOOST_AUTO_TEST_CASE(The_shortest_way_out_is_that_of_all_normals_of_edges_and_faces) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> about(-1.0, 1.0);
  OverlapFinder finder;
  EdgeAxes edges;
  int n_overlaps = 0, n_shorter = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const ConvexPart first = random_floe(random), second = random_floe(random);
    // From lying nearly flat, as floes afloat, to any attitude.
    const double tilt = trial % 2 == 0 ? 0.02 : 1.0;
    const auto pose = [&] {
      const Quaternion q{1.0, tilt * about(random), tilt * about(random), about(random)};
      const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
      return Pose{{about(random), about(random), 0.3 * about(random)},
                  {q.w / size, q.x / size, q.y / size, q.z / size}};
    };
    const PlacedPart a = placed(first, pose()), b = placed(second, pose());
    const Overlap& overlap = finder.find(a, b);
    if (overlap.vertices.empty()) continue;
    ++n_overlaps;
    double face = std::numeric_limits<double>::infinity();
    for (const SeparatingAxis& axis : overlap.axes) face = std::min(face, axis.depth);
    const auto axes = edges.find(finder, a, b, face);
    for (const SeparatingAxis& axis : axes) {
      BOOST_TEST(std::abs(norm(axis.normal) - 1.0) < kRoundOff);
      BOOST_TEST(std::abs(depth_along(a, b, axis.normal) - axis.depth) < kRoundOff);
    }
    const double expected = least_depth_over_edges(a, b);
    const double found = axes.empty() ? face : axes[0].depth;
    BOOST_TEST(std::abs(found - std::min(face, expected)) < kRoundOff);
    n_shorter += expected < face - kRoundOff;
  }
  BOOST_TEST_MESSAGE(n_overlaps << " overlaps, the least depth over edges in " << n_shorter);
  BOOST_TEST(n_overlaps > 1000);
  BOOST_TEST(n_shorter > 200);
}

BOOST_AUTO_TEST_CASE(A_solid_has_each_edge_once_between_its_two_faces) {
  for (const ConvexPart& solid :
       {convex_prism(rectangle({0, 0}, {2, 1}), 0, 1), convex_hull(cone(6.8, radians(61.4), 5.68, 3.4))}) {
    BOOST_TEST(solid.vertices.size() + solid.faces.size() == solid.edges.size() + 2);  // Euler
    for (const Edge& edge : solid.edges) {
      BOOST_TEST(edge.left != edge.right);
      for (const int face : {edge.left, edge.right})
        for (const int end : {edge.from, edge.to}) {
          const Plane& plane = solid.planes[static_cast<std::size_t>(face)];
          BOOST_TEST(std::abs(dot(plane.normal, solid.vertices[static_cast<std::size_t>(end)]) - plane.offset) < 1e-8);
        }
    }
  }
}
