// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/io/case.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "scratch.hpp"

using namespace brash;
using namespace brash::io;
using namespace brash::model;

namespace {

const std::string kValidation = std::string(BRASH_SOURCE_DIR) + "/experiments/validation/cone.toml";

Case with(const std::string& override_text) { return read_case(kValidation, {override_text}); }
Cone cone_of(const Case& c) { return std::get<Cone>(c.structure.shape); }
double thickness(const std::string& value) { return with("ice.thickness=" + value).ice.thickness; }

}  // namespace

BOOST_AUTO_TEST_SUITE(case_file)

BOOST_AUTO_TEST_CASE(the_validation_case_has_the_values_of_the_paper) {
  const Case c = read_case(kValidation);
  BOOST_TEST(c.name == "cone");
  BOOST_TEST(c.ice.thickness == 0.33);
  BOOST_TEST(c.ice.youngs_modulus == 0.35e9);
  BOOST_TEST(c.ice.flexural_strength == 539e3);
  BOOST_TEST(c.ice.compressive_strength == 1e6);
  // The conversion factor pi/180 is rounded differently by UDUNITS: one unit in the last place.
  BOOST_TEST(std::abs(cone_of(c).angle - radians(61.4)) <= 2.3e-16);
  BOOST_TEST(speed(c.structure.motion) == 1.202);
  BOOST_TEST((c.failure.model == FailureModel::kNetwork));
  BOOST_TEST(c.failure.wedges[0] == 3);
  BOOST_TEST(c.failure.wedges[1] == 5);
  BOOST_TEST(c.random.seed == 1u);
  BOOST_TEST(c.time.duration == 20.0);
}

BOOST_AUTO_TEST_CASE(keys_that_are_not_written_have_the_defaults_of_the_header) {
  const Scratch scratch;
  const Case c = read_case(scratch.write("least.toml", kLeastCase));
  Case expected;
  expected.name = "least";
  expected.ice.thickness = 0.33;
  expected.ice.youngs_modulus = 0.35e9;
  expected.ice.flexural_strength = 539e3;
  expected.structure.shape =
      Cone{.angle = cone_of(c).angle, .waterline_width = 13.6, .height = 9.08, .height_under_water = 5.68};
  expected.structure.motion = Towed{1.202};
  expected.structure.start_distance = 7;
  expected.field.length = 50;
  expected.field.width = 50;
  expected.time.duration = 20;
  BOOST_TEST(to_toml(c) == to_toml(expected));
  BOOST_TEST((c == expected));
}

BOOST_AUTO_TEST_CASE(a_preset_sets_defaults_only_and_what_is_written_wins) {
  const Case paper = read_case(kValidation);
  BOOST_TEST((paper.failure.model == FailureModel::kNetwork));
  BOOST_TEST(!paper.failure.under_floes);
  BOOST_TEST(!paper.failure.second_order);
  BOOST_TEST((paper.failure.pieces == model::Pieces::kWhole));
  const Case brash_ = read_case(kValidation, {"algorithm.preset=brash"});
  BOOST_TEST((brash_.failure.model == FailureModel::kPlateOutline));
  BOOST_TEST((brash_.failure.pattern == model::CrackPattern::kStress));
  BOOST_TEST((brash_.failure.pieces == model::Pieces::kBreak));
  BOOST_TEST(brash_.failure.second_order);
  BOOST_TEST(!read_case(kValidation, {"algorithm.preset=brash", "failure.second_order=false"}).failure.second_order);
  const std::vector<std::string> left{"failure.order",
                                      "failure.second_order",
                                      "failure.under_floes",
                                      "failure.joint_loads",
                                      "failure.edge",
                                      "failure.judged",
                                      "failure.pattern",
                                      "failure.pressure",
                                      "failure.length_density",
                                      "failure.small_contact",
                                      "failure.crushed_ice",
                                      "failure.pieces",
                                      "failure.lateness",
                                      "contact.engine",
                                      "contact.area",
                                      "contact.crushing_bound",
                                      "contact.iterations",
                                      "contact.floe_stress",
                                      "hydrodynamics.drag",
                                      "hydrodynamics.drag_travel",
                                      "hydrodynamics.form_drag_along",
                                      "hydrodynamics.skin_friction",
                                      "hydrodynamics.added_mass_law",
                                      "hydrodynamics.ventilation",
                                      "hydrodynamics.structure_flow",
                                      "output.statistics_from"};
  BOOST_TEST(keys_set_by_preset(kValidation, {"failure.model=plate"}) == left);
}

