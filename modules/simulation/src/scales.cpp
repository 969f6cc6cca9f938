// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/simulation/scales.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "brash/core/constants.hpp"
#include "brash/simulation/cone_of.hpp"
#include "brash/simulation/run.hpp"
#include "edge_contact.hpp"
#include "initial_crack.hpp"

namespace brash::simulation {

double collision_time(const model::Case& resolved, double mass) {
  return 0.5 * kPi * std::sqrt((1.0 + resolved.hydrodynamics.added_mass) * mass / resolved.contact.stiffness);
}

double initial_crack_radius(const model::Case& resolved, const failure::IceProperties& ice,
                            const failure::BendingCriterion& criterion) {
  if (resolved.field.initial_crack_radius > 0.0) return resolved.field.initial_crack_radius;
  const failure::LoadRatios ratios =
      failure::load_ratios(resolved.structure.angle, resolved.ice.friction_structure, 0.0);
  return criterion.assess({.contact_length = ice.thickness, .mu1 = ratios.mu1, .mu2 = ratios.mu2}).breaking_length;
}

namespace {

/// What is to be asked about a run that is over before there is anything to tell.
std::vector<std::string> duration_warnings(const model::Case& c) {
  const double way = c.structure.speed * c.time.duration;
  const structure::Cone cone = cone_of(c);
  const Freeboard heights = freeboard(c);
  // The end of the ice's thickness at which the cone is wider meets it first.
  const double radius = std::max(structure::radius_at(cone, heights.top), structure::radius_at(cone, heights.bottom));
  const double gap = c.structure.start_distance - radius;
  if (way <= gap)
    return {
        fmt::format("the structure does not reach the ice: it is {:.3g} m away and moves {:.3g} m in time.duration = "
                    "{} s; raise that, or lower structure.start_distance",
                    gap, way, c.time.duration)};
  if (statistics_from(c) < c.time.duration) return {};
  return {
      fmt::format("the run is over before its statistics begin, when the structure's axis passes the ice edge at "
                  "{:.3g} s: raise time.duration = {} s, or set output.statistics_from",
                  c.structure.start_distance / c.structure.speed, c.time.duration)};
}

/// A network is scaled by Eq. 19 to ice of another h / l_c, which is right for its bending alone. Against the plate its
/// stress was 23 % off at three times the h / l_c it was trained with.
constexpr double kThicknessScaled = 0.2;

std::vector<std::string> thickness_warnings(const model::Case& c, double thickness_over_lc,
                                            const failure::BendingCriterion& criterion) {
  const std::optional<double> trained = criterion.trained_thickness_over_lc();
  if (!trained || std::abs(thickness_over_lc / *trained - 1.0) <= kThicknessScaled) return {};
  return {
      fmt::format("failure.model = {} was trained with h/l_c = {:.3g}, and this ice has {:.3g}: take superposition, "
                  "which knows h/l_c, or train a network for this ice",
                  model::name_of(c.failure.model), *trained, thickness_over_lc)};
}

/// A run is a whole number of steps long, the one nearest to its duration.
std::vector<std::string> step_warnings(const model::Case& c) {
  const double steps = c.time.duration / c.time.step;
  constexpr double kRounding = 1e-6;  // of a duration and a step as they are written
  if (std::abs(steps - std::round(steps)) <= kRounding * steps) return {};
  return {
      fmt::format("the run ends at {:.9g} s: time.duration = {} s is no whole number of steps of {} s, as {:.9g} and "
                  "{:.9g} s are",
                  std::round(steps) * c.time.step, c.time.duration, c.time.step, std::floor(steps) * c.time.step,
                  std::ceil(steps) * c.time.step)};
}

/// A floe between the structure and what holds it comes nearer to its crushing bound by about m v a sweep
/// (docs/theory/dynamics.md, "What this leaves out").
std::vector<std::string> sweep_warnings(const model::Case& c, double piece) {
  const double mass = (1.0 + c.hydrodynamics.added_mass) * c.ice.density * c.ice.thickness * piece;
  const double face = c.ice.thickness * std::sqrt(piece);
  const double bound = c.time.step * c.ice.compressive_strength * c.ice.crushing_factor * face;
  const double sweeps = std::ceil(bound / (mass * c.structure.speed));
  if (sweeps <= c.contact.iterations) return {};
  return {
      fmt::format("contact.iterations = {} are too few for a piece of {:.2g} m2 that is squeezed at structure.speed = "
                  "{} m/s to bear what crushes it: it needs about {:.0f}, or steps of {:.2g} s",
                  c.contact.iterations, piece, c.structure.speed, sweeps, c.time.step * c.contact.iterations / sweeps)};
}

}  // namespace

DerivedScales derived_scales(const model::Case& resolved) {
  const failure::IceProperties ice = ice_properties(resolved);
  const auto criterion = make_criterion(resolved, ice);
  DerivedScales scales;
  scales.warnings = duration_warnings(resolved);
  std::ranges::move(step_warnings(resolved), std::back_inserter(scales.warnings));
  scales.characteristic_length = failure::characteristic_length(ice);
  scales.thickness_over_lc = ice.thickness / scales.characteristic_length;
  std::ranges::move(thickness_warnings(resolved, scales.thickness_over_lc, *criterion),
                    std::back_inserter(scales.warnings));
  scales.mu1 = failure::load_ratios(resolved.structure.angle, resolved.ice.friction_structure, 0.0).mu1;
  scales.freeboard = freeboard(resolved).top;
  scales.draft = -freeboard(resolved).bottom;
  scales.initial_crack_radius = initial_crack_radius(resolved, ice, *criterion);
  const double piece = 0.25 * scales.characteristic_length * scales.characteristic_length;
  scales.collision_time = collision_time(resolved, resolved.ice.density * ice.thickness * piece);
  if (scales.collision_time < resolved.time.step)
    scales.warnings.push_back(fmt::format(
        "time.step = {} s is longer than the collision time {:.3g} s of a piece of {:.2g} m2 (Eq. 11): shorten it",
        resolved.time.step, scales.collision_time, piece));
  std::ranges::move(sweep_warnings(resolved, piece), std::back_inserter(scales.warnings));
  const failure::Assessment straight =
      criterion->assess({.contact_length = ice.thickness, .mu1 = scales.mu1, .mu2 = 0.0});
  if (straight.above_range)
    scales.warnings.push_back(
        fmt::format("mu1 = {:.3g} of structure.angle lies above the failure model's range: its inputs will be clamped",
                    scales.mu1));
  return scales;
}

}  // namespace brash::simulation
