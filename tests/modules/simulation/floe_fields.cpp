// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of floes: their drift, two that collide, a jam against a wall, and whole runs (docs/theory/ice.md).
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "brash/advice/advice.hpp"
#include "brash/core/error.hpp"
#include "brash/simulation/initial_floes.hpp"
#include "brash/simulation/run.hpp"
#include "floating_floe.hpp"
#include "laid_floes.hpp"
#include "pool.hpp"

namespace {

using namespace brash;
using namespace brash::simulation;
using namespace brash::simulation::testing;
namespace tt = boost::test_tools;

/// A short run through some dozens of floes.
model::Case field_case(const std::vector<std::string>& more = {}) {
  std::vector<std::string> overrides{"field.length=60",
                                     "field.width=60",
                                     "field.concentration=0.6",
                                     "field.size.least=4",
                                     "field.size.largest=12",
                                     "time.duration=3",
                                     "time.step=0.01",
                                     "structure.start_distance=7",
                                     "output.frames_per_second=1",
                                     "output.statistics_from=0"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return io::read_case(BRASH_SOURCE_DIR "/experiments/fields/cone.toml", overrides);
}

/// A square floe of side `l` that a wind U and a current along it drive: where water and wind balance, ice.md,
/// (F9). Besides friction on the bottom and two sides there is form drag on one end.
double free_drift(const model::Case& c, double l, double wind, double current) {
  const double draught = c.ice.thickness * c.ice.density / c.water.density;
  const model::HydrodynamicsSection& h = c.hydrodynamics;
  const double air = c.wind.density * c.wind.skin_friction * l * l;
  const double water =
      0.5 * c.water.density * (h.skin_friction * (l * l + 2.0 * l * draught) + h.form_drag * l * draught);
  const double nansen = std::sqrt(air / water);
  return current + nansen / (1.0 + nansen) * (wind - current);
}

BOOST_AUTO_TEST_SUITE(floe_fields)

BOOST_AUTO_TEST_CASE(a_lone_floe_comes_to_the_free_drift_of_wind_and_current) {
  for (const double current : {0.0, 0.3, -0.2}) {
    FloatingFloe floe(10.0, 10.0,
                      ice_and_water({"wind.velocity=[15, 0]", "water.current=[" + std::to_string(current) + ", 0]"}));
    for (int i = 0; i < 30000; ++i) floe.step(0.05);  // 1500 s, of which a tenth would do
    const double expected = free_drift(floe.ice, 10.0, 15.0, current);
    // The wind turns the floe by a hair, and the water meets a draught that differs by as much.
    BOOST_TEST(floe.world.twist(floe.body).linear.x == expected, tt::tolerance(1e-3));
  }
}

BOOST_AUTO_TEST_CASE(no_wind_drags_a_top_that_is_under_water_and_half_of_a_half_sunk_one) {
  FloatingFloe floe(4.0, 4.0, ice_and_water());
  const Prism& prism = floe.floes.at(floe.body).prism;
  const hydrodynamics::Wind wind{{10.0, 0.0, 0.0}, 1.3, 0.0015};
  const double whole = 1.3 * 0.0015 * 16.0 * 100.0;
  const auto force = [&](const Pose& pose) { return hydrodynamics::wind_load(prism, pose, {}, wind).force.x; };
  BOOST_TEST(force({{0.0, 0.0, 0.0}, {}}) == whole, tt::tolerance(1e-12));
  BOOST_TEST(force({{0.0, 0.0, -1.0}, {}}) == 0.0);
  // Turned by 0.5 rad about y, with the middle of its top on the water's surface.
  const Quaternion turned{std::cos(0.25), 0.0, std::sin(0.25), 0.0};
  const Vec3 top = rotate(turned, {0.0, 0.0, 0.5 * prism.thickness});
  BOOST_TEST(force({{0.0, 0.0, -top.z}, turned}) == 0.5 * whole, tt::tolerance(1e-12));
  const Quaternion over{0.0, 1.0, 0.0, 0.0};
  BOOST_TEST(force({{0.0, 0.0, 0.0}, over}) == 0.0);
}

BOOST_AUTO_TEST_CASE(two_floes_that_collide_go_on_together_with_their_momentum) {
  Pool pool(without_drag());
  const BodyId one = pool.add({0.0, -1.5}, {3.0, 1.5}, {{0.3, 0.0, 0.0}, {}});
  const BodyId other = pool.add({3.02, -1.0}, {5.02, 1.0}, {});
  const auto mass = [&](BodyId body) { return pool.floes.at(body).inertia.mass; };  // along the plate
  const auto velocity = [&](BodyId body) { return pool.world.twist(body).linear.x; };
  const double momentum = mass(one) * 0.3, energy = 0.5 * mass(one) * 0.09;
  const model::LoadRow before = pool.step(0.002);
  model::LoadRow after;
  for (int i = 0; i < 500; ++i) after = pool.step(0.002);
  const double together = momentum / (mass(one) + mass(other));
  // Restitution 0: both have the velocity of the common centre of mass. Rocking after the blow leaves a thousandth.
  BOOST_TEST(mass(one) * velocity(one) + mass(other) * velocity(other) == momentum, tt::tolerance(1e-6));
  BOOST_TEST(velocity(one) == together, tt::tolerance(5e-3));
  BOOST_TEST(velocity(other) == together, tt::tolerance(5e-3));
  const double lost = before.kinetic_energy + before.potential_energy - after.kinetic_energy - after.potential_energy;
  BOOST_TEST(lost == energy * mass(other) / (mass(one) + mass(other)), tt::tolerance(1e-2));
}

BOOST_AUTO_TEST_CASE(a_jam_presses_on_the_wall_with_the_wind_on_all_its_floes) {
  Pool pool({"wind.velocity=[20, 0]"});
  pool.resolved.field.kind = model::FieldKind::kFloes;
  pool.resolved.field.length = 20.0;
  pool.resolved.field.width = 10.0;
  pool.resolved.field.floes.border = model::FloeBorder::kWalls;
  lay_borders(pool.resolved, pool.world);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j) {
      const double x = 19.9 - 3.05 * (i + 1), y = -3.05 + 3.1 * j;  // clear of the walls along the sides
      pool.add({x, y}, {x + 3.0, y + 3.0}, {});
    }
  double impulse = 0.0;
  constexpr double kStep = 0.01;
  constexpr int kSettle = 12000, kCount = 3000;
  for (int i = 0; i < kSettle + kCount; ++i) {
    (void)pool.step(kStep);
    if (i < kSettle) continue;
    for (const rigid_body::ContactLoad& contact : pool.world.contacts()) {
      if (contact.other_kind != rigid_body::BodyKind::kSheet) continue;
      impulse -= kStep * (contact.normal_force * contact.normal.x + contact.friction_force.x);
    }
  }
  // ice.md, (F10): the wall bears the wind on 8 floes, each 9 m2, as a mean over 30 s. What is left is their
  // last motion.
  const double wind = 1.3 * 0.0015 * 400.0 * 8.0 * 9.0;
  BOOST_TEST(impulse / (kCount * kStep) == wind, tt::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(the_concentration_of_a_field_with_land_is_of_its_water) {
  const std::filesystem::path shore = std::filesystem::temp_directory_path() / "brash_shore_of_a_field.wkt";
  std::ofstream(shore) << "POLYGON((30 -40, 70 -40, 70 40, 30 40, 30 -40))";  // over half of the field and beyond it
  const Run run = simulation::run(field_case(
      {"field.shore=" + shore.string(), "field.shape=discs", "field.concentration=0.4", "time.duration=0.02"}));
  std::filesystem::remove(shore);
  BOOST_REQUIRE(run.summary.initial_floes.has_value());
  const double found = run.summary.initial_floes->concentration;
  BOOST_TEST(found == run.summary.ledger.initial.square_metres() / 1800.0, tt::tolerance(1e-9));
  BOOST_TEST(std::abs(found - 0.4) < 0.5 * 144.0 / 1800.0);  // half of the largest floe
}

BOOST_AUTO_TEST_CASE(a_run_through_a_field_closes_its_ledger_and_its_energies) {
  const Run run = advice::run(field_case({"field.border=walls", "wind.velocity=[10, 5]"}));
  BOOST_TEST(run.complete);
  const RunSummary& s = run.summary;
  BOOST_TEST(s.ledger.closes());
  BOOST_TEST((s.ledger.sheet == geometry::ExactArea{}));
  BOOST_REQUIRE(s.initial_floes.has_value());
  BOOST_TEST(s.initial_floes->concentration == s.ledger.initial.square_metres() / 3600.0, tt::tolerance(1e-9));
  BOOST_TEST(std::abs(s.initial_floes->concentration - 0.6) < 0.5 * 144.0 / 3600.0);
  BOOST_TEST(s.initial_floes->size_quantiles.front() >= 4.0);
  BOOST_TEST(s.initial_floes->size_quantiles.back() <= 12.0);
  BOOST_TEST(run.results.loads.back().n_floes > 20);
  for (const model::Warning& warning : s.warnings) BOOST_TEST(warning.id != "no-breaks");  // floes alone bear
  BOOST_TEST(s.horizontal.maximum > 0.0);                                                  // the cone has met floes
}

BOOST_AUTO_TEST_CASE(a_field_that_sleeps_until_it_is_pushed_gives_the_structure_the_same_impulse) {
  const std::vector<std::string> common{"field.border=walls", "time.duration=8"};
  const auto with = [&](const std::string& more) {
    std::vector<std::string> overrides = common;
    overrides.push_back(more);
    return simulation::run(field_case(overrides));
  };
  const double slow = 0.02;
  const Run asleep = with("time.settle_speed=0.02"), awake = with("time.settle_speed=0");
  const auto impulse = [](const Run& run) {
    double sum = 0.0;
    for (const model::LoadRow& row : run.results.loads) sum += 0.01 * row.total.force.x;
    return sum;
  };
  // Up to the first blow nothing differs. After it no floe's speed is off by more than `slow`.
  std::size_t first = 0;
  while (awake.results.loads[first].total.force.x == 0.0) ++first;
  BOOST_TEST(asleep.results.loads[first].total.force.x == awake.results.loads[first].total.force.x);
  const double mass = awake.summary.ledger.floes.square_metres() * 0.33 * 900.0;
  BOOST_TEST(impulse(awake) > 2.0 * slow * mass);
  BOOST_TEST(std::abs(impulse(asleep) - impulse(awake)) < slow * mass);
  BOOST_TEST(asleep.summary.ledger.closes());
}

BOOST_AUTO_TEST_CASE(a_field_in_a_current_or_wind_begins_awake) {
  for (const std::string drive :
       {"water.current=[0.2, 0]", "wind.velocity=[10, 0]", "structure.motion.frame=ice-drifts-through-still-water"}) {
    const Run run = simulation::run(field_case({"time.settle_speed=0.05", "time.duration=1", drive}));
    BOOST_TEST(run.results.loads.back().kinetic_energy > 0.0);
    Run still = simulation::run(field_case({"time.settle_speed=0", "time.duration=1", drive}));
    BOOST_TEST(run.results.loads.back().kinetic_energy == still.results.loads.back().kinetic_energy,
               tt::tolerance(1e-2));  // one slow floe may touch another
  }
}

BOOST_AUTO_TEST_CASE(a_field_runs_in_a_fast_current) {
  simulation::Simulation simulation(field_case({"time.duration=0.05", "water.current=[-2, 1]"}));
  model::LoadRow row;
  for (int i = 0; i < 5; ++i) row = simulation.step().loads;  // the watchdog would throw
  BOOST_TEST(row.kinetic_energy > 1e6);
  BOOST_TEST(row.birth_energy == row.kinetic_energy, tt::tolerance(0.1));
  BOOST_TEST(std::abs(row.energy_error) < 1e-3 * row.kinetic_energy);
}

BOOST_AUTO_TEST_CASE(a_resumed_run_ends_with_the_same_bytes) {
  for (const std::string sleep : {"time.settle_speed=0", "time.settle_speed=0.05"}) {
    const model::Case resolved = field_case({"time.duration=3", sleep});
    simulation::Simulation whole(resolved), first(resolved);
    for (int i = 0; i < 150; ++i) (void)whole.step(), (void)first.step();
    simulation::Simulation second(resolved, first.checkpoint());
    for (int i = 0; i < 150; ++i) (void)whole.step(), (void)second.step();
    BOOST_TEST((whole.checkpoint() == second.checkpoint()));
  }
}

BOOST_AUTO_TEST_CASE(a_floe_meets_the_water_of_a_structure_where_both_are_at_the_start_of_a_step) {
  const auto folder = std::filesystem::temp_directory_path() / "brash_field_of_one";
  std::filesystem::create_directories(folder);
  const std::string file = (folder / "floe.geojson").string();
  std::ofstream(file) << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},
    "geometry":{"type":"Polygon","coordinates":[[[5,-1],[7,-1],[7,1],[5,1],[5,-1]]]}}]})";
  const model::Case resolved =
      io::read_case(BRASH_SOURCE_DIR "/tests/experiments/field-of-file.toml",
                    std::vector<std::string>{"field.file=" + file, "time.step=0.1", "time.duration=1"});
  simulation::Simulation run(resolved);
  FloatingFloe alone(2.0, 2.0, resolved);
  structure::State cone = run.structure();
  cone.pose.position.x -= 6.0;
  for (int i = 0; i < 5; ++i) {
    alone.water.apply(alone.world, alone.floes, resolved.time.step, cone);
    alone.world.step(resolved.time.step);
    (void)run.step();
    cone.pose.position = run.structure().pose.position - Vec3{6.0, 0.0, 0.0};
  }
  const double way = alone.world.pose(alone.body).position.x;
  BOOST_TEST(way > 0.005);
  BOOST_TEST(run.frame().floes[0].pose.position.x - 6.0 == way, tt::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(floes_of_a_file_have_their_own_ice_and_may_not_lie_under_the_structure) {
  const auto folder = std::filesystem::temp_directory_path() / "brash_field_of_file";
  std::filesystem::create_directories(folder);
  const std::string file = (folder / "floes.geojson").string();
  std::ofstream(file) << R"({"type":"FeatureCollection","features":[
    {"type":"Feature","properties":{"thickness":0.5},"geometry":{"type":"Polygon",
     "coordinates":[[[5,-5],[15,-5],[15,5],[5,5],[5,-5]]]}},
    {"type":"Feature","properties":{},"geometry":{"type":"Polygon",
     "coordinates":[[[20,-5],[30,-5],[30,5],[20,5],[20,-5]]]}}]})";
  const auto of_file = [&](const std::vector<std::string>& more) {
    std::vector<std::string> overrides{"field.file=" + file, "field.length=60", "field.width=60", "time.duration=0.1"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return io::read_case(BRASH_SOURCE_DIR "/tests/experiments/field-of-file.toml", overrides);
  };
  const simulation::Simulation started(of_file({}));
  BOOST_REQUIRE(started.initial_births().size() == 2u);
  BOOST_TEST(started.initial_births()[0].thickness == 0.5);
  BOOST_TEST(started.initial_births()[1].thickness == 0.33);
  BOOST_TEST(initial_field(of_file({})).area == 200.0);
  BOOST_CHECK_EXCEPTION((void)simulation::Simulation(of_file({"structure.start_distance=-10"})), InputError,
                        [](const InputError& error) {
                          return std::string(error.what()).find("starts inside a floe") != std::string::npos;
                        });
  std::filesystem::remove_all(folder);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
