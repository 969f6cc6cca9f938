// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sched.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "brash/core/workers.hpp"

// Costs of sharing loops between threads, on a machine that other programs use too.
namespace brash::benchmarks {

using Clock = LoopRecord::Clock;

inline double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

/// Processor time of all threads of this program [s].
inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The sample that `share` of all lie below.
inline double quantile(std::vector<double> samples, double share) {
  const auto place = samples.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(samples.size()));
  std::nth_element(samples.begin(), place, samples.end());
  return *place;
}

inline double median(std::vector<double> samples) { return quantile(std::move(samples), 0.5); }

/// Seconds of `task()`, done `n_times` in a row.
template <typename Task>
double seconds_each(int n_times, Task&& task) {
  constexpr int kRows = 201;
  std::vector<double> rows;
  for (int row = 0; row < kRows; ++row) {
    const auto start = Clock::now();
    for (int i = 0; i < n_times; ++i) task();
    rows.push_back(seconds(Clock::now() - start) / n_times);
  }
  return median(rows);
}

/// By how much a record lengthens each chunk [s].
inline double clock_seconds() {
  constexpr std::size_t kChunks = 1000;
  LoopRecord record;
  record.moments.reserve(kChunks + 1);
  Workers workers(1);
  const auto of_chunk = [&] {
    return seconds_each(1,
                        [&] {
                          record.loops.clear();
                          record.moments.clear();
                          workers.each(kChunks, 1, [](std::size_t) {});
                        }) /
           kChunks;
  };
  const double without = of_chunk();
  workers.record(&record);
  return of_chunk() - without;
}

/// An exchange of a word that no other thread wants [s].
inline double near_seconds() {
  std::atomic<std::uint64_t> word{0};
  return seconds_each(1000, [&] {
    std::uint64_t now = word.load(std::memory_order_acquire);
    while (!word.compare_exchange_weak(now, now + 1, std::memory_order_acq_rel, std::memory_order_acquire)) {
    }
  });
}

/// An exchange of a word that another core exchanged last: two threads take turns [s].
inline double far_seconds() {
  constexpr std::uint64_t kEnd = ~std::uint64_t{0};
  alignas(64) std::atomic<std::uint64_t> word{0};
  const auto take = [&word](std::uint64_t turn) {  // false at the end
    std::uint64_t now = word.load(std::memory_order_acquire);
    while (now != turn && now != kEnd) now = word.load(std::memory_order_acquire);
    return word.compare_exchange_strong(turn, turn + 1, std::memory_order_acq_rel);
  };
  std::thread other([&] {
    for (std::uint64_t turn = 1; take(turn); turn += 2) {
    }
  });
  std::uint64_t turn = 0;
  const double both = seconds_each(1000, [&] {
    take(turn);
    turn += 2;
  });
  while (word.load() != turn) {
  }
  word.store(kEnd);
  other.join();
  return both / 2;
}

/// Times of one loop of two threads: from its call to the first chunk of the caller and of the other, and from the end
/// of the other's chunk to the end of the loop [s].
inline std::array<double, 3> loop_seconds(Workers& workers) {
  std::array<Clock::time_point, 2> began, ended;
  std::atomic<int> n_began{0};
  const auto call = Clock::now();
  workers.each(2, 1, [&](std::size_t chunk) {
    began[chunk] = Clock::now();
    n_began.fetch_add(1);
    while (n_began.load() < 2) {  // nobody takes both
    }
    const auto start = Clock::now();
    while (chunk == 1 && seconds(Clock::now() - start) < 1e-6) {  // the caller has looked at all shares
    }
    ended[chunk] = Clock::now();
  });
  return {seconds(began[0] - call), seconds(began[1] - call), seconds(Clock::now() - ended[1])};
}

/// Lets threads without work fall asleep, while this one stays awake at the end.
inline void let_others_sleep() {
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const auto start = Clock::now();
  while (seconds(Clock::now() - start) < 1e-4) {
  }
}

/// Medians of the times of a loop of two threads that are awake, or of which the other sleeps. A loop does not count if
/// the other thread had to wait for a core that another program has.
inline std::array<double, 3> median_loop_seconds(bool asleep) {
  const double disturbed = asleep ? 1e-4 : 1e-5;
  const std::size_t n_wanted = asleep ? 51 : 501;
  std::array<std::vector<double>, 3> samples;
  for (int round = 0; round < 200 && samples[0].size() < n_wanted; ++round) {
    Workers workers(2);
    let_others_sleep();
    for (int i = 0; i < (asleep ? 1 : 51); ++i) {
      const std::array<double, 3> times = loop_seconds(workers);
      if (times[1] > disturbed) continue;
      for (std::size_t k = 0; k < times.size(); ++k) samples[k].push_back(times[k]);
    }
  }
  if (samples[0].empty())
    throw std::runtime_error("two threads never ran at once; try on a machine with two idle cores");
  return {median(samples[0]), median(samples[1]), median(samples[2])};
}

/// An empty loop whose caller has to wake all other threads, and which they do not keep from its core [s].
inline double rousing_seconds(int threads) {
  sched_param none{};
  sched_setscheduler(0, SCHED_BATCH, &none);  // of new threads: they do not take a core as soon as they wake up
  Workers workers(threads);
  sched_setscheduler(0, SCHED_OTHER, &none);
  std::vector<double> samples;
  for (int i = 0; i < 51; ++i) {
    let_others_sleep();
    const auto call = Clock::now();
    workers.each(static_cast<std::size_t>(threads), 1, [](std::size_t) {});
    samples.push_back(seconds(Clock::now() - call));
  }
  return quantile(samples, 0.1);  // other programs disturb most of them
}

/// How long a thread without work looks for some before it sleeps: its processor time [s].
inline double awake_seconds() {
  Workers workers(2);
  const auto of_sleep = [&workers](std::size_t n_chunks) {
    std::vector<double> samples;
    for (int i = 0; i < 51; ++i) {
      workers.each(n_chunks, 1, [](std::size_t) {});
      const double start = processor_seconds();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      samples.push_back(processor_seconds() - start);
    }
    return median(samples);
  };
  return of_sleep(2) - of_sleep(0);
}

}  // namespace brash::benchmarks
