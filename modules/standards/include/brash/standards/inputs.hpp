// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "brash/standards/croasdale.hpp"
#include "brash/standards/crushing.hpp"
#include "brash/standards/lindqvist.hpp"
#include "brash/standards/nevel.hpp"
#include "brash/standards/ralston.hpp"

namespace brash::standards {

/// Whether a user must give a number. Optional ones leave a part of a formula out, or are constants of nature.
enum class Given { kAlways, kOptionally, kWithRubble };

/// One number of the input of a closed form, with the name that it has for users.
template <typename Input>
struct InputNumber {
  const char* name;
  const char* unit;  ///< UDUNITS
  double Input::*member;
  Given given = Given::kAlways;
};

/// The numbers of each closed form, in the order of a call.
inline constexpr std::array kCroasdaleInputs{
    InputNumber<CroasdaleInput>{"slope", "rad", &CroasdaleInput::slope},
    InputNumber<CroasdaleInput>{"width", "m", &CroasdaleInput::width},
    InputNumber<CroasdaleInput>{"thickness", "m", &CroasdaleInput::thickness},
    InputNumber<CroasdaleInput>{"flexural_strength", "Pa", &CroasdaleInput::flexural_strength},
    InputNumber<CroasdaleInput>{"youngs_modulus", "Pa", &CroasdaleInput::youngs_modulus},
    InputNumber<CroasdaleInput>{"poisson_ratio", "1", &CroasdaleInput::poisson_ratio},
    InputNumber<CroasdaleInput>{"friction_structure", "1", &CroasdaleInput::friction_structure},
    InputNumber<CroasdaleInput>{"friction_ice", "1", &CroasdaleInput::friction_ice},
    InputNumber<CroasdaleInput>{"ice_density", "kg m-3", &CroasdaleInput::ice_density},
    InputNumber<CroasdaleInput>{"water_density", "kg m-3", &CroasdaleInput::water_density},
    InputNumber<CroasdaleInput>{"weight_density", "kg m-3", &CroasdaleInput::weight_density, Given::kOptionally},
    InputNumber<CroasdaleInput>{"rubble_height", "m", &CroasdaleInput::rubble_height, Given::kOptionally},
    InputNumber<CroasdaleInput>{"rubble_porosity", "1", &CroasdaleInput::rubble_porosity, Given::kWithRubble},
    InputNumber<CroasdaleInput>{"rubble_cohesion", "Pa", &CroasdaleInput::rubble_cohesion, Given::kWithRubble},
    InputNumber<CroasdaleInput>{"rubble_angle", "rad", &CroasdaleInput::rubble_angle, Given::kWithRubble},
    InputNumber<CroasdaleInput>{"rubble_friction_angle", "rad", &CroasdaleInput::rubble_friction_angle,
                                Given::kWithRubble},
    InputNumber<CroasdaleInput>{"gravity", "m s-2", &CroasdaleInput::gravity, Given::kOptionally}};

inline constexpr std::array kRalstonInputs{
    InputNumber<RalstonInput>{"slope", "rad", &RalstonInput::slope},
    InputNumber<RalstonInput>{"waterline_width", "m", &RalstonInput::waterline_width},
    InputNumber<RalstonInput>{"end_width", "m", &RalstonInput::end_width},
    InputNumber<RalstonInput>{"thickness", "m", &RalstonInput::thickness},
    InputNumber<RalstonInput>{"flexural_strength", "Pa", &RalstonInput::flexural_strength},
    InputNumber<RalstonInput>{"friction_structure", "1", &RalstonInput::friction_structure},
    InputNumber<RalstonInput>{"ice_density", "kg m-3", &RalstonInput::ice_density},
    InputNumber<RalstonInput>{"water_density", "kg m-3", &RalstonInput::water_density},
    InputNumber<RalstonInput>{"ride_thickness", "m", &RalstonInput::ride_thickness, Given::kOptionally},
    InputNumber<RalstonInput>{"gravity", "m s-2", &RalstonInput::gravity, Given::kOptionally}};

inline constexpr std::array kNevelInputs{
    InputNumber<NevelInput>{"wedge_angle", "rad", &NevelInput::wedge_angle},
    InputNumber<NevelInput>{"loaded_length", "m", &NevelInput::loaded_length},
    InputNumber<NevelInput>{"thickness", "m", &NevelInput::thickness},
    InputNumber<NevelInput>{"flexural_strength", "Pa", &NevelInput::flexural_strength},
    InputNumber<NevelInput>{"youngs_modulus", "Pa", &NevelInput::youngs_modulus},
    InputNumber<NevelInput>{"water_density", "kg m-3", &NevelInput::water_density},
    InputNumber<NevelInput>{"gravity", "m s-2", &NevelInput::gravity, Given::kOptionally}};

inline constexpr std::array kCrushingInputs{
    InputNumber<CrushingInput>{"width", "m", &CrushingInput::width},
    InputNumber<CrushingInput>{"thickness", "m", &CrushingInput::thickness},
    InputNumber<CrushingInput>{"strength_coefficient", "Pa", &CrushingInput::strength_coefficient}};

inline constexpr std::array kLindqvistInputs{
    InputNumber<LindqvistInput>{"length", "m", &LindqvistInput::length},
    InputNumber<LindqvistInput>{"breadth", "m", &LindqvistInput::breadth},
    InputNumber<LindqvistInput>{"draught", "m", &LindqvistInput::draught},
    InputNumber<LindqvistInput>{"stem_angle", "rad", &LindqvistInput::stem_angle},
    InputNumber<LindqvistInput>{"waterline_angle", "rad", &LindqvistInput::waterline_angle},
    InputNumber<LindqvistInput>{"speed", "m s-1", &LindqvistInput::speed},
    InputNumber<LindqvistInput>{"thickness", "m", &LindqvistInput::thickness},
    InputNumber<LindqvistInput>{"flexural_strength", "Pa", &LindqvistInput::flexural_strength},
    InputNumber<LindqvistInput>{"youngs_modulus", "Pa", &LindqvistInput::youngs_modulus},
    InputNumber<LindqvistInput>{"poisson_ratio", "1", &LindqvistInput::poisson_ratio},
    InputNumber<LindqvistInput>{"friction", "1", &LindqvistInput::friction},
    InputNumber<LindqvistInput>{"ice_density", "kg m-3", &LindqvistInput::ice_density},
    InputNumber<LindqvistInput>{"water_density", "kg m-3", &LindqvistInput::water_density},
    InputNumber<LindqvistInput>{"gravity", "m s-2", &LindqvistInput::gravity, Given::kOptionally}};

}  // namespace brash::standards
