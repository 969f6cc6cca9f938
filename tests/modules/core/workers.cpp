// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/workers.hpp"

#include <algorithm>
#include <atomic>
#include <boost/test/unit_test.hpp>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "brash/core/contract.hpp"

namespace {

using brash::Workers;

BOOST_AUTO_TEST_SUITE(workers)

BOOST_AUTO_TEST_CASE(every_item_of_many_loops_is_done_once) {
  for (const int n_workers : {1, 2, 3, 8}) {
    Workers workers(n_workers);
    for (const std::size_t n : {0, 1, 2, 7, 1000})
      for (const std::size_t chunk : {1, 3, 2000})
        for (int again = 0; again < 50; ++again) {
          std::vector<int> done(n, 0);
          workers.each(n, chunk, [&](std::size_t i) { ++done[i]; });
          BOOST_REQUIRE(done == std::vector<int>(n, 1));
        }
  }
}

BOOST_AUTO_TEST_CASE(chunks_have_their_size_and_workers_have_scratch_of_their_own) {
  for (const int n_workers : {1, 3}) {
    Workers workers(n_workers);
    std::vector<std::vector<std::size_t>> begins(static_cast<std::size_t>(n_workers));
    std::vector<std::size_t> ends(10, 0);
    workers.chunks(95, 10, [&](std::size_t begin, std::size_t end, int worker) {
      begins[static_cast<std::size_t>(worker)].push_back(begin);
      ends[begin / 10] = end;
    });
    std::set<std::size_t> all;
    for (const auto& of_worker : begins) all.insert(of_worker.begin(), of_worker.end());
    BOOST_TEST(all == (std::set<std::size_t>{0, 10, 20, 30, 40, 50, 60, 70, 80, 90}), boost::test_tools::per_element());
    BOOST_TEST(ends == (std::vector<std::size_t>{10, 20, 30, 40, 50, 60, 70, 80, 90, 95}),
               boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(a_loop_after_the_threads_have_fallen_asleep_is_done_too) {
  Workers workers(3);
  for (int i = 0; i < 5; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::vector<int> done(100, 0);
    workers.each(100, 1, [&](std::size_t k) { ++done[k]; });
    BOOST_TEST(std::accumulate(done.begin(), done.end(), 0) == 100);
  }
}

BOOST_AUTO_TEST_CASE(a_loop_wakes_as_many_threads_as_it_has_chunks) {
  Workers workers(5);
  for (int again = 0; again < 40; ++again)
    for (const std::size_t n : {2, 4, 3, 5}) {
      // Some or all threads sleep, and some sleep through the loop.
      if (again % 2 == 0) std::this_thread::sleep_for(std::chrono::microseconds(20 * again));
      std::atomic<std::size_t> n_began{0};
      workers.each(n, 1, [&](std::size_t) {
        ++n_began;
        while (n_began < n) std::this_thread::yield();  // each chunk has a thread of its own
      });
      BOOST_REQUIRE(n_began == n);
    }
}

BOOST_AUTO_TEST_CASE(the_error_of_the_earliest_item_is_thrown_and_all_others_are_done) {
  for (const int n_workers : {1, 2, 8}) {
    Workers workers(n_workers);
    for (int again = 0; again < 20; ++again) {
      std::vector<int> done(100, 0);
      const auto task = [&](std::size_t i) {
        if (i % 30 == 17) throw std::runtime_error(std::to_string(i));
        ++done[i];
      };
      BOOST_CHECK_EXCEPTION(workers.each(100, 1, task), std::runtime_error,
                            [](const std::runtime_error& e) { return std::string(e.what()) == "17"; });
      BOOST_TEST(std::accumulate(done.begin(), done.end(), 0) == 97);
    }
    std::vector<int> after(10, 0);
    workers.each(10, 1, [&](std::size_t i) { after[i] = 1; });
    BOOST_TEST(std::accumulate(after.begin(), after.end(), 0) == 10);
  }
}

BOOST_AUTO_TEST_CASE(one_worker_is_the_thread_that_calls) {
  Workers workers(1);
  std::set<std::thread::id> threads;
  workers.each(100, 1, [&](std::size_t) { threads.insert(std::this_thread::get_id()); });
  BOOST_TEST((threads == std::set<std::thread::id>{std::this_thread::get_id()}));
}

BOOST_AUTO_TEST_CASE(a_record_has_the_loops_in_their_order_and_a_moment_around_each_chunk) {
  Workers workers(1);
  brash::LoopRecord record;
  std::vector<brash::LoopRecord::Clock::time_point> within;
  const auto task = [&](std::size_t) { within.push_back(brash::LoopRecord::Clock::now()); };
  const auto shares_out_too = [&] { workers.each(1, 4, task); };
  workers.each(3, 1, task);  // before the record
  within.clear();
  workers.record(&record);
  workers.each(9, 4, [&](std::size_t i) { i % 4 == 0 ? task(i) : void(); });
  workers.each(0, 4, task);  // no loop
  shares_out_too();
  BOOST_CHECK_THROW(workers.chunks(2, 1, [](auto...) { throw std::runtime_error("both"); }), std::runtime_error);
  workers.record(nullptr);
  workers.each(3, 1, task);

  BOOST_REQUIRE(record.loops.size() == 3);
  const std::string here = __func__;
  BOOST_TEST((record.loops[0].caller == here && record.loops[1].caller != here && record.loops[2].caller == here));
  BOOST_TEST((record.loops[0].n_chunks == 3 && record.loops[1].n_chunks == 1 && record.loops[2].n_chunks == 2));
  const auto& moments = record.moments;
  BOOST_REQUIRE(moments.size() == 4 + 2 + 3);
  BOOST_TEST(std::is_sorted(moments.begin(), moments.end()));
  for (const std::size_t chunk : {0, 1, 2})
    BOOST_TEST((moments[chunk] <= within[chunk] && within[chunk] <= moments[chunk + 1]));
  BOOST_TEST((moments[4] <= within[3] && within[3] <= moments[5]));
}

BOOST_AUTO_TEST_CASE(loops_of_several_threads_are_not_recorded) {
  brash::LoopRecord record;
  Workers workers(2);
  BOOST_CHECK_THROW(workers.record(&record), brash::ContractViolation);
}

BOOST_AUTO_TEST_CASE(loops_within_loops_and_no_worker_are_broken_contracts) {
  BOOST_CHECK_THROW(Workers(0), brash::ContractViolation);
  for (const int n_workers : {1, 2}) {
    Workers workers(n_workers);
    const auto inner = [](std::size_t) {};
    const auto outer = [&](std::size_t) { workers.each(2, 1, inner); };
    BOOST_CHECK_THROW(workers.each(2, 1, outer), brash::ContractViolation);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
