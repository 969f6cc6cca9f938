// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of docs/reference/warnings.md: its settings give its warning.
#include "warnings.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <regex>

#include "brash/io/case.hpp"

namespace {

using namespace brash;
using namespace brash::test;

struct Row {
  std::string id;
  std::vector<std::string> settings;
  std::string file = "experiments/validation/cone.toml";
};

/// The rows of the tables under `heading`: `| `id` | `key=value` `key=value` | ...`, or `| `id` | `file` | ...`.
std::vector<Row> rows_under(const std::string& heading) {
  static const std::regex quoted("`([^`]+)`");
  std::ifstream page(kSource + "/docs/reference/warnings.md");
  std::vector<Row> rows;
  std::string section;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ")) section = line.substr(3);
    if (section != heading || !line.starts_with("| `")) continue;
    const std::string first_cells = line.substr(0, line.find('|', line.find('|', 1) + 1));
    Row row;
    for (std::sregex_iterator m(first_cells.begin(), first_cells.end(), quoted), end; m != end; ++m)
      if (const std::string text = (*m)[1]; row.id.empty())
        row.id = text;
      else if (text.ends_with(".toml"))
        row.file = text;
      else
        row.settings.push_back(text);
    rows.push_back(std::move(row));
  }
  return rows;
}

BOOST_AUTO_TEST_CASE(the_validation_case_gives_no_warning) { BOOST_TEST(warnings_with({}).empty()); }

BOOST_AUTO_TEST_CASE(each_row_of_the_table_before_the_run_gives_its_warning) {
  const std::vector<Row> rows = rows_under("Before the run");
  BOOST_TEST(rows.size() >= 34u);
  std::filesystem::current_path(kSource);  // files of the settings
  for (const Row& row : rows) {
    const model::Case c = io::read_case(kSource + "/" + row.file, row.settings);
    BOOST_TEST(has(advice::warnings_of(c), row.id), row.id);
  }
}

BOOST_AUTO_TEST_CASE(each_row_of_the_table_after_the_run_gives_its_warning) {
  const std::vector<Row> rows = rows_under("After the run");
  BOOST_TEST(rows.size() == 6u);
  for (const Row& row : rows) BOOST_TEST(has(advice::run(validation(row.settings)).summary.warnings, row.id), row.id);
}

BOOST_AUTO_TEST_CASE(a_hull_whose_bottom_still_fills_warns) {
  const auto warns_where_it_grows_to = [](double covered) {
    simulation::RunSummary summary;
    summary.window = {.from = 10.0, .until = 50.0};
    simulation::LoadsSeen loads(summary.window);
    for (int second = 1; second <= 60; ++second) {
      model::LoadRow row;
      row.time = second;
      row.regions[static_cast<std::size_t>(model::HullRegion::kBottom)].covered = second <= 30 ? 0.2 : covered;
      loads.add(row);
    }
    return has(advice::warnings_of(summary, loads, {}), "filling-hull");
  };
  BOOST_TEST(warns_where_it_grows_to(0.26));
  BOOST_TEST(!warns_where_it_grows_to(0.24));
  BOOST_TEST(!warns_where_it_grows_to(0.0));
}

BOOST_AUTO_TEST_CASE(a_number_without_its_unit_gets_the_unit_that_was_probably_meant) {
  const auto strength = text_of(warnings_with({"ice.flexural_strength=0.4"}), "flexural-strength");
  BOOST_TEST(says(strength, "was \"400 kPa\" meant?"), strength);
  const auto modulus = text_of(warnings_with({"ice.youngs_modulus='100 kPa'"}), "youngs-modulus");
  BOOST_TEST(says(modulus, "was \"100 GPa\" meant?") == false, modulus);
  BOOST_TEST(says(modulus, "was \"100 MPa\" meant?"), modulus);
}

