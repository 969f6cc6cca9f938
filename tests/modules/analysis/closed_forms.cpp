// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/closed_forms.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "brash/analysis/case_forms.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "history_file.hpp"

namespace {

using namespace brash;
using namespace brash::analysis;
using boost::test_tools::tolerance;

model::Case validation_cone() { return io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml"); }

}  // namespace

BOOST_AUTO_TEST_SUITE(closed_forms)

BOOST_AUTO_TEST_CASE(the_validation_cone_has_its_known_peaks) {
  const auto loads = closed_form_loads(validation_cone())["loads"];
  BOOST_TEST_REQUIRE(loads.size() == 8U);  // Croasdale, Ralston twice, 3 to 5 wedges, crushing twice
  BOOST_CHECK_SMALL(loads[0]["horizontal"].get<double>() - 319e3, 0.5e3);
  BOOST_CHECK_SMALL(loads[1]["horizontal"].get<double>() - 275e3, 0.5e3);
  BOOST_TEST(loads[3]["horizontal"].get<double>() / loads[3]["vertical"].get<double>() ==
                 loads[0]["horizontal"].get<double>() / loads[0]["vertical"].get<double>(),
             tolerance(1e-12));  // the same slope and friction
  const std::string text = loads_text(closed_form_loads(validation_cone()));
  BOOST_TEST(contains(text, "Croasdale"));
  BOOST_TEST(contains(text, "peaks of one breaking event; of crushing, once in many years"));
  for (const std::size_t i : {0U, 1U, 2U, 3U, 4U, 5U}) BOOST_TEST(loads[i]["kind"] == "peak of one breaking event");
  for (const std::size_t i : {6U, 7U}) BOOST_TEST(loads[i]["kind"] == "peak, once in many years");
}

BOOST_AUTO_TEST_CASE(small_loads_have_a_small_unit) {
  const auto name = [](std::vector<double> values) { return unit_for(values, "N").name; };
  BOOST_TEST(name({3.0, -1000.0}) == "kN");
  BOOST_TEST(name({3.0, -52.0, std::nan("")}) == "N");
  BOOST_TEST(name({0.02}) == "mN");
  BOOST_TEST(name({}) == "kN");
  nlohmann::ordered_json loads = closed_form_loads(validation_cone());
  for (auto& load : loads["loads"])
    for (const char* const direction : {"horizontal", "vertical"})
      if (load.contains(direction)) load[direction] = 1e-5 * load[direction].get<double>();
  BOOST_TEST(contains(loads_text(loads), "closed-form loads [N]"));
  BOOST_TEST(contains(loads_text(loads), "       3.2  "));
}

BOOST_AUTO_TEST_CASE(a_ship_has_the_resistance_formulas_alone) {
  const model::Case ship = io::read_case(BRASH_SOURCE_DIR "/experiments/ships/icebreaker.toml");
  const auto all = closed_form_loads(ship);
  const auto& loads = all["loads"];
  BOOST_TEST_REQUIRE(loads.size() == 3U);
  for (const std::size_t i : {0U, 1U, 2U}) BOOST_TEST(loads[i]["kind"] == "mean");
  BOOST_TEST(loads[0]["horizontal"].get<double>() == lindqvist_of(ship)->value().total);
  BOOST_TEST(loads[1]["horizontal"].get<double>() == riska_of(ship)->value().total);
  BOOST_TEST(loads[2]["horizontal"].get<double>() == jeong_of(ship)->value().total);
  // The table of the icebreaker's campaign: 0.8 m at 2 m/s, with its bow rounded to 34.6 m.
  BOOST_CHECK_SMALL(loads[0]["horizontal"].get<double>() - 647e3, 0.5e3);
  BOOST_CHECK_SMALL(loads[1]["horizontal"].get<double>() - 697e3, 1e3);
  BOOST_CHECK_SMALL(loads[2]["horizontal"].get<double>() - 752e3, 0.5e3);
  const std::string text = loads_text(all);
  BOOST_TEST(contains(text, "means, the resistance in level ice"));
  BOOST_TEST(contains(text, "  bow length                 34.64 m  Riska\n"), text);
  BOOST_TEST(!contains(text, "Croasdale"));
}

BOOST_AUTO_TEST_CASE(a_vertical_face_crushes_alone) {
  const auto loads = closed_form_loads(io::read_case(BRASH_SOURCE_DIR "/experiments/validation/demo.toml",
                                                     {"structure.angle=90 deg", "field.initial_crack=false"}))["loads"];
  BOOST_TEST_REQUIRE(loads.size() == 2U);
  for (const auto& load : loads) BOOST_TEST(load["formula"] == "crushing");
}

BOOST_AUTO_TEST_CASE(a_bow_longer_than_its_waterline_is_refused_by_riska_alone) {
  const model::Case ship = io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml",
                                         {"hull.length=20", "hull.breadth=18", "hull.draught=6.5",
                                          "hull.stem_angle=30 deg", "hull.waterline_angle=35 deg"});
  BOOST_TEST(!riska_of(ship)->has_value());
  BOOST_TEST(jeong_of(ship)->has_value());
}

