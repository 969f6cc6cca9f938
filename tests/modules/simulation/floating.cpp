// SPDX-License-Identifier: GPL-3.0-or-later
// A floe in the water: World and hydrodynamics, coupled as in the step, against closed forms; equations of
// docs/theory/contacts-and-bodies.md, (V1), (V2), (V3), (V4), (V5), (V6).
#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "floating_floe.hpp"

namespace {

using namespace brash;
using simulation::testing::FloatingFloe;
using simulation::testing::ice_and_water;
using simulation::testing::oscillate;
using simulation::testing::Oscillation;
using simulation::testing::without_drag;

constexpr double kLength = 4.0;
constexpr double kBreadth = 3.0;

double heave_frequency(const FloatingFloe& floe) {  // V1
  return std::sqrt(floe.ice.water.density * kGravity * floe.l * floe.b / floe.inertia().mass);
}

/// GM = I_wp / V - BG of the box.
double metacentric_height(const FloatingFloe& floe) {
  return floe.b * floe.b / (12.0 * floe.draft()) - 0.5 * (floe.h() - floe.draft());
}

double roll_frequency(const FloatingFloe& floe) {  // V2
  const double weight = floe.floes.floes().at(floe.body).weight;
  return std::sqrt(weight * metacentric_height(floe) / floe.inertia().inertia.x);
}

/// Turning point B after a half cycle from A with m v' = -k x - c |v| v, beta = c / m: (1 + a) e^-a = (1 - b) e^b with
/// a = 2 beta A, b = 2 beta B (V3).
double next_turn(double beta, double amplitude) {
  const double a = 2.0 * beta * amplitude;
  const double left = (1.0 + a) * std::exp(-a);
  double low = 0.0, high = std::min(a, 1.0);  // (1 - b) e^b falls from 1 to 0
  for (int i = 0; i < 60; ++i) {
    const double b = 0.5 * (low + high);
    ((1.0 - b) * std::exp(b) > left ? low : high) = b;
  }
  return 0.5 * (low + high) / (2.0 * beta);
}

double relative_error(double found, double exact) { return std::abs(found - exact) / std::abs(exact); }

}  // namespace

