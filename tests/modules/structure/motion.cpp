// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/motion.hpp"

#include <boost/test/unit_test.hpp>

namespace {

using namespace brash;

std::unique_ptr<structure::Motion> towed() {
  return structure::make_motion({.shape = {}, .motion = model::Towed{1.5}, .start_distance = 7.0}, 0.01);
}

BOOST_AUTO_TEST_SUITE(motion)

BOOST_AUTO_TEST_CASE(a_towed_structure_goes_on_at_its_speed_whatever_the_load) {
  const auto motion = towed();
  BOOST_TEST(motion->now().pose.position.x == -7.0);
  BOOST_TEST(motion->course().x == 1.5);
  for (int i = 0; i < 100; ++i) {
    motion->advance(1.0);
    motion->bear({{-1e9, 1e9, 1e9}, {1e9, 0.0, 0.0}});
  }
  BOOST_TEST(motion->now().pose.position.x == -5.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST((motion->now().twist == Twist{{1.5, 0.0, 0.0}, {}}));
}

BOOST_AUTO_TEST_CASE(looking_ahead_moves_nothing_and_parts_of_a_step_make_it_whole) {
  const auto motion = towed();
  const Pose start = motion->now().pose;
  BOOST_TEST(motion->after(0.5).pose.position.x == -6.9925);
  BOOST_TEST((motion->now().pose == start));
  motion->advance(0.25);
  motion->advance(0.75);
  BOOST_TEST(motion->now().pose.position.x == -6.985, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(a_motion_goes_on_from_a_checkpoint) {
  const auto motion = towed(), again = towed();
  motion->advance(1.0);
  model::Checkpoint saved;
  motion->save(saved);
  again->restore(saved);
  BOOST_TEST((again->now().pose == motion->now().pose));
  BOOST_TEST((again->now().twist == motion->now().twist));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
