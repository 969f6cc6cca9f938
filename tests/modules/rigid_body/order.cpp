// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <cstring>
#include <map>
#include <tuple>

#include "helpers.hpp"

using namespace brash;
using namespace brash::rigid_body;
using namespace brash::rigid_body::testing;

namespace {

constexpr double kStep = 0.01;

/// A floe of the scene: its plan ring and the parts of it.
struct Piece {
  std::vector<Vec2> ring;
  std::vector<std::vector<Vec2>> parts;
};

/// A cone runs into 5 x 6 floes, some L-shaped (two parts), against a fixed edge.
struct Scene {
  explicit Scene(bool backwards) : world({.ice_structure = {0.027, 0.5e6}, .ice_ice = {0.3, 0.5e6}}) {
    std::vector<Piece> pieces;
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 6; ++j) pieces.push_back(piece({6.9 + 1.02 * i, -3.06 + 1.02 * j}, (i + j) % 3 == 0));
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const std::size_t which = backwards ? pieces.size() - 1 - k : k;
      if (backwards && k == 7) add_fixed();
      const std::vector<std::vector<Vec2>> rings{pieces[which].ring};
      const PlacedPrism placed = place_prism(rings, pieces[which].parts, 0.33, 0.0);
      floes[which] = world.add_floe(placed.prism, mass_properties(placed.prism, kDensity, 0.5), placed.pose);
    }
    if (!backwards) add_fixed();
  }

  static Piece piece(Vec2 at, bool l_shaped) {
    if (!l_shaped) return {rectangle(at, at + Vec2{1, 1}), {rectangle(at, at + Vec2{1, 1})}};
    return {{at, at + Vec2{1, 0}, at + Vec2{1, 0.5}, at + Vec2{0.5, 0.5}, at + Vec2{0.5, 1}, at + Vec2{0, 1}},
            {rectangle(at, at + Vec2{1, 0.5}), rectangle(at + Vec2{0, 0.5}, at + Vec2{0.5, 1})}};
  }

  void add_fixed() {
    structure = add_structure(world, cone(6.8, radians(61.4), 5.68, 3.4));
    world.add_sheet_part(rectangle({12.1, -5}, {16, 0}), -0.165, 0.165);
    world.add_sheet_part(rectangle({12.1, 0}, {16, 5}), -0.165, 0.165);
  }

  void step() {
    push(world, structure, {1.2, 0.1, 0}, kStep);
    for (const auto& [which, id] : floes) {
      const Pose pose = world.pose(id);
      world.apply(id, {{0, 0, -9000.0 * pose.position.z}, {}});
    }
    world.step(kStep);
  }

  bool same_as(const Scene& other) const {
    for (const auto& [which, id] : floes) {
      const Pose p = world.pose(id), q = other.world.pose(other.floes.at(which));
      const Twist s = world.twist(id), t = other.world.twist(other.floes.at(which));
      if (std::memcmp(&p, &q, sizeof p) != 0 || std::memcmp(&s, &t, sizeof s) != 0) return false;
    }
    return true;
  }

  World world;
  std::map<std::size_t, BodyId> floes;
  BodyId structure;
};

}  // namespace

BOOST_AUTO_TEST_CASE(The_order_of_insertion_does_not_change_a_bit_of_a_trajectory) {
  Scene forwards(false);
  Scene backwards(true);
  std::size_t contacts = 0;
  for (int i = 0; i < 300; ++i) {
    forwards.step();
    backwards.step();
    contacts += forwards.world.contacts().size();
    BOOST_REQUIRE_MESSAGE(forwards.same_as(backwards), "the trajectories part in step " << i);
  }
  BOOST_TEST(contacts > 10000u);
}

BOOST_AUTO_TEST_CASE(A_world_rebuilt_from_poses_and_velocities_goes_on_to_the_same_bits) {
  Scene original(false);
  for (int i = 0; i < 120; ++i) original.step();
  Scene resumed(true);
  resumed.world.set_state(resumed.structure, original.world.pose(original.structure), {});
  for (const auto& [which, id] : original.floes)
    resumed.world.set_state(resumed.floes[which], original.world.pose(id), original.world.twist(id));
  for (int i = 0; i < 120; ++i) {
    original.step();
    resumed.step();
    BOOST_REQUIRE_MESSAGE(original.same_as(resumed), "the trajectories part in step " << i);
  }
}

BOOST_AUTO_TEST_CASE(Contacts_are_reported_in_the_order_of_their_bodies_and_points) {
  Scene scene(true);
  for (int i = 0; i < 100; ++i) scene.step();
  const auto& contacts = scene.world.contacts();
  BOOST_TEST(contacts.size() > 10u);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ContactLoad& c = contacts[i];
    BOOST_TEST((scene.world.kind(c.body) == BodyKind::kFloe));
    if (scene.world.kind(c.other) == BodyKind::kFloe) BOOST_TEST((c.body < c.other));
    BOOST_TEST(norm(c.normal) == 1.0, boost::test_tools::tolerance(1e-12));
    if (i == 0) continue;
    const ContactLoad& b = contacts[i - 1];
    const auto sheet_is_one = [](const ContactLoad& l) { return l.other_kind == BodyKind::kSheet ? kNoBody : l.other; };
    const BodyId before = sheet_is_one(b), now = sheet_is_one(c);
    BOOST_TEST((b.body < c.body || (b.body == c.body && (before < now || before == now))));
    if (b.body == c.body && before == now)
      BOOST_TEST((std::tie(b.point.x, b.point.y, b.point.z) <= std::tie(c.point.x, c.point.y, c.point.z)));
  }
}
