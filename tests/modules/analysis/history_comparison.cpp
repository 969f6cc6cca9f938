// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/history_comparison.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "brash/analysis/history_statistics.hpp"
#include "brash/core/constants.hpp"
#include "brash/statistics/random.hpp"

namespace {

using namespace brash;
using namespace brash::analysis;

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

std::vector<std::string> differs(const LoadHistory& run, const LoadHistory& measured) {
  return compare_histories(run, measured)["differs"].get<std::vector<std::string>>();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(compare_command)

BOOST_AUTO_TEST_CASE(a_history_does_not_differ_from_itself) {
  const LoadHistory load = noise(1, 2000, 100.0, 20.0);
  const auto c = compare_histories(load, load);
  BOOST_TEST(c["differs"].empty());
  BOOST_TEST(c["mean"]["ratio"].get<double>() == 1.0);
  BOOST_TEST(c["distribution"]["p"].get<double>() == 1.0);
  BOOST_TEST(c["spectrum"]["outside_95"].get<double>() == 0.0);
  BOOST_TEST(contains(comparison_text(c), "no difference at 5 %"));
}

BOOST_AUTO_TEST_CASE(each_side_has_every_statistic_of_its_history) {
  const LoadHistory load = noise(1, 2000, 100.0, 20.0), other = noise(2, 2000, 90.0, 20.0);
  const auto c = compare_histories(load, other);
  for (const auto& [side, history] : {std::pair{"run", &load}, {"measured", &other}}) {
    const auto alone = statistics_of(*history);
    statistics::Summary::visit(
        [&, &side = side](const statistics::Statistic& of, auto) { BOOST_TEST(c[side][of.name] == alone[of.name]); });
  }
}

BOOST_AUTO_TEST_CASE(two_columns_of_one_file_are_compared_by_their_differences) {
  LoadHistory load = noise(1, 2000, 100.0, 20.0), beside = load;
  const LoadHistory error = noise(2, 2000, 0.0, 1.0);
  for (std::size_t i = 0; i < beside.history.values.size(); ++i)
    beside.history.values[i] += 1.0 + error.history.values[i];
  // Of two files, an offset of 1 is lost in a deviation of 20.
  BOOST_TEST(compare_histories(load, beside)["mean"]["p"].get<double>() > 0.1);
  load.file = beside.file = "sensors.csv";
  const auto c = compare_histories(load, beside);
  BOOST_TEST(c["mean"]["p"].get<double>() < 1e-6);
  BOOST_TEST(c["mean"]["difference_95"][0].get<double>() < -1.0);
  BOOST_TEST(c["mean"]["difference_95"][1].get<double>() > -1.2);
  BOOST_TEST(contains(comparison_text(c), "two columns of one file"));
  BOOST_TEST(contains(comparison_text(c), "p < 1e-06"));
}

BOOST_AUTO_TEST_CASE(a_short_history_is_named) {
  // A memory of five steps: the autocorrelation time is 4.5 of them.
  const LoadHistory lasting = noise(1, 2000, 100.0, 20.0), brief = noise(2, 100, 100.0, 20.0);
  BOOST_TEST(!contains(comparison_text(compare_histories(lasting, lasting)), "note:"));
  const std::string text = comparison_text(compare_histories(brief, lasting));
  BOOST_TEST(contains(text, "note: measured 1 is shorter than 50 autocorrelation times"));
  BOOST_TEST(!contains(text, "measured 2 is"));
}

BOOST_AUTO_TEST_CASE(replicates_of_one_process_differ_in_few_cases) {
  int different = 0;
  for (std::uint64_t r = 0; r < 100; ++r)
    different += differs(noise(2 * r, 1500, 100.0, 20.0), noise(2 * r + 1, 1000, 100.0, 20.0)).empty() ? 0 : 1;
  BOOST_TEST(different <= 12);  // 5 of 100 wanted; three errors of a count above it
}

BOOST_AUTO_TEST_CASE(what_is_changed_is_what_differs) {
  const LoadHistory measured = noise(1, 3000, 100.0, 10.0);
  const auto has = [&](const LoadHistory& run, const char* name) {
    const auto names = differs(run, measured);
    return std::ranges::find(names, name) != names.end();
  };
  const LoadHistory higher = noise(2, 3000, 110.0, 10.0), wilder = noise(2, 3000, 100.0, 14.0);
  BOOST_TEST(has(higher, "mean"));
  BOOST_TEST(has(higher, "distribution"));
  BOOST_TEST(!has(higher, "deviation"));
  BOOST_TEST(!has(wilder, "mean"));
  BOOST_TEST(has(wilder, "deviation"));
  const LoadHistory faster = noise(2, 3000, 100.0, 10.0, 0.05);
  BOOST_TEST(has(faster, "peak_rate"));
  BOOST_TEST(!has(faster, "deviation"));
}

/// A load that rises in a straight line over `duration` [s], with noise about it.
LoadHistory rising(std::uint64_t replicate, double from, double to, double duration, std::size_t n = 4000) {
  LoadHistory load = noise(replicate, n, 0.0, 5.0, duration / static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i)
    load.history.values[i] += from + (to - from) * static_cast<double>(i) / static_cast<double>(n);
  load.even = statistics::make_even(load.history);
  return load;
}

BOOST_AUTO_TEST_CASE(growth_is_the_second_half_over_the_first) {
  const auto c = compare_histories(rising(1, 100.0, 300.0, 400.0), noise(2, 4000, 200.0, 5.0));
  // The halves have 150 and 250.
  BOOST_TEST(c["growth"]["ratio"].get<double>() == 250.0 / 150.0, boost::test_tools::tolerance(0.01));
  BOOST_TEST(c["growth"]["growth"][1].get<double>() == 1.0, boost::test_tools::tolerance(0.01));
  const auto windows = c["growth"]["windows"]["run"];
  BOOST_TEST(windows.size() == 4U);
  for (std::size_t i = 0; i < 4; ++i)
    BOOST_TEST(windows[i]["mean"].get<double>() == 125.0 + 50.0 * static_cast<double>(i),
               boost::test_tools::tolerance(0.02));
  BOOST_TEST(c["growth"]["unit"].get<std::string>() == "s");
  BOOST_TEST(contains(comparison_text(c), "second half over first: 1.67 and 1"));
}

BOOST_AUTO_TEST_CASE(growth_is_compared_over_equal_travel_if_the_speeds_are_known) {
  // The same load over the travel, at 0.5 and at 1 m/s, but the slow run covers half of the way.
  const LoadHistory slow = rising(1, 100.0, 200.0, 400.0), fast = rising(2, 100.0, 300.0, 400.0);
  const auto by_travel = compare_histories(slow, fast, {0.5, 1.0})["growth"];
  BOOST_TEST(by_travel["travel"].get<double>() == 200.0, boost::test_tools::tolerance(0.001));
  BOOST_TEST(by_travel["unit"].get<std::string>() == "m");
  BOOST_TEST(by_travel["ratio"].get<double>() == 1.0, boost::test_tools::tolerance(0.01));
  BOOST_TEST(by_travel["windows"]["measured"][3]["to"].get<double>() == 200.0, boost::test_tools::tolerance(0.001));
  // Over equal time the halves have 125 and 175 against 150 and 250.
  BOOST_TEST(compare_histories(slow, fast)["growth"]["ratio"].get<double>() == 175.0 / 125.0 / (250.0 / 150.0),
             boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(a_window_in_a_gap_has_no_mean) {
  LoadHistory measured = noise(1, 3000, 100.0, 10.0);
  measured.history.times.erase(measured.history.times.begin() + 500, measured.history.times.begin() + 900);
  measured.history.values.erase(measured.history.values.begin() + 500, measured.history.values.begin() + 900);
  measured.even = statistics::make_even(measured.history);
  const auto c = compare_histories(noise(2, 1000, 100.0, 10.0), measured);  // 100 s, and the gap lasts from 50 to 90 s
  BOOST_TEST(c["growth"]["windows"]["measured"][2]["mean"].is_null());
  BOOST_TEST(!c["growth"]["windows"]["measured"][3]["mean"].is_null());
  BOOST_TEST(contains(comparison_text(c), ", -, "));
}

BOOST_AUTO_TEST_CASE(growth_of_replicates_has_its_error_from_their_spread) {
  std::vector<LoadHistory> runs, tests;
  for (std::uint64_t i = 0; i < 5; ++i) {
    runs.push_back(rising(2 * i, 100.0, 300.0, 400.0));
    tests.push_back(noise(2 * i + 1, 4000, 200.0, 5.0));
  }
  const auto c = compare_histories(runs, tests);
  const auto differing = c["differs"].get<std::vector<std::string>>();
  BOOST_TEST((std::ranges::find(differing, "growth") != differing.end()));
  BOOST_TEST(c["growth"]["ratio"].get<double>() == 5.0 / 3.0, boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(a_load_without_a_positive_mean_or_with_few_samples_has_no_growth) {
  const LoadHistory load = noise(1, 2000, 100.0, 20.0);
  BOOST_TEST(!compare_histories(load, noise(2, 2000, -100.0, 20.0)).contains("growth"));
  BOOST_TEST(!compare_histories(load, noise(2, 30, 100.0, 20.0)).contains("growth"));
  BOOST_TEST(contains(comparison_text(compare_histories(load, noise(2, 30, 100.0, 20.0))), "growth"));
}

BOOST_AUTO_TEST_CASE(a_replicate_with_a_shorter_step_weighs_as_its_time) {
  const auto constant = [](std::size_t n, double dt, double value) {
    LoadHistory load;
    for (std::size_t i = 0; i < n; ++i) {
      load.history.times.push_back(dt * static_cast<double>(i));
      load.history.values.push_back(value);
    }
    load.even = statistics::make_even(load.history);
    return load;
  };
  const LoadHistory all = joined({constant(1000, 0.1, 1.0), constant(4000, 0.025, 3.0)});
  BOOST_TEST(!all.even.sampling.even);
  BOOST_TEST(all.even.sampling.gaps.size() == 1U);
  // 100 s of each value; an end errs by a step.
  BOOST_TEST(statistics::summarise(all.history, all.even).mean == 2.0, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(peaks_of_one_height_are_as_uncertain_as_the_mean_below_them) {
  LoadHistory teeth;
  for (int i = 0; i < 400; ++i) {
    teeth.history.times.push_back(0.1 * i);
    teeth.history.values.push_back(i % 4 == 0 ? 110.0 : 100.0);
  }
  teeth.even = statistics::make_even(teeth.history);
  const auto other = compare_histories(teeth, noise(1, 2000, 100.0, 10.0))["mean_peak"];
  BOOST_TEST(std::isfinite(other["ratio_95"][0].get<double>()));
  BOOST_TEST(std::isfinite(other["ratio_95"][1].get<double>()));
  const auto itself = compare_histories(teeth, teeth)["mean_peak"];
  BOOST_TEST(itself["ratio_95"][0].get<double>() < 1.0);
  BOOST_TEST(itself["ratio_95"][1].get<double>() > 1.0);
  BOOST_TEST(itself["p"].get<double>() == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()