BOOST_AUTO_TEST_CASE(the_preset_paper_is_the_literal_reading_of_decision_39) {
  const Case c = read_case(kValidation);
  BOOST_TEST((c.contact.area == ContactArea::kProjected && c.contact.crushing_bound == CrushingBound::kLevelIce));
  BOOST_TEST((c.contact.floe_stress == model::FloeStress::kStep && c.contact.engine == ContactEngine::kBullet));
  BOOST_TEST(c.contact.iterations == 10);
  const FailureSection& f = c.failure;
  BOOST_TEST((f.crushed_ice == CrushedIce::kStays && f.pressure == EdgePressure::kContact));
  BOOST_TEST((f.small_contact == SmallContact::kKeepsPressure && f.length_density == LengthDensity::kIce));
  const HydrodynamicsSection& h = c.hydrodynamics;
  BOOST_TEST((h.added_mass_law == AddedMassLaw::kNone && h.drag == DragLaw::kPaper));
  BOOST_TEST((h.skin_friction == 0.0 && h.drag_travel == 0.0));
  BOOST_TEST((c.output.statistics_from == 0.0));
  BOOST_TEST((!read_case(kValidation, {"algorithm.preset=brash"}).output.statistics_from));
}

BOOST_AUTO_TEST_CASE(the_engine_of_the_preset_paper_gives_way_to_what_it_does_not_know) {
  for (const char* const key :
       {"field.border=free", "water.depth=5", "contact.restitution=0.2", "hydrodynamics.added_mass_law=plate"}) {
    BOOST_TEST((read_case(kValidation, {key}).contact.engine == ContactEngine::kBrash));
    BOOST_CHECK_THROW(read_case(kValidation, {key, "contact.engine=bullet"}), InputError);
  }
}

/// They have their values from before that decision.
BOOST_AUTO_TEST_CASE(the_second_reading_differs_from_the_validation_case_in_the_keys_of_decision_39_alone) {
  const Case earlier = read_case(std::string(BRASH_SOURCE_DIR) + "/experiments/validation/second_reading.toml");
  Case same = read_case(kValidation);
  same.name = earlier.name;
  same.contact = ContactSection{};
  same.hydrodynamics = {.form_drag_along = FormDragAlong::kVelocity,
                        .added_mass_law = AddedMassLaw::kIsotropic,
                        .ventilation = false,
                        .structure_flow = false};
  same.failure.crushed_ice = CrushedIce::kLeaves;
  same.failure.pressure = EdgePressure::kEdge;
  same.failure.small_contact = SmallContact::kKeepsForce;
  same.failure.length_density = LengthDensity::kWater;
  same.output.statistics_from = 7.0 / 1.202;
  BOOST_TEST((earlier == same));
}

BOOST_AUTO_TEST_CASE(a_default_that_the_failure_model_does_not_take_is_left_out) {
  const Case wedge = read_case(kValidation, {"algorithm.preset=brash", "failure.model=wedge"});
  BOOST_TEST(!wedge.failure.second_order);
  BOOST_TEST(!wedge.failure.joint_loads);
  BOOST_TEST((wedge.failure.judged == model::JudgedAt::kCentreLine));
  BOOST_TEST((wedge.failure.pattern == model::CrackPattern::kDisc));
  BOOST_TEST((wedge.failure.order == CrackOrder::kCircumferentialFirst));
  BOOST_CHECK_THROW(read_case(kValidation, {"failure.model=wedge", "failure.second_order=true"}), InputError);
}

BOOST_AUTO_TEST_CASE(readings_of_the_meta_model_need_a_network) {
  const auto failure_of = [](std::vector<std::string> keys) { return read_case(kValidation, keys).failure; };
  BOOST_TEST((failure_of({"failure.pressure=contact"}).pressure == EdgePressure::kContact));
  BOOST_TEST((failure_of({"failure.small_contact=keeps-pressure"}).small_contact == SmallContact::kKeepsPressure));
  BOOST_TEST((failure_of({"failure.length_density=ice"}).length_density == LengthDensity::kIce));
  for (const char* const key : {"failure.pressure=contact", "failure.length_density=ice"})
    BOOST_CHECK_THROW(failure_of({"failure.model=wedge", key}), InputError);
}

