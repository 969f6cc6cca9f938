// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets with free borders as bodies; docs/theory/fracture-of-floes.md.
#include "brash/edge/drifting_sheets.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <utility>

#include "brash/edge/sheet_tiles.hpp"
#include "brash/edge/splitting_force.hpp"
#include "brash/io/case.hpp"
#include "brash/rigid_body/world.hpp"
#include "brash/simulation/simulation.hpp"
#include "laid_floes.hpp"

namespace {

using namespace brash;
using edge::DriftingSheets;

model::Case free_case(std::vector<std::string> overrides = {}) {
  overrides.emplace_back("field.border=free");
  const bool is_default = std::ranges::find(overrides, "algorithm.preset=brash") != overrides.end();
  if (is_default) return io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml", overrides);
  overrides.insert(overrides.begin(), "output.statistics_from=0");
  return io::read_case(BRASH_SOURCE_DIR "/experiments/validation/second_reading.toml", overrides);
}

/// A rectangle from (0, 0) to (a, b).
ice::Plate plate(const model::Case& c, double a, double b, int number = 0) {
  const std::array<Vec2, 4> corners{Vec2{0, 0}, {a, 0}, {a, b}, {0, b}};
  return {
      number, ice::Hold::kDrifting, {.thickness = c.ice.thickness}, {geometry::Polygon{geometry::ring(corners), {}}}};
}

/// Sheets without ice around them.
struct Lone {
  explicit Lone(const model::Case& c) : sheets(c, world, true) {}

  /// A step with a force of the structure [N] at each point [m]. @return the work on the sheets [J].
  edge::WorkOnSheets step(double dt, const std::vector<std::pair<Vec3, Vec3>>& forces = {}) {
    sheets.begin_step();
    sheets.advance(dt);
    for (const auto& [force, point] : forces) sheets.push(0, force, point);
    sheets.hand_over(dt);
    world.step(dt);
    return sheets.take_back(dt);
  }

