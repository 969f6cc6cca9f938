// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "brash/core/sha256.hpp"
#include "brash/core/workers.hpp"
#include "helpers.hpp"

using namespace brash;
using namespace brash::rigid_body;
using namespace brash::rigid_body::testing;

namespace {

constexpr double kStep = 0.01;

/// A cone runs into three layers of 14 x 8 floes in front of fixed ice. Some are asleep until they are hit, two are
/// linked, and one is moored.
struct Pile {
  explicit Pile(int n_workers)
      : workers(n_workers), world({.ice_structure = {0.027, 0.5e6}, .ice_ice = {0.3, 0.5e6}, .release_speed = 0.05}) {
    world.share_work(workers);
    for (int layer = 0; layer < 3; ++layer)
      for (int i = 0; i < 14; ++i)
        for (int j = 0; j < 8; ++j) {
          const Vec2 at{6.7 + 1.0 * i + 0.3 * layer, -4.0 + 1.0 * j + 0.2 * layer};
          const BodyId floe = add_floe(world, rectangle(at, at + Vec2{0.995, 0.995}), 0.33);
          Pose pose = world.pose(floe);
          pose.position.z = -0.32 * layer;
          pose.rotation = {std::sqrt(1.0 - 2e-4), 0.01 * ((i + j) % 3 - 1), 0.01 * ((i + 2 * j) % 3 - 1), 0.0};
          world.set_state(floe, pose, {{0.1 * std::sin(i), 0.1 * std::cos(j), 0.0}, {}});
          floes.push_back(floe);
        }
    for (std::size_t i = 60; i < 75; ++i) world.set_settled(floes[i], true);
    world.link({floes[30], {0.5, 0, 0}}, {floes[38], {-0.5, 0, 0}});
    world.moor({floes[90], {}}, world.pose(floes[90]).position, {1e5, 1e3});
    structure = add_structure(world, cone(6.8, radians(61.4), 5.68, 3.4));
    world.add_sheet_part(rectangle({20.9, -6}, {24, 0}), -0.165, 0.165);
    world.add_sheet_part(rectangle({20.9, 0}, {24, 6}), -0.165, 0.165);
  }

  void step() {
    push(world, structure, {1.2, 0.1, 0}, kStep);
    for (const BodyId id : world.moving()) world.apply(id, {{0, 0, -9000.0 * world.pose(id).position.z}, {}});
    world.step(kStep);
  }

  /// Of all numbers that a step leaves.
  std::string hash() const {
    std::string bytes;
    const auto add = [&](const auto& value) {
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);  // NOLINT: bytes are what is compared
    };
    for (const BodyId id : floes) {
      add(world.pose(id));
      add(world.twist(id));
    }
    for (const ContactLoad& c : world.contacts())
      for (const Vec3 v : {c.point, c.normal, c.friction_force, c.body_velocity, Vec3{c.normal_force, c.area, c.loss}})
        add(v);
    for (const LinkLoad& link : world.links()) add(link.force);
    add(world.last_change());
    return sha256(bytes);
  }

  Workers workers;
  World world;
  std::vector<BodyId> floes;
  BodyId structure;
};

}  // namespace

BOOST_AUTO_TEST_CASE(No_byte_of_a_pile_depends_on_the_number_of_threads) {
  Pile alone(1), two(2), three(3), eight(8);
  const std::size_t n_asleep = alone.floes.size() - alone.world.moving().size();
  for (int i = 0; i < 40; ++i) {
    alone.step();
    const std::string hash = alone.hash();
    for (Pile* pile : {&two, &three, &eight}) {
      pile->step();
      BOOST_REQUIRE_MESSAGE(pile->hash() == hash, pile->workers.count() << " threads part in step " << i);
    }
  }
  BOOST_TEST(alone.world.contacts().size() > 500u);
  BOOST_TEST(alone.floes.size() - alone.world.moving().size() < n_asleep);  // some were hit
}

BOOST_AUTO_TEST_CASE(The_number_of_threads_may_change_between_two_steps) {
  Pile alone(1), changing(1);
  std::array<Workers, 3> others{Workers(2), Workers(3), Workers(8)};
  for (std::size_t i = 0; i < 9; ++i) {
    changing.world.share_work(others[i % 3]);
    alone.step();
    changing.step();
    BOOST_REQUIRE(alone.hash() == changing.hash());
  }
}

BOOST_AUTO_TEST_CASE(Threads_visit_the_neighbours_of_each_floe_once) {
  Pile alone(1), eight(8);
  for (Pile* pile : {&alone, &eight}) pile->step();
  const auto seen = [](Pile& pile) {
    std::vector<std::size_t> n(pile.floes.size(), 0);
    pile.world.visit_neighbours(pile.world.moving(), 0.1, [&](BodyId floe, std::span<const Solid> solids) {
      n[floe.index] += 1 + solids.size();
    });
    return n;
  };
  const std::vector<std::size_t> of_one = seen(alone);
  BOOST_TEST(of_one == seen(eight), boost::test_tools::per_element());
  BOOST_TEST(of_one[40] > 4u);
}