BOOST_AUTO_TEST_CASE(model_ice_at_sea_is_warned_of_and_the_same_in_a_basin_is_not) {
  const std::vector<std::string> of_model_ice{"youngs-modulus", "friction-structure"};
  const auto at_sea = warnings_with({"reference.source='a pier'"});
  for (const std::string& id : of_model_ice) BOOST_TEST(has(at_sea, id), id);
  const auto modulus = text_of(at_sea, "youngs-modulus");
  BOOST_TEST(says(modulus, "ice.youngs_modulus = 350 MPa is of model ice"), modulus);
  BOOST_TEST(says(modulus, "ice at sea, which has 500 MPa to 12 GPa"), modulus);
  BOOST_TEST(says(modulus, "`brash new --ice baltic`"), modulus);
  // Ice as thin as a basin's, the words for a basin, and the ice of a site.
  const std::vector<std::string> thin{"reference.source='a pier'", "ice.thickness=5 cm", "failure.smallest_floe=1e-4"};
  for (const std::string& id : of_model_ice) {
    BOOST_TEST(!has(warnings_with(thin), id), id);
    for (const std::string words : {"an Ice Tank", "model test of 1998", "scaled model ice", "HSVA basin"})
      BOOST_TEST(!has(warnings_with({"reference.source='" + words + "'"}), id), words);
    BOOST_TEST(!has(warnings_with({"reference.source='a pier'", "ice.youngs_modulus=3.1 GPa", "ice.density=910",
                                   "ice.flexural_strength=690 kPa", "ice.compressive_strength=2.9 MPa",
                                   "ice.friction_structure=0.1"}),
                    id),
               id);
  }
}

BOOST_AUTO_TEST_CASE(an_angle_without_its_unit_is_warned_of_and_one_that_is_meant_is_not) {
  const auto text = [](const std::string& setting) {
    const model::Case c =
        io::read_case(kSource + "/tests/modules/simulation/askew_barge.toml", {setting, "ice.friction_structure=0"});
    return text_of(advice::warnings_of(c), "bare-angle");
  };
  BOOST_TEST(says(text("structure.heading=3"), "3 is in radians, 171.9 degrees: was \"3 deg\" meant?"));
  for (const char* const bare :
       {"structure.heading=-1", "structure.heading=2.5", "structure.heel=0.5", "structure.trim=0.2"})
    BOOST_TEST(!text(bare).empty(), bare);
  for (const char* const meant : {"structure.heading='170 deg'", "structure.heading=1.57", "structure.heading=3.14",
                                  "structure.heading=0.1", "structure.heel='2 deg'", "structure.trim=0.02"})
    BOOST_TEST(text(meant).empty(), meant);
}

BOOST_AUTO_TEST_CASE(a_network_for_other_ice_is_warned_of) {
  BOOST_TEST(warnings_with({"ice.thickness=0.5 m", "failure.length_density=water"}).empty());  // h/l_c = 0.112
  const auto text =
      text_of(warnings_with({"ice.youngs_modulus=9 GPa", "failure.length_density=water"}), "trained-thickness");
  BOOST_TEST(says(text, "failure.model = network was trained with h/l_c = 0.1, and this ice has 0.044"), text);
}

BOOST_AUTO_TEST_CASE(ice_beyond_the_range_of_a_model_is_warned_of_but_not_for_a_rounded_input) {
  const std::string model = "failure.model=superposition";
  const auto beyond = text_of(warnings_with({model, "ice.youngs_modulus=70.6 MPa"}), "thickness-range");  // 0.1505
  BOOST_TEST(says(beyond, "failure.model = superposition holds from 0.05 to 0.15"), beyond);
  const auto rounded = text_of(warnings_with({model, "ice.youngs_modulus=71.4 MPa"}), "thickness-range");  // 0.1501
  BOOST_TEST(rounded == "", rounded);
}

BOOST_AUTO_TEST_CASE(another_poisson_s_ratio_is_warned_of_where_the_model_knows_one) {
  const auto text = [](const std::string& ratio, std::vector<std::string> settings) {
    settings.push_back("ice.poisson_ratio=" + ratio);
    return text_of(warnings_with(settings), "poisson-ratio");
  };
  for (const std::string model : {"network", "deep-network", "superposition"}) {
    const std::string choice = "failure.model=" + model;
    BOOST_TEST(says(text("0.2", {choice}), "ice.poisson_ratio = 0.2, and failure.model = " + model), choice);
    BOOST_TEST(says(text("0.36", {choice}), "take 0.3, or model = \"plate-outline\""), choice);
    BOOST_TEST(text("0.25", {choice}) == "", choice);
    BOOST_TEST(text("0.35", {choice}) == "", choice);
  }
  // A file of one's own may be of plates with any ratio.
  const std::string file = kSource + "/experiments/failure_database/cone_network.json";
  BOOST_TEST(text("0.2", {"failure.model=network", "failure.file=" + file}) == "");
  BOOST_TEST(says(text("0.2", {"failure.model=plate-outline", "failure.edge=dynamic"}),
                  "failure.edge = dynamic was solved with 0.3"));
  BOOST_TEST(text("0.2", {"failure.model=plate-outline", "failure.edge=static"}) == "");
  BOOST_TEST(text("0.2", {"failure.model=plate"}) == "");
  BOOST_TEST(text("0.2", {"failure.model=wedge"}) == "");
}