  rigid_body::World world{{.ice_structure = {0.0, 5e5}, .ice_ice = {0.3, 5e5}}};
  edge::DriftingSheets sheets;
};

const std::vector<std::string> kNoDrag{"hydrodynamics.form_drag=0", "hydrodynamics.skin_friction=0"};

BOOST_AUTO_TEST_CASE(a_contact_of_a_step_lies_in_the_frame_where_the_step_began) {
  const model::Case c = free_case(kNoDrag);
  Lone lone(c);
  lone.sheets.add(plate(c, 40.0, 20.0), {.velocity = {2.0, 1.0}, .spin = 0.1});
  const Vec3 corner = lone.sheets.to_world(0, {40.0, 20.0, 0.0});
  const Vec3 side = lone.sheets.turned(0, {1.0, 0.0, 0.0});
  (void)lone.step(0.5);
  BOOST_TEST(norm(lone.sheets.to_sheet(0, corner) - Vec3{40.0, 20.0, 0.0}) < 1e-12);
  BOOST_TEST(norm(lone.sheets.turned_back(0, side) - Vec3{1.0, 0.0, 0.0}) < 1e-12);
}

/// Its tiles are where the step has moved them; a resumed run lays them where the frame is.
BOOST_AUTO_TEST_CASE(the_end_of_a_step_leaves_a_frame_where_it_is_to_the_bit) {
  const model::Case c = free_case();
  Lone lone(c);
  lone.sheets.add(plate(c, 37.3, 21.7), {.position = {0.1, 0.3}, .velocity = {0.7, 0.3}, .spin = 0.01});
  for (double length = 37.0; length > 30.0; length -= 0.3) {
    lone.sheets.begin_step();
    lone.sheets.advance(0.01);
    const Pose moved = lone.sheets.pose(0);
    lone.sheets.push(0, {1e3, 3e2, 0.0}, {1.7, 0.9, 0.0});
    lone.sheets.weigh(plate(c, length, 21.7));  // a break
    lone.sheets.hand_over(0.01);
    lone.world.step(0.01);
    (void)lone.sheets.take_back(0.01);
    BOOST_REQUIRE((lone.sheets.pose(0) == moved));
  }
}

BOOST_AUTO_TEST_CASE(a_sheet_under_a_constant_force_accelerates_by_force_over_mass_and_turns_by_moment_over_inertia) {
  const model::Case c = free_case(kNoDrag);
  Lone lone(c);
  edge::DriftingSheets& sheets = lone.sheets;
  const double a = 40.0, b = 20.0, mass = c.ice.density * c.ice.thickness * a * b, dt = 0.01;
  sheets.add(plate(c, a, b));
  const double moment = 2e4;  // F1: about the centre, by a pair of forces
  double work = 0.0;
  for (int i = 0; i < 200; ++i) {
    const model::SheetMotion now = sheets.motions()[0];
    const Vec2 centre = now.centre + dt * now.velocity;
    const edge::WorkOnSheets done = lone.step(dt, {{{0, 5e4 + moment / 8.0, 0}, {centre.x + 4.0, centre.y, 0}},
                                                   {{0, -moment / 8.0, 0}, {centre.x - 4.0, centre.y, 0}}});
    work += done.edge + done.form + done.skin + done.wind;
  }
  const model::SheetMotion moved = sheets.motions()[0];
  const double t = 2.0, inertia = mass * (a * a + b * b) / 12.0;
  BOOST_TEST(moved.mass == mass, boost::test_tools::tolerance(1e-13));
  // 5e4 N at an arm of 4 m and a pair of 2e4 N m.
  BOOST_TEST(moved.velocity.y == 5e4 * t / mass, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(moved.velocity.x) < 1e-15);
  BOOST_TEST(moved.spin == (5e4 * 4.0 + moment) * t / inertia, boost::test_tools::tolerance(1e-12));
  // Steps of even motion: the first has none, so a share dt / t is missing.
  BOOST_TEST(moved.centre.y - 10.0 == 0.5 * 5e4 * t * (t - dt) / mass, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(work == sheets.kinetic_energy(), boost::test_tools::tolerance(1e-12));  // (G5)
}

BOOST_AUTO_TEST_CASE(a_sheet_that_is_pushed_through_water_reaches_the_speed_of_the_closed_form) {
  const model::Case c = free_case();
  Lone lone(c);
  edge::DriftingSheets& sheets = lone.sheets;
  const double a = 40.0, b = 20.0, mass = c.ice.density * c.ice.thickness * a * b, dt = 0.01, force = 2e5;
  sheets.add(plate(c, a, b));
  const double draught = c.ice.thickness * c.ice.density / c.water.density;
  const double k =
      0.5 * c.water.density * (c.hydrodynamics.form_drag * draught * b + c.hydrodynamics.skin_friction * a * b);
  for (int i = 1; i <= 6000; ++i) {
    const Vec2 centre = sheets.motions()[0].centre;
    static_cast<void>(lone.step(dt, {{{force, 0, 0}, {centre.x, centre.y, 0}}}));
    if (i % 1000 != 0) continue;
    // m v' = F - k v^2 from rest; the step is of the first order: dt sqrt(F k) / m = 2e-4.
    const double expected = std::sqrt(force / k) * std::tanh(std::sqrt(force * k) / mass * i * dt);
    BOOST_TEST(sheets.motions()[0].velocity.x == expected, boost::test_tools::tolerance(1e-3));
  }
}

BOOST_AUTO_TEST_CASE(still_water_stops_a_drift_and_a_spin_and_a_current_carries_a_sheet_along) {
  const model::Case c = free_case({"water.current=[0.3, -0.1]"});
  Lone lone(c);
  edge::DriftingSheets& sheets = lone.sheets;
  sheets.add(plate(c, 40.0, 20.0), {.velocity = {0.0, 0.5}, .spin = 0.05});
  for (int i = 0; i < 40000; ++i) static_cast<void>(lone.step(0.05));
  const model::SheetMotion at_last = sheets.motions()[0];
  // A quadratic drag leaves about m / (k t): 2.4e5 kg / (2e3 kg/m * 2000 s) at the least skin friction.
  BOOST_TEST(norm(at_last.velocity - Vec2{0.3, -0.1}) < 0.02);
  BOOST_TEST(std::abs(at_last.spin) < 0.01);
}

BOOST_AUTO_TEST_CASE(wind_and_current_carry_a_sheet_along_at_the_free_drift) {
  const model::Case c = free_case({"wind.velocity=[15, 0]", "water.current=[0.3, 0]"});
  Lone lone(c);
  const double a = 40.0, b = 20.0;
  lone.sheets.add(plate(c, a, b));
  double work = 0.0;
  for (int i = 0; i < 40000; ++i) work += lone.step(0.05).wind;
  const double draught = c.ice.thickness * c.ice.density / c.water.density;
  const double air = c.wind.density * c.wind.skin_friction * a * b;
  const double water =
      0.5 * c.water.density * (c.hydrodynamics.form_drag * draught * b + c.hydrodynamics.skin_friction * a * b);
  const double nansen = std::sqrt(air / water);  // ice.md, (F9)
  const double drift = 0.3 + nansen / (1.0 + nansen) * 14.7;
  BOOST_TEST(lone.sheets.motions()[0].velocity.x == drift, boost::test_tools::tolerance(2e-4));  // 1 + dt c / m
  BOOST_TEST(work > lone.sheets.kinetic_energy());
}

BOOST_AUTO_TEST_CASE(a_jam_of_three_sheets_presses_on_the_wall_with_wind_and_current_on_all) {
  model::Case c = free_case({"wind.velocity=[20, 0]", "water.current=[0.1, 0]", "field.length=60", "field.width=40"});
  c.field.kind = model::FieldKind::kFloes;
  c.field.floes.border = model::FloeBorder::kWalls;
  Lone lone(c);
  simulation::lay_borders(c, lone.world);
  edge::SheetTiles tiles(c);
  const double b = 16.0, dt = 0.02;
  double x = 60.0, expected = 0.0;
  for (int number = 0; number < 3; ++number) {
    const double a = 20.0 - 2.0 * number;  // along the wind
    x -= a + 0.01;
    const ice::Plate ice = plate(c, a, b, number);
    lone.sheets.add(ice, {.position = {x, -0.5 * b}});
    tiles.lay(ice, lone.world, {0, 0}, {a, b}, lone.sheets.pose(number), lone.sheets.id(number));
    const double draught = c.ice.thickness * c.ice.density / c.water.density;
    expected += c.wind.density * c.wind.skin_friction * a * b * 400.0 +
                0.5 * c.water.density * 0.01 *
                    (c.hydrodynamics.form_drag * draught * b + c.hydrodynamics.skin_friction * a * b);
  }
  double on_wall = 0.0;
  constexpr int kSettle = 2000, kCount = 1000;
  for (int i = 0; i < kSettle + kCount; ++i) {
    lone.sheets.begin_step();
    lone.sheets.advance(dt);
    for (int number = 0; number < 3; ++number)
      tiles.move(number, lone.world, lone.sheets.pose(number), lone.sheets.twist(number));
    lone.sheets.hand_over(dt);
    lone.world.step(dt);
    static_cast<void>(lone.sheets.take_back(dt));
    if (i < kSettle) continue;
    for (const rigid_body::ContactLoad& contact : lone.world.contacts_of_sheets())
      if (!tiles.level_ice_of(contact.other)) on_wall -= contact.normal_force * contact.normal.x / kCount;
  }
  BOOST_TEST(on_wall == expected, boost::test_tools::tolerance(1e-3));  // ice.md, (F10)
  for (const model::SheetMotion& sheet : lone.sheets.motions()) BOOST_TEST(norm(sheet.velocity) < 1e-5);
}

BOOST_AUTO_TEST_CASE(the_rectangle_of_a_crack_is_as_long_as_its_way_through_the_ice) {
  const ice::Plate ice = plate(free_case(), 100.0, 400.0);
  const auto ahead = [&](double angle) {
    return edge::rectangle_ahead(ice.sheet(), {.at = {0.0, 200.0}, .towards = {std::cos(angle), std::sin(angle)}});
  };
  constexpr double kThirty = std::numbers::pi / 6.0;
  BOOST_REQUIRE(ahead(0.0).has_value());
  BOOST_TEST(ahead(0.0)->length == 100.0, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(ahead(0.0)->breadth == 400.0, boost::test_tools::tolerance(1e-9));
  BOOST_REQUIRE(ahead(kThirty).has_value());
  BOOST_TEST(ahead(kThirty)->length == 100.0 / std::cos(kThirty), boost::test_tools::tolerance(1e-9));
  // To the corner at (0, 400). No corner to the right is ahead, but ice 200 m to the side is.
  BOOST_TEST(ahead(kThirty)->breadth == 2.0 * 200.0 * std::cos(kThirty), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_floe_far_from_the_ice_lays_no_tiles) {
  const model::Case c = free_case(kNoDrag);
  Lone lone(c);
  edge::SheetTiles tiles(c);
  // Beyond the plane of the exact ice, whose corners could not be snapped.
  BOOST_CHECK_NO_THROW(tiles.lay(plate(c, 20.0, 10.0), lone.world, {-9000.0, 0.0}, {-8990.0, 4.0}));
}

BOOST_AUTO_TEST_CASE(wind_presses_a_sheet_of_level_ice_on_the_shore) {
  model::Case c = free_case({"wind.velocity=[20, 0]"});
  const std::filesystem::path shore = std::filesystem::temp_directory_path() / "brash_shore_of_a_sheet.wkt";
  std::ofstream(shore) << "POLYGON((500040.01 7000000, 500060 7000000, 500060 7000030, 500040.01 7000030, "
                          "500040.01 7000000))";
  c.field.shore = shore.string();
  c.field.origin = {500000.0, 7000000.0};
  Lone lone(c);
  simulation::lay_borders(c, lone.world);
  std::filesystem::remove(shore);
  edge::SheetTiles tiles(c);
  const double a = 40.0, b = 20.0, dt = 0.02;
  const ice::Plate ice = plate(c, a, b);
  lone.sheets.add(ice, {.position = {0.0, 5.0}});
  tiles.lay(ice, lone.world, {0, 0}, {a, b}, lone.sheets.pose(0), lone.sheets.id(0));
  double on_shore = 0.0;
  constexpr int kSettle = 2000, kCount = 500;
  for (int i = 0; i < kSettle + kCount; ++i) {
    lone.sheets.begin_step();
    lone.sheets.advance(dt);
    tiles.move(0, lone.world, lone.sheets.pose(0), lone.sheets.twist(0));
    lone.sheets.hand_over(dt);
    lone.world.step(dt);
    static_cast<void>(lone.sheets.take_back(dt));
    if (i < kSettle) continue;
    for (const rigid_body::ContactLoad& contact : lone.world.contacts_of_sheets())
      on_shore -= contact.normal_force * contact.normal.x / kCount;
  }
  BOOST_TEST(on_shore == c.wind.density * c.wind.skin_friction * a * b * 400.0, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(ice_that_leaves_a_sheet_takes_its_momentum_along_and_the_rest_moves_on) {
  const model::Case c = free_case(kNoDrag);
  Lone lone(c);
  edge::DriftingSheets& sheets = lone.sheets;
  sheets.add(plate(c, 40.0, 20.0), {.position = {3.0, 1.0}, .angle = 0.4, .velocity = {1.0, 0.2}, .spin = 0.1});
  const double before = sheets.kinetic_energy();
  const Twist field = sheets.twist(0);
  const Vec2 corner = plan(sheets.to_world(0, {30.0, 5.0, 0.0}));
  const double lost = sheets.weigh(plate(c, 30.0, 20.0));
  BOOST_TEST(before - lost == sheets.kinetic_energy(), boost::test_tools::tolerance(1e-13));
  BOOST_TEST((sheets.twist(0) == field));
  BOOST_TEST((plan(sheets.to_world(0, {30.0, 5.0, 0.0})) == corner));
  const model::SheetMotion rest = sheets.motions()[0];
  // The middle of the rest, as a point of the old sheet.
  const Vec2 middle = plan(sheets.to_world(0, {15.0, 10.0, 0.0}));
  const Vec3 velocity = velocity_at(field, Vec3{middle.x - 3.0, middle.y - 1.0, 0.0});
  BOOST_TEST(norm(rest.centre - middle) < 1e-12);
  BOOST_TEST(norm(rest.velocity - plan(velocity)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(a_structure_is_seen_from_a_sheet_that_drifts_and_turns_as_it_moves_past) {
  const model::Case c = free_case();
  Lone lone(c);
  edge::DriftingSheets& sheets = lone.sheets;
  sheets.add(plate(c, 40.0, 20.0), {.position = {3.0, 1.0}, .angle = 0.4, .velocity = {1.0, 0.2}, .spin = 0.1});
  const structure::State structure{{{-5.0, 2.0, 0.5}, {}}, {{1.2, 0.1, 0.0}, {0.0, 0.0, 0.03}}};
  const structure::State seen = sheets.seen_from(0, structure);
  // A finite difference of the seen motion, both moved on for a moment.
  const double moment = 1e-6;
  const structure::State then =
      sheets.seen_from(0, {{structure.pose.position + moment * structure.twist.linear, {}}, structure.twist}, moment);
  // The way curves: half the moment times the seen acceleration, some 0.2 m/s2.
  BOOST_TEST(norm((then.pose.position - seen.pose.position) / moment - seen.twist.linear) < 0.2 * moment);
  BOOST_TEST(seen.twist.angular.z == -0.07, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(norm(sheets.to_world(0, seen.pose.position) - structure.pose.position) < 1e-14);
}

BOOST_AUTO_TEST_CASE(a_floe_and_a_sheet_that_meet_keep_their_momentum) {
  const model::Case c = free_case(kNoDrag);
  rigid_body::World world({.ice_structure = {0.0, 5e5}, .ice_ice = {0.3, 5e5}});
  edge::DriftingSheets sheets(c, world, true);
  sheets.add(plate(c, 20.0, 20.0), {.velocity = {-0.4, 0.0}});
  const std::vector<Vec2> tile{{0, 5}, {4, 5}, {4, 15}, {0, 15}};
  const std::vector<std::vector<Vec2>> ring{{{-4, 8}, {-0.01, 8}, {-0.01, 12}, {-4, 12}}};
  const BodyId part = world.add_sheet_part(tile, -0.2, 0.1, sheets.pose(0), sheets.id(0));
  const auto placed = rigid_body::place_prism(ring, ring, 0.3, -0.05);
  const rigid_body::MassProperties mass = rigid_body::mass_properties(placed.prism, c.ice.density, 0.0);
  const BodyId floe = world.add_floe(placed.prism, mass, placed.pose, {{0.6, 0.0, 0.0}, {}});
  const auto momentum = [&] {
    const model::SheetMotion sheet = sheets.motions()[0];
    return sheet.mass * sheet.velocity + mass.mass * plan(world.twist(floe).linear);
  };
  const Vec2 before = momentum();
  const double energy = sheets.kinetic_energy() + world.kinetic_energy();
  const double dt = 0.005;
  for (int i = 0; i < 200; ++i) {
    sheets.begin_step();
    sheets.advance(dt);
    world.move_sheet_part(part, sheets.pose(0), sheets.twist(0));
    sheets.hand_over(dt);
    world.step(dt);
    static_cast<void>(sheets.take_back(dt));
  }
  BOOST_TEST(norm(momentum() - before) < 1e-9 * norm(before));  // rounding of 200 steps
  const double gap = world.twist(floe).linear.x - sheets.motions()[0].velocity.x;
  BOOST_TEST(gap < 0.01);  // they have met, and do not come nearer
  BOOST_TEST(sheets.kinetic_energy() + world.kinetic_energy() < energy);
  BOOST_TEST(world.pose(floe).position.x > placed.pose.position.x - 1.0);
}

/// Steps a case, and tells each report.
template <typename Tell>
void step_through(simulation::Simulation& simulation, int n_steps, Tell&& tell) {
  for (int i = 0; i < n_steps; ++i) tell(simulation.step());
}

BOOST_AUTO_TEST_CASE(the_structure_gives_a_sheet_the_momentum_that_the_sheet_takes_from_it) {
  std::vector<std::string> overrides = kNoDrag;
  overrides.insert(overrides.end(), {"time.duration=3", "field.initial_crack=false"});
  const model::Case c = free_case(overrides);
  simulation::Simulation simulation(c);
  Vec2 given{};
  bool broken = false;
  double crushed = 0.0;
  step_through(simulation, 300, [&](const simulation::StepReport& report) {
    if (broken) return;
    // Loads are along the ice's drift, against the structure's heading.
    given += Vec2{c.time.step * report.loads.total.force.x, 0.0};
    crushed = report.loads.area_crushed;
    broken = !report.events.empty();
    if (broken) return;
    const model::SheetMotion sheet = simulation.sheet_motions()[0];
    // Crushed ice leaves with the sheet's velocity.
    const double left = c.ice.density * c.ice.thickness * crushed * norm(sheet.velocity);
    BOOST_TEST(std::abs(sheet.mass * sheet.velocity.x - given.x) <= left + 1e-9 * given.x);
  });
  BOOST_TEST(broken);
  BOOST_TEST(given.x > 1e3);
}

BOOST_AUTO_TEST_CASE(a_sheet_with_far_borders_has_the_loads_of_the_fixed_sheet_up_to_the_first_break) {
  const auto start = [](const std::string& border) {
    return simulation::Simulation(
        io::read_case(BRASH_SOURCE_DIR "/experiments/validation/second_reading.toml",
                      {"time.duration=3", "output.statistics_from=0", "field.initial_crack=false",
                       "field.border=" + border, "field.length=4000", "field.width=4000"}));
  };
  simulation::Simulation fixed = start("fixed"), drifting = start("free");
  double largest = 0.0, apart = 0.0;
  for (int i = 0; i < 300; ++i) {
    const simulation::StepReport at_rest = fixed.step(), adrift = drifting.step();
    largest = std::max(largest, norm(at_rest.loads.total.force));
    apart = std::max(apart, norm(at_rest.loads.total.force - adrift.loads.total.force));
    if (!at_rest.events.empty() || !adrift.events.empty()) break;
  }
  BOOST_TEST(largest > 1e3);
  // The sheet of 5e9 kg has moved by micrometres, and the overlap is centimetres deep.
  BOOST_TEST(apart < 1e-3 * largest);
}

BOOST_AUTO_TEST_CASE(a_sheet_that_crushing_severs_goes_on_as_two) {
  // A vertical cylinder crosses a strip on its middle line. It breaks nothing, and the tough ice does not split.
  const model::Case c =
      free_case({"algorithm.preset=brash", "structure.angle=90 deg", "structure.waterline_width=1", "structure.speed=8",
                 "structure.start_distance=2", "field.length=4", "field.width=100", "field.smallest_plate=0.1",
                 "field.initial_crack=false", "ice.fracture_toughness=1e7", "time.step=0.005", "time.duration=1.5"});
  simulation::Simulation simulation(c);
  step_through(simulation, 300, [](const simulation::StepReport& report) { BOOST_TEST(report.events.empty()); });
  const std::vector<model::SheetMotion> halves = simulation.sheet_motions();
  BOOST_REQUIRE(halves.size() == 2u);
  BOOST_TEST(simulation.sheet().size() == 2u);
  // The channel is as wide as the cylinder. The halves are hinged on nothing: each turns its own way.
  for (const model::SheetMotion& half : halves)
    BOOST_TEST(half.mass == c.ice.density * c.ice.thickness * 4.0 * 49.5, boost::test_tools::tolerance(2e-3));
  BOOST_TEST(halves[0].spin * halves[1].spin < 0.0);
  BOOST_TEST(simulation.ledger().closes());
}

/// The verdicts of the step were on the whole sheet.
BOOST_AUTO_TEST_CASE(a_sheet_that_splits_keeps_no_verdicts) {
  const model::Case c = free_case({"algorithm.preset=brash", "time.duration=6", "field.length=40", "field.width=60",
                                   "ice.fracture_toughness=20e3"});
  simulation::Simulation simulation(c);
  int n_split = 0;
  for (int i = 0; n_split == 0 && i < 600; ++i) {
    n_split = simulation.step().breaks.sheets_split;
  }
  BOOST_REQUIRE(n_split == 1);
  BOOST_TEST(simulation.checkpoint().table("verdict").n_rows() == 0u);
}

BOOST_AUTO_TEST_CASE(a_resumed_run_of_a_sheet_that_drifts_goes_on_to_the_bit_and_its_ledgers_close) {
  const model::Case c = free_case({"time.duration=6", "field.length=40", "field.width=60",
                                   "ice.fracture_toughness=20e3", "failure.model=wedge", "failure.pattern=disc",
                                   "failure.judged=centre-line", "failure.order=circumferential-first",
                                   "failure.edge=static", "failure.second_order=false", "failure.joint_loads=false"});
  simulation::Simulation whole(c);
  int n_split = 0;
  std::vector<model::SheetSplit> splits;
  step_through(whole, 450, [&](const simulation::StepReport& report) {
    n_split += report.breaks.sheets_split;
    splits.insert(splits.end(), report.splits.begin(), report.splits.end());
  });
  BOOST_TEST(n_split > 0);
  BOOST_TEST(splits.size() == static_cast<std::size_t>(n_split));
  for (const model::SheetSplit& split : splits) {
    BOOST_TEST(split.stress_intensity >= c.ice.fracture_toughness);
    BOOST_TEST(split.pieces >= 2);
    BOOST_TEST(split.area_after < split.area_before + 1e-6);  // small pieces become floes; vertices are rounded
    BOOST_TEST(norm(split.towards) == 1.0, boost::test_tools::tolerance(1e-12));
  }
  BOOST_TEST(whole.sheet_motions().size() > 1u);
  simulation::Simulation resumed(c, whole.checkpoint());
  int n_floes = 0;
  for (int i = 0; i < 120; ++i) {
    const simulation::StepReport one = whole.step(), other = resumed.step();
    BOOST_TEST((one.loads == other.loads));
    n_floes = std::max(n_floes, one.loads.n_floes);
  }
  BOOST_TEST(n_floes > 3);
  const model::SheetMotion sheet = whole.sheet_motions()[0];
  BOOST_TEST(sheet.velocity.x > 0.01);
  BOOST_TEST(sheet.velocity.x == resumed.sheet_motions()[0].velocity.x);
  BOOST_TEST(whole.ledger().closes());
}

}  // namespace
