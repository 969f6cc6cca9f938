// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/simulation/scales.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "case_warnings.hpp"
#include "edge_contact.hpp"
#include "initial_crack.hpp"

namespace brash::simulation {

double collision_time(const model::Case& resolved, double mass) {
  return 0.5 * kPi * std::sqrt((1.0 + resolved.hydrodynamics.added_mass) * mass / resolved.contact.stiffness);
}

namespace {

/// Of the structure where it meets the ice straight ahead [rad].
double slope_ahead(const model::Case& c) {
  const auto hull = structure::make_hull(c.structure);
  const auto motion = structure::make_motion(c, *hull);
  const Freeboard heights = freeboard(c);
  return structure::foremost(*hull, motion->now().pose, heights.bottom, heights.top, motion->course()).surface.slope;
}

/// Of a contact straight ahead. A front that is vertical, or to which the ice sticks, does not bend the ice, and a
/// criterion asks for something that does.
failure::LoadRatios ratios_ahead(double slope, double friction) {
  constexpr double kHardly = 1e-6;
  if (slope >= structure::kSteepestSlope) return {.horizontal = 1.0, .mu1 = kHardly, .mu2 = 0.0};
  failure::LoadRatios ratios = failure::load_ratios(slope, friction, 0.0);
  ratios.mu1 = std::max(ratios.mu1, kHardly);
  return ratios;
}

}  // namespace

double initial_crack_radius(const model::Case& resolved, const failure::IceProperties& ice,
                            const failure::BendingCriterion& criterion) {
  if (resolved.field.initial_crack_radius > 0.0) return resolved.field.initial_crack_radius;
  const failure::LoadRatios ratios = ratios_ahead(slope_ahead(resolved), resolved.ice.friction_structure);
  return criterion.assess({.contact_length = ice.thickness, .mu1 = ratios.mu1, .mu2 = ratios.mu2}).breaking_length;
}

DerivedScales derived_scales(const model::Case& resolved, const failure::BendingCriterion& criterion) {
  const failure::IceProperties ice = ice_properties(resolved);
  DerivedScales scales;
  scales.characteristic_length = failure::characteristic_length(ice);
  scales.thickness_over_lc = ice.thickness / scales.characteristic_length;
  scales.front_slope = slope_ahead(resolved);
  scales.mu1 = ratios_ahead(scales.front_slope, resolved.ice.friction_structure).mu1;
  scales.freeboard = freeboard(resolved).top;
  scales.draft = -freeboard(resolved).bottom;
  scales.initial_crack_radius = initial_crack_radius(resolved, ice, criterion);
  if (ice::varies(resolved.ice)) scales.correlation_length = ice::correlation_length(resolved.ice);
  const double piece = 0.25 * scales.characteristic_length * scales.characteristic_length;
  scales.collision_time = collision_time(resolved, resolved.ice.density * ice.thickness * piece);
  scales.warnings = case_warnings(resolved, scales, criterion);
  return scales;
}

DerivedScales derived_scales(const model::Case& resolved) {
  return derived_scales(resolved, *make_criterion(resolved, ice_properties(resolved)));
}

}  // namespace brash::simulation