BOOST_AUTO_TEST_CASE(a_structure_too_slow_for_the_sweeps_of_a_step_is_warned_of) {
  const auto warned = [](const char* speed, const char* iterations) {
    return text_of(warnings_with({speed, iterations, "time.duration=10000", "failure.length_density=water"}),
                   "few-iterations");
  };
  // A piece of 2.7 m2 has 1.2 t and yields at 2.7 kN s in 10 ms: 114 sweeps at 2 cm/s.
  const auto slow = warned("structure.speed=0.02", "contact.iterations=30");
  BOOST_TEST(says(slow, "contact.iterations = 30 are too few for a piece of 2.7 m2"), slow);
  BOOST_TEST(says(slow, "it needs about 114, or steps of 0.0026 s"), slow);
  BOOST_TEST(warned("structure.speed=0.02", "contact.iterations=114").empty());
  BOOST_TEST(warned("structure.speed=0.08", "contact.iterations=30").empty());
}

BOOST_AUTO_TEST_CASE(the_way_to_the_ice_depends_on_the_direction_of_breaking) {
  // The cone is 0.18 m from the ice, its axis 7 m, and moves 1.202 m in a second. Breaking upward it is widest at the
  // ice's bottom, 0.29 m down, and 0.04 m away.
  BOOST_TEST(has(warnings_with({"time.duration=0.14"}), "no-contact"));
  BOOST_TEST(!has(warnings_with({"time.duration=0.14", "structure.breaking=upward"}), "no-contact"));
  BOOST_TEST(has(warnings_with({"algorithm.preset=brash", "time.duration=0.14", "structure.breaking=upward"}),
                 "no-statistics"));
}

BOOST_AUTO_TEST_CASE(statistics_from_before_the_contact_are_short_all_the_same) {
  const auto warnings = warnings_with({"output.statistics_from=0.1", "time.duration=2"});
  BOOST_TEST(has(warnings, "early-statistics"));
  BOOST_TEST(has(warnings, "short-run"));
  BOOST_TEST(!has(warnings_with({"output.statistics_from=0.2"}), "early-statistics"));
  BOOST_TEST(!has(warnings_with({"output.statistics_from=0.1", "field.border=free"}), "early-statistics"));
}

BOOST_AUTO_TEST_CASE(a_duration_of_no_whole_number_of_steps_names_the_two_nearest) {
  const auto text = text_of(warnings_with({"time.duration=10", "time.step=0.03"}), "broken-step");
  BOOST_TEST(says(text, "the run ends at 9.99 s"), text);
  BOOST_TEST(says(text, "9.99 and 10.02 s"), text);
  // A quotient that is not whole only by round-off.
  BOOST_TEST(!has(warnings_with({"time.duration=8.7", "time.step=0.003"}), "broken-step"));
}

BOOST_AUTO_TEST_CASE(a_sheet_hardly_wider_than_the_cone_is_warned_of) {
  const auto text = text_of(
      warnings_with({"field.width=13", "structure.waterline_width=12", "field.initial_crack_radius=1"}), "near-side");
  BOOST_TEST(says(text, "leaves 0.47"), text);
}

BOOST_AUTO_TEST_CASE(a_leg_beside_the_sheet_is_warned_of_wherever_the_others_are) {
  const auto text = text_of(warnings_with({"field.width=100", "structure.legs=[[0,20],[0,50]]"}), "leaves-field");
  BOOST_TEST(says(text, "comes 6."), text);  // the leg's axis is on the border
  BOOST_TEST(!has(warnings_with({"field.width=100", "structure.legs=[[0,20],[0,-20]]"}), "leaves-field"));
}

