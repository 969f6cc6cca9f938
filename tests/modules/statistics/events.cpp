// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/events.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "brash/core/contract.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/random.hpp"

namespace {

using namespace brash::statistics;
using boost::test_tools::tolerance;
using Samples = std::vector<double>;

/// A history sampled every second.
History every_second(const Samples& values) {
  History history{{}, values};
  for (std::size_t i = 0; i < values.size(); ++i) history.times.push_back(static_cast<double>(i));
  return history;
}

std::vector<LoadEvent> events_of(const History& history, const EventLevels& levels) {
  return load_events(history, make_even(history), levels);
}

/// A wave of 0.4 Hz and amplitude 40 for 50 s, 50 samples a second, with white noise.
History noisy_wave(double noise) {
  RandomStream stream(1, "events", 0, "noise");
  History history;
  for (int i = 0; i < 2500; ++i) {
    history.times.push_back(0.02 * i);
    history.values.push_back(110.0 + 40.0 * std::sin(2.0 * std::numbers::pi * 0.4 * 0.02 * i) +
                             noise * stream.normal());
  }
  return history;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(events)

BOOST_AUTO_TEST_CASE(an_event_has_its_start_end_peak_and_impulse) {
  const History history = every_second({0.0, 2.0, 6.0, 2.0, 0.0, 0.0});
  const auto events = events_of(history, {1.0, 1.0, 1.0});
  BOOST_TEST_REQUIRE(events.size() == 1U);
  BOOST_TEST(events[0].start == 0.5);
  BOOST_TEST(events[0].end == 3.5);
  BOOST_TEST(events[0].peak == 6.0);
  BOOST_TEST(events[0].peak_time == 2.0);
  BOOST_TEST(events[0].rise() == 1.5);
  BOOST_TEST(events[0].fall() == 1.5);
  // Trapezoids: half a second from 1 to 2 twice, a second from 2 to 6 twice.
  BOOST_TEST(events[0].impulse == 2 * 0.75 + 2 * 4.0, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_dead_band_joins_crossings_of_noise) {
  const History history = every_second({0, 5, 9, 4, 6, 8, 4, 0, 0, 7, 0});
  BOOST_TEST(events_of(history, {5.0, 5.0, 5.0}).size() == 3U);
  const auto events = events_of(history, {5.0, 6.5, 3.5});
  BOOST_TEST_REQUIRE(events.size() == 2U);
  BOOST_TEST(events[0].peak == 9.0);
  BOOST_TEST(events[1].peak == 7.0);
}

BOOST_AUTO_TEST_CASE(events_at_the_ends_and_in_gaps_are_left_out) {
  BOOST_TEST(events_of(every_second({9, 0, 0, 0, 9, 9}), {1.0, 1.0, 1.0}).empty());
  History history = every_second({0, 9, 9, 9, 0, 0, 9, 0});
  history.times = {0, 1, 2, 30, 31, 32, 33, 34};  // the first event is cut
  const auto events = events_of(history, {1.0, 1.0, 1.0});
  BOOST_TEST_REQUIRE(events.size() == 1U);
  BOOST_TEST(events[0].peak_index == 6U);
}

BOOST_AUTO_TEST_CASE(the_noise_floor_of_a_wave_is_the_deviation_of_its_noise) {
  for (const double noise : {0.5, 5.0, 25.0}) {
    const History history = noisy_wave(noise);
    // 2500 second differences tell the median to about 3 %.
    BOOST_TEST(noise_floor(make_even(history).pieces(history)) == noise, tolerance(0.1));
  }
  const Samples ramp{0, 1, 2, 3, 4, 5};
  BOOST_TEST(noise_floor({ramp}) == 0.0);
}

BOOST_AUTO_TEST_CASE(a_noisy_wave_has_as_many_events_as_periods) {
  for (const double noise : {0.0, 0.5, 5.0, 25.0}) {
    const History history = noisy_wave(noise);
    const EvenHistory even = make_even(history);
    const double mean = moments(history.values).mean;
    const auto counted = load_events(history, even, event_levels(history, even, mean)).size();
    // 20 periods; strong noise may split one, and the record's ends may cut one.
    BOOST_TEST(std::abs(static_cast<int>(counted) - 20) <= 2, noise << " noise: " << counted << " events");
  }
}

BOOST_AUTO_TEST_CASE(a_wide_dead_band_stays_within_the_record) {
  const History history = every_second({0, 9, 0, 9, 0, 9, 0});
  const EventLevels levels = event_levels(history, make_even(history), 4.0, 1e3);
  BOOST_TEST(levels.upper == 6.5);
  BOOST_TEST(levels.lower == 2.0);
  BOOST_TEST(events_of(history, levels).size() == 3U);
}

bool is_clipped(const Samples& values) {
  const History history = every_second(values);
  return clipping(history, make_even(history)).has_value();
}

BOOST_AUTO_TEST_CASE(a_sensor_at_its_limit_is_noticed) {
  BOOST_TEST(!is_clipped({0, 5, 9, 9, 5, 0, 8, 0}));
  BOOST_TEST(!is_clipped({3, 3, 3, 3, 3, 3}));
  BOOST_TEST(!is_clipped({-1, 0, 0, 0, 0, 0, 0, -2}));
  const History twice = every_second({0, 5, 9, 9, 5, 0, 9, 9, 0}), once = every_second({0, 9, 9, 9, 9, 9, 0});
  BOOST_TEST(clipping(twice, make_even(twice)).value().samples == 4U);
  BOOST_TEST(clipping(once, make_even(once)).value().value == 9.0);
}

/// Waves of 2 s with random amplitudes, 200 samples a second, in whole units and cut at a limit.
Samples rounded_waves(double limit, std::uint64_t replicate) {
  RandomStream stream(1, "events", replicate, "amplitudes");
  Samples values;
  double amplitude = 0.0;
  for (int i = 0; i < 80'000; ++i) {
    if (i % 400 == 0) amplitude = 100.0 + 20.0 * stream.normal();
    values.push_back(std::round(std::min(limit, amplitude * std::sin(std::numbers::pi * 0.005 * i))));
  }
  return values;
}

BOOST_AUTO_TEST_CASE(the_flat_tops_of_rounded_waves_are_no_limit) {
  int cut = 0;
  for (std::uint64_t replicate = 0; replicate < 20; ++replicate) {
    BOOST_TEST(!is_clipped(rounded_waves(1e9, replicate)));
    cut += is_clipped(rounded_waves(120.0, replicate)) ? 1 : 0;
  }
  BOOST_TEST(cut == 20);  // one deviation above the mean cuts a sixth of the waves
}

BOOST_AUTO_TEST_SUITE_END()
