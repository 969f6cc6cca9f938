// SPDX-License-Identifier: GPL-3.0-or-later
// The in-plane load on the bent plate, and the sheet that a radial crack has split; k = l_c = D = 1.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "brash/plate/plate.hpp"
#include "fem.hpp"
#include "mesh.hpp"
#include "recovery.hpp"

namespace plate = brash::plate;
using boost::test_tools::tolerance;

namespace {

/// A cylinder (no rotation across the sides) of length 16 and width 1, line load 1 on its end, with its in-plane stress
/// under a unit pressure on that end: sigma_xx = -1.
struct Strip {
  plate::Mesh mesh;
  plate::Field stress;

  static plate::Mesh meshed() {
    constexpr double kLength = 16.0;
    plate::Domain domain;
    domain.segments = {{{0.0, 0.0}, {kLength, 0.0}, plate::Side::kSymmetryY},
                       {{kLength, 0.0}, {kLength, 1.0}, plate::Side::kFar},
                       {{kLength, 1.0}, {0.0, 1.0}, plate::Side::kSymmetryY},
                       {{0.0, 1.0}, {0.0, 0.0}, plate::Side::kTip}};
    domain.largest_size = 0.25;
    return plate::mesh_domain(domain).value();
  }
  Strip() : mesh(meshed()), stress(plate::solve_membrane(mesh, 3, {0.3, {{1.0, 0.0}}, false}).value().front()) {}

  auto bent(double in_plane_load) const {
    constexpr double kThin = 1e-3;  // of h / l_c: Kirchhoff's plate
    return plate::solve_bending(mesh, 3, {0.3, plate::shear_stiffness(0.3, kThin), 1.0, {}, &stress, in_plane_load});
  }
};

/// A semi-infinite beam on an elastic foundation, compressed by N and loaded by P = 1 on its free end:
/// w'''' + N w'' + w = 0, w''(0) = 0, w''' + N w' = P. With alpha^2 = 1/2 - N/4 and beta^2 = 1/2 + N/4 the moment is
/// e^(-alpha x) sin(beta x) / (beta (1 - N)): the end buckles at N = sqrt(k D), half the load of an infinite beam.
double beam_moment(double x, double N) {
  const double alpha = std::sqrt(0.5 - 0.25 * N), beta = std::sqrt(0.5 + 0.25 * N);
  return std::exp(-alpha * x) * std::sin(beta * x) / (beta * (1.0 - N));
}

BOOST_AUTO_TEST_CASE(a_compressed_strip_bends_as_a_beam_column_on_water) {
  const Strip strip;
  std::vector<double> x;
  for (int i = 0; i <= 60; ++i) x.push_back(0.1 * i);
  for (const double N : {0.0, 0.3, 0.8}) {
    const auto field = strip.bent(N);
    BOOST_REQUIRE(field.has_value());
    const auto moments = plate::recover_tensor(*field, x, plate::Parity::kEven);
    double error = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) error = std::max(error, std::abs(moments[i].xx - beam_moment(x[i], N)));
    // Without N these elements are 2e-5 off (a_strip_bends_as_hetenyi_says); near buckling errors grow as 1 / (1 - N).
    BOOST_TEST(error / beam_moment(1.1, N) < 5e-4);
  }
}

BOOST_AUTO_TEST_CASE(a_strip_buckles_at_the_load_of_the_beam) {
  const Strip strip;
  BOOST_TEST(strip.bent(0.99).has_value());
  BOOST_TEST(!strip.bent(1.01).has_value());
}

const plate::WedgePlate kWedge{
    .depth = 0.5, .contact_length = 0.3, .angle = std::numbers::pi / 3.0, .thickness = 0.1009};

BOOST_AUTO_TEST_CASE(the_in_plane_load_raises_the_bending_of_a_wedge_and_buckles_it_in_the_end) {
  plate::WedgePlate wedge = kWedge;
  const auto at = [&](double N) {
    wedge.in_plane_load = N;
    return plate::solve(wedge);
  };
  const auto first_order = at(0.0), loaded = at(1.0);
  BOOST_REQUIRE((first_order && loaded));
  BOOST_TEST(plate::respond(*loaded, 0.1009, 0.5, 0.0).sigma_over_p >
             plate::respond(*first_order, 0.1009, 0.5, 0.0).sigma_over_p);
  const auto buckled = at(50.0);
  BOOST_REQUIRE(!buckled);
  BOOST_TEST(buckled.error().buckled);
}

BOOST_AUTO_TEST_CASE(splitting_a_narrow_wedge_without_lateral_contraction_changes_nothing) {
  // No moments cross the centre line of a beam.
  plate::WedgePlate wedge{.depth = 3.0, .contact_length = 0.05, .angle = 0.03, .thickness = 0.05, .poisson_ratio = 0.0};
  const auto whole = plate::solve(wedge);
  wedge.split = true;
  const auto halves = plate::solve(wedge);
  BOOST_REQUIRE((whole && halves));
  const auto a = plate::respond(*whole, 0.05, 1.0, 0.0), b = plate::respond(*halves, 0.05, 1.0, 0.0);
  BOOST_TEST(b.sigma_over_p == a.sigma_over_p, tolerance(2e-3));  // two different recoveries
}

BOOST_AUTO_TEST_CASE(a_split_sheet_carries_no_moment_across_the_crack_and_breaks_more_easily) {
  plate::WedgePlate edge{.contact_length = 0.3, .thickness = 0.1009};
  const auto whole = plate::solve(edge);
  edge.split = true;
  const auto halves = plate::solve(edge);
  BOOST_REQUIRE((whole && halves));
  double across = 0.0, along = 0.0;
  for (const auto& m : halves->bending) {
    across = std::max(across, std::abs(m.yy));
    along = std::max(along, std::abs(m.xx));
  }
  BOOST_TEST(across < 0.02 * along);  // natural boundary condition: zero as the mesh gets finer
  BOOST_TEST(plate::respond(*halves, 0.1009, 0.5, 0.0).sigma_over_p >
             plate::respond(*whole, 0.1009, 0.5, 0.0).sigma_over_p);
}

}  // namespace
