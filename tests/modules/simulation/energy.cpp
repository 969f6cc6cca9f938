// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>

#include "brash/core/constants.hpp"
#include "brash/io/case.hpp"
#include "brash/simulation/run.hpp"
#include "pool.hpp"

namespace {

using namespace brash;
using namespace brash::simulation;
using namespace brash::simulation::testing;

BOOST_AUTO_TEST_CASE(what_a_drifting_floe_loses_is_the_power_of_its_drag) {
  Pool pool;
  const BodyId floe = pool.add({0, 0}, {3, 2}, {{0.9, 0, 0}, {}});
  const double before = pool.world.kinetic_energy();
  const double dt = 1e-4;
  const model::LoadRow row = pool.step(dt);
  const double draft = 0.33 * 900.0 / 1025.0;
  // Form drag on the front face, skin friction on the bottom and the two long sides.
  const double form = 0.5 * 1025.0 * 1.0 * (2.0 * draft) * std::pow(0.9, 3);
  const double skin = 0.5 * 1025.0 * 0.005 * (3.0 * 2.0 + 2.0 * 3.0 * draft) * std::pow(0.9, 3);
  // The speed changes by 1e-5 of itself in the step.
  BOOST_TEST(row.losses.drag == dt * form, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(row.losses.skin_friction == dt * skin, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(std::abs(before - pool.world.kinetic_energy(floe) - row.losses.total()) < 1e-9);  // round-off of 1000 J
}

BOOST_AUTO_TEST_CASE(crushed_ice_has_cost_the_work_of_its_crushing) {
  // Without friction the structure's work at the edge is crushing alone. Ice that breaks off takes its bevel along.
  for (const char* model : {"superposition", "network"}) {
    const model::Case resolved =
        io::read_case(BRASH_SOURCE_DIR "/experiments/validation/second_reading.toml",
                      {std::string("failure.model=") + model, "ice.friction_structure=0", "time.duration=8"});
    const Run run = simulation::run(resolved);
    const double volume = run.summary.ledger.crushed.square_metres() * resolved.ice.thickness;
    const double least = volume * resolved.ice.compressive_strength * resolved.ice.crushing_factor;
    const double work = run.results.loads.back().losses.edge;
    BOOST_TEST_MESSAGE(model << ": " << least / 1e3 << " kJ to crush the ice, " << work / 1e3 << " kJ of work");
    BOOST_TEST(run.summary.n_breaks > 5);
    BOOST_TEST(work >= least);
  }
}

BOOST_AUTO_TEST_CASE(a_current_gives_a_resting_floe_its_energy) {
  Pool pool({"water.current=[0.5, 0.0]"});
  pool.add({0, 0}, {3, 2}, {});
  model::LoadRow row;
  for (int i = 0; i < 100; ++i) row = pool.step(0.01);
  BOOST_TEST(row.losses.drag < 0.0);
  BOOST_TEST(row.losses.skin_friction < 0.0);
  BOOST_TEST(row.kinetic_energy > 1.0);
  // Pushed below its centre of mass the floe tilts; the step of 0.01 s leaves less than 1 % of its energy open.
  BOOST_TEST(std::abs(row.energy_error) < 0.01 * row.kinetic_energy);
}

/// Energies of a crowd that collides, tilts and dives for a second, less the energies at its start [J].
double error_of_a_crowd(double dt) {
  Pool pool;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      pool.add({1.0 * i, 1.0 * j}, {i + 0.98, j + 0.98},
               {{0.8 * (1 - i), 0.6 * (1 - j), 0.2 * ((i + j) % 3 - 1)}, {0.2 * (i - 1), -0.3 * (j - 1), 0.4}});
  const double before = pool.world.kinetic_energy();
  model::LoadRow row;
  for (int i = 0; i < std::lround(1.0 / dt); ++i) row = pool.step(dt);
  BOOST_TEST(row.losses.floe_contact > 0.0);
  BOOST_TEST(row.losses.floe_friction > 0.0);
  BOOST_TEST(row.potential_energy > 0.0);
  BOOST_TEST(row.losses.structure_contact == 0.0);
  return (row.energy_error + before) / before;
}

BOOST_AUTO_TEST_CASE(what_the_balance_of_a_crowd_lacks_fades_with_the_time_step) {
  const double coarse = std::abs(error_of_a_crowd(0.01));
  const double fine = std::abs(error_of_a_crowd(0.001));
  BOOST_TEST_MESSAGE("error of the balance " << coarse << " at 0.01 s, " << fine << " at 0.001 s");
  BOOST_TEST(coarse < 0.01);
  // First order would be a tenth; collisions differ between the two.
  BOOST_TEST(fine < 0.3 * coarse);
}

BOOST_AUTO_TEST_CASE(no_floe_has_more_energy_than_its_loads_gave_it) {
  // A sloping wall drives a crowd of floes together and under.
  Pool pool;
  std::map<BodyId, double> given;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j) given[pool.add({1.0 * i, 1.2 * j}, {i + 0.98, 1.2 * j + 1.1}, {})] = 0.0;
  const std::vector<Vec3> wall{{-1, -3, -3}, {-2, -3, -3}, {0.1, -3, 1}, {-2, -3, 1},
                               {-1, 6, -3},  {-2, 6, -3},  {0.1, 6, 1},  {-2, 6, 1}};
  Pose place;
  const BodyId structure = pool.world.add_structure(std::span(&wall, 1), place);
  const double dt = 0.01;
  const Vec3 velocity{1.2, 0.0, 0.0};
  double worst = 0.0;
  double fastest = 0.0;
  for (int i = 0; i < 300; ++i) {
    place.position += dt * velocity;
    pool.world.move_structure(structure, place, {velocity, {}});
    (void)pool.step(dt);
    for (const BodyId body : pool.world.moving()) {
      given.at(body) += pool.ledger.received(body);
      worst = std::max(worst, pool.floes.energy(pool.world, body, pool.floes.floes().at(body)) - given.at(body));
      fastest = std::max(fastest, norm(pool.world.twist(body).linear));
    }
  }
  BOOST_TEST_MESSAGE("largest unexplained energy of a floe " << worst << " J, fastest floe " << fastest << " m/s");
  BOOST_TEST(fastest > 1.0);
  // 480 kg with added mass: 5 J move them at 0.15 m/s. The explicit step of weight and buoyancy leaves this.
  BOOST_TEST(worst < 5.0);
}

BOOST_AUTO_TEST_CASE(a_floe_born_with_energy_is_booked_and_a_deleted_one_takes_its_own_along) {
  Pool pool;
  const BodyId floe = pool.add({0, 0}, {3, 2}, {{0.9, 0, 0}, {}});
  const double energy = pool.world.kinetic_energy();
  pool.water.apply(pool.world, pool.floes, 0.01, {});
  pool.world.step(0.01);
  pool.ledger.book_step(pool.world, pool.floes, 0, 0.01);
  model::LoadRow row;
  pool.ledger.report(pool.world, pool.floes, row);
  // Given a velocity at birth, it brings that energy in; drag in the first step is no part of it.
  BOOST_TEST(row.birth_energy == energy, boost::test_tools::tolerance(1e-4));  // tilt by drag in the first step
  BOOST_TEST(std::abs(row.energy_error) < 1e-9);                               // round-off of 1000 J
  pool.ledger.remove(pool.world, pool.floes, floe);
  pool.remove(floe);
  pool.ledger.report(pool.world, pool.floes, row);
  BOOST_TEST(row.removed_energy == row.birth_energy - row.losses.total(), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(row.energy_error) < 1e-9);
}

BOOST_AUTO_TEST_CASE(the_energies_of_a_run_account_for_the_work_of_the_structure) {
  const Run run = brash::simulation::run(io::read_case(kValidation, {"time.duration=3.5", "output.statistics_from=0"}));
  for (const model::LoadRow& row : run.results.loads) {
    const double accounted =
        row.kinetic_energy + row.potential_energy + row.losses.total() + row.removed_energy + row.energy_error;
    BOOST_TEST(std::abs(row.work + row.birth_energy - accounted) <= 1e-9 * (1.0 + row.work));  // rounding of the sum
  }
  const EnergyBalance& e = run.summary.energy;
  BOOST_TEST(e.work > 1e5);
  // The error of the integration in time, first order in the step of 0.01 s: 0.03 % was found.
  BOOST_TEST(std::abs(e.error) < 0.01 * e.work);
  // 5 J were found, where an average step has 800 J of work; 10 J move the smallest floe, 90 kg, at 0.5 m/s.
  BOOST_TEST(e.largest_step_error < 10.0);
  // Floes are born at rest, afloat. The structure pushes them in their first step. The step leaves an error of second
  // order there: 1.2, 0.25 and 0.03 J of the first 5 s at 10, 5 and 2.5 ms.
  BOOST_TEST(std::abs(e.birth_energy) < 1e-5 * e.work);
  model::EnergyLosses::visit_without_bed([&](const char* cause, const char*, double model::EnergyLosses::*loss) {
    // Still water takes energy like everything else; an edge that does not move takes none.
    if (loss == &model::EnergyLosses::bending)
      BOOST_TEST(e.losses.bending == 0.0);
    else
      BOOST_TEST((e.losses.*loss > 0.0), cause);
  });
  // All the work against the edge is lost there.
  double edge = 0.0;
  double work = 0.0;
  for (const model::LoadRow& row : run.results.loads) {
    edge += row.crushing.force.x * 1.202 * 0.01;
    work += row.total.force.x * 1.202 * 0.01;
  }
  BOOST_TEST(e.losses.edge == edge, boost::test_tools::tolerance(1e-12));  // order of summation
  BOOST_TEST(e.work == work, boost::test_tools::tolerance(1e-12));         // likewise
}

}  // namespace
