// SPDX-License-Identifier: GPL-3.0-or-later
// The ice of the validation case, pressed by its cone. The reference is an independent finite-element and
// boundary-element calculation of the same plate on the same water.
#include "brash/failure/edge_break.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <iostream>

#include "brash/core/constants.hpp"

namespace failure = brash::failure;
namespace plate = brash::plate;

namespace {

constexpr double kSpeed = 1.202;
constexpr double kFriction = 0.027;

failure::IceProperties ice() {
  return {.thickness = 0.33,
          .youngs_modulus = 0.35e9,
          .poisson_ratio = 0.3,
          .flexural_strength = 539e3,
          .compressive_strength = 1e6,
          .crushing_factor = 0.5,
          .water_density = 1025.0};
}

plate::EdgeResponses responses(double depth, double contact_length, double degrees) {
  const double l_c = failure::characteristic_length(ice());
  const auto solved = plate::solve(plate::EdgeGeometry{.depth = depth,
                                                       .contact_length = contact_length,
                                                       .angle = brash::radians(degrees),
                                                       .mass_ratio = failure::mass_ratio(ice(), 900.0),
                                                       .thickness = ice().thickness / l_c});
  BOOST_REQUIRE_MESSAGE(solved.has_value(), (solved ? "" : solved.error().what));
  return *solved;
}

failure::EdgePush push(double speed, double contact_length) {
  const double slope = brash::radians(61.4);
  return {.speed = speed,
          .slope = slope,
          .friction = kFriction,
          .mu1 = failure::load_ratios(slope, kFriction, 0.0).mu1,
          .contact_length = contact_length * failure::characteristic_length(ice())};
}

void print(const char* name, const failure::EdgeBreak& b) {
  std::cout << name << ": N " << b.load << " N, t " << b.time << " s, w " << b.deflection << " m, l/l_c "
            << b.breaking_length / failure::characteristic_length(ice()) << ", radial " << b.radial_load << " N\n";
}

struct Row {
  double load, length, deflection, radial_load;
};

void check(const char* name, const failure::EdgeBreak& found, const Row& wanted) {
  print(name, found);
  BOOST_TEST(std::abs(found.load / wanted.load - 1.0) < 0.02);
  BOOST_TEST(std::abs(found.deflection / wanted.deflection - 1.0) < 0.05);
  BOOST_TEST(std::abs(found.breaking_length / failure::characteristic_length(ice()) - wanted.length) < 0.03);
  BOOST_TEST(found.radial_first == (wanted.radial_load > 0.0));
  if (found.radial_first) BOOST_TEST(std::abs(found.radial_load / wanted.radial_load - 1.0) < 0.05);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_straight_edge_breaks_as_in_the_reference) {
  const auto r = responses(0.0, 0.3, 0.0);
  check("straight, static", failure::break_edge_at_rest(r, ice(), push(1.0, 0.3)), {179e3, 0.95, 0.396, 41e3});
  check("straight, moving", failure::break_edge(r, ice(), push(kSpeed, 0.3)), {148e3, 0.70, 0.091, 76e3});
}

BOOST_AUTO_TEST_CASE(a_protrusion_breaks_as_in_the_reference) {
  const auto r = responses(0.4, 0.3, 60.0);
  check("protrusion, static", failure::break_edge_at_rest(r, ice(), push(1.0, 0.3)), {49.5e3, 0.39, 0.185, 0.0});
  check("protrusion, moving", failure::break_edge(r, ice(), push(kSpeed, 0.3)), {55.3e3, 0.39, 0.032, 0.0});
}

BOOST_AUTO_TEST_CASE(a_slow_push_is_static) {
  const auto r = responses(0.4, 0.3, 60.0);
  const auto rest = failure::break_edge_at_rest(r, ice(), push(0.01, 0.3));
  const auto slow = failure::break_edge(r, ice(), push(0.01, 0.3));
  print("protrusion, slow", slow);
  BOOST_TEST(std::abs(slow.load / rest.load - 1.0) < 0.005);
  BOOST_TEST(std::abs(slow.deflection / rest.deflection - 1.0) < 0.005);
  // The bound on the speed of docs/theory/fracture-of-the-edge.md, (W7), is 0.045 m/s here.
  const auto at_bound = failure::break_edge(r, ice(), push(0.045, 0.3));
  print("protrusion, at the bound", at_bound);
  BOOST_TEST(std::abs(at_bound.load / rest.load - 1.0) < 0.01);
}

BOOST_AUTO_TEST_CASE(a_wide_contact_breaks_the_edge_as_a_strip) {
  const auto b = failure::break_edge(responses(0.0, 12.0, 0.0), ice(), push(kSpeed, 12.0));
  print("strip", b);
  const double line = push(kSpeed, 12.0).mu1 * b.load / push(kSpeed, 12.0).contact_length;
  BOOST_TEST_MESSAGE("q = " << line);
  BOOST_TEST(std::abs(line / 19.8e3 - 1.0) < 0.02);
  BOOST_TEST(std::abs(b.breaking_length / failure::characteristic_length(ice()) - 0.36) < 0.03);
  BOOST_TEST(std::abs(b.deflection / 0.017 - 1.0) < 0.05);
}
