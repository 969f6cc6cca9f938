// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/trapezoid.hpp"

#include <boost/test/unit_test.hpp>

#include "brash/core/contract.hpp"
#include "fit_cases.hpp"
#include "shapes.hpp"

namespace brash::geometry {
namespace {

using fit_cases::Polyline;
using fit_cases::trapezoid_edge;

/// `edge` with B moved to `at` and x turned to `angle`.
Polyline placed(const Polyline& edge, Vec2 at, double angle) {
  Polyline result;
  const Vec2 x{std::cos(angle), std::sin(angle)};
  for (const Vec2 p : edge) result.push_back(at + p.x * x + p.y * perpendicular(x));
  return result;
}

Trapezoid fit_in_frame(const std::vector<Polyline>& edges, double c, double reach) {
  return fit_trapezoid(edges, FitRequest{{0, 0}, {1, 0}, c, reach});
}

BOOST_AUTO_TEST_SUITE(trapezoid_fit)

BOOST_AUTO_TEST_CASE(exact_trapezoids_anywhere_are_found_again) {
  for (const double b : {0.25, 0.8, 1.7}) {
    for (const double theta : {0.0, 30.0, 61.0, 90.0, 120.0}) {
      // The window does not show the whole of a wider trapezoid.
      if (0.2 + b * std::tan(radians(0.5 * theta)) > 2.5) continue;
      const Polyline edge = placed(trapezoid_edge(b, 0.4, radians(theta), 8.0), {31.0, -7.0}, 2.1);
      const Trapezoid fit = fit_trapezoid(std::vector<Polyline>{edge},
                                          FitRequest{{31.0, -7.0}, {std::cos(2.1), std::sin(2.1)}, 0.4, 3.0});
      // The search ends at 1e-4 of the ranges along the axes of a valley that is not aligned with them.
      BOOST_TEST(std::abs(fit.depth - b) < 0.003);
      BOOST_TEST(std::abs(degrees(fit.angle) - theta) < 0.5);
      BOOST_TEST(fit.contact_length == 0.4);
      BOOST_TEST(fit.error < 1e-4);
      BOOST_TEST(!fit.reidentified);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_contact_length_is_found_where_it_is_not_known) {
  const Trapezoid fit = fit_in_frame({trapezoid_edge(0.9, 0.7, radians(70), 8.0)}, 0.0, 3.0);
  // Three coupled parameters: the descent along the axes stops a little earlier.
  BOOST_TEST(std::abs(fit.depth - 0.9) < 0.01);
  BOOST_TEST(std::abs(fit.contact_length - 0.7) < 0.05);
  BOOST_TEST(std::abs(degrees(fit.angle) - 70) < 2.0);
}

BOOST_AUTO_TEST_CASE(a_straight_edge_has_no_depth_and_no_angle) {
  const Trapezoid fit = fit_in_frame({{{0, 9}, {0, -9}}}, 0.5, 3.0);
  BOOST_TEST(fit.depth == 0.0);
  BOOST_TEST(fit.angle == 0.0);
  BOOST_TEST(fit.error == 0.0);
  BOOST_TEST(!fit.reidentified);
}

BOOST_AUTO_TEST_CASE(a_notch_counts_as_a_straight_edge) {
  const Trapezoid fit = fit_in_frame({{{-1, 9}, {-1, 1}, {0, 0.3}, {0, -0.3}, {-1, -1}, {-1, -9}}}, 0.5, 3.0);
  BOOST_TEST(fit.depth == 0.0);
  BOOST_TEST(fit.error == 0.0);
}

BOOST_AUTO_TEST_CASE(a_protrusion_deeper_than_the_window_is_as_deep_as_the_window) {
  const Trapezoid fit = fit_in_frame({{{9, 1.0}, {0, 0.5}, {0, -0.5}, {9, -1.0}}}, 1.0, 3.0);
  BOOST_TEST(fit.depth == 3.0, boost::test_tools::tolerance(1e-2));
  BOOST_TEST(degrees(fit.angle) == 2 * degrees(std::atan(0.5 / 9)), boost::test_tools::tolerance(0.1));
}

BOOST_AUTO_TEST_CASE(a_tooth_between_cusps_keeps_its_depth_and_its_neighbours_do_not_count) {
  // Arcs of radius 1.2 about (0, +-1), (0, +-3): teeth with sharp tips at y = 0, +-2 that are recessed alike.
  const double tip = std::sqrt(1.2 * 1.2 - 1.0);
  Polyline edge;
  for (int arc = 3; arc >= -3; arc -= 2) {
    const double end = std::acos(1.0 / 1.2);
    for (int k = 0; k <= 12; ++k) {
      const double a = kPi - end - (kPi - 2 * end) * k / 12;
      edge.push_back({1.2 * std::sin(a) - tip, arc - 1.2 * std::cos(a) * 1.0});
    }
  }
  std::reverse(edge.begin(), edge.end());
  if (edge.front().y < edge.back().y) std::reverse(edge.begin(), edge.end());
  const Trapezoid fit = fit_in_frame({edge}, 0.1, 3.0);
  // The cusps are 1.2 - tip = 0.54 m deep; the least area cuts their bottoms: between half and all of it.
  BOOST_TEST(fit.depth > 0.27);
  BOOST_TEST(fit.depth < 0.54);
  BOOST_TEST(degrees(fit.angle) > 60.0);
  BOOST_TEST(fit.error < 0.1);
}

BOOST_AUTO_TEST_CASE(an_overhang_is_seen_from_the_structure_and_flagged) {
  // A mushroom: the sides step back under the tip. From the front it is a right-angled block of width 2.
  const Polyline mushroom{{1.0, 9},    {1.0, 0.3},  {0.4, 0.3},  {0.4, 1.0},  {0.0, 1.0},
                          {0.0, -1.0}, {0.4, -1.0}, {0.4, -0.3}, {1.0, -0.3}, {1.0, -9}};
  const Trapezoid fit = fit_in_frame({mushroom}, 2.0, 3.0);
  BOOST_TEST(fit.reidentified);
  BOOST_TEST(std::abs(fit.depth - 1.0) < 0.003);
  BOOST_TEST(degrees(fit.angle) < 0.5);
}

BOOST_AUTO_TEST_CASE(an_overhang_ahead_of_the_tip_line_is_no_distortion) {
  // A tooth between cusps; the tip of the next cusp stands 0.5 m ahead of B and leans over by `lean`.
  const auto edge_leaning = [](double lean) {
    return Polyline{{0.8, 9},    {0.8, 1.0},          {0.0, 0.2},   {0.0, -0.2},
                    {0.8, -1.0}, {-0.5, -2.0 + lean}, {-0.5, -2.3}, {0.8, -9}};
  };
  // Upright, and with its side stepping back by 0.1 m at the front only.
  Polyline leaning = edge_leaning(0.0);
  leaning.insert(leaning.begin() + 5, {-0.1, -2.1});
  const Trapezoid upright = fit_in_frame({edge_leaning(-0.1)}, 0.4, 3.0), fit = fit_in_frame({leaning}, 0.4, 3.0);
  BOOST_TEST(!upright.reidentified);
  BOOST_TEST(!fit.reidentified);
  BOOST_TEST(fit.error < 0.1);

  // The same step back behind the tip line hides ice from the structure.
  leaning[5] = {0.1, -2.1};
  BOOST_TEST(fit_in_frame({leaning}, 0.4, 3.0).reidentified);
}

BOOST_AUTO_TEST_CASE(seen_from_the_chord_the_crushed_tip_does_not_count) {
  // A sharp tooth of 60 deg, 1 m deep. The structure has crushed its tip down to a chord of 0.3 m.
  const double slope = std::tan(radians(30)), crushed = 0.15 / slope;
  const Polyline tooth{{1.0, 8.0}, {1.0, slope}, {0.0, 0.0}, {1.0, -slope}, {1.0, -8.0}};
  const Trapezoid fit = fit_trapezoid(std::vector<Polyline>{tooth}, FitRequest{{crushed, 0.0}, {1.0, 0.0}, 0.3, 3.0});
  BOOST_TEST(std::abs(fit.depth - (1.0 - crushed)) < 0.003);
  BOOST_TEST(std::abs(degrees(fit.angle) - 60.0) < 0.5);
  BOOST_TEST(fit.error < 1e-4);
  BOOST_TEST(!fit.reidentified);
}

BOOST_AUTO_TEST_CASE(an_edge_that_ends_to_one_side_of_the_centre_line_is_held) {
  const Trapezoid fit = fit_in_frame({{{0.5, 2.0}, {0.5, 0.2}}}, 0.5, 3.0);
  // A step of 0.5 m all over the window but for the tip edge.
  BOOST_TEST(std::abs(fit.depth - 0.5) < 0.003);
  BOOST_TEST(degrees(fit.angle) < 0.5);
}

BOOST_AUTO_TEST_CASE(edges_behind_the_front_do_not_count) {
  const Polyline front = trapezoid_edge(0.8, 0.4, radians(60), 8.0);
  const Polyline hole{{2.0, -0.5}, {2.0, 0.5}, {2.5, 0.5}, {2.5, -0.5}, {2.0, -0.5}};
  const Trapezoid alone = fit_in_frame({front}, 0.4, 3.0), with_hole = fit_in_frame({hole, front}, 0.4, 3.0);
  BOOST_TEST(alone.depth == with_hole.depth);
  BOOST_TEST(alone.angle == with_hole.angle);
}

BOOST_AUTO_TEST_CASE(anything_at_all_is_answered_within_the_ranges) {
  std::mt19937_64 generator(4);
  for (int i = 0; i < 300; ++i) {
    std::vector<Polyline> edges(generator() % 4);
    for (Polyline& edge : edges) {
      const std::size_t n = generator() % 12;
      for (std::size_t k = 0; k < n; ++k) {
        // Coordinates from a few values, so that segments coincide, vanish and cross.
        edge.push_back({static_cast<double>(generator() % 9) - 4.0, static_cast<double>(generator() % 9) - 4.0});
      }
    }
    const double reach = 0.5 + 4 * shapes::uniform(generator);
    const Trapezoid fit = fit_in_frame(edges, i % 2 ? 0.0 : 9.0 * shapes::uniform(generator), reach);
    BOOST_TEST((fit.depth >= 0.0 && fit.depth <= reach));
    BOOST_TEST((fit.angle >= 0.0 && fit.angle <= radians(150) * (1 + 1e-15)));
    BOOST_TEST((fit.error >= 0.0 && fit.error <= 1.0));
    BOOST_TEST(std::isfinite(fit.contact_length));
  }
}

BOOST_AUTO_TEST_CASE(a_request_without_reach_or_direction_is_a_broken_contract) {
  const std::vector<Polyline> edges{{{0, 1}, {0, -1}}};
  BOOST_CHECK_THROW(fit_trapezoid(edges, FitRequest{{0, 0}, {1, 0}, 0.1, 0.0}), ContractViolation);
  BOOST_CHECK_THROW(fit_trapezoid(edges, FitRequest{{0, 0}, {1, 1}, 0.1, 1.0}), ContractViolation);
  BOOST_CHECK_THROW(fit_trapezoid(edges, FitRequest{{0, 0}, {1, 0}, -0.1, 1.0}), ContractViolation);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace brash::geometry
