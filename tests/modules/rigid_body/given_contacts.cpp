// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>

#include "brash/core/contract.hpp"
#include "helpers.hpp"

using namespace brash;
using namespace brash::rigid_body;
using namespace brash::rigid_body::testing;

namespace {

constexpr double kStep = 0.01;
constexpr double kMass = 5000.0;
const MassProperties kBlock{kMass, {4000.0, 5000.0, 6000.0}};

WorldSettings breakable() { return {.ice_structure = {0.1, 0.5e6}, .ice_ice = {0.3, 0.5e6}}; }

BodyId add_block(World& world, Vec3 velocity) {
  const std::vector<std::vector<Vec3>> hulls{box({-1, -1, -1}, {1, 1, 1})};
  return world.add_structure(hulls, {}, kBlock, {velocity, {}});
}

/// The edge of fixed ice before the block's front.
GivenContact edge(BodyId block, double force, double friction = 0.0) {
  return {.body = block,
          .point = {1, 0, 0},
          .normal = {-1, 0, 0},
          .area = 0.1,
          .most_normal_force = force,
          .friction = friction};
}

Vec3 angular_momentum(const World& world, BodyId id, const MassProperties& mass) {
  const Pose pose = world.pose(id);
  const Twist twist = world.twist(id);
  const Vec3 w = rotate(conjugate(pose.rotation), twist.angular);
  const Vec3 spin{mass.inertia.x * w.x, mass.inertia.y * w.y, mass.inertia.z * w.z};
  return rotate(pose.rotation, spin) + mass.mass * cross(pose.position, twist.linear);
}

}  // namespace

