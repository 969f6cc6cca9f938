// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>

#include "brash/core/contract.hpp"
#include "helpers.hpp"

using namespace brash;
using namespace brash::rigid_body;
using namespace brash::rigid_body::testing;

namespace {

// Fifty sequential impulses on the four points of a face leave about 2e-6 of velocities of 1 m/s.
constexpr double kSolver = 1e-5;

WorldSettings rigid(double friction, double restitution) {
  WorldSettings settings;
  settings.ice_structure = {.friction = friction};
  settings.ice_ice = settings.ice_structure;
  settings.restitution = restitution;
  return settings;
}

Vec3 momentum(const World& world, BodyId floe, double mass) { return mass * world.twist(floe).linear; }

/// Angular momentum about the origin.
Vec3 angular_momentum(const World& world, BodyId floe, const MassProperties& m) {
  const Pose pose = world.pose(floe);
  const Twist twist = world.twist(floe);
  const Vec3 w = rotate(conjugate(pose.rotation), twist.angular);
  return rotate(pose.rotation, {m.inertia.x * w.x, m.inertia.y * w.y, m.inertia.z * w.z}) +
         cross(pose.position, m.mass * twist.linear);
}

}  // namespace

BOOST_AUTO_TEST_CASE(The_impulse_of_an_unbounded_impact_is_the_momentum_it_takes) {
  for (const double dt : {0.02, 0.001}) {
    World world(rigid(0.0, 0.0));
    add_structure(world, box({-1, -2, -1}, {0.0, 2, 1}));
    const BodyId floe = add_floe(world, rectangle({0.0005, -1}, {2.0005, 1}), 0.3, {{-1.5, 0, 0}, {}});
    double impulse = 0.0;
    for (int i = 0; i < 5; ++i) {
      world.step(dt);
      impulse += dt * total_normal_force(world);
    }
    BOOST_TEST(impulse == 1.5 * kDensity * 4 * 0.3, boost::test_tools::tolerance(kSolver));
    BOOST_TEST(norm(world.twist(floe).linear) < kSolver);
  }
}

BOOST_AUTO_TEST_CASE(A_floe_rebounds_with_the_coefficient_of_restitution) {
  for (const double e : {0.0, 0.3, 1.0}) {
    World world(rigid(0.0, e));
    add_structure(world, box({-1, -2, -1}, {0.0005, 2, 1}));
    const BodyId floe = add_floe(world, rectangle({0, -1}, {2, 1}), 0.3, {{-1.0, 0, 0}, {}});
    world.step(0.01);
    BOOST_TEST(std::abs(world.twist(floe).linear.x - e) < kSolver);
  }
}

