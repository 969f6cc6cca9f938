// SPDX-License-Identifier: GPL-3.0-or-later
#include "schedule.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <random>

#include "scratch.hpp"

using namespace brash;
using namespace brash::campaign;

namespace {

/// A plan of settings named s0, s1, ... with a stop rule on the column `x`.
io::CampaignPlan plan_with_rule(std::size_t n_settings, double half_width) {
  io::CampaignPlan plan;
  plan.replicates = 3;
  plan.stop = {"x", half_width, 0.95, 20, 4};
  for (std::size_t i = 0; i < n_settings; ++i) {
    plan.settings.emplace_back();
    plan.settings.back().name = "s" + std::to_string(i);
  }
  return plan;
}

/// The value that a replicate would have, whenever it runs.
double value_of(const CaseKey& key) {
  std::mt19937 numbers(static_cast<unsigned>(1000 * key.setting + static_cast<std::size_t>(key.replicate)));
  return 10.0 + 0.001 * static_cast<double>(numbers() % 5000);
}

void finish(const Folder& folder, const CaseKey& key) {
  std::filesystem::create_directories(folder.case_folder(key));
  std::ofstream(folder.case_folder(key) + "/summary.json") << "{\"x\": " << value_of(key) << "}";
}

/// Runs all cases of `schedule`, up to `n_at_once` handed out at a time and finished in random order.
void run(Schedule& schedule, const Folder& folder, std::size_t n_at_once, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<CaseKey> running;
  while (true) {
    while (running.size() < n_at_once) {
      const auto key = schedule.next();
      if (!key) break;
      running.push_back(*key);
    }
    if (running.empty()) return;
    const auto ended = running.begin() + static_cast<std::ptrdiff_t>(random() % running.size());
    finish(folder, *ended);
    schedule.look_at(*ended);
    running.erase(ended);
  }
}

std::vector<std::string> ids(const Schedule& schedule, const Folder& folder) {
  std::vector<std::string> all;
  for (const auto& [key, state] : schedule.cases()) all.push_back(folder.id(key));
  return all;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(schedule)

BOOST_AUTO_TEST_CASE(replicates_that_coincide_count_once_and_fulfil_no_stop_rule) {
  io::CampaignPlan plan = plan_with_rule(1, 0.04);
  const Scratch scratch;
  const Folder folder(plan, scratch.folder().string());
  Schedule schedule(plan, folder);
  while (const auto key = schedule.next()) {
    std::filesystem::create_directories(folder.case_folder(*key));
    std::ofstream(folder.case_folder(*key) + "/summary.json") << "{\"x\": 10.5, \"y\": 2}";
    schedule.look_at(*key);
  }
  BOOST_TEST(schedule.counts().n_done == plan.stop->most_replicates);
  BOOST_TEST(!schedule.is_narrow_enough(0));
  // The same statistic of other runs is another value.
  for (int i = 1; i < 3; ++i)
    std::ofstream(folder.case_folder({0, i}) + "/summary.json") << "{\"x\": 10.5, \"y\": " << 2 + i << "}";
  BOOST_TEST(Schedule(plan, folder).is_narrow_enough(0));
}

BOOST_AUTO_TEST_CASE(the_replicates_of_a_stop_rule_do_not_depend_on_who_finishes_when) {
  const io::CampaignPlan plan = plan_with_rule(6, 0.04);
  std::vector<std::vector<std::string>> outcomes;
  for (const auto& [n_at_once, seed] : {std::pair{1u, 1u}, {2u, 2u}, {7u, 3u}, {50u, 4u}}) {
    const Scratch scratch;
    const Folder folder(plan, scratch.folder().string());
    Schedule schedule(plan, folder);
    run(schedule, folder, n_at_once, seed);
    BOOST_TEST(schedule.counts().n_missing() == 0);
    outcomes.push_back(ids(schedule, folder));
    // Who looks at the folder afterwards sees the same campaign.
    BOOST_TEST(ids(Schedule(plan, folder), folder) == outcomes.back(), boost::test_tools::per_element());
  }
  for (const auto& outcome : outcomes) BOOST_TEST(outcome == outcomes.front(), boost::test_tools::per_element());
  // The rule acts: some settings need more than the least number, and fewer than all.
  BOOST_TEST(outcomes.front().size() > 6u * 3u);
  BOOST_TEST(outcomes.front().size() < 6u * 20u);
}

BOOST_AUTO_TEST_CASE(replicates_come_in_batches_up_to_the_most) {
  const io::CampaignPlan plan = plan_with_rule(1, 1e-9);
  const Scratch scratch;
  const Folder folder(plan, scratch.folder().string());
  Schedule schedule(plan, folder);
  BOOST_TEST(schedule.counts().n_cases == 3);
  for (int i = 0; i < 3; ++i) {
    const CaseKey key = *schedule.next();
    finish(folder, key);
    schedule.look_at(key);
  }
  BOOST_TEST(schedule.counts().n_cases == 7);
  run(schedule, folder, 2, 1);
  BOOST_TEST(schedule.counts().n_cases == 20);
  BOOST_TEST(!schedule.is_narrow_enough(0));
}

BOOST_AUTO_TEST_CASE(a_rule_about_a_number_that_no_case_has_adds_none) {
  io::CampaignPlan plan = plan_with_rule(1, 0.1);
  plan.stop->statistic = "y";
  const Scratch scratch;
  const Folder folder(plan, scratch.folder().string());
  Schedule schedule(plan, folder);
  run(schedule, folder, 2, 1);
  BOOST_TEST(schedule.counts().n_cases == 3);
  BOOST_TEST(!schedule.has_statistic(0));
}

BOOST_AUTO_TEST_CASE(failed_replicates_count_as_there_and_not_in_the_mean) {
  const io::CampaignPlan plan = plan_with_rule(1, 10.0);
  const Scratch scratch;
  const Folder folder(plan, scratch.folder().string());
  std::filesystem::create_directories(scratch.path("cases"));
  for (int i = 0; i < 2; ++i) std::ofstream(folder.failure_record({0, i})) << "{}";
  finish(folder, {0, 2});
  // One value has no interval, so a batch is added.
  Schedule schedule(plan, folder);
  BOOST_CHECK(schedule.counts() == (Counts{.n_cases = 7, .n_done = 1, .n_failed = 2}));
  BOOST_TEST(schedule.next()->replicate == 3);
}

BOOST_AUTO_TEST_CASE(the_rule_compares_the_half_width_of_students_interval_with_the_mean) {
  // Mean 10, deviation 1, n = 4: half-width t(0.975, 3) / sqrt(4) = 3.182446 / 2.
  const std::vector<double> values{10.0 - std::sqrt(1.5), 10.0, 10.0, 10.0 + std::sqrt(1.5)};
  io::StopRule rule{"x", 0.1591224, 0.95, 9, 1};
  BOOST_TEST(is_narrow(rule, values));
  rule.half_width = 0.1591222;
  BOOST_TEST(!is_narrow(rule, values));
  BOOST_TEST(!is_narrow(rule, std::vector<double>{10.0}));
}

BOOST_AUTO_TEST_SUITE_END()
