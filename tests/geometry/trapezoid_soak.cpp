// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "brash/core/constants.hpp"
#include "brash/edge/edge_contact.hpp"
#include "brash/failure/criterion.hpp"
#include "brash/geometry/trapezoid.hpp"
#include "brash/io/case.hpp"
#include "brash/simulation/simulation.hpp"
#include "brash/structure/hull.hpp"

// Fits to every contact of validation runs, step by step, seed after seed. `test_geometry_trapezoid_soak -- N` asks for
// N fits; the full soak is a hundred thousand.
using namespace brash;
using namespace brash::geometry;

namespace {

long asked_fits() {
  const auto& suite = boost::unit_test::framework::master_test_suite();
  return suite.argc > 1 ? std::atol(suite.argv[1]) : 1000;
}

struct Counts {
  std::vector<double> errors;
  long fits = 0, runs = 0, without_wedge = 0, reidentified = 0;
  double depth = 0.0, angle = 0.0, seconds = 0.0, slowest = 0.0;
};

void fit_and_count(const IceSheet& sheet, const ContactRegion& region, double reach, Counts& counts) {
  const FitRequest request{.at = 0.5 * (region.chord_from + region.chord_to),
                           .towards = region.normal,
                           .contact_length = region.contact_length,
                           .reach = reach};
  const std::clock_t start = std::clock();
  const Trapezoid fit = fit_trapezoid(sheet, request);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  counts.seconds += seconds;
  counts.slowest = std::max(counts.slowest, seconds);
  BOOST_REQUIRE(fit.depth >= 0.0);
  BOOST_REQUIRE(fit.depth <= reach);
  BOOST_REQUIRE(fit.angle >= 0.0);
  // The largest angle that is sought, 150 deg, as the fit's own arithmetic rounds it.
  BOOST_REQUIRE(fit.angle <= radians(150.0) * (1.0 + 1e-12));
  BOOST_REQUIRE(fit.contact_length == region.contact_length);
  BOOST_REQUIRE(fit.error >= 0.0);
  BOOST_REQUIRE(fit.error <= 1.0);
  counts.errors.push_back(fit.error);
  counts.depth += fit.depth;
  counts.angle += fit.angle;
  counts.without_wedge += fit.depth == 0.0 ? 1 : 0;
  counts.reidentified += fit.reidentified ? 1 : 0;
  ++counts.fits;
}

void run_and_fit(int seed, long most, Counts& counts) {
  const model::Case c =
      io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml", {"random.seed=" + std::to_string(seed)});
  simulation::Simulation run(c);
  const auto hull = structure::make_hull(c.structure.shape);
  const double reach = 2.0 * failure::characteristic_length(edge::ice_properties(c));
  const edge::Freeboard heights = edge::freeboard(c);
  while (run.time() < c.time.duration && counts.fits < most) {
    (void)run.step();
    const Ring section = ring(hull->footprint(run.frame().structure, heights.bottom, heights.top).leading.at(0));
    const IceSheet sheet = IceSheet::from_polygons(run.sheet()).value();
    for (const ContactRegion& region : sheet.contacts(section)) {
      if (region.contact_length > 0.0 && counts.fits < most) fit_and_count(sheet, region, reach, counts);
    }
  }
  ++counts.runs;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(trapezoid_soak)

BOOST_AUTO_TEST_CASE(every_contact_of_validation_runs_has_a_fit) {
  const long n_fits = asked_fits();
  Counts counts;
  counts.errors.reserve(static_cast<std::size_t>(n_fits));
  for (int seed = 1; counts.fits < n_fits; ++seed) run_and_fit(seed, n_fits, counts);
  BOOST_TEST(counts.fits == n_fits);
  std::sort(counts.errors.begin(), counts.errors.end());
  const auto quantile = [&](double q) {
    return counts.errors[static_cast<std::size_t>(q * (counts.errors.size() - 1))];
  };
  const auto n = static_cast<double>(counts.fits);
  BOOST_TEST_MESSAGE("fits " << counts.fits << " in " << counts.runs << " runs, b = 0 in " << counts.without_wedge
                             << ", re-identified " << counts.reidentified << ", mean b " << counts.depth / n
                             << " m, mean theta " << degrees(counts.angle / n) << " deg; E: median " << quantile(0.5)
                             << ", 90 % " << quantile(0.9) << ", 99 % " << quantile(0.99) << ", largest "
                             << quantile(1.0) << "; " << 1e6 * counts.seconds / n << " us a fit, slowest "
                             << 1e6 * counts.slowest << " us");
}

BOOST_AUTO_TEST_SUITE_END()
