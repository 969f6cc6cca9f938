// SPDX-License-Identifier: GPL-3.0-or-later
// The life of an edge that gives way, with responses in closed form.
#include "brash/edge/moving_edges.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/constants.hpp"

namespace {

using namespace brash;
using edge::EdgeContact;
using edge::MovingEdges;

const failure::IceProperties kIce{
    .thickness = 0.33, .youngs_modulus = 0.35e9, .flexural_strength = 539e3, .compressive_strength = 1e6};

/// A heavily damped edge: its deflection goes to the static value 2 as 1 - exp(-t).
plate::EdgeResponses damped(const plate::EdgeGeometry&) {
  plate::EdgeResponses r;
  r.static_deflection = 2.0;
  r.static_edge_moment = -0.2;
  for (double t = 0.02; t < 12.0; t *= 1.1) {
    const double share = 1.0 - (1.0 - std::exp(-t)) / t;
    r.time.push_back(t);
    r.deflection.push_back(2.0 * share);
    r.edge_moment.push_back(-0.2 * share);
  }
  for (int i = 0; i <= 40; ++i) {
    r.station.push_back(0.1 * i);
    r.static_axis_moment.push_back(0.05 * r.station.back() * std::exp(-r.station.back()));
  }
  for (const double f : r.deflection)
    for (const double m : r.static_axis_moment) r.axis_moment.push_back(0.5 * f * m);
  return r;
}

edge::MovingEdges edges() {
  return edge::MovingEdges(
      {failure::EdgeDynamics([](const plate::EdgeGeometry& g) { return damped(g); }, kIce, 900.0)});
}

/// A contact at (0, y) that pushes the edge down with `force`.
edge::EdgeContact contact(double y, double force) {
  edge::EdgeContact result;
  result.touched = {{0.0, y}, 1.0};
  result.load = {.contact_length = 1.0, .mu1 = 0.5, .pressure = force > 0.0 ? 1e5 : 0.0};
  result.on_ice = {0.0, 0.0, -force};
  result.ice = kIce;
  return result;
}

/// Loads the edges, where the structure does more work than bends them. @return the work that bent them [J].
double follow(edge::MovingEdges& moving, std::vector<edge::EdgeContact> contacts, double from, double to) {
  const std::vector<double> work(contacts.size(), 1e9);
  return moving.follow(contacts, work, from, to);
}

double static_deflection(double force) {
  return 2.0 * force / (kIce.water_density * kGravity * failure::characteristic_length(kIce));
}

BOOST_AUTO_TEST_CASE(an_edge_under_an_even_force_goes_down_to_its_static_place) {
  edge::MovingEdges moving = edges();
  BOOST_TEST(moving.shift(0, {{0.0, 0.0}, 1.0}, 0.0) == 0.0);
  double work = 0.0, before = 0.0;
  for (int i = 0; i < 1000; ++i) {
    work += follow(moving, {contact(0.001 * i, 1e4)}, 0.01 * i, 0.01 * (i + 1));
    const double shift = moving.shift(0, {{0.0, 0.001 * i}, 1.0}, 0.01 * (i + 1));
    if (i > 0) BOOST_TEST(shift <= before + 1e-5);  // downwards; the series is interpolated
    before = shift;
  }
  BOOST_TEST(before == -static_deflection(1e4), boost::test_tools::tolerance(0.01));
  BOOST_TEST(work == 1e4 * static_deflection(1e4), boost::test_tools::tolerance(0.02));
  BOOST_TEST(moving.largest_shift(0, 10.0) == before);
  BOOST_TEST(moving.largest_shift(1, 10.0) == 0.0);
}

BOOST_AUTO_TEST_CASE(a_contact_keeps_its_edge_and_another_one_has_its_own) {
  edge::MovingEdges moving = edges();
  for (int i = 0; i < 50; ++i) follow(moving, {contact(0.0, 1e4), contact(3.0, 2e4)}, 0.01 * i, 0.01 * (i + 1));
  const double one = moving.shift(0, {{0.0, 0.1}, 1.0}, 0.5), other = moving.shift(0, {{0.0, 2.8}, 1.0}, 0.5);
  BOOST_TEST(other == 2.0 * one, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(moving.shift(0, {{0.0, 1.5}, 1.0}, 0.5) == 0.0);  // beside both chords
  BOOST_TEST(moving.shift(1, {{0.0, 0.0}, 1.0}, 0.5) == 0.0);  // of other ice
  edge::MovingEdges broken = moving;
  broken.forget(contact(3.0, 2e4));
  BOOST_TEST(broken.shift(0, {{0.0, 3.0}, 1.0}, 0.5) == 0.0);
  BOOST_TEST(broken.shift(0, {{0.0, 0.0}, 1.0}, 0.5) != 0.0);
  moving.forget_within(0, {0.0, 3.0}, 1.0);
  BOOST_TEST(moving.shift(0, {{0.0, 3.0}, 1.0}, 0.5) == 0.0);
  BOOST_TEST(moving.shift(0, {{0.0, 0.0}, 1.0}, 0.5) != 0.0);
  follow(moving, {}, 0.5, 0.51);  // the structure lets go
  BOOST_TEST(moving.shift(0, {{0.0, 0.0}, 1.0}, 0.51) == 0.0);
}

BOOST_AUTO_TEST_CASE(an_edge_that_the_contact_misses_for_a_while_springs_back) {
  edge::MovingEdges moving = edges();
  for (int i = 0; i < 100; ++i) follow(moving, {contact(0.0, 1e4)}, 0.01 * i, 0.01 * (i + 1));
  const double down = moving.shift(0, {{0.0, 0.0}, 1.0}, 1.0);
  double work = 0.0;
  for (int i = 100; i < 400; ++i) work += follow(moving, {contact(0.0, 0.0)}, 0.01 * i, 0.01 * (i + 1));
  const double later = moving.shift(0, {{0.0, 0.0}, 1.0}, 4.0);
  BOOST_TEST(later > 0.1 * down);
  BOOST_TEST(later <= 0.0);
  BOOST_TEST(std::abs(work) < 100.0);  // only the step in which the force fell
}

BOOST_AUTO_TEST_CASE(an_edge_takes_no_more_work_than_the_structure_does) {
  for (const double step : {0.01, 0.05, 0.2}) {
    for (const double speed : {0.001, 0.01, 0.1, 1.0}) {  // of the surface, downwards
      edge::MovingEdges moving = edges();
      double given = 0.0, bent = 0.0;
      for (int i = 0; i < 60; ++i) {
        std::vector<edge::EdgeContact> contacts{contact(0.0, i % 3 == 2 ? 0.0 : 1e4 * (1 + i % 4))};
        const std::vector<double> work{std::abs(contacts[0].on_ice.z) * speed * step};
        const Vec3 whole = contacts[0].on_ice;
        bent += moving.follow(contacts, work, step * i, step * (i + 1));
        const double share = whole.z == 0.0 ? 1.0 : contacts[0].on_ice.z / whole.z;
        BOOST_TEST((share >= 0.0 && share <= 1.0));
        given += share * work[0];
        BOOST_TEST(bent <= given + 1e-9 * (1.0 + given));  // rounding
      }
      BOOST_TEST(given > 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(an_upward_push_lifts_the_edge) {
  edge::MovingEdges moving = edges();
  edge::EdgeContact up = contact(0.0, 1e4);
  up.on_ice.z = 1e4;
  for (int i = 0; i < 50; ++i) follow(moving, {up}, 0.01 * i, 0.01 * (i + 1));
  BOOST_TEST(moving.shift(0, up.touched, 0.5) > 0.0);
}

BOOST_AUTO_TEST_CASE(a_checkpoint_restores_every_edge_and_its_memory) {
  edge::MovingEdges moving = edges(), again = edges();
  const auto step = [](edge::MovingEdges& m, int i) {
    return follow(m, {contact(0.0, 1e4 * std::sin(0.1 * i) + 1e4), contact(3.0, 2e3 * i)}, 0.01 * i, 0.01 * (i + 1));
  };
  for (int i = 0; i < 900; ++i) step(moving, i);
  model::Checkpoint saved;
  moving.save(saved);
  again.restore(saved);
  for (int i = 900; i < 950; ++i) BOOST_TEST(step(again, i) == step(moving, i));
  BOOST_TEST(again.shift(0, {{0.0, 0.0}, 1.0}, 9.5) == moving.shift(0, {{0.0, 0.0}, 1.0}, 9.5));
}

BOOST_AUTO_TEST_CASE(edges_that_do_not_move_cost_nothing) {
  edge::MovingEdges rigid({});
  BOOST_TEST(follow(rigid, {contact(0.0, 1e4)}, 0.0, 0.01) == 0.0);
  BOOST_TEST(rigid.shift(0, {{0.0, 0.0}, 1.0}, 0.01) == 0.0);
  BOOST_TEST(rigid.motion(contact(0.0, 1e4)).whole.stress == 1.0);
}

}  // namespace
