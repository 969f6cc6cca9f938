// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/hydrodynamics/ventilation.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/constants.hpp"
#include "shapes.hpp"

namespace {

using namespace brash;
using namespace brash::test;
using hydrodynamics::flooded_share;
using hydrodynamics::ran_in_after;
using hydrodynamics::sunk_top;
using hydrodynamics::SunkTop;
namespace tt = boost::test_tools;

constexpr double kWater = 1025.0;

/// Work against the pressure that the dry top lacks while a level plate is pushed down by `depth` at `speed` [J].
double work_to_drown(const Prism& plate, double depth, double speed) {
  constexpr int kSteps = 20000;
  const double step = depth / kSteps;
  double work = 0.0, ran = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double d = (i + 0.5) * step;
    const SunkTop top = sunk_top(plate, {{0.0, 0.0, -0.5 * plate.thickness - d}, {}}, kWater);
    ran = ran_in_after(ran, top, step / speed);
    work += -(1.0 - flooded_share(ran, top)) * top.pressure.force.z * step;
  }
  return work;
}

BOOST_AUTO_TEST_CASE(the_pressure_on_a_sunk_top_is_hydrostatic) {
  const Prism plate = notched_plate(0.4);
  const SunkTop level = sunk_top(plate, {{0.0, 0.0, -1.2}, {}}, kWater);
  BOOST_TEST(level.mean_depth == 1.0, tt::tolerance(1e-12));
  BOOST_TEST(level.pressure.force.z == -kWater * kGravity * 13.0, tt::tolerance(1e-12));
  BOOST_TEST(norm(level.pressure.moment) < 1e-9);  // its centre of area is the centre of mass

  // A box on its long edge, tilted: the sunk part is a rectangle with a triangular pressure.
  const double angle = 0.6, h = 0.4;
  const Prism floe = box(3.0, 2.0, h);
  const SunkTop tilted = sunk_top(floe, {{0.0, 0.0, -0.3}, turn({1.0, 0.0, 0.0}, angle)}, kWater);
  const double deepest = 0.3 + std::sin(angle) - 0.5 * h * std::cos(angle), length = deepest / std::sin(angle);
  const double force = 0.5 * kWater * kGravity * deepest * 3.0 * length;
  BOOST_TEST(norm(tilted.pressure.force) == force, tt::tolerance(1e-12));
  BOOST_TEST(tilted.mean_depth == 0.5 * deepest, tt::tolerance(1e-12));
  // It acts at a third of the length from the deep edge, y = -1 m, along the plate's normal.
  BOOST_TEST(tilted.pressure.moment.x == force * (1.0 - length / 3.0), tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_top_with_an_edge_on_the_waterline_bears_the_whole_pressure) {
  const Prism plate = box(2.0, 2.0, 0.3);
  const Quaternion tilt = turn({1.0, 0.0, 0.0}, kPi / 6.0);
  const Vec3 up = rotate(conjugate(tilt), {0.0, 0.0, 1.0});
  const Pose pose{{0.0, 0.0, -dot(up, {1.0, 1.0, 0.15})}, tilt};
  BOOST_REQUIRE(dot(up, {-1.0, 1.0, 0.15}) + pose.position.z == 0.0);  // both ends of the edge, to the last bit
  // The other edge is 2 m sin(30 degrees) = 1 m deep: a mean depth of 0.5 m on 4 m2.
  const SunkTop top = sunk_top(plate, pose, kWater);
  BOOST_TEST(top.mean_depth == 0.5, tt::tolerance(1e-12));
  BOOST_TEST(norm(top.pressure.force) == kWater * kGravity * 2.0, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_plate_pushed_down_fast_is_drowned_against_the_whole_pressure) {
  const Prism plate = box(3.0, 2.0, 0.3);
  BOOST_TEST(work_to_drown(plate, 0.5, 1e6) == 0.5 * kWater * kGravity * 6.0 * 0.25, tt::tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(the_energy_to_drown_a_plate_follows_from_the_dam_break) {
  // The front has run 4/3 sqrt(g) d^(3/2) / V at the depth d, and covers l = a/2 at D = (3 l V / (4 sqrt(g)))^(2/3).
  // The work up to there is 3/14 rho g A D^2, and no more comes.
  const Prism plate = box(3.0, 2.0, 0.3);
  for (const double speed : {0.3, 1.2}) {
    const double depth = std::pow(0.75 * 1.0 * speed / std::sqrt(kGravity), 2.0 / 3.0);
    const double energy = 3.0 / 14.0 * kWater * kGravity * 6.0 * depth * depth;
    BOOST_TEST(work_to_drown(plate, 2.0 * depth, speed) == energy, tt::tolerance(2e-3));  // the step: 1e-4 of the depth
  }
  BOOST_TEST(work_to_drown(plate, 1.0, 1e-6) < 1e-6);  // slowly: buoyancy alone
}

BOOST_AUTO_TEST_CASE(a_top_out_of_the_water_is_dry_again_and_one_that_looks_down_holds_no_air) {
  const Prism plate = box(3.0, 2.0, 0.3);
  const SunkTop out = sunk_top(plate, {{0.0, 0.0, 0.1}, {}}, kWater);
  BOOST_TEST(out.mean_depth == 0.0);
  BOOST_TEST(ran_in_after(0.7, out, 0.01) == 0.0);
  const SunkTop upside_down = sunk_top(plate, {{0.0, 0.0, -2.0}, turn({1.0, 0.0, 0.0}, kPi)}, kWater);
  BOOST_TEST(norm(upside_down.pressure.force) == 0.0);
  BOOST_TEST(flooded_share(0.0, upside_down) == 1.0);
}

/// The top of a box of 3 m by 2 m whose centre lies `depth` under water, turned about its long axis by `angle`.
SunkTop top_turned(double angle, double depth) {
  return sunk_top(box(3.0, 2.0, 0.33), {{0.0, 0.0, -depth}, turn({1.0, 0.0, 0.0}, angle)}, kWater);
}

BOOST_AUTO_TEST_CASE(a_flooded_top_that_turns_past_the_vertical_and_back_stays_flooded) {
  for (const double depth : {1.5, 0.5}) {  // deep, and with an edge out of the water
    double ran = ran_in_after(0.0, top_turned(0.6, depth), 10.0);
    for (const double angle : {0.6, 1.5, 1.6, 2.6, 1.6, 1.5, 0.6}) {
      const SunkTop top = top_turned(angle, depth);
      ran = ran_in_after(ran, top, 0.001);
      BOOST_TEST(flooded_share(ran, top) == 1.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_dry_top_is_flooded_when_it_looks_down_into_the_water_and_stays_dry_in_the_air) {
  const SunkTop sunk = top_turned(1.5, 1.5), in_water = top_turned(1.6, 1.5), in_air = top_turned(1.6, -2.0);
  BOOST_TEST(norm(sunk.pressure.force) > 0.0);
  BOOST_TEST(flooded_share(ran_in_after(0.0, sunk, 0.0), sunk) == 0.0);
  BOOST_TEST(flooded_share(ran_in_after(ran_in_after(0.0, in_water, 0.0), sunk, 0.0), sunk) == 1.0);
  BOOST_TEST(ran_in_after(1.0, in_air, 0.01) == 0.0);
}

}  // namespace
