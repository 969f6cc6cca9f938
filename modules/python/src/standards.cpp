// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "brash/analysis/closed_forms.hpp"
#include "brash/standards/inputs.hpp"
#include "case.hpp"
#include "convert.hpp"
#include "rooms.hpp"
#include "values.hpp"

namespace brash::python {
namespace {

using namespace standards;

/// Whether a call must give a number: rubble without a height has no properties.
template <typename Input>
bool is_required(const InputNumber<Input>& number, const py::kwargs& given) {
  if (number.given == Given::kWithRubble && given.contains("rubble_height"))
    return double(py::float_(given["rubble_height"])) != 0.0;
  return number.given == Given::kAlways;
}

/// Fills the input of a closed form from keyword arguments. A number that changes the load has no default.
template <typename Input, std::size_t n>
Input input_from(const char* form, const py::kwargs& given, const std::array<InputNumber<Input>, n>& numbers) {
  Input input;
  std::vector<std::string> names, missing;
  std::size_t n_used = 0;
  for (const InputNumber<Input>& number : numbers) {
    names.emplace_back(number.name);
    if (given.contains(number.name)) {
      const py::object value = given[number.name];
      input.*number.member = py::float_(value);
      if (!std::isfinite(input.*number.member))
        throw InputError(std::string(number.name) + ": a finite number is expected");
      ++n_used;
    } else if (is_required(number, given)) {
      missing.push_back(fmt::format("{} [{}]", number.name, number.unit == std::string("1") ? "-" : number.unit));
    }
  }
  if (!missing.empty())
    throw py::type_error(
        fmt::format("{}() misses {}: the load depends on it, so it has no default", form, fmt::join(missing, ", ")));
  if (n_used < given.size())
    throw py::type_error(
        fmt::format("{}() has an argument that is not known; there are: {}", form, fmt::join(names, ", ")));
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
        const CroasdaleInput input = input_from("croasdale", given, kCroasdaleInputs);
        return with_arguments_of("croasdale", [&] { return applicable(croasdale(input)); });
      },
      "Loads of level ice on a sloping structure by the elastic beam of ISO 19906, A.8.2.4.4. Keywords, SI and "
      "radians: slope, width, thickness, flexural_strength, youngs_modulus, poisson_ratio, friction_structure, "
      "friction_ice, ice_density, water_density; of rubble on the slope rubble_height, rubble_porosity, "
      "rubble_cohesion, rubble_angle, rubble_friction_angle. weight_density is that of ice_density if left out.");
  m.def(
      "ralston",
      [](const std::string& breaking, const std::string& yield_criterion, const py::kwargs& given) {
        RalstonInput input = input_from("ralston", given, kRalstonInputs);
        input.breaking = to_breaking(breaking);
        input.yield = to_yield(yield_criterion);
        return with_arguments_of("ralston", [&] { return applicable(ralston(input)); });
      },
      py::kw_only(), py::arg("breaking"), py::arg("yield_criterion") = "tresca",
      "Loads of level ice on a cone by plastic limit analysis. Keywords, SI and radians: slope, waterline_width, "
      "end_width, thickness, flexural_strength, friction_structure, ice_density, water_density; breaking upward or "
      "downward; yield_criterion tresca or johansen. ride_thickness is the thickness if left out.");
  m.def(
      "nevel",
      [](const py::kwargs& given) {
        const NevelInput input = input_from("nevel", given, kNevelInputs);
        return with_arguments_of("nevel", [&] { return nevel(input); });
      },
      "Vertical force that breaks a narrow wedge. Keywords, SI and radians: wedge_angle, loaded_length, thickness, "
      "flexural_strength, youngs_modulus, water_density.");
  m.def(
      "global_crushing",
      [](const py::kwargs& given) {
        const CrushingInput input = input_from("global_crushing", given, kCrushingInputs);
        return with_arguments_of("global_crushing", [&] { return applicable(global_crushing(input)); });
      },
      "Load of level ice that crushes over a vertical face, ISO 19906:2010, A.8.2.4.3.3. Keywords, SI: width, "
      "thickness, strength_coefficient (2.8e6 in the Arctic, 1.8e6 in the Baltic).");
  m.def(
      "lindqvist",
      [](const py::kwargs& given) {
        const LindqvistInput input = input_from("lindqvist", given, kLindqvistInputs);
        return with_arguments_of("lindqvist", [&] { return applicable(lindqvist(input)); });
      },
      "Mean resistance of a ship in level ice. Keywords, SI and radians: length, breadth, draught, stem_angle, "
      "waterline_angle, speed, thickness, flexural_strength, youngs_modulus, poisson_ratio, friction, ice_density, "
      "water_density.");
  m.def(
      "croasdale_of", [](const Case& c) { return applicable(analysis::croasdale_of(c.resolved)); }, py::arg("case"),
      "Croasdale's elastic beam for the structure and ice of a case, without rubble on the slope.");
  m.def(
      "ralston_of",
      [](const Case& c, const std::string& yield_criterion) {
        return applicable(analysis::ralston_of(c.resolved, to_yield(yield_criterion)));
      },
      py::arg("case"), py::arg("yield_criterion") = "tresca",
      "Ralston's plastic plate for the structure and ice of a case.");
  m.def(
      "lindqvist_of",
      [](const Case& c) {
        auto load = analysis::lindqvist_of(c.resolved);
        if (!load) throw python::NotApplicable("the case has no section [hull]");
        return applicable(std::move(*load));
      },
      py::arg("case"), "Lindqvist's resistance of a case with a section [hull], at the structure's speed, in its ice.");
}

}  // namespace brash::python
