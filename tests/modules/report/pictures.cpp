// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/report/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "brash/analysis/history_comparison.hpp"
#include "brash/core/text.hpp"
#include "brash/statistics/random.hpp"
#include "chart.hpp"
#include "drawing.hpp"

namespace {

using namespace brash;
using namespace brash::report;
using analysis::LoadHistory;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A load about `mean` with a memory of five steps.
LoadHistory noise(std::uint64_t replicate, std::size_t n, double mean, double deviation, double dt = 0.1) {
  statistics::RandomStream stream(3, "compare", replicate, "noise");
  LoadHistory load;
  load.column = "Fx";
  double state = stream.normal();
  for (std::size_t i = 0; i < n; ++i) {
    state = 0.8 * state + 0.6 * stream.normal();
    load.history.times.push_back(dt * static_cast<double>(i));
    load.history.values.push_back(mean + deviation * state);
  }
  load.even = statistics::make_even(load.history);
  return load;
}

std::string logarithmic(double lower, double upper) {
  return Chart(0.0, 0.0, 100.0, 100.0, "", {"size [m]", lower, upper, true}, {"", 0.0, 1.0}).svg();
}

std::string picture_of(double mean, double amplitude, const std::string& unit = "") {
  LoadHistory load{"Fz", {}, {}, 0};
  load.unit = unit;
  for (int i = 0; i < 4000; ++i) {
    load.history.times.push_back(0.1 * i);
    load.history.values.push_back(mean + amplitude * ((i * 37) % 101 - 50) / 50.0);
  }
  load.even = statistics::make_even(load.history);
  return stats_picture(load, {});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(pictures)

BOOST_AUTO_TEST_CASE(a_drawing_is_to_scale_with_y_upwards) {
  Drawing drawing({10.0, 20.0}, 2.0, {-1.0, 0.0}, {4.0, 3.0});
  drawing.box({-1.0, 0.0}, {0.0, 1.0}, "class=\"ice\"");
  BOOST_TEST(drawing.svg() == "<path d=\"M10.0 26.0L12.0 26.0L12.0 24.0L10.0 24.0Z\" class=\"ice\"/>\n");
  BOOST_TEST((drawing.on_page({4.0, 3.0}) == Vec2{20.0, 20.0}));
  BOOST_TEST((drawing.size() == Vec2{10.0, 6.0}));
  drawing.rings_within({{{0.0, 0.0}, {9.0, 0.0}, {9.0, 9.0}}}, "class=\"land\"");
  BOOST_TEST(contains(drawing.svg(), "viewBox=\"10.0 20.0 10.0 6.0\""));
}

BOOST_AUTO_TEST_CASE(a_curve_lies_in_its_band) {
  BOOST_TEST(at_equal_ratios(1.0, 100.0, 3) == std::vector<double>({1.0, 10.0, 100.0}),
             boost::test_tools::per_element());
  BOOST_TEST(axis_label("load", "kN") == "load [kN]");
  BOOST_TEST(axis_label("load", "") == "load");
  Chart chart(0.0, 0.0, 100.0, 100.0, "", {"x", 0.0, 1.0}, {"", 0.0, 1.0});
  chart.curve({0.0, 1.0}, {0.5, 0.5}, {0.25, 0.25}, {0.75, 0.75}, "#123456");
  const std::string svg = chart.svg();
  const std::size_t band = svg.find("M0.0 25.0L100.0 25.0L100.0 75.0L0.0 75.0Z"),
                    line = svg.find("M0.0 50.0L100.0 50.0\"");
  BOOST_TEST(band < line);
  BOOST_TEST((line != std::string::npos));
}

BOOST_AUTO_TEST_CASE(an_axis_of_large_numbers_has_its_unit_with_a_prefix) {
  const auto chart = [](const char* label, double upper, bool logarithmic) {
    return Chart(0.0, 0.0, 100.0, 100.0, "", {label, logarithmic ? upper / 1e3 : 0.0, upper, logarithmic},
                 {"", 0.0, 1.0})
        .svg();
  };
  const std::string meganewtons = chart("load [N]", 2e6, false), logarithmic = chart("load [N]", 1e9, true);
  BOOST_TEST(contains(meganewtons, ">load [MN]</text>"));
  BOOST_TEST(contains(meganewtons, ">1.5</text>"));
  BOOST_TEST(contains(logarithmic, ">load [GN]</text>"));
  BOOST_TEST(contains(logarithmic, ">0.01</text>"));
  BOOST_TEST(contains(chart("moment [N m]", 5e4, false), ">moment [kN m]</text>"));
  // Without a unit the prefix stands behind each number, and a unit that takes none stays.
  BOOST_TEST(contains(chart("load", 6e8, false), ">400M</text>"));
  BOOST_TEST(contains(chart("load [N]", 900.0, false), ">load [N]</text>"));
  BOOST_TEST(contains(chart("width [m]", 2e6, false), ">width [m]</text>"));
}

BOOST_AUTO_TEST_CASE(a_unit_stands_at_the_end_of_each_label_and_no_number_has_its_prefix) {
  const std::string svg = picture_of(300e3, 200e3, "N");
  for (const char* const label : {">load [kN]</text>", ">load by the law [kN]</text>", ">threshold [kN]</text>"})
    BOOST_TEST(contains(svg, label));
  BOOST_TEST(!contains(svg, "k</text>"));
}

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

BOOST_AUTO_TEST_CASE(the_picture_holds_both_histories_and_closes_its_elements) {
  LoadHistory measured = noise(1, 3000, 100.0, 10.0);
  measured.history.times.erase(measured.history.times.begin() + 500, measured.history.times.begin() + 900);
  measured.history.values.erase(measured.history.values.begin() + 500, measured.history.values.begin() + 900);
  measured.even = statistics::make_even(measured.history);
  LoadHistory run = noise(2, 1000, 100.0, 10.0);
  run.origin.programs = {"brash 0.3.0"};
  const std::string svg = comparison_picture(run, measured, analysis::compare_histories(run, measured));
  BOOST_TEST(contains(svg, "run: Fx"));
  BOOST_TEST(contains(svg, "measured: Fx"));
  BOOST_TEST(contains(svg, "means of quarters"));
  BOOST_TEST(contains(svg, "difference at 5 %"));
  BOOST_TEST(!contains(svg, "nan"));
  const auto count = [&](const std::string& part) {
    int n = 0;
    for (std::size_t at = svg.find(part); at != std::string::npos; at = svg.find(part, at + 1)) ++n;
    return n;
  };
  BOOST_TEST(count("<svg") == count("</svg>"));
  BOOST_TEST(count("<text") == count("</text>"));
}

BOOST_AUTO_TEST_CASE(a_line_breaks_where_a_logarithmic_axis_has_no_place) {
  Chart chart(0.0, 0.0, 100.0, 100.0, "a < b", {"x", 1.0, 3.0}, {"y", 1.0, 100.0, true});
  chart.line({1.0, 2.0, 2.5, 3.0}, {100.0, 0.0, 10.0, 1.0}, "#000");
  const std::string svg = chart.svg();
  BOOST_TEST(contains(svg, "M0.0 0.0M75.0 50.0L100.0 100.0"));
  BOOST_TEST(contains(svg, "a &lt; b"));
}

BOOST_AUTO_TEST_SUITE_END()