BOOST_AUTO_TEST_CASE(a_body_that_floats_as_drawn_gives_no_warning_and_one_in_tonnes_does) {
  const auto afloat = [](std::vector<std::string> settings) {
    settings.push_back("structure.motion.kind=free");
    return warnings_with(settings);
  };
  BOOST_TEST(afloat({}).empty());
  BOOST_TEST(!has(afloat({"structure.motion.mass=530 t"}), "not-in-balance"));
  const auto text = text_of(afloat({"structure.motion.mass=606"}), "not-in-balance");
  BOOST_TEST(says(text, "on its waterline it displaces "), text);
  // The metacentre lies 1 m above the waterline.
  BOOST_TEST(!has(afloat({"structure.motion.centre_of_gravity=[0,0,0.9]"}), "turns-over"));
  BOOST_TEST(has(afloat({"structure.motion.centre_of_gravity=[0,0,1.1]"}), "turns-over"));
  BOOST_TEST(has(afloat({"structure.motion.centre_of_gravity=[0,0.5,0]"}), "not-in-balance"));
}

BOOST_AUTO_TEST_CASE(legs_in_a_triangle_are_not_lopsided) {
  const auto afloat = [](const std::string& legs) {
    return warnings_with({"structure.motion.kind=free", "structure.start_distance=40", "field.width=120", legs});
  };
  BOOST_TEST(has(afloat("structure.legs=[[0,20],[10,-20]]"), "lopsided-legs"));
  BOOST_TEST(!has(afloat("structure.legs=[[20,20],[20,-20],[-20,0]]"), "lopsided-legs"));
  BOOST_TEST(!has(warnings_with({"structure.legs=[[0,20],[10,-20]]", "structure.start_distance=40", "field.width=90"}),
                  "lopsided-legs"));
}

BOOST_AUTO_TEST_CASE(a_key_that_needs_another_is_warned_of_without_it) {
  struct Idle {
    std::string key, value;
    std::vector<std::string> needs;
  };
  const std::vector<Idle> all{
      {"ice.fracture_toughness", "2e5", {"field.border=free"}},
      {"field.smallest_plate", "4", {"field.border=free"}},
      {"ice.variation.correlation_length", "3", {"ice.variation.thickness=0.1"}},
      {"field.initial_crack_radius", "1", {"field.initial_crack=true"}},
      {"field.origin", "[1,2]", {"field.shore=tests/experiments/shore.wkt"}},
      {"hydrodynamics.rotational_drag", "0.8", {"hydrodynamics.drag=paper", "algorithm.preset=paper"}},
      {"hydrodynamics.shading_gap", "0.4", {"hydrodynamics.shading=true"}},
      {"water.bed_friction", "0.5", {"water.depth=5"}},
      {"wind.density", "1.2", {"wind.velocity=[5,0]"}},
      {"wind.skin_friction", "0.002", {"wind.velocity=[5,0]"}},
      {"failure.lateness", "0.1", {"failure.model=plate-outline"}},
      {"structure.motion.thrust_arm", "[1,0,0]", {"structure.motion.thrust=[1e5,0,0]"}},
  };
  std::filesystem::current_path(kSource);  // the file of the shore
  for (const Idle& one : all) {
    std::vector<std::string> settings{one.key + "=" + one.value, "failure.model=wedge", "hydrodynamics.drag=surface",
                                      "hydrodynamics.shading=false", "field.initial_crack=false"};
    if (one.key.starts_with("structure.motion")) settings.push_back("structure.motion.kind=free");
    const auto text = text_of(warnings_with(settings), "idle-keys");
    BOOST_TEST(says(text, one.key + " needs "), one.key + ": " + text);
    settings.insert(settings.end(), one.needs.begin(), one.needs.end());
    BOOST_TEST(text_of(warnings_with(settings), "idle-keys") == "", one.key);
  }
}

BOOST_AUTO_TEST_CASE(keys_of_drift_shape_and_chance_are_idle_where_nothing_reads_them) {
  const auto idle = [](const std::vector<std::string>& settings) {
    return text_of(warnings_with(settings), "idle-keys");
  };
  BOOST_TEST(says(idle({"field.border=free", "time.settle_speed=0.01"}), "time.settle_speed needs "));
  BOOST_TEST(idle({"time.settle_speed=0.01"}) == "");
  BOOST_TEST(
      says(idle({"hydrodynamics.form_drag=0", "hydrodynamics.form_drag_along=velocity"}), "form_drag_along needs"));
  BOOST_TEST(says(idle({"hull.flare=10 deg", "hull.length=80", "hull.breadth=20", "hull.draught=6",
                        "hull.stem_angle=25 deg", "hull.waterline_angle=30 deg"}),
                  "hull.flare needs structure.kind"));
  // Four wedges in every break, even ice, no generated floes: all replicates are alike.
  BOOST_TEST(says(idle({"failure.wedges=[4,4]", "random.seed=7"}), "random.seed needs something random"));
  BOOST_TEST(idle({"failure.wedges=[4,4]"}) == "");
  BOOST_TEST(idle({"failure.wedges=[4,4]", "random.seed=7", "ice.variation.thickness=0.1"}) == "");
  BOOST_TEST(idle({"random.seed=7"}) == "");
}