BOOST_AUTO_TEST_CASE(a_floe_comes_to_rest_at_the_draft_of_archimedes) {
  // Quadratic drag never ends a motion (V4), so a linear brake of the test's own takes heave, roll and pitch away.
  FloatingFloe floe(kLength, kBreadth, ice_and_water());
  const Twist pitching{{}, {0.0, 0.05, 0.0}};
  floe.place(0.03, radians(1.0), pitching);
  const double brake = floe.inertia().mass * heave_frequency(floe);
  for (int i = 0; i < 4000; ++i) {
    const Twist twist = floe.world.twist(floe.body);
    floe.world.apply(floe.body, {-brake * twist.linear, -brake * twist.angular});
    floe.step(0.01);
  }
  const Vec3 up = rotate(floe.world.pose(floe.body).rotation, {0.0, 0.0, 1.0});
  BOOST_TEST_MESSAGE("draft off by " << floe.heave() / floe.h() << " h, tilt " << std::hypot(up.x, up.y));
  BOOST_TEST(std::abs(floe.heave()) < 1e-9 * floe.h());  // asked for; rounding leaves 1e-15
  BOOST_TEST(std::hypot(up.x, up.y) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_floe_at_rest_in_still_water_stays_at_rest) {
  FloatingFloe floe(kLength, kBreadth, ice_and_water());
  for (int i = 0; i < 6000; ++i) floe.step(0.01);
  BOOST_TEST_MESSAGE("after 60 s off by " << floe.heave() / floe.h() << " h");
  // Weight and buoyancy of 35 kN cancel to rounding, 1e-11 N: 1e-15 m at the natural frequency.
  BOOST_TEST(std::abs(floe.heave()) < 1e-13);
  BOOST_TEST(norm(floe.world.twist(floe.body).linear) < 1e-13);
}

BOOST_AUTO_TEST_CASE(the_heave_period_is_that_of_the_spring_of_the_waterplane) {
  for (const double dt : {0.01, 0.001}) {
    FloatingFloe floe(kLength, kBreadth, ice_and_water(without_drag()));
    floe.place(0.03, 0.0);
    const double exact = 2.0 * kPi / heave_frequency(floe);
    const Oscillation heave = oscillate(
        floe, [&] { return floe.heave(); }, dt, 41);
    const double angle = heave_frequency(floe) * dt;
    BOOST_TEST_MESSAGE("heave: T = " << heave.period << " s, exact " << exact << ", off by "
                                     << relative_error(heave.period, exact) << " at dt = " << dt);
    // Semi-implicit Euler turns by 2 asin(w dt / 2) a step: the period is short by (w dt)^2 / 24.
    BOOST_TEST(heave.period == exact * (1.0 - angle * angle / 24.0), boost::test_tools::tolerance(1e-6));
    // It keeps the amplitude: after twenty cycles within w dt / 2, the width of its ellipse.
    BOOST_TEST(heave.turns.back() == 0.03, boost::test_tools::tolerance(0.5 * angle));
  }
  FloatingFloe dragged(kLength, kBreadth, ice_and_water());
  dragged.place(0.03, 0.0);
  const Oscillation heave = oscillate(
      dragged, [&] { return dragged.heave(); }, 0.01, 41);
  const double exact = 2.0 * kPi / heave_frequency(dragged);
  BOOST_TEST_MESSAGE("heave with drag: off by " << relative_error(heave.period, exact));
  BOOST_TEST(heave.period == exact, boost::test_tools::tolerance(0.01));  // asked for: 1 %
}

/// Heave against V3 with drag kept for `travel`: 39 turning points within `tolerance`.
void check_heave_decay(const std::string& travel, double tolerance) {
  FloatingFloe floe(kLength, kBreadth,
                    ice_and_water({"hydrodynamics.skin_friction=0", "hydrodynamics.drag_travel=" + travel}));
  const double start = 0.03;
  floe.place(start, 0.0);
  // The dry top does not count: only the way down is braked, by the bottom face.
  const double beta = 0.5 * floe.ice.water.density * kLength * kBreadth / floe.inertia().mass;
  const Oscillation heave = oscillate(
      floe, [&] { return floe.heave(); }, 0.001, 40);
  double amplitude = start, worst = 0.0;
  for (std::size_t i = 1; i < heave.turns.size(); ++i) {
    if (i % 2 == 1) amplitude = next_turn(beta, amplitude);
    worst = std::max(worst, relative_error(std::abs(heave.turns[i]), amplitude));
  }
  const double first = 4.0 / 3.0 * beta * start;  // per cycle, leading term of V4
  BOOST_TEST_MESSAGE("heave decay, drag kept for " << travel << " h: " << heave.turns.size() - 1
                                                   << " turning points within " << worst << ", first cycle lost "
                                                   << 1.0 - heave.turns[2] / start << ", leading term " << first);
  BOOST_TEST(worst < tolerance);
  BOOST_TEST(1.0 - heave.turns[2] / start == first, boost::test_tools::tolerance(2.0 * beta * start));  // next term
}

BOOST_AUTO_TEST_CASE(heave_decays_by_the_quadratic_drag_of_its_downward_half_cycles) {
  check_heave_decay("0", 1e-5);
  check_heave_decay("0.1", 1e-3);  // 1 % is asked for; the drag of the way up is kept for a part of the way down
}

BOOST_AUTO_TEST_CASE(the_roll_period_is_that_of_the_metacentric_height) {
  for (const double dt : {0.01, 0.001}) {
    FloatingFloe floe(kLength, kBreadth, ice_and_water(without_drag()));
    const double start = 0.01;  // the deck's edge stays 25 mm above water
    floe.place(0.0, start);
    const double exact = 2.0 * kPi / roll_frequency(floe);
    const Oscillation roll = oscillate(
        floe, [&] { return floe.roll(); }, dt, 41);
    const double angle = roll_frequency(floe) * dt;
    BOOST_TEST_MESSAGE("roll: GM = " << metacentric_height(floe) << " m, T = " << roll.period << " s, exact " << exact
                                     << ", off by " << relative_error(roll.period, exact) << " at dt = " << dt);
    // As for heave; GZ grows by tan^2 / 2 beyond the sine, and with heave at rest the draft by z phi^2 / 2: 1e-4.
    BOOST_TEST(roll.period == exact * (1.0 - angle * angle / 24.0), boost::test_tools::tolerance(1e-4));
  }
  FloatingFloe dragged(kLength, kBreadth, ice_and_water());
  dragged.place(0.0, 0.01);
  const Oscillation roll = oscillate(
      dragged, [&] { return dragged.roll(); }, 0.01, 41);
  const double exact = 2.0 * kPi / roll_frequency(dragged);
  BOOST_TEST_MESSAGE("roll with drag: off by " << relative_error(roll.period, exact));
  BOOST_TEST(roll.period == exact, boost::test_tools::tolerance(0.01));  // asked for: 1 %
}

/// Roll from `start` against V3: the largest deviation of 39 turning points and the loss of the first cycle.
void check_roll_decay(const model::Case& resolved, double moment_per_square, double tolerance, const char* law) {
  FloatingFloe floe(kLength, kBreadth, resolved);
  const double start = 0.01;
  floe.place(0.0, start);
  const double beta = moment_per_square / floe.inertia().inertia.x;
  const Oscillation roll = oscillate(
      floe, [&] { return floe.roll(); }, 0.001, 40);
  double amplitude = start, worst = 0.0;
  for (std::size_t i = 1; i < roll.turns.size(); ++i) {
    amplitude = next_turn(beta, amplitude);
    worst = std::max(worst, relative_error(std::abs(roll.turns[i]), amplitude));
  }
  BOOST_TEST_MESSAGE("roll decay, " << law << ": " << roll.turns.size() - 1 << " turning points within " << worst
                                    << ", first cycle lost " << 1.0 - roll.turns[2] / start);
  BOOST_TEST(worst < tolerance);
}

BOOST_AUTO_TEST_CASE(roll_decays_by_the_rotational_drag_in_both_half_cycles) {
  std::vector<std::string> settings{"hydrodynamics.drag=paper", "hydrodynamics.form_drag=0",
                                    "hydrodynamics.skin_friction=0"};
  const model::Case resolved = ice_and_water(settings);
  const FloatingFloe floe(kLength, kBreadth, resolved);
  const double l_avg = (kLength + kBreadth + floe.h()) / 3.0;
  const double wetted = kLength * kBreadth + 2.0 * (kLength + kBreadth) * floe.draft();
  const double moment = 0.5 * resolved.water.density * l_avg * l_avg * l_avg * wetted;
  check_roll_decay(resolved, moment, 1e-3, "Eq. 14");  // 1 % is asked for
  settings.push_back("hydrodynamics.drag_travel=0");
  check_roll_decay(ice_and_water(settings), moment, 2e-5, "Eq. 14, drag of every step");
}

BOOST_AUTO_TEST_CASE(roll_decays_by_the_drag_on_the_leading_half_of_bottom_and_sides) {
  const model::Case resolved = ice_and_water({"hydrodynamics.skin_friction=0"});
  const FloatingFloe floe(kLength, kBreadth, resolved);
  // V6: from the axis of roll the sides are b/2 away, the bottom h/2 down and the waterline w up.
  const double y = 0.5 * kBreadth, z = 0.5 * floe.h(), w = floe.draft() - z;
  const auto strip = [](double along, double off) {  // integral of s (s^2 + off^2) from 0 to `along`
    return 0.25 * std::pow(along, 4) + 0.5 * along * along * off * off;
  };
  const double sum = kLength * (strip(y, z) + strip(z, y) + strip(w, y));
  const double moment = 0.5 * resolved.water.density * sum;
  check_roll_decay(resolved, moment, 1e-3, "on the surface");
  check_roll_decay(ice_and_water({"hydrodynamics.skin_friction=0", "hydrodynamics.drag_travel=0"}), moment, 1e-4,
                   "on the surface, drag of every step");
}

BOOST_AUTO_TEST_CASE(a_floe_held_under_water_rises_as_tanh_to_its_terminal_velocity) {
  for (const double dt : {0.01, 0.001}) {
    FloatingFloe floe(kLength, kBreadth, ice_and_water());
    const model::Case& c = floe.ice;
    const double area = kLength * kBreadth;
    const double damping =
        0.5 * c.water.density *
        (c.hydrodynamics.form_drag * area + c.hydrodynamics.skin_friction * 2.0 * (kLength + kBreadth) * floe.h());
    const double lift = (c.water.density - c.ice.density) * kGravity * area * floe.h();
    const double terminal = std::sqrt(lift / damping);
    const double rise_time = floe.inertia().mass / (damping * terminal);  // added mass delays, it does not lift
    floe.place(-20.0, 0.0);
    double worst = 0.0;
    for (int i = 1; i * dt < 8.0 * rise_time; ++i) {
      floe.step(dt);
      const double exact = terminal * std::tanh(i * dt / rise_time);
      worst = std::max(worst, std::abs(floe.world.twist(floe.body).linear.z - exact) / terminal);
    }
    const double last = floe.world.twist(floe.body).linear.z;
    BOOST_TEST_MESSAGE("rise: terminal " << last << " m/s, exact " << terminal << ", off by "
                                         << relative_error(last, terminal) << " at dt = " << dt
                                         << "; on the way within " << worst);
    // 1e-3 is asked for. A steady velocity comes out as it is, 1 - tanh(8) = 2e-7; on the way the error is second
    // order.
    BOOST_TEST(last == terminal, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(worst < 1.0 * std::pow(dt / rise_time, 2) + 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(a_current_takes_a_floe_along_by_the_closed_form_of_quadratic_drag) {
  FloatingFloe floe(kLength, kBreadth, ice_and_water({"water.current=[0.5, 0]"}));
  const model::Case& c = floe.ice;
  const double bottom_and_sides = kLength * kBreadth + 2.0 * kLength * floe.draft();
  const double damping =
      0.5 * c.water.density *
      (c.hydrodynamics.form_drag * kBreadth * floe.draft() + c.hydrodynamics.skin_friction * bottom_and_sides);
  const double rate = damping * 0.5 / floe.inertia().mass;
  const double dt = 0.01;
  double worst = 0.0;
  for (int i = 1; i <= 6000; ++i) {
    floe.step(dt);
    const double exact = 0.5 * (1.0 - 1.0 / (1.0 + rate * i * dt));  // V5
    worst = std::max(worst, std::abs(floe.world.twist(floe.body).linear.x - exact) / 0.5);
  }
  BOOST_TEST_MESSAGE("drift: within " << worst << " of the current over 60 s");
  // The drag acts 20 mm below the centre of mass: 111 N against 160 kN m / rad, so the floe pitches to 1.4e-5 rad and
  // swings to twice that, where the bottom shows the current 3.4e-4 m2 beside the 0.87 m2 of the front.
  BOOST_TEST(worst < 4e-4);
}

BOOST_AUTO_TEST_CASE(a_floe_that_rises_against_the_underside_of_the_sheet_has_no_form_drag_there) {
  for (const auto& [shading, gap, share] : {std::tuple{"true", 0.01, 0.0}, {"true", 1.0, 1.0}, {"false", 0.01, 1.0}}) {
    FloatingFloe floe(kLength, kBreadth, ice_and_water({std::string("hydrodynamics.shading=") + shading}));
    const double top = -2.0;
    // The sheet is in two parts, as its tiles are: their joint is no gap.
    for (const auto& [from, to] : {std::pair{-5.0, 0.3}, {0.3, 5.0}})
      floe.world.add_sheet_part(std::vector<Vec2>{{from, -5}, {to, -5}, {to, 5}, {from, 5}}, top + gap,
                                top + gap + 1.0);
    const double speed = 0.5, dt = 1e-6;  // short, so that the velocity does not change
    floe.place(top - 0.5 * floe.h() - floe.rest, 0.0, {{0.0, 0.0, speed}, {}});
    floe.step(dt);
    const double free = 0.5 * floe.ice.water.density * kLength * kBreadth * speed * speed;
    BOOST_TEST(std::abs(floe.floes.floes().at(floe.body).drag.force.z + share * free) < 1e-5 * free);
  }
}

BOOST_AUTO_TEST_CASE(without_drag_a_floe_that_rolls_over_keeps_its_energy) {
  // On edge and out of the water by a third: it falls, dives and turns, deck and bottom pass the waterplane. Without
  // added mass, which the water would give and take with a loss.
  std::vector<std::string> changes = without_drag();
  changes.emplace_back("hydrodynamics.added_mass=0");
  std::vector<double> drifts;
  for (const double dt : {0.002, 0.001, 0.0005}) {
    FloatingFloe floe(kLength, kBreadth, ice_and_water(changes));
    floe.place(0.5, radians(70.0), {{}, {0.2, 0.3, 0.1}});
    const auto energy = [&] { return floe.world.kinetic_energy() + floe.floes.potential_energy(floe.world); };
    const double start = energy();
    double worst = 0.0;
    for (double t = 0.0; t < 10.0; t += dt) {
      floe.step(dt);
      worst = std::max(worst, relative_error(energy(), start));
    }
    drifts.push_back(worst);
  }
  BOOST_TEST_MESSAGE("energy within " << drifts[0] << ", " << drifts[1] << ", " << drifts[2]
                                      << " of the start at dt = 2, 1, 0.5 ms");
  BOOST_TEST(drifts[2] < 0.01);
  BOOST_TEST(drifts[2] < 0.6 * drifts[1]);  // first order
  BOOST_TEST(drifts[1] < 0.6 * drifts[0]);
}

BOOST_AUTO_TEST_CASE(drag_only_takes_energy_from_a_floe) {
  FloatingFloe floe(kLength, kBreadth, ice_and_water());
  floe.place(0.5, radians(70.0), {{0.5, -0.3, 0.0}, {0.2, 0.3, 0.1}});
  const auto energy = [&] { return floe.world.kinetic_energy() + floe.floes.potential_energy(floe.world); };
  const double start = energy();
  double before = start;
  double gained = 0.0;
  for (int i = 0; i < 20000; ++i) {
    floe.step(0.001);
    const double now = energy();
    gained = std::max(gained, now - before);
    before = now;
  }
  BOOST_TEST_MESSAGE("energy after 20 s: " << before / start << " of the start; largest gain in a step "
                                           << gained / start);
  BOOST_TEST(before < 0.05 * start);
  // The wobble of semi-implicit Euler in one step, (w dt)^2 of the energy.
  BOOST_TEST(gained < 1e-4 * start);
}

BOOST_AUTO_TEST_CASE(a_dry_floe_falls_with_g) {
  FloatingFloe floe(kLength, kBreadth, ice_and_water());
  floe.place(5.0, 0.0);
  for (int i = 0; i < 50; ++i) floe.step(0.01);
  BOOST_TEST(floe.world.twist(floe.body).linear.z == -kGravity * 0.5, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_floe_that_falls_into_the_water_hands_on_momentum_to_its_added_mass) {
  // Over a step the weight and the water add less than a hundredth to a floe this fast.
  FloatingFloe floe(kLength, kBreadth, ice_and_water());
  const Twist falling{{0.0, 0.0, -20.0}, {}};
  floe.place(2.0, 0.0, falling);
  floe.step(1e-6);
  const double dry = floe.inertia().mass;
  floe.place(0.0, 0.0, falling);
  floe.step(1e-6);
  const double wet = floe.inertia().mass;
  BOOST_TEST(wet == 1.5 * dry, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(wet * floe.world.twist(floe.body).linear.z == dry * falling.linear.z, boost::test_tools::tolerance(1e-3));
  const floes::Floe& state = floe.floes.floes().at(floe.body);
  BOOST_TEST(state.shed == 0.5 * dry * 400.0 * (1.0 - dry / wet), boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(a_structure_that_drifts_with_the_current_does_not_stir_the_water) {
  FloatingFloe floe(1.0, 1.0, ice_and_water({"hydrodynamics.structure_flow=true", "water.current=[0.5, 0.2]"}));
  const Twist drift{{0.5, 0.2, 0.0}, {}};
  floe.place(0.0, 0.0, drift);
  structure::State structure{{{-8.0, 1.0, 0.0}, {}}, drift};
  for (int i = 0; i < 100; ++i) {
    floe.water.apply(floe.world, floe.floes, 0.01, structure);
    floe.world.step(0.01);
    structure.pose.position += 0.01 * drift.linear;
  }
  BOOST_TEST(norm(floe.world.twist(floe.body).linear - drift.linear) < 1e-12);
}
