// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/edge/verdicts.hpp"

#include <boost/test/unit_test.hpp>

#include "brash/io/case.hpp"
#include "brash/simulation/run.hpp"

namespace {

using namespace brash;
using edge::EdgeContact;
using edge::Verdicts;
using Verdict = edge::EdgeContact::Verdict;

/// A contact at (0, y) whose sheet was solved.
edge::EdgeContact solved(double y, double overload, edge::Pressing pressing, std::int64_t floe = model::kNoFloe) {
  edge::EdgeContact result;
  result.floe = floe;
  result.touched = {{0.0, y}, 1.0};
  result.pressing = pressing;
  result.assessment = {.sigma_max = 1e5 * overload, .breaking_length = 3.0, .overload = overload};
  result.assessment.solves.coarse = 1;
  return result;
}

/// The same contact, loaded anew.
edge::EdgeContact asked(double y, edge::Pressing pressing, std::int64_t floe = model::kNoFloe) {
  edge::EdgeContact result = solved(y, 0.0, pressing, floe);
  result.assessment = {};
  return result;
}

edge::EdgeContact recalled(const edge::Verdicts& verdicts, double now, edge::EdgeContact contact) {
  std::vector<edge::EdgeContact> contacts{std::move(contact)};
  verdicts.recall(now, contacts);
  return contacts.front();
}

BOOST_AUTO_TEST_CASE(the_overload_grows_with_the_loads_of_the_structure) {
  edge::Verdicts verdicts(0.0);
  verdicts.keep(0.0, {solved(0.0, 0.6, {80.0, 20.0}), solved(9.0, 0.9, {100.0, 0.0}), solved(20.0, 1.2, {1.0, 0.0})});
  const auto growth = verdicts.most_overloaded(
      {asked(0.1, {180.0, 0.0}), asked(9.0, {110.0, 0.0}), asked(20.0, {9.0, 0.0}), asked(40.0, {9.0, 0.0})});
  BOOST_REQUIRE(growth.has_value());
  BOOST_TEST(growth->before == 0.6);
  BOOST_TEST(growth->now == 0.6 * 200.0 / 100.0, boost::test_tools::tolerance(1e-12));  // floes press as before
  BOOST_TEST(!verdicts.most_overloaded({asked(20.0, {9.0, 0.0})}).has_value());         // it held above 1
  verdicts.forget_within(0, {0.0, 9.0}, 1.0, 1.0);
  BOOST_TEST(!verdicts.most_overloaded({asked(9.0, {110.0, 0.0})}).has_value());
}

BOOST_AUTO_TEST_CASE(a_verdict_is_kept_while_the_ice_is_far_from_breaking) {
  edge::Verdicts verdicts(0.2);
  verdicts.keep(1.0, {solved(0.0, 0.3, {100.0, 0.0}), solved(9.0, 0.5, {100.0, 0.0}, 7)});
  const edge::EdgeContact kept = recalled(verdicts, 1.1, asked(0.0, {110.0, 0.0}));
  BOOST_TEST((kept.kept == Verdict::kKept));
  BOOST_TEST(kept.assessment.sigma_max == 0.33e5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(kept.assessment.breaking_length == 3.0);
  const auto is_solved = [&](double now, const edge::EdgeContact& contact) {
    return recalled(verdicts, now, contact).kept == Verdict::kSolved;
  };
  BOOST_TEST(is_solved(1.2, asked(0.0, {100.0, 0.0})));       // T is over
  BOOST_TEST(!is_solved(1.17, asked(9.0, {100.0, 0.0}, 7)));  // 0.5 (1.1 + 0.85) < 1
  BOOST_TEST(is_solved(1.19, asked(9.0, {100.0, 0.0}, 7)));   // 0.5 (1.1 + 0.95) > 1
  BOOST_TEST(is_solved(1.03, asked(9.0, {100.0, 0.0}, 8)));   // another floe
  BOOST_TEST(is_solved(1.1, asked(0.0, {201.0, 0.0})));       // loads have jumped
  BOOST_TEST(is_solved(1.1, asked(0.0, {100.0, 101.0})));     // a floe has come
  edge::EdgeContact young = asked(0.0, {100.0, 0.0});
  young.edge_age = 0.3;
  BOOST_TEST(!is_solved(1.14, young));  // 0.3 (1.1 + 0.93) < 1
  BOOST_TEST(is_solved(1.16, young));   // half its age is over
  edge::EdgeContact longer = asked(0.0, {100.0, 0.0});
  longer.touched.length = 1.5;
  BOOST_TEST(is_solved(1.1, longer));
  BOOST_TEST((recalled(edge::Verdicts(0.0), 1.1, asked(0.0, {100.0, 0.0})).kept == Verdict::kSolved));
  verdicts.forget_within(0, {0.0, -3.0}, 1.0, 5.0);  // the ice has broken nearby
  BOOST_TEST(is_solved(1.1, asked(0.0, {100.0, 0.0})));
  BOOST_TEST(verdicts.most_overloaded({asked(0.0, {110.0, 0.0})}).has_value());  // its load still predicts
}

/// A floe lifts the ice and another presses it down. Together they bend it little, until one of them goes.
BOOST_AUTO_TEST_CASE(the_ice_is_not_far_from_breaking_where_loads_oppose_each_other) {
  edge::Verdicts verdicts(0.2);
  verdicts.keep(1.0, {solved(0.0, 0.5, {0.0, 60.0, 36.0, 24.0}, 7)});  // 12 are left
  const auto is_kept = [&](double up, double down) {
    return recalled(verdicts, 1.02, asked(0.0, {0.0, up + down, up, down}, 7)).kept == Verdict::kKept;
  };
  BOOST_TEST(is_kept(36.0, 24.0));
  BOOST_TEST(is_kept(38.0, 22.0));   // 0.5 (16 / 12) (1.1 + 0.1) < 1
  BOOST_TEST(!is_kept(45.0, 24.0));  // 0.5 (21 / 12) (1.1 + 0.1) > 1
  BOOST_TEST(!is_kept(23.0, 36.0));  // bent the other way
}

BOOST_AUTO_TEST_CASE(a_control_counts_a_failure_that_came_late) {
  edge::Verdicts verdicts(0.2);
  const std::int64_t floe = 16;  // 0 + 16 + 1 is a multiple of 17
  verdicts.keep(0.0, {solved(0.0, 0.3, {100.0, 0.0}, floe)});
  edge::EdgeContact control = recalled(verdicts, 0.05, asked(0.0, {100.0, 0.0}, floe));
  BOOST_REQUIRE((control.kept == Verdict::kControl));
  control.control.fails = true;
  model::KeptCounts counts = verdicts.keep(0.05, {control});
  BOOST_TEST(counts.kept == 1);
  BOOST_TEST(counts.controls == 1);
  BOOST_TEST(counts.late == 0);
  counts = verdicts.keep(0.2, {solved(0.0, 1.3, {100.0, 0.0}, floe)});
  BOOST_TEST(counts.late == 1);
  BOOST_TEST(counts.latest == 0.15, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(verdicts_go_into_a_checkpoint) {
  edge::Verdicts verdicts(0.2), restored(0.2);
  verdicts.keep(1.0, {solved(0.0, 0.3, {100.0, 0.0}), solved(5.0, 0.4, {50.0, 5.0}, 16)});
  verdicts.forget_within(0, {0.0, 5.0}, 0.1, 0.1);
  model::Checkpoint checkpoint;
  verdicts.save(checkpoint);
  restored.restore(checkpoint);
  const edge::EdgeContact kept = recalled(restored, 1.05, asked(0.0, {90.0, 0.0}));
  BOOST_TEST((kept.kept == Verdict::kKept));
  BOOST_TEST(kept.assessment.sigma_max == 0.27e5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST((recalled(restored, 1.05, asked(5.0, {50.0, 5.0}, 16)).kept == Verdict::kSolved));
}

/// A step of 24 mm let the first break of the cone come at 1.5 times its load.
BOOST_AUTO_TEST_CASE(ice_breaks_within_a_long_step_when_it_should) {
  const model::Case c = io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml",
                                      {"algorithm.preset=brash", "time.step=0.04", "time.duration=1.2"});
  const simulation::Run run = simulation::run(c);
  BOOST_REQUIRE(!run.results.events.empty());
  BOOST_TEST(run.results.events.front().substeps > 1);
  BOOST_TEST(run.results.events.front().overload < 1.1);
}

}  // namespace
