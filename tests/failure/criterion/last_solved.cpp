// SPDX-License-Identifier: GPL-3.0-or-later
#define BOOST_TEST_MODULE last_solved
#include "last_solved.hpp"

#include <boost/test/unit_test.hpp>

namespace {

using brash::failure::LastSolved;

BOOST_AUTO_TEST_CASE(a_plate_among_the_last_eight_is_not_solved_again) {
  LastSolved<int, int> last;
  int n_solved = 0;
  const auto square = [&](int plate) {
    ++n_solved;
    return plate * plate;
  };
  for (int plate = 0; plate < 8; ++plate) last.get(plate, square);
  for (int plate = 0; plate < 8; ++plate) BOOST_TEST(last.get(plate, square) == plate * plate);
  BOOST_TEST(n_solved == 8);
  last.get(8, square);
  BOOST_TEST(last.get(0, square) == 0);  // forgotten for the ninth
  BOOST_TEST(n_solved == 10);
}

}  // namespace
