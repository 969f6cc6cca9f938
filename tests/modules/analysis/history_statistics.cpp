// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/history_statistics.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "brash/analysis/load_history.hpp"
#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/statistics/random.hpp"
#include "history_file.hpp"

namespace {

using namespace brash;
using namespace brash::analysis;
using boost::test_tools::tolerance;

/// An evenly sampled history without a file.
LoadHistory every(double dt, const std::vector<double>& samples) {
  LoadHistory load{"Fx", {{}, samples}, {}, 0};
  for (std::size_t i = 0; i < samples.size(); ++i) load.history.times.push_back(dt * static_cast<double>(i));
  load.even = statistics::make_even(load.history);
  return load;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(history_statistics)

BOOST_AUTO_TEST_CASE(a_noisy_wave_has_its_mean_frequency_and_peaks) {
  std::vector<double> samples;
  statistics::RandomStream noise(1, "stats", 0, "noise");
  for (int i = 0; i < 16000; ++i)
    samples.push_back(100.0 + 30.0 * std::sin(2.0 * kPi * 0.4 * 0.02 * i) + 0.01 * noise.normal());
  const auto s = statistics_of(every(0.02, samples));
  BOOST_TEST(s["duration"].get<double>() == 320.0, tolerance(1e-12));
  // 128 whole periods: the sine leaves the noise's error, 0.01 / sqrt(16000), times 4.
  BOOST_CHECK_SMALL(s["mean"].get<double>() - 100.0, 4e-4);
  BOOST_TEST(s["standard_deviation"].get<double>() == 30.0 / std::sqrt(2.0), tolerance(1e-4));
  BOOST_TEST(s["spectrum_peak"]["frequency"].get<double>() == 0.4, tolerance(1e-9));  // 16 periods in a segment of 40 s
  const auto peaks = s["peaks"]["count"].get<int>();
  // A wave crosses its mean 128 times; noise of 0.01 against a slope of 1.5 a step adds no crossing but at the ends.
  BOOST_TEST(std::abs(peaks - 127) <= 1);
  BOOST_TEST(contains(statistics_text(s), "highest spectrum at  0.4 Hz"));
}

BOOST_AUTO_TEST_CASE(a_short_history_says_what_it_cannot_tell) {
  const auto s = statistics_of(every(0.1, {1.0, 3.0, 2.0, 5.0}));
  BOOST_TEST(s["spectrum_peak"].is_null());
  BOOST_TEST(s["extremes"].contains("not_fitted"));
  BOOST_TEST(!s["long_enough"].get<bool>());
  BOOST_TEST(contains(statistics_text(s), "no level recommended: 0 load events in "));
  BOOST_TEST(s["mean_95"][0].is_null());
  BOOST_TEST(contains(statistics_text(s), "too few for an interval: give one of 2 s or more"));
}

/// A sawtooth of cycles of 1 s whose peaks are exponential above 100.
std::vector<double> sawtooth(int cycles) {
  std::vector<double> samples;
  statistics::RandomStream stream(1, "stats", 0, "peaks");
  for (int c = 0; c < cycles; ++c) {
    const double peak = 100.0 - 40.0 * std::log(1.0 - stream.uniform());
    for (int i = 1; i <= 20; ++i) samples.push_back(20.0 + (peak - 20.0) * i / 20);
  }
  return samples;
}

BOOST_AUTO_TEST_CASE(a_minute_gets_no_level_for_an_hour_and_says_so) {
  const auto s = statistics_of(every(0.05, sawtooth(60)));
  BOOST_TEST(s["recommended"]["law"].is_null());
  BOOST_TEST(s["extremes"].contains("not_fitted"));
  BOOST_TEST(contains(statistics_text(s), "no level recommended: the return period is 60"));
  StatisticsSettings century;
  century.extremes.return_period = 3.2e9;
  const auto long_asked = statistics_text(statistics_of(every(0.05, sawtooth(300)), century));
  BOOST_TEST(contains(long_asked, "times the record, and 30 times is the most"));
}

BOOST_AUTO_TEST_CASE(a_long_record_gets_one_recommended_level_with_its_reason) {
  const auto s = statistics_of(every(0.05, sawtooth(1000)));
  BOOST_TEST(s["recommended"]["law"].get<std::string>() == "GEV");
  BOOST_TEST(s["laws"].size() == 5U);
  const std::string text = statistics_text(s);
  BOOST_TEST(contains(text, "by GEV: "));
  BOOST_TEST(contains(text, "block maxima fit"));
}

BOOST_AUTO_TEST_CASE(equivalent_loads_tell_when_the_record_is_too_short_for_them) {
  StatisticsSettings settings;
  settings.exponents = {3.0, 10.0};
  const auto s = statistics_of(every(0.05, sawtooth(1000)), settings);
  BOOST_TEST_REQUIRE(s["fatigue"].size() == 2U);
  BOOST_TEST(s["fatigue"][1]["equivalent_load"].get<double>() > s["fatigue"][0]["equivalent_load"].get<double>());
  BOOST_TEST(contains(statistics_text(s),
                      "% of the damage in the long run is from cycles larger than any seen: the "
                      "upper end holds if their tail is exponential or lighter"));
  const auto few = statistics_of(every(0.05, sawtooth(20)), settings);
  BOOST_TEST(few["fatigue"][0]["equivalent_load_95"][0].is_null());
  BOOST_TEST(contains(statistics_text(few), "independent stretches are too few for an interval"));
}

BOOST_AUTO_TEST_CASE(stretches_of_an_uneven_record_are_cut_by_time) {
  // Cycles of 1 s with random peaks. The other record has four times the samples in the first half, between the same
  // corners.
  statistics::RandomStream stream(1, "stats", 0, "uneven");
  std::vector<double> samples;
  for (int cycle = 0; cycle < 400; ++cycle) {
    const double peak = -std::log(1.0 - stream.uniform());
    for (const double share : {0.25, 0.5, 0.75, 1.0, 0.83, 0.67, 0.5, 0.33, 0.17, 0.0}) samples.push_back(share * peak);
  }
  const LoadHistory even = every(0.1, samples);
  LoadHistory uneven{"Fx", {}, {}, 0};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (int part = i > 0 && i <= samples.size() / 2 ? 3 : 0; part >= 0; --part) {
      uneven.history.times.push_back(0.1 * static_cast<double>(i) - 0.025 * part);
      uneven.history.values.push_back(part == 0 ? samples[i]
                                                : samples[i] + 0.25 * part * (samples[i - 1] - samples[i]));
    }
  }
  uneven.even = statistics::make_even(uneven.history);
  BOOST_TEST_REQUIRE(!uneven.even.sampling.even);
  // Not a whole number of samples, so that rounding decides about none.
  const auto whole = fatigue_json({&even}, {3.0}, 9.99, 1.0)[0], parts = fatigue_json({&uneven}, {3.0}, 9.99, 1.0)[0];
  BOOST_TEST(parts["stretches"] == 40);
  BOOST_TEST(parts["stretches"] == whole["stretches"]);
  // The even record counts one step of 0.1 s more than it lasts, the uneven one its mean step of 0.04 s.
  const auto close = tolerance(1e-4);
  BOOST_TEST(parts["equivalent_load"].get<double>() == whole["equivalent_load"].get<double>(), close);
  BOOST_TEST(parts["equivalent_load_95"][0].get<double>() == whole["equivalent_load_95"][0].get<double>(), close);
}

BOOST_AUTO_TEST_CASE(a_history_is_filtered_and_resampled_with_its_gaps) {
  std::vector<double> samples;
  for (int i = 0; i < 2000; ++i)
    samples.push_back(std::sin(2.0 * kPi * 0.5 * 0.01 * i) + 0.5 * std::sin(2.0 * kPi * 20.0 * 0.01 * i));
  LoadHistory load = every(0.01, samples);
  for (std::size_t i = 1000; i < 2000; ++i) load.history.times[i] += 7.0;
  load.even = statistics::make_even(load.history);
  const LoadHistory slow = prepared(load, {.low_pass = 2.0, .step = 0.05, .phase = statistics::Phase::kZero});
  BOOST_TEST(slow.even.sampling.step == 0.05, tolerance(1e-12));
  BOOST_TEST(slow.even.sampling.gaps.size() == 1U);
  BOOST_TEST_REQUIRE(slow.history.values.size() == 400U);
  // The slow wave passes but for (0.5/2)^4/2, the fast one is a ten-thousandth.
  for (std::size_t i = 40; i < 160; ++i)
    BOOST_CHECK_SMALL(slow.history.values[i] - std::sin(2.0 * kPi * 0.5 * slow.history.times[i]), 5e-3);
  BOOST_CHECK_EXCEPTION(prepared(load, {.low_pass = 0.0, .step = 1e-9, .phase = statistics::Phase::kZero}), InputError,
                        [](const InputError& e) {
                          return contains(e.what(), "at most 134217728 samples, by a step of 1.49e-07 s or more");
                        });
  BOOST_CHECK_EXCEPTION(prepared(load, {.low_pass = 50.0, .step = 0.0, .phase = statistics::Phase::kZero}), InputError,
                        [](const InputError& e) { return contains(e.what(), "below half of the sampling frequency"); });
}

BOOST_AUTO_TEST_CASE(pieces_with_different_steps_are_resampled_each_in_its_time) {
  LoadHistory load{"Fx", {}, {}, 0};
  for (int i = 0; i < 6000; ++i) {
    const double time = i < 4000 ? 0.05 * i : 210.0 + 0.1 * (i - 4000);
    load.history.times.push_back(time);
    load.history.values.push_back(std::sin(2.0 * kPi * time));
  }
  load.even = statistics::make_even(load.history);
  BOOST_TEST(statistics_of(load)["spectrum_peak"]["frequency"].get<double>() == 1.0, tolerance(0.05));
  const LoadHistory slow = prepared(load, {.low_pass = 0.0, .step = 0.1, .phase = statistics::Phase::kZero});
  BOOST_TEST(slow.even.sampling.even);
  // Two pieces of 200 s; the last sample of a piece may be lost to the interpolation.
  BOOST_TEST(slow.history.values.size() >= 3998U);
  BOOST_TEST(slow.history.times[2000] == 210.0, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_filter_and_a_new_step_do_not_hide_a_clipped_sensor) {
  std::vector<double> samples = sawtooth(1000);
  for (double& value : samples) value = std::min(value, 180.0);
  const LoadHistory load = every(0.05, samples);
  for (const auto& [low_pass, step] : {std::pair(0.0, 0.0), std::pair(4.0, 0.0), std::pair(0.0, 0.1)}) {
    const auto s =
        statistics_of(prepared(load, {.low_pass = low_pass, .step = step, .phase = statistics::Phase::kZero}));
    BOOST_TEST(s["recommended"]["law"].is_null());
    BOOST_TEST(s["recommended"]["reason"] == "the largest loads are clipped");
    BOOST_TEST(contains(s["warnings"].dump(), "the sensor seems to clip"));
  }
}

BOOST_AUTO_TEST_CASE(an_event_of_a_run_has_its_cause_and_its_crack) {
  std::string text = "time,Fx,crushing_Fx,floe_normal_Fx\n";
  for (int i = 0; i < 200; ++i) {
    const double load = i % 20 < 10 ? 0.0 : 100.0 * (i % 20 - 9);
    text += std::to_string(0.1 * i) + "," + std::to_string(load) + "," + std::to_string(0.8 * load) + "," +
            std::to_string(0.2 * load) + "\n";
  }
  const TemporaryFile file(text);
  const auto folder = std::filesystem::path(file.path()).parent_path();
  std::ofstream(folder / "events.csv") << "time,x,y,event\n1.9,4,5,break\n1.0,0,0,break\n1.95,0,0,deleted\n";
  const CsvTable table = events_table(read_history(file.path(), {}), std::nullopt);
  const std::string first = table.lines.substr(0, table.lines.find('\n'));
  BOOST_TEST(first.ends_with(",crushing,1.9,4,5"), first);
}

BOOST_AUTO_TEST_CASE(an_event_of_a_load_below_zero_has_its_cause_too) {
  std::string text = "time,Fx,crushing_Fx,floe_normal_Fx,floe_friction_Fx\n";
  for (int i = 0; i < 200; ++i) {
    const double load = i % 20 < 10 ? 0.0 : -100.0 * (i % 20 - 9);
    text += fmt::format("{},{},{},{},{}\n", 0.1 * i, load, 0.8 * load, 0.3 * load, -0.1 * load);
  }
  const TemporaryFile file(text);
  HistoryChoice choice;
  choice.negate = true;
  for (const double step : {0.0, 0.1}) {
    const LoadHistory load =
        prepared(read_history(file.path(), choice), {.low_pass = 0.0, .step = step, .phase = statistics::Phase::kZero});
    const CsvTable table = events_table(load, std::nullopt);
    BOOST_TEST(contains(table.lines.substr(0, table.lines.find('\n')), ",crushing,"), table.lines);
  }
}

BOOST_AUTO_TEST_CASE(a_load_below_zero_has_its_peaks_with_the_other_sign) {
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
  HistoryChoice choice;
  const nlohmann::ordered_json of_up = statistics_of(read_history(up.path(), choice));
  const nlohmann::ordered_json plain = statistics_of(read_history(down.path(), choice));
  BOOST_TEST(!contains(of_up["warnings"].dump(), "the mean is negative"));
  BOOST_TEST(contains(plain["warnings"].dump(), "the mean is negative, and peaks are of the upper end"));
  BOOST_TEST(plain["quantile_99"].get<double>() > -30.0);

  // The other sign gives the same numbers.
  choice.negate = true;
  nlohmann::ordered_json turned = statistics_of(read_history(down.path(), choice));
  BOOST_TEST(turned["column"] == "-Fz");
  turned["column"] = "Fz";
  BOOST_TEST(turned == of_up);
}

BOOST_AUTO_TEST_CASE(a_start_that_is_no_number_is_refused) {
  HistoryChoice choice;
  choice.has_from = true;
  choice.from = std::nan("");
  BOOST_TEST(contains(complaint("0,1\n1,2\n2,3\n", choice), "--from nan is not a time"));
}

BOOST_AUTO_TEST_SUITE_END()
