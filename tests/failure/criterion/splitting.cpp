// SPDX-License-Identifier: GPL-3.0-or-later
/// The law of docs/theory/fracture-of-floes.md, (G7), (G8), (G9).
#include "brash/failure/splitting.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace brash;
using failure::SplitPlate;

constexpr double kPi = std::numbers::pi;

/// Mouth opening of a strip of unit breadth in tension, V1 of Tada, Paris and Irwin (2000), to 1 %: v = 4 s a V1 / E.
double mouth_opening(double a) {
  const double c = std::cos(0.5 * kPi * a);
  return 4.0 * a * (1.46 + 3.42 * (1.0 - c)) / (c * c);
}

/// Stress intensity of the same strip in unit tension, likewise, to 0.5 %.
double tension_intensity(double a) {
  const double t = std::tan(0.5 * kPi * a), c = std::cos(0.5 * kPi * a);
  return std::sqrt(2.0 / kPi / a * t) * (0.752 + 2.02 * a + 0.37 * std::pow(1.0 - std::sin(0.5 * kPi * a), 3)) / c *
         std::sqrt(kPi * a);
}

/// The pair of forces at the mouth, from these two by reciprocity (Rice 1972): K_P = E v' / (2 K_s).
double pair_intensity(double a) {
  const double step = 1e-5;
  return (mouth_opening(a + step) - mouth_opening(a - step)) / (2.0 * step) / (2.0 * tension_intensity(a));
}

BOOST_AUTO_TEST_CASE(a_short_crack_has_the_stress_intensity_of_the_half_plane) {
  // 2 P sqrt(pi / (pi^2 - 4) / a) of an edge crack whose mouth is wedged open (Tada, Paris and Irwin 2000).
  const double length = 100.0, share = 0.02, force = 1e5, thickness = 0.4;
  const double exact = 2.0 * force / thickness * std::sqrt(kPi / (kPi * kPi - 4.0) / (share * length));
  const double found =
      failure::stress_intensity({.opening = force, .thickness = thickness}, SplitPlate{length, 200.0}, share);
  // The table has 1 %, and a crack of 2 % of the plate is not yet in a half plane.
  BOOST_TEST(found == exact, boost::test_tools::tolerance(0.025));
}

BOOST_AUTO_TEST_CASE(a_long_plate_has_the_stress_intensity_of_the_handbook) {
  for (const double share : {0.2, 0.3, 0.4, 0.5, 0.6, 0.7})
    // The handbook's formulas have 1 % and 0.5 %, and their derivative somewhat more.
    BOOST_TEST(failure::stress_intensity({.opening = 1.0, .thickness = 1.0}, SplitPlate{1.0, 4.0}, share) ==
                   pair_intensity(share),
               boost::test_tools::tolerance(0.03));
}

BOOST_AUTO_TEST_CASE(a_narrow_ligament_has_the_stress_intensity_of_pure_bending) {
  // 3.975 M / c^1.5 of a deep crack (Benthem and Koiter 1973), M = P (a + c / 2).
  const double share = 0.9, rest = 0.1;
  const double bending = 3.975 * (share + 0.5 * rest) / std::pow(rest, 1.5);
  BOOST_TEST(failure::stress_intensity({.opening = 1.0, .thickness = 1.0}, SplitPlate{1.0, 1.0}, share) == bending,
             boost::test_tools::tolerance(0.04));  // the force through the ligament adds a few percent
}

/// A stress intensity of experiments/splitting, by FreeFem++ on its finest mesh and on the one before.
struct Solved {
  double breadth = 0.0, crack = 0.0;
  bool push = false;
  double finest = 0.0, by_energy = 0.0, coarser = 0.0;
};

