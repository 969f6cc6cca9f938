// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/simulation/simulation.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "brash/core/error.hpp"
#include "brash/edge/edge_contact.hpp"
#include "brash/ice/variation.hpp"
#include "brash/io/case.hpp"
#include "brash/io/checkpoint.hpp"
#include "brash/recording/recording.hpp"
#include "brash/simulation/run.hpp"
#include "brash/simulation/setup.hpp"

namespace {

using namespace brash;

/// The validation case, cut short: 3.5 s see the first dozens of breaks. Without a preset it has the laws of the preset
/// `paper` before decision 39, whose steps are functions of their states.
model::Case short_case(std::vector<std::string> overrides = {}, double duration = 3.5) {
  const bool has_preset =
      std::ranges::any_of(overrides, [](const std::string& text) { return text.starts_with("algorithm.preset="); });
  overrides.push_back("time.duration=" + std::to_string(duration));
  if (has_preset) return io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml", overrides);
  overrides.insert(overrides.begin(), "output.statistics_from=0");
  return io::read_case(BRASH_SOURCE_DIR "/experiments/validation/second_reading.toml", overrides);
}

struct Bytes {
  std::vector<double> loads;
  std::vector<double> poses;
  friend bool operator==(const Bytes&, const Bytes&) = default;
};

Bytes bytes_of(const simulation::Run& run) {
  Bytes bytes;
  for (const model::LoadRow& row : run.results.loads)
    for (const double value : {row.total.force.x, row.total.force.z, row.total.moment.y, row.kinetic_energy})
      bytes.loads.push_back(value);
  for (const model::Frame& frame : run.results.frames)
    for (const model::FloePose& floe : frame.floes)
      for (const double value :
           {floe.pose.position.x, floe.pose.position.y, floe.pose.position.z, floe.pose.rotation.w})
        bytes.poses.push_back(value);
  return bytes;
}

BOOST_AUTO_TEST_CASE(one_seed_gives_one_history_and_another_seed_another) {
  const Bytes first = bytes_of(simulation::run(short_case()));
  BOOST_TEST((first == bytes_of(simulation::run(short_case()))));
  BOOST_TEST((first != bytes_of(simulation::run(short_case({"random.seed=2"})))));
}

BOOST_AUTO_TEST_CASE(no_ice_is_crushed_where_crushed_ice_stays) {
  const auto last = [](const std::string& what) {
    return simulation::run(short_case({"failure.crushed_ice=" + what}, 2.0)).results.loads.back();
  };
  const model::LoadRow leaves = last("leaves"), stays = last("stays");
  BOOST_TEST(leaves.area_crushed > 0.0);
  BOOST_TEST(stays.area_crushed == 0.0);
  BOOST_TEST(stays.area_floes > 1.0);
}

/// Rigid floes that are deleted by the stress of a step: the watchdog ends a run whose accounts do not close.
BOOST_AUTO_TEST_CASE(a_run_passes_its_watchdog_where_rigid_floes_are_crushed_and_deleted) {
  for (const char* const engine : {"contact.engine=brash", "contact.engine=bullet"}) {
    const simulation::Run run = simulation::run(
        short_case({engine, "contact.crushing_bound=level-ice", "contact.floe_stress=step", "contact.area=projected",
                    "failure.crushed_ice=stays", "hydrodynamics.added_mass_law=none", "ice.variation.thickness=0.1"},
                   5.0));
    BOOST_TEST(run.summary.n_floes_crushed > 0);
    BOOST_TEST(run.results.loads.back().area_deleted > 0.0);
    BOOST_TEST(run.summary.ledger.closes());
  }
}

BOOST_AUTO_TEST_CASE(a_case_under_another_name_runs_the_same) {
  for (const char* const preset : {"algorithm.preset=paper", "algorithm.preset=brash"}) {
    model::Case first = short_case({preset, "ice.variation.thickness=0.1"}, 2.0), other = first;
    other.name = "a copy";
    BOOST_TEST((bytes_of(simulation::run(first)) == bytes_of(simulation::run(other))));
  }
}

BOOST_AUTO_TEST_CASE(only_the_water_tells_a_structure_that_moves_from_ice_that_drifts) {
  const auto drift = [](const std::string& frame) { return "structure.motion.frame=" + frame; };
  const Bytes moves = bytes_of(simulation::run(short_case()));
  BOOST_TEST((moves == bytes_of(simulation::run(short_case({drift("ice-drifts")})))));
  // Water at rest with the structure passes the ice with the structure's speed, and gives way to it no longer.
  for (const char* const flow : {"hydrodynamics.structure_flow=false", "hydrodynamics.structure_flow=true"}) {
    const Bytes still = bytes_of(simulation::run(short_case({drift("ice-drifts-through-still-water"), flow})));
    BOOST_TEST((still != moves));
    BOOST_TEST((still == bytes_of(simulation::run(short_case({"water.current=[1.202, 0]", flow})))));
  }
}

BOOST_AUTO_TEST_CASE(a_structure_that_is_driven_along_a_tow_has_its_loads_and_one_that_is_turned_has_others) {
  const auto start = [](const std::string& kind) {
    return simulation::Simulation(short_case({"structure.motion.kind=" + kind, "field.initial_crack=false"}));
  };
  simulation::Simulation towed = start("towed"), left_alone = start("driven"), told = start("driven"),
                         turned = start("driven");
  double most = 0.0, apart = 0.0;
  bool has_broken = false;
  for (int i = 1; i <= 120; ++i) {
    const simulation::StepReport report = towed.step();
    BOOST_TEST((left_alone.step().loads == report.loads));
    told.drive(Pose{{-7.0 + 1.202 * 0.01 * i, 0.0, 0.0}, {}});
    turned.drive(Twist{{1.202, 0.0, 0.0}, {0.0, 0.0, 0.2}});
    const Vec3 force = report.loads.total.force;
    most = std::max(most, norm(force));
    apart = std::max(apart, norm(turned.step().loads.total.force - force));
    has_broken = has_broken || !report.events.empty();
    const Vec3 same = told.step().loads.total.force;
    // The poses differ by a rounding, so the outlines by a unit of the grid, 2^-30 m: by some 0.01 N of crushing.
    if (!has_broken) BOOST_TEST(norm(same - force) <= 0.1 + 1e-6 * norm(force));
  }
  BOOST_TEST(has_broken);
  BOOST_TEST(most > 1e4);
  BOOST_TEST(apart > 0.01 * most);  // the skin of the cone slides sideways
  BOOST_TEST(turned.structure().pose.rotation.z == std::sin(0.5 * 0.2 * 1.2), boost::test_tools::tolerance(1e-12));
  BOOST_CHECK_THROW(towed.drive(Twist{}), InputError);
}

BOOST_AUTO_TEST_CASE(an_edge_that_moves_gives_way_and_its_run_goes_on_from_a_checkpoint) {
  const auto moving = [](double duration, const std::string& edge) {
    return short_case({"algorithm.preset=brash", "failure.edge=" + edge}, duration);
  };
  // The first break comes at 0.9 s; the checkpoint lies in the lives of edges.
  std::optional<model::Checkpoint> saved;
  const auto save = [&](const simulation::Simulation& simulation, const simulation::StepReport&) {
    if (!saved && simulation.time() > 0.8) saved = simulation.checkpoint();
  };
  const simulation::Run whole = simulation::run(moving(1.3, "dynamic"), {.observer = save});
  BOOST_REQUIRE(saved);
  BOOST_TEST(saved->table("moving_edge").n_rows() > 0u);
  simulation::Simulation rest(moving(1.3, "dynamic"), *saved);
  for (std::size_t i = 81; i < whole.results.loads.size(); ++i) {
    const model::LoadRow row = rest.step().loads;
    BOOST_TEST((row == whole.results.loads[i]));
  }
  const model::LoadRow& last = whole.results.loads.back();
  BOOST_TEST(last.losses.bending > 0.0);
  BOOST_TEST(last.losses.edge > 0.0);
  BOOST_TEST(std::abs(last.energy_error) < 1e-3 * last.work);
  BOOST_REQUIRE(!whole.results.events.empty());
  BOOST_TEST(whole.results.events.front().edge_age > 0.1);
  BOOST_TEST(whole.results.events.front().edge_deflection > 0.01);
  BOOST_TEST(whole.results.events.front().edge_deflection < 0.2);

  const simulation::Run rigid = simulation::run(moving(1.3, "static"));
  BOOST_TEST(rigid.results.loads.back().losses.bending == 0.0);
  // Before any break a rigid edge is crushed more.
  BOOST_TEST(rigid.results.loads[70].crushing.force.x > whole.results.loads[70].crushing.force.x);
}

BOOST_AUTO_TEST_CASE(ice_that_varies_breaks_where_it_is_thin_or_weak_and_its_run_goes_on_from_a_checkpoint) {
  const std::vector<std::string> settings{"algorithm.preset=brash", "ice.variation.thickness=0.1",
                                          "ice.variation.flexural_strength=0.1"};
  std::optional<model::Checkpoint> saved;
  const auto look = [&](const simulation::Simulation& simulation, const simulation::StepReport&) {
    if (!saved && simulation.time() > 1.5) saved = simulation.checkpoint();
    BOOST_REQUIRE(simulation.ledger().closes());
  };
  const model::Case resolved = short_case(settings, 2.8);
  const simulation::Run whole = simulation::run(resolved, {.observer = look});
  BOOST_REQUIRE(saved);
  simulation::Simulation rest(resolved, *saved);
  for (std::size_t i = 151; i < whole.results.loads.size(); ++i)
    BOOST_TEST((rest.step().loads == whole.results.loads[i]));

  const ice::Variation variation(resolved);
  BOOST_REQUIRE(whole.results.events.size() > 3u);
  for (const model::CrackEvent& event : whole.results.events) {
    BOOST_TEST(event.thickness != resolved.ice.thickness);
    BOOST_TEST(event.sigma_max > event.flexural_strength);
    if (event.pressing_floe != model::kNoFloe) continue;
    // The middle of the chord lies at the tip, to the shift of a moving edge.
    const failure::IceProperties there = variation.at(edge::ice_properties(resolved), event.tip);
    BOOST_TEST(event.thickness == there.thickness, boost::test_tools::tolerance(0.01));
  }
  for (const model::FloeRecord& floe : whole.results.floes) BOOST_TEST(floe.thickness > 0.0);
  const auto& thickness = std::get<std::vector<double>>(saved->table("floe").column("thickness").values);
  BOOST_TEST(std::ranges::min(thickness) < std::ranges::max(thickness));
  BOOST_TEST(std::abs(whole.results.loads.back().energy_error) < 1e-3 * whole.results.loads.back().work);

  const simulation::Run even = simulation::run(short_case({"algorithm.preset=brash"}, 1.0));
  BOOST_TEST(even.results.loads[90].crushing.force.x != whole.results.loads[90].crushing.force.x);
  for (const model::CrackEvent& event : even.results.events) BOOST_TEST(event.thickness == resolved.ice.thickness);
}

BOOST_AUTO_TEST_CASE(stock_bullet_runs_the_case_by_choice_and_its_energies_close) {
  const model::Case bullet = short_case({"contact.engine=bullet"});
  const simulation::Run run = simulation::run(bullet);
  BOOST_TEST(run.complete);
  const model::LoadRow& last = run.results.loads.back();
  BOOST_TEST(last.losses.structure_contact > 0.0);
  BOOST_TEST(last.losses.floe_contact > 0.0);
  // As close as the balance of the own engine: the time step leaves it open.
  BOOST_TEST(std::abs(last.energy_error) < 1e-3 * last.work);
  BOOST_TEST((bytes_of(run) == bytes_of(simulation::run(bullet))));
  BOOST_TEST((bytes_of(run) != bytes_of(simulation::run(short_case()))));
}

BOOST_AUTO_TEST_CASE(the_ledger_closes_after_every_step) {
  const auto closes = [](const simulation::Simulation& simulation, const simulation::StepReport&) {
    BOOST_REQUIRE(simulation.ledger().closes());
  };
  BOOST_TEST(simulation::run(short_case(), {.observer = closes}).complete);
}

BOOST_AUTO_TEST_CASE(a_step_reports_what_it_did) {
  int n_breaks = 0;
  std::set<std::int64_t> born;
  const auto look = [&](const simulation::Simulation& simulation, const simulation::StepReport& report) {
    n_breaks += static_cast<int>(report.events.size());
    for (const model::FloeRecord& floe : report.births) BOOST_TEST(born.insert(floe.id).second);
    for (const model::CrackEvent& event : report.events) {
      BOOST_TEST(event.sigma_max > 539e3);  // the flexural strength
      BOOST_TEST(event.area_after < event.area_before);
      BOOST_TEST(event.breaking_length > 0.0);
    }
    BOOST_TEST(report.loads.time == simulation.time());
  };
  (void)simulation::run(short_case(), {.observer = look});
  BOOST_TEST(n_breaks > 5);
  BOOST_TEST(born.size() > 10u);
}

/// A run, and the same interrupted at one second and every 1.1 s from then on; `file` is left for more.
std::pair<simulation::Run, simulation::Run> whole_and_resumed(const model::Case& resolved, const std::string& file) {
  std::filesystem::remove(file);
  simulation::Run whole = simulation::run(resolved);
  double stop_at = 1.0;
  double now = 0.0;
  const simulation::RunOptions options{
      .observer = [&](const simulation::Simulation& s, const simulation::StepReport&) { now = s.time(); },
      .checkpoint = recording::checkpoint_file(file, true),
      .interrupted = [&] { return now >= stop_at; }};
  simulation::Run resumed = simulation::run(resolved, options);
  for (; !resumed.complete; resumed = simulation::run(resolved, options)) stop_at += 1.1;
  return {std::move(whole), std::move(resumed)};
}

BOOST_AUTO_TEST_CASE(a_resumed_run_with_floes_asleep_is_the_uninterrupted_one_to_the_bit) {
  const std::string file = (std::filesystem::temp_directory_path() / "brash-test-asleep.nc").string();
  const model::Case narrow =
      short_case({"structure.waterline_width=3", "structure.height=2", "structure.height_under_water=1",
                  "structure.start_distance=1.6", "time.settle_speed=0.5"},
                 10.0);
  const auto [whole, resumed] = whole_and_resumed(narrow, file);
  const model::Checkpoint kept = io::read_checkpoint(file);
  const auto& asleep = std::get<std::vector<std::int64_t>>(kept.table("floe").column("asleep").values);
  const auto n_asleep = std::ranges::count(asleep, 1);
  BOOST_TEST(n_asleep > 0);
  BOOST_TEST((resumed.results == whole.results));
  std::filesystem::remove(file);
}

BOOST_AUTO_TEST_CASE(a_copy_under_another_name_goes_on_from_a_checkpoint) {
  const model::Case first = short_case({}, 2.0);
  model::Case copy = first;
  copy.name = "a copy";
  simulation::Simulation whole(first);
  for (int i = 0; i < 150; ++i) (void)whole.step();
  simulation::Simulation twin(copy, whole.checkpoint());
  for (int i = 0; i < 20; ++i) BOOST_TEST((twin.step().loads == whole.step().loads));
}

/// A crack rounds the remaining edge of the sheet again, even far from the crack. The collision shapes there must
/// follow, or a resumed run, which lays all shapes, has others.
BOOST_AUTO_TEST_CASE(a_state_goes_on_to_the_bit_wherever_in_a_run_it_is_taken) {
  const model::Case resolved = short_case({"failure.under_floes=true"}, 11.0);
  simulation::Simulation whole(resolved);
  std::vector<std::pair<simulation::Simulation, int>> twins;  // with the steps that are left to compare
  while (whole.time() < 11.0 - 1e-9) {
    if (std::lround(whole.time() / resolved.time.step) % 25 == 0)
      twins.emplace_back(simulation::Simulation(resolved, whole.checkpoint()), 10);
    const model::LoadRow loads = whole.step().loads;
    for (auto& [twin, left] : twins) {
      --left;
      BOOST_REQUIRE((twin.step().loads == loads));
      BOOST_REQUIRE((twin.frame() == whole.frame()));
    }
    std::erase_if(twins, [](const auto& twin) { return twin.second == 0; });
  }
}

/// Floes that rise on the structure come and go by long work, of which the watchdog keeps account.
BOOST_AUTO_TEST_CASE(a_resumed_upward_run_ends_in_the_whole_state_of_the_uninterrupted_one) {
  simulation::Simulation whole(short_case({"structure.breaking=upward"}, 8.0));
  std::vector<simulation::Simulation> twins;
  while (whole.time() < 8.0 - 1e-9) {
    if (std::lround(whole.time() / 0.01) % 200 == 100)
      twins.emplace_back(short_case({"structure.breaking=upward"}, 8.0), whole.checkpoint());
    (void)whole.step();
    for (simulation::Simulation& twin : twins) (void)twin.step();
  }
  BOOST_TEST(twins.size() == 4u);
  for (const simulation::Simulation& twin : twins) BOOST_TEST((twin.checkpoint() == whole.checkpoint()));
}

BOOST_AUTO_TEST_CASE(a_resumed_run_is_the_uninterrupted_one_to_the_bit) {
  const std::string file = (std::filesystem::temp_directory_path() / "brash-test-checkpoint.nc").string();
  const auto [whole, resumed] = whole_and_resumed(short_case(), file);
  BOOST_TEST((bytes_of(resumed) == bytes_of(whole)));
  BOOST_TEST((resumed.results == whole.results));
  BOOST_TEST(simulation::to_json(resumed.summary) == simulation::to_json(whole.summary));
  BOOST_CHECK_THROW(
      simulation::run(short_case({"random.seed=2"}), {.checkpoint = recording::checkpoint_file(file, true)}),
      InputError);
  std::filesystem::remove(file);
}

BOOST_AUTO_TEST_CASE(a_run_on_the_true_edge_resumes_to_the_same_bytes_and_counts_its_breaks) {
  const std::string file = (std::filesystem::temp_directory_path() / "brash-test-sheet-checkpoint.nc").string();
  const auto [whole, resumed] = whole_and_resumed(short_case({"algorithm.preset=brash"}), file);
  BOOST_TEST((bytes_of(resumed) == bytes_of(whole)));
  BOOST_TEST(simulation::to_json(resumed.summary) == simulation::to_json(whole.summary));
  const simulation::RunSummary& summary = whole.summary;
  BOOST_TEST(summary.n_breaks > 0);
  BOOST_TEST(summary.breaks.true_edge == summary.n_breaks);
  BOOST_TEST(summary.breaks.along_stress > 0);
  BOOST_TEST(summary.breaks.radial_first <= summary.n_breaks);
  std::filesystem::remove(file);
}

/// The floes that ended broken, each with its pieces.
std::map<std::int64_t, std::vector<model::FloeRecord>> splits_of(const model::RunResults& results) {
  std::map<std::int64_t, std::vector<model::FloeRecord>> splits;
  for (const model::FloeRecord& floe : results.floes) {
    if (floe.end == model::FloeEnd::kBroken) splits[floe.id];
    if (floe.parent != model::kNoFloe) splits[floe.parent].push_back(floe);
  }
  return splits;
}

BOOST_AUTO_TEST_CASE(pieces_break_again_into_pieces_that_take_their_place) {
  const simulation::Run run = simulation::run(short_case({"failure.pieces=break"}, 4.5));
  const auto splits = splits_of(run.results);
  BOOST_TEST(splits.size() > 5u);
  BOOST_TEST(run.summary.n_floes_broken == static_cast<int>(splits.size()));
  BOOST_TEST(run.summary.n_floes_present + run.summary.n_floes_broken == run.summary.n_floes_born);
  for (const auto& [id, pieces] : splits) {
    const model::FloeRecord& parent = run.results.floes[static_cast<std::size_t>(id)];
    BOOST_TEST((parent.end == model::FloeEnd::kBroken));
    BOOST_TEST(pieces.size() >= 1u);
    double area = 0.0;
    for (const model::FloeRecord& piece : pieces) {
      BOOST_TEST(piece.birth == parent.death);
      area += piece.area;
    }
    BOOST_TEST(area > 0.9 * parent.area);  // but for brash
    BOOST_TEST(area < parent.area * (1.0 + 1e-8));
  }
  const model::LoadRow& last = run.results.loads.back();
  BOOST_TEST(std::abs(last.energy_error) < 1e-3 * last.work);  // as without splits
}

BOOST_AUTO_TEST_CASE(a_run_whose_pieces_break_again_resumes_to_the_same_bytes) {
  const std::string file = (std::filesystem::temp_directory_path() / "brash-test-pieces.nc").string();
  const auto [whole, resumed] = whole_and_resumed(short_case({"failure.pieces=break"}, 4.5), file);
  BOOST_TEST((resumed.results == whole.results));
  BOOST_TEST(simulation::to_json(resumed.summary) == simulation::to_json(whole.summary));
  std::filesystem::remove(file);
}

BOOST_AUTO_TEST_CASE(whole_pieces_stay_whole_and_leave_no_means_of_their_bending) {
  simulation::Simulation simulation(short_case({"failure.pieces=whole"}));
  while (simulation.time() < 3.5 - 1e-9)
    for (const simulation::FloeDeath& death : simulation.step().deaths)
      BOOST_TEST((death.cause != model::FloeEnd::kBroken));
  BOOST_TEST(simulation.checkpoint().table("section_load").n_rows() == 0u);
}

BOOST_AUTO_TEST_CASE(
    a_step_is_cut_where_that_keeps_the_contact_within_the_range_and_left_whole_where_it_is_above_already) {
  // Ice too weak to be bent: the contact only grows, to twice l_c and beyond. A step of 0.96 m leads there from open
  // water at once, and half of it does not; once the contact is as long as that, no step is short enough.
  simulation::Simulation simulation(short_case({"time.step=0.8", "time.duration=8", "field.initial_crack=false",
                                                "ice.compressive_strength=1e4", "failure.under_floes=false"}));
  int n_cut = 0, n_whole_above = 0;
  for (int i = 0; i < 8; ++i) {
    const simulation::StepReport report = simulation.step();
    n_cut += report.n_substeps > 1 ? 1 : 0;
    if (report.n_substeps == 1 && report.n_above_range > 0) ++n_whole_above;
    BOOST_TEST(report.events.empty());
  }
  BOOST_TEST(n_cut == 1);
  BOOST_TEST(n_whole_above >= 5);
}

BOOST_AUTO_TEST_CASE(far_from_the_ice_nothing_loads_the_structure) {
  simulation::Simulation simulation(short_case({"structure.start_distance=20", "field.initial_crack=false"}));
  for (int i = 0; i < 20; ++i) {
    const simulation::StepReport report = simulation.step();
    BOOST_TEST(norm(report.loads.total.force) == 0.0);
    BOOST_TEST(report.events.empty());
  }
}

BOOST_AUTO_TEST_CASE(without_anything_near_the_floes_of_the_initial_crack_stay_where_they_are) {
  simulation::Simulation simulation(short_case({"structure.start_distance=20"}));
  const model::Frame before = simulation.frame();
  for (int i = 0; i < 100; ++i) (void)simulation.step();
  const model::Frame after = simulation.frame();
  BOOST_REQUIRE(before.floes.size() >= 3u);
  for (std::size_t i = 0; i < before.floes.size(); ++i)
    // Floating at rest to the rounding of weight against buoyancy, a second long.
    BOOST_TEST(norm(after.floes[i].pose.position - before.floes[i].pose.position) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_run_takes_the_setup_that_was_made_for_its_warnings) {
  const auto setup = std::make_shared<const simulation::Setup>(short_case());
  const simulation::Run run = simulation::run(setup->resolved, {.setup = setup});
  BOOST_TEST((run.setup == setup));
  BOOST_TEST((bytes_of(run) == bytes_of(simulation::run(setup->resolved))));
}

BOOST_AUTO_TEST_CASE(scales_of_the_validation_case_are_those_of_the_paper) {
  const simulation::DerivedScales scales = simulation::Setup(short_case()).scales;
  BOOST_TEST(scales.characteristic_length == 3.27, boost::test_tools::tolerance(2e-3));  // three digits
  BOOST_TEST(scales.mu1 == 0.511, boost::test_tools::tolerance(1e-3));                   // three digits
  BOOST_TEST(scales.draft == 0.33 * 900.0 / 1025.0, boost::test_tools::tolerance(1e-14));
}

/// Of the validation case with another value.
BOOST_AUTO_TEST_CASE(without_a_steady_part_there_are_no_statistics_of_it) {
  const simulation::RunSummary summary = simulation::run(short_case({"algorithm.preset=brash"}, 1.0)).summary;
  BOOST_TEST(std::isnan(summary.horizontal.mean));
  BOOST_TEST(std::isnan(summary.vertical_split.crushing));
  BOOST_TEST(std::isnan(summary.breaking_frequency));
  BOOST_TEST(summary.mean_horizontal_whole > 0.0);
  const std::string json = simulation::to_json(summary);
  BOOST_TEST(json.find("\"breaking_frequency\": null") != std::string::npos);
  BOOST_TEST(json.find("nan") == std::string::npos);
}

}  // namespace
