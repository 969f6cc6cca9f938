// SPDX-License-Identifier: GPL-3.0-or-later
// The terms in the in-plane load against the plate solved under that load; k = l_c = D = 1.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "brash/plate/plate.hpp"

namespace plate = brash::plate;

namespace {

constexpr double kMu1 = 0.511;

/// Relative error of the largest stress by the terms, under `share` of the buckling load; also the first-order error.
struct Errors {
  double terms = 0.0;
  double first_order = 0.0;
};

Errors errors_at(plate::WedgePlate wedge, double share) {
  wedge.with_in_plane_terms = true;
  const auto terms = plate::solve(wedge).value();
  wedge.with_in_plane_terms = false;
  wedge.in_plane_load = share * terms.in_plane.buckling_load;
  const auto known = plate::respond(plate::solve(wedge).value(), wedge.thickness, kMu1, 0.0);
  const auto error = [&](const plate::UnitProfiles& profiles) {
    return std::abs(plate::respond(profiles, wedge.thickness, kMu1, 0.0).sigma_over_p / known.sigma_over_p - 1.0);
  };
  return {.terms = error(plate::compressed(terms, wedge.in_plane_load).value()), .first_order = error(terms)};
}

const plate::WedgePlate kStraight{.contact_length = 0.3, .thickness = 0.1009};
const plate::WedgePlate kWedge{
    .depth = 0.5, .contact_length = 0.3, .angle = std::numbers::pi / 2.0, .thickness = 0.1009};
const plate::WedgePlate kSplit{.contact_length = 0.5, .thickness = 0.1009, .split = true};

BOOST_AUTO_TEST_CASE(the_terms_are_the_plate_under_that_load) {
  // The terms from r^3 on leave out the higher modes: about a twentieth of r^3.
  for (const plate::WedgePlate& wedge : {kStraight, kWedge, kSplit}) {
    const Errors low = errors_at(wedge, 0.2), high = errors_at(wedge, 0.5);
    BOOST_TEST(low.terms < 1e-3);
    BOOST_TEST(low.first_order > 0.2);
    BOOST_TEST(high.terms < 1.5e-2);
  }
}

BOOST_AUTO_TEST_CASE(a_load_above_the_buckling_load_has_no_answer) {
  plate::WedgePlate wedge = kWedge;
  wedge.with_in_plane_terms = true;
  const auto terms = plate::solve(wedge).value();
  BOOST_TEST(!plate::compressed(terms, 1.01 * terms.in_plane.buckling_load).has_value());
  // Rayleigh's quotient is above the least load, by little: the plate itself has buckled there.
  wedge.with_in_plane_terms = false;
  wedge.in_plane_load = terms.in_plane.buckling_load;
  BOOST_TEST(!plate::solve(wedge).has_value());
  wedge.in_plane_load = 0.95 * terms.in_plane.buckling_load;
  BOOST_TEST(plate::solve(wedge).has_value());
}

}  // namespace
