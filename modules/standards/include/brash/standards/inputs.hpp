// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

#include "brash/standards/croasdale.hpp"
#include "brash/standards/crushing.hpp"
#include "brash/standards/jeong.hpp"
#include "brash/standards/lengths.hpp"
#include "brash/standards/lindqvist.hpp"
#include "brash/standards/nevel.hpp"
#include "brash/standards/ralston.hpp"
#include "brash/standards/ridge.hpp"
#include "brash/standards/riska.hpp"

namespace brash::standards {

/// Whether a user must give a number. Optional ones leave a part of a formula out, or are constants of nature.
enum class Given { kAlways, kOptionally, kWithRubble };

/// The values that an input may have; an end that is open is left out, and so is infinity.
struct Range {
  double least, most;
  bool open_least = true, open_most = true;

  constexpr bool contains(double v) const {
    return (open_least ? v > least : v >= least) && (open_most ? v < most : v <= most);
  }
};

inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();
inline constexpr Range kPositive{0.0, kNoLimit};
inline constexpr Range kNotNegative{0.0, kNoLimit, false};
inline constexpr Range kSharpAngle{0.0, 0.5 * kPi};
inline constexpr Range kPoisson{0.0, 0.5, false};

/// One number of the input of a closed form, with the name that it has for users.
template <typename Input>
struct InputNumber {
  const char* name;
  const char* unit;  ///< UDUNITS
  double Input::*member;
  Range range = kPositive;
  Given given = Given::kAlways;
};

/// The numbers of each closed form, in the order of a call.
inline constexpr std::array kCroasdaleInputs{
    InputNumber<CroasdaleInput>{"slope", "rad", &CroasdaleInput::slope, kSharpAngle},
    InputNumber<CroasdaleInput>{"width", "m", &CroasdaleInput::width},
    InputNumber<CroasdaleInput>{"thickness", "m", &CroasdaleInput::thickness},
    InputNumber<CroasdaleInput>{"flexural_strength", "Pa", &CroasdaleInput::flexural_strength},
    InputNumber<CroasdaleInput>{"youngs_modulus", "Pa", &CroasdaleInput::youngs_modulus},
    InputNumber<CroasdaleInput>{"poisson_ratio", "1", &CroasdaleInput::poisson_ratio, kPoisson},
    InputNumber<CroasdaleInput>{"friction_structure", "1", &CroasdaleInput::friction_structure, kNotNegative},
    InputNumber<CroasdaleInput>{"friction_ice", "1", &CroasdaleInput::friction_ice, kNotNegative},
    InputNumber<CroasdaleInput>{"ice_density", "kg m-3", &CroasdaleInput::ice_density},
    InputNumber<CroasdaleInput>{"water_density", "kg m-3", &CroasdaleInput::water_density},
    InputNumber<CroasdaleInput>{"weight_density", "kg m-3", &CroasdaleInput::weight_density, kNotNegative,
                                Given::kOptionally},
    InputNumber<CroasdaleInput>{"rubble_height", "m", &CroasdaleInput::rubble_height, kNotNegative, Given::kOptionally},
    InputNumber<CroasdaleInput>{"rubble_porosity", "1", &CroasdaleInput::rubble_porosity, Range{0.0, 1.0, false},
                                Given::kWithRubble},
    InputNumber<CroasdaleInput>{"rubble_cohesion", "Pa", &CroasdaleInput::rubble_cohesion, kNotNegative,
                                Given::kWithRubble},
    InputNumber<CroasdaleInput>{"rubble_angle", "rad", &CroasdaleInput::rubble_angle, kSharpAngle, Given::kWithRubble},
    InputNumber<CroasdaleInput>{"rubble_friction_angle", "rad", &CroasdaleInput::rubble_friction_angle,
                                Range{0.0, 0.5 * kPi, false}, Given::kWithRubble},
    InputNumber<CroasdaleInput>{"gravity", "m s-2", &CroasdaleInput::gravity, kPositive, Given::kOptionally}};

inline constexpr std::array kRalstonInputs{
    InputNumber<RalstonInput>{"slope", "rad", &RalstonInput::slope, kSharpAngle},
    InputNumber<RalstonInput>{"waterline_width", "m", &RalstonInput::waterline_width},
    InputNumber<RalstonInput>{"end_width", "m", &RalstonInput::end_width, kNotNegative},
    InputNumber<RalstonInput>{"thickness", "m", &RalstonInput::thickness},
    InputNumber<RalstonInput>{"flexural_strength", "Pa", &RalstonInput::flexural_strength},
    InputNumber<RalstonInput>{"friction_structure", "1", &RalstonInput::friction_structure, kNotNegative},
    InputNumber<RalstonInput>{"ice_density", "kg m-3", &RalstonInput::ice_density},
    InputNumber<RalstonInput>{"water_density", "kg m-3", &RalstonInput::water_density},
    InputNumber<RalstonInput>{"ride_thickness", "m", &RalstonInput::ride_thickness, kNotNegative, Given::kOptionally},
    InputNumber<RalstonInput>{"gravity", "m s-2", &RalstonInput::gravity, kPositive, Given::kOptionally}};

inline constexpr std::array kNevelInputs{
    InputNumber<NevelInput>{"wedge_angle", "rad", &NevelInput::wedge_angle, Range{0.0, kPi}},
    InputNumber<NevelInput>{"loaded_length", "m", &NevelInput::loaded_length, kNotNegative},
    InputNumber<NevelInput>{"thickness", "m", &NevelInput::thickness},
    InputNumber<NevelInput>{"flexural_strength", "Pa", &NevelInput::flexural_strength},
    InputNumber<NevelInput>{"youngs_modulus", "Pa", &NevelInput::youngs_modulus},
    InputNumber<NevelInput>{"water_density", "kg m-3", &NevelInput::water_density},
    InputNumber<NevelInput>{"gravity", "m s-2", &NevelInput::gravity, kPositive, Given::kOptionally}};

inline constexpr std::array kCrushingInputs{
    InputNumber<CrushingInput>{"width", "m", &CrushingInput::width},
    InputNumber<CrushingInput>{"thickness", "m", &CrushingInput::thickness},
    InputNumber<CrushingInput>{"strength_coefficient", "Pa", &CrushingInput::strength_coefficient}};

inline constexpr std::array kLindqvistInputs{
    InputNumber<LindqvistInput>{"length", "m", &LindqvistInput::length},
    InputNumber<LindqvistInput>{"breadth", "m", &LindqvistInput::breadth},
    InputNumber<LindqvistInput>{"draught", "m", &LindqvistInput::draught},
    InputNumber<LindqvistInput>{"stem_angle", "rad", &LindqvistInput::stem_angle, kSharpAngle},
    InputNumber<LindqvistInput>{"waterline_angle", "rad", &LindqvistInput::waterline_angle,
                                Range{0.0, 0.5 * kPi, true, false}},
    InputNumber<LindqvistInput>{"speed", "m s-1", &LindqvistInput::speed, kNotNegative},
    InputNumber<LindqvistInput>{"thickness", "m", &LindqvistInput::thickness},
    InputNumber<LindqvistInput>{"flexural_strength", "Pa", &LindqvistInput::flexural_strength},
    InputNumber<LindqvistInput>{"youngs_modulus", "Pa", &LindqvistInput::youngs_modulus},
    InputNumber<LindqvistInput>{"poisson_ratio", "1", &LindqvistInput::poisson_ratio, kPoisson},
    InputNumber<LindqvistInput>{"friction", "1", &LindqvistInput::friction, kNotNegative},
    InputNumber<LindqvistInput>{"ice_density", "kg m-3", &LindqvistInput::ice_density},
    InputNumber<LindqvistInput>{"water_density", "kg m-3", &LindqvistInput::water_density},
    InputNumber<LindqvistInput>{"gravity", "m s-2", &LindqvistInput::gravity, kPositive, Given::kOptionally}};

inline constexpr std::array kRiskaInputs{
    InputNumber<RiskaInput>{"length", "m", &RiskaInput::length},
    InputNumber<RiskaInput>{"breadth", "m", &RiskaInput::breadth},
    InputNumber<RiskaInput>{"draught", "m", &RiskaInput::draught},
    InputNumber<RiskaInput>{"midbody", "m", &RiskaInput::midbody, kNotNegative},
    InputNumber<RiskaInput>{"bow_length", "m", &RiskaInput::bow_length},
    InputNumber<RiskaInput>{"stem_angle", "rad", &RiskaInput::stem_angle, Range{0.0, 0.5 * kPi, true, false}},
    InputNumber<RiskaInput>{"thickness", "m", &RiskaInput::thickness},
    InputNumber<RiskaInput>{"speed", "m s-1", &RiskaInput::speed, kNotNegative}};

inline constexpr std::array kJeongInputs{
    InputNumber<JeongInput>{"breadth", "m", &JeongInput::breadth},
    InputNumber<JeongInput>{"draught", "m", &JeongInput::draught},
    InputNumber<JeongInput>{"thickness", "m", &JeongInput::thickness},
    InputNumber<JeongInput>{"speed", "m s-1", &JeongInput::speed, kNotNegative},
    InputNumber<JeongInput>{"flexural_strength", "Pa", &JeongInput::flexural_strength},
    InputNumber<JeongInput>{"ice_density", "kg m-3", &JeongInput::ice_density},
    InputNumber<JeongInput>{"water_density", "kg m-3", &JeongInput::water_density},
    InputNumber<JeongInput>{"buoyancy_factor", "1", &JeongInput::buoyancy_factor, kPositive, Given::kOptionally},
    InputNumber<JeongInput>{"gravity", "m s-2", &JeongInput::gravity, kPositive, Given::kOptionally}};

inline constexpr std::array kKeelInputs{
    InputNumber<KeelInput>{"width", "m", &KeelInput::width},
    InputNumber<KeelInput>{"keel_depth", "m", &KeelInput::keel_depth},
    InputNumber<KeelInput>{"keel_porosity", "1", &KeelInput::keel_porosity, Range{0.0, 1.0, false}},
    InputNumber<KeelInput>{"keel_cohesion", "Pa", &KeelInput::keel_cohesion, kNotNegative},
    InputNumber<KeelInput>{"keel_friction_angle", "rad", &KeelInput::keel_friction_angle, Range{0.0, 0.5 * kPi, false}},
    InputNumber<KeelInput>{"ice_density", "kg m-3", &KeelInput::ice_density},
    InputNumber<KeelInput>{"water_density", "kg m-3", &KeelInput::water_density},
    InputNumber<KeelInput>{"gravity", "m s-2", &KeelInput::gravity, kPositive, Given::kOptionally}};

inline constexpr std::array kRidgeInputs{
    InputNumber<RidgeInput>{"width", "m", &RidgeInput::width},
    InputNumber<RidgeInput>{"layer_thickness", "m", &RidgeInput::layer_thickness},
    InputNumber<RidgeInput>{"strength_coefficient", "Pa", &RidgeInput::strength_coefficient},
    InputNumber<RidgeInput>{"keel_depth", "m", &RidgeInput::keel_depth},
    InputNumber<RidgeInput>{"keel_porosity", "1", &RidgeInput::keel_porosity, Range{0.0, 1.0, false}},
    InputNumber<RidgeInput>{"keel_cohesion", "Pa", &RidgeInput::keel_cohesion, kNotNegative},
    InputNumber<RidgeInput>{"keel_friction_angle", "rad", &RidgeInput::keel_friction_angle,
                            Range{0.0, 0.5 * kPi, false}},
    InputNumber<RidgeInput>{"ice_density", "kg m-3", &RidgeInput::ice_density},
    InputNumber<RidgeInput>{"water_density", "kg m-3", &RidgeInput::water_density},
    InputNumber<RidgeInput>{"gravity", "m s-2", &RidgeInput::gravity, kPositive, Given::kOptionally}};

inline constexpr std::array kPlateInputs{
    InputNumber<PlateInput>{"thickness", "m", &PlateInput::thickness},
    InputNumber<PlateInput>{"youngs_modulus", "Pa", &PlateInput::youngs_modulus},
    InputNumber<PlateInput>{"poisson_ratio", "1", &PlateInput::poisson_ratio, kPoisson},
    InputNumber<PlateInput>{"water_density", "kg m-3", &PlateInput::water_density},
    InputNumber<PlateInput>{"gravity", "m s-2", &PlateInput::gravity, kPositive, Given::kOptionally}};

}  // namespace brash::standards