std::vector<Solved> solved_by_freefem() {
  std::ifstream file(BRASH_SOURCE_DIR "/experiments/splitting/edge_crack.csv");
  std::vector<Solved> rows;
  std::string line;
  for (std::getline(file, line); std::getline(file, line);) {
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    const Solved row{std::stod(cells.at(0)), std::stod(cells.at(1)), cells.at(2) == "push", std::stod(cells.at(5)),
                     std::stod(cells.at(6))};
    const auto same = [&](const Solved& other) {
      return other.breadth == row.breadth && other.crack == row.crack && other.push == row.push;
    };
    const auto before = std::find_if(rows.begin(), rows.end(), same);
    if (before == rows.end()) {
      rows.push_back(row);
    } else {
      const double coarser = before->finest;
      *before = row;
      before->coarser = coarser;
    }
  }
  return rows;
}

BOOST_AUTO_TEST_CASE(rectangles_have_the_stress_intensities_of_an_independent_program) {
  const std::vector<Solved> rows = solved_by_freefem();
  BOOST_TEST(rows.size() == 30U);
  for (const Solved& row : rows)
    BOOST_TEST_CONTEXT("breadth " << row.breadth << ", crack " << row.crack << (row.push ? ", push" : ", opening")) {
      // The other solution has converged, and its two integrals agree.
      BOOST_TEST(row.coarser == row.finest, boost::test_tools::tolerance(0.001));
      BOOST_TEST(row.by_energy == row.finest, boost::test_tools::tolerance(0.001));
      const failure::SplittingLoad load{
          .opening = row.push ? 0.0 : 1.0, .push = row.push ? 1.0 : 0.0, .thickness = 1.0};
      // The table's elements are coarser: 0.1 to 0.4 % below.
      BOOST_TEST(failure::stress_intensity(load, SplitPlate{1.0, row.breadth}, row.crack) == row.finest,
                 boost::test_tools::tolerance(0.005));
    }
}

BOOST_AUTO_TEST_CASE(the_force_that_splits_a_square_grows_with_the_root_of_its_size) {
  const auto of = [](double size) { return failure::splitting_force(1.5e5, 0.5, SplitPlate{size, size}); };
  BOOST_TEST(of(80.0) == 2.0 * of(20.0), boost::test_tools::tolerance(1e-12));
  const double force = of(50.0);
  const SplitPlate square{50.0, 50.0};
  BOOST_TEST(failure::least_intensity({.opening = force, .thickness = 0.5}, square) == 1.5e5,
             boost::test_tools::tolerance(1e-12));
  // The push against the inertia of the plate closes the crack.
  BOOST_TEST(failure::least_intensity({.opening = force, .push = force, .thickness = 0.5}, square) < 1.5e5);
  BOOST_TEST(failure::stress_intensity({.push = force, .thickness = 0.5}, square, 0.3) < 0.0);
}

BOOST_AUTO_TEST_CASE(plates_between_and_beyond_the_table_have_what_finite_elements_give_them) {
  // The least K h sqrt(W) / P on the way of the crack, by splitting_fem.py with cracks between the lengths of the
  // table.
  struct Least {
    double breadth = 0.0, pair = 0.0;
  };
  for (const auto& [breadth, pair] : {Least{0.177, 12.515}, {0.35, 8.897}, {0.7, 6.310}, {1.4, 4.841}, {2.8, 4.735}})
    BOOST_TEST(failure::least_intensity({.opening = 1.0, .thickness = 1.0}, SplitPlate{1.0, breadth}) == pair,
               boost::test_tools::tolerance(0.02));
  const auto closing = [](double breadth, double crack) {
    return failure::stress_intensity({.push = 1.0, .thickness = 1.0}, SplitPlate{1.0, breadth}, crack) *
           std::sqrt(crack) * std::pow(1.0 - crack, 1.5);
  };
  for (const auto& [crack, push] : {std::pair{0.02, 0.8537}, {0.1, 2.1268}, {0.5, 5.6085}, {0.9, 7.5134}})
    BOOST_TEST(closing(16.0, crack) == -push, boost::test_tools::tolerance(0.01));
  // A plate four times as long is split by the same force.
  const failure::SplittingLoad load{.opening = 1e5, .push = 4e4, .thickness = 0.5};
  BOOST_TEST(failure::least_intensity(load, SplitPlate{800.0, 25.0}) ==
             failure::least_intensity(load, SplitPlate{200.0, 25.0}));
}

}  // namespace
