// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/peaks.hpp"

#include <boost/test/unit_test.hpp>
#include <vector>

#include "brash/core/contract.hpp"
#include "brash/statistics/moments.hpp"

namespace {

using namespace brash::statistics;
using Samples = std::vector<double>;

std::vector<std::size_t> places(const std::vector<Peak>& peaks) {
  std::vector<std::size_t> out;
  for (const Peak& peak : peaks) out.push_back(peak.index);
  return out;
}

void check_places(const std::vector<Peak>& peaks, const std::vector<std::size_t>& expected) {
  BOOST_TEST(places(peaks) == expected, boost::test_tools::per_element());
}

const Samples kSaw{0, 2, 5, 3, 0, 4, 0, 0, 0, 7, 7, 1};

}  // namespace

BOOST_AUTO_TEST_SUITE(peaks)

BOOST_AUTO_TEST_CASE(each_excursion_above_the_threshold_has_one_peak) {
  check_places(peaks_above(kSaw, 1.0), {2, 5, 9});
}

BOOST_AUTO_TEST_CASE(excursions_with_too_short_a_calm_between_them_are_one) {
  check_places(peaks_above(kSaw, 1.0, 2), {2, 9});  // one calm sample joins 5 and 4, three keep 7 apart
  check_places(peaks_above(kSaw, 1.0, 4), {9});
}

BOOST_AUTO_TEST_CASE(a_calm_history_has_no_peaks) {
  check_places(peaks_above(kSaw, 7.0), {});
  check_places(peaks_above(Samples{}, 0.0), {});
  check_places(peaks_between_crossings(kSaw, 7.0), {});
}

BOOST_AUTO_TEST_CASE(between_upward_crossings_lies_one_peak_and_the_ends_do_not_count) {
  // Upward crossings of 1 at samples 1, 5 and 9: whole pieces are [1, 5) and [5, 9).
  check_places(peaks_between_crossings(kSaw, 1.0), {2, 5});
}

BOOST_AUTO_TEST_CASE(block_maxima_leave_out_an_incomplete_block) {
  BOOST_TEST(block_maxima(kSaw, 5) == (Samples{5, 7}), boost::test_tools::per_element());
  BOOST_TEST(block_maxima(kSaw, 13).empty());
  BOOST_CHECK_THROW(block_maxima(kSaw, 0), brash::ContractViolation);
}

BOOST_AUTO_TEST_CASE(a_histogram_holds_lower_edges_and_the_last_upper_edge) {
  const Histogram h = histogram(Samples{0.0, 1.0, 1.5, 2.0, 3.0, 3.1, -0.1}, 3, 0.0, 3.0);
  BOOST_TEST(h.counts == (std::vector<std::size_t>{1, 2, 2}), boost::test_tools::per_element());
  BOOST_TEST(h.n_outside == 2U);
  BOOST_CHECK_THROW(histogram(kSaw, 0, 0.0, 1.0), brash::ContractViolation);
  BOOST_CHECK_THROW(histogram(kSaw, 3, 1.0, 1.0), brash::ContractViolation);
}

BOOST_AUTO_TEST_CASE(equal_values_have_no_spread_and_no_shape) {
  const Moments m = moments(Samples(7, 0.1));
  BOOST_TEST(m.mean == 0.1);
  BOOST_TEST(m.variance == 0.0);
  BOOST_TEST(m.skewness == 0.0);
  BOOST_TEST(m.excess_kurtosis == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
