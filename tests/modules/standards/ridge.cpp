// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/standards/ridge.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/standards/crushing.hpp"

namespace {

using namespace brash;
using namespace brash::standards;
using boost::test_tools::tolerance;

KeelInput keel_of_16_metres() {
  return {.width = 100.0,
          .keel_depth = 16.0,
          .keel_porosity = 0.3,
          .keel_cohesion = 6e3,
          .keel_friction_angle = radians(30.0),
          .ice_density = 910.0,
          .water_density = 1024.0,
          .gravity = 9.81};
}

BOOST_AUTO_TEST_CASE(a_keel_has_the_load_of_a_second_program) {
  // By the expression of a public program for ridge loads (I. Samardzija, after ISO 19906) with the same inputs.
  BOOST_TEST(keel(keel_of_16_metres()).horizontal == 65.0048e6, tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(a_wide_keel_is_rankine_s_passive_earth_pressure) {
  KeelInput in = keel_of_16_metres();
  in.width = 1e9;  // no ends
  // Pressure K_p gamma z + 2 c sqrt(K_p) at the depth z, by the trapezoidal rule, exact for a line.
  const double sine = std::sin(in.keel_friction_angle), passive = (1.0 + sine) / (1.0 - sine);
  const double gamma = 0.7 * 114.0 * 9.81;
  const auto pressure = [&](double z) { return passive * gamma * z + 2.0 * in.keel_cohesion * std::sqrt(passive); };
  const double per_width = 0.5 * in.keel_depth * (pressure(0.0) + pressure(in.keel_depth));
  BOOST_TEST(keel(in).horizontal / in.width == per_width, tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(rubble_beside_a_narrow_structure_adds_a_sixth_of_its_depth) {
  KeelInput in = keel_of_16_metres();
  in.width = 16.0 / 6.0;
  KeelInput wide = in;
  wide.width = 1e9;
  BOOST_TEST(keel(in).horizontal / in.width == 2.0 * keel(wide).horizontal / wide.width, tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(a_keel_has_its_two_parts) {
  KeelInput in = keel_of_16_metres();
  const KeelLoad both = keel(in);
  in.keel_cohesion = 0.0;
  BOOST_TEST(keel(in).horizontal == both.buoyancy, tolerance(1e-14));
  BOOST_TEST(both.horizontal == both.buoyancy + both.cohesion, tolerance(1e-14));
  in.keel_porosity = 1.0;
  BOOST_CHECK_THROW(keel(in), ContractViolation);
}

BOOST_AUTO_TEST_CASE(a_ridge_is_its_layer_that_crushes_and_its_keel) {
  const KeelInput of_keel = keel_of_16_metres();
  RidgeInput in{.width = 100.0,
                .layer_thickness = 2.0,
                .strength_coefficient = 1.8e6,
                .keel_depth = 16.0,
                .keel_porosity = 0.3,
                .keel_cohesion = 6e3,
                .keel_friction_angle = radians(30.0),
                .ice_density = 910.0,
                .water_density = 1024.0,
                .gravity = 9.81};
  const auto load = ridge(in);
  const auto layer = global_crushing({.width = 100.0, .thickness = 2.0, .strength_coefficient = 1.8e6});
  BOOST_TEST(load->layer == layer->horizontal);
  BOOST_TEST(load->layer_pressure == layer->pressure);
  BOOST_TEST(load->keel == keel(of_keel).horizontal);
  BOOST_TEST(load->horizontal == load->layer + load->keel);
  in.width = 3.0;
  BOOST_TEST(!ridge(in).has_value());  // narrower than two thicknesses
}

}  // namespace
