// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/path.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "motions.hpp"

namespace {

using namespace brash;
using structure::Path;
using structure::testing::Moving;

double heading(const Pose& pose) { return 2.0 * std::atan2(pose.rotation.z, pose.rotation.w); }

/// A circle of 100 m at 2 m/s, a row every `interval` seconds.
std::vector<model::Waypoint> circle(double interval, double end) {
  std::vector<model::Waypoint> rows;
  for (double t = 0.0; t <= end; t += interval) {
    const double angle = 2.0 * t / 100.0;
    rows.push_back({t, {100.0 * std::sin(angle), 100.0 * (1.0 - std::cos(angle))}, angle});
  }
  return rows;
}

double error_on_circle(double interval) {
  const Path path(circle(interval, 150.0));
  double most = 0.0;
  for (double t = 30.0; t < 120.0; t += 0.37) {
    const double angle = 2.0 * t / 100.0;
    const Vec3 p = path.at(t).position;
    most = std::max(most, std::hypot(p.x - 100.0 * std::sin(angle), p.y - 100.0 * (1.0 - std::cos(angle))));
  }
  return most;
}

BOOST_AUTO_TEST_SUITE(path)

BOOST_AUTO_TEST_CASE(a_path_meets_its_rows_and_its_velocity_does_not_jump) {
  const std::vector<model::Waypoint> rows{{0, {-9, 0}, 0}, {4, {0, 1}, 0.3}, {5, {2, 2}, 0.8}, {9, {3, 9}, 1.5}};
  const Path path(rows);
  for (const model::Waypoint& row : rows) {
    const Pose pose = path.at(row.time);
    BOOST_TEST(norm(pose.position - Vec3{row.position.x, row.position.y, 0.0}) < 1e-14);
    BOOST_TEST(std::abs(heading(pose) - row.heading) < 1e-14);
  }
  for (const double t : {4.0, 5.0}) {
    const double d = 1e-6;
    const Vec3 before = path.at(t).position - path.at(t - d).position,
               after = path.at(t + d).position - path.at(t).position;
    BOOST_TEST(norm(after - before) / d < 1e-4);  // the change of velocity over d, the curvature's share
  }
  BOOST_TEST((path.at(-1.0) == path.at(0.0)));
  BOOST_TEST((path.at(99.0) == path.at(9.0)));
}

BOOST_AUTO_TEST_CASE(straight_parts_stay_straight_beside_a_turn) {
  const Path path(
      {{0, {0, 0}, 0}, {1, {2, 0}, 0}, {2, {4, 0}, 0}, {3, {6, 0}, 0}, {4, {7.5, 1}, 0.5}, {5, {8, 3}, 1.2}});
  for (double t = 0.0; t <= 2.0; t += 0.1) {
    BOOST_TEST(std::abs(path.at(t).position.x - 2.0 * t) < 1e-14);
    BOOST_TEST(path.at(t).position.y == 0.0);
    BOOST_TEST((path.at(t).rotation == Quaternion{}));
  }
}

BOOST_AUTO_TEST_CASE(where_two_straight_parts_meet_in_one_row_the_slope_is_their_mean) {
  // Along x at 1 m/s, then along y at 1 m/s; the chords of x differ by rounding.
  const Path path({{0.0, {0.0, 0.0}, 0},
                   {0.1, {0.1, 0.0}, 0},
                   {0.2, {0.2, 0.0}, 0},
                   {0.3, {0.3, 0.0}, 0},
                   {0.4, {0.3, 0.1}, 0},
                   {0.5, {0.3, 0.2}, 0},
                   {0.6, {0.3, 0.3}, 0}});
  const double d = 1e-5;
  const Vec3 velocity = (path.at(0.3 + d).position - path.at(0.3 - d).position) / (2.0 * d);
  BOOST_TEST(velocity.x == 0.5, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(velocity.y == 0.5, boost::test_tools::tolerance(1e-6));
  // Both parts leave their lines beside the corner: x by h t (1 - t)^2 m with h = 0.1 s 0.5 m/s, y likewise before it.
  BOOST_TEST(path.at(0.35).position.x == 0.3 + 0.05 * 0.125, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(path.at(0.25).position.y == -0.05 * 0.125, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(rows_on_a_circle_give_the_circle_the_better_the_more_they_are) {
  const double coarse = error_on_circle(5.0), fine = error_on_circle(2.5);  // 5.7 and 2.9 degrees
  BOOST_TEST_MESSAGE("off the circle of 100 m: " << coarse << " and " << fine << " m");
  BOOST_TEST(coarse < 0.02);
  BOOST_TEST(fine < coarse / 6.0);  // third order
}

BOOST_AUTO_TEST_CASE(the_mean_speed_on_a_circle_is_the_speed_on_it) {
  const model::StructureSection section{.shape = {}, .motion = model::Towed{0.0, circle(5.0, 150.0)}};
  // The chords of 0.4 degrees are shorter by 2e-6, and the ends of the path are a little off the circle.
  BOOST_TEST(structure::mean_speed(section, 150.0) == 2.0, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(the_heading_takes_the_shorter_way_between_rows) {
  const Path path({{0, {0, 0}, radians(350)}, {1, {1, 0}, radians(10)}, {2, {2, 0}, radians(30)}});
  const double turn = heading(path.at(0.5)) - 2.0 * kPi;
  BOOST_TEST(std::abs(std::remainder(turn, 2.0 * kPi)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_structure_on_a_path_is_where_the_path_says_and_goes_on_from_a_checkpoint) {
  const model::Towed towed{.speed = 0.0, .path = circle(5.0, 150.0)};
  const Path path(towed.path);
  Moving whole({model::Cone{1.0, 10.0, 8.0, 5.0}}, towed, 0.01), again({model::Cone{1.0, 10.0, 8.0, 5.0}}, towed, 0.01);
  whole.steps(3000);
  whole->advance(0.5);
  whole->advance(0.25);
  whole->advance(0.25);
  BOOST_TEST((whole->now().pose == path.at(3001 * 0.01)));
  // The velocity is the mean of the step, which is the chord over the step.
  const Vec3 chord = (path.at(30.01).position - path.at(30.0).position) / 0.01;
  BOOST_TEST(norm(whole->now().twist.linear - chord) < 1e-9);
  BOOST_TEST(whole->now().twist.angular.z == 0.02, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(norm(Vec2{whole->course().x - chord.x, whole->course().y - chord.y}) < 1e-9);
  whole->bear({});
  model::Checkpoint saved;
  whole->save(saved);
  again->restore(saved);
  whole.steps(10);
  again.steps(10);
  BOOST_TEST((again->now().pose == whole->now().pose));
  BOOST_TEST((again->now().twist == whole->now().twist));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
