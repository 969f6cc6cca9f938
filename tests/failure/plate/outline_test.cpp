// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "brash/plate/plate.hpp"

namespace plate = brash::plate;
using brash::Vec2;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// The trapezoid of the failure model as an edge like any other.
std::vector<Vec2> trapezoid() {
  const double root = 0.15 + 0.5 * std::tan(30.0 * kDegree);
  return {{0.5, -root - 1.0}, {0.5, -root}, {0.0, -0.15}, {0.0, 0.15}, {0.5, root}, {0.5, root + 1.0}};
}

/// An edge with nothing regular about it.
std::vector<Vec2> crooked() { return {{0.6, -1.5}, {0.4, -0.8}, {0.1, -0.3}, {-0.02, 0.2}, {0.3, 0.5}, {0.2, 1.2}}; }

std::vector<Vec2> mirrored(const std::vector<Vec2>& edge) {
  std::vector<Vec2> result;
  for (auto point = edge.rbegin(); point != edge.rend(); ++point) result.push_back({point->x, -point->y});
  return result;
}

/// The edge moved so that the point of it on the x-axis is the origin.
std::vector<Vec2> through_origin(std::vector<Vec2> edge) {
  for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
    if (edge[i].y > 0.0 || edge[i + 1].y <= 0.0) continue;
    const double x = edge[i].x - (edge[i + 1].x - edge[i].x) * edge[i].y / (edge[i + 1].y - edge[i].y);
    for (auto& point : edge) point.x -= x;
    return edge;
  }
  return edge;
}

plate::UnitProfiles solved(const std::vector<Vec2>& edge, double contact = 0.3) {
  const auto profiles = plate::solve_outline({edge, contact, 0.100871});
  BOOST_REQUIRE_MESSAGE(profiles.has_value(), (profiles ? "" : profiles.error().what));
  return *profiles;
}

std::string refusal(const std::vector<Vec2>& edge) {
  const auto profiles = plate::solve_outline({edge, 0.3, 0.1});
  return profiles ? "none" : profiles.error().what;
}

}  // namespace

// Both meshes are accurate to 0.1 % of sigma; the place of the flat peak to 0.005 l_c.
BOOST_AUTO_TEST_CASE(an_outline_that_is_a_trapezoid_gives_what_the_trapezoid_gives) {
  const auto outline = plate::respond(solved(trapezoid()), 0.100871, 0.5, 0.1);
  const auto direct = plate::respond(*plate::solve({0.5, 0.3, 60.0 * kDegree, 0.100871}), 0.100871, 0.5, 0.1);
  BOOST_TEST(outline.sigma_over_p == direct.sigma_over_p, boost::test_tools::tolerance(2e-3));
  BOOST_TEST(std::abs(outline.lbreak_over_lc - direct.lbreak_over_lc) < 0.01);
  BOOST_TEST(outline.sigma_radial_over_p == direct.sigma_radial_over_p, boost::test_tools::tolerance(5e-3));
  // Raw stress of single elements, from two sides of the corner: 2 %.
  BOOST_TEST(outline.sigma_root_over_p == direct.sigma_root_over_p, boost::test_tools::tolerance(0.02));
}

// The same plate seen from the other side: f changes its sign with y, the rest does not. The meshes differ.
BOOST_AUTO_TEST_CASE(a_mirrored_outline_gives_mirrored_stress) {
  const auto edge = through_origin(crooked());
  const auto here = plate::respond(solved(edge), 0.100871, 0.5, 0.2);
  const auto there = plate::respond(solved(mirrored(edge)), 0.100871, 0.5, -0.2);
  const auto other = plate::respond(solved(edge), 0.100871, 0.5, -0.2);
  BOOST_TEST(here.sigma_over_p == there.sigma_over_p, boost::test_tools::tolerance(2e-3));
  BOOST_TEST(std::abs(here.lbreak_over_lc - there.lbreak_over_lc) < 0.01);
  // And it matters which way friction pulls: by more than both errors.
  BOOST_TEST(std::abs(here.sigma_over_p / other.sigma_over_p - 1.0) > 0.004);
}

// A crack parallel to the edge, 0.8 l_c behind it: the ice ends there and so does the centre line.
BOOST_AUTO_TEST_CASE(the_centre_line_ends_where_the_ice_ends) {
  const std::vector<Vec2> edge{{0.0, -2.0}, {0.0, 0.5}, {0.7, 0.5}, {0.7, -1.0}, {0.8, -1.0}, {0.8, 1.0}, {0.0, 1.5}};
  const auto profiles = solved(edge);
  BOOST_TEST(profiles.station.back() == 0.7, boost::test_tools::tolerance(1e-12));
  // A free edge carries no moment and no stress across it: 1 % of the largest ones, read off one side.
  double moment = 0.0;
  for (const auto& m : profiles.bending) moment = std::max(moment, std::abs(m.xx));
  BOOST_TEST(std::abs(profiles.bending.back().xx) < 0.01 * moment);
  BOOST_TEST(std::abs(profiles.normal.back().xx) < 0.01);
}

BOOST_AUTO_TEST_CASE(an_edge_that_cannot_be_used_is_refused_with_a_reason) {
  BOOST_TEST(refusal({{0.0, 0.0}}) == "the edge has fewer than two points");
  BOOST_TEST(refusal({{0.1, -1.0}, {0.1, 1.0}}) == "the edge misses B");
  BOOST_TEST(refusal({{0.0, 1.0}, {0.0, -1.0}}) == "the edge passes its own ends sideways");
  BOOST_TEST(refusal({{0.0, -1.0}, {0.0, -1.0}, {0.0, 1.0}}) == "two points of the edge coincide");
  BOOST_TEST(refusal({{0.0, -1.0}, {-0.5, 0.6}, {0.0, 0.6}, {0.0, -0.6}, {0.5, -0.6}, {0.5, 1.0}}) ==
             "there is no ice ahead of B");
  BOOST_TEST(refusal({{0.0, -1.0}, {0.0, 0.2}, {1.0, 0.2}, {-1.0, -0.5}, {-1.0, 1.0}}).rfind("meshing failed", 0) == 0);
}
