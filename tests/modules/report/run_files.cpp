// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "brash/report/report.hpp"
#include "brash/statistics/random.hpp"
#include "history_file.hpp"

namespace {

using namespace brash;
using analysis::TemporaryFile;

BOOST_AUTO_TEST_CASE(a_measured_load_below_zero_has_its_peaks_at_the_lower_end) {
  const auto sawtooth = [](const char* sign) {
    statistics::RandomStream stream(1, "stats", 0, "peaks");
    std::string text = "time,Fz\n";
    double peak = 0.0;
    for (int i = 0; i < 8000; ++i) {
      if (i % 20 == 0) peak = 80.0 - 40.0 * std::log(1.0 - stream.uniform());
      text += fmt::format("{},{}{}\n", 0.05 * i, sign, 20.0 + peak * (i % 20 + 1) / 20.0);
    }
    return text;
  };
  const TemporaryFile up(sawtooth("")), down(sawtooth("-"), "down.csv");
  const auto reported = [](const TemporaryFile& file) {
    return nlohmann::ordered_json::parse(report::measured_history(file.path(), {}).statistics);
  };
  const nlohmann::ordered_json high = reported(up), low = reported(down);
  BOOST_TEST(high["lower_end"] == false);
  BOOST_TEST(low["lower_end"] == true);
  BOOST_TEST(low["column"] == "Fz");
  for (const char* key : {"mean", "quantile_95", "quantile_99", "skewness"})
    BOOST_TEST(low[key].get<double>() == -high[key].get<double>());
  BOOST_TEST(low["minimum"].get<double>() == -high["maximum"].get<double>());
  BOOST_TEST(low["mean_95"][0].get<double>() == -high["mean_95"][1].get<double>());
  BOOST_TEST_REQUIRE(high["recommended"].contains("level"));
  BOOST_TEST(low["recommended"]["level"].get<double>() == -high["recommended"]["level"].get<double>());
  BOOST_TEST(low["recommended"]["level_95"][0].get<double>() == -high["recommended"]["level_95"][1].get<double>());
  BOOST_TEST_REQUIRE(low["events"].size() == high["events"].size());
  BOOST_TEST(low["events"].size() > 300U);
  for (std::size_t i = 0; i < low["events"].size(); ++i)
    for (const char* key : {"peak", "impulse"})
      BOOST_TEST(low["events"][i][key].get<double>() == -high["events"][i][key].get<double>());
}

}  // namespace