BOOST_AUTO_TEST_CASE(A_block_that_crushes_an_edge_stops_where_its_energy_is_spent) {
  // The edge bears k d at a depth d, so the block stops like a spring's load, at v sqrt(m / k).
  const double speed = 0.8, k = 2e5;
  double lost = 0.0;
  World world(breakable());
  const BodyId block = add_block(world, {speed, 0, 0});
  while (world.twist(block).linear.x > 1e-9 * speed) {
    const double depth = world.pose(block).position.x;
    world.add_contact(edge(block, k * depth));
    world.step(kStep);
    for (const ContactLoad& c : world.contacts()) lost -= kStep * normal_power(c);
  }
  // Semi-implicit Euler: the depth is found up to half a step's last travel, (omega dt)^2 / 8 of itself.
  BOOST_TEST(world.pose(block).position.x == speed * std::sqrt(kMass / k), boost::test_tools::tolerance(0.005));
  BOOST_TEST(lost == 0.5 * kMass * speed * speed, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(world.kinetic_energy(block) < 1e-9);
}

BOOST_AUTO_TEST_CASE(A_block_pushed_with_less_than_the_bound_stays) {
  World world(breakable());
  const BodyId block = add_block(world, {});
  for (int i = 0; i < 100; ++i) {
    world.apply(block, {{4000.0, 300.0, 0}, {0, 0, 300.0}});  // as if in the contact
    world.add_contact(edge(block, 9000.0, 0.1));
    world.step(kStep);
    BOOST_TEST_REQUIRE(world.contacts().size() == 1U);
    BOOST_TEST(world.contacts()[0].normal_force == 4000.0, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(!world.contacts()[0].at_bound);
    BOOST_TEST((world.contacts()[0].other == kNoBody));
    BOOST_TEST((world.contacts()[0].other_kind == BodyKind::kSheet));
  }
  // The solver ends when it changes no velocity by 1e-8 m/s.
  BOOST_TEST(norm(world.pose(block).position) < 1e-7);
  world.apply(block, {{14000.0, 0, 0}, {}});
  world.add_contact(edge(block, 9000.0));
  world.step(kStep);
  BOOST_TEST(world.contacts()[0].at_bound);
  BOOST_TEST(world.twist(block).linear.x == kStep * 5000.0 / kMass, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(A_contact_between_free_bodies_keeps_both_momenta) {
  World world(breakable());
  const BodyId block = add_block(world, {0.5, 0.2, 0});
  const BodyId floe = add_floe(world, rectangle({3, -1}, {6, 1}), 0.4, {{-0.4, 0, 0.1}, {}});
  const MassProperties ice{
      kDensity * 6 * 0.4,
      {kDensity * 2.4 * (4 + 0.16) / 12, kDensity * 2.4 * (9 + 0.16) / 12, kDensity * 2.4 * 13 / 12}};
  const Vec3 linear = kMass * world.twist(block).linear + ice.mass * world.twist(floe).linear;
  const Vec3 angular = angular_momentum(world, block, kBlock) + angular_momentum(world, floe, ice);
  world.add_contact({.body = block,
                     .other = floe,
                     .point = {2, 0.3, 0.1},
                     .normal = normalized(Vec3{-1, 0.1, 0.05}),
                     .area = 0.2,
                     .most_normal_force = 3e4,
                     .friction = 0.2});
  world.step(1e-9);  // bodies keep their places, so that the impulses' arms stay the same
  BOOST_TEST(world.contacts().size() == 1U);
  BOOST_TEST(norm(world.twist(floe).linear - Vec3{-0.4, 0, 0.1}) > 0.0);
  const Vec3 after = kMass * world.twist(block).linear + ice.mass * world.twist(floe).linear;
  const Vec3 turned = angular_momentum(world, block, kBlock) + angular_momentum(world, floe, ice);
  BOOST_TEST(norm(after - linear) < 1e-12 * norm(linear));
  // 1e-9 s of travel at 0.5 m/s beside an arm of metres.
  BOOST_TEST(norm(turned - angular) < 1e-9 * (1.0 + norm(angular)));
  BOOST_TEST((world.contacts()[0].body == block));
}

BOOST_AUTO_TEST_CASE(A_driven_structure_bears_the_bound_of_fixed_ice_while_it_closes_up) {
  World world(breakable());
  const BodyId cone = add_structure(world, box({-1, -1, -1}, {1, 1, 1}));
  const auto bears = [&](Vec3 velocity) {
    push(world, cone, velocity, kStep);
    world.add_contact(edge(cone, 7e4, 0.1));
    world.step(kStep);
    return world.contacts();
  };
  const auto closing = bears({1.2, 0.5, 0});
  BOOST_TEST_REQUIRE(closing.size() == 1U);
  BOOST_TEST(closing[0].normal_force == 7e4, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(norm(closing[0].friction_force - Vec3{0, -7e3, 0}) < 1e-8);
  BOOST_TEST(normal_power(closing[0]) == -7e4 * 1.2, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(world.twist(cone).linear.x == 1.2);
  BOOST_TEST(bears({-1.2, 0, 0}).empty());
  GivenContact rigid = edge(cone, 7e4);
  rigid.most_normal_force = std::numeric_limits<double>::infinity();
  BOOST_CHECK_THROW(world.add_contact(rigid), ContractViolation);
}

BOOST_AUTO_TEST_CASE(A_structure_with_mass_and_a_floe_exchange_momentum) {
  World world({});  // no bound: they meet like rigid bodies
  const std::vector<std::vector<Vec3>> hulls{box({-1, -1, -1}, {1, 1, 1})};
  const BodyId block = world.add_structure(hulls, {{-1.0005, 0, 0}, {}}, kBlock, {{0.6, 0, 0}, {}});
  const BodyId floe = add_floe(world, rectangle({0, -1}, {2, 1}), 0.4);
  const double ice = kDensity * 4 * 0.4;
  for (int i = 0; i < 20; ++i) world.step(kStep);
  BOOST_TEST(kMass * world.twist(block).linear.x + ice * world.twist(floe).linear.x == kMass * 0.6,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(world.twist(block).linear.x == kMass * 0.6 / (kMass + ice), boost::test_tools::tolerance(1e-5));
  BOOST_TEST((world.moving() == std::vector<BodyId>{floe}));
  BOOST_CHECK_THROW(world.move_structure(block, {}, {}), ContractViolation);
}
