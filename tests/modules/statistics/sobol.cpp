// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/sobol.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <set>

#include "brash/core/contract.hpp"

using brash::statistics::kMostSobolDimensions;
using brash::statistics::sobol;

BOOST_AUTO_TEST_SUITE(sobol_sequences)

BOOST_AUTO_TEST_CASE(more_points_continue_the_sequence) {
  const auto few = sobol(8, 5, 38), many = sobol(32, 5, 38);
  BOOST_TEST(std::vector(many.begin(), many.begin() + 40) == few, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(each_part_of_each_dimension_has_its_point) {
  for (const std::uint64_t seed : {1ULL, 38ULL})
    for (const std::size_t n : {8U, 64U}) {
      const auto points = sobol(n, kMostSobolDimensions, seed);
      for (std::size_t j = 0; j < kMostSobolDimensions; ++j) {
        std::set<int> parts;
        for (std::size_t i = 0; i < n; ++i)
          parts.insert(static_cast<int>(points[i * kMostSobolDimensions + j] * static_cast<double>(n)));
        BOOST_TEST(parts.size() == n);
      }
    }
}

BOOST_AUTO_TEST_CASE(the_first_two_dimensions_have_a_point_in_each_square) {
  // A net in base 2: 4 by 4 squares, 16 points.
  const auto points = sobol(16, 2, 7);
  std::set<int> squares;
  for (std::size_t i = 0; i < 16; ++i)
    squares.insert(static_cast<int>(points[2 * i] * 4) * 4 + static_cast<int>(points[2 * i + 1] * 4));
  BOOST_TEST(squares.size() == 16u);
}

BOOST_AUTO_TEST_CASE(a_mean_converges_faster_than_random_numbers_would) {
  // The integral of the product of 2 x is 1. Random points err by 0.03 (deviation sqrt((4/3)^5 - 1) / sqrt(n)).
  constexpr std::size_t kPoints = 4096;
  const auto points = sobol(kPoints, 5, 3);
  double sum = 0.0;
  for (std::size_t i = 0; i < kPoints; ++i) {
    double product = 1.0;
    for (std::size_t j = 0; j < 5; ++j) product *= 2.0 * points[5 * i + j];
    sum += product;
  }
  BOOST_TEST(std::abs(sum / kPoints - 1.0) < 0.003);
}

BOOST_AUTO_TEST_CASE(the_points_of_a_seed_never_change) {
  // Recorded: the ensembles of experiments/predictions depend on them.
  const auto points = sobol(2, 2, 38);
  BOOST_TEST(points != sobol(2, 2, 39), boost::test_tools::per_element());
  BOOST_TEST(std::abs(points[0] - points[2]) == 0.5);
}

BOOST_AUTO_TEST_CASE(too_many_dimensions_are_refused) {
  BOOST_CHECK_THROW(sobol(4, kMostSobolDimensions + 1, 1), brash::ContractViolation);
  BOOST_CHECK_THROW(sobol(0, 1, 1), brash::ContractViolation);
}

BOOST_AUTO_TEST_SUITE_END()
