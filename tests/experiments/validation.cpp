// SPDX-License-Identifier: GPL-3.0-or-later
// experiments/validation, its first 6 s: the cone's axis then stands at the initial edge.
#include <boost/test/unit_test.hpp>

#include "brash/io/case.hpp"
#include "brash/simulation/run.hpp"

namespace {

using namespace brash;

const model::Case& validation_case() {
  static const model::Case resolved =
      io::read_case(BRASH_SOURCE_DIR "/experiments/validation/second_reading.toml", {"time.duration=6"});
  return resolved;
}

const simulation::Run& validation_run() {
  static const simulation::Run run = simulation::run(validation_case());
  return run;
}

BOOST_AUTO_TEST_CASE(the_load_is_the_recorded_one) {
  // Recorded over seeds 1 to 4: mean 103.1 kN; deviation between seeds 3.1 kN, over 8 seeds of the paper's drag
  // 4.1 kN. One seed on another machine is another replicate (a last digit of libm changes the sequence of breaks), so
  // the bounds are four deviations of 4.1 kN.
  BOOST_TEST(validation_run().summary.mean_horizontal_whole > 86700.0);
  BOOST_TEST(validation_run().summary.mean_horizontal_whole < 119500.0);
}

BOOST_AUTO_TEST_CASE(the_ledger_closes_exactly) {
  const geometry::Ledger& ledger = validation_run().summary.ledger;
  BOOST_TEST(ledger.closes());
  BOOST_TEST(ledger.initial.square_metres() == 2500.0);
  BOOST_TEST(std::abs(ledger.snap.square_metres()) < 1e-9 * 2500.0);
}

BOOST_AUTO_TEST_CASE(no_floe_flies) {
  const model::Case& c = validation_case();
  for (const model::Frame& frame : validation_run().results.frames)
    for (const model::FloePose& floe : frame.floes) {
      // A floe that floats on edge reaches this high; one that is thrown up reaches higher.
      const double half_length = 0.5 * std::sqrt(validation_run().results.floes.at(floe.floe).area) + c.ice.thickness;
      BOOST_TEST(floe.pose.position.z < half_length);
    }
  // The structure's speed plus the speed of a rising plate with C_d = 1, sqrt(2 (1 - rho_i/rho_w) g h).
  const double rise = std::sqrt(2.0 * (1.0 - c.ice.density / c.water.density) * 9.81 * c.ice.thickness);
  BOOST_TEST(validation_run().summary.fastest_floe.value() < 2.0 * (model::speed(c.structure.motion) + rise));
}

BOOST_AUTO_TEST_CASE(the_channel_is_a_little_wider_than_the_structure) {
  double widest = 0.0;
  for (const model::CrackEvent& event : validation_run().results.events)
    widest = std::max(widest, std::abs(event.at.y));
  const double width = std::get<model::Cone>(validation_case().structure.shape).waterline_width;
  BOOST_TEST(widest > 0.4 * width);
  BOOST_TEST(widest < 0.6 * width);
}

}  // namespace
