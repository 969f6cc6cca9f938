// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <utility>

#include "brash/analysis/case_forms.hpp"
#include "brash/analysis/closed_forms.hpp"
#include "case.hpp"
#include "closed_form.hpp"
#include "rooms.hpp"

namespace brash::python {
namespace {

using namespace standards;
using std::pair;

Yield to_yield(const std::string& name) {
  if (name == "tresca") return Yield::kTresca;
  if (name == "johansen") return Yield::kJohansen;
  throw InputError("yield_criterion = '" + name + "': allowed are tresca, johansen");
}

Breaking to_breaking(const std::string& name) {
  if (name == "upward") return Breaking::kUpward;
  if (name == "downward") return Breaking::kDownward;
  throw InputError("breaking = '" + name + "': allowed are upward, downward");
}

/// What all closed forms share, after the text of one.
std::string doc(const std::string& text) {
  return text +
         "\n\nArguments are keywords, floats or arrays that broadcast. Fields of the result are floats, or arrays of "
         "the common shape with nan (and one warning) where the formula does not apply. A single such value raises "
         "NotApplicable, and a value out of range InputError. No physical input has a default but gravity.";
}

void add_croasdale(py::module_& m) {
  const auto record = add_record<CroasdaleLoad>(
      m, "CroasdaleLoad", "Peak loads of one breaking event [N], horizontal unless stated; lengths in m.",
      pair("horizontal", &CroasdaleLoad::horizontal), pair("vertical", &CroasdaleLoad::vertical),
      pair("breaking", &CroasdaleLoad::breaking), pair("pushing", &CroasdaleLoad::pushing),
      pair("ride_up", &CroasdaleLoad::ride_up), pair("lifting", &CroasdaleLoad::lifting),
      pair("turning", &CroasdaleLoad::turning), pair("in_plane_factor", &CroasdaleLoad::in_plane_factor),
      pair("force_ratio", &CroasdaleLoad::force_ratio), pair("crack_length", &CroasdaleLoad::crack_length),
      pair("characteristic_length", &CroasdaleLoad::characteristic_length));
  m.def(
      "croasdale",
      [record](const py::kwargs& given) { return call_form("croasdale", given, kCroasdaleInputs, record, croasdale); },
      doc("Loads of level ice on a sloping structure by the elastic beam of ISO 19906, A.8.2.4.4 (Croasdale, Cammaert, "
          "Metge 1994). SI and radians: slope, width, thickness, flexural_strength, youngs_modulus, poisson_ratio, "
          "friction_structure, friction_ice, ice_density, water_density; of rubble on the slope rubble_height, "
          "rubble_porosity, rubble_cohesion, rubble_angle, rubble_friction_angle. weight_density is "
          "ice_density if left out.")
          .c_str());
  m.def(
      "croasdale_of",
      [record](const Case& c) { return record.of_load(applicable(analysis::croasdale_of(c.resolved))); },
      py::arg("case"), "Croasdale's elastic beam for the structure and ice of a case, without rubble on the slope.");
}

void add_ralston(py::module_& m) {
  const auto record = add_record<RalstonLoad>(
      m, "RalstonLoad", "Peak loads [N].", pair("horizontal", &RalstonLoad::horizontal),
      pair("vertical", &RalstonLoad::vertical), pair("breaking_horizontal", &RalstonLoad::breaking_horizontal),
      pair("ride_horizontal", &RalstonLoad::ride_horizontal),
      pair("breaking_vertical", &RalstonLoad::breaking_vertical), pair("ride_vertical", &RalstonLoad::ride_vertical),
      pair("radius_ratio", &RalstonLoad::radius_ratio));
  m.def(
      "ralston",
      [record](const std::string& breaking, const std::string& yield_criterion, const py::kwargs& given) {
        const Breaking direction = to_breaking(breaking);
        const Yield yield = to_yield(yield_criterion);
        return call_form("ralston", given, kRalstonInputs, record, [=](RalstonInput input) {
          input.breaking = direction;
          input.yield = yield;
          return ralston(input);
        });
      },
      py::kw_only(), py::arg("breaking"), py::arg("yield_criterion") = "tresca",
      doc("Loads of level ice on a cone by plastic limit analysis (Ralston 1977; ISO 19906, A.8.2.4.4). SI and "
          "radians: slope, waterline_width, end_width, thickness, flexural_strength, friction_structure, ice_density, "
          "water_density; breaking upward or downward; yield_criterion tresca or johansen. ride_thickness is the "
          "thickness if left out.")
          .c_str());
  m.def(
      "ralston_of",
      [record](const Case& c, const std::string& yield_criterion) {
        return record.of_load(applicable(analysis::ralston_of(c.resolved, to_yield(yield_criterion))));
      },
      py::arg("case"), py::arg("yield_criterion") = "tresca",
      "Ralston's plastic plate for the structure and ice of a case.");
}

void add_nevel(py::module_& m) {
  const auto record = add_record<NevelLoad>(
      m, "NevelLoad", "Force that breaks a narrow wedge [N]; characteristic length of the beam [m].",
      pair("vertical", &NevelLoad::vertical), pair("characteristic_length", &NevelLoad::characteristic_length),
      pair("in_range", &NevelLoad::in_range));
  m.def(
      "nevel", [record](const py::kwargs& given) { return call_form("nevel", given, kNevelInputs, record, nevel); },
      doc("Vertical force that breaks a narrow wedge (Nevel 1972). SI and radians: wedge_angle, loaded_length, "
          "thickness, flexural_strength, youngs_modulus, water_density.")
          .c_str());
  m.def(
      "nevel_of",
      [record](const Case& c, int wedges) {
        return record.of_load(applicable(analysis::nevel_of(c.resolved, wedges)));
      },
      py::arg("case"), py::arg("wedges"),
      "Nevel's force on one of `wedges` wedges (at least 2) of a half disc of a case's ice, loaded over one "
      "thickness.");
}

void add_walls(py::module_& m) {
  const auto crushing = add_record<CrushingLoad>(
      m, "CrushingLoad", "Load of ice that crushes over a vertical face [N], and its pressure [Pa].",
      pair("horizontal", &CrushingLoad::horizontal), pair("pressure", &CrushingLoad::pressure));
  m.def(
      "global_crushing",
      [crushing](const py::kwargs& given) {
        return call_form("global_crushing", given, kCrushingInputs, crushing, global_crushing);
      },
      doc("Load of level ice that crushes over a vertical face, once in many years (ISO 19906:2010, A.8.2.4.3.3). SI: "
          "width, thickness, strength_coefficient (C_R: 2.8e6 in the Arctic, 1.8e6 in the Baltic).")
          .c_str());
  m.def(
      "global_crushing_of",
      [crushing](const Case& c, double strength_coefficient) {
        return crushing.of_load(applicable(with_arguments_of(
            "global_crushing_of", [&] { return analysis::crushing_of(c.resolved, strength_coefficient); })));
      },
      py::arg("case"), py::kw_only(), py::arg("strength_coefficient"),
      "Crushing of a case's ice over the width of its structure, as if the face were vertical.");

  const auto keel_load =
      add_record<KeelLoad>(m, "KeelLoad", "Load of a ridge's keel [N]: friction under its buoyancy, and cohesion.",
                           pair("horizontal", &KeelLoad::horizontal), pair("buoyancy", &KeelLoad::buoyancy),
                           pair("cohesion", &KeelLoad::cohesion));
  m.def(
      "keel", [keel_load](const py::kwargs& given) { return call_form("keel", given, kKeelInputs, keel_load, keel); },
      doc("Load of a first-year ridge's keel on a vertical face (Dolgopolov et al. 1975; ISO 19906, A.8.2.4.5). SI and "
          "radians: width, keel_depth (of the rubble below the consolidated layer), keel_porosity, keel_cohesion, "
          "keel_friction_angle, ice_density, water_density.")
          .c_str());

  const auto ridge_load =
      add_record<RidgeLoad>(m, "RidgeLoad", "Load of a ridge [N]: consolidated layer with its pressure [Pa], and keel.",
                            pair("horizontal", &RidgeLoad::horizontal), pair("layer", &RidgeLoad::layer),
                            pair("layer_pressure", &RidgeLoad::layer_pressure), pair("keel", &RidgeLoad::keel));
  m.def(
      "ridge",
      [ridge_load](const py::kwargs& given) { return call_form("ridge", given, kRidgeInputs, ridge_load, ridge); },
      doc("Load of a first-year ridge on a vertical face (ISO 19906, A.8.2.4.5): the consolidated layer crushes as "
          "level ice, see global_crushing, and the keel fails below it, see keel. SI and radians: width, "
          "layer_thickness, strength_coefficient, keel_depth, keel_porosity, keel_cohesion, keel_friction_angle, "
          "ice_density, water_density.")
          .c_str());
  m.def(
      "ridge_of",
      [ridge_load](const Case& c, const py::kwargs& given) {
        const RidgeInput known = applicable(analysis::ridge_input_of(c.resolved));
        py::kwargs all;
        for (const auto& argument : given) all[argument.first] = argument.second;
        for (const auto& [name, value] : {pair("width", known.width), pair("ice_density", known.ice_density),
                                          pair("water_density", known.water_density)}) {
          if (all.contains(name)) throw py::type_error(std::string("ridge_of(): ") + name + " is set by the case");
          all[name] = value;
        }
        return call_form("ridge_of", all, kRidgeInputs, ridge_load, ridge);
      },
      py::arg("case"),
      "ridge() on a case's structure, whose face must be vertical: width and densities are the case's.");
}

void add_ships(py::module_& m) {
  const auto of_lindqvist = add_record<LindqvistLoad>(
      m, "LindqvistLoad", "Mean resistance [N] and its parts at zero speed.", pair("total", &LindqvistLoad::total),
      pair("crushing", &LindqvistLoad::crushing), pair("bending", &LindqvistLoad::bending),
      pair("submersion", &LindqvistLoad::submersion));
  m.def(
      "lindqvist",
      [of_lindqvist](const py::kwargs& given) {
        return call_form("lindqvist", given, kLindqvistInputs, of_lindqvist, lindqvist);
      },
      doc("Mean resistance of a ship in level ice (Lindqvist 1989). SI and radians: length, breadth, draught, "
          "stem_angle, waterline_angle, speed, thickness, flexural_strength, youngs_modulus, poisson_ratio, friction, "
          "ice_density, water_density.")
          .c_str());
  m.def(
      "lindqvist_of",
      [of_lindqvist](const Case& c) { return of_lindqvist.of_load(of_ship(analysis::lindqvist_of(c.resolved))); },
      py::arg("case"), "Lindqvist's resistance of a case with a section [hull], at the structure's speed, in its ice.");

  const auto of_riska = add_record<RiskaLoad>(
      m, "RiskaLoad", "Mean resistance at speed and at rest [N], and its growth with speed [N s/m].",
      pair("total", &RiskaLoad::total), pair("at_rest", &RiskaLoad::at_rest), pair("per_speed", &RiskaLoad::per_speed));
  m.def(
      "riska", [of_riska](const py::kwargs& given) { return call_form("riska", given, kRiskaInputs, of_riska, riska); },
      doc("Mean resistance of a ship in level ice (Riska, Wilhelmson, Englund, Leiviska 1997), a regression for Baltic "
          "ice and ships. SI and radians: length, breadth, draught, midbody, bow_length, stem_angle, thickness, speed.")
          .c_str());
  m.def(
      "riska_of", [of_riska](const Case& c) { return of_riska.of_load(of_ship(analysis::riska_of(c.resolved))); },
      py::arg("case"), "Riska's resistance of a case with a section [hull], at the structure's speed, in its ice.");

  const auto of_jeong =
      add_record<JeongLoad>(m, "JeongLoad", "Mean resistance [N] and its parts at speed.",
                            pair("total", &JeongLoad::total), pair("buoyancy", &JeongLoad::buoyancy),
                            pair("clearing", &JeongLoad::clearing), pair("breaking", &JeongLoad::breaking));
  m.def(
      "jeong", [of_jeong](const py::kwargs& given) { return call_form("jeong", given, kJeongInputs, of_jeong, jeong); },
      doc("Mean resistance of a ship in level ice (Jeong, Lee, Cho 2010), a regression of basin tests with one "
          "icebreaker. SI: breadth, draught, thickness, speed, flexural_strength, ice_density, water_density. "
          "buoyancy_factor, the regression's coefficient C_B, is 0.499 if left out.")
          .c_str());
  m.def(
      "jeong_of", [of_jeong](const Case& c) { return of_jeong.of_load(of_ship(analysis::jeong_of(c.resolved))); },
      py::arg("case"), "Jeong's resistance of a case with a section [hull], at the structure's speed, in its ice.");
}

void add_lengths(py::module_& m) {
  struct Length {
    double value;
  };
  const Record<Length, double> length{py::none(), {&Length::value}};
  m.def(
      "characteristic_length",
      [length](const py::kwargs& given) {
        return call_form("characteristic_length", given, kPlateInputs, length,
                         [](const PlateInput& plate) { return Length{characteristic_length(plate)}; });
      },
      doc("Characteristic length of a floating plate, (E h^3/(12 (1 - nu^2) rho_w g))^(1/4) [m] (Hetenyi 1946). SI: "
          "thickness, youngs_modulus, poisson_ratio, water_density.")
          .c_str());
  m.def(
      "breaking_length",
      [length](const py::kwargs& given) {
        return call_form("breaking_length", given, kPlateInputs, length,
                         [](const PlateInput& plate) { return Length{breaking_length(plate)}; });
      },
      doc("Distance from a straight free edge to the largest bending moment of a floating plate that is loaded evenly "
          "along the edge, 1.111 characteristic lengths [m] (Hetenyi 1946): the breaking length of a wide, slow slope. "
          "SI: thickness, youngs_modulus, poisson_ratio, water_density.")
          .c_str());
  m.def(
      "breaking_length_of", [](const Case& c) { return analysis::breaking_length_of(c.resolved); }, py::arg("case"),
      "breaking_length() of a case's ice [m].");
}

}  // namespace

void add_standards(py::module_& m) {
  add_croasdale(m);
  add_ralston(m);
  add_nevel(m);
  add_walls(m);
  add_ships(m);
  add_lengths(m);
}

}  // namespace brash::python
