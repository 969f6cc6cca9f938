// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/load_history.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <string>

#include "brash/analysis/campaign_histories.hpp"
#include "brash/analysis/history_statistics.hpp"
#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "brash/io/results.hpp"
#include "history_file.hpp"

namespace {

using namespace brash;
using namespace brash::analysis;
using boost::test_tools::tolerance;

}  // namespace

BOOST_AUTO_TEST_SUITE(load_histories)

BOOST_AUTO_TEST_CASE(a_named_column_is_read_with_its_times) {
  const TemporaryFile file("# measured\ntime,Fx,Fz\n0.5,1e3,-1\n0.6,2000,-2\r\n0.7,+3000, -3\n\n");
  const LoadHistory first = read_history(file.path(), {});
  BOOST_TEST(first.column == "Fx");
  BOOST_TEST(first.history.times.front() == 0.5);
  BOOST_TEST(first.even.sampling.step == 0.1, tolerance(1e-12));
  BOOST_TEST(first.history.values == (std::vector<double>{1000, 2000, 3000}), boost::test_tools::per_element());
  HistoryChoice vertical;
  vertical.column = "Fz";
  BOOST_TEST(read_history(file.path(), vertical).history.values == (std::vector<double>{-1, -2, -3}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(numbers_without_names_and_other_separators_are_read) {
  for (const std::string text : {"0 5\n1 6\n2 7\n", "0;5\n1;6\n2;7\n", "0\t5\n1\t6\n2\t7\n", "  0   5 \n 1  6\n2 7"}) {
    const TemporaryFile file(text);
    const LoadHistory history = read_history(file.path(), {});
    BOOST_TEST(history.column == "2");
    BOOST_TEST(history.history.values == (std::vector<double>{5, 6, 7}), boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(a_single_column_needs_the_step) {
  BOOST_TEST(contains(complaint("1\n2\n3\n"), "--dt"));
  const TemporaryFile file("1\n2\n3\n");
  HistoryChoice choice;
  choice.dt = 0.25;
  const LoadHistory history = read_history(file.path(), choice);
  BOOST_TEST(history.even.sampling.step == 0.25);
  BOOST_TEST(history.history.values.size() == 3U);
}

BOOST_AUTO_TEST_CASE(a_step_is_for_files_without_times) {
  HistoryChoice choice;
  choice.dt = 0.02;
  for (const std::string text : {"time [s],Fx\n0,5\n0.1,6\n", "Fx,t\n5,0\n6,0.1\n"})
    BOOST_TEST(contains(complaint(text, choice), ", and a time step is given"));
  BOOST_TEST(contains(complaint("0 5\n0.1 6\n", choice), "of which the first may be of times"));
  const TemporaryFile unnamed("3 5\n4 6\n");
  for (const auto& [column, first] : {std::pair("1", 3.0), std::pair("2", 5.0)}) {
    choice.column = column;
    const LoadHistory load = read_history(unnamed.path(), choice);
    BOOST_TEST(load.history.values.front() == first);
    BOOST_TEST(load.even.sampling.step == 0.02);
  }
  choice.column = "";
  const TemporaryFile named("Fx,Fz\n5,1\n6,2\n");
  BOOST_TEST(read_history(named.path(), choice).column == "Fx");
}

BOOST_AUTO_TEST_CASE(what_is_earlier_than_from_is_left_out) {
  const TemporaryFile file("time,F\n0.01,1\n0.02,2\n0.03,3\n0.04,4\n0.05,5\n");
  HistoryChoice choice;
  choice.has_from = true;
  for (const double from : {0.03, 0.0299}) {
    choice.from = from;
    const LoadHistory history = read_history(file.path(), choice);
    BOOST_TEST(history.history.values == (std::vector<double>{3, 4, 5}), boost::test_tools::per_element());
    BOOST_TEST(history.history.times.front() == 0.03);
  }
  choice.from = 0.05;
  BOOST_CHECK_THROW(read_history(file.path(), choice), InputError);
  choice.from = 0.03;
  choice.after = true;
  BOOST_TEST(read_history(file.path(), choice).history.values == (std::vector<double>{4, 5}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_loads_of_a_run_are_read_from_its_netcdf_file_as_from_its_table) {
  const TemporaryFile place("");
  const std::string folder = std::filesystem::path(place.path()).parent_path().string();
  model::RunResults results;
  for (int i = 1; i <= 20; ++i) {
    model::LoadRow row;
    row.time = 0.01 * i;
    row.total = {{1e5 + i, 0.0, -2.0 * i}, {0.0, 3.0 * i, 0.0}};
    row.crushing.force.z = 7.0 * i;
    results.loads.push_back(row);
  }
  io::write_results(folder, io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml"), results);
  for (const char* column : {"Fx", "Fz", "My", "crushing_Fz"}) {
    HistoryChoice choice;
    choice.column = column;
    const LoadHistory table = read_history(folder + "/history.csv", choice);
    const LoadHistory run = read_history(folder + "/run.nc", choice);
    BOOST_TEST(run.history.values == table.history.values, boost::test_tools::per_element());
    BOOST_TEST(run.history.times == table.history.times, boost::test_tools::per_element());
    BOOST_TEST(run.even.sampling.even);
  }
}

BOOST_AUTO_TEST_CASE(times_in_another_unit_become_seconds) {
  const TemporaryFile file("Time [ms];F\n0;1\n20;2\n40;3\n");
  const LoadHistory load = read_history(file.path(), {});
  BOOST_TEST(load.column == "F");
  BOOST_TEST(load.even.sampling.step == 0.02, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(what_spreadsheets_and_loggers_export_is_read) {
  for (const std::string text : {
           "Time [s];Fx [kN]\n0,0;1,5\n0,5;2,5\n1,0;3,5\n",                        // decimal commas
           "\xef\xbb\xbfTime [s]\tFx [kN]\r\n0,0\t1,5\r\n0,5\t2,5\r\n1\t3,5\r\n",  // of Windows, with a byte order mark
           "\"Time (ms)\",\"Fx (kN)\"\n\"0\",\"1.5\"\n\"500\",\"2.5\"\n\"1000\",\"3.5\"\n",
           "Zeit,Fx\ns,kN\n0,1.5\n0.5,2.5\n1,3.5\n",  // units in a line of their own
           "Zeit;Fx\n[ms];[kN]\n0;1,5\n500;2,5\n1000;3,5\n",
       }) {
    const TemporaryFile file(text);
    const LoadHistory load = read_history(file.path(), {});
    BOOST_TEST(load.column == "Fx");
    BOOST_TEST(load.unit == "N");
    BOOST_TEST(load.history.times == (std::vector<double>{0, 0.5, 1}), boost::test_tools::per_element());
    BOOST_TEST(load.history.values == (std::vector<double>{1500, 2500, 3500}), boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(a_unit_is_converted_to_si_or_kept) {
  const TemporaryFile file("t [min],M [kN m],p [MPa],E [J],U [V],n [],Q\n0,1,1,1,1,1,1\n1,2,2,2,2,2,2\n");
  const auto read = [&](const char* column) {
    HistoryChoice choice;
    choice.column = column;
    const LoadHistory load = read_history(file.path(), choice);
    BOOST_TEST(load.history.times.back() == 60.0);
    return std::pair(load.unit, load.history.values.back());
  };
  BOOST_TEST((read("M") == std::pair(std::string("N m"), 2e3)));
  BOOST_TEST((read("p [MPa]") == std::pair(std::string("Pa"), 2e6)));  // as the file has it
  BOOST_TEST((read("E") == std::pair(std::string("J"), 2.0)));
  BOOST_TEST((read("U") == std::pair(std::string("V"), 2.0)));
  BOOST_TEST((read("n") == std::pair(std::string(), 2.0)));
  BOOST_TEST((read("Q") == std::pair(std::string(), 2.0)));
}

BOOST_AUTO_TEST_CASE(missing_values_and_missing_rows_make_gaps) {
  std::string text = "t,F\n";
  for (int i = 0; i < 100; ++i) {
    if (i >= 40 && i < 50) continue;  // rows are missing
    text += std::to_string(0.1 * i) + (i >= 70 && i < 80 ? ",\n" : ",5\n");
  }
  const TemporaryFile file(text);
  const LoadHistory load = read_history(file.path(), {});
  BOOST_TEST(load.n_missing == 10U);
  BOOST_TEST(load.even.sampling.even);
  BOOST_TEST_REQUIRE(load.even.sampling.gaps.size() == 2U);
  BOOST_TEST(load.even.sampling.gaps[0].from == 3.9, tolerance(1e-12));
  BOOST_TEST(load.even.sampling.gaps[1].to == 8.0, tolerance(1e-12));
  const auto s = statistics_of(load);
  BOOST_TEST(s["duration"].get<double>() == 8.0, tolerance(1e-12));
  BOOST_TEST(contains(statistics_text(s), "gaps                 2 (2.2 s together), 10 values missing"));
  HistoryChoice patient;
  patient.longest_interval = 2.0;
  BOOST_TEST(read_history(file.path(), patient).even.sampling.gaps.empty());
}

BOOST_AUTO_TEST_CASE(a_usual_marker_of_missing_values_is_warned_of_and_left_out_on_request) {
  const auto table = [](const std::string& head, const std::string& marker) {
    std::string text = "time [s]," + head + "\n";
    for (int i = 0; i < 40; ++i)
      text += std::to_string(i) + "," + (i % 20 == 3 ? marker : std::to_string(50 + i % 7)) + "\n";
    return text;
  };
  for (const auto& [head, marker] : {std::pair("F [kN]", "-9999"), {"F [N]", "-999.25"}, {"F", "99999"}}) {
    const TemporaryFile file(table(head, marker));
    const LoadHistory load = read_history(file.path(), {});
    BOOST_TEST_REQUIRE(load.marker.has_value());
    BOOST_TEST(load.marker->value == std::stod(marker));
    BOOST_TEST(load.marker->n == 2U);
    BOOST_TEST(contains(statistics_text(statistics_of(load, {})), std::string("--missing ") + marker));
    HistoryChoice choice;
    choice.missing = {std::stod(marker)};
    const LoadHistory without = read_history(file.path(), choice);
    BOOST_TEST(without.n_missing == 2U);
    BOOST_TEST(!without.marker.has_value());
    BOOST_TEST(without.even.sampling.n_lost == 2U);
  }
  // The end of a range is not a marker, and neither is another number that lies apart.
  for (const char* const ordinary : {"57", "-9998", "1e5"})
    BOOST_TEST(!read_history(TemporaryFile(table("F", ordinary)).path(), {}).marker.has_value());
  std::vector<double> wave;
  for (int i = 0; i <= 99; ++i) wave.push_back(i);
  BOOST_TEST(!missing_marker(wave, 1.0).has_value());
}

BOOST_AUTO_TEST_CASE(the_date_of_a_history_is_kept) {
  const TemporaryFile file("time,F\n2024-02-01T12:00:00.3,1\n2024-02-01T12:00:00.4,2\n2024-02-01T12:00:00.5,3\n");
  HistoryChoice choice;
  choice.has_from = true;
  choice.from = 0.1;
  const LoadHistory load = read_history(file.path(), choice);
  BOOST_TEST(load.history.times == (std::vector<double>{0.1, 0.2}), boost::test_tools::per_element());
  const auto json = statistics_of(load, {});
  BOOST_TEST(json["start"] == "2024-02-01T12:00:00.3");
  BOOST_TEST(contains(statistics_text(json), "from t = 0.1 s after 2024-02-01T12:00:00.3"));
}

BOOST_AUTO_TEST_CASE(the_window_of_a_run_has_one_rule_whoever_says_where_it_begins) {
  const std::string rows = "time,Fx\n0.1,1\n0.2,2\n0.3,3\n0.4,4\n0.5,5\n";
  const TemporaryFile run(rows), summary(R"({"statistics_from": 0.2, "statistics_until": 0.5})", "summary.json"),
      measured(rows, "measured.csv");
  HistoryChoice of_summary, told;
  begin_as_run(of_summary, run.path());
  told.has_from = true;
  told.from = 0.2;
  BOOST_TEST(read_history(run.path(), of_summary).history.times.front() == 0.3);
  BOOST_TEST(read_history(run.path(), told).history.times.front() == 0.3);
  BOOST_TEST(read_history(measured.path(), told).history.times.front() == 0.2);
}

BOOST_AUTO_TEST_CASE(bad_files_are_refused_with_the_place) {
  BOOST_TEST(contains(complaint("time,F\n0,1\n1,x\n2,3\n"), "history.csv:3: column 'F': 'x'"));
  BOOST_TEST(contains(complaint("time,F\n0,1\nnan,2\n2,3\n"), ":3: the time is missing"));
  BOOST_TEST(contains(complaint("time,F\n0,1\n1,inf\n2,3\n"), ":3:"));
  BOOST_TEST(contains(complaint("time,F\n0,1\n1,2,3\n"), ":3: 3 values in a table of 2"));
  BOOST_TEST(contains(complaint("time,F\n0,1\n1,2\n1,3\n2,4\n"), ":4: time 1 after 1\n  allowed: times that rise"));
  BOOST_TEST(contains(complaint("time [kg],F\n0,1\n1,2\n"), "column 'time [kg]': the times' unit 'kg'"));
  BOOST_TEST(contains(complaint("time,F\n0,1\n1,nan\n2,NA\n"), "fewer than two values"));
  BOOST_TEST(contains(complaint("time,F\n0,1\n"), "1 rows of numbers\n  allowed: lines of numbers, 2 at least"));
  HistoryChoice wrong;
  wrong.column = "Fy";
  BOOST_TEST(contains(complaint("time,Fx\n0,1\n1,2\n", wrong), "has no column 'Fy'\n  allowed: one of: time, Fx"));
  BOOST_CHECK_THROW(read_history("/no/such/file.csv", {}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
