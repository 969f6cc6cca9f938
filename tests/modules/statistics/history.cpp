// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/history.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstddef>
#include <string>

namespace {

using namespace brash::statistics;
using boost::test_tools::tolerance;

/// Adds `n` samples of one value, the first at `from`, every `step` [s].
void add(History& history, double from, double step, std::size_t n, double value) {
  for (std::size_t i = 0; i < n; ++i) {
    history.times.push_back(from + step * static_cast<double>(i));
    history.values.push_back(value);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(histories)

BOOST_AUTO_TEST_CASE(pieces_with_different_steps_are_weighed_by_time) {
  History history;
  add(history, 0.0, 0.05, 4000, 1.0);
  add(history, 210.0, 0.1, 2000, 3.0);
  const EvenHistory even = make_even(history);
  BOOST_TEST(!even.sampling.even);
  BOOST_TEST(even.sampling.gaps.size() == 1U);
  // 200 s of each value. At the ends and the gap a sample counts for half of the mean step of 0.067 s.
  BOOST_TEST(summarise(history, even).mean == 2.0, tolerance(1e-3));
  BOOST_TEST(even.duration == 400.0, tolerance(1e-3));
  // Both pieces are on the grid of one step, and keep their lengths.
  for (const auto piece : even.pieces(history))
    BOOST_TEST(even.sampling.step * static_cast<double>(piece.size()) == 200.0, tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(pieces_with_one_step_are_even_wherever_they_begin) {
  History history;
  add(history, 0.0, 0.1, 500, 1.0);
  add(history, 77.03, 0.1, 1500, 3.0);
  const EvenHistory even = make_even(history);
  BOOST_TEST(even.sampling.even);
  BOOST_TEST(summarise(history, even).mean == 2.5, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(lost_samples_leave_the_step_as_it_is) {
  History history;
  for (int i = 0; i < 1000; ++i) {
    if (i % 50 == 20 || i % 50 == 21 || i == 333) continue;
    history.times.push_back(0.02 * i);
    history.values.push_back(std::sin(0.1 * i));
  }
  const EvenHistory even = make_even(history);
  BOOST_TEST(even.sampling.step == 0.02, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(even.sampling.n_lost == 41U);
  BOOST_TEST(even.sampling.gaps.empty());
  BOOST_TEST_REQUIRE(even.resampled.size() == 1U);
  BOOST_TEST(even.resampled.front().size() == 1000U);
  // A change of the sampling rate is no loss, and steps that vary have no grid.
  History slower;
  add(slower, 0.0, 0.05, 400, 1.0);
  add(slower, 20.0, 0.1, 200, 1.0);
  BOOST_TEST(make_even(slower).sampling.n_lost == 0U);
  for (std::size_t i = 0; i < history.times.size(); ++i) history.times[i] += 0.004 * std::sin(double(i));
  BOOST_TEST(make_even(history).sampling.n_lost == 0U);
}

BOOST_AUTO_TEST_CASE(a_change_of_the_sampling_rate_is_told_from_gaps) {
  // 20 s at 0.01 s, 100 s at 0.1 s: the slow part falls into single samples.
  History burst;
  add(burst, 0.0, 0.01, 2000, 3.0);
  add(burst, 20.0, 0.1, 1000, 1.0);
  BOOST_TEST(gap_warning(burst, make_even(burst)) ==
             "999 of 1000 pieces between gaps have one sample: the sampling rate seems to change, so give --gap");
  BOOST_TEST(!make_even(burst).sampling.even);
  BOOST_TEST(summarise(burst, make_even(burst)).n == 3000U);
  BOOST_TEST(gap_warning(burst, make_even(burst, 0.2)) == "");

  History halves;
  add(halves, 0.0, 0.1, 300, 1.0);
  add(halves, 40.0, 0.1, 300, 1.0);
  BOOST_TEST(gap_warning(halves, make_even(halves)) ==
             "gaps cover 14 % of the time: if the sampling rate changes, give --gap");
  History whole;
  add(whole, 0.0, 0.1, 300, 1.0);
  add(whole, 32.0, 0.1, 300, 1.0);
  BOOST_TEST(gap_warning(whole, make_even(whole)) == "");
}

BOOST_AUTO_TEST_SUITE_END()
