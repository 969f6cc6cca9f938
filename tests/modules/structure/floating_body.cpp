// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/floating_body.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "brash/core/error.hpp"
#include "motions.hpp"

namespace {

using namespace brash;
using structure::testing::box;
using structure::testing::kDensity;
using structure::testing::Moving;

constexpr double kDraught = 3.0, kLength = 20.0, kBreadth = 8.0;  // of box()
constexpr double kMass = kDensity * kDraught * kLength * kBreadth;
constexpr Vec3 kNoWater{};

/// The cone of the validation case, round to 1e-5.
model::Cone cone() {
  return {.angle = radians(61.4), .waterline_width = 13.6, .height = 9.08, .height_under_water = 5.68, .facets = 1024};
}

/// Roll about x or pitch about y, for turns about that axis alone.
double roll(const Moving& body) {
  return 2.0 * std::atan2((*body).now().pose.rotation.x, (*body).now().pose.rotation.w);
}
double pitch(const Moving& body) {
  return 2.0 * std::atan2((*body).now().pose.rotation.y, (*body).now().pose.rotation.w);
}

/// The angle by which a leapfrog goes on in a step, at the angular frequency `omega`: sin(angle / 2) = omega dt / 2.
double angle_of_step(double omega, double dt) { return 2.0 * std::asin(0.5 * omega * dt); }

BOOST_AUTO_TEST_SUITE(floating_body)

BOOST_AUTO_TEST_CASE(a_box_too_heavy_heaves_about_its_floating_at_the_closed_form_s_period) {
  const double omega = std::sqrt(kDensity * kGravity * kLength * kBreadth / (kMass * 1.01 + 2e5)), dt = 0.02;
  Moving body(box(), model::Free{0.0, {.mass = 1.01 * kMass, .added_mass = Vec3{0.0, 0.0, 2e5}}}, dt);
  const double depth = 0.01 * kDraught;
  double most = 0.0, of_closed_form = 0.0;
  for (int n = 1; n <= 2000; ++n) {
    body.step();
    const double z = body->now().pose.position.z;
    most = std::max(most, std::abs(z + depth * (1.0 - std::cos(n * angle_of_step(omega, dt)))));
    of_closed_form = std::max(of_closed_form, std::abs(z + depth * (1.0 - std::cos(omega * n * dt))));
  }
  BOOST_TEST(most < 1e-12);
  // The period is short by (omega dt)^2 / 24 of itself.
  BOOST_TEST_MESSAGE("heave of 30 mm in 40 s: " << of_closed_form << " m off, period " << 2.0 * kPi / omega << " s");
  BOOST_TEST(of_closed_form < 1.1 * depth * omega * 40.0 * std::pow(omega * dt, 2) / 24.0);
}

BOOST_AUTO_TEST_CASE(a_box_with_its_weight_to_one_side_rolls_and_pitches_at_the_closed_forms_periods) {
  const double dt = 0.01, height = -0.5, offset = 1e-4;
  const double metacentric_roll = -0.5 * kDraught + kBreadth * kBreadth / (12.0 * kDraught) - height;
  const double metacentric_pitch = -0.5 * kDraught + kLength * kLength / (12.0 * kDraught) - height;
  const Vec3 radii{3.0, 6.0, 6.0}, water{2e6, 3e7, 0.0};
  Moving rolling(box(),
                 model::Free{0.0,
                             {.centre_of_gravity = Vec3{0.0, offset, height},
                              .radii_of_gyration = radii,
                              .added_mass = kNoWater,
                              .added_inertia = water}},
                 dt);
  Moving pitching(box(),
                  model::Free{0.0,
                              {.centre_of_gravity = Vec3{offset, 0.0, height},
                               .radii_of_gyration = radii,
                               .added_mass = kNoWater,
                               .added_inertia = water}},
                  dt);
  const double in_roll = std::sqrt(kMass * kGravity * metacentric_roll / (kMass * 9.0 + water.x));
  const double in_pitch = std::sqrt(kMass * kGravity * metacentric_pitch / (kMass * 36.0 + water.y));
  const double heel = -offset / metacentric_roll, trim = offset / metacentric_pitch;
  double off_roll = 0.0, off_pitch = 0.0;
  for (int n = 1; n <= 2000; ++n) {
    rolling.step();
    pitching.step();
    off_roll = std::max(off_roll, std::abs(roll(rolling) - heel * (1.0 - std::cos(n * angle_of_step(in_roll, dt)))));
    off_pitch =
        std::max(off_pitch, std::abs(pitch(pitching) - trim * (1.0 - std::cos(n * angle_of_step(in_pitch, dt)))));
  }
  BOOST_TEST_MESSAGE("roll " << 2.0 * kPi / in_roll << " s, pitch " << 2.0 * kPi / in_pitch << " s");
  // The angles are 1e-4 and less: their squares are what the closed form leaves out.
  BOOST_TEST(off_roll < 1e-3 * std::abs(heel));
  BOOST_TEST(off_pitch < 1e-3 * std::abs(trim));
}

BOOST_AUTO_TEST_CASE(natural_periods_are_those_of_waterplane_and_metacentre_and_a_high_centre_turns_over) {
  model::Free free{0.0,
                   {.centre_of_gravity = Vec3{0.0, 0.0, -1.0},
                    .radii_of_gyration = Vec3{3.0, 6.0, 6.5},
                    .added_mass = kNoWater,
                    .added_inertia = kNoWater}};
  // Of the box: BM = I / V, and the centre of buoyancy lies 1.5 m under water.
  const double to_roll = 8.0 * 8.0 / 12.0 / 3.0 - 0.5, to_pitch = 20.0 * 20.0 / 12.0 / 3.0 - 0.5;
  const std::vector<structure::NaturalMode> modes = Moving(box(), free, 0.01)->natural_modes();
  BOOST_REQUIRE(modes.size() == 3);  // a free body drifts and turns in plan
  const auto near = boost::test_tools::tolerance(1e-6);
  BOOST_TEST(modes[0].motion == std::string("roll"));
  BOOST_TEST(modes[0].squared_frequency == kGravity * to_roll / 9.0, near);
  BOOST_TEST(modes[1].motion == std::string("pitch"));
  BOOST_TEST(modes[1].squared_frequency == kGravity * to_pitch / 36.0, near);
  BOOST_TEST(modes[2].motion == std::string("heave"));
  BOOST_TEST(modes[2].squared_frequency == kGravity / 3.0, near);

  free.body.centre_of_gravity = Vec3{0.0, 0.0, 0.5};  // above the metacentre of the roll
  const structure::NaturalMode slowest = Moving(box(), free, 0.01)->natural_modes().front();
  BOOST_TEST(slowest.motion == std::string("roll"));
  BOOST_TEST(slowest.squared_frequency < 0.0);
}

BOOST_AUTO_TEST_CASE(a_thrust_restores_nothing_so_it_changes_no_natural_period) {
  model::Free free{0.0, {.centre_of_gravity = Vec3{0.0, 0.0, -1.0}}};
  const std::vector<structure::NaturalMode> alone = Moving(box(), free, 0.01)->natural_modes();
  free.body.thrust = {1e6, 2e5, 0.0};
  free.body.thrust_arm = {-5.0, 1.0, -2.0};
  const std::vector<structure::NaturalMode> driven = Moving(box(), free, 0.01)->natural_modes();
  BOOST_REQUIRE(driven.size() == alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    BOOST_TEST(driven[i].motion == std::string(alone[i].motion));
    BOOST_TEST(driven[i].squared_frequency == alone[i].squared_frequency);
  }
}

BOOST_AUTO_TEST_CASE(a_box_out_of_balance_settles_by_its_waterplane_and_metacentre) {
  const auto near = boost::test_tools::tolerance(1e-6);
  const structure::Settling heavy = Moving(box(), model::Free{0.0, {.mass = 1.01 * kMass}}, 0.01)->settling();
  BOOST_TEST(heavy.heave == -0.01 * kDraught, near);
  BOOST_TEST(std::abs(heavy.roll) + std::abs(heavy.pitch) < 1e-12);

  const double offset = 1e-4, height = -0.5;
  const double metacentric = -0.5 * kDraught + kBreadth * kBreadth / (12.0 * kDraught) - height;
  const structure::Settling aslant =
      Moving(box(), model::Free{0.0, {.centre_of_gravity = Vec3{0.0, offset, height}}}, 0.01)->settling();
  BOOST_TEST(aslant.roll == -offset / metacentric, near);
  BOOST_TEST(std::abs(aslant.pitch) < 1e-9);

  const structure::Settling level = Moving(cone(), model::Free{}, 0.01)->settling();
  BOOST_TEST(std::abs(level.heave) + std::abs(level.roll) + std::abs(level.pitch) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_cone_heaves_and_pitches_at_the_closed_forms_periods) {
  const double radius = 6.8, keel = radius - 5.68 / std::tan(radians(61.4));
  const double area = kPi * radius * radius, squares = radius * radius + radius * keel + keel * keel;
  const double volume = kPi * 5.68 / 3.0 * squares, mass = kDensity * volume;
  // The centre of buoyancy lies below the waterplane by the depth of a frustum's centroid.
  const double buoyancy = -5.68 * 0.25 * (radius * radius + 2.0 * radius * keel + 3.0 * keel * keel) / squares;
  const double metacentric = buoyancy + 0.25 * kPi * std::pow(radius, 4) / volume;
  const double dt = 0.01, offset = 1e-4, excess = 1e-3;
  Moving heaving(cone(), model::Free{0.0, {.mass = (1.0 + excess) * mass, .added_mass = kNoWater}}, dt);
  Moving pitching(cone(),
                  model::Free{0.0,
                              {.centre_of_gravity = Vec3{offset, 0.0, 0.0},
                               .radii_of_gyration = Vec3{3.0, 3.0, 4.0},
                               .added_mass = kNoWater,
                               .added_inertia = kNoWater}},
                  dt);
  const double in_heave = std::sqrt(kDensity * kGravity * area / mass), depth = excess * volume / area;
  const double in_pitch = std::sqrt(kGravity * metacentric) / 3.0, trim = offset / metacentric;
  double off_heave = 0.0, off_pitch = 0.0;
  for (int n = 1; n <= 1000; ++n) {
    heaving.step();
    pitching.step();
    const double z = heaving->now().pose.position.z;
    off_heave = std::max(off_heave, std::abs(z + depth * (1.0 - std::cos(in_heave * n * dt))));
    off_pitch = std::max(off_pitch, std::abs(pitch(pitching) - trim * (1.0 - std::cos(in_pitch * n * dt))));
  }
  BOOST_TEST_MESSAGE("heave " << 2.0 * kPi / in_heave << " s, pitch " << 2.0 * kPi / in_pitch << " s, off by "
                              << off_heave / depth << " and " << off_pitch / trim);
  // 1024 facets displace 6e-6 less, 0.6 % of the excess; the waterplane grows by 0.06 % over the depth.
  BOOST_TEST(off_heave < 0.015 * depth);
  BOOST_TEST(off_pitch < 5e-3 * trim);
}

BOOST_AUTO_TEST_CASE(damping_lets_a_heave_fade_as_the_closed_form_says_and_drag_slows_a_surge) {
  const double mass = 1.01 * kMass, stiffness = kDensity * kGravity * kLength * kBreadth, damping = 2e5;
  const double omega = std::sqrt(stiffness / mass), ratio = 0.5 * damping / std::sqrt(stiffness * mass);
  const double damped = omega * std::sqrt(1.0 - ratio * ratio), depth = 0.01 * kDraught;
  const auto error = [&](double dt) {
    Moving body(box(), model::Free{0.0, {.mass = mass, .added_mass = kNoWater, .linear_damping = {0.0, 0.0, damping}}},
                dt);
    double most = 0.0;
    for (int n = 1; n * dt <= 20.0; ++n) {
      body.step();
      const double t = n * dt, fade = std::exp(-ratio * omega * t);
      const double exact =
          -depth * (1.0 - fade * (std::cos(damped * t) + ratio * omega / damped * std::sin(damped * t)));
      most = std::max(most, std::abs(body->now().pose.position.z - exact));
    }
    return most;
  };
  const double coarse = error(0.04), fine = error(0.02);
  BOOST_TEST_MESSAGE("damped heave of 30 mm off by " << coarse << " and " << fine << " m at 0.04 and 0.02 s");
  BOOST_TEST(coarse / fine == 4.0, boost::test_tools::tolerance(0.02));  // second order
  BOOST_TEST(fine < 2e-3 * depth);

  // m v' = -c v^2: v = v0 / (1 + c v0 t / m).
  Moving body(box(), model::Free{2.0, {.added_mass = kNoWater, .quadratic_damping = {5e4, 0.0, 0.0}}}, 0.02);
  body.steps(1000);
  const double exact = kMass / 5e4 * std::log1p(5e4 * 2.0 * 20.0 / kMass) - 7.0;
  BOOST_TEST(body->now().pose.position.x == exact, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(thrust_against_drag_attains_its_speed_in_the_direction_of_the_bow) {
  // v = v1 tanh(t sqrt(T c) / m)
  const double thrust = 2e5, drag = 5e4, top = std::sqrt(thrust / drag);
  Moving body(
      box(),
      model::Free{0.0, {.added_mass = kNoWater, .quadratic_damping = {drag, 0.0, 0.0}, .thrust = {thrust, 0.0, 0.0}}},
      0.02);
  for (int n = 1; n <= 4000; ++n) body.step();
  const double rate = std::sqrt(thrust * drag) / kMass;
  const double exact = top / rate * (std::log(std::cosh(rate * 80.0))) - 7.0;
  BOOST_TEST(body->now().pose.position.x == exact, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(body->now().twist.linear.x == top, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(a_thrust_that_falls_with_the_speed_follows_its_closed_form_and_attains_the_speed_in_open_water) {
  // m v' = T (1 - v / (3 v0) - 2/3 (v / v0)^2): v = v0 (E - 1) / (E + 2/3) with E = e^(k t), k = 5 T / (3 m v0).
  const double bollard = 2e5, top = 4.0, rate = 5.0 * bollard / (3.0 * kMass * top);
  Moving body(box(), model::Free{0.0, {.added_mass = kNoWater, .thrust = {bollard, 0.0, 0.0}, .open_water_speed = top}},
              0.02);
  body.steps(750);
  const double growth = rate * 15.0;
  const double exact = top / rate * (2.5 * std::log((std::exp(growth) + 2.0 / 3.0) * 0.6) - 1.5 * growth) - 7.0;
  BOOST_TEST(body->now().pose.position.x == exact, boost::test_tools::tolerance(1e-6));
  body.steps(20000);
  BOOST_TEST(body->now().twist.linear.x == top, boost::test_tools::tolerance(1e-9));
  // The loss of the thrust takes energy as damping does.
  const model::BodyEnergy e = body->energy();
  BOOST_TEST(e.thrust_work == e.kinetic + e.damping_loss, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(e.kinetic == 0.5 * kMass * top * top, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_moored_box_in_a_current_rests_where_spring_and_drag_balance) {
  const double stiffness = 1e5, linear = 2e4, quadratic = 4e4, current = 1.5;
  model::Moored moored{0.0,
                       {.linear_damping = {linear, linear, 5e5},
                        .quadratic_damping = {quadratic, quadratic, 0.0},
                        .angular_damping = {1e7, 1e7, 1e7}},
                       {},
                       {},
                       {}};
  moored.stiffness.resize(6);
  for (std::size_t i = 0; i < 6; ++i) moored.stiffness[i][i] = i < 3 ? stiffness : 1e6;
  Moving body(box(), moored, 0.05, {current, 0.0});
  body.steps(20000);
  const double exact = (linear * current + quadratic * current * current) / stiffness;
  BOOST_TEST(body->now().pose.position.x + 7.0 == exact, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(norm(body->now().twist.linear) < 1e-9);
  // Its energy: the water, in which it moves back, does no work; the feet pull it through the water.
  const model::BodyEnergy e = body->energy();
  BOOST_TEST(e.mooring == 0.5 * stiffness * exact * exact, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(std::abs(e.error) < 1e-4 * e.damping_loss);
}

BOOST_AUTO_TEST_CASE(two_moored_boxes_whose_frames_differ_move_alike_to_round_off) {
  // The one lies in a current. The other's feet are towed the other way through water at rest.
  model::Moored moored{0.0, {.linear_damping = {2e4, 2e4, 1e5}, .angular_damping = {1e6, 1e6, 1e6}}, {}, {}, {}};
  moored.lines = {{{190, 0, -30}, {9, 0, 0}, 205, 1000, 3e8},
                  {{-140, 130, -30}, {-9, 3, 0}, 205, 1000, 3e8},
                  {{-140, -130, -30}, {-9, -3, 0}, 205, 1000, 3e8}};
  model::Moored towed = moored;
  towed.speed = 0.75;
  Moving at_rest(box(), moored, 0.01, {-0.75, 0.25}), moves(box(), towed, 0.01, {0.0, 0.25});
  double apart = 0.0;
  for (int n = 1; n <= 3000; ++n) {
    const Wrench ice{{-3e5 * std::sin(0.01 * n), 1e5 * std::cos(0.03 * n), 2e4}, {1e5, -2e5, 3e5}};
    at_rest.step(ice);
    moves.step(ice);
    const Vec3 drift{0.75 * 0.01 * n, 0.0, 0.0};
    apart = std::max(apart, norm(moves->now().pose.position - drift - at_rest->now().pose.position));
  }
  BOOST_TEST_MESSAGE("Galilean pair: " << apart << " m apart after 30 s");
  BOOST_TEST(apart < 1e-8);  // the lines' pull is found to 1e-13 of their length, some 1e-5 N
  BOOST_TEST(std::abs(at_rest->energy().error - moves->energy().error) < 1e-3);
  BOOST_TEST(norm(plan(at_rest->now().pose.position) - Vec2{-7.0, 0.0}) > 0.5);
}

BOOST_AUTO_TEST_CASE(the_impulse_of_the_ice_is_the_change_of_momentum_to_round_off) {
  const double mass = kMass + 3e5;
  Moving body(box(), model::Free{1.0, {.added_mass = Vec3{3e5, 3e5, 3e5}}}, 0.01);
  auto velocity_of_centre = [&, last = body->now().pose.position]() mutable {
    const Vec3 way = body->now().pose.position - last;  // the centre of gravity is the origin
    last = body->now().pose.position;
    return way / 0.01;
  };
  body->advance(1.0);
  Vec3 velocity = velocity_of_centre();
  Vec3 last{}, given{}, gained{};
  for (int n = 1; n <= 500; ++n) {
    const Vec3 force{-3e5 * std::sin(0.05 * n), 2e5 * std::cos(0.03 * n), -1e4};
    const Vec3 acts = 0.5 * (last + force);  // from the middle of one step to the middle of the next
    body->bear({force, {1e5, -2e5, 3e4}});
    body->advance(1.0);
    const Vec3 next = velocity_of_centre(), gain = mass * (next - velocity), gift = 0.01 * acts;
    // A place of some metres is rounded to 1e-15 m, so a velocity to 1e-13 m/s.
    BOOST_TEST(norm(plan(gain) - plan(gift)) < 1e-12 * mass);
    given += gift;
    gained += gain;
    velocity = next;
    last = force;
  }
  BOOST_TEST(norm(plan(gained) - plan(given)) < 1e-9 * norm(plan(given)));
}

BOOST_AUTO_TEST_CASE(a_body_that_turns_in_water_keeps_its_momentum_and_nearly_its_energy) {
  // Long and narrow: the added mass across turns it to the stream (Munk's moment); no damping.
  const auto errors = [](double dt) {
    Moving body(box(), model::Free{2.0, {.thrust = {1.0, 2e3, 0.0}, .thrust_arm = {9.0, 0.0, 0.0}}}, dt);
    double most = 0.0;
    for (int n = 1; n * dt <= 60.0; ++n) {
      body.step();
      most = std::max(most, std::abs(body->energy().error));
    }
    BOOST_TEST(std::abs(body->now().twist.angular.z) > 0.01);
    return most / body->energy().kinetic;
  };
  const double coarse = errors(0.04), fine = errors(0.02);
  BOOST_TEST_MESSAGE("energy of a turning box off by " << coarse << " and " << fine);
  BOOST_TEST(coarse / fine == 4.0, boost::test_tools::tolerance(0.1));  // second order
  BOOST_TEST(fine < 1e-4);
}

BOOST_AUTO_TEST_CASE(large_motions_of_a_cone_close_their_energy_at_second_order_and_do_not_drift) {
  const auto errors = [](double dt, double end) {
    Moving body(
        model::Cone{.angle = radians(61.4), .waterline_width = 13.6, .height = 9.08, .height_under_water = 5.68},
        model::Free{1.0, {.mass = 5.5e5, .centre_of_gravity = Vec3{0.6, 0.3, -0.5}}}, dt);
    double most = 0.0, deepest = 0.0;
    for (int n = 1; n * dt <= end; ++n) {
      body.step();
      most = std::max(most, std::abs(body->energy().error));
      deepest = std::max(deepest, std::abs(body->energy().hydrostatic));
    }
    return most / deepest;
  };
  const double coarse = errors(0.02, 60.0), fine = errors(0.01, 60.0), longer = errors(0.02, 600.0);
  BOOST_TEST_MESSAGE("energy of a tossing cone off by " << coarse << " at 0.02 s, " << fine
                                                        << " at 0.01 s; ten times as long " << longer);
  BOOST_TEST(coarse / fine == 4.0, boost::test_tools::tolerance(0.25));
  BOOST_TEST(longer < 2.0 * coarse);
}

BOOST_AUTO_TEST_CASE(a_body_goes_on_from_a_checkpoint_with_the_same_bytes) {
  model::Moored moored{
      0.5, {.linear_damping = {2e4, 2e4, 1e5}, .quadratic_angular_damping = {1e6, 1e6, 1e6}}, {}, {}, {}};
  moored.lines = {{{190, 0, -30}, {9, 0, 0}, 205, 1000, 3e8}, {{-190, 0, -30}, {-9, 0, 0}, 205, 1000, 3e8}};
  Moving whole(box(), moored, 0.01, {0.1, 0.2}), again(box(), moored, 0.01, {0.1, 0.2});
  const Wrench ice{{-3e5, 1e5, 2e4}, {1e5, -2e5, 3e5}};
  for (int n = 0; n < 200; ++n) whole.step(ice);
  model::Checkpoint saved;
  whole->save(saved);
  again->restore(saved);
  for (const Moving* const one : {&whole, &again}) {
    for (int n = 0; n < 50; ++n) {
      (*one)->advance(0.5);
      (*one)->advance(0.5);
      (*one)->bear(ice);
    }
  }
  BOOST_TEST((again->now().pose == whole->now().pose));
  BOOST_TEST((again->now().twist == whole->now().twist));
  BOOST_TEST((again->energy() == whole->energy()));
  BOOST_TEST(whole->now().pose.rotation.z != 0.0);
}

BOOST_AUTO_TEST_CASE(a_step_that_is_too_long_and_a_hull_out_of_the_water_are_refused) {
  model::Moored moored{0.0, {}, {}, {}, {}};
  moored.stiffness.resize(6);
  moored.stiffness[0][0] = 1e9;
  BOOST_CHECK_THROW(Moving(box(), moored, 0.1), InputError);
  BOOST_CHECK_NO_THROW(Moving(box(), moored, 0.01));
  model::Plane dry = box();
  dry.height_under_water = -1.0;
  BOOST_CHECK_THROW(Moving(dry, model::Free{}, 0.01), InputError);
}

BOOST_AUTO_TEST_CASE(a_box_has_the_mass_of_its_water_and_turned_a_quarter_the_same_along_the_other_axes) {
  const auto hull = structure::make_hull(box());
  const structure::Inertia inertia = structure::inertia_of({}, *hull, kDensity);
  BOOST_TEST(inertia.mass == kMass, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(norm(inertia.centre) < 1e-12);
  BOOST_TEST(inertia.added_mass.y > 2.0 * inertia.added_mass.x);
  BOOST_TEST(inertia.added_mass.z > inertia.added_mass.y);
  model::Plane wide = box();
  std::swap(wide.waterline_width, wide.length);
  const structure::Inertia across = structure::inertia_of({}, *structure::make_hull(wide), kDensity);
  BOOST_TEST(across.added_mass.x == inertia.added_mass.y, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(across.moments.y == inertia.moments.x, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
