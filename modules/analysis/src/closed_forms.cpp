// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/closed_forms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "brash/analysis/case_forms.hpp"
#include "brash/core/constants.hpp"
#include "brash/standards/inputs.hpp"
#include "brash/structure/hull.hpp"
#include "brash/structure/motion.hpp"
#include "brash/structure/ship.hpp"

namespace brash::analysis {

using nlohmann::ordered_json;

namespace {
/// The structure as closed forms see it, or one of its legs, as it starts: one slope at the waterline, and the width
/// across its way.
struct Slope {
  double angle = 0.0;  ///< from the horizontal [rad]
  double width = 0.0;  ///< across its way [m]
};

Slope slope_of(const model::Case& c) {
  if (const auto* const cone = std::get_if<model::Cone>(&c.structure.shape))
    return {cone->angle, cone->waterline_width};
  const auto hull = structure::make_hull(c.structure.shape);
  const auto whole = structure::make_hull(c.structure);
  const auto motion = structure::make_motion(c, *whole);
  const Pose turned{{}, motion->now().pose.rotation};
  const Vec2 ahead = motion->course(), left = perpendicular(ahead);
  const auto at_waterline = [&](Vec2 course) { return structure::foremost(*hull, turned, 0.0, 0.0, course); };
  return {at_waterline(ahead).surface.slope, at_waterline(left).reach + at_waterline(-1.0 * left).reach};
}

bool is_vertical(double slope) { return slope >= structure::kSteepestSlope; }
const standards::NotApplicable kBendsNothing{"the face is vertical: it crushes the ice and bends none"};

/// The input of a closed form, or why it has none.
template <typename Input>
using InputOf = tl::expected<Input, standards::NotApplicable>;

InputOf<standards::CroasdaleInput> croasdale_input(const model::Case& c) {
  const Slope slope = slope_of(c);
  if (is_vertical(slope.angle)) return tl::unexpected(kBendsNothing);
  standards::CroasdaleInput input;
  input.slope = slope.angle;
  input.width = slope.width;
  input.thickness = c.ice.thickness;
  input.flexural_strength = c.ice.flexural_strength;
  input.youngs_modulus = c.ice.youngs_modulus;
  input.poisson_ratio = c.ice.poisson_ratio;
  input.friction_structure = c.ice.friction_structure;
  input.friction_ice = c.ice.friction_ice;
  input.ice_density = c.ice.density;
  input.water_density = c.water.density;
  return input;
}

InputOf<standards::RalstonInput> ralston_input(const model::Case& c, standards::Yield yield) {
  const auto* const cone = std::get_if<model::Cone>(&c.structure.shape);
  if (cone == nullptr) return tl::unexpected(standards::NotApplicable{"the structure is not a cone"});
  if (is_vertical(cone->angle)) return tl::unexpected(kBendsNothing);
  const bool downward = cone->breaking == model::Breaking::kDownward;
  const double slope_height = downward ? cone->height_under_water : cone->height - cone->height_under_water;
  standards::RalstonInput input;
  input.slope = cone->angle;
  input.waterline_width = cone->waterline_width;
  input.end_width = std::max(0.0, cone->waterline_width - 2.0 * slope_height / std::tan(cone->angle));
  input.thickness = c.ice.thickness;
  input.flexural_strength = c.ice.flexural_strength;
  input.friction_structure = c.ice.friction_structure;
  input.ice_density = c.ice.density;
  input.water_density = c.water.density;
  input.breaking = downward ? standards::Breaking::kDownward : standards::Breaking::kUpward;
  input.yield = yield;
  return input;
}

// The inputs of the ships' formulas ask for [hull]; it has all its first five keys, or none.

InputOf<standards::LindqvistInput> lindqvist_input(const model::Case& c) {
  standards::LindqvistInput input;
  input.length = *c.hull.length;
  input.breadth = *c.hull.breadth;
  input.draught = *c.hull.draught;
  input.stem_angle = *c.hull.stem_angle;
  input.waterline_angle = *c.hull.waterline_angle;
  input.speed = structure::mean_speed(c.structure, c.time.duration);
  input.thickness = c.ice.thickness;
  input.flexural_strength = c.ice.flexural_strength;
  input.youngs_modulus = c.ice.youngs_modulus;
  input.poisson_ratio = c.ice.poisson_ratio;
  input.friction = c.ice.friction_structure;
  input.ice_density = c.ice.density;
  input.water_density = c.water.density;
  return input;
}

InputOf<standards::RiskaInput> riska_input(const model::Case& c) {
  const structure::Particulars ship = structure::particulars_of(c.hull);
  if (ship.midbody < 0.0) return tl::unexpected(standards::NotApplicable{"the bow is longer than the waterline"});
  standards::RiskaInput input;
  input.length = ship.length;
  input.breadth = *c.hull.breadth;
  input.draught = *c.hull.draught;
  input.midbody = ship.midbody;
  input.bow_length = ship.bow;
  input.stem_angle = *c.hull.stem_angle;
  input.thickness = c.ice.thickness;
  input.speed = structure::mean_speed(c.structure, c.time.duration);
  return input;
}

InputOf<standards::JeongInput> jeong_input(const model::Case& c) {
  standards::JeongInput input;
  input.breadth = *c.hull.breadth;
  input.draught = *c.hull.draught;
  input.thickness = c.ice.thickness;
  input.speed = structure::mean_speed(c.structure, c.time.duration);
  input.flexural_strength = c.ice.flexural_strength;
  input.ice_density = c.ice.density;
  input.water_density = c.water.density;
  return input;
}

/// A wedge of a half disc in front of a contact, loaded over one thickness from its tip.
InputOf<standards::NevelInput> nevel_input(const model::Case& c, int wedges) {
  if (wedges < 2) return tl::unexpected(standards::NotApplicable{"the whole half disc is not a wedge: two at least"});
  standards::NevelInput input;
  input.wedge_angle = kPi / wedges;
  input.loaded_length = c.ice.thickness;
  input.thickness = c.ice.thickness;
  input.flexural_strength = c.ice.flexural_strength;
  input.youngs_modulus = c.ice.youngs_modulus;
  input.water_density = c.water.density;
  return input;
}

standards::CrushingInput crushing_input(const model::Case& c, double coefficient) {
  return {.width = slope_of(c).width, .thickness = c.ice.thickness, .strength_coefficient = coefficient};
}

}  // namespace

tl::expected<standards::CroasdaleLoad, standards::NotApplicable> croasdale_of(const model::Case& c) {
  return croasdale_input(c).and_then(standards::croasdale);
}

tl::expected<standards::RalstonLoad, standards::NotApplicable> ralston_of(const model::Case& c,
                                                                          standards::Yield yield) {
  return ralston_input(c, yield).and_then(standards::ralston);
}

tl::expected<standards::NevelLoad, standards::NotApplicable> nevel_of(const model::Case& c, int wedges) {
  return nevel_input(c, wedges).map(standards::nevel);
}

tl::expected<standards::CrushingLoad, standards::NotApplicable> crushing_of(const model::Case& c, double coefficient) {
  return standards::global_crushing(crushing_input(c, coefficient));
}

double full_crushing_of(const model::Case& c) {
  return c.ice.compressive_strength * slope_of(c).width * c.ice.thickness;
}

tl::expected<standards::RidgeInput, standards::NotApplicable> ridge_input_of(const model::Case& c) {
  const Slope slope = slope_of(c);
  if (!is_vertical(slope.angle))
    return tl::unexpected(standards::NotApplicable{"the face slopes; the formulas of a ridge are for a vertical one"});
  standards::RidgeInput input;
  input.width = slope.width;
  input.ice_density = c.ice.density;
  input.water_density = c.water.density;
  return input;
}

std::optional<tl::expected<standards::LindqvistLoad, standards::NotApplicable>> lindqvist_of(const model::Case& c) {
  if (!c.hull.length) return std::nullopt;
  return lindqvist_input(c).and_then(standards::lindqvist);
}

std::optional<tl::expected<standards::RiskaLoad, standards::NotApplicable>> riska_of(const model::Case& c) {
  if (!c.hull.length) return std::nullopt;
  return riska_input(c).map(standards::riska);
}

std::optional<tl::expected<standards::JeongLoad, standards::NotApplicable>> jeong_of(const model::Case& c) {
  if (!c.hull.length) return std::nullopt;
  return jeong_input(c).map(standards::jeong);
}

double breaking_length_of(const model::Case& c) {
  return standards::breaking_length({.thickness = c.ice.thickness,
                                     .youngs_modulus = c.ice.youngs_modulus,
                                     .poisson_ratio = c.ice.poisson_ratio,
                                     .water_density = c.water.density});
}

namespace {

constexpr const char* kPeak = "peak of one breaking event";
constexpr const char* kRarePeak = "peak, once in many years";
constexpr const char* kMean = "mean";

ordered_json refused(const char* method, const char* source, const standards::NotApplicable& why) {
  return {{"method", method}, {"source", source}, {"not_applicable", why.reason}};
}

/// The numbers that a formula was given, by their names in Python; SI.
template <typename Input, std::size_t n>
ordered_json inputs_json(const Input& input, const std::array<standards::InputNumber<Input>, n>& numbers) {
  ordered_json out;
  for (const standards::InputNumber<Input>& number : numbers)
    if (number.given == standards::Given::kAlways) out[number.name] = input.*number.member;
  return out;
}

// Where each method holds; docs/theory/standards.md.
constexpr const char* kCroasdaleApplies =
    "wide slopes, width well above the characteristic length, at low speed; the slope steeper than the friction angle "
    "and "
    "less steep than its complement, in-plane compression below the flexural strength";
constexpr const char* kRalstonApplies =
    "cones at low speed with one layer of ice on the whole slope; upper bound; friction that does not lock the ice";
constexpr const char* kNevelApplies = "narrow wedges, loaded over at most 0.6 characteristic lengths from the tip";
constexpr const char* kCrushingApplies = "a vertical face of the structure's width, which crushes the ice all over it";
constexpr const char* kLindqvistApplies =
    "icebreaking bows in continuous motion; friction that does not lock the ice under the bow";
constexpr const char* kRiskaApplies = "merchant ships in level ice of the Baltic";
constexpr const char* kJeongApplies = "icebreakers with a hull as in the tests: neither its angles nor friction";

ordered_json croasdale_json(const model::Case& c) {
  constexpr const char* kMethod = "elastic beam, no rubble, weight in air";
  constexpr const char* kSource = "ISO 19906, A.8.2.4.4 (Croasdale)";
  const auto input = croasdale_input(c);
  const auto load = input.and_then(standards::croasdale);
  if (!load) return refused(kMethod, kSource, load.error());
  return {{"method", kMethod},
          {"source", kSource},
          {"kind", kPeak},
          {"applies_to", kCroasdaleApplies},
          {"horizontal", load->horizontal},
          {"vertical", load->vertical},
          {"components",
           {{"H_B", load->breaking},
            {"H_P", load->pushing},
            {"H_R", load->ride_up},
            {"H_L", load->lifting},
            {"H_T", load->turning}}},
          {"force_ratio", load->force_ratio},
          {"in_plane_factor", load->in_plane_factor},
          {"characteristic_length", load->characteristic_length},
          {"crack_length", load->crack_length},
          {"inputs", inputs_json(*input, standards::kCroasdaleInputs)}};
}

ordered_json ralston_json(const model::Case& c, standards::Yield yield) {
  const auto* const cone = std::get_if<model::Cone>(&c.structure.shape);
  const std::string method = fmt::format(
      "plastic cone, {}{}", cone == nullptr ? "" : fmt::format("{} breaking, ", model::name_of(cone->breaking)),
      yield == standards::Yield::kTresca ? "Tresca (Y = 2.711)" : "Johansen (Y = 3.422)");
  constexpr const char* kSource = "ISO 19906, A.8.2.4.4 (Ralston)";
  const auto input = ralston_input(c, yield);
  const auto load = input.and_then(standards::ralston);
  if (!load) return refused(method.c_str(), kSource, load.error());
  return {{"method", method},
          {"source", kSource},
          {"kind", kPeak},
          {"applies_to", kRalstonApplies},
          {"horizontal", load->horizontal},
          {"vertical", load->vertical},
          {"components",
           {{"H_B", load->breaking_horizontal},
            {"H_R", load->ride_horizontal},
            {"V_B", load->breaking_vertical},
            {"V_R", load->ride_vertical}}},
          {"radius_ratio", load->radius_ratio},
          {"inputs", inputs_json(*input, standards::kRalstonInputs)}};
}

/// One break: the half disc in front of a contact, divided into wedges, each loaded over one thickness from its tip.
ordered_json nevel_json(const model::Case& c, int wedges) {
  const std::string method = fmt::format("one break of {} wedges, loaded over one thickness", wedges);
  constexpr const char* kSource = "Nevel 1972, narrow wedges";
  const auto input = nevel_input(c, wedges);
  if (!input) return refused(method.c_str(), kSource, input.error());
  const standards::NevelLoad load = standards::nevel(*input);
  // Friction on the slope inclines the force by atan(mu) from its normal.
  const double slope = slope_of(c).angle;
  const double inclination = slope + std::atan(c.ice.friction_structure);
  if (inclination >= 0.5 * kPi) return refused(method.c_str(), kSource, {"the ice locks: tan(slope) >= 1/friction"});
  const double vertical = wedges * load.vertical;
  ordered_json inputs = inputs_json(*input, standards::kNevelInputs);
  inputs["slope"] = slope;
  inputs["friction_structure"] = c.ice.friction_structure;
  return {{"method", method},
          {"source", kSource},
          {"kind", kPeak},
          {"applies_to", kNevelApplies},
          {"horizontal", vertical * std::tan(inclination)},
          {"vertical", vertical},
          {"components", {{"P of one wedge", load.vertical}}},
          {"in_range", load.in_range},
          {"inputs", inputs}};
}

ordered_json crushing_json(const model::Case& c, double coefficient, const char* region) {
  const std::string method = fmt::format("crushing on a vertical face, C_R = {:g} MPa ({})", coefficient / 1e6, region);
  constexpr const char* kSource = "ISO 19906:2010, A.8.2.4.3.3";
  const standards::CrushingInput input = crushing_input(c, coefficient);
  const auto load = standards::global_crushing(input);
  if (!load) return refused(method.c_str(), kSource, load.error());
  return {{"method", method},
          {"source", kSource},
          {"kind", kRarePeak},
          {"applies_to", kCrushingApplies},
          {"horizontal", load->horizontal},
          {"components", {{"p w h", load->horizontal}}},
          {"pressure", load->pressure},
          {"inputs", inputs_json(input, standards::kCrushingInputs)}};
}

ordered_json lindqvist_json(const model::Case& c) {
  constexpr const char* kMethod = "ship's hull at the structure's speed";
  constexpr const char* kSource = "Lindqvist 1989";
  const auto input = lindqvist_input(c);
  const auto load = input.and_then(standards::lindqvist);
  if (!load) return refused(kMethod, kSource, load.error());
  return {{"method", kMethod},
          {"source", kSource},
          {"kind", kMean},
          {"applies_to", kLindqvistApplies},
          {"horizontal", load->total},
          {"components", {{"R_c", load->crushing}, {"R_b", load->bending}, {"R_s", load->submersion}}},
          {"components_at", "zero speed"},
          {"inputs", inputs_json(*input, standards::kLindqvistInputs)}};
}

ordered_json riska_json(const model::Case& c) {
  constexpr const char* kMethod = "regression of Baltic ships, at the structure's speed";
  constexpr const char* kSource = "Riska et al. 1997";
  const auto input = riska_input(c);
  const auto load = input.map(standards::riska);
  if (!load) return refused(kMethod, kSource, load.error());
  return {{"method", kMethod},
          {"source", kSource},
          {"kind", kMean},
          {"applies_to", kRiskaApplies},
          {"horizontal", load->total},
          {"components", {{"at rest", load->at_rest}, {"by speed", load->total - load->at_rest}}},
          {"inputs", inputs_json(*input, standards::kRiskaInputs)}};
}

ordered_json jeong_json(const model::Case& c) {
  constexpr const char* kMethod = "regression of an icebreaker's basin tests, at the structure's speed";
  constexpr const char* kSource = "Jeong et al. 2010";
  const auto input = jeong_input(c);
  const auto load = input.map(standards::jeong);
  if (!load) return refused(kMethod, kSource, load.error());
  return {{"method", kMethod},
          {"source", kSource},
          {"kind", kMean},
          {"applies_to", kJeongApplies},
          {"horizontal", load->total},
          {"components", {{"buoyancy", load->buoyancy}, {"clearing", load->clearing}, {"breaking", load->breaking}}},
          {"inputs", inputs_json(*input, standards::kJeongInputs)}};
}

/// What the numbers of the structure's formulas are.
const char* kind_of(const model::Case& c) {
  if (std::holds_alternative<model::Ship>(c.structure.shape)) return "means, the resistance in level ice";
  return c.structure.legs.size() < 2
             ? "peaks of one breaking event; of crushing, once in many years; a ship's is a mean"
             : "peaks of one breaking event, of crushing once in many years; at one leg, as if alone";
}

}  // namespace

ordered_json closed_form_loads(const model::Case& c) {
  ordered_json loads = ordered_json::array();
  const auto add = [&](const char* formula, ordered_json load) {
    load["formula"] = formula;
    loads.push_back(std::move(load));
  };
  const bool is_ship = std::holds_alternative<model::Ship>(c.structure.shape);
  if (!is_ship && !is_vertical(slope_of(c).angle)) {
    add("Croasdale", croasdale_json(c));
    if (std::holds_alternative<model::Cone>(c.structure.shape)) {
      add("Ralston", ralston_json(c, standards::Yield::kTresca));
      add("Ralston", ralston_json(c, standards::Yield::kJohansen));
    }
    for (int wedges = c.failure.wedges[0]; wedges <= c.failure.wedges[1]; ++wedges) add("Nevel", nevel_json(c, wedges));
  }
  if (!is_ship) {
    add("crushing", crushing_json(c, 1.8e6, "Baltic"));
    add("crushing", crushing_json(c, 2.8e6, "Arctic"));
  }
  if (c.hull.length) {
    add("Lindqvist", lindqvist_json(c));
    add("Riska", riska_json(c));
    add("Jeong", jeong_json(c));
  }
  return {{"case", c.name}, {"kind", kind_of(c)}, {"loads", loads}};
}

double waterline_slope(const model::Case& resolved) { return slope_of(resolved).angle; }

}  // namespace brash::analysis
