// SPDX-License-Identifier: GPL-3.0-or-later
#include "chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "brash/core/text.hpp"
#include "stats_picture.hpp"

namespace {

using namespace brash;
using namespace brash::cli;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string logarithmic(double lower, double upper) {
  return Chart(0.0, 0.0, 100.0, 100.0, "", {"size [m]", lower, upper, true}, {"", 0.0, 1.0}).svg();
}

std::string picture_of(double mean, double amplitude) {
  LoadHistory load{"Fz", {}, {}, 0};
  for (int i = 0; i < 4000; ++i) {
    load.history.times.push_back(0.1 * i);
    load.history.values.push_back(mean + amplitude * ((i * 37) % 101 - 50) / 50.0);
  }
  load.even = statistics::make_even(load.history);
  return stats_picture(load, {});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(chart)

BOOST_AUTO_TEST_CASE(a_logarithmic_axis_has_two_numbers_at_least) {
  const std::string decade = logarithmic(1.66, 7.35), narrow = logarithmic(3.1, 4.6), wide = logarithmic(0.5, 2000.0);
  BOOST_TEST(contains(decade, ">2</text>"));
  BOOST_TEST(contains(decade, ">5</text>"));
  BOOST_TEST(contains(narrow, ">3.5</text>"));
  BOOST_TEST(contains(narrow, ">4</text>"));
  for (const char* const power : {">1</text>", ">10</text>", ">1000</text>"}) BOOST_TEST(contains(wide, power));
  BOOST_TEST(!contains(wide, ">2</text>"));
}

BOOST_AUTO_TEST_CASE(an_axis_ends_above_its_values_whatever_their_sign) {
  BOOST_TEST(upper_end(0.0, 100.0) == 105.0);
  BOOST_TEST(upper_end(-260.0, -100.0) == -92.0);
  BOOST_TEST(upper_end(0.0, 0.0) == 1.0);
  BOOST_TEST(upper_end(-5.0, -5.0) == -4.0);
}

BOOST_AUTO_TEST_CASE(histories_below_zero_and_without_a_load_are_drawn) {
  // 0 lies on the axis of the loads, and the highest sample below its end.
  BOOST_TEST(contains(picture_of(-180e3, 80e3), ">0</text>"));
  BOOST_TEST(contains(picture_of(-180e3, 80e3), ">-200k</text>"));
  BOOST_TEST(!contains(picture_of(0.0, 0.0), "nan"));
}

BOOST_AUTO_TEST_SUITE_END()
