// SPDX-License-Identifier: GPL-3.0-or-later
#include "closed_forms.hpp"

#include <algorithm>
#include <cmath>

namespace brash::cli {

tl::expected<standards::CroasdaleLoad, standards::NotApplicable> croasdale_of(const io::Case& c) {
  standards::CroasdaleInput input;
  input.slope = c.structure.angle;
  input.width = c.structure.waterline_width;
  input.thickness = c.ice.thickness;
  input.flexural_strength = c.ice.flexural_strength;
  input.youngs_modulus = c.ice.youngs_modulus;
  input.poisson_ratio = c.ice.poisson_ratio;
  input.friction_structure = c.ice.friction_structure;
  input.friction_ice = c.ice.friction_ice;
  input.ice_density = c.ice.density;
  input.water_density = c.water.density;
  return standards::croasdale(input);
}

tl::expected<standards::RalstonLoad, standards::NotApplicable> ralston_of(const io::Case& c, standards::Yield yield) {
  const bool downward = c.structure.breaking == "downward";
  const double slope_height =
      downward ? c.structure.height_under_water : c.structure.height - c.structure.height_under_water;
  standards::RalstonInput input;
  input.slope = c.structure.angle;
  input.waterline_width = c.structure.waterline_width;
  input.end_width = std::max(0.0, c.structure.waterline_width - 2.0 * slope_height / std::tan(c.structure.angle));
  input.thickness = c.ice.thickness;
  input.flexural_strength = c.ice.flexural_strength;
  input.friction_structure = c.ice.friction_structure;
  input.ice_density = c.ice.density;
  input.water_density = c.water.density;
  input.breaking = downward ? standards::Breaking::kDownward : standards::Breaking::kUpward;
  input.yield = yield;
  return standards::ralston(input);
}

std::optional<tl::expected<standards::LindqvistLoad, standards::NotApplicable>> lindqvist_of(const io::Case& c) {
  if (!c.hull.length) return std::nullopt;  // all keys or none
  standards::LindqvistInput input;
  input.length = *c.hull.length;
  input.breadth = *c.hull.breadth;
  input.draught = *c.hull.draught;
  input.stem_angle = *c.hull.stem_angle;
  input.waterline_angle = *c.hull.waterline_angle;
  input.speed = c.structure.speed;
  input.thickness = c.ice.thickness;
  input.flexural_strength = c.ice.flexural_strength;
  input.youngs_modulus = c.ice.youngs_modulus;
  input.poisson_ratio = c.ice.poisson_ratio;
  input.friction = c.ice.friction_structure;
  input.ice_density = c.ice.density;
  input.water_density = c.water.density;
  return standards::lindqvist(input);
}

}  // namespace brash::cli
