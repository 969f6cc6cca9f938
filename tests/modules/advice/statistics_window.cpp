// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a run that its statistics cover.
#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "brash/simulation/run.hpp"
#include "warnings.hpp"

namespace {

using namespace brash;
using namespace brash::test;

/// Of the validation case with the preset `brash`.
simulation::StatisticsWindow window_with(std::vector<std::string> settings) {
  settings.push_back("algorithm.preset=brash");
  const model::Case c = validation(settings);
  return simulation::Setup(c).window;
}

BOOST_AUTO_TEST_CASE(statistics_begin_behind_the_initial_crack) {
  const auto settings = [](const char* more) { return std::vector<std::string>{"field.initial_crack_radius=5", more}; };
  const simulation::StatisticsWindow behind = window_with(settings("time.step=0.01"));
  BOOST_TEST(behind.from == 12.0 / 1.202, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(behind.until == 20.0);
  BOOST_TEST(behind.begins == "the structure's axis has passed the last floe of the initial crack");
  BOOST_TEST(behind.ends == "the run is over");
  BOOST_TEST(window_with({"field.initial_crack=false"}).from == 7.0 / 1.202, boost::test_tools::tolerance(1e-12));
  const auto of_paper = simulation::statistics_window(validation(settings("algorithm.preset=paper")), 5.0);
  BOOST_TEST(of_paper.from == 0.0);
  BOOST_TEST(of_paper.until == 20.0);
  const auto warnings = [&](const char* more) {
    return warnings_with({"algorithm.preset=brash", "field.initial_crack_radius=5", more});
  };
  BOOST_TEST(says(text_of(warnings("output.statistics_from=9.9"), "early-statistics"), "at 9.98 s"));
  BOOST_TEST(!has(warnings("output.statistics_from=10"), "early-statistics"));
  BOOST_TEST(says(text_of(warnings("time.duration=9"), "no-statistics"), "has passed the last floe"));
}

BOOST_AUTO_TEST_CASE(statistics_of_a_ship_begin_with_its_whole_hull_in_the_ice) {
  const auto window_of = [](double duration) {
    model::Case c = io::read_case(BRASH_SOURCE_DIR "/experiments/ships/icebreaker.toml");
    c.output.statistics_from.reset();
    c.structure.start_distance = 60.0;
    c.time.duration = duration;
    return simulation::statistics_window(c, 0.0);
  };
  // 90 m at the waterline, its origin in the middle of it: half outside when the origin passes the edge.
  const double speed =
      model::speed(io::read_case(BRASH_SOURCE_DIR "/experiments/ships/icebreaker.toml").structure.motion);
  const double stern = (60.0 + 45.0) / speed;
  const simulation::StatisticsWindow whole = window_of(stern + 10.0), half = window_of(stern - 10.0);
  BOOST_TEST(whole.from == stern, boost::test_tools::tolerance(0.03));  // the ice reaches above and below the waterline
  BOOST_TEST(whole.begins == "the ship's stern passes the ice edge: the whole hull is in the ice");
  BOOST_TEST(half.from == 60.0 / speed, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(half.begins == "the structure's axis passes the ice edge");
}

BOOST_AUTO_TEST_CASE(a_run_that_is_too_short_is_told_how_long_it_should_be) {
  // l_c = 3.27 m and 1.202 m/s: five breaking lengths of 1.31 m take 5.44 s, after 9.98 s.
  const auto warnings = [](const char* duration) {
    return warnings_with({"algorithm.preset=brash", "field.initial_crack_radius=5", duration});
  };
  BOOST_TEST(says(text_of(warnings("time.duration=9"), "no-statistics"), "from 9 s to 16 s or more"));
  const auto text = text_of(warnings("time.duration=15"), "short-run");
  BOOST_TEST(says(text, "a break reaches about 0.4 l_c = 1.31 m: expected 5 breaking lengths"), text);
  BOOST_TEST(says(text, "from 15 s to 16 s or more"), text);
  BOOST_TEST(!has(warnings("time.duration=16"), "short-run"));
}

BOOST_AUTO_TEST_CASE(statistics_end_where_the_structure_leaves_the_ice) {
  // The bow is 0.18 m from the ice at the start, and is at 20 m after 16.8 s.
  const simulation::StatisticsWindow left = window_with({"field.length=20", "field.initial_crack=false"});
  BOOST_TEST(left.until == 16.8, boost::test_tools::tolerance(0.01));
  BOOST_TEST(left.ends == "the structure's bow leaves the ice at the far side");
  BOOST_TEST(window_with({"field.length=20", "field.border=free"}).until == 20.0);
  BOOST_TEST(window_with({"field.length=20", "output.statistics_from=17"}).until ==
             20.0);  // of open water, as asked for
}

/// Largest and mean horizontal load of the rows after one time and up to another [N].
struct Loads {
  double largest = 0.0;
  double mean = 0.0;
};

Loads loads_between(const std::vector<model::LoadRow>& rows, double from, double until) {
  Loads loads;
  int n = 0;
  for (const model::LoadRow& row : rows) {
    if (row.time <= from || row.time > until + 1e-9) continue;  // rounding of a time
    loads.largest = std::max(loads.largest, row.total.force.x);
    loads.mean += row.total.force.x;
    ++n;
  }
  loads.mean /= n;
  return loads;
}

BOOST_AUTO_TEST_CASE(a_run_that_outlives_its_sheet_has_the_mean_of_the_ice_alone) {
  const auto run_for = [](const char* duration) {
    return simulation::run(validation(
        {"failure.model=wedge", "field.initial_crack=false", "field.length=14", "field.width=20", duration}));
  };
  const simulation::Run longer = run_for("time.duration=20");
  const simulation::RunSummary& summary = longer.summary;
  BOOST_TEST((summary.window.until > 11.0 && summary.window.until < 12.0));
  const Loads ice = loads_between(longer.results.loads, summary.window.from, summary.window.until);
  const Loads all = loads_between(longer.results.loads, summary.window.from, 20.0);
  BOOST_TEST(summary.horizontal.mean == ice.mean, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(all.mean < 0.8 * ice.mean);  // open water
  // The run that ends there says the same.
  const std::string end = fmt::format("time.duration={}", summary.window.until);
  const simulation::RunSummary shorter = run_for(end.c_str()).summary;
  BOOST_TEST(shorter.horizontal.mean == summary.horizontal.mean);
  BOOST_TEST(shorter.breaking_frequency == summary.breaking_frequency);
}

BOOST_AUTO_TEST_CASE(the_floes_of_the_initial_crack_give_no_statistics) {
  const model::Case c =
      validation({"algorithm.preset=brash", "failure.model=wedge", "field.initial_crack_radius=4", "time.duration=12"});
  const simulation::Run run = simulation::run(c);
  const simulation::StatisticsWindow& window = run.summary.window;
  const double edge = 7.0 / 1.202, behind = 11.0 / 1.202;  // the axis passes the ice edge, and the crack's far side
  BOOST_TEST(window.from == behind, boost::test_tools::tolerance(1e-12));
  const Loads own = loads_between(run.results.loads, behind, 12.0),
              first = loads_between(run.results.loads, edge, behind);
  BOOST_TEST(run.summary.horizontal.maximum == own.largest);
  BOOST_TEST(run.summary.horizontal.mean == own.mean, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(own.largest != first.largest);
  BOOST_TEST(run.summary.maximum_horizontal_whole >= std::max(own.largest, first.largest));
}

}  // namespace
