// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/standards/nevel.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "brash/core/contract.hpp"

namespace {

using namespace brash;
using namespace brash::standards;

/// Cubic Hermite functions and their second derivatives at t in [0, 1] of an element of length `size`.
struct Hermite {
  std::array<double, 4> value, curvature;
  Hermite(double t, double size)
      : value{1 - 3 * t * t + 2 * t * t * t, size * (t - 2 * t * t + t * t * t), 3 * t * t - 2 * t * t * t,
              size * (t * t * t - t * t)},
        curvature{(-6 + 12 * t) / (size * size), (-4 + 6 * t) / size, (6 - 12 * t) / (size * size),
                  (6 * t - 2) / size} {}
};

/// Solves (x w'')'' + x w = q on [0, 12], lengths in l, by finite elements: q = 2 x/a^2 on [0, a] has total load 1. The
/// tip is free and the far end clamped, where the deflection is e^-8 of the tip's.
/// @return 1 / max |w''|: P = (b_0 sigma h^2/6) times it breaks the wedge.
double exact_factor(double a, int n_loaded, int n_free) {
  std::vector<double> x;
  for (int i = 0; i <= n_loaded; ++i) x.push_back(a * i / n_loaded);
  for (int i = 1; i <= n_free; ++i) x.push_back(a + (12.0 - a) * i / n_free);
  const auto n = static_cast<int>(x.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * n - 2);
  const std::array<double, 4> points{0.0694318442029737, 0.3300094782075719, 0.6699905217924281, 0.9305681557970263};
  const std::array<double, 4> weights{0.1739274225687269, 0.3260725774312731, 0.3260725774312731, 0.1739274225687269};
  for (int e = 0; e + 1 < n; ++e) {
    const double size = x[e + 1] - x[e];
    for (std::size_t g = 0; g < 4; ++g) {
      const Hermite shape(points[g], size);
      const double at = x[e] + points[g] * size, weight = weights[g] * size;
      for (int i = 0; i < 4; ++i) {
        if (2 * e + i >= 2 * n - 2) continue;
        if (e < n_loaded) load(2 * e + i) += weight * 2.0 * at / (a * a) * shape.value[i];
        for (int j = 0; j < 4; ++j) {
          if (2 * e + j >= 2 * n - 2) continue;
          entries.emplace_back(
              2 * e + i, 2 * e + j,
              weight * at * (shape.curvature[i] * shape.curvature[j] + shape.value[i] * shape.value[j]));
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(2 * n - 2, 2 * n - 2);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd w = Eigen::VectorXd::Zero(2 * n);
  w.head(2 * n - 2) = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(load);
  double largest = 0.0;
  for (int e = 0; e + 1 < n; ++e) {
    // The curvature of a cubic is superconvergent at the two Gauss points.
    for (const double t : {0.21132486540518713, 0.7886751345948129}) {
      const Hermite shape(t, x[e + 1] - x[e]);
      double curvature = 0.0;
      for (int i = 0; i < 4; ++i) curvature += shape.curvature[i] * w(2 * e + i);
      largest = std::max(largest, std::abs(curvature));
    }
  }
  return 1.0 / largest;
}

/// A wedge with b_0 sigma h^2/6 = 1 and l = 1.
double formula_factor(double a) {
  NevelInput in;
  in.wedge_angle = 2.0 * std::atan(0.5);
  in.thickness = 1.0;
  in.flexural_strength = 6.0;
  in.youngs_modulus = 12.0 * in.water_density * in.gravity;
  in.loaded_length = a;
  return nevel(in).vertical;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(nevel_wedge)

BOOST_AUTO_TEST_CASE(the_formula_is_within_1_2_per_cent_of_the_beam_solution_in_its_range) {
  for (const double a : {0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6}) {
    const double exact = exact_factor(a, 100, 2000);
    BOOST_CHECK_SMALL(exact - exact_factor(a, 50, 1000), 5e-4 * exact);  // halving the mesh moves it by 1e-4
    BOOST_CHECK_SMALL(formula_factor(a) / exact - 1.0, 0.012);
  }
}

BOOST_AUTO_TEST_CASE(beyond_its_range_the_formula_is_low_as_documented) {
  BOOST_CHECK_SMALL(1.0 - formula_factor(1.0) / exact_factor(1.0, 200, 2000) - 0.04, 0.005);
  BOOST_CHECK_SMALL(1.0 - formula_factor(1.5) / exact_factor(1.5, 300, 2000) - 0.11, 0.005);
}

BOOST_AUTO_TEST_CASE(the_range_is_reported) {
  NevelInput in;
  in.wedge_angle = radians(45.0);
  in.thickness = 0.33;
  in.flexural_strength = 539e3;
  in.youngs_modulus = 0.35e9;
  in.loaded_length = 1.0;
  BOOST_TEST(nevel(in).in_range);
  in.loaded_length = 2.0;  // l = 3.2 m
  BOOST_TEST(!nevel(in).in_range);
  in.wedge_angle = 0.0;
  BOOST_CHECK_THROW(nevel(in), ContractViolation);
}

BOOST_AUTO_TEST_SUITE_END()