BOOST_AUTO_TEST_CASE(the_preset_brash_takes_the_laws_of_the_water_that_the_other_keys_take) {
  const auto water_of = [](std::vector<std::string> keys) {
    keys.emplace_back("algorithm.preset=brash");
    return read_case(kValidation, keys).hydrodynamics;
  };
  const HydrodynamicsSection all = water_of({});
  BOOST_TEST((all.added_mass_law == AddedMassLaw::kPlate && all.form_drag_along == FormDragAlong::kNormal));
  BOOST_TEST((all.ventilation && all.structure_flow));
  const HydrodynamicsSection paper = read_case(kValidation).hydrodynamics;
  BOOST_TEST((paper.added_mass_law == AddedMassLaw::kNone && paper.form_drag_along == FormDragAlong::kVelocity));
  BOOST_TEST((!paper.ventilation && !paper.structure_flow));

  BOOST_TEST((water_of({"hydrodynamics.drag=paper"}).form_drag_along == FormDragAlong::kVelocity));
  BOOST_TEST((water_of({"hydrodynamics.added_mass=0.7"}).added_mass_law == AddedMassLaw::kIsotropic));
  BOOST_TEST((water_of({"contact.engine=bullet"}).added_mass_law == AddedMassLaw::kIsotropic));
  BOOST_TEST(
      (water_of({"hydrodynamics.added_mass_law=none", "contact.engine=bullet"}).added_mass_law == AddedMassLaw::kNone));
  BOOST_CHECK_THROW(water_of({"hydrodynamics.drag=paper", "hydrodynamics.form_drag_along=normal"}), InputError);
  BOOST_CHECK_THROW(water_of({"contact.engine=bullet", "hydrodynamics.added_mass_law=plate"}), InputError);
}

BOOST_AUTO_TEST_CASE(the_resolved_text_reads_back_to_the_same_case) {
  const Scratch scratch;
  scratch.write("model \"a\".json", "{}");
  Case c = read_case(kValidation, {"structure.angle=0.1 deg", "structure.angle=61.37 deg",
                                   "time.step=0.1234567890123456789", "random.seed=9223372036854775807",
                                   "water.current=['10 cm/s', -1e-17]", "ice.density=899.99999999999989",
                                   "structure.breaking=upward", "failure.file=" + scratch.path("model \"a\".json"),
                                   "field.initial_crack=false", "output.statistics_from=7.3"});
  BOOST_TEST(c.random.seed == 9223372036854775807u);
  const Case again = read_case(scratch.write("cone.toml", to_toml(c)));
  BOOST_TEST((again == c));
  BOOST_TEST(to_toml(again) == to_toml(c));
}

BOOST_AUTO_TEST_CASE(the_template_is_a_case_with_every_key) {
  const Scratch scratch;
  const Case c = read_case(scratch.write("cone.toml", case_template()));
  Case validation = read_case(kValidation);
  validation.reference = {};  // a measured load belongs to one case
  BOOST_TEST((c.failure.model == FailureModel::kPlateOutline));
  BOOST_TEST(c.failure.joint_loads);
  BOOST_TEST(c.failure.under_floes);
  BOOST_TEST(c.failure.second_order);
  BOOST_TEST((c.failure.order == CrackOrder::kRadialFirst));
  // The paper's preset there, the default here.
  validation.algorithm = c.algorithm;
  validation.failure = c.failure;
  validation.hydrodynamics = c.hydrodynamics;
  validation.contact = c.contact;
  validation.output = c.output;
  BOOST_TEST((c == validation));
  // Every key of the resolved text is in the template too.
  const std::string text = case_template();
  for (const char* key : {"\n# entrance = ", "\n# stiffness = ", "\nrotational_drag = ", "\ncurrent = ",
                          "\nreplicate = ", "\narea = ", "\nfile = "})
    BOOST_TEST(text.find(key) != std::string::npos, key);
}

BOOST_AUTO_TEST_CASE(quantities_convert_to_si) {
  BOOST_TEST(thickness("33 cm") == 0.33);
  BOOST_TEST(thickness("\"33cm\"") == 0.33);
  BOOST_TEST(thickness("330 mm") == 0.33);
  BOOST_TEST(thickness("+3.3e-1 m") == 0.33);
  BOOST_TEST(thickness("1 ft") == 0.3048);
  BOOST_TEST(with("ice.fracture_toughness=150 kPa m^0.5").ice.fracture_toughness == 150e3);
  BOOST_TEST(with("ice.fracture_toughness=0.15 MPa*m^0.5").ice.fracture_toughness == 150e3);
  BOOST_TEST(thickness("1 in") == 0.0254);
  BOOST_TEST(with("ice.flexural_strength=539 kPa").ice.flexural_strength == 539e3);
  BOOST_TEST(with("ice.flexural_strength=0.539 N/mm2").ice.flexural_strength == 539e3);
  BOOST_TEST(with("ice.flexural_strength=0.539 N mm^-2").ice.flexural_strength == 539e3);
  BOOST_TEST(with("ice.density=0.9 g/cm3").ice.density == 900.0);
  BOOST_TEST(speed(with("structure.speed=3.6 km/h").structure.motion) == 1.0,
             boost::test_tools::tolerance(4e-16));  // two roundings
  BOOST_TEST(with("time.duration=1 min").time.duration == 60.0);
  BOOST_TEST(with("ice.poisson_ratio=30 %").ice.poisson_ratio == 0.3);
  BOOST_TEST(with("output.frames_per_second=25 Hz").output.frames_per_second == 25.0);
  BOOST_TEST(with("output.frames_per_second=25 1/s").output.frames_per_second == 25.0);
  BOOST_TEST(cone_of(with("structure.angle=1.07 rad")).angle == 1.07);
  BOOST_TEST(cone_of(with("structure.angle=1.07")).angle == 1.07);
}

