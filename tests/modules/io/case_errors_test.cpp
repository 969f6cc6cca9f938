// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "scratch.hpp"

using namespace brash;
using namespace brash::io;
using namespace brash::model;

namespace {

/// The message that reading `text` ends with, the folder's name cut out; "" when it is read.
std::string message_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const Scratch scratch;
  try {
    read_case(scratch.write("bad.toml", text), overrides);
  } catch (const InputError& error) {
    std::string message = error.what();
    const std::string folder = scratch.folder().string() + "/";
    for (std::size_t at; (at = message.find(folder)) != std::string::npos;) message.erase(at, folder.size());
    return message;
  }
  return "";
}

/// The least case with its line `key = ...` replaced by `line`.
std::string with_line(const std::string& key, const std::string& line) {
  std::string text = kLeastCase;
  const std::size_t begin = text.find("\n" + key + " = ") + 1;
  return text.replace(begin, text.find('\n', begin) - begin, line);
}

std::string with_more(const std::string& text) { return kLeastCase + text; }

void check_has(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    BOOST_TEST(message.find(part) != std::string::npos, "\"" << part << "\" is not in:\n" << message);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(case_errors)

BOOST_AUTO_TEST_CASE(the_least_case_is_no_error) { BOOST_TEST(message_of(kLeastCase) == ""); }

BOOST_AUTO_TEST_CASE(an_unknown_key_names_the_nearest_one) {
  check_has(message_of(with_line("thickness", "thicknes = 0.33")),
            {"bad.toml:2:1: ice.thicknes = 0.33: is not a known key", "allowed: keys of [ice]: thickness, density",
             "nearest: ice.thickness", "remedy:  rename it",
             // The right one is missing then, which is said as well.
             "bad.toml:1:1: ice.thickness: is missing", "add `thickness = \"0.33 m\"`"});
}

BOOST_AUTO_TEST_CASE(a_key_in_the_wrong_section_names_the_right_one) {
  check_has(message_of(with_more("thickness = 1\n")), {"bad.toml:17:1: time.thickness = 1", "nearest: ice.thickness"});
}

BOOST_AUTO_TEST_CASE(a_key_above_all_sections_names_its_section) {
  check_has(message_of("preset = \"paper\"\n" + std::string(kLeastCase)),
            {"bad.toml:1:10: preset = \"paper\": stands outside the sections", "nearest: algorithm.preset",
             "remedy:  write it below the line `[algorithm]`"});
  check_has(
      message_of("colour = 3\n" + std::string(kLeastCase)),
      {"colour = 3: stands outside the sections", "remedy:  remove it, or write it below the line of its section"});
}

BOOST_AUTO_TEST_CASE(an_unknown_section_names_the_nearest_one) {
  check_has(
      message_of(with_more("[hidrodynamics]\nform_drag = 1\n")),
      {"bad.toml:17:1: [hidrodynamics]: is not a known section",
       "allowed: sections algorithm, ice, ice.variation, water", "nearest: [hydrodynamics]", "remedy:  rename it"});
}

BOOST_AUTO_TEST_CASE(a_missing_section_lists_its_required_keys) {
  std::string text = kLeastCase;
  text.erase(text.find("[time]"));
  check_has(message_of(text), {"bad.toml:1:1: time.duration: is missing", "allowed: a finite number >= 1e-06",
                               "remedy:  add `duration = \"20 s\"` or the like under `[time]`"});
}

BOOST_AUTO_TEST_CASE(a_value_out_of_range_is_shown_in_si) {
  check_has(message_of(with_line("thickness", "thickness = \"33 km\"")),
            {"bad.toml:2:13: ice.thickness = \"33 km\": is out of range (33000.0 in SI)",
             "allowed: a finite number >= 0.001 and <= 10 in m, or a string with a unit that converts to m",
             "remedy:  lower it, to at most 10 m"});
  check_has(message_of(with_line("thickness", "thickness = 0")), {"bad.toml:2:13: ice.thickness = 0: is out of range"});
  check_has(message_of(with_line("thickness", "thickness = -0.33")), {"ice.thickness = -0.33: is out of range"});
}

BOOST_AUTO_TEST_CASE(an_angle_without_its_unit_is_told_about_degrees) {
  check_has(message_of(with_line("angle", "angle = 61.4")),
            {"bad.toml:6:9: structure.angle = 61.4",
             "remedy:  write the unit, such as \"61.4 deg\": a bare number is in radians"});
}

BOOST_AUTO_TEST_CASE(a_value_of_another_type_is_refused) {
  check_has(
      message_of(with_line("thickness", "thickness = true")),
      {"bad.toml:2:13: ice.thickness = true: is a value of another type, not a number", "allowed: a finite number"});
  check_has(message_of(with_more("[structure.more]\n")), {"structure.more", "is not a known key"});
  check_has(message_of(with_line("thickness", "thickness = {m = 1}")), {"ice.thickness", "is a table, not a value"});
  check_has(message_of(with_line("thickness", "thickness = 2020-01-01")), {"ice.thickness", "is a date or time"});
  check_has(message_of(with_line("thickness", "thickness = [0.33]")), {"ice.thickness", "another type"});
  check_has(message_of(with_more("[random]\nseed = 1.5\n")), {"random.seed = 1.5", "not a whole number"});
  check_has(message_of(with_more("[random]\nseed = 1.0\n")), {"random.seed = 1.0", "not a whole number"});
  check_has(message_of(with_more("[failure]\nfile = 3\n")), {"failure.file = 3", "not a string"});
  check_has(message_of(std::string("water = 3\n") + kLeastCase), {"bad.toml:1:9: water = 3: must be a section"});
}

BOOST_AUTO_TEST_CASE(a_number_that_is_not_finite_is_refused) {
  for (const char* value : {"inf", "-inf", "nan", "\"nan m\"", "\"inf m\"", "\"1e400 m\"", "1e400"})
    check_has(message_of(with_line("thickness", std::string("thickness = ") + value)),
              {"bad.toml:2:", "ice.thickness", "remedy"});
  check_has(message_of(with_line("thickness", "thickness = nan")),
            {"is not finite", "allowed: a finite number >= 0.001"});
}

BOOST_AUTO_TEST_CASE(a_unit_that_does_not_fit_is_refused) {
  const auto of = [](const std::string& value) { return message_of(with_line("thickness", "thickness = " + value)); };
  check_has(of("\"33 kg\""), {"bad.toml:2:13: ice.thickness = \"33 kg\"", "the unit kg does not convert to m",
                              "allowed: ", "such as \"0.33 m\""});
  check_has(of("\"33 furlings\""), {"the unit furlings is not known"});
  check_has(of("\"0.33\""), {"the string has no unit"});
  check_has(of("\"\""), {"does not begin with a number"});
  check_has(of("\"cm\""), {"does not begin with a number"});
  check_has(of("\"0,33 m\""), {"the number has a decimal comma"});
  check_has(of("\"0.1 m2\""), {"does not convert to m"});
}

BOOST_AUTO_TEST_CASE(fractional_exponents_and_numbers_in_a_unit_are_refused) {
  // UDUNITS alone reads the first two as 5 MPa and 0.5, the third as 0.66 m, the fourth as 1650 m.
  const auto of = [](const std::string& value) {
    return message_of(with_line("flexural_strength", "flexural_strength = \"" + value + "\""));
  };
  check_has(of("0.1 MPa m^0.5"), {"an exponent must be a whole number", "symbols with whole exponents"});
  check_has(of("0.1 MPa m0.5"), {"an exponent must be a whole number"});
  check_has(of("0.1 MPa m^(1/2)"), {"an exponent must be a whole number"});
  check_has(of("0.1 2 MPa"), {"'2' is not part of a unit"});
  check_has(of("0.1 MPa 5"), {"'5' is not part of a unit"});
  check_has(of("0.1 MPa^"), {"an exponent is missing"});
  check_has(of("0.1 MPa^999999999999"), {"an exponent is too large"});
  check_has(of("0.1 MPa/"), {"it is incomplete"});
}

BOOST_AUTO_TEST_CASE(a_toughness_has_the_root_of_the_metre) {
  const auto of = [](const std::string& value) {
    return message_of(with_line("thickness", "thickness = 0.33\nfracture_toughness = \"" + value + "\""));
  };
  check_has(of("150 kPa"), {"the unit kPa does not convert to Pa m^0.5", "MPa m^0.5"});
  check_has(of("150 kPa m"), {"does not convert to Pa m^0.5"});
  check_has(of("150 kg m^0.5"), {"the unit kg does not convert to Pa"});
  check_has(of("150 m^0.5"), {"cannot be read"});
}

BOOST_AUTO_TEST_CASE(angles_and_ratios_do_not_convert_into_each_other) {
  check_has(message_of(with_line("angle", "angle = \"50 %\"")), {"the unit % does not convert to rad"});
  check_has(message_of(with_more("[contact]\nrestitution = \"10 deg\"\n")), {"the unit deg does not convert to 1"});
}

BOOST_AUTO_TEST_CASE(an_unknown_name_is_told_the_nearest) {
  check_has(
      message_of(with_more("[failure]\nmodel = \"plates\"\n")),
      {"bad.toml:18:9: failure.model = \"plates\": is not a known name",
       "allowed: one of \"network\", \"deep-network\", \"superposition\", \"plate\", \"plate-outline\", \"wedge\"",
       "nearest: \"plate\"", "take the default \"plate-outline\""});
  const std::string paper = "[algorithm]\npreset = \"paper\"\n";
  check_has(message_of(with_more("[failure]\nmodel = \"fem\"\n" + paper)), {"take the default \"network\""});
}

BOOST_AUTO_TEST_CASE(an_array_of_another_size_is_refused) {
  check_has(message_of(with_more("[failure]\nwedges = [3]\n")), {"bad.toml:18:10: failure.wedges = [3]", "has 1 values",
                                                                 "an array of 2, each a whole number >= 1 and <= 16"});
  check_has(message_of(with_more("[failure]\nwedges = [3, 99]\n")), {"failure.wedges"});
  check_has(message_of(with_more("[water]\ncurrent = [0.1, \"3 kg\"]\n")),
            {"water.current", "kg does not convert to m s-1"});
}

BOOST_AUTO_TEST_CASE(duplicate_keys_and_sections_are_refused) {
  check_has(
      message_of(with_line("thickness", "thickness = 1\nthickness = 2")),
      {"bad.toml:3:", "ice.thickness = 2", "redefine", "each key and section once", "remedy:  remove one of the two"});
  check_has(message_of(with_more("[ice]\ndensity = 900\n")),
            {"bad.toml:17:", "[ice]", "remedy:  remove one of the two"});
}

BOOST_AUTO_TEST_CASE(a_syntax_error_has_its_place_key_and_value) {
  check_has(message_of(with_line("thickness", "thickness = 33 cm")),
            {"bad.toml:2:", "ice.thickness = 33 cm", "allowed: TOML 1.0", "a number with a unit"});
  check_has(message_of(with_line("thickness", "thickness = ")), {"bad.toml:2:", "ice.thickness", "remedy"});
  check_has(message_of(with_line("thickness", "thickness")), {"bad.toml:2:", "line `thickness`", "remedy"});
  check_has(message_of("\xff\xfe"), {"bad.toml:1:", "remedy"});
  check_has(message_of(std::string("a = 1\n\0b = 2", 13)), {"bad.toml:2:", "remedy"});
}

BOOST_AUTO_TEST_CASE(values_that_do_not_go_together_are_refused) {
  check_has(
      message_of(with_line("height_under_water", "height_under_water = 9.08")),
      {"bad.toml:9:22: structure.height_under_water = 9.08", "allowed: less than structure.height = 9.08 m", "remedy"});
  check_has(message_of(with_line("waterline_width", "waterline_width = 6")),
            {"structure.waterline_width = 6", "the cone's keel would have the width", "allowed: more than 6.19"});
  check_has(message_of(with_line("width", "width = 13")), {"field.width = 13", "narrower than the structure"});
  check_has(
      message_of(with_line("start_distance", "start_distance = 6.8")),
      {"structure.start_distance = 6.8", "starts inside the ice", "more than its largest radius in the ice, 6.8"});
  check_has(message_of(with_more("step = \"30 s\"\n") + "[output]\n"), {"time.step = ", "is out of range"});
  check_has(message_of(with_line("duration", "duration = 0.001")),
            {"time.step = its default: the step is longer than the run"});
  check_has(message_of(with_more("[failure]\nwedges = [5, 3]\n")), {"failure.wedges = [5, 3]", "swap the two numbers"});
  check_has(message_of(with_more("[failure]\nmodel = \"network\"\norder = \"radial-first\"\n")),
            {"failure.order = \"radial-first\"", "network cannot split the sheet", "failure.model = \"plate\""});
  check_has(message_of(with_more("[failure]\nmodel = \"wedge\"\nsecond_order = true\n")),
            {"failure.second_order = true", "wedge is of first order"});
  check_has(message_of(with_more("[water]\ndensity = 900\n")), {"ice.density = its default", "does not float"});
  check_has(message_of(with_more("[failure]\nfile = \"no.json\"\n")),
            {"failure.file = \"no.json\"", "there is no file"});
  for (const std::string model : {"wedge", "plate", "plate-outline"})
    check_has(message_of(with_more("[failure]\nmodel = \"" + model + "\"\nfile = \"no.json\"\n")),
              {"failure.file = \"no.json\"", "the model " + model + " reads no file", "superposition",
               "remove failure.file"});
  check_has(message_of(with_line("thickness", "thickness = 0.009")),
            {"contact.margin", "less than half of ice.thickness"});
}

BOOST_AUTO_TEST_CASE(a_structure_too_thin_for_the_margin_of_its_contacts_is_refused) {
  const std::string structure = "waterline_width = 13.6\nheight = 9.08\nheight_under_water = 5.68\n";
  const auto with_shape = [&](const std::string& keys, const std::string& margin) {
    std::string text = kLeastCase;
    text.replace(text.find(structure), structure.size(), keys);
    return text + "[contact]\nmargin = " + margin + "\n";
  };
  const std::string plane = "kind = \"plane\"\nlength = 4\nheight = 2\nheight_under_water = 1\nwaterline_width = ";
  check_has(message_of(with_shape(plane + "0.15\n", "0.1")),
            {"bad.toml:20:10: contact.margin = 0.1: leaves no body of the structure, which is 0.15 m thick",
             "allowed: less than half of that, 0.075 m\n",
             "remedy:  lower contact.margin, or raise structure.waterline_width"});
  check_has(message_of(with_shape(plane + "0.2\n", "0.1")), {"contact.margin = 0.1: leaves no body"});
  BOOST_TEST(message_of(with_shape(plane + "0.201\n", "0.1")) == "");
  BOOST_TEST(message_of(with_shape(plane + "0.15\n", "0.0749")) == "");
  // The margin's default, 5 mm, has no place of its own.
  check_has(message_of(with_shape(plane + "0.009\n", "0.1")), {"less than half of that, 0.0045 m\n"});
  std::string thin = with_shape(plane + "0.009\n", "0.1");
  thin.erase(thin.find("[contact]"));
  check_has(message_of(thin), {"bad.toml:11:19: contact.margin = its default: leaves no body"});

  const std::string across =
      "kind = \"plane\"\nangle = \"89 deg\"\nlength = 0.15\nheight = 2\nheight_under_water = 1\nwaterline_width = 4\n";
  std::string slab = with_shape(across, "0.1");
  slab.erase(slab.find("angle = \"61"), 19);
  check_has(message_of(slab),
            {"contact.margin = 0.1: leaves no body of the structure, which is 0.1", "raise structure.length"});
}

BOOST_AUTO_TEST_CASE(a_part_of_a_mesh_too_thin_for_the_margin_of_its_contacts_is_refused) {
  const Scratch scratch;
  // A plate, 0.1 m thick.
  scratch.write(
      "plate.off",
      "OFF\n8 12 0\n0 0 0\n4 0 0\n4 0.1 0\n0 0.1 0\n0 0 2\n4 0 2\n4 0.1 2\n0 0.1 2\n3 0 2 1\n3 0 3 2\n3 4 5 6\n"
      "3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n");
  std::string text = kLeastCase;
  const std::size_t from = text.find("angle"), to = text.find("speed");
  text.replace(from, to - from, "kind = \"mesh\"\nfile = \"plate.off\"\ndraught = 1\n");
  text.insert(text.find("length = 50"), "initial_crack = false\n");
  const std::string file = scratch.write("bad.toml", text);
  BOOST_TEST(read_case(file, {"contact.margin=0.0499"}).contact.margin == 0.0499);
  try {
    read_case(file, {"contact.margin=0.05"});
    BOOST_TEST(false, "a plate of 0.1 m is read with a margin of 0.05 m");
  } catch (const InputError& error) {
    check_has(error.what(), {"contact.margin = 0.05: leaves no body of the thinnest of the mesh's 1 convex parts",
                             "thicken the mesh of structure.file"});
  }
}

BOOST_AUTO_TEST_CASE(an_override_is_named_as_the_place) {
  check_has(message_of(kLeastCase, {"ice.thickness=-1"}),
            {"bad.toml, --set ice.thickness=-1: ice.thickness = -1: is out of range", "allowed: ", "remedy:  "});
  check_has(message_of(kLeastCase, {"ice.thicknes=1"}), {"--set ice.thicknes=1", "nearest: ice.thickness"});
  check_has(message_of(kLeastCase, {"icy.thickness=1"}), {"--set icy.thickness=1: [icy]", "nearest: [ice]"});
  check_has(message_of(kLeastCase, {"ice.thickness=33 kg"}), {"ice.thickness = \"33 kg\"", "kg does not convert"});
  for (const char* text : {"", "=", "ice", "ice=1", "ice.=1", ".thickness=1", "ice.a.b=1", "ice.thickness"})
    check_has(message_of(kLeastCase, {text}),
              {"is not an override", "allowed: section.key=value", "remedy:  write it as --set"});
}

BOOST_AUTO_TEST_CASE(an_override_cannot_smuggle_in_other_keys) {
  check_has(message_of(kLeastCase, {"ice.thickness=1\ndensity=2"}), {"ice.thickness", "remedy"});
}

BOOST_AUTO_TEST_CASE(every_error_of_a_file_is_reported_in_the_order_of_the_file) {
  const std::string message =
      message_of("[ice]\nthickness = -1\nyoungs_modulus = \"1 m\"\nfoo = 1\n[structure]\nangle = 61.4\n");
  std::size_t last = 0;
  for (const char* part : {"bad.toml:2:13", "bad.toml:3:18", "bad.toml:4:1", "bad.toml:6:9"}) {
    const std::size_t at = message.find(part);
    BOOST_TEST(at != std::string::npos, part);
    BOOST_TEST(at >= last);
    last = at;
  }
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_read_is_named) {
  const Scratch scratch;
  BOOST_CHECK_EXCEPTION(read_case(scratch.path("none.toml")), InputError, [](const InputError& error) {
    check_has(error.what(), {"none.toml:1:1", "cannot be opened: No such file", "allowed", "remedy"});
    return true;
  });
  BOOST_CHECK_EXCEPTION(read_case(scratch.folder().string()), InputError, [](const InputError& error) {
    check_has(error.what(), {"is a folder", "allowed", "remedy"});
    return true;
  });
}

BOOST_AUTO_TEST_CASE(huge_and_deep_files_are_refused_before_they_cost_anything) {
  check_has(message_of(std::string(1 << 20, '#') + "#"), {"is larger than 1 MiB", "allowed", "remedy"});
  check_has(message_of("a = " + std::string(500000, '[')), {"bad.toml:1:21", "nested too deeply", "at most 16 levels"});
  std::string dots = "a";
  for (int i = 0; i < 300000; ++i) dots += ".a";
  check_has(message_of(dots + " = 1\n"), {"nested too deeply"});
  check_has(message_of("[" + dots + "]\n"), {"nested too deeply"});
  check_has(message_of(kLeastCase, {"ice.thickness=" + std::string(1000, '[')}), {"ice.thickness", "remedy"});
  // Dots and brackets in comments and strings are text.
  BOOST_TEST(message_of(with_more("# " + std::string(100, '[') + "\n")) == "");
}

BOOST_AUTO_TEST_CASE(many_errors_end_with_a_count) {
  std::string text;
  for (int i = 0; i < 20000; ++i) text += "thickness" + std::to_string(i) + " = 1\n";
  check_has(message_of("[ice]\n" + text), {"... and ", " more"});
}

BOOST_AUTO_TEST_SUITE_END()
