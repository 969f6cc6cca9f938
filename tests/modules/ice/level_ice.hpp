// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/ice/field.hpp"

namespace brash::ice::testing {

inline const std::vector<geometry::Ring> kFarAway{geometry::disc({-100.0, 0.0}, 1.0, 8)};

inline failure::IceProperties properties() { return {.thickness = 0.33, .flexural_strength = 539e3}; }

inline Field level_ice(double length, double width) {
  model::FieldSection section;
  section.length = length;
  section.width = width;
  return {section, properties()};
}

/// A circle with wedges, planned on the first level ice.
inline CrackPlan circle(const Plate& plate, Vec2 at, double radius, int n_wedges) {
  return {geometry::circumferential(plate.sheet(), at, radius, n_wedges), at, radius, n_wedges};
}

inline geometry::ExactArea total(const std::vector<Plate>& plates) {
  geometry::ExactArea sum;
  for (const Plate& plate : plates) sum += plate.area();
  return sum;
}

}  // namespace brash::ice::testing
