// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include "../../cli/src/closed_forms.hpp"
#include "brash/standards/crushing.hpp"
#include "brash/standards/lindqvist.hpp"
#include "brash/standards/nevel.hpp"
#include "case.hpp"
#include "convert.hpp"
#include "rooms.hpp"
#include "values.hpp"

namespace brash::python {
namespace {

using namespace standards;

/// An argument of a closed form: its name, where it goes and whether it must be given.
template <typename Input>
struct Argument {
  const char* name;
  double Input::*member;
  bool required = false;
};

constexpr std::array kCroasdale{
    Argument<CroasdaleInput>{"slope", &CroasdaleInput::slope, true},
    Argument<CroasdaleInput>{"width", &CroasdaleInput::width, true},
    Argument<CroasdaleInput>{"thickness", &CroasdaleInput::thickness, true},
    Argument<CroasdaleInput>{"flexural_strength", &CroasdaleInput::flexural_strength, true},
    Argument<CroasdaleInput>{"youngs_modulus", &CroasdaleInput::youngs_modulus, true},
    Argument<CroasdaleInput>{"poisson_ratio", &CroasdaleInput::poisson_ratio},
    Argument<CroasdaleInput>{"friction_structure", &CroasdaleInput::friction_structure},
    Argument<CroasdaleInput>{"friction_ice", &CroasdaleInput::friction_ice},
    Argument<CroasdaleInput>{"ice_density", &CroasdaleInput::ice_density},
    Argument<CroasdaleInput>{"water_density", &CroasdaleInput::water_density},
    Argument<CroasdaleInput>{"weight_density", &CroasdaleInput::weight_density},
    Argument<CroasdaleInput>{"rubble_height", &CroasdaleInput::rubble_height},
    Argument<CroasdaleInput>{"rubble_porosity", &CroasdaleInput::rubble_porosity},
    Argument<CroasdaleInput>{"rubble_cohesion", &CroasdaleInput::rubble_cohesion},
    Argument<CroasdaleInput>{"rubble_angle", &CroasdaleInput::rubble_angle},
    Argument<CroasdaleInput>{"rubble_friction_angle", &CroasdaleInput::rubble_friction_angle},
    Argument<CroasdaleInput>{"gravity", &CroasdaleInput::gravity}};

constexpr std::array kRalston{Argument<RalstonInput>{"slope", &RalstonInput::slope, true},
                              Argument<RalstonInput>{"waterline_width", &RalstonInput::waterline_width, true},
                              Argument<RalstonInput>{"end_width", &RalstonInput::end_width, true},
                              Argument<RalstonInput>{"thickness", &RalstonInput::thickness, true},
                              Argument<RalstonInput>{"flexural_strength", &RalstonInput::flexural_strength, true},
                              Argument<RalstonInput>{"ride_thickness", &RalstonInput::ride_thickness},
                              Argument<RalstonInput>{"friction_structure", &RalstonInput::friction_structure},
                              Argument<RalstonInput>{"ice_density", &RalstonInput::ice_density},
                              Argument<RalstonInput>{"water_density", &RalstonInput::water_density},
                              Argument<RalstonInput>{"gravity", &RalstonInput::gravity}};

constexpr std::array kNevel{Argument<NevelInput>{"wedge_angle", &NevelInput::wedge_angle, true},
                            Argument<NevelInput>{"loaded_length", &NevelInput::loaded_length, true},
                            Argument<NevelInput>{"thickness", &NevelInput::thickness, true},
                            Argument<NevelInput>{"flexural_strength", &NevelInput::flexural_strength, true},
                            Argument<NevelInput>{"youngs_modulus", &NevelInput::youngs_modulus, true},
                            Argument<NevelInput>{"water_density", &NevelInput::water_density},
                            Argument<NevelInput>{"gravity", &NevelInput::gravity}};

constexpr std::array kCrushing{Argument<CrushingInput>{"width", &CrushingInput::width, true},
                               Argument<CrushingInput>{"thickness", &CrushingInput::thickness, true},
                               Argument<CrushingInput>{"strength_coefficient", &CrushingInput::strength_coefficient}};

constexpr std::array kLindqvist{Argument<LindqvistInput>{"length", &LindqvistInput::length, true},
                                Argument<LindqvistInput>{"breadth", &LindqvistInput::breadth, true},
                                Argument<LindqvistInput>{"draught", &LindqvistInput::draught, true},
                                Argument<LindqvistInput>{"stem_angle", &LindqvistInput::stem_angle, true},
                                Argument<LindqvistInput>{"waterline_angle", &LindqvistInput::waterline_angle, true},
                                Argument<LindqvistInput>{"thickness", &LindqvistInput::thickness, true},
                                Argument<LindqvistInput>{"flexural_strength", &LindqvistInput::flexural_strength, true},
                                Argument<LindqvistInput>{"youngs_modulus", &LindqvistInput::youngs_modulus, true},
                                Argument<LindqvistInput>{"speed", &LindqvistInput::speed},
                                Argument<LindqvistInput>{"poisson_ratio", &LindqvistInput::poisson_ratio},
                                Argument<LindqvistInput>{"friction", &LindqvistInput::friction},
                                Argument<LindqvistInput>{"ice_density", &LindqvistInput::ice_density},
                                Argument<LindqvistInput>{"water_density", &LindqvistInput::water_density},
                                Argument<LindqvistInput>{"gravity", &LindqvistInput::gravity}};

/// Fills the input of a closed form from keyword arguments.
template <typename Input, std::size_t n>
Input input_from(const py::kwargs& given, const std::array<Argument<Input>, n>& arguments) {
  Input input;
  std::string names;
  std::size_t n_used = 0;
  for (const Argument<Input>& a : arguments) {
    names += (names.empty() ? "" : ", ") + std::string(a.name);
    if (given.contains(a.name)) {
      const py::object value = given[a.name];
      input.*a.member = py::float_(value);
      if (!std::isfinite(input.*a.member)) throw InputError(std::string(a.name) + ": a finite number is expected");
      ++n_used;
    } else if (a.required) {
      throw py::type_error(std::string("missing argument: ") + a.name);
    }
  }
  if (n_used < given.size()) throw py::type_error("an argument is not known; there are: " + names);
  return input;
}

template <typename Load>
Load applicable(tl::expected<Load, standards::NotApplicable> load) {
  if (!load) throw python::NotApplicable(load.error().reason);
  return *std::move(load);
}

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

void add_loads(py::module_& m) {
  using std::pair;
  add_value<CroasdaleLoad>(
      m, "CroasdaleLoad", "Peak loads of one breaking event [N], horizontal unless stated; lengths in m.",
      pair("horizontal", &CroasdaleLoad::horizontal), pair("vertical", &CroasdaleLoad::vertical),
      pair("breaking", &CroasdaleLoad::breaking), pair("pushing", &CroasdaleLoad::pushing),
      pair("ride_up", &CroasdaleLoad::ride_up), pair("lifting", &CroasdaleLoad::lifting),
      pair("turning", &CroasdaleLoad::turning), pair("in_plane_factor", &CroasdaleLoad::in_plane_factor),
      pair("force_ratio", &CroasdaleLoad::force_ratio), pair("crack_length", &CroasdaleLoad::crack_length),
      pair("characteristic_length", &CroasdaleLoad::characteristic_length));
  add_value<RalstonLoad>(
      m, "RalstonLoad", "Peak loads [N].", pair("horizontal", &RalstonLoad::horizontal),
      pair("vertical", &RalstonLoad::vertical), pair("breaking_horizontal", &RalstonLoad::breaking_horizontal),
      pair("ride_horizontal", &RalstonLoad::ride_horizontal),
      pair("breaking_vertical", &RalstonLoad::breaking_vertical), pair("ride_vertical", &RalstonLoad::ride_vertical),
      pair("radius_ratio", &RalstonLoad::radius_ratio));
  add_value<NevelLoad>(m, "NevelLoad", "Force that breaks a narrow wedge [N].", pair("vertical", &NevelLoad::vertical),
                       pair("characteristic_length", &NevelLoad::characteristic_length),
                       pair("in_range", &NevelLoad::in_range));
  add_value<CrushingLoad>(m, "CrushingLoad",
                          "Load of ice that crushes over a vertical face [N], and its pressure [Pa].",
                          pair("horizontal", &CrushingLoad::horizontal), pair("pressure", &CrushingLoad::pressure));
  add_value<LindqvistLoad>(m, "LindqvistLoad", "Mean resistance [N] and its parts at zero speed.",
                           pair("total", &LindqvistLoad::total), pair("crushing", &LindqvistLoad::crushing),
                           pair("bending", &LindqvistLoad::bending), pair("submersion", &LindqvistLoad::submersion));
}

}  // namespace

void add_standards(py::module_& m) {
  add_loads(m);
  m.def(
      "croasdale",
      [](const py::kwargs& given) {
        const CroasdaleInput input = input_from(given, kCroasdale);
        return with_arguments_of("croasdale", [&] { return applicable(croasdale(input)); });
      },
      "Loads of level ice on a sloping structure by the elastic beam of ISO 19906, A.8.2.4.4. Keywords, SI and "
      "radians: slope, width, thickness, flexural_strength, youngs_modulus; see the stub for those with defaults.");
  m.def(
      "ralston",
      [](const std::string& breaking, const std::string& yield_criterion, const py::kwargs& given) {
        RalstonInput input = input_from(given, kRalston);
        input.breaking = to_breaking(breaking);
        input.yield = to_yield(yield_criterion);
        return with_arguments_of("ralston", [&] { return applicable(ralston(input)); });
      },
      py::kw_only(), py::arg("breaking") = "upward", py::arg("yield_criterion") = "tresca",
      "Loads of level ice on a cone by plastic limit analysis. Keywords, SI and radians: slope, waterline_width, "
      "end_width, thickness, flexural_strength; breaking upward or downward; yield_criterion tresca or johansen.");
  m.def(
      "nevel",
      [](const py::kwargs& given) {
        const NevelInput input = input_from(given, kNevel);
        return with_arguments_of("nevel", [&] { return nevel(input); });
      },
      "Vertical force that breaks a narrow wedge. Keywords, SI and radians: wedge_angle, loaded_length, thickness, "
      "flexural_strength, youngs_modulus.");
  m.def(
      "global_crushing",
      [](const py::kwargs& given) {
        const CrushingInput input = input_from(given, kCrushing);
        return with_arguments_of("global_crushing", [&] { return applicable(global_crushing(input)); });
      },
      "Load of level ice that crushes over a vertical face, ISO 19906:2010, A.8.2.4.3.3. Keywords, SI: width, "
      "thickness, strength_coefficient.");
  m.def(
      "lindqvist",
      [](const py::kwargs& given) {
        const LindqvistInput input = input_from(given, kLindqvist);
        return with_arguments_of("lindqvist", [&] { return applicable(lindqvist(input)); });
      },
      "Mean resistance of a ship in level ice. Keywords, SI and radians: length, breadth, draught, stem_angle, "
      "waterline_angle, thickness, flexural_strength, youngs_modulus, speed.");
  m.def(
      "croasdale_of", [](const Case& c) { return applicable(cli::croasdale_of(c.resolved)); }, py::arg("case"),
      "Croasdale's elastic beam for the structure and ice of a case, without rubble on the slope.");
  m.def(
      "ralston_of",
      [](const Case& c, const std::string& yield_criterion) {
        return applicable(cli::ralston_of(c.resolved, to_yield(yield_criterion)));
      },
      py::arg("case"), py::arg("yield_criterion") = "tresca",
      "Ralston's plastic plate for the structure and ice of a case.");
}

}  // namespace brash::python
