// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets that drift meet each other, fixed walls and floes; docs/theory/fracture-of-floes.md, "Contact".
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "helpers.hpp"

using namespace brash;
using namespace brash::rigid_body;

namespace {

namespace tt = boost::test_tools;
constexpr double kStep = 0.01;
constexpr double kThickness = 0.5;
constexpr double kPressure = 0.5e6;
constexpr double kFriction = 0.3;

/// A rectangular sheet in square tiles, as level ice has them.
struct Sheet {
  Sheet(World& owner, Vec2 lower, Vec2 upper, Vec2 drift = {}, double tile = 4.0)
      : world(owner),
        centre(0.5 * (lower + upper)),
        velocity(drift),
        mass(900.0 * kThickness * (upper.x - lower.x) * (upper.y - lower.y)),
        inertia(mass * dot(upper - lower, upper - lower) / 12.0),
        id(world.add_drifting_sheet()) {
    const Vec2 half = 0.5 * (upper - lower);  // the frame lies in the centre
    for (double x = -half.x; x < half.x; x += tile)
      for (double y = -half.y; y < half.y; y += tile) {
        const double right = std::min(x + tile, half.x), top = std::min(y + tile, half.y);
        parts.push_back(world.add_sheet_part(std::vector<Vec2>{{x, y}, {right, y}, {right, top}, {x, top}}, -0.45, 0.05,
                                             pose(), id));
      }
  }

  Pose pose() const { return {{centre.x, centre.y, 0.0}, {std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle)}}; }
  Twist twist() const { return {{velocity.x, velocity.y, 0.0}, {0.0, 0.0, spin}}; }
  double energy() const { return 0.5 * (mass * dot(velocity, velocity) + inertia * spin * spin); }
  Vec2 momentum() const { return mass * velocity; }
  double angular_momentum() const { return inertia * spin + mass * cross(centre, velocity); }

  /// As docs/theory/fracture-of-floes.md, (G1), (G2): an even move, and then the step of the world.
  void hand_over() {
    world.set_sheet(id, {mass, inertia, centre, velocity, spin, force, 0.0});
    centre += kStep * velocity;
    angle += kStep * spin;
    for (const BodyId part : parts) world.move_sheet_part(part, pose(), twist());
  }
  void take_back() {
    velocity = plan(world.twist(id).linear);
    spin = world.twist(id).angular.z;
  }

  World& world;
  Vec2 centre;
  Vec2 velocity;
  double mass, inertia;
  BodyId id;
  double angle = 0.0, spin = 0.0;
  Vec2 force{};
  std::vector<BodyId> parts{};
};

/// Steps the world with its sheets. @return the energy that contacts of sheets took [J].
double step(World& world, std::vector<Sheet*> sheets, int n_steps = 1) {
  double taken = 0.0;
  for (int i = 0; i < n_steps; ++i) {
    for (Sheet* sheet : sheets) sheet->hand_over();
    world.step(kStep);
    for (Sheet* sheet : sheets) sheet->take_back();
    for (const ContactLoad& c : world.contacts_of_sheets()) taken -= kStep * (normal_power(c) + friction_power(c));
  }
  return taken;
}

WorldSettings breakable(double friction = kFriction) {
  return {.ice_structure = {0.1, kPressure}, .ice_ice = {friction, kPressure}};
}

/// Along x on what lies about the line x [N].
double between(const World& world, double x) {
  double sum = 0.0;
  for (const ContactLoad& c : world.contacts_of_sheets())
    if (std::abs(c.point.x - x) < 0.1) sum += std::abs(c.normal_force * c.normal.x + c.friction_force.x);
  return sum;
}

/// On a wall at x = 0 [N].
double on_wall(const World& world) { return between(world, 0.0); }

