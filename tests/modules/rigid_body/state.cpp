// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <limits>

#include "brash/core/contract.hpp"
#include "helpers.hpp"

using namespace brash;
using namespace brash::rigid_body;
using namespace brash::rigid_body::testing;

namespace {

WorldSettings breakable() { return {.ice_structure = {0.027, 0.5e6}, .ice_ice = {0.3, 0.5e6}}; }

/// Signed distances of `point` to the neighbours of `floe`, in their order.
std::vector<double> distances(World& world, BodyId floe, double reach, Vec3 point) {
  std::vector<double> found;
  world.visit_neighbours({&floe, 1}, reach, [&](BodyId visited, std::span<const Solid> solids) {
    BOOST_TEST((visited == floe));
    for (const Solid solid : solids) found.push_back(signed_distance(solid, point));
  });
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(A_free_floe_moves_by_the_loads_it_is_given) {
  World world(breakable());
  const BodyId floe = add_floe(world, rectangle({-1, -1}, {1, 1}), 0.5);
  const double mass = kDensity * 4 * 0.5;
  world.apply(floe, {{mass, 0, 0}, {}});
  world.apply(floe, {{0, 2 * mass, 0}, {0, 0, 3 * mass * 8 / 12}});
  world.step(0.1);
  // Semi-implicit Euler, Eqs. 7 to 10, for one step; loads do not last.
  BOOST_TEST(norm(world.twist(floe).linear - Vec3{0.1, 0.2, 0}) < 1e-15);
  BOOST_TEST(norm(world.twist(floe).angular - Vec3{0, 0, 0.3}) < 1e-15);
  BOOST_TEST(norm(world.pose(floe).position - Vec3{0.01, 0.02, 0}) < 1e-15);
  BOOST_TEST(2 * std::atan(world.pose(floe).rotation.z / world.pose(floe).rotation.w) == 0.03,
             boost::test_tools::tolerance(1e-12));
  world.step(0.1);
  BOOST_TEST(norm(world.twist(floe).linear - Vec3{0.1, 0.2, 0}) < 1e-15);
}

BOOST_AUTO_TEST_CASE(A_settled_floe_is_to_the_others_what_the_sheet_is_until_it_is_let_go) {
  World settled(breakable()), fixed(breakable());
  const BodyId rests = add_floe(settled, rectangle({-1, -1}, {1, 1}), 0.5);
  settled.set_settled(rests, true);
  fixed.add_sheet_part(rectangle({-1, -1}, {1, 1}), -0.25, 0.25);
  const Pose place = settled.pose(rests);
  std::vector<BodyId> comes;
  for (World* world : {&settled, &fixed})
    comes.push_back(add_floe(*world, rectangle({-3.1, -0.7}, {-1.1, 1.3}), 0.5, {{1.0, 0, 0}, {}}));
  for (int i = 0; i < 30; ++i) {
    settled.step(0.01);
    fixed.step(0.01);
    BOOST_TEST(total_normal_force(settled) == total_normal_force(fixed), boost::test_tools::tolerance(1e-6));
  }
  // Placed by a pose instead of by its corners, which rounds differently.
  BOOST_TEST(norm(settled.pose(comes[0]).position - fixed.pose(comes[1]).position) < 1e-9);
  BOOST_TEST((settled.pose(rests) == place));
  BOOST_TEST(settled.kinetic_energy(rests) == 0.0);

  settled.set_settled(rests, false);
  settled.apply(rests, {{kDensity * 4 * 0.5, 0, 0}, {}});
  settled.step(0.01);
  BOOST_TEST(settled.twist(rests).linear.x == 0.01, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(A_step_starts_where_the_one_before_it_ended_and_a_settled_floe_where_it_lies) {
  World world({.iterations = 100, .release_speed = 0.1});
  const BodyId moves = add_floe(world, rectangle({-1, -1}, {1, 1}), 0.5, {{0.5, 0, 0}, {}});
  const BodyId rests = add_floe(world, rectangle({59, -1}, {61, 1}), 0.5);
  world.set_settled(rests, true);
  for (int i = 0; i < 3; ++i) {
    const Pose before = world.pose(moves);
    world.step(0.01);
    BOOST_TEST((world.start_pose(moves) == before));
    BOOST_TEST((world.start_pose(rests) == world.pose(rests)));
  }
  world.set_settled(rests, false);
  BOOST_TEST((world.start_pose(rests) == world.pose(rests)));
  world.set_settled(moves, true);
  BOOST_TEST((world.start_pose(moves) == world.pose(moves)));
}

BOOST_AUTO_TEST_CASE(A_blow_goes_on_through_settled_floes_that_touch_as_far_as_it_is_fast) {
  // Equal floes in a row, each 0.4 mm into the next. The first moves, the others sleep. Without restitution n floes
  // take v / n each.
  const auto row = [](int n, double release_speed, double speed) {
    World world({.iterations = 1000, .release_speed = release_speed});
    for (int i = 0; i < n; ++i) {
      const double x = 1.9996 * i;
      const BodyId floe = add_floe(world, rectangle({x, 0}, {x + 2, 2}), 0.5);
      if (i > 0) world.set_settled(floe, true);
    }
    world.set_state(world.floes()[0], world.pose(world.floes()[0]), {{speed, 0, 0}, {}});
    world.step(0.01);
    return world;
  };
  const World three = row(3, 0.05, 0.3);
  // Iterations stop at changes below 1e-8 m/s.
  for (const BodyId floe : three.floes())
    BOOST_TEST(three.twist(floe).linear.x == 0.1, boost::test_tools::tolerance(1e-5));

  // The fourth would take v / 4 and the fifth would take v / 5. At v / 4 the blow is too slow to release the fifth.
  const World seven = row(7, 0.26 * 0.4, 0.4);
  const std::vector<BodyId> floes = seven.floes();
  for (std::size_t i = 0; i < floes.size(); ++i) BOOST_TEST(seven.is_settled(floes[i]) == (i >= 4));
}

BOOST_AUTO_TEST_CASE(The_floes_that_move_are_those_not_settled_in_the_order_of_their_ids) {
  WorldSettings settings = breakable();
  settings.release_speed = 0.1;
  World world(settings);
  const BodyId first = add_floe(world, rectangle({-1, -1}, {1, 1}), 0.5);
  world.add_sheet_part(rectangle({-9, -9}, {-8, -8}), -0.25, 0.25);
  const BodyId second = add_floe(world, rectangle({5, -1}, {7, 1}), 0.5);
  const BodyId third = add_floe(world, rectangle({1.001, -1}, {3, 1}), 0.5, {{-0.5, 0, 0}, {}});
  const auto moving = [&](std::vector<BodyId> ids) { return world.moving() == ids; };
  BOOST_TEST(moving({first, second, third}));
  world.set_settled(first, true);
  BOOST_TEST(moving({second, third}));
  world.set_settled(second, true);
  world.set_settled(second, true);
  BOOST_TEST(moving({third}));
  world.step(0.01);  // the third comes to overlap the first
  world.step(0.01);  // and runs into it
  BOOST_TEST(moving({first, third}));
  world.remove(third);
  world.remove(second);
  BOOST_TEST(moving({first}));
}

BOOST_AUTO_TEST_CASE(Floes_born_with_a_common_edge_stay_where_they_are) {
  // Wedges of a fan, turned each into its own principal axes, and the sheet behind them, as a crack leaves them.
  World world(breakable());
  std::vector<Vec2> arc;
  for (int i = 0; i <= 4; ++i) arc.push_back({3 * std::cos(-1.1 + 0.55 * i), 3 * std::sin(-1.1 + 0.55 * i)});
  std::vector<BodyId> floes;
  for (int i = 0; i < 4; ++i) floes.push_back(add_floe(world, {{0, 0}, arc[i], arc[i + 1]}, 0.33));
  for (int i = 0; i < 4; ++i) {
    const Vec2 a = arc[i], b = arc[i + 1];
    const std::vector<Vec2> ring{a, 2 * a, 2 * b, b};
    world.add_sheet_part(ring, -0.165, 0.165);
  }
  std::vector<Pose> poses;
  for (const BodyId id : floes) poses.push_back(world.pose(id));
  for (int i = 0; i < 100; ++i) world.step(0.01);
  BOOST_TEST(world.contacts().empty());
  for (std::size_t i = 0; i < floes.size(); ++i) BOOST_TEST((world.pose(floes[i]) == poses[i]));
  BOOST_TEST(world.kinetic_energy() == 0.0);
}

BOOST_AUTO_TEST_CASE(A_floe_between_cone_and_fixed_sheet_is_crushed_without_flying_off) {
  // Squeezed to a third of its length by a structure that does not yield: it may turn or be ground up in place, but
  // bounded forces give it no more than the speed of the structure and the work of crushing.
  World world(breakable());
  const BodyId structure = add_structure(world, cone(6.8, radians(61.4), 5.68, 3.4));
  const BodyId floe = add_floe(world, rectangle({6.95, -0.7}, {8.5, 0.7}), 0.33, {}, 0.5);
  world.add_sheet_part(rectangle({8.5, -5}, {12, 5}), -0.165, 0.165);
  double fastest = 0.0;
  for (int i = 0; i < 100; ++i) {
    push(world, structure, {1.2, 0, 0}, 0.01);
    const Twist twist = world.twist(floe);
    world.apply(floe, {-2000.0 * twist.linear, -1000.0 * twist.angular});
    BOOST_REQUIRE_NO_THROW(world.step(0.01));
    fastest = std::max(fastest, norm(world.twist(floe).linear));
  }
  BOOST_TEST_MESSAGE("fastest " << fastest << " m/s, at " << world.pose(floe).position.x << ' '
                                << world.pose(floe).position.z);
  BOOST_TEST(fastest < 5.0);  // the floe is turned under by the cone's side: twice its velocity and some
}

BOOST_AUTO_TEST_CASE(A_part_thinner_than_the_inset_has_mass_but_no_contact) {
  World world(breakable());
  add_structure(world, box({-1, -1, -1}, {0.5, 1, 1}));
  const BodyId thin = add_floe(world, rectangle({0, -0.5}, {0.008, 0.5}), 0.33, {{-1, 0, 0}, {}});
  world.step(0.01);
  BOOST_TEST(world.contacts().empty());
  BOOST_TEST(world.twist(thin).linear.x == -1.0);
}

BOOST_AUTO_TEST_CASE(A_removed_body_is_gone_and_its_id_is_not_given_again) {
  World world(breakable());
  const BodyId a = add_floe(world, rectangle({0, 0}, {1, 1}), 0.33);
  const BodyId b = add_floe(world, rectangle({2, 0}, {3, 1}), 0.33);
  world.step(0.01);
  world.remove(a);
  BOOST_TEST(!world.contains(a));
  BOOST_TEST(world.contains(b));
  BOOST_CHECK_THROW(world.pose(a), ContractViolation);
  BOOST_CHECK_THROW(world.remove(a), ContractViolation);
  BOOST_CHECK_THROW(world.apply(a, {}), ContractViolation);
  const BodyId c = add_floe(world, rectangle({0, 0}, {1, 1}), 0.33);
  BOOST_TEST((b < c));
  BOOST_TEST((world.floes() == std::vector<BodyId>{b, c}));
  world.step(0.01);
}

BOOST_AUTO_TEST_CASE(More_parts_than_the_broad_phase_began_with_find_their_contacts) {
  World world(breakable());
  std::vector<BodyId> floes;
  for (int i = 0; i < 1500; ++i) floes.push_back(add_floe(world, rectangle({2.0 * i, 0}, {2.0 * i + 1, 1}), 0.33));
  const double last = 2.0 * 1499 + 1;
  const BodyId wall = add_structure(world, box({last - 0.1, -1, -1}, {last + 1, 2, 1}));
  push(world, wall, {-1, 0, 0}, 0.01);
  world.step(0.01);
  BOOST_TEST(!world.contacts().empty());
  for (const ContactLoad& c : world.contacts()) BOOST_TEST((c.body == floes.back()));
  BOOST_TEST(world.twist(floes.back()).linear.x < 0.0);
}

BOOST_AUTO_TEST_CASE(Numbers_that_are_not_finite_are_broken_contracts) {
  World world(breakable());
  const BodyId floe = add_floe(world, rectangle({0, 0}, {1, 1}), 0.33);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(world.apply(floe, {{nan, 0, 0}, {}}), ContractViolation);
  BOOST_CHECK_THROW(world.set_state(floe, {{nan, 0, 0}, {}}, {}), ContractViolation);
  BOOST_CHECK_THROW(world.step(0.0), ContractViolation);
  BOOST_CHECK_THROW(world.step(nan), ContractViolation);
  world.apply(floe, {{1e308, 0, 0}, {}});
  world.apply(floe, {{1e308, 0, 0}, {}});
  BOOST_CHECK_EXCEPTION(world.step(10.0), ContractViolation, [](const ContractViolation& e) {
    return std::string(e.what()).find("state of body, 0") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(Neighbours_are_the_bodies_within_reach_where_they_are_now) {
  World world({});
  const BodyId floe = add_floe(world, rectangle({0, 0}, {2, 1}), 0.4);
  const BodyId other = add_floe(world, rectangle({2.1, 0}, {4, 1}), 0.4);
  world.add_sheet_part(rectangle({-3, 0}, {-0.2, 1}), -0.2, 0.2);
  add_structure(world, box({0, 1.5, -1}, {1, 2, 1}));
  const Vec3 corner{2, 0.5, 0};
  BOOST_TEST(distances(world, floe, 0.05, corner).empty());
  BOOST_TEST(distances(world, floe, 0.15, corner).size() == 1U);
  BOOST_TEST(distances(world, floe, 0.25, corner).size() == 2U);
  BOOST_TEST(distances(world, floe, 0.55, corner).size() == 3U);
  BOOST_TEST(distances(world, floe, 0.15, corner).front() == 0.1, boost::test_tools::tolerance(1e-12));  // rounding
  BOOST_TEST(distances(world, other, 0.15, {2.1, 0.5, 0}).front() == 0.1, boost::test_tools::tolerance(1e-12));

  // Of two at once, each has its own.
  std::vector<std::pair<BodyId, std::size_t>> visits;
  world.visit_neighbours(std::array{other, floe}, 0.25,
                         [&](BodyId id, std::span<const Solid> solids) { visits.emplace_back(id, solids.size()); });
  BOOST_TEST((visits == std::vector<std::pair<BodyId, std::size_t>>{{other, 1U}, {floe, 2U}}));

  // A step moves the other floe away, and the query follows.
  world.set_state(other, world.pose(other), {{5.0, 0.0, 0.0}, {}});
  world.step(0.01);
  BOOST_TEST(distances(world, floe, 0.16, corner).front() == 0.15, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(distances(world, floe, 0.14, corner).empty());
  world.remove(other);
  BOOST_TEST(distances(world, floe, 0.16, corner).empty());
}

BOOST_AUTO_TEST_CASE(The_order_of_neighbours_does_not_depend_on_the_order_of_insertion) {
  const std::vector<std::vector<Vec2>> rings{rectangle({2.1, 0}, {4, 1}), rectangle({-2, 0}, {-0.1, 1}),
                                             rectangle({0, 1.1}, {2, 3}), rectangle({0, -2}, {2, -0.1})};
  std::vector<std::vector<double>> seen;
  for (const bool reversed : {false, true}) {
    World world({});
    std::vector<std::vector<Vec2>> order = rings;
    if (reversed) std::reverse(order.begin(), order.end());
    for (const auto& ring : order) add_floe(world, ring, 0.4);
    const BodyId floe = add_floe(world, rectangle({0, 0}, {2, 1}), 0.4);
    seen.push_back(distances(world, floe, 0.2, {0.7, 0.2, 0}));
  }
  BOOST_TEST(seen[0].size() == 4U);
  BOOST_TEST(seen[0] == seen[1], boost::test_tools::per_element());
}

namespace {

/// A plate of 4 t with 10 t more along its normal.
MassProperties plate_with_water() {
  return {.mass = 4000.0, .inertia = {3000.0, 5000.0, 7000.0}, .added_across = 10000.0};
}

BodyId add_plate(World& world, const Quaternion& rotation, const Twist& twist) {
  const std::vector<std::vector<Vec2>> rings{rectangle({-1, -1}, {1, 1})};
  return world.add_floe(place_prism(rings, rings, 0.5, 0.0).prism, plate_with_water(), {{}, rotation}, twist);
}

const Quaternion kTilted{std::cos(0.3), std::sin(0.3) * 0.6, std::sin(0.3) * 0.8, 0.0};

}  // namespace

BOOST_AUTO_TEST_CASE(A_plate_with_added_mass_across_is_accelerated_by_direction) {
  World world(breakable());
  const BodyId plate = add_plate(world, kTilted, {});
  const Vec3 n = rotate(kTilted, {0, 0, 1}), along = rotate(kTilted, {1, 0, 0});
  world.apply(plate, {14000.0 * n + 4000.0 * along, {}});
  world.step(0.1);
  BOOST_TEST(norm(world.loaded_twist(plate).linear - 0.1 * (n + along)) < 1e-15);
  BOOST_TEST(world.kinetic_energy(plate) == 0.5 * 18000.0 * 0.01, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(A_plate_that_has_slept_knows_no_water_from_before) {
  // A blow may wake it before it meets the water again, also when a checkpoint came in between.
  const auto turned = [](bool had_stream) {
    World world(breakable());
    const BodyId plate = add_plate(world, kTilted, {});
    if (had_stream) world.set_stream(plate, {0.8, -0.3, 0.1});
    world.set_settled(plate, true);
    world.set_settled(plate, false);
    world.set_state(plate, world.pose(plate), {{1.0, 0.4, -0.7}, {0.5, -0.9, 0.3}});
    world.step(0.01);
    return world.twist(plate);
  };
  BOOST_TEST((turned(true) == turned(false)));
}

BOOST_AUTO_TEST_CASE(A_turning_plate_keeps_its_momentum_and_energy_against_the_water) {
  for (const Vec3 stream : {Vec3{}, Vec3{0.8, -0.3, 0.1}}) {
    World world(breakable());
    const BodyId plate = add_plate(world, kTilted, {{1.0, 0.4, -0.7}, {0.5, -0.9, 0.3}});
    world.set_stream(plate, stream);
    const auto against = [&] { return world.twist(plate).linear - stream; };
    const auto energy = [&] {
      return world.kinetic_energy(plate) +
             0.5 * dot(momentum(plate_with_water(), world.pose(plate), against()), against()) -
             0.5 * dot(momentum(plate_with_water(), world.pose(plate), world.twist(plate).linear),
                       world.twist(plate).linear);
    };
    const Vec3 before = momentum(plate_with_water(), world.pose(plate), against());
    double lost = 0.0;
    for (int i = 0; i < 500; ++i) {
      const double start = energy(), total = world.kinetic_energy(plate);
      world.step(0.01);
      lost += start - energy();
      BOOST_TEST(norm(momentum(plate_with_water(), world.pose(plate), against()) - before) <
                 1e-9);  // rounding, 500 steps
      if (stream == Vec3{}) BOOST_TEST(std::abs(world.gained_by_turning(plate)) < 1e-11 * total);
    }
    BOOST_TEST(norm(world.twist(plate).linear - Vec3{1.0, 0.4, -0.7}) > 0.1);  // it did turn
    // The implicit gyroscopic term takes some energy; the turn takes and gives none.
    BOOST_TEST(lost > -1e-8 * energy());
    BOOST_TEST(lost < 0.02 * energy());
  }
}

BOOST_AUTO_TEST_CASE(A_plate_that_goes_edge_on_turns_its_face_to_the_stream) {
  // A plate that goes along its plane but for a small angle b, with the masses m and m + A: Munk's moment gives
  // I a'' = k^2 I (a + A/m b) with k^2 = A m / (m + A) v^2 / I, so a = b ((1 + A/m) cosh(k t) - A/m).
  World world(breakable());
  const double angle = 1e-4, speed = 0.5, dt = 1e-3;
  const BodyId plate = add_plate(world, {std::cos(0.5 * angle), std::sin(0.5 * angle), 0.0, 0.0}, {{0, speed, 0}, {}});
  for (int i = 0; i < 1000; ++i) world.step(dt);
  const double k = speed * std::sqrt(10000.0 * 4000.0 / 14000.0 / 3000.0);
  BOOST_TEST(2.0 * std::asin(world.pose(plate).rotation.x) == angle * (3.5 * std::cosh(k) - 2.5),
             boost::test_tools::tolerance(2e-3));  // first order in the step
}
