// SPDX-License-Identifier: GPL-3.0-or-later
// Structures that turn, or are bodies, in the step.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "brash/core/constants.hpp"
#include "brash/floes/plan.hpp"
#include "brash/io/case.hpp"
#include "brash/simulation/run.hpp"
#include "region_loads.hpp"

namespace {

using namespace brash;

/// The validation case with the algorithm of the paper and Nevel's wedges, for some seconds. The program's engine
/// resumes to the bit.
std::string text_of(const std::string& motion, double duration) {
  return "[algorithm]\npreset = \"paper\"\n[contact]\nengine = \"brash\"\n[ice]\nthickness = 0.33\nyoungs_modulus = "
         "0.35e9\nflexural_strength = "
         "539e3\n"
         "[structure]\nangle = \"61.4 deg\"\nwaterline_width = 13.6\nheight = 9.08\nheight_under_water = 5.68\n" +
         motion +
         "[field]\nlength = 50\nwidth = 50\ninitial_crack = false\n[failure]\nmodel = \"wedge\"\n[time]\nduration = " +
         std::to_string(duration) + "\n";
}

model::Case case_of(const std::string& motion, double duration, const std::vector<std::string>& overrides = {}) {
  return io::parse_case(text_of(motion, duration), "motion.toml", overrides);
}

const std::string kTow = "speed = 1.2\nstart_distance = 7\n";
const std::string kFree =
    "speed = 1.2\nstart_distance = 7\n[structure.motion]\nkind = \"free\"\ncentre_of_gravity = [0, 0, 0]\n"
    "added_mass = [1e5, 1e5, 1e5]\nlinear_damping = [0, 0, 2e5]\nangular_damping = [1e6, 1e6, 1e6]\n";
const std::string kMoored =
    "speed = 0.8\nstart_distance = 7\n[structure.motion]\nkind = \"moored\"\nframe = "
    "\"ice-drifts-through-still-water\"\n"
    "lines = [[190, 0, -30, 6, 0, 0, 205, \"1 kN/m\", \"300 MN\"], [-150, 110, -30, -6, 3, 0, 205, 1e3, 3e8],\n"
    "  [-150, -110, -30, -6, -3, 0, 205, 1e3, 3e8]]\nlinear_damping = [1e4, 1e4, 2e5]\n";
const std::string kTurn =
    "[structure.motion]\npath = [[0, -7, 0, 0], [1, -5.8, 0, 0], [2, -4.6, 0.05, \"4 deg\"], [3, -3.4, 0.2, \"9 "
    "deg\"]]\n";

std::vector<model::LoadRow> rows_of(const model::Case& resolved) { return simulation::run(resolved).results.loads; }

/// The rows before the first break, of which floes make much of a rounding afterwards.
std::vector<model::LoadRow> rows_before_break(const model::Case& resolved) {
  simulation::Run run = simulation::run(resolved);
  BOOST_REQUIRE(!run.results.events.empty());
  std::erase_if(run.results.loads,
                [&](const model::LoadRow& row) { return row.time >= run.results.events.front().time; });
  BOOST_REQUIRE(run.results.loads.back().total.force.x > 1e3);
  return run.results.loads;
}

BOOST_AUTO_TEST_SUITE(motions)

BOOST_AUTO_TEST_CASE(a_load_is_told_against_the_heading_and_to_starboard_of_it) {
  const Wrench load{{0.0, -5.0, 2.0}, {3.0, 0.0, 1.0}};
  // The structure heads along y, so the ice resists it along -y, and the moment about x turns it to starboard.
  const Wrench told = simulation::LoadAxes({{}, {std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)}})(load);
  BOOST_TEST(told.force.x == 5.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(std::abs(told.force.y) < 1e-14);
  BOOST_TEST(told.force.z == 2.0);
  BOOST_TEST(told.moment.y == 3.0, boost::test_tools::tolerance(1e-14));
  // Unturned it is the half turn about z, with no negative zeros.
  const Wrench straight = simulation::LoadAxes({})(load);
  BOOST_TEST((straight == Wrench{{0.0, 5.0, 2.0}, {-3.0, 0.0, 1.0}}));
  BOOST_TEST(!std::signbit(straight.force.x));
}

BOOST_AUTO_TEST_CASE(a_straight_path_is_a_tow) {
  const std::vector<model::LoadRow> tow = rows_before_break(case_of(kTow, 1.0));
  const std::vector<model::LoadRow> path =
      rows_of(case_of("[structure.motion]\npath = [[0, -7, 0, 0], [10, 5, 0, 0]]\n", 1.0));
  for (std::size_t i = 0; i < tow.size(); ++i) {
    // Rounded poses move the outlines by a unit of the grid, 2^-30 m: by some 0.01 N of crushing.
    BOOST_TEST(norm(path[i].total.force - tow[i].total.force) <= 0.1);
    BOOST_TEST(path[i].structure.x == tow[i].structure.x, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(a_turned_structure_meets_the_ice_as_the_straight_one_meets_turned_ice) {
  // A cone that slides along x while it heads 45 degrees to port has the loads of the tow, told in turned axes.
  const std::vector<model::LoadRow> tow = rows_before_break(case_of(kTow, 1.0, {"ice.friction_structure=0.1"}));
  const std::vector<model::LoadRow> turned =
      rows_of(case_of("[structure.motion]\npath = [[0, -7, 0, \"45 deg\"], [10, 5, 0, \"45 deg\"]]\n", 1.0,
                      {"ice.friction_structure=0.1"}));
  // 45 degrees are eight of the 64 facets.
  for (std::size_t i = 0; i < tow.size(); ++i) {
    const Vec3 f = tow[i].total.force, g = turned[i].total.force;
    BOOST_TEST(std::abs(g.x - std::sqrt(0.5) * (f.x + f.y)) <= 0.1 + 1e-6 * f.x);
    BOOST_TEST(std::abs(g.y - std::sqrt(0.5) * (f.y - f.x)) <= 0.1 + 1e-6 * f.x);
    BOOST_TEST(std::abs(turned[i].work - tow[i].work) <= 1e-6 * (1.0 + tow[i].work));
  }
}

BOOST_AUTO_TEST_CASE(every_motion_resumes_to_the_same_bytes) {
  for (const std::string& motion : {kTurn, kFree, kMoored}) {
    std::optional<model::Checkpoint> saved;
    const auto save = [&](const simulation::Simulation& simulation, const simulation::StepReport&) {
      if (!saved && simulation.time() > 1.2) saved = simulation.checkpoint();
    };
    const model::Case resolved = case_of(motion, 2.0);
    const simulation::Run whole = simulation::run(resolved, {.observer = save});
    BOOST_REQUIRE(saved);
    simulation::Simulation rest(resolved, *saved);
    for (std::size_t i = 121; i < whole.results.loads.size(); ++i)
      BOOST_TEST((rest.step().loads == whole.results.loads[i]), motion << i);
    BOOST_TEST(whole.results.loads.back().total.force.x > 0.0);
  }
}

BOOST_AUTO_TEST_CASE(a_free_structure_receives_the_impulse_of_its_loads_to_round_off) {
  // Heave damping acts along the mast, which leans.
  const model::Case resolved =
      case_of(kFree, 2.0, {"structure.motion.mass=8e5", "structure.motion.linear_damping=[0, 0, 0]"});
  const std::vector<model::LoadRow> rows = rows_of(resolved);
  const auto in_sheet = [](const model::LoadRow& row) {  // a load's force, in the plan of the sheet
    const Vec2 ahead{std::cos(row.attitude.z), std::sin(row.attitude.z)};
    return -row.total.force.x * ahead - row.total.force.y * perpendicular(ahead);
  };
  Vec2 given{}, gained{};
  for (std::size_t i = 1; i + 1 < rows.size(); ++i) {
    const Vec2 gift = 0.005 * (in_sheet(rows[i - 1]) + in_sheet(rows[i]));
    const Vec2 gain = 9e5 * (rows[i + 1].velocity - rows[i].velocity);
    BOOST_TEST(norm(gain - gift) <= 1e-12 * 9e5 * 1.2 + 1e-12 * norm(gift));
    given += gift;
    gained += gain;
  }
  BOOST_TEST_MESSAGE("impulse of the ice " << given.x << " N s, of " << 9e5 * 1.2 << " N s");
  BOOST_TEST(norm(gained - given) <= 1e-9 * norm(given));
  BOOST_TEST(norm(given) > 1e4);
  // The ice has slowed it, and the accounts close.
  const model::BodyEnergy& e = rows.back().body;
  BOOST_TEST(e.ice_work < 0.0);
  BOOST_TEST_MESSAGE("energy: ice " << e.ice_work << " J, error " << e.error << " J");
  BOOST_TEST(std::abs(e.error) < 1e-3 * std::abs(e.ice_work));
}

/// Total momentum in the plan of floes between two frames, `dt` apart [N s]: without added mass, a floe's is that of
/// its way.
Vec2 momentum_of_floes(const model::Frame& before, const model::Frame& after,
                       const std::map<std::int64_t, double>& mass, double dt) {
  Vec2 sum{};
  for (std::size_t i = 0; i < after.floes.size(); ++i) {
    BOOST_REQUIRE(before.floes[i].floe == after.floes[i].floe);
    sum += mass.at(after.floes[i].floe) / dt * plan(after.floes[i].pose.position - before.floes[i].pose.position);
  }
  return sum;
}

BOOST_AUTO_TEST_CASE(what_a_free_structure_loses_its_floes_gain_to_round_off) {
  // Water that neither drags nor pushes sideways, and no walls.
  const model::Case resolved = io::read_case(
      BRASH_SOURCE_DIR "/experiments/fields/cone.toml",
      {"structure.motion.kind=free", "structure.motion.centre_of_gravity=[0, 0, 0]", "structure.motion.mass=8e5",
       "structure.motion.added_mass=[1e5, 1e5, 1e5]", "structure.motion.angular_damping=[1e6, 1e6, 1e6]",
       "field.length=60", "field.width=60", "field.border=free", "failure.pieces=whole", "time.duration=4",
       "output.statistics_from=0", "hydrodynamics.form_drag=0", "hydrodynamics.skin_friction=0",
       "hydrodynamics.added_mass_law=isotropic", "hydrodynamics.added_mass=0", "hydrodynamics.ventilation=false",
       "hydrodynamics.structure_flow=false"});
  simulation::Simulation simulation(resolved);
  std::map<std::int64_t, double> mass;
  for (const model::FloeRecord& floe : simulation.initial_births())
    mass[floe.id] = resolved.ice.density * floe.thickness * floe.area;
  const double dt = resolved.time.step, of_structure = 9e5;
  Vec2 gained{}, last_load{}, start{};
  model::Frame before = simulation.frame();
  for (int i = 0; i < 400; ++i) {
    const model::LoadRow row = simulation.step().loads;
    if (i == 0) start = row.velocity;
    const model::Frame after = simulation.frame();
    BOOST_REQUIRE(after.floes.size() == before.floes.size());
    gained = momentum_of_floes(before, after, mass, dt);
    before = after;
    // The structure bears the mean of two steps' loads in the step after them: half of the last load is on its way.
    const Vec2 ahead{std::cos(row.attitude.z), std::sin(row.attitude.z)};
    const Vec2 load = row.total.force.x * ahead + row.total.force.y * perpendicular(ahead);
    const Vec2 lost = of_structure * (start - row.velocity) + 0.5 * dt * last_load + dt * load;
    BOOST_TEST(norm(gained - lost) <= 1e-9 * of_structure * norm(start));
    last_load = load;
  }
  BOOST_TEST_MESSAGE("floes have " << gained.x << " N s of " << of_structure * start.x << " N s");
  BOOST_TEST(gained.x > 0.01 * of_structure * start.x);
}

BOOST_AUTO_TEST_CASE(a_free_structure_and_drifting_ice_are_a_galilean_pair) {
  const std::vector<model::LoadRow> moves = rows_of(case_of(kFree, 1.5));
  const std::vector<model::LoadRow> drifts = rows_of(case_of(kFree + "frame = \"ice-drifts\"\n", 1.5));
  BOOST_TEST((moves == drifts));
}

BOOST_AUTO_TEST_CASE(a_structure_that_turns_has_its_heading_and_rates_in_the_history) {
  const std::vector<model::LoadRow> rows = rows_of(case_of(kTurn, 3.0));
  BOOST_TEST(rows.back().attitude.z == radians(9), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(rows.back().structure.y == 0.2, boost::test_tools::tolerance(1e-9));
  double turned = 0.0;
  for (const model::LoadRow& row : rows) turned += 0.01 * row.spin.z;
  BOOST_TEST(turned == radians(9), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