BodyId add_wall(World& world, double x) {
  return world.add_sheet_part(std::vector<Vec2>{{x, -100}, {x + 10, -100}, {x + 10, 100}, {x, 100}}, -5.0, 5.0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(Two_sheets_that_collide_go_on_together_with_their_momentum_and_lose_the_energy_of_their_approach) {
  World world(breakable());
  Sheet one(world, {-40.3, -12}, {-0.3, 12}, {0.4, 0.0}), other(world, {0, -14}, {24, 14}, {-0.1, 0.0});
  const double momentum = one.mass * 0.4 - other.mass * 0.1, before = one.energy() + other.energy();
  const double taken = step(world, {&one, &other}, 300);
  const double together = momentum / (one.mass + other.mass);
  // Restitution 0. The contacts are solved to 1e-8 m/s.
  BOOST_TEST(one.velocity.x == together, tt::tolerance(1e-6));
  BOOST_TEST(other.velocity.x == together, tt::tolerance(1e-6));
  BOOST_TEST(norm(one.momentum() + other.momentum() - Vec2{momentum, 0.0}) < 1e-12 * one.mass);
  const double reduced = one.mass * other.mass / (one.mass + other.mass);
  BOOST_TEST(taken == 0.5 * reduced * 0.25, tt::tolerance(1e-6));  // fracture-of-floes.md, (G11)
  BOOST_TEST(before - one.energy() - other.energy() == taken, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(Sheets_that_meet_out_of_the_middle_keep_their_momentum_and_their_moment_of_momentum) {
  World world(breakable());
  Sheet one(world, {-30.2, -2}, {-0.2, 22}, {0.5, -0.1}), other(world, {0, -20}, {24, 4}, {0.0, 0.1});
  one.spin = 0.01;
  const Vec2 momentum = one.momentum() + other.momentum();
  const double before = one.energy() + other.energy();
  double turning = one.angular_momentum() + other.angular_momentum();
  const double scale = one.mass * 0.5 * 30.0;
  double taken = 0.0;
  for (int i = 0; i < 600; ++i) {
    const Vec2 at_one = one.centre, at_other = other.centre;
    taken += step(world, {&one, &other});
    // Contacts act where the sheets are at the start of a step, and the sheets move on as they did then: the moment of
    // the new momentum is about the places of the start.
    const double gained = one.inertia * one.spin + one.mass * cross(at_one, one.velocity) + other.inertia * other.spin +
                          other.mass * cross(at_other, other.velocity) - turning;
    BOOST_TEST(std::abs(gained) < 1e-9 * scale);
    turning = one.angular_momentum() + other.angular_momentum();
  }
  BOOST_TEST(std::abs(other.spin) > 1e-3);
  BOOST_TEST(norm(one.momentum() + other.momentum() - momentum) < 1e-12 * one.mass);
  BOOST_TEST(taken > 0.0);
  BOOST_TEST(before - one.energy() - other.energy() == taken, tt::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(A_sheet_that_runs_into_a_wall_is_crushed_at_the_crushing_pressure_until_it_stops) {
  World world(breakable());
  add_wall(world, 0.0);
  Sheet sheet(world, {-60.1, -2}, {-0.1, 2}, {1.0, 0.0});
  const double most = kPressure * 4.0 * kThickness;
  double depth = 0.0, largest = 0.0;
  for (int i = 0; i < 300; ++i) {
    step(world, {&sheet});
    largest = std::max(largest, on_wall(world));
    depth = std::max(depth, sheet.centre.x + 30.0);
  }
  BOOST_TEST(largest == most, tt::tolerance(1e-9));
  BOOST_TEST(std::abs(sheet.velocity.x) < 1e-4);  // the sweeps of a step end early
  // m v2 / 2 at the force p A. The first contact is found within a step of 0.01 m, and a sheet moves on at the velocity
  // of the start of a step: half a step more.
  BOOST_TEST(std::abs(depth - 0.5 * sheet.mass / most) < 0.016);
}

BOOST_AUTO_TEST_CASE(A_row_of_three_sheets_presses_on_a_wall_with_the_push_on_all_and_does_not_creep) {
  World world(breakable());
  add_wall(world, 0.0);
  Sheet near(world, {-20.01, -10}, {-0.01, 10}), middle(world, {-50.02, -12}, {-20.02, 12}),
      far(world, {-90.03, -8}, {-50.03, 8});
  near.force = {1000.0, 0.0};
  middle.force = {2000.0, 0.0};
  far.force = {3000.0, 0.0};
  step(world, {&near, &middle, &far}, 3000);
  const double before[]{near.centre.x, middle.centre.x, far.centre.x};
  constexpr int kSteps = 10000;  // 100 s
  double wall = 0.0, first_gap = 0.0, second_gap = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    step(world, {&near, &middle, &far});
    wall += on_wall(world) / kSteps;
    first_gap += between(world, -20.015) / kSteps;
    second_gap += between(world, -50.025) / kSteps;
  }
  BOOST_TEST(wall == 6000.0, tt::tolerance(1e-3));
  BOOST_TEST(first_gap == 5000.0, tt::tolerance(1e-3));
  BOOST_TEST(second_gap == 3000.0, tt::tolerance(1e-3));
  // The sweeps of a step leave some 1e-6 m/s, away from the wall.
  const double after[]{near.centre.x, middle.centre.x, far.centre.x};
  for (int i = 0; i < 3; ++i) {
    BOOST_TEST(after[i] < before[i] + 1e-6);
    BOOST_TEST(after[i] > before[i] - 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(A_sheet_at_a_wall_sticks_below_the_friction_of_ice_and_slides_above) {
  for (const double share : {0.9, 1.5}) {
    World world(breakable());
    add_wall(world, 0.0);
    Sheet sheet(world, {-40.001, -10}, {-0.001, 10}, {0.05, 0.0});
    step(world, {&sheet}, 50);
    const double normal = 50e3, along = share * kFriction * normal, y = sheet.centre.y, v = sheet.velocity.y;
    // The push acts at the centre and turns the sheet, which the wall holds.
    sheet.force = {normal, along};
    step(world, {&sheet}, 200);
    if (share < 1.0)
      BOOST_TEST(std::abs(sheet.centre.y - y) < 1e-6);
    else
      BOOST_TEST(sheet.velocity.y - v == 2.0 * (along - kFriction * normal) / sheet.mass, tt::tolerance(1e-6));
  }
}

BOOST_AUTO_TEST_CASE(The_tiles_of_a_sheet_make_no_difference) {
  std::vector<Vec2> velocities;
  for (const double tile : {4.0, 3.3, 100.0}) {
    World world(breakable());
    Sheet one(world, {-30.2, -2}, {-0.2, 22}, {0.5, -0.1}, tile), other(world, {0, -20}, {24, 4}, {0.0, 0.1}, tile);
    step(world, {&one, &other}, 200);
    velocities.push_back(one.velocity);
  }
  // The bound is not reached, so the area does not count; corners that rub differ by the way the patch is divided.
  BOOST_TEST(norm(velocities[1] - velocities[0]) < 1e-3);
  BOOST_TEST(norm(velocities[2] - velocities[0]) < 1e-3);
}

BOOST_AUTO_TEST_CASE(A_floe_and_a_sheet_of_its_mass_that_collide_go_on_together) {
  World world(breakable(0.0));
  Sheet sheet(world, {0, -4}, {8, 4});
  const std::vector<std::vector<Vec2>> ring{{{-8.05, -4}, {-0.05, -4}, {-0.05, 4}, {-8.05, 4}}};
  const PlacedPrism placed = place_prism(ring, ring, kThickness, -0.2);
  const MassProperties mass = mass_properties(placed.prism, 900.0, 0.0);
  BOOST_TEST(mass.mass == sheet.mass, tt::tolerance(1e-12));
  const BodyId floe = world.add_floe(placed.prism, mass, placed.pose, {{0.2, 0.0, 0.0}, {}});
  step(world, {&sheet}, 100);
  // The sheet as a wall that moves as told would hand the velocity on: an impact without loss.
  // The sweeps of a step end early.
  BOOST_TEST(sheet.velocity.x == 0.1, tt::tolerance(1e-3));
  BOOST_TEST(world.twist(floe).linear.x == 0.1, tt::tolerance(1e-3));
  BOOST_TEST(sheet.mass * sheet.velocity.x + mass.mass * world.twist(floe).linear.x == 0.2 * mass.mass,
             tt::tolerance(1e-12));
}
