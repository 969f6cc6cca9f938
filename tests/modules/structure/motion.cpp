// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/motion.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/error.hpp"

namespace {

using namespace brash;

std::unique_ptr<structure::Motion> motion_of(const model::Motion& motion, double time_step = 0.01) {
  static const auto hull = structure::make_hull(model::Cone{1.0, 10.0, 8.0, 5.0});
  model::Case resolved;
  resolved.structure = {.shape = {}, .motion = motion, .start_distance = 7.0};
  resolved.time.step = time_step;
  return structure::make_motion(resolved, *hull);
}

std::unique_ptr<structure::Motion> towed() { return motion_of(model::Towed{1.5}); }

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

/// 2e6 kg on 8e6 N/m: 2 rad/s; its foot goes at 0.5 m/s.
std::unique_ptr<structure::Motion> compliant(double damping, double time_step) {
  return motion_of(model::Compliant{0.5, 2e6, 8e6, damping}, time_step);
}

/// Where the foot is.
double foot_at(double time) { return -7.0 + 0.5 * time; }

BOOST_AUTO_TEST_CASE(a_compliant_structure_under_a_load_that_jumps_moves_as_the_oscillator_does) {
  // q = F/k (1 - e^(-a t) (cos wd t + a/wd sin wd t)); below, at and above critical damping, in steps of any length.
  const double omega = 2.0, rest = -1e6 / 8e6;
  for (const double ratio : {0.0, 0.05, 1.0, 2.0}) {
    for (const double dt : {0.01, 0.5}) {
      const auto motion = compliant(ratio * 2.0 * omega * 2e6, dt);
      motion->bear({{-1e6, 0.0, 0.0}, {}});
      for (int i = 1; i <= static_cast<int>(6.0 / dt); ++i) {
        motion->advance(1.0);
        motion->bear({{-1e6, 0.0, 0.0}, {}});
        const double t = i * dt, a = ratio * omega, wd = omega * std::sqrt(std::abs(1.0 - ratio * ratio));
        const double shape = ratio < 1.0   ? std::cos(wd * t) + a / wd * std::sin(wd * t)
                             : ratio > 1.0 ? std::cosh(wd * t) + a / wd * std::sinh(wd * t)
                                           : 1.0 + a * t;
        const double exact = rest * (1.0 - std::exp(-a * t) * shape);
        BOOST_TEST(std::abs(motion->now().pose.position.x - foot_at(t) - exact) < 1e-12);
      }
      BOOST_TEST(motion->now().pose.position.y == 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_heavily_overdamped_compliant_structure_creeps_to_its_rest) {
  // With rates r = a - f and R = a + f, r R = k/m: q = F/k (1 - (R e^(-r t) - r e^(-R t)) / (R - r)). The hyperbolic
  // functions of f dt overflow from f dt = 710 on.
  const double mass = 1e3, stiffness = 1e8, load = -1e6, dt = 0.01;
  for (const double damping : {1e7, 2e8, 1e15}) {
    const auto motion = motion_of(model::Compliant{0.5, mass, stiffness, damping}, dt);
    motion->bear({{load, 0.0, 0.0}, {}});
    for (int i = 1; i <= 600; ++i) {
      motion->advance(1.0);
      motion->bear({{load, 0.0, 0.0}, {}});
      const double t = i * dt, a = 0.5 * damping / mass, f = std::sqrt(a * a - stiffness / mass);
      const double fast = a + f, slow = stiffness / mass / fast;
      const double crept = (slow * std::expm1(-fast * t) - fast * std::expm1(-slow * t)) / (fast - slow);
      BOOST_TEST(std::abs(motion->now().pose.position.x - foot_at(t) - load / stiffness * crept) < 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_compliant_structure_sways_on_its_own_and_goes_on_from_a_checkpoint) {
  const auto motion = compliant(1e5, 0.02), again = compliant(1e5, 0.02);
  for (int i = 0; i < 50; ++i) {
    motion->bear({{-3e5, 2e5 * (i % 3), 9e9}, {9e9, 0.0, 0.0}});
    motion->advance(1.0);
  }
  BOOST_TEST(motion->now().pose.position.y > 0.0);
  BOOST_TEST(motion->now().pose.position.z == 0.0);
  model::Checkpoint saved;
  motion->save(saved);
  again->restore(saved);
  for (structure::Motion* const one : {motion.get(), again.get()}) {
    one->bear({{1e5, -4e5, 0.0}, {}});
    one->advance(0.5);
    one->advance(0.5);
  }
  BOOST_TEST((again->now().pose == motion->now().pose));
  BOOST_TEST((again->now().twist == motion->now().twist));
}

std::unique_ptr<structure::Motion> driven() { return motion_of(model::Driven{1.5}); }

BOOST_AUTO_TEST_CASE(a_driven_structure_goes_straight_and_turns_evenly_to_its_goal_and_on_at_its_twist) {
  const auto motion = driven();
  const Pose goal{{-6.98, 0.01, 0.002}, {std::cos(0.04), 0.0, 0.0, std::sin(0.04)}};  // turned by 0.08 rad
  const structure::State way = structure::way_to(goal, motion->now().pose, 0.01);
  BOOST_TEST(way.twist.linear.x == 2.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(way.twist.angular.z == 8.0, boost::test_tools::tolerance(1e-12));
  motion->drive(way);
  motion->advance(0.25);
  BOOST_TEST(motion->now().pose.position.x == -6.995, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(motion->now().pose.rotation.z == std::sin(0.01), boost::test_tools::tolerance(1e-14));
  motion->advance(0.75);
  BOOST_TEST(norm(motion->now().pose.position - goal.position) < 1e-15);
  BOOST_TEST(motion->now().pose.rotation.z == std::sin(0.04), boost::test_tools::tolerance(1e-14));
  motion->bear({{-1e9, 0.0, 0.0}, {}});
  motion->advance(1.0);
  BOOST_TEST(motion->now().pose.position.x == -6.96, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(motion->now().pose.rotation.z == std::sin(0.08), boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_driven_structure_that_is_told_a_twist_goes_where_it_leads) {
  const auto motion = driven();
  const Twist twist{{1.0, -2.0, 0.5}, {0.0, 0.3, 0.0}};
  const structure::State way = structure::way_at(twist, motion->now().pose, 0.01);
  const structure::State back = structure::way_to(way.pose, motion->now().pose, 0.01);
  BOOST_TEST(norm(back.twist.linear - twist.linear) < 1e-12);
  BOOST_TEST(norm(back.twist.angular - twist.angular) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_drive_that_is_no_motion_and_a_drive_of_a_tow_are_refused) {
  const auto motion = driven();
  BOOST_CHECK_THROW(motion->drive({{{std::nan(""), 0.0, 0.0}, {}}, {}}), InputError);
  BOOST_CHECK_THROW(motion->drive({{{}, {0.5, 0.0, 0.0, 0.0}}, {}}), InputError);
  BOOST_CHECK_THROW(motion->drive({{{}, {}}, {{}, {0.0, INFINITY, 0.0}}}), InputError);
  BOOST_CHECK_THROW(towed()->drive({}), InputError);
}

BOOST_AUTO_TEST_CASE(a_drive_that_jumps_or_turns_over_in_a_step_is_refused_with_its_speed) {
  const auto motion = driven();
  const Pose start = motion->now().pose;
  const auto refusal = [&](const structure::State& goal) {
    try {
      motion->drive(goal);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const auto says = [](const std::string& text, const char* words) { return text.find(words) != std::string::npos; };
  const std::string far = refusal({{start.position + Vec3{1.0, 0.0, 0.0}, {}}, {}});
  BOOST_TEST(says(far, "more than 50 m/s"), far);
  const std::string over = refusal({{start.position, {0.0, 0.0, 1.0, 0.0}}, {}});  // pitched by 180 degrees
  BOOST_TEST(says(over, "turns it at 314.159265 rad/s: more than 10 rad/s"), over);
  const std::string fast = refusal({start, {{51.0, 0.0, 0.0}, {}}}), spins = refusal({start, {{}, {0.0, 0.0, 11.0}}});
  BOOST_TEST(says(fast, "moves it at 51.000000 m/s"), fast);
  BOOST_TEST(says(spins, "turns it at 11.000000 rad/s"), spins);
  BOOST_TEST(refusal({start, {{50.0, 0.0, 0.0}, {0.0, 0.0, 10.0}}}) == "accepted");
}

BOOST_AUTO_TEST_CASE(a_drive_goes_on_from_a_checkpoint_that_lies_before_its_step) {
  const auto motion = driven(), again = driven();
  motion->drive({{{-6.9, 0.2, 0.0}, {std::cos(0.04), std::sin(0.04), 0.0, 0.0}}, {{9.0, 20.0, 0.0}, {8.0, 0.0, 0.0}}});
  model::Checkpoint saved;
  motion->save(saved);
  again->restore(saved);
  for (structure::Motion* const one : {motion.get(), again.get()}) {
    one->advance(0.5);
    one->advance(0.5);
    one->bear({});
    one->advance(1.0);
  }
  BOOST_TEST((again->now().pose == motion->now().pose));
  BOOST_TEST((again->now().twist == motion->now().twist));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