BOOST_AUTO_TEST_CASE(Two_floes_keep_their_momentum_and_angular_momentum) {
  for (const bool breakable : {false, true}) {
    WorldSettings settings = rigid(0.3, 0.2);
    if (breakable) settings.ice_ice.crushing_pressure = 0.5e6;
    World world(settings);
    const std::vector<std::vector<Vec2>> plan_a{{{0, 0}, {2, 0.1}, {1.6, 1.4}, {0.2, 1.1}}};
    const std::vector<std::vector<Vec2>> plan_b{{{2.0, -0.4}, {4, 0.0}, {3.5, 1.8}, {1.9, 1.2}}};
    std::vector<BodyId> floes;
    std::vector<MassProperties> masses;
    for (const auto& plan : {plan_a, plan_b}) {
      const PlacedPrism placed = place_prism(plan, plan, 0.33, floes.empty() ? 0.0 : 0.1);
      masses.push_back(mass_properties(placed.prism, kDensity, 0.0));
      const double way = floes.empty() ? 1.0 : -1.0;
      floes.push_back(
          world.add_floe(placed.prism, masses.back(), placed.pose, {{way, 0.3 * way, 0.1}, {0.2, -0.1 * way, 0.5}}));
    }
    const Vec3 p0 = momentum(world, floes[0], masses[0].mass) + momentum(world, floes[1], masses[1].mass);
    const Vec3 l0 = angular_momentum(world, floes[0], masses[0]) + angular_momentum(world, floes[1], masses[1]);
    // Impulses act as if the bodies stood still during the solve, so angular momentum is compared with the bodies where
    // they were: at once after one step of vanishing length.
    const double dt = 1e-9;
    std::size_t contacts = 0;
    for (int i = 0; i < 3; ++i) {
      world.step(dt);
      contacts += world.contacts().size();
    }
    BOOST_TEST(contacts > 0u);
    const Vec3 p = momentum(world, floes[0], masses[0].mass) + momentum(world, floes[1], masses[1].mass);
    const Vec3 l = angular_momentum(world, floes[0], masses[0]) + angular_momentum(world, floes[1], masses[1]);
    // Round-off of momenta of 1000 N s; moving 1e-9 s turns the moment of momentum by 1e-9 of it.
    BOOST_TEST(norm(p - p0) < 1e-9);
    // Where ice does not break, the split impulse moves the bodies, and the moments of their momenta with them.
    if (breakable) BOOST_TEST(norm(l - l0) < 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(A_structure_with_mass_and_a_floe_exchange_momentum) {
  constexpr double kMass = 5000.0;
  const MassProperties mass{kMass, {4000.0, 5000.0, 6000.0}};
  World world({});  // no bound: they meet like rigid bodies
  const std::vector<std::vector<Vec3>> hulls{box({-1, -1, -1}, {1, 1, 1})};
  const BodyId block = world.add_structure(hulls, {{-1.0005, 0, 0}, {}}, mass, {{0.6, 0, 0}, {}});
  const BodyId floe = add_floe(world, rectangle({0, -1}, {2, 1}), 0.4);
  const double ice = kDensity * 4 * 0.4;
  for (int i = 0; i < 20; ++i) world.step(0.01);
  BOOST_TEST(kMass * world.twist(block).linear.x + ice * world.twist(floe).linear.x == kMass * 0.6,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(world.twist(block).linear.x == kMass * 0.6 / (kMass + ice), boost::test_tools::tolerance(1e-5));
  BOOST_TEST((world.moving() == std::vector<BodyId>{floe}));
  BOOST_CHECK_THROW(world.move_structure(block, {}, {}), ContractViolation);
}

BOOST_AUTO_TEST_CASE(A_floe_slides_to_rest_at_mu_g_and_then_stays) {
  const double mu = 0.3;
  const double dt = 0.01;
  World world(rigid(mu, 0.0));
  add_structure(world, box({-20, -5, -2}, {20, 5, -0.15}));
  const double mass = kDensity * 4 * 0.3;
  const BodyId floe = add_floe(world, rectangle({-1, -1}, {1, 1}), 0.3, {{1.2, 1.6, 0}, {}});
  const double stop = 2.0 / (mu * kGravity);
  // Once more than the surfaces touch, the contact holds the weight; the first step finds no overlap yet.
  for (int i = 0; i < std::lround(0.5 * stop / dt); ++i) {
    world.apply(floe, {{0, 0, -mass * kGravity}, {}});
    world.step(dt);
  }
  const Vec3 v = world.twist(floe).linear;
  // Speed 2 m/s less mu g t, along (0.6, 0.8), within the two steps at which contact begins.
  BOOST_TEST(std::hypot(v.x, v.y) == 1.0, boost::test_tools::tolerance(2 * mu * kGravity * dt));
  BOOST_TEST(v.y / v.x == 4.0 / 3.0, boost::test_tools::tolerance(1e-3));
  for (int i = 0; i < 100; ++i) {
    world.apply(floe, {{0, 0, -mass * kGravity}, {}});
    world.step(dt);
  }
  BOOST_TEST(norm(world.twist(floe).linear) < 1e-6);
}

BOOST_AUTO_TEST_CASE(Floes_that_do_not_break_lie_still_on_each_other) {
  const double dt = 0.02, thickness = 0.3;
  WorldSettings settings = rigid(0.3, 0.0);
  settings.iterations = 50;
  World world(settings);
  const BodyId bed = add_structure(world, box({-5, -5, -2}, {5, 5, -0.5 * thickness}));
  std::vector<BodyId> floes;
  for (int i = 0; i < 5; ++i) {
    const std::vector<std::vector<Vec2>> rings{rectangle({-1, -1}, {1, 1})};
    PlacedPrism placed = place_prism(rings, rings, thickness, 0.0);
    placed.pose.position.z += i * thickness;
    floes.push_back(world.add_floe(placed.prism, mass_properties(placed.prism, kDensity, 0.0), placed.pose, {}));
  }
  const double weight = kDensity * 4 * thickness * kGravity;
  for (int step = 0; step < 200; ++step) {
    for (const BodyId floe : floes) world.apply(floe, {{0, 0, -weight}, {}});
    world.step(dt);
    if (step < 100) continue;
    double on_bed = 0.0;
    for (const ContactLoad& c : world.contacts())
      if (c.other == bed) on_bed += c.normal_force;
    BOOST_TEST(on_bed == 5 * weight, boost::test_tools::tolerance(0.01));
  }
  // Each floe has kept its overlap with the floe below.
  for (int i = 0; i < 5; ++i) BOOST_TEST(std::abs(world.pose(floes[i]).position.z - i * thickness) < (i + 1) * 1e-3);
}

BOOST_AUTO_TEST_CASE(Friction_stays_in_the_disc_of_mu_times_the_actual_normal_force) {
  // A bound far below the pressure that the wall would need, oblique slip that turns during the solve, eccentric hits.
  WorldSettings settings;
  settings.ice_structure = {.friction = 0.25, .crushing_pressure = 0.2e6};
  settings.ice_ice = settings.ice_structure;
  World world(settings);
  const BodyId wall = add_structure(world, cone(6.8, radians(61.4), 5.68, 3.4));
  for (int i = -2; i <= 2; ++i)
    add_floe(world, rectangle({6.9 - 0.1 * i * i, 1.1 * i - 0.5}, {9, 1.1 * i + 0.5}), 0.33,
             {{0, 0.5, 0}, {0, 0, 0.3}});
  double sliding = 0;
  for (int i = 0; i < 100; ++i) {
    push(world, wall, {1.2, 0.4, 0}, 0.01);
    world.step(0.01);
    for (const ContactLoad& c : world.contacts()) {
      const double friction = norm(c.friction_force);
      const double limit = 0.25 * c.normal_force;
      // Round-off of a force of 1e5 N.
      BOOST_TEST(friction <= limit + 1e-9);
      BOOST_TEST(std::abs(dot(c.friction_force, c.normal)) <= 1e-9 + 1e-9 * friction);
      BOOST_TEST(c.normal_force <= 0.2e6 * c.area * (1 + 1e-12));
      if (limit > 1.0 && friction > 0.999 * limit) ++sliding;
    }
  }
  BOOST_TEST(sliding > 50);
}

BOOST_AUTO_TEST_CASE(The_reported_loads_are_the_change_of_momentum) {
  WorldSettings settings;
  settings.ice_structure = {.friction = 0.25, .crushing_pressure = 0.3e6};
  settings.restitution = 0.1;
  settings.ice_ice = settings.ice_structure;
  World world(settings);
  const BodyId wall = add_structure(world, cone(6.8, radians(61.4), 5.68, 3.4));
  const std::vector<std::vector<Vec2>> plan{{{6.9, -0.9}, {8.1, -0.4}, {8.3, 0.8}, {7.0, 1.1}}};
  const PlacedPrism placed = place_prism(plan, plan, 0.33, 0.0);
  const MassProperties m = mass_properties(placed.prism, kDensity, 0.5);
  const BodyId floe = world.add_floe(placed.prism, m, placed.pose, {{0, 0.4, 0}, {0, 0, 0.2}});
  const double dt = 0.01;
  std::size_t contacts = 0;
  for (int i = 0; i < 60; ++i) {
    push(world, wall, {1.2, 0, 0}, dt);
    const Pose pose = world.pose(floe);
    const Vec3 p = momentum(world, floe, m.mass);
    const Vec3 spin = angular_momentum(world, floe, m) - cross(pose.position, p);
    world.step(dt);
    Vec3 force{};
    Vec3 moment{};
    for (const ContactLoad& c : world.contacts()) {
      const Vec3 f = c.normal_force * c.normal + c.friction_force;
      force += f;
      moment += cross(c.point - pose.position, f);
    }
    // Round-off of momenta of 1000 N s.
    BOOST_TEST(norm(momentum(world, floe, m.mass) - p - dt * force) < 1e-9);
    // The inertia turns with the floe after the impulses: w x I w dt of a moment of momentum of 100 N m s at 1 rad/s.
    const Vec3 new_spin =
        angular_momentum(world, floe, m) - cross(world.pose(floe).position, momentum(world, floe, m.mass));
    BOOST_TEST(norm(new_spin - spin - dt * moment) < 0.0005 * (1.0 + norm(new_spin)));
    contacts += world.contacts().size();
  }
  BOOST_TEST(contacts > 20u);
}

BOOST_AUTO_TEST_CASE(The_work_of_the_contacts_of_two_floes_is_the_change_of_their_kinetic_energy) {
  for (const double e : {0.0, 0.4}) {
    WorldSettings settings;
    settings.ice_ice = {.friction = 0.3, .crushing_pressure = 0.2e6};
    settings.restitution = e;
    World world(settings);
    // No spin before the impact, so that only contacts change energies. The second is born first: a pair is turned.
    const BodyId second = add_floe(world, rectangle({1.99, 0.3}, {4, 1.6}), 0.33, {{-1.2, 0.1, 0.05}, {}});
    const BodyId first = add_floe(world, rectangle({0, 0}, {2, 1}), 0.25, {{0.8, -0.4, 0}, {}}, 0.5);
    const double energy = world.kinetic_energy();
    const double energy_of_first = world.kinetic_energy(first);
    const double dt = 0.01;
    world.step(dt);
    BOOST_REQUIRE(!world.contacts().empty());
    double work = 0.0;
    double work_on_first = 0.0;
    double friction = 0.0;
    for (const ContactLoad& c : world.contacts()) {
      BOOST_TEST((c.body == second && c.other == first));
      BOOST_TEST(normal_power(c) <= 0.0);
      friction += friction_power(c);
      work += dt * (normal_power(c) + friction_power(c));
      work_on_first -= dt * dot(c.normal_force * c.normal + c.friction_force, c.other_velocity);
    }
    BOOST_TEST(work < -1.0);
    BOOST_TEST(friction < 0.0);  // of all points: the others may turn the slip of one against its friction
    // Round-off of energies of 500 J.
    BOOST_TEST(std::abs(world.kinetic_energy() - energy - work) < 1e-9);
    BOOST_TEST(std::abs(world.kinetic_energy(first) - energy_of_first - work_on_first) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(Loads_contacts_and_a_moving_structure_work_at_the_mean_of_the_velocities_of_the_step) {
  WorldSettings settings;
  settings.ice_structure = {.friction = 0.25, .crushing_pressure = 0.3e6};
  settings.restitution = 0.1;
  settings.iterations = 200;  // enough for top and bottom to bear the same: otherwise the floe begins to pitch
  World world(settings);
  const BodyId wall = add_structure(world, box({-1, -2, -1}, {0.0, 2, 1}));
  // Round in the plan's axes and spun about the vertical only: no gyroscopic moment, whose numerical loss is no work.
  const BodyId floe = add_floe(world, rectangle({0.001, -1}, {2.001, 1}), 0.3, {{-0.5, 0.2, 0}, {0, 0, 0.4}});
  const double dt = 0.01;
  const Vec3 velocity{0.7, 0, 0};
  double given = 0.0;
  double lost = 0.0;
  const double before = world.kinetic_energy();
  for (int i = 0; i < 20; ++i) {
    const Wrench load{{-900.0, 150.0, 0.0}, {0.0, 0.0, 120.0}};
    world.apply(floe, load);
    push(world, wall, velocity, dt);
    world.step(dt);
    const Twist mean = world.mean_twist(floe);
    given += dt * (dot(load.force, mean.linear) + dot(load.moment, mean.angular));
    for (const ContactLoad& c : world.contacts()) {
      BOOST_TEST((c.other_velocity == velocity));
      given += dt * dot(c.normal_force * c.normal + c.friction_force, velocity);
      lost -= dt * (normal_power(c) + friction_power(c));
    }
  }
  BOOST_TEST(lost > 10.0);
  // Round-off of 20 sums of 500 J; the faces are vertical to rounding.
  BOOST_TEST(std::abs(world.kinetic_energy() - before - given + lost) < 1e-8);
}

BOOST_AUTO_TEST_CASE(A_floe_that_tumbles_by_more_than_a_radian_in_a_step_gains_no_energy) {
  for (const double rate : {1.0, 10.0, 30.0, 60.0, 120.0}) {  // 0.05 to 6 rad in a step
    World world(WorldSettings{});
    add_floe(world, rectangle({0, 0}, {0.3, 0.15}), 0.05, {{}, rate * Vec3{0.6, 0.5, 0.4}});
    double energy = world.kinetic_energy();
    for (int i = 0; i < 100; ++i) {
      world.step(0.05);
      BOOST_TEST(world.kinetic_energy() <= energy * (1.0 + 1e-9));  // rounding
      energy = world.kinetic_energy();
    }
  }
}

BOOST_AUTO_TEST_CASE(The_gyroscopic_moment_hands_on_what_loads_give_a_spinning_floe) {
  World world(WorldSettings{});
  const Vec3 moment{0.4, -0.3, 0.2};
  const double dt = 0.05;
  const BodyId free = add_floe(world, rectangle({0, 0}, {0.3, 0.15}), 0.05, {{}, {9.0, 6.0, -4.0}});
  const BodyId loaded = add_floe(world, rectangle({9, 0}, {9.3, 0.15}), 0.05, {{}, {9.0, 6.0, -4.0}});
  const double before = world.kinetic_energy(loaded);
  world.apply(loaded, {{}, moment});
  world.step(dt);
  BOOST_TEST(world.gyroscopic_share(free) == 0.0);
  // The floe without a load shows the effect of the moment alone.
  const double lost = before - world.kinetic_energy(free);
  const double work = dt * dot(moment, world.mean_twist(loaded).angular);
  BOOST_TEST(std::abs(world.gyroscopic_share(loaded)) > 0.01 * work);
  BOOST_TEST(world.kinetic_energy(loaded) - before == work + world.gyroscopic_share(loaded) - lost,
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(Contacts_between_floes_take_energy_and_leave_momentum) {
  for (const auto& [pressure, restitution] : {std::pair{0.05e6, 0.0}, {0.5e6, 0.0}, {0.05e6, 0.5}, {0.5e6, 0.5}}) {
    WorldSettings settings;
    settings.ice_ice = {.friction = 0.3, .crushing_pressure = pressure};
    settings.restitution = restitution;
    World world(settings);
    const double mass = kDensity * 0.33 * 0.98 * 0.98;
    // Six by six floes drawn together, with spins and heaves of all signs.
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        add_floe(world, rectangle({1.0 * i, 1.0 * j}, {i + 0.98, j + 0.98}), 0.33,
                 {{0.4 * (2.5 - i), 0.3 * (2.5 - j), 0.1 * ((i * 5 + j * 3) % 5 - 2)},
                  {0.2 * ((i + j) % 3 - 1), 0.2 * ((i * j) % 3 - 1), 0.5 * ((i + 2 * j) % 3 - 1)}});
    const auto sum = [&] {
      Vec3 p{};
      for (const BodyId id : world.floes()) p += momentum(world, id, mass);
      return p;
    };
    const Vec3 before = sum();
    double energy = world.kinetic_energy();
    const double first = energy;
    for (int i = 0; i < 200; ++i) {
      world.step(0.01);
      // Each impulse takes energy or none. The tolerance is the implicit gyroscopic term's round-off.
      BOOST_TEST(world.kinetic_energy() <= energy * (1 + 1e-6));
      energy = world.kinetic_energy();
    }
    BOOST_TEST(energy < 0.5 * first);
    BOOST_TEST(norm(sum() - before) < 1e-9);  // round-off of 36 momenta of 300 N s in 200 steps
  }
}

BOOST_AUTO_TEST_CASE(A_free_floe_keeps_its_spin_without_gaining_energy) {
  // The implicit gyroscopic term loses a little: a plate spun about its middle axis tumbles for 5 s.
  World world(rigid(0, 0));
  const std::vector<std::vector<Vec2>> plan{rectangle({-2, -1}, {2, 1})};
  const PlacedPrism placed = place_prism(plan, plan, 0.33, 0.0);
  const MassProperties m = mass_properties(placed.prism, kDensity, 0.5);
  const BodyId floe = world.add_floe(placed.prism, m, placed.pose, {{}, {0.05, 2.0, 0.05}});
  const double energy = world.kinetic_energy();
  const Vec3 spin = angular_momentum(world, floe, m);
  double before = energy;
  for (int i = 0; i < 5000; ++i) {
    world.step(0.001);
    before = std::max(before, world.kinetic_energy());
  }
  BOOST_TEST(before <= energy * (1 + 1e-3));
  // First order in dt: 2 rad/s for 5 s at 1 ms.
  BOOST_TEST(norm(angular_momentum(world, floe, m) - spin) < 0.02 * norm(spin));
}

BOOST_AUTO_TEST_CASE(A_settled_floe_stops_another_by_the_force_that_is_reported_on_either_side) {
  for (const double side : {1.0, -1.0}) {
    World world({.ice_structure = {}, .ice_ice = {0.3, 0.5e6}});
    const BodyId fixed = add_floe(world, rectangle({-1, -1}, {1, 1}), 0.33);
    // 1 mm into the other, along it and towards it.
    const double x = side * 1.999;
    const BodyId floe = add_floe(world, rectangle({x - 1, -0.7}, {x + 1, 1.3}), 0.33, {{-0.2 * side, 0.1, 0}, {}});
    world.set_settled(fixed, true);
    const Vec3 before = world.twist(floe).linear;
    constexpr double dt = 0.01;
    world.step(dt);
    Vec3 impulse{};
    for (const ContactLoad& c : world.contacts()) {
      const Vec3 force = c.normal_force * c.normal + c.friction_force;
      impulse += (c.body == floe ? dt : -dt) * force;
    }
    const double mass = kDensity * 4 * 0.33;
    BOOST_TEST(norm(impulse) > 0.1 * mass);
    BOOST_TEST(norm(mass * (world.twist(floe).linear - before) - impulse) < 1e-9 * mass);
    BOOST_TEST(side * world.twist(floe).linear.x > -1e-6);
  }
}
