// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of the preset brash for the water, in the stage that applies them.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brash/hydrodynamics/structure_flow.hpp"
#include "brash/simulation/run.hpp"
#include "floating_floe.hpp"
#include "pool.hpp"

namespace {

using namespace brash;
using namespace brash::simulation;
using namespace brash::simulation::testing;
namespace tt = boost::test_tools;

std::vector<std::string> laws_of_the_water(std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"hydrodynamics.added_mass_law=plate", "hydrodynamics.form_drag_along=normal",
                             "hydrodynamics.ventilation=true"});
  return more;
}

BOOST_AUTO_TEST_CASE(a_square_plate_heaves_with_half_the_added_mass_of_a_square) {
  FloatingFloe floe(2.0, 2.0, ice_and_water(laws_of_the_water(without_drag())));
  floe.place(0.01, 0.0);  // the top stays out of the water
  const Oscillation heave = oscillate(
      floe, [&] { return floe.heave(); }, 1e-3, 21);
  const double ice = 900.0 * 0.33 * 4.0, water = 0.5 * 1025.0 * kPi / 4.0 * 8.0 * 0.579;
  BOOST_TEST(heave.period == 2.0 * kPi * std::sqrt((ice + water) / (1025.0 * kGravity * 4.0)), tt::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(a_plate_without_added_mass_heaves_with_its_own_mass) {
  auto laws = without_drag();
  laws.emplace_back("hydrodynamics.added_mass_law=none");
  FloatingFloe floe(2.0, 2.0, ice_and_water(laws));
  floe.place(0.01, 0.0);
  const Oscillation heave = oscillate(
      floe, [&] { return floe.heave(); }, 1e-3, 21);
  BOOST_TEST(heave.period == 2.0 * kPi * std::sqrt(900.0 * 0.33 / (1025.0 * kGravity)), tt::tolerance(1e-3));
  BOOST_TEST(floe.inertia().mass == 900.0 * 0.33 * 4.0, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_floe_in_the_air_falls_without_added_mass) {
  FloatingFloe floe(2.0, 2.0, ice_and_water(laws_of_the_water()));
  floe.place(5.0, 0.3);
  floe.step(1e-3);
  BOOST_TEST(floe.world.twist(floe.body).linear.z == -kGravity * 1e-3, tt::tolerance(1e-12));
  BOOST_TEST(floe.inertia().added_across == 0.0);
  BOOST_TEST(floe.inertia().mass == 900.0 * 0.33 * 4.0, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_plate_that_falls_flat_into_the_water_keeps_its_momentum) {
  // Von Karman's impact: the bottom is wet at once, and the water under it takes its share.
  FloatingFloe floe(2.0, 2.0, ice_and_water(laws_of_the_water(without_drag())));
  floe.place(0.5 * 0.33 - floe.rest + 1e-6, 0.0, {{0.0, 0.0, -3.0}, {}});
  const double ice = 900.0 * 0.33 * 4.0, water = 0.5 * 1025.0 * kPi / 4.0 * 8.0 * 0.579;
  floe.step(1e-5);
  floe.step(1e-5);
  BOOST_TEST(floe.world.twist(floe.body).linear.z == -3.0 * ice / (ice + water), tt::tolerance(2e-3));  // K: 1e-3
  const floes::Floe& state = floe.floes.floes().at(floe.body);
  BOOST_TEST(state.shed == 0.5 * ice * 9.0 * water / (ice + water), tt::tolerance(2e-3));
}

BOOST_AUTO_TEST_CASE(a_plate_pressed_under_is_held_up_by_the_air_on_its_top) {
  FloatingFloe floe(3.0, 2.0, ice_and_water(laws_of_the_water(without_drag())));
  // Its top 0.2 m under water at once: no water has run in but for the front of one step.
  const double depth = 0.2, dt = 1e-3;
  floe.place(-floe.rest - 0.5 * 0.33 - depth, 0.0);
  floe.step(dt);
  const floes::Floe& state = floe.floes.floes().at(floe.body);
  const double flooded = 2.0 * std::sqrt(kGravity * depth) * dt / 1.0;
  BOOST_TEST(state.pressure.force.z == (1.0 - flooded) * 1025.0 * kGravity * 6.0 * depth, tt::tolerance(1e-9));
  // Held there until the front has run 1 m, it has buoyancy alone.
  for (int i = 0; i < 400; ++i) {
    floe.place(-floe.rest - 0.5 * 0.33 - depth, 0.0);
    floe.step(dt);
  }
  BOOST_TEST(state.pressure.force.z == 0.0);
  BOOST_TEST(floe.floes.floes().at(floe.body).wet_share == 1.0, tt::tolerance(1e-12));
}

/// Energies of a crowd that collides, tilts and dives for a second, less the energies at its start [J].
double error_of_a_crowd(double dt, const std::vector<std::string>& overrides) {
  Pool pool(overrides);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      pool.add({1.0 * i, 1.0 * j}, {i + 0.98, j + 0.98},
               {{0.8 * (1 - i), 0.6 * (1 - j), 0.2 * ((i + j) % 3 - 1)}, {0.2 * (i - 1), -0.3 * (j - 1), 0.4}});
  const double before = pool.world.kinetic_energy();
  model::LoadRow row;
  for (int i = 0; i < std::lround(1.0 / dt); ++i) row = pool.step(dt);
  BOOST_TEST(row.losses.floe_contact > 0.0);
  return (row.energy_error + before) / before;
}

BOOST_AUTO_TEST_CASE(the_balance_of_energy_closes_with_all_laws_and_in_a_current) {
  for (const char* const current : {"water.current=[0, 0]", "water.current=[0.5, -0.2]"}) {
    const double coarse = std::abs(error_of_a_crowd(0.01, laws_of_the_water({current})));
    const double fine = std::abs(error_of_a_crowd(0.001, laws_of_the_water({current})));
    BOOST_TEST_MESSAGE(current << ": error of the balance " << coarse << " at 0.01 s, " << fine << " at 0.001 s");
    BOOST_TEST(coarse < 0.01);
    BOOST_TEST(fine < 0.3 * coarse);
  }
}

BOOST_AUTO_TEST_CASE(a_floe_does_in_a_current_as_it_does_in_water_at_rest) {
  // Galilei: the same motion against the water, to rounding. The quadrature of skin friction is not that exact:
  // rounding decides how it divides a face.
  const Vec3 current{0.7, -0.4, 0.0};
  FloatingFloe still(3.0, 2.0, ice_and_water(laws_of_the_water({"hydrodynamics.skin_friction=0"})));
  FloatingFloe drifting(
      3.0, 2.0, ice_and_water(laws_of_the_water({"hydrodynamics.skin_friction=0", "water.current=[0.7, -0.4]"})));
  const Twist moves{{0.5, 0.3, -0.8}, {0.9, -0.5, 0.2}};
  still.place(-0.3, 0.8, moves);
  drifting.place(-0.3, 0.8, {moves.linear + current, moves.angular});
  for (int i = 1; i <= 300; ++i) {
    still.step(0.01);
    drifting.step(0.01);
    const Pose a = still.world.pose(still.body), b = drifting.world.pose(drifting.body);
    BOOST_TEST(norm(b.position - 0.01 * i * current - a.position) < 1e-9);
    BOOST_TEST(norm(drifting.world.twist(drifting.body).linear - current - still.world.twist(still.body).linear) <
               1e-9);
  }
  BOOST_TEST(norm(still.world.twist(still.body).linear - moves.linear) > 0.1);
}

BOOST_AUTO_TEST_CASE(a_floe_as_heavy_as_the_water_goes_with_the_water_that_gives_way) {
  FloatingFloe floe(0.2, 0.2,
                    ice_and_water(laws_of_the_water({"ice.density=949.999", "water.density=950", "ice.thickness=0.02",
                                                     "contact.margin=1e-3", "hydrodynamics.structure_flow=true",
                                                     "hydrodynamics.ventilation=false"})));
  const double speed = 1.202, dt = 1e-3;
  const auto body = structure::fitted_ellipsoid(*structure::make_hull(floe.ice.structure.shape));
  const hydrodynamics::StructureFlow flow(body.semi_axes);
  structure::State cone{{{-9.0, 1.0, 0.0}, {}}, {{speed, 0.0, 0.0}, {}}};
  Vec3 particle{0.0, 0.0, -2.0};
  const auto there = [&](Vec3 at) { return flow.at(at - Vec3{cone.pose.position.x, 1.0, 0.0}, {speed, 0.0}); };
  floe.world.set_state(floe.body, {particle, {}}, {there(particle), {}});
  for (int i = 0; i < 1000; ++i) {
    floe.water.apply(floe.world, floe.floes, dt, cone);
    floe.world.step(dt);
    const Vec3 half = particle + 0.5 * dt * there(particle);
    cone.pose.position.x += 0.5 * dt * speed;
    particle += dt * there(half);
    cone.pose.position.x += 0.5 * dt * speed;
  }
  // It weighs 1e-6 less than the water and its size is 0.1 m; the water has gone 0.1 m.
  BOOST_TEST(norm(particle - Vec3{0.0, 0.0, -2.0}) > 0.1);
  BOOST_TEST(norm(floe.world.pose(floe.body).position - particle) < 1e-3);
}

BOOST_AUTO_TEST_CASE(accelerated_water_pushes_a_tilted_floe_at_the_centre_of_the_water_that_it_displaces) {
  FloatingFloe floe(
      3.0, 2.0,
      ice_and_water(laws_of_the_water({"hydrodynamics.structure_flow=true", "hydrodynamics.ventilation=false"})));
  floe.place(0.0, 0.3);
  const Pose pose = floe.world.pose(floe.body);
  const structure::State cone{{{-9.0, 1.0, 0.0}, {}}, {{1.202, 0.0, 0.0}, {}}};
  floe.water.apply(floe.world, floe.floes, 0.01, cone);
  const floes::Floe& state = floe.floes.floes().at(floe.body);
  const auto wet = hydrodynamics::displacement(state.prism, pose);
  const hydrodynamics::StructureFlow flow(
      structure::fitted_ellipsoid(*structure::make_hull(floe.ice.structure.shape)).semi_axes);
  const Vec3 a = flow.acceleration(pose.position - cone.pose.position, {1.202, 0.0});
  const Vec3 arm = wet.centre - pose.position;
  const Vec3 expected = cross(arm, 1025.0 * wet.volume * a);
  BOOST_TEST(norm(arm) > 0.05);
  BOOST_TEST(norm(state.pressure.moment - expected) < 1e-9 * norm(expected));
}

/// The validation case by the preset brash, cut short, with a failure model that is quick.
model::Case short_case(std::vector<std::string> overrides, double duration) {
  overrides.insert(overrides.end(), {"algorithm.preset=brash", "failure.model=superposition",
                                     "time.duration=" + std::to_string(duration)});
  return io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml", overrides);
}

BOOST_AUTO_TEST_CASE(ice_that_drifts_loads_a_structure_at_rest_as_a_structure_that_moves_loads_itself) {
  const Run moves = simulation::run(short_case({}, 3.0));
  const Run drifts = simulation::run(short_case({"structure.motion.frame=ice-drifts"}, 3.0));
  BOOST_TEST(moves.summary.n_breaks > 0);
  BOOST_TEST((moves.results.loads == drifts.results.loads));
}

BOOST_AUTO_TEST_CASE(a_run_with_all_laws_goes_on_from_a_checkpoint_to_the_bit) {
  const model::Case resolved = short_case({}, 4.0);
  Simulation whole(resolved);
  std::optional<Simulation> twin;
  while (whole.time() < 4.0 - 1e-9) {
    if (!twin && whole.time() > 3.0) twin.emplace(resolved, whole.checkpoint());
    const model::LoadRow loads = whole.step().loads;
    if (!twin) continue;
    BOOST_REQUIRE((twin->step().loads == loads));
    BOOST_REQUIRE((twin->frame() == whole.frame()));
  }
  BOOST_TEST(twin.has_value());
}

}  // namespace
