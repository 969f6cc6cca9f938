// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../../modules/rigid_body/src/bounded_solver.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace brash;
using namespace brash::rigid_body;

namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kFixed = BoundedSolver::kFixed;

/// A ball of 25 kg m2 about each axis.
SolverBody ball(Vec3 position, Twist twist, double mass) {
  return {.position = position,
          .twist = twist,
          .inverse_mass = 1.0 / mass,
          .axes = {Vec3{0.2, 0.0, 0.0}, Vec3{0.0, 0.2, 0.0}, Vec3{0.0, 0.0, 0.2}}};
}

double kinetic_energy(const SolverBody& ball, const Twist& twist) {
  return 0.5 * dot(twist.linear, twist.linear) / ball.inverse_mass + 12.5 * dot(twist.angular, twist.angular);
}

/// One point with its contact, as it was added.
struct Point {
  SolverContact contact;
  PatchPoint patch;
};

/// Balls that press on each other and on fixed ground at random points.
struct Pile {
  std::vector<SolverBody> balls{{}};  ///< the first is the ground
  std::vector<Point> points;
  BoundedSolver solver;

  /// @param bounds  most of the limited impulses are multiplied by this [-].
  explicit Pile(unsigned seed, double restitution = 0.0, double bounds = 1.0) {
    solver.clear(restitution);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] { return Vec3{unit(random), unit(random), unit(random)}; };
    for (int i = 0; i < 12; ++i) {
      balls.push_back(ball(5.0 * vector(), {vector(), vector()}, std::exp(2.0 * unit(random))));
      BOOST_REQUIRE(solver.add(balls.back()) == balls.size() - 1);
    }
    const auto any = [&](std::size_t n) { return static_cast<std::uint32_t>(random() % n); };
    for (int i = 0; i < 20; ++i) {
      const std::uint32_t first = 1 + any(12), second = any(first);
      const SolverContact contact{.first = first,
                                  .second = second,
                                  .normal = normalized(vector()),
                                  .friction = i % 2 == 0 ? 0.3 : 0.8,
                                  .crushing_impulse = i % 4 == 0 ? kAny : 0.5 * bounds};
      std::vector<PatchPoint> patch(1 + any(4));
      const Vec3 middle = 0.5 * (balls[first].position + balls[second].position);
      for (PatchPoint& point : patch) point = {middle + 0.5 * vector(), std::abs(unit(random))};
      solver.add(contact, patch);
      for (const PatchPoint& point : patch) points.push_back({contact, point});
    }
  }

  /// Velocity of the first body against the second at a point, after the solver [m/s].
  Vec3 velocity(const Point& p) const {
    const auto of = [&](std::uint32_t i) { return velocity_at(solver.twist(i), p.patch.position - balls[i].position); };
    return of(p.contact.first) - of(p.contact.second);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(bounded_solver)

BOOST_AUTO_TEST_CASE(two_balls_that_meet_head_on_part_as_newton_says) {
  for (const double restitution : {0.0, 0.3, 1.0}) {
    BoundedSolver solver;
    solver.clear(restitution);
    const std::uint32_t a = solver.add(ball({0, 0, 0}, {{1.0, 0, 0}, {}}, 3.0));
    const std::uint32_t b = solver.add(ball({2, 0, 0}, {{-0.5, 0, 0}, {}}, 1.0));
    solver.add({.first = a, .second = b, .normal = {-1, 0, 0}, .friction = 0.3, .crushing_impulse = kAny},
               std::vector<PatchPoint>{{{1, 0, 0}, 1.0}});
    solver.solve(50, 0.0);
    const double impulse = 0.75 * 1.5 * (1.0 + restitution);
    BOOST_TEST(solver.impulse(0).normal == impulse, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(!solver.impulse(0).at_bound);
    BOOST_TEST(solver.twist(a).linear.x == 1.0 - impulse / 3.0, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(solver.twist(b).linear.x == -0.5 + impulse, boost::test_tools::tolerance(1e-12));
  }
}

/// A ball hits the first of n balls that touch: P = (1 + e) times the impulse that lets all move on together.
BOOST_AUTO_TEST_CASE(a_chain_of_balls_parts_as_moreau_says) {
  constexpr int kBalls = 4;
  for (const double e : {0.3, 1.0}) {
    BoundedSolver solver;
    solver.clear(e);
    for (int i = 0; i < kBalls; ++i) {
      const std::uint32_t one = solver.add(ball({2.0 * i, 0, 0}, {{i == 0 ? 1.0 : 0.0, 0, 0}, {}}, 1.0));
      if (i == 0) continue;
      solver.add({.first = one, .second = one - 1, .normal = {1, 0, 0}, .crushing_impulse = kAny},
                 std::vector<PatchPoint>{{{2.0 * i - 1.0, 0, 0}, 1.0}});
    }
    solver.solve(1000, 0.0);
    double energy = 0.0;
    for (std::uint32_t i = 1; i <= kBalls; ++i) {
      const double wanted = (1.0 + e) / kBalls - (i == 1 ? e : 0.0);
      BOOST_TEST(std::abs(solver.twist(i).linear.x - wanted) < 1e-12);
      energy += 0.5 * wanted * wanted;
    }
    BOOST_TEST(energy <= 0.5);
    if (e == 1.0) BOOST_TEST(energy == 0.5, boost::test_tools::tolerance(1e-12));
  }
}

/// Newton's law for the normal velocity with Coulomb's friction would give this rod 46 % more energy than it had in the
/// directions of the contact (after Kane and Levinson 1985).
BOOST_AUTO_TEST_CASE(a_rod_that_slides_as_it_hits_the_ground_gains_no_energy) {
  const double root = std::sqrt(3.0);  // of 1 / (m l^2 / 12), m = 1 kg, l = 2 m
  for (const double e : {0.0, 0.5, 1.0}) {
    BoundedSolver solver;
    solver.clear(e);
    const SolverBody rod{.twist = {{-0.7, 0, -1.0}, {}},
                         .inverse_mass = 1.0,
                         .axes = {Vec3{root, 0, 0}, Vec3{0, root, 0}, Vec3{0, 0, root}}};
    const std::uint32_t one = solver.add(rod);
    solver.add({.first = one, .second = kFixed, .normal = {0, 0, 1}, .friction = 0.3, .crushing_impulse = kAny},
               std::vector<PatchPoint>{{{std::cos(1.0), 0, -std::sin(1.0)}, 1.0}});
    solver.solve(5000, 0.0);
    const auto energy = [&](const Twist& t) {
      return 0.5 * (dot(t.linear, t.linear) + dot(t.angular, t.angular) / 3.0);
    };
    BOOST_TEST(energy(solver.twist(one)) <= energy(rod.twist) + 1e-12);
    BOOST_TEST(solver.impulse(0).normal > 0.1);
  }
}

BOOST_AUTO_TEST_CASE(impulses_change_turned_bodies_of_three_moments_as_newton_and_euler_say) {
  constexpr Vec3 kInertia{1.0, 4.0, 9.0};
  constexpr double kMass = 3.0;
  const auto turned = [&](Vec3 position, const Quaternion& q, const Twist& twist) {
    return SolverBody{
        .position = position,
        .twist = twist,
        .inverse_mass = 1.0 / kMass,
        .axes = {rotate(q, {1.0, 0.0, 0.0}), rotate(q, {0.0, 0.5, 0.0}), rotate(q, {0.0, 0.0, 1.0 / 3.0})}};
  };
  const Quaternion q[] = {{0.5, 0.5, -0.7, 0.1}, {0.1, -0.7, 0.5, 0.5}};
  const SolverBody bodies[] = {turned({0, 0, 0}, q[0], {{1.0, 0.2, 0.1}, {0.3, -0.2, 0.5}}),
                               turned({2, 0, 0}, q[1], {{-0.5, 0.0, -0.3}, {-0.4, 0.1, 0.2}})};
  const Vec3 normal = normalized(Vec3{-1.0, 0.2, 0.1});
  const std::vector<PatchPoint> points{{{1.0, 0.3, 0.2}, 1.0}, {{1.1, -0.4, 0.3}, 1.0}, {{0.9, 0.1, -0.5}, 1.0}};
  BoundedSolver solver;
  const std::uint32_t number[] = {solver.add(bodies[0]), solver.add(bodies[1])};
  solver.add({.first = number[0], .second = number[1], .normal = normal, .friction = 0.3, .crushing_impulse = kAny},
             points);
  solver.solve(50, 0.0);
  for (std::size_t b = 0; b < 2; ++b) {
    Vec3 momentum{}, spin{};
    for (std::size_t k = 0; k < points.size(); ++k) {
      const PointImpulse p = solver.impulse(k);
      const Vec3 impulse = (b == 0 ? 1.0 : -1.0) * (p.normal * normal + p.friction);
      momentum += impulse;
      spin += cross(points[k].position - bodies[b].position, impulse);
    }
    const Twist now = solver.twist(number[b]);
    const Vec3 turn = rotate(conjugate(q[b]), now.angular - bodies[b].twist.angular);
    const Vec3 gained = rotate(q[b], {kInertia.x * turn.x, kInertia.y * turn.y, kInertia.z * turn.z});
    BOOST_TEST(norm(momentum) > 0.1);
    BOOST_TEST(norm(kMass * (now.linear - bodies[b].twist.linear) - momentum) < 1e-13);
    BOOST_TEST(norm(gained - spin) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(impulses_change_a_body_with_more_mass_along_an_axis_as_newton_says) {
  constexpr double kMass = 3.0, kAcross = 12.0;
  const Vec3 axis = normalized(Vec3{0.3, -0.5, 0.9});
  SolverBody plate = ball({0, 0, 0}, {{1.0, 0.2, 0.1}, {0.3, -0.2, 0.5}}, kMass);
  plate.normal = axis;
  plate.stretch = std::sqrt(kMass / kAcross) - 1.0;
  const SolverBody other = ball({2, 0, 0}, {{-0.5, 0.0, -0.3}, {-0.4, 0.1, 0.2}}, 2.0);
  const Vec3 normal = normalized(Vec3{-1.0, 0.2, 0.1});
  const std::vector<PatchPoint> points{{{1.0, 0.3, 0.2}, 1.0}, {{1.1, -0.4, 0.3}, 1.0}, {{0.9, 0.1, -0.5}, 1.0}};
  BoundedSolver solver;
  const std::uint32_t number[] = {solver.add(plate), solver.add(other)};
  solver.add({.first = number[0], .second = number[1], .normal = normal, .friction = 0.3, .crushing_impulse = kAny},
             points);
  solver.solve(200, 0.0);
  Vec3 impulse{};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const PointImpulse p = solver.impulse(k);
    impulse += p.normal * normal + p.friction;
    const Twist &a = solver.twist(number[0]), &b = solver.twist(number[1]);
    const Vec3 apart = velocity_at(a, points[k].position) - velocity_at(b, points[k].position - other.position);
    if (p.normal > 0.0) BOOST_TEST(std::abs(dot(normal, apart)) < 1e-9);  // converged
  }
  const Vec3 gained = solver.twist(number[0]).linear - plate.twist.linear;
  BOOST_TEST(norm(impulse) > 0.1);
  BOOST_TEST(norm(kMass * gained + (kAcross - kMass) * dot(axis, gained) * axis - impulse) < 1e-13);
  BOOST_TEST(norm(2.0 * (solver.twist(number[1]).linear - other.twist.linear) + impulse) < 1e-13);
}

BOOST_AUTO_TEST_CASE(a_point_bears_its_area_times_the_crushing_impulse_at_most) {
  BoundedSolver solver;
  const std::uint32_t a = solver.add(ball({0, 0, 0}, {{1.0, 0, 0}, {}}, 3.0));
  solver.add({.first = a, .second = kFixed, .normal = {-1, 0, 0}, .crushing_impulse = 10.0},
             std::vector<PatchPoint>{{{1, 0, 0}, 0.2}});
  solver.solve(50, 0.0);
  BOOST_TEST(solver.impulse(0).normal == 2.0);
  BOOST_TEST(solver.impulse(0).at_bound);
  BOOST_TEST(solver.twist(a).linear.x == 1.0 / 3.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(friction_stops_a_slow_slide_and_brakes_a_fast_one_against_its_direction) {
  for (const double speed : {0.1, 5.0}) {
    BoundedSolver solver;
    const Vec3 along = speed * normalized(Vec3{3, 4, 0});
    SolverBody block = ball({0, 0, 0}, {along + Vec3{0, 0, -1}, {}}, 2.0);
    block.axes = {};  // it does not turn
    const std::uint32_t a = solver.add(block);
    solver.add({.first = a, .second = kFixed, .normal = {0, 0, 1}, .friction = 0.5, .crushing_impulse = kAny},
               std::vector<PatchPoint>{{{0, 0, -1}, 1.0}});
    solver.solve(50, 0.0);
    const Vec3 left = solver.twist(a).linear;
    const Vec3 wanted = std::max(0.0, speed - 0.5) / speed * along;
    BOOST_TEST(norm(left - wanted) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(positions_part_at_their_speed_and_velocities_know_nothing_of_it) {
  BoundedSolver solver;
  const std::uint32_t a = solver.add(ball({0, 0, 0}, {}, 3.0));
  const std::uint32_t b = solver.add(ball({2, 0, 0}, {}, 1.0));
  solver.add({.first = a, .second = b, .normal = {-1, 0, 0}, .crushing_impulse = kAny, .parting_speed = 0.4},
             std::vector<PatchPoint>{{{1, 0, 0}, 1.0}});
  solver.solve(50, 0.0);
  BOOST_TEST(solver.parting(a).linear.x == -0.1, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(solver.parting(b).linear.x == 0.3, boost::test_tools::tolerance(1e-12));
  BOOST_TEST((solver.twist(a) == Twist{}));
  BOOST_TEST((solver.twist(b) == Twist{}));
  BOOST_TEST(solver.impulse(0).normal == 0.0);
}

/// Sweeps that each begin where the last one ended leave 24 % and 44 % of the weight here.
BOOST_AUTO_TEST_CASE(the_weight_of_a_column_reaches_the_ground_in_few_sweeps) {
  for (const auto& [n, iterations] : {std::pair{10, 50}, {20, 100}}) {
    BoundedSolver solver;
    std::uint32_t below = kFixed;
    for (int i = 0; i < n; ++i) {
      const std::uint32_t one = solver.add(ball({0, 0, i + 0.5}, {{0, 0, -1}, {}}, 1.0));
      solver.add({.first = one, .second = below, .normal = {0, 0, 1}, .friction = 0.3, .crushing_impulse = kAny},
                 std::vector<PatchPoint>{{{0, 0, static_cast<double>(i)}, 1.0}});
      below = one;
    }
    solver.solve(iterations, 0.0);
    for (int i = 0; i < n; ++i) BOOST_TEST(std::abs(solver.impulse(i).normal - (n - i)) < 1e-3 * n);
  }
}

/// Signorini's condition, Coulomb's disc and the bound, at every point at once. A pile of points and normals at random
/// need not let the iteration come to rest.
BOOST_AUTO_TEST_CASE(at_every_point_of_a_pile_the_laws_of_contact_hold) {
  constexpr double kSlow = 1e-9;   // [m/s]
  constexpr double kClear = 1e-3;  // has a direction [m/s]
  int n_solved = 0, n_free = 0, n_bearing = 0, n_crushed = 0, n_sticking = 0, n_sliding = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    Pile pile(seed);
    if (pile.solver.solve(2000, 1e-12) > 1e-12) continue;
    ++n_solved;
    for (std::size_t i = 0; i < pile.points.size(); ++i) {
      const auto& [contact, patch] = pile.points[i];
      const PointImpulse impulse = pile.solver.impulse(i);
      const double bound = contact.crushing_impulse * patch.area;
      const Vec3 velocity = pile.velocity(pile.points[i]);
      const double parts_at = dot(contact.normal, velocity);
      BOOST_TEST(impulse.normal >= 0.0);
      BOOST_TEST(impulse.normal <= bound);
      BOOST_TEST(impulse.at_bound == (impulse.normal == bound));
      if (impulse.normal < bound) BOOST_TEST(parts_at > -kSlow);
      if (impulse.normal > 0.0) BOOST_TEST(parts_at < kSlow);
      (impulse.normal == 0.0 ? n_free : impulse.at_bound ? n_crushed : n_bearing) += 1;

      const Vec3 slip = velocity - parts_at * contact.normal;
      const double disc = contact.friction * impulse.normal;
      BOOST_TEST(std::abs(dot(impulse.friction, contact.normal)) < 1e-12);
      BOOST_TEST(norm(impulse.friction) <= disc * (1.0 + 1e-12));
      if (norm(impulse.friction) < 0.999 * disc) BOOST_TEST(norm(slip) < kSlow);
      if (norm(slip) > kClear) BOOST_TEST(norm(impulse.friction + disc * normalized(slip)) <= 1e-6 * disc);
      if (disc > 0.0) (norm(slip) < kSlow ? n_sticking : n_sliding) += 1;
    }
  }
  // Otherwise the test says little.
  BOOST_TEST_MESSAGE(n_solved << " solved");
  BOOST_TEST(n_solved >= 98);
  for (const int n : {n_free, n_bearing, n_crushed, n_sticking, n_sliding}) BOOST_TEST(n > 20);
}

/// Moreau's law: the impulses are 1 + e times the impulses of bodies that do not rebound, bounds likewise.
BOOST_AUTO_TEST_CASE(restitution_multiplies_the_impulses_of_a_pile) {
  int n_solved = 0;
  for (unsigned seed = 1; seed <= 50; ++seed) {
    for (const double e : {0.2, 1.0}) {
      Pile dull(seed), elastic(seed, e, 1.0 + e);
      if (dull.solver.solve(5000, 1e-13) > 1e-13 || elastic.solver.solve(5000, 1e-13) > 1e-13) continue;
      ++n_solved;
      for (std::uint32_t i = 1; i < dull.balls.size(); ++i) {
        const Twist before = dull.balls[i].twist, one = dull.solver.twist(i), other = elastic.solver.twist(i);
        BOOST_TEST(norm(other.linear - before.linear - (1.0 + e) * (one.linear - before.linear)) < 1e-9);
        BOOST_TEST(norm(other.angular - before.angular - (1.0 + e) * (one.angular - before.angular)) < 1e-9);
      }
    }
  }
  BOOST_TEST(n_solved >= 80);
}

BOOST_AUTO_TEST_CASE(a_pile_keeps_its_momentum_but_for_what_the_ground_takes_and_gains_no_energy) {
  for (unsigned seed = 1; seed <= 400; ++seed) {
    Pile pile(seed, 0.25 * (seed % 5));
    pile.solver.solve(1 + static_cast<int>(seed) % 50, 0.0);  // was seen with any number of iterations
    Vec3 gained{}, from_ground{};
    double before = 0.0, after = 0.0;
    for (std::uint32_t i = 1; i < pile.balls.size(); ++i) {
      const SolverBody& ball = pile.balls[i];
      const Twist twist = pile.solver.twist(i);
      gained += (twist.linear - ball.twist.linear) / ball.inverse_mass;
      before += kinetic_energy(ball, ball.twist);
      after += kinetic_energy(ball, twist);
    }
    for (std::size_t i = 0; i < pile.points.size(); ++i) {
      const SolverContact& contact = pile.points[i].contact;
      const PointImpulse impulse = pile.solver.impulse(i);
      if (contact.second == kFixed) from_ground += impulse.normal * contact.normal + impulse.friction;
    }
    BOOST_TEST(norm(gained - from_ground) < 1e-12);
    BOOST_TEST(after <= before);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_CASE(a_joint_holds_within_its_limits_and_gives_way_by_its_softness) {
  // Two balls of 2 and 3 kg part along x at 5 m/s; m is their reduced mass.
  const double m = 1.0 / (1.0 / 2.0 + 1.0 / 3.0);
  const auto impulse_of = [&](double softness, double most, double velocity) {
    BoundedSolver solver;
    const std::uint32_t first = solver.add(ball({1, 0, 0}, {{2, 0, 0}, {}}, 2.0));
    const std::uint32_t second = solver.add(ball({-1, 0, 0}, {{-3, 0, 0}, {}}, 3.0));
    solver.add(SolverJoint{.first = first,
                           .second = second,
                           .of_first = {{1, 0, 0}, {}},
                           .of_second = {{-1, 0, 0}, {}},
                           .velocity = velocity,
                           .softness = softness,
                           .least = -most,
                           .most = most});
    solver.solve(30, 1e-12);
    const double impulse = solver.joint_impulse(0);
    BOOST_TEST(solver.twist(first).linear.x == 2.0 + impulse / 2.0, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(solver.twist(second).linear.x == -3.0 - impulse / 3.0, boost::test_tools::tolerance(1e-12));
    return impulse;
  };
  BOOST_TEST(impulse_of(0.0, kAny, 0.0) == -5.0 * m, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(impulse_of(0.0, kAny, 1.0) == -4.0 * m, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(impulse_of(0.0, 2.0, 0.0) == -2.0);
  BOOST_TEST(impulse_of(0.4, kAny, 0.0) == -5.0 / (1.0 / m + 0.4), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_row_of_angular_velocities_stops_a_turn) {
  BoundedSolver solver;
  const std::uint32_t body = solver.add(ball({}, {{1, 2, 3}, {0.1, 0.2, 0.8}}, 2.0));
  solver.add(SolverJoint{.first = body, .of_first = {{}, {0, 0, 1}}, .least = -kAny, .most = kAny});
  solver.solve(30, 1e-12);
  BOOST_TEST(norm(solver.twist(body).angular - Vec3{0.1, 0.2, 0.0}) < 1e-12);
  BOOST_TEST((solver.twist(body).linear == Vec3{1, 2, 3}));
  BOOST_TEST(solver.joint_impulse(0) == -25.0 * 0.8, boost::test_tools::tolerance(1e-12));
}
