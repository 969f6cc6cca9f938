// SPDX-License-Identifier: GPL-3.0-or-later
// A bay as a trapezoid with a negative depth, against the straight edge, the sheet with any outline, and its static
// limit.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "brash/plate/edge_responses.hpp"
#include "brash/plate/plate.hpp"
#include "brash/plate/sheet.hpp"

namespace plate = brash::plate;
namespace tt = boost::test_tools;
using brash::Vec2;

namespace {

constexpr double kThickness = 0.1009, kContact = 0.3, kAngle = std::numbers::pi / 3.0;

plate::UnitProfiles solved(double depth) {
  const auto profiles = plate::solve(
      plate::WedgePlate{.depth = depth, .contact_length = kContact, .angle = kAngle, .thickness = kThickness});
  BOOST_REQUIRE_MESSAGE(profiles.has_value(), (profiles ? "" : profiles.error().what));
  return *profiles;
}

plate::Response response(double depth) { return plate::respond(solved(depth), kThickness, 0.511, 0.0); }

/// Moment xx at a distance on the centre line.
double moment_at(const plate::UnitProfiles& profiles, double place) {
  std::size_t i = 0;
  while (profiles.station[i + 1] < place) ++i;
  const double share = (place - profiles.station[i]) / (profiles.station[i + 1] - profiles.station[i]);
  return (1.0 - share) * profiles.bending[i].xx + share * profiles.bending[i + 1].xx;
}

/// The same outline as a sheet with any outline, its tip edge pushed by P = 1 per metre.
plate::LoadedSheet sheet(double deep) {
  const double tip = 0.5 * kContact, root = tip + deep * std::tan(0.5 * kAngle);
  return {
      .outline = {{-deep, -root - 3.0}, {-deep, -root}, {0.0, -tip}, {0.0, tip}, {-deep, root}, {-deep, root + 3.0}},
      .edge_loads = {{{0.0, -tip}, {0.0, tip}, {}, kContact, 0.0}},
      .patch_loads = {},
      .thickness = kThickness,
      .accuracy = plate::Accuracy::kFine};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_shallow_bay_is_nearly_a_straight_edge) {
  const plate::Response straight = response(0.0), bay = response(-1e-3), protrusion = response(1e-3);
  BOOST_TEST(bay.sigma_over_p < straight.sigma_over_p);
  BOOST_TEST(bay.sigma_over_p == straight.sigma_over_p, tt::tolerance(0.005));
  BOOST_TEST(bay.sigma_over_p + protrusion.sigma_over_p == 2.0 * straight.sigma_over_p, tt::tolerance(0.002));
  BOOST_TEST(std::abs(bay.lbreak_over_lc - straight.lbreak_over_lc) < 0.01);
}

// The fast sheet errs by 1 %, the fine one by less; 1 % is asked for.
BOOST_AUTO_TEST_CASE(the_moments_ahead_of_a_bay_are_those_of_the_sheet_with_that_outline) {
  for (const double deep : {0.2, 0.6}) {
    const plate::UnitProfiles bay = solved(-deep);
    const auto solution = plate::solve(sheet(deep));
    BOOST_REQUIRE_MESSAGE(solution.has_value(), (solution ? "" : solution.error().what));
    const plate::LineProfile line = solution->along({0.0, 0.0}, {1.0, 0.0}, 3.0);
    double largest = 0.0, apart = 0.0;
    for (std::size_t i = 0; i < line.station.size(); ++i) {
      if (line.station[i] < kThickness) continue;
      // UnitProfiles::bending is per Q l_c, a sheet's moment per rho_w g l_c^3 with Q = 1.
      const double exact = moment_at(bay, line.station[i]);
      largest = std::max(largest, exact);
      apart = std::max(apart, std::abs(line.state[i].moment.xx - exact));
    }
    BOOST_TEST_MESSAGE("bay " << deep << " deep: moments apart by " << apart / largest << " of the largest");
    BOOST_TEST(apart < 0.01 * largest);
  }
}

BOOST_AUTO_TEST_CASE(a_bay_that_is_pushed_slowly_bends_as_at_rest) {
  const double depth = -0.4;
  const auto moving = plate::solve(
      plate::EdgeGeometry{.depth = depth, .contact_length = kContact, .angle = kAngle, .thickness = kThickness});
  BOOST_REQUIRE(moving.has_value());
  const plate::UnitProfiles rest = solved(depth);
  BOOST_TEST(moving->static_deflection == rest.deflection.front(), tt::tolerance(0.005));
  std::size_t largest = 0;
  for (std::size_t i = 0; i < moving->station.size(); ++i)
    if (moving->static_axis_moment[i] > moving->static_axis_moment[largest]) largest = i;
  BOOST_TEST(moving->static_axis_moment[largest] == moment_at(rest, moving->station[largest]), tt::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(the_deeper_the_bay_the_more_it_bears_and_the_farther_in_it_breaks) {
  double stress = 10.0, length = 0.0;
  for (const double depth : {0.0, -0.1, -0.4, -1.0}) {
    const plate::Response here = response(depth);
    BOOST_TEST(here.sigma_over_p < stress);
    BOOST_TEST(here.lbreak_over_lc > length);
    stress = here.sigma_over_p;
    length = here.lbreak_over_lc;
  }
}