BOOST_AUTO_TEST_CASE(a_hull_adds_the_ships_formulas_with_their_parts) {
  const std::string cone = BRASH_SOURCE_DIR "/experiments/validation/cone.toml";
  const model::Case ship = io::read_case(cone, {"hull.length=75.2", "hull.breadth=18", "hull.draught=6.5",
                                                "hull.stem_angle=30 deg", "hull.waterline_angle=35 deg"});
  const auto loads = closed_form_loads(ship)["loads"];
  const auto& load = loads[loads.size() - 3];
  BOOST_TEST(load["source"].get<std::string>() == "Lindqvist 1989");
  BOOST_TEST(loads[loads.size() - 2]["source"].get<std::string>() == "Riska et al. 1997");
  BOOST_TEST(loads.back()["source"].get<std::string>() == "Jeong et al. 2010");
  const auto& parts = load["components"];
  BOOST_TEST(load["horizontal"].get<double>() >
             parts["R_c"].get<double>() + parts["R_b"].get<double>() + parts["R_s"].get<double>());
  BOOST_TEST(contains(loads_text(closed_form_loads(ship)), "Lindqvist"));
  BOOST_CHECK_THROW(io::read_case(cone, {"hull.length=75.2"}), InputError);
}

BOOST_AUTO_TEST_CASE(each_formula_states_the_inputs_that_it_used) {
  const std::string cone = BRASH_SOURCE_DIR "/experiments/validation/cone.toml";
  const auto loads = closed_form_loads(
      io::read_case(cone, {"hull.length=75.2", "hull.breadth=18", "hull.draught=6.5", "hull.stem_angle=30 deg",
                           "hull.waterline_angle=35 deg", "ice.friction_ice=0.2", "ice.youngs_modulus=3 GPa"}));
  const auto inputs = [&](std::size_t i) { return loads["loads"][i]["inputs"]; };
  const auto &croasdale = inputs(0), &ralston = inputs(1), &nevel = inputs(3), &crushing = inputs(6),
             &lindqvist = inputs(8);
  for (const auto& of : {croasdale, ralston, nevel, crushing, lindqvist}) BOOST_TEST(of["thickness"] == 0.33);
  for (const auto& of : {croasdale, ralston, nevel, lindqvist}) BOOST_TEST(of["flexural_strength"] == 539e3);
  for (const auto& of : {croasdale, nevel, lindqvist}) BOOST_TEST(of["youngs_modulus"] == 3e9);
  for (const auto& of : {croasdale, ralston, lindqvist}) BOOST_TEST(of["ice_density"] == 900.0);
  for (const auto& of : {croasdale, ralston, nevel}) BOOST_TEST(of["friction_structure"] == 0.027);
  BOOST_TEST(croasdale["friction_ice"] == 0.2);
  BOOST_TEST(lindqvist["friction"] == 0.027);
  BOOST_TEST(crushing["strength_coefficient"] == 1.8e6);
  BOOST_TEST(!ralston.contains("youngs_modulus"));  // a plastic plate has none
  const std::string text = loads_text(loads);
  for (const char* const line :
       {"  thickness                   0.33 m  Croasdale, Ralston, Nevel, crushing, Lindqvist, Riska, Jeong\n",
        "  youngs modulus               3 GPa  Croasdale, Nevel, Lindqvist\n",
        "  strength coefficient       1.8 MPa  crushing\n", "  strength coefficient       2.8 MPa  crushing\n",
        "  slope                     61.4 deg  Croasdale, Ralston, Nevel\n",
        "  water density           1025 kg/m3  Croasdale, Ralston, Nevel, Lindqvist, Jeong\n"})
    BOOST_TEST(contains(text, line), text);
}

BOOST_AUTO_TEST_CASE(a_bow_that_goes_flank_first_meets_the_ice_with_its_vertical_side) {
  const auto loads = [](const std::string& heading) {
    return closed_form_loads(
        io::parse_case("[ice]\nthickness = 0.33\nyoungs_modulus = 0.35e9\nflexural_strength = 539e3\n"
                       "[structure]\nkind = \"wedge-bow\"\nlength = 30\nentrance = \"45 deg\"\nangle = \"60 deg\"\n"
                       "waterline_width = 10\nheight = 6\nheight_under_water = 4\n"
                       "[structure.motion]\npath = [[0, -40, 0, " +
                           heading + "], [40, 0, 0, " + heading +
                           "]]\n"
                           "[field]\nlength = 60\nwidth = 60\ninitial_crack = false\n[time]\nduration = 40\n",
                       "bow.toml", {}))["loads"];
  };
  BOOST_TEST(loads("0")[0]["formula"] == "Croasdale");
  BOOST_TEST(loads("0")[1]["formula"] == "Nevel");  // no cone, so not Ralston
  BOOST_TEST(loads("1.5707963267948966")[0]["formula"] == "crushing");
}

BOOST_AUTO_TEST_CASE(a_case_outside_a_method_says_so_instead_of_a_number) {
  model::Case c = validation_cone();
  c.ice.friction_structure = 0.6;
  const auto loads = closed_form_loads(c);
  for (const auto& load : loads["loads"]) {
    const bool of_a_slope = !contains(load["method"].get<std::string>(), "vertical face");
    BOOST_TEST(load.contains("not_applicable") == of_a_slope);
  }
  BOOST_TEST(contains(loads_text(loads), "not applicable: the ice locks"));
}

BOOST_AUTO_TEST_CASE(a_half_disc_in_one_piece_is_no_narrow_wedge) {
  model::Case c = validation_cone();
  c.failure.wedges = {1, 2};
  const auto loads = closed_form_loads(c)["loads"];
  BOOST_TEST_REQUIRE(loads.size() == 7U);
  BOOST_TEST(loads[3].contains("not_applicable"));
  BOOST_TEST(loads[4]["horizontal"].get<double>() > 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