BOOST_AUTO_TEST_CASE(units_that_udunits_misreads_mean_what_sailors_mean) {
  // UDUNITS alone: nano-mile and parts per trillion.
  BOOST_TEST(with("field.length=1 nmi").field.length == 1852.0);
  BOOST_TEST(with("ice.friction_ice=300 ppt").ice.friction_ice == 0.3);
  // Its knot is 1852/3600 m/s, printed and stored as a double.
  BOOST_TEST(speed(with("structure.speed=2 knots").structure.motion) == 2 * 1852.0 / 3600.0,
             boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(overrides_win_over_the_file_and_the_last_one_wins) {
  const Case c = read_case(kValidation, {"ice.thickness=0.4", "ice.thickness = 50 cm", "contact.restitution=0.1"});
  BOOST_TEST(c.ice.thickness == 0.5);
  BOOST_TEST(c.contact.restitution == 0.1);
}

BOOST_AUTO_TEST_CASE(a_model_file_is_relative_to_the_case_file) {
  const Scratch scratch;
  const std::string model = scratch.write("model.json", "{}");
  const std::string path =
      scratch.write("case.toml", std::string(kLeastCase) + "[failure]\nmodel = \"network\"\nfile = \"./model.json\"\n");
  BOOST_TEST(read_case(path).failure.file == model);
}

BOOST_AUTO_TEST_CASE(the_schema_is_what_the_program_carries) {
  BOOST_TEST(case_schema() == read_bytes(std::string(BRASH_SOURCE_DIR) + "/modules/io/case.schema.json"));
}

BOOST_AUTO_TEST_CASE(the_speed_is_written_in_the_motion_or_in_its_short_form) {
  const Scratch scratch;
  std::string text = kLeastCase;
  const std::size_t at = text.find("speed = 1.202\n");
  BOOST_REQUIRE(at != std::string::npos);
  text.erase(at, std::string("speed = 1.202\n").size());
  const std::string in_long = text + "[structure.motion]\nkind = \"towed\"\nspeed = \"2.404 m/s\"\n";
  const Case c = read_case(scratch.write("long.toml", in_long));
  BOOST_TEST(speed(c.structure.motion) == 2.404);
  BOOST_TEST(to_toml(c).find("[structure.motion]\nframe = \"structure-moves\"\n") != std::string::npos);
  BOOST_TEST(to_toml(c).find("speed = 2.404") != std::string::npos);
  std::filesystem::create_directory(scratch.folder() / "again");
  BOOST_TEST((read_case(scratch.write("again/long.toml", to_toml(c))) == c));

  const auto message_of = [&](const std::string& file, const std::vector<std::string>& overrides) -> std::string {
    try {
      read_case(scratch.write("both.toml", file), overrides);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  BOOST_TEST(message_of(kLeastCase, {"structure.motion.speed=3"}).find("is the short form of structure.motion.speed") !=
             std::string::npos);
  BOOST_TEST(message_of(text, {"structure.motion.kind=towed"}).find("structure.speed: is missing") !=
             std::string::npos);
  BOOST_TEST(message_of(kLeastCase, {"structure.motion.kind=twoed"}).find("nearest: \"towed\"") != std::string::npos);
  BOOST_TEST(message_of(kLeastCase, {"structure.motion.stiffness=3"}).find("is not a key of structure.motion.kind") !=
             std::string::npos);
  BOOST_TEST(message_of(kLeastCase, {"structure.motion.stiffnes=3"}).find("is not a known key") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(every_key_has_a_meaning_a_unit_and_limits_that_hold) {
  const auto schema = nlohmann::json::parse(case_schema());
  const auto refused = [](const std::string& key, const std::string& value) {
    try {
      read_case(kValidation, {key + "=" + value});
    } catch (const InputError& error) {
      return std::string(error.what()).find(key) != std::string::npos;
    }
    return false;
  };
  for (const auto& [section, content] : schema["properties"].items()) {
    BOOST_TEST(!content["additionalProperties"].get<bool>(), section);
    for (const auto& [name, key] : content["properties"].items()) {
      const std::string full_name = section + "." + name;
      BOOST_TEST(!key["description"].get<std::string>().empty(), full_name);
      BOOST_TEST(refused(full_name, "2020-01-01"), full_name);
      BOOST_TEST(refused(full_name, "nan"), full_name);
      if (!key["type"].is_array()) continue;

      // A quantity: it has a unit, both limits or a reason in its kind, and a value just outside is refused.
      BOOST_TEST(key.contains("x-unit"), full_name);
      BOOST_TEST((key.contains("minimum") || key.contains("exclusiveMinimum")), full_name);
      BOOST_TEST((key.contains("maximum") || key.contains("exclusiveMaximum")), full_name);
      BOOST_TEST(refused(full_name, "1 cd"), full_name);
      if (key.contains("exclusiveMinimum")) BOOST_TEST(refused(full_name, key["exclusiveMinimum"].dump()), full_name);
      if (key.contains("minimum"))
        BOOST_TEST(refused(full_name, std::to_string(key["minimum"].get<double>() - 0.01)), full_name);
      if (key.contains("exclusiveMaximum")) BOOST_TEST(refused(full_name, key["exclusiveMaximum"].dump()), full_name);
      if (key.contains("maximum"))
        BOOST_TEST(refused(full_name, std::to_string(key["maximum"].get<double>() * 1.01)), full_name);
    }
  }
}

/// The names of a choice in the schema, in its order.
std::vector<std::string> names_in_schema(const char* section, const char* key) {
  const auto schema = nlohmann::json::parse(case_schema());
  return schema.at("properties").at(section).at("properties").at(key).at("enum");
}

template <typename Choice>
std::vector<std::string> names_in_model() {
  std::vector<std::string> names;
  for (const auto& entry : kNames<Choice>) names.emplace_back(entry.name);
  return names;
}

BOOST_AUTO_TEST_CASE(the_schema_and_the_model_name_the_same_choices) {
  BOOST_TEST(names_in_schema("algorithm", "preset") == names_in_model<Preset>());
  BOOST_TEST(names_in_schema("structure", "kind") == names_in_model<StructureKind>());
  const auto motion = nlohmann::json::parse(case_schema())["properties"]["structure"]["properties"]["motion"];
  BOOST_TEST(motion["properties"]["kind"]["enum"].get<std::vector<std::string>>() == names_in_model<MotionKind>());
  BOOST_TEST(names_in_schema("structure", "breaking") == names_in_model<Breaking>());
  BOOST_TEST(names_in_schema("field", "kind") == names_in_model<FieldKind>());
  BOOST_TEST(names_in_schema("failure", "model") == names_in_model<FailureModel>());
  BOOST_TEST(names_in_schema("failure", "order") == names_in_model<CrackOrder>());
  BOOST_TEST(names_in_schema("failure", "pattern") == names_in_model<CrackPattern>());
  BOOST_TEST(names_in_schema("failure", "pressure") == names_in_model<EdgePressure>());
  BOOST_TEST(names_in_schema("failure", "length_density") == names_in_model<LengthDensity>());
  BOOST_TEST(names_in_schema("failure", "small_contact") == names_in_model<SmallContact>());
  BOOST_TEST(names_in_schema("failure", "crushed_ice") == names_in_model<CrushedIce>());
  BOOST_TEST(names_in_schema("failure", "pieces") == names_in_model<Pieces>());
  BOOST_TEST(names_in_schema("contact", "area") == names_in_model<ContactArea>());
  BOOST_TEST(names_in_schema("contact", "crushing_bound") == names_in_model<CrushingBound>());
  BOOST_TEST(names_in_schema("contact", "floe_stress") == names_in_model<FloeStress>());
  BOOST_TEST(names_in_schema("contact", "engine") == names_in_model<ContactEngine>());
  BOOST_TEST(names_in_schema("hydrodynamics", "drag") == names_in_model<DragLaw>());
  BOOST_TEST(names_in_schema("hydrodynamics", "form_drag_along") == names_in_model<FormDragAlong>());
  BOOST_TEST(names_in_schema("hydrodynamics", "added_mass_law") == names_in_model<AddedMassLaw>());
}

BOOST_AUTO_TEST_SUITE_END()
