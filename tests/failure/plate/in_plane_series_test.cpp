// SPDX-License-Identifier: GPL-3.0-or-later
// The series in the in-plane load against the plate solved under that load; k = l_c = D = 1.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "brash/plate/plate.hpp"

namespace plate = brash::plate;

namespace {

struct Errors {
  double stress = 0.0;  ///< of the largest stress, relative
  double place = 0.0;   ///< over l_c
};

/// The terms' answer against that of the plate compressed by `share` of its buckling load.
Errors errors_at(plate::WedgePlate wedge, double share) {
  wedge.with_in_plane_terms = true;
  const auto terms = plate::solve(wedge).value();
  wedge.with_in_plane_terms = false;
  wedge.in_plane_load = share * terms.in_plane.buckling_load;
  const auto exact = plate::solve(wedge);
  BOOST_REQUIRE(exact.has_value());
  const auto answer = plate::respond(*plate::compressed(terms, wedge.in_plane_load), wedge.thickness, 0.511, 0.0);
  const auto known = plate::respond(*exact, wedge.thickness, 0.511, 0.0);
  std::printf("b %.2f c %.2f th %.0f n_b %.3f share %.2f sigma %.4f known %.4f first %.4f l %.3f %.3f\n", wedge.depth, wedge.contact_length, wedge.angle*57.3, terms.in_plane.buckling_load, share, answer.sigma_over_p, known.sigma_over_p, plate::respond(terms, wedge.thickness, 0.511,0.0).sigma_over_p, answer.lbreak_over_lc, known.lbreak_over_lc);
  return {.stress = std::abs(answer.sigma_over_p / known.sigma_over_p - 1.0),
          .place = std::abs(answer.lbreak_over_lc - known.lbreak_over_lc)};
}

BOOST_AUTO_TEST_CASE(the_series_is_the_plate_under_that_load) {
  for (const double b : {0.0, 0.1, 0.5, 1.5})
    for (const double c : {0.05, 0.3, 1.0})
      for (const double theta : {30.0, 90.0, 140.0}) {
        if (b == 0.0 && theta > 30) continue;
        for (const double share : {0.2, 0.5, 0.8}) errors_at({.depth = b, .contact_length = c, .angle = theta * std::numbers::pi / 180.0, .thickness = 0.1009}, share);
      }
}

}  // namespace
