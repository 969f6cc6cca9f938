// SPDX-License-Identifier: GPL-3.0-or-later
// Scales of a case, the structure's course through the field, and the part of the run that its statistics cover.
#include "brash/simulation/setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "brash/core/constants.hpp"
#include "brash/edge/edge_contact.hpp"
#include "brash/floes/floe_population.hpp"

namespace brash::simulation {

namespace {

/// Of the structure where it meets the ice straight ahead [rad].
double slope_ahead(const model::Case& c, const structure::Hull& hull, const structure::Motion& motion) {
  const edge::Freeboard heights = edge::freeboard(c);
  return structure::foremost(hull, motion.now().pose, heights.bottom, heights.top, motion.course()).surface.slope;
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

/// As initial_crack_radius() of a structure with this slope ahead.
double crack_radius(const model::Case& c, const failure::IceProperties& ice, const failure::BendingCriterion& criterion,
                    double slope) {
  const failure::LoadRatios ratios = ratios_ahead(slope, c.ice.friction_structure);
  return criterion.assess({.contact_length = ice.thickness, .mu1 = ratios.mu1, .mu2 = ratios.mu2}).breaking_length;
}

DerivedScales scales_of(const model::Case& c, const failure::IceProperties& ice,
                        const failure::BendingCriterion& criterion, double slope) {
  DerivedScales scales;
  scales.characteristic_length = failure::characteristic_length(ice);
  scales.thickness_over_lc = ice.thickness / scales.characteristic_length;
  scales.front_slope = slope;
  scales.mu1 = ratios_ahead(slope, c.ice.friction_structure).mu1;
  scales.freeboard = edge::freeboard(c).top;
  scales.draft = -edge::freeboard(c).bottom;
  const double given = c.field.initial_crack_radius;
  scales.initial_crack_radius = given > 0.0 ? given : crack_radius(c, ice, criterion, slope);
  if (ice::varies(c.ice)) scales.correlation_length = model::correlation_length(c.ice);
  const double piece = 0.25 * scales.characteristic_length * scales.characteristic_length;
  scales.collision_time = floes::collision_time(c, c.ice.density * ice.thickness * piece);
  return scales;
}

}  // namespace

double initial_crack_radius(const model::Case& resolved, const failure::IceProperties& ice,
                            const failure::BendingCriterion& criterion) {
  if (resolved.field.initial_crack_radius > 0.0) return resolved.field.initial_crack_radius;
  const auto hull = structure::make_hull(resolved.structure);
  return crack_radius(resolved, ice, criterion, slope_ahead(resolved, *hull, *structure::make_motion(resolved, *hull)));
}

namespace {

Course straight_course(const model::Case& c, const structure::Hull& hull) {
  const edge::Freeboard heights = edge::freeboard(c);
  const Pose start = structure::unresisted(c.structure, 0.0);
  const auto reach = [&](Vec2 course) {
    return structure::foremost(hull, start, heights.bottom, heights.top, course).reach;
  };
  const double speed = model::speed(c.structure.motion), bow = reach({1.0, 0.0});
  return {.speed = speed,
          .velocity = {speed, 0.0},
          .axis = structure::last_axis(c.structure, start),
          .bow = bow,
          .end = bow + speed * c.time.duration,
          .leaves = (c.field.length - bow) / speed,
          .beside = std::max(reach({0.0, 1.0}), reach({0.0, -1.0})),
          .meets = bow + speed * c.time.duration > 0.0 && -reach({-1.0, 0.0}) < c.field.length};
}

/// Sampled along the path.
Course course_on_path(const model::Case& c, const structure::Hull& hull) {
  constexpr int kSamples = 400;
  const edge::Freeboard heights = edge::freeboard(c);
  const Vec2 from = plan(structure::unresisted(c.structure, 0.0).position),
             to = plan(structure::unresisted(c.structure, c.time.duration).position);
  Course course;
  for (int i = 0; i <= kSamples; ++i) {
    const Pose pose = structure::unresisted(c.structure, c.time.duration * i / kSamples);
    const auto reach = [&](Vec2 way) {
      return structure::foremost(hull, pose, heights.bottom, heights.top, way).reach;
    };
    const double bow = reach({1.0, 0.0});
    if (i == 0)
      course = {.speed = structure::mean_speed(c.structure, c.time.duration),
                .velocity = (to - from) / c.time.duration,
                .axis = structure::last_axis(c.structure, pose),
                .bow = bow,
                .end = bow};
    if (course.end <= c.field.length && bow > c.field.length) course.leaves = c.time.duration * i / kSamples;
    course.end = std::max(course.end, bow);
    const double left = reach({0.0, 1.0}), right = -reach({0.0, -1.0}), half = 0.5 * c.field.width;
    course.beside = std::max({course.beside, left, -right});
    course.meets = course.meets || (bow > 0.0 && -reach({-1.0, 0.0}) < c.field.length && left > -half && right < half);
  }
  return course;
}

Course course_of(const model::Case& c, const structure::Hull& hull) {
  const auto* const towed = std::get_if<model::Towed>(&c.structure.motion);
  return towed != nullptr && !towed->path.empty() ? course_on_path(c, hull) : straight_course(c, hull);
}

}  // namespace

bool goes_as_told(const model::Motion& motion) {
  return std::holds_alternative<model::Towed>(motion) || std::holds_alternative<model::Compliant>(motion);
}

bool has_initial_crack(const model::Case& c) { return model::has_level_ice(c.field) && c.field.initial_crack; }

double place_of_begin(const model::Case& c, double radius) { return has_initial_crack(c) ? radius : 0.0; }

namespace {

/// When the structure's last axis passes `x` where nothing resists it; at the latest the end of the run [s].
double time_at(const model::Case& c, double x) {
  const auto axis_at = [&](double time) {
    return structure::last_axis(c.structure, structure::unresisted(c.structure, time));
  };
  const double speed = model::speed(c.structure.motion);
  if (speed > 0.0) return std::clamp((x - axis_at(0.0)) / speed, 0.0, c.time.duration);
  const auto n_steps = std::llround(c.time.duration / c.time.step);
  for (long long i = 0; i < n_steps; ++i)
    if (const double time = static_cast<double>(i) * c.time.step; axis_at(time) >= x) return time;
  return c.time.duration;
}

/// When a ship's stern passes `x` where nothing resists it, if it does before the end of the run [s].
std::optional<double> time_of_stern(const model::Case& c, const structure::Hull& hull, double x) {
  if (!std::holds_alternative<model::Ship>(c.structure.shape)) return std::nullopt;
  constexpr int kSamples = 400;
  const edge::Freeboard heights = edge::freeboard(c);
  const auto stern_at = [&](double time) {
    const Pose pose = structure::unresisted(c.structure, time);
    return -structure::foremost(hull, pose, heights.bottom, heights.top, {-1.0, 0.0}).reach;
  };
  if (const double speed = model::speed(c.structure.motion); speed > 0.0) {
    const double time = std::max(0.0, (x - stern_at(0.0)) / speed);
    return time < c.time.duration ? std::optional(time) : std::nullopt;
  }
  for (int i = 0; i < kSamples; ++i)
    if (const double time = c.time.duration * i / kSamples; stern_at(time) >= x) return time;
  return std::nullopt;
}

/// Time after so many steps [s].
double whole_steps(const model::Case& c, double n) { return n * c.time.step; }

/// Whether the structure comes out of ice that stays where it is.
bool leaves_ice(const model::Case& c, const Course& course) {
  return model::has_level_ice(c.field) && c.field.border == model::Border::kFixed && goes_as_told(c.structure.motion) &&
         course.meets && course.end > c.field.length && course.leaves < c.time.duration;
}

StatisticsWindow window_of(const model::Case& resolved, const structure::Hull& hull, double initial_crack_radius,
                           const Course& course) {
  const double x = place_of_begin(resolved, initial_crack_radius);
  StatisticsWindow window{.from = resolved.output.statistics_from.value_or(time_at(resolved, x)),
                          .until = whole_steps(resolved, std::round(resolved.time.duration / resolved.time.step)),
                          .begins = "the structure's axis passes the ice edge",
                          .ends = "the run is over"};
  const bool leaves = leaves_ice(resolved, course);
  std::optional<double> stern = resolved.output.statistics_from ? std::nullopt : time_of_stern(resolved, hull, x);
  if (stern && leaves && course.leaves <= *stern) stern.reset();  // the ice is shorter than the ship
  if (stern) window.from = *stern;
  if (stern) window.begins = "the ship's stern passes the ice edge: the whole hull is in the ice";
  if (x > 0.0)
    window.begins = fmt::format("the {} has passed the last floe of the initial crack",
                                stern ? "ship's stern" : "structure's axis");
  if (resolved.output.statistics_from) window.begins = "output.statistics_from says so";
  if (!leaves || course.leaves <= window.from) return window;
  window.until = whole_steps(resolved, std::floor(course.leaves / resolved.time.step));
  window.ends = "the structure's bow leaves the ice at the far side";
  return window;
}

}  // namespace

StatisticsWindow statistics_window(const model::Case& resolved, double initial_crack_radius) {
  const auto hull = structure::make_hull(resolved.structure);
  return window_of(resolved, *hull, initial_crack_radius, course_of(resolved, *hull));
}

Setup::Setup(model::Case of)
    : resolved(std::move(of)),
      ice(edge::ice_properties(resolved)),
      criterion(edge::make_criterion(resolved, ice)),
      hull(structure::make_hull(resolved.structure)),
      motion(structure::make_motion(resolved, *hull)),
      scales(scales_of(resolved, ice, *criterion, slope_ahead(resolved, *hull, *motion))),
      course(course_of(resolved, *hull)),
      window(window_of(resolved, *hull, scales.initial_crack_radius, course)) {}

}  // namespace brash::simulation