BOOST_AUTO_TEST_CASE(a_track_through_north_is_no_mistake) {
  const auto turns = [](const std::string& first, const std::string& second) {
    const std::string path = "structure.motion.path=[[0,-7,0," + first + "],[20,13,0," + second + "]]";
    const std::string file = kSource + "/tests/modules/simulation/turning_path.toml";
    return has(advice::warnings_of(io::read_case(file, {path})), "path-turns");
  };
  BOOST_TEST(!turns("\"350 deg\"", "\"10 deg\""));
  BOOST_TEST(!turns("0", "3"));
  BOOST_TEST(turns("0", "45"));
}

BOOST_AUTO_TEST_CASE(a_thrust_a_pretension_and_a_heavy_body_break_ice_without_a_stiff_spring) {
  const auto is_soft = [](std::vector<std::string> settings) {
    settings.insert(settings.end(), {"structure.motion.kind=moored",
                                     "structure.motion.stiffness_matrix=[[0,0,0,0,0,0],[0,1e5,0,0,0,0],[0,0,0,0,0,0],"
                                     "[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,1e8]]"});
    return has(warnings_with(settings), "soft-spring");
  };
  BOOST_TEST(is_soft({}));
  BOOST_TEST(!is_soft({"structure.motion.thrust=[1e6,0,0]"}));
  BOOST_TEST(!is_soft({"structure.motion.pretension=[1e6,0,0,0,0,0]"}));
  // 3.6 MJ break ice with 59 kN over the 24 m of the run.
  const auto compliant = [](const std::string& mass) {
    return has(warnings_with({"structure.motion.kind=compliant", "structure.motion.stiffness=100", mass}),
               "soft-spring");
  };
  BOOST_TEST(!compliant("structure.motion.mass=5e6"));
  BOOST_TEST(compliant("structure.motion.mass=5e5"));
}

BOOST_AUTO_TEST_CASE(a_hull_askew_whose_inertia_is_stated_gives_no_warning) {
  const std::string file = kSource + "/tests/modules/simulation/askew_barge.toml";
  const auto is_askew = [&](const std::vector<std::string>& settings) {
    return has(advice::warnings_of(io::read_case(file, settings)), "askew-hull");
  };
  BOOST_TEST(is_askew({}));
  BOOST_TEST(!is_askew({"structure.heading=0"}));
  BOOST_TEST(!is_askew({"structure.heading=90 deg"}));
  BOOST_TEST(!is_askew({"structure.motion.radii_of_gyration=[3,6,6]", "structure.motion.added_mass=[1e4,1e5,1e6]",
                        "structure.motion.added_inertia=[1e6,1e7,1e6]"}));
}

BOOST_AUTO_TEST_CASE(the_source_of_a_reference_is_idle_without_its_value_unless_it_names_a_basin) {
  model::Case c = validation();
  c.reference.mean_horizontal.reset();
  c.reference.source = "a pier";
  BOOST_TEST(says(text_of(advice::warnings_of(c), "idle-keys"), "reference.source needs "));
  c.reference.source = "ice of a model basin";
  BOOST_TEST(text_of(advice::warnings_of(c), "idle-keys") == "");
}

BOOST_AUTO_TEST_CASE(the_laws_of_generated_floes_are_idle_beside_a_file_of_floes) {
  model::Case c = validation({"field.initial_crack=false"});
  c.field.kind = model::FieldKind::kFloes;
  c.field.file = "floes.wkt";
  BOOST_TEST(text_of(advice::warnings_of(c), "idle-keys") == "");
  c.field.floes.shape = model::FloeShape::kDiscs;
  c.field.floes.size.median = 3.0;
  const auto text = text_of(advice::warnings_of(c), "idle-keys");
  BOOST_TEST(says(text, "field.shape needs floes without field.file; field.size needs floes"), text);
}

}  // namespace
