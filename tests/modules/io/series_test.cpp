// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/io/series.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "brash/core/error.hpp"
#include "scratch.hpp"

namespace {

using namespace brash;

/// The series of a table with these first lines over a row of zeros and a row of ones.
io::Series series_of(const std::string& names, const std::string& units = "") {
  std::string zeros = "0", ones = "1";
  for (const char c : names) zeros += c == ',' ? ",0" : "", ones += c == ',' ? ",1" : "";
  const Scratch scratch;
  return io::read_series(scratch.write("history.csv", names + "\n" + units + zeros + "\n" + ones + "\n"));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(series)

BOOST_AUTO_TEST_CASE(units_in_the_ends_of_names_may_be_quotients) {
  struct Expected {
    const char *head, *name, *unit;
    double one;  ///< 1 in SI, where there is a unit of the program's own
  };
  for (const auto& [head, name, unit, one] : {Expected{"q_N/mm", "q", "N/mm", 1.0},
                                              {"v_m/s", "v", "m/s", 1.0},
                                              {"v_km/h", "v", "m s-1", 1000.0 / 3600.0},
                                              {"a m/s2", "a", "m/s2", 1.0},
                                              {"p_N/mm2", "p", "Pa", 1e6},
                                              {"f_1/s", "f", "1/s", 1.0},
                                              {"F/kN", "F", "N", 1e3},
                                              {"Fx_leg_1/kN", "Fx_leg_1", "N", 1e3},
                                              {"F_kN", "F", "N", 1e3},
                                              {"water_level_mm", "water_level", "m", 1e-3},
                                              {"N/mm", "N/mm", "", 1.0},
                                              {"Fx_leg_1", "Fx_leg_1", "", 1.0}}) {
    const io::Series read = series_of(std::string("time_s,") + head);
    BOOST_TEST_CONTEXT(head) {
      BOOST_TEST(read.names.at(1) == name);
      BOOST_TEST(read.units.at(1) == unit);
      BOOST_TEST(read.columns.at(1).back() == one, boost::test_tools::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(between_blanks_a_unit_in_brackets_belongs_to_the_name_before_it) {
  const Scratch scratch;
  const auto read = [&](const std::string& text) { return io::read_series(scratch.write("history.txt", text)); };
  const io::Series one = read("Fx [kN]\n1\n2\n");
  BOOST_TEST(one.names == std::vector<std::string>{"Fx"}, boost::test_tools::per_element());
  BOOST_TEST(one.units.at(0) == "N");
  BOOST_TEST(one.columns.at(0).back() == 2e3);
  const io::Series several = read("time [s]  Fx (kN) My [kN m]\n0 1 2\n1 3 4\n");
  BOOST_TEST(several.names == (std::vector<std::string>{"time", "Fx", "My"}), boost::test_tools::per_element());
  BOOST_TEST(several.heads.at(2) == "My [kN m]");
  BOOST_TEST(several.columns.at(2).back() == 4e3);
  BOOST_TEST(several.time.value() == 0U);
  // A line of units alone stays what it is.
  const io::Series below = read("time Fx\n[s] [kN]\n0 1\n1 3\n");
  BOOST_TEST(below.names.size() == 2U);
  BOOST_TEST(below.columns.at(1).back() == 3e3);
}

BOOST_AUTO_TEST_CASE(a_closing_remark_is_left_out_with_a_note) {
  const Scratch scratch;
  const auto read = [&](const char* name, const std::string& text) {
    return io::read_series(scratch.write(name, text));
  };
  const std::string table = "\nWritten by HydroDyn\n\n  Time  Fx\n (sec)  (kN)\n 0.0  1.0e+01\n 1.0  0.0e+01\n";
  const std::string remark = "\nThis output file was closed on 19-Oct-2018 at 10:15:16.\n\n";
  const io::Series series = read("tower.out", table + remark);
  BOOST_TEST(series.columns.at(1).front() == 1e4);
  BOOST_TEST(series.rows.size() == 2U);
  BOOST_TEST_REQUIRE(series.notes.size() == 1U);
  BOOST_TEST(series.notes.at(0) ==
             "line 9 is not a row and was left out: This output file was closed on 19-Oct-2018 at 10:15:16.");
  BOOST_TEST(read("plain.csv", "time,Fx\n0,1\n1,2\nend of file\n").rows.size() == 2U);
  // Within the table, and with numbers in it, the line is a broken row.
  for (const char* const bad :
       {"time,Fx\n0,1\n1,2\nrestart\n2,3\n", "time,Fx\n0,1\n1,2\nmean,3\n", "time,Fx\n0,1\n1,2\n2\n", "F\n1\n2\ninf\n"})
    BOOST_CHECK_THROW(read("bad.csv", bad), InputError);
}

BOOST_AUTO_TEST_CASE(dates_become_exact_seconds_after_the_first_which_is_kept) {
  const Scratch scratch;
  const auto read = [&](const std::string& text) { return io::read_series(scratch.write("history.csv", text)); };
  const io::Series dated = read("time,F\n2024-02-29T23:59:59.9,1\n2024-03-01T00:00:00,2\n2024-03-01T00:00:00.6,3\n");
  BOOST_TEST(dated.columns.at(0) == (std::vector<double>{0.0, 0.1, 0.7}), boost::test_tools::per_element());
  BOOST_TEST(dated.start == "2024-02-29T23:59:59.9");
  BOOST_TEST(read("time,F\n0,1\n1,2\n").start.empty());
  // Another form is refused with the form that is read.
  for (const char* const cell : {"01.02.2024 12:00:00", "02/01/2024 12:00", "12:00:00.1", "2024-2-1 12:00"})
    BOOST_CHECK_EXCEPTION(read(std::string("time;F\n") + cell + ";1\n" + cell + ";2\n"), InputError,
                          [](const InputError& e) {
                            const std::string what = e.what();
                            return what.find("history.csv:2") != std::string::npos &&
                                   what.find("2024-02-01T12:00:00.5 (ISO 8601") != std::string::npos;
                          });
}

BOOST_AUTO_TEST_CASE(values_that_stand_for_missing_ones_are_in_the_unit_of_the_file) {
  const Scratch scratch;
  const std::string path = scratch.write("history.csv", "time,F [kN],x\n-9999,1,-9999\n1,-9999,2\n2,3,-99\n");
  const io::Series series = io::read_series(path, {-9999, -99});
  BOOST_TEST(series.columns.at(0).front() == -9999.0);  // a time
  BOOST_TEST(std::isnan(series.columns.at(1).at(1)));
  BOOST_TEST(std::isnan(series.columns.at(2).front()));
  BOOST_TEST(std::isnan(series.columns.at(2).back()));
  BOOST_TEST(series.columns.at(1).back() == 3e3);
  BOOST_TEST(series.factors.at(1) == 1e3);
  BOOST_TEST(io::read_series(path).columns.at(1).at(1) == -9999e3);
}

BOOST_AUTO_TEST_CASE(binary_formats_are_named) {
  const Scratch scratch;
  BOOST_CHECK_EXCEPTION(io::read_series(scratch.write("tower.outb", "\x02")), InputError, [](const InputError& e) {
    return std::string(e.what()).find("OpenFAST's binary output") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(a_speed_in_the_first_column_is_no_time) {
  BOOST_TEST(!series_of("v_m/s,F_kN").time.has_value());
  BOOST_TEST(series_of("x_s,F_kN").time.value() == 0U);
}

BOOST_AUTO_TEST_CASE(units_under_the_names_may_be_quotients_and_products) {
  const io::Series read = series_of("time,v,M", "s,km/h,kN m\n");
  BOOST_TEST(read.units.at(1) == "m s-1");
  BOOST_TEST(read.columns.at(1).back() == 1000.0 / 3600.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(read.columns.at(2).back() == 1e3, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
