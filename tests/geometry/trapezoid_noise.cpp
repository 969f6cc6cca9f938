// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of b, c and theta against the noise of the edge. `--log_level=message` prints the table that
// trapezoid_noise.csv keeps.
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>

#include "brash/geometry/trapezoid.hpp"
#include "fit_cases.hpp"

namespace brash::geometry {
namespace {

constexpr double kReach = 3.0;

struct Errors {
  double depth;           ///< root mean square [m]
  double angle;           ///< median magnitude [deg]
  double angle_90;        ///< 90 % of the magnitudes are below [deg]
  double contact_length;  ///< root mean square [m]
  double fit;             ///< mean error of the fit [-]
  double reidentified;    ///< share [-]
};

/// 400 trapezoids b 0.3 to 1.5 m, c 0.1 to 1 m, theta 20 to 120 deg that the window shows whole, a vertex every 0.3 m.
Errors errors_at(double noise, bool is_contact_known) {
  std::mt19937_64 generator(7);
  Errors sum{};
  std::vector<double> angles;
  while (angles.size() < 400) {
    const double b = 0.3 + 1.2 * shapes::uniform(generator), c = 0.1 + 0.9 * shapes::uniform(generator);
    const double theta = radians(20 + 100 * shapes::uniform(generator));
    if (0.5 * c + b * std::tan(0.5 * theta) > 2.5) continue;
    const auto exact = fit_cases::trapezoid_edge(b, c, theta, 8.0);
    const std::vector<fit_cases::Polyline> edges{fit_cases::roughened(exact, 0.3, noise, generator)};
    const Trapezoid fit = fit_trapezoid(edges, FitRequest{{0, 0}, {1, 0}, is_contact_known ? c : 0.0, kReach});
    sum.depth += std::pow(fit.depth - b, 2);
    sum.contact_length += std::pow(fit.contact_length - c, 2);
    sum.fit += fit.error;
    sum.reidentified += fit.reidentified;
    angles.push_back(std::abs(degrees(fit.angle - theta)));
  }
  std::sort(angles.begin(), angles.end());
  const double n = static_cast<double>(angles.size());
  return {std::sqrt(sum.depth / n),          angles[200], angles[360],
          std::sqrt(sum.contact_length / n), sum.fit / n, sum.reidentified / n};
}

BOOST_AUTO_TEST_SUITE(trapezoid_fit_and_noise)

BOOST_AUTO_TEST_CASE(errors_grow_in_proportion_to_the_noise_of_the_edge) {
  for (const bool is_known : {true, false}) {
    for (const double noise : {0.0, 0.01, 0.03, 0.1}) {
      const Errors e = errors_at(noise, is_known);
      BOOST_TEST_MESSAGE("c " << (is_known ? "known" : "fitted") << ", noise " << noise << " m: b " << e.depth
                              << " m, theta median " << e.angle << " 90 % " << e.angle_90 << " deg, c "
                              << e.contact_length << " m, error " << e.fit << ", reidentified " << e.reidentified);
      // About twenty vertices lie on the base line, so its depth is better than one vertex: 0.36 noise measured.
      BOOST_TEST(e.depth <= 0.45 * noise + 2e-4);
      // A side of 1 m has three or four vertices: noise / 1 m is 0.57 deg at 0.01 m. Medians of 49 (c known)
      // and 83 deg per metre of noise measured.
      BOOST_TEST(e.angle <= (is_known ? 60.0 : 95.0) * noise + 0.1);
      // A contact length is the distance of two side lines near their ends: about twice the noise measured.
      BOOST_TEST(e.contact_length <= 2.5 * noise + 2e-3);
      // No fit is worse than the noise itself, spread over one side of the window.
      BOOST_TEST(e.fit <= noise / kReach + 1e-4);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace brash::geometry
