// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks on the bed of the water: docs/theory/contacts-and-bodies.md, (C9).
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "helpers.hpp"

using namespace brash;
using namespace brash::rigid_body;
using namespace brash::rigid_body::testing;

namespace {

constexpr double kStep = 0.01;
constexpr double kThick = 0.5;
constexpr double kFriction = 0.4;
constexpr double kPressure = 0.5e6;
constexpr double kMass = kDensity * 2.0 * 2.0 * kThick;
/// Weight less the lift of the part under water [N].
constexpr double kNet = 0.3 * kMass * kGravity;
/// The solver ends when it changes no velocity by 1e-8 m/s: 2e-3 N on a block.
const auto kSolved = boost::test_tools::tolerance(1e-6);

WorldSettings over_bed(Vec2 velocity = {}) {
  return {.ice_structure = {0.1, kPressure},
          .ice_ice = {0.3, kPressure},
          .bed = Bed{.height = -1.0, .law = {kFriction, kPressure}, .velocity = velocity},
          .iterations = 200};
}

/// A block of 2 m by 2 m, `layer` blocks above the bed, pressed a little into the ice or the bed below.
BodyId add_block(World& world, double x, int layer = 0) {
  const BodyId block = add_floe(world, rectangle({x - 1, -1}, {x + 1, 1}), kThick);
  Pose pose = world.pose(block);
  pose.position.z = -1.0 + (layer + 0.5) * kThick - (layer + 1) * 1e-4;
  world.set_state(block, pose, {});
  return block;
}

/// Steps under the net weight of all blocks and a push on one.
void step(World& world, BodyId pushed = kNoBody, double push = 0.0) {
  for (const BodyId block : world.moving()) world.apply(block, {{0, 0, -kNet}, {}});
  if (pushed != kNoBody) world.apply(pushed, {{push, 0, 0}, {}});
  world.step(kStep);
}

/// Sum of the forces that a body takes from the bed [N].
Vec3 from_bed(const World& world, BodyId block) {
  Vec3 sum{};
  for (const ContactLoad& c : world.contacts())
    if (c.other_kind == BodyKind::kBed && c.body == block) sum += force(c);
  return sum;
}

double area_on_bed(const World& world) {
  double area = 0.0;
  for (const ContactLoad& c : world.contacts()) area += c.area;
  return area;
}

double speed(const World& world, BodyId block) { return world.twist(block).linear.x; }

BOOST_AUTO_TEST_SUITE(bed)

BOOST_AUTO_TEST_CASE(a_block_comes_to_rest_on_the_bed_and_presses_with_its_net_weight) {
  World world(over_bed());
  const BodyId block = add_floe(world, rectangle({-1, -1}, {1, 1}), kThick);
  world.set_state(block, {{0, 0, -0.6}, {}}, {});
  for (int i = 0; i < 200; ++i) step(world);
  BOOST_TEST(norm(from_bed(world, block) - Vec3{0, 0, kNet}) < 1e-6 * kNet);
  BOOST_TEST(norm(world.twist(block).linear) < 1e-7);
  // It fell 0.15 m. In its last step of the fall it may have passed the surface by the way of a step.
  const double sunk = -1.0 + 0.5 * kThick - world.pose(block).position.z;
  BOOST_TEST(sunk > 0.0);
  BOOST_TEST(sunk < kStep * std::sqrt(2.0 * 0.3 * kGravity * 0.16));
  BOOST_TEST(area_on_bed(world) == 4.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(without_a_bed_the_block_sinks) {
  WorldSettings deep = over_bed();
  deep.bed.reset();
  World world(deep);
  const BodyId block = add_block(world, 0.0);
  for (int i = 0; i < 100; ++i) step(world);
  BOOST_TEST(world.twist(block).linear.z == -0.3 * kGravity, kSolved);
  BOOST_TEST(world.contacts().empty());
}

BOOST_AUTO_TEST_CASE(friction_holds_a_block_up_to_its_bound_and_no_further) {
  for (const double share : {0.98, 1.5}) {
    World world(over_bed());
    const BodyId block = add_block(world, 0.0);
    for (int i = 0; i < 100; ++i) step(world, block, share * kFriction * kNet);
    const double slides = std::max(0.0, share - 1.0) * kFriction * kNet / kMass;  // m/s2
    BOOST_TEST(std::abs(speed(world, block) - 100 * kStep * slides) < 1e-6);
    BOOST_TEST(from_bed(world, block).x == -std::min(share, 1.0) * kFriction * kNet, kSolved);
    BOOST_TEST(from_bed(world, block).z == kNet, kSolved);
  }
}

BOOST_AUTO_TEST_CASE(the_bed_carries_a_stack_and_each_block_the_blocks_above_it) {
  for (const int n : {2, 3}) {
    World world(over_bed());
    std::vector<BodyId> stack;
    for (int layer = 0; layer < n; ++layer) stack.push_back(add_block(world, 0.0, layer));
    for (int i = 0; i < 50; ++i) step(world);
    BOOST_TEST(from_bed(world, stack[0]).z == n * kNet, kSolved);
    for (int layer = 1; layer < n; ++layer) {
      double below = 0.0;
      for (const ContactLoad& c : world.contacts())
        if (c.body == stack[layer - 1] && c.other == stack[layer]) below += c.normal_force;
      BOOST_TEST(below == (n - layer) * kNet, kSolved);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_stack_pushed_at_its_foot_slides_on_the_bed_and_pushed_at_its_top_between_the_blocks) {
  constexpr double kBetween = 0.3;  // friction of ice on ice
  for (const int n : {2, 3}) {
    // The top block slides off at 0.3 of its own net weight. The bed would hold the stack up to 0.4 of all.
    World top(over_bed()), foot(over_bed());
    for (World* world : {&top, &foot})
      for (int layer = 0; layer < n; ++layer) (void)add_block(*world, 0.0, layer);
    const BodyId uppermost = top.floes().back(), lowest = foot.floes().front();
    const double force = 1.2 * kBetween * kNet;
    for (int i = 0; i < 20; ++i) step(top, uppermost, force);
    BOOST_TEST(speed(top, uppermost) == 20 * kStep * (force - kBetween * kNet) / kMass,
               boost::test_tools::tolerance(1e-3));
    BOOST_TEST(std::abs(speed(top, top.floes().front())) < 1e-6);
    // The bed lets the foot go at 0.4 of all. Friction between the blocks takes the others along: 0.05 g' is less.
    const double held = kFriction * n * kNet, more = 0.05 * n * kNet;
    for (int i = 0; i < 20; ++i) step(foot, lowest, 0.98 * held);
    BOOST_TEST(std::abs(speed(foot, lowest)) < 1e-6);
    for (int i = 0; i < 20; ++i) step(foot, lowest, held + more);
    for (const BodyId block : foot.floes())
      BOOST_TEST(speed(foot, block) == 20 * kStep * more / (n * kMass), boost::test_tools::tolerance(1e-3));
  }
}

BOOST_AUTO_TEST_CASE(a_row_of_grounded_blocks_moves_when_the_friction_of_all_is_overcome) {
  for (const int n : {2, 4}) {
    const double holds = n * kFriction * kNet;
    for (const double share : {0.98, 1.2}) {
      World world(over_bed());
      for (int i = 0; i < n; ++i) (void)add_block(world, i * (2.0 - 1e-4));
      const BodyId first = world.floes().front(), last = world.floes().back();
      for (int i = 0; i < 50; ++i) step(world, first, share * holds);
      const double slides = std::max(0.0, share - 1.0) * holds / (n * kMass);
      BOOST_TEST(std::abs(speed(world, last) - 50 * kStep * slides) < 1e-4);
      BOOST_TEST(std::abs(speed(world, first) - 50 * kStep * slides) < 1e-4);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_bed_that_moves_carries_the_block_along) {
  const double velocity = 0.5, slides = velocity / (kFriction * 0.3 * kGravity);  // s
  World world(over_bed({velocity, 0.0}));
  const BodyId block = add_block(world, 0.0);
  double lost = 0.0, given = 0.0;
  for (int i = 0; i < std::lround(2.0 * slides / kStep); ++i) {
    step(world);
    const double time = (i + 1) * kStep;
    BOOST_TEST(std::abs(speed(world, block) - std::min(velocity, velocity * time / slides)) < 1e-6);
    for (const ContactLoad& c : world.contacts()) {
      lost -= kStep * friction_power(c);
      given += kStep * dot(force(c), c.body_velocity);
    }
  }
  // Friction has the mean velocity of the block and the bed against each other: half of its work is heat.
  const double kinetic = 0.5 * kMass * velocity * velocity;
  BOOST_TEST(given == kinetic, kSolved);
  BOOST_TEST(lost == kinetic, boost::test_tools::tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(a_corner_that_is_crushed_on_the_bed_carries_its_strength_times_its_area) {
  // Upright on an edge of length 0.5 m: depth d has the area 2 d times 0.5 m.
  World world(over_bed());
  const BodyId block = add_floe(world, rectangle({-1, -1}, {1, 1}), kThick);
  const double h = std::numbers::sqrt2, depth = 0.01;
  const Quaternion upright{std::sqrt(0.5), std::sqrt(0.5), 0, 0};
  const double a = kPi / 8;
  const Quaternion on_corner{std::cos(a), 0, 0, std::sin(a)};  // about the block's own normal, first
  const Quaternion turned{upright.w * on_corner.w - upright.z * on_corner.z, upright.x * on_corner.w,
                          -upright.x * on_corner.z, upright.w * on_corner.z};
  world.set_state(block, {{0, 0, -1.0 + h - depth}, turned}, {{0, 0, -1.0}, {}});
  world.step(1e-6);
  BOOST_TEST(area_on_bed(world) == 2.0 * depth * kThick, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(from_bed(world, block).z == kPressure * 2.0 * depth * kThick, boost::test_tools::tolerance(1e-9));
  for (const ContactLoad& c : world.contacts()) BOOST_TEST(c.at_bound);
}

BOOST_AUTO_TEST_CASE(the_parts_of_a_floe_share_its_area_on_the_bed) {
  const std::vector<std::vector<Vec2>> outline{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}};
  const std::vector<std::vector<Vec2>> parts{rectangle({0, 0}, {3, 1}), rectangle({0, 1}, {1, 2})};
  World world(over_bed());
  const PlacedPrism placed = place_prism(outline, parts, kThick, -1.0 + 0.5 * kThick - 1e-3);
  const BodyId floe = world.add_floe(placed.prism, mass_properties(placed.prism, kDensity, 0.0), placed.pose);
  for (int i = 0; i < 20; ++i) {
    world.apply(floe, {{0, 0, -kNet}, {}});
    world.step(kStep);
  }
  BOOST_TEST(from_bed(world, floe).z == kNet, kSolved);
  double area = 0.0;
  for (const ContactLoad& c : world.contacts()) area += c.area;
  BOOST_TEST(area == 4.0, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(norm(world.twist(floe).angular) < 1e-7);
}

BOOST_AUTO_TEST_CASE(a_floe_asleep_on_the_bed_has_no_contact_with_it_and_carries_another) {
  World world(over_bed());
  const BodyId lower = add_block(world, 0.0), upper = add_block(world, 0.5, 1);
  step(world);
  world.set_settled(lower, true);
  for (int i = 0; i < 20; ++i) step(world);
  BOOST_TEST((from_bed(world, lower) == Vec3{}));
  BOOST_TEST(norm(world.twist(upper).linear) < 1e-6);
  BOOST_TEST(total_normal_force(world) == kNet, kSolved);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
