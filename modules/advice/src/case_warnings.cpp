// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>

#include "brash/advice/advice.hpp"
#include "brash/failure/response_model.hpp"
#include "brash/geometry/text.hpp"
#include "brash/ice/floe_file.hpp"
#include "brash/ice/variation.hpp"

namespace brash::advice {

using simulation::Course;
using simulation::DerivedScales;
using simulation::StatisticsWindow;

namespace {

/// Sides nearer than this many characteristic lengths change how the ice bends: the plate of the failure model has
/// none.
constexpr double kNearBorder = 2.0;
/// Typical breaking length over l_c: medians of 0.3 to 0.5 with the preset `brash`, of 0.5 with `paper`.
constexpr double kBreakingLength = 0.4;
/// A run with fewer breaks one after the other says little of their mean, however often its load goes up and down.
constexpr double kFewBreaks = 5.0;

void add_border_warnings(const model::Case& c, const Course& course, const DerivedScales& scales, Warnings& warnings) {
  const double margin = kNearBorder * scales.characteristic_length;
  const double beside = 0.5 * c.field.width - course.beside;
  if (beside < 0.0)
    warnings.push_back(
        {"leaves-field", fmt::format("the structure leaves the ice across a side, and comes {:.3g} m beyond it: raise "
                                     "field.width to {:.3g} m, or bend structure.motion.path",
                                     -beside, 2.0 * (course.beside + margin))});
  else if (beside < margin)
    warnings.push_back(
        {"near-side",
         fmt::format(
             "the structure leaves {:.3g} m of ice to each side of the sheet, and the plate of the "
             "failure model extends beyond it; expected at least 2 l_c = {:.3g} m: raise field.width to {:.3g} m",
             beside, margin, 2.0 * (course.beside + margin))});
  const double end = course.end;
  if (c.field.border == model::Border::kFree) {
    warnings.push_back(
        {"sheet-drifts",
         fmt::format("the borders of the sheet are free: the structure, at {:.3g} m/s, pushes it ahead, and nothing "
                     "holds it; loads fall as it comes up to that speed, and end where it has split or is broken up",
                     course.speed)});
    return;
  }
  if (end > c.field.length)
    warnings.push_back(
        {"leaves-field",
         fmt::format("the structure leaves the ice at {:.3g} s, and time.duration = {} s: the loads after it are of "
                     "open water; shorten the run, or raise field.length = {} m to {:.3g} m",
                     course.leaves, c.time.duration, c.field.length, end + margin)});
  else if (end > c.field.length - margin)
    warnings.push_back(
        {"near-end", fmt::format("the structure ends {:.3g} m before the far side of the sheet, and the plate of the "
                                 "failure model extends beyond it; expected at least 2 l_c = {:.3g} m: shorten the "
                                 "run, or raise field.length = {} m",
                                 c.field.length - end, margin, c.field.length)});
}

/// Whether current or wind may bring ice to the structure.
bool ice_drifts(const model::Case& c) {
  const bool may = c.field.kind == model::FieldKind::kFloes || c.field.border == model::Border::kFree;
  return may && (c.water.current != Vec2{} || c.wind.velocity != Vec2{});
}

void add_reach_warning(const model::Case& c, const Course& course, Warnings& warnings) {
  if (ice_drifts(c)) return;
  const double gap = -course.bow;
  const double way = course.end - course.bow;
  if (way <= gap)
    warnings.push_back(
        {"no-contact", fmt::format("the structure does not reach the ice: it is {:.3g} m away and moves {:.3g} m in "
                                   "time.duration = {} s; raise that, or lower structure.start_distance",
                                   gap, way, c.time.duration)});
  else if (!course.meets)
    warnings.push_back(
        {"no-contact", fmt::format("the structure does not reach the ice: its course lies beside or behind the field, "
                                   "which has x from 0 to {:.4g} m and y within +-{:.4g} m; check "
                                   "structure.start_distance and structure.motion.path",
                                   c.field.length, 0.5 * c.field.width)});
}

/// Walls are solid to ice alone.
void add_wall_warning(const model::Case& c, const Course& course, Warnings& warnings) {
  if (c.field.floes.border != model::FloeBorder::kWalls || !course.meets) return;
  if (course.beside > 0.5 * c.field.width)
    warnings.push_back({"leaves-field", fmt::format("the structure passes through the wall at a side, and comes {:.3g} "
                                                    "m beyond it: raise field.width to {:.3g} m or more, or bend "
                                                    "structure.motion.path",
                                                    course.beside - 0.5 * c.field.width, 2.0 * course.beside)});
  if (course.end > c.field.length)
    warnings.push_back(
        {"leaves-field",
         fmt::format("the structure passes through the wall at the far end at {:.3g} s, and time.duration = {} s: "
                     "shorten the run, or raise field.length = {} m to {:.3g} m or more",
                     course.leaves, c.time.duration, c.field.length, course.end)});
}

}  // namespace

void add_field_warnings(const Setup& setup, Warnings& warnings) {
  const model::Case& c = setup.resolved;
  const Course& course = setup.course;
  if (model::has_level_ice(c.field)) {
    add_reach_warning(c, course, warnings);
    if (course.meets || course.end <= 0.0) add_border_warnings(c, course, setup.scales, warnings);
  } else if (simulation::goes_as_told(c.structure.motion)) {
    add_reach_warning(c, course, warnings);
    add_wall_warning(c, course, warnings);
  }
}

namespace {

/// Whether the structure goes through ice that is held from x = 0 on, at its own speed.
bool comes_at_its_speed(const model::Case& c) {
  const model::Motion& motion = c.structure.motion;
  return !std::holds_alternative<model::Free>(motion) && model::speed(motion) > 0.0 && model::has_level_ice(c.field) &&
         !model::has_ice_files(c.field) && c.field.border == model::Border::kFixed;
}

/// A structure that is slower rests [m/s].
constexpr double kAtRest = 1e-3;

/// The speed at which ice passes the structure [m/s]. Ice that may drift has the current's velocity, or is about to.
double passing_speed(const model::Case& c, const Course& course) {
  const bool may_drift = c.field.kind == model::FieldKind::kFloes || c.field.border == model::Border::kFree;
  return may_drift ? std::max(course.speed, norm(course.velocity - c.water.current)) : course.speed;
}

/// The remedy of a run with too little travel after its statistics begin.
std::string longer_run(const model::Case& c, double from, double speed, double l_c) {
  return fmt::format("raise time.duration from {} s to {:.0f} s or more", c.time.duration,
                     std::ceil(from + kFewBreaks * kBreakingLength * l_c / speed));
}

/// When the statistics would begin, in words.
std::string when_they_begin(const model::Case& c, const Course& course, const StatisticsWindow& window,
                            const DerivedScales& scales) {
  if (model::speed(c.structure.motion) < kAtRest)
    return window.begins + ", and it does not pass it in this run: set output.statistics_from";
  const double from = (simulation::place_of_begin(c, scales.initial_crack_radius) - course.axis) / course.speed;
  return fmt::format("{} at {:.3g} s: {}, or set output.statistics_from", window.begins, from,
                     longer_run(c, from, course.speed, scales.characteristic_length));
}

/// Statistics that begin by output.statistics_from before the load comes from ice which the structure breaks.
void add_early_warning(const model::Case& c, const Course& course, double radius, Warnings& warnings) {
  if (!comes_at_its_speed(c) || !c.output.statistics_from) return;
  const bool of_paper = c.algorithm.preset == model::Preset::kPaper;
  if (of_paper && *c.output.statistics_from == 0.0) return;  // the preset's own choice
  const double from = *c.output.statistics_from, contact = -course.bow / course.speed;
  const double past_crack = (radius - course.axis) / course.speed;
  if (from < contact)
    warnings.push_back(
        {"early-statistics", fmt::format("the statistics begin at {:.3g} s, before the structure touches the ice at "
                                         "{:.3g} s: zeros and the entry lower the mean; raise output.statistics_from, "
                                         "or leave it out",
                                         from, contact)});
  else if (simulation::has_initial_crack(c) && from < past_crack && !of_paper)
    warnings.push_back(
        {"early-statistics",
         fmt::format("the statistics begin at {:.3g} s, and the structure has passed the floes of the initial crack at "
                     "{:.3g} s: the program cut these floes, and their loads may be the largest; raise "
                     "output.statistics_from, or leave it out",
                     from, past_crack)});
}

void add_statistics_warnings(const Setup& setup, Warnings& warnings) {
  const model::Case& c = setup.resolved;
  const DerivedScales& scales = setup.scales;
  const Course& course = setup.course;
  const StatisticsWindow& window = setup.window;
  const double from = window.from, speed = passing_speed(c, course), travel = speed * (window.until - from);
  add_early_warning(c, course, scales.initial_crack_radius, warnings);
  if (from >= c.time.duration)
    warnings.push_back({"no-statistics", "the run is over before its statistics begin, when " +
                                             when_they_begin(c, course, window, scales)});
  else if (speed >= kAtRest && travel < kFewBreaks * kBreakingLength * scales.characteristic_length)
    warnings.push_back(
        {"short-run",
         fmt::format("the statistics cover {:.3g} m of travel from {:.3g} s on, and a break reaches about {:.1g} l_c = "
                     "{:.3g} m: expected {:.0f} breaking lengths; {}",
                     travel, from, kBreakingLength, kBreakingLength * scales.characteristic_length, kFewBreaks,
                     longer_run(c, from, speed, scales.characteristic_length))});
}

/// A run is a whole number of steps long, the one nearest to its duration.
void add_broken_step_warning(const model::TimeSection& time, Warnings& warnings) {
  const double steps = time.duration / time.step;
  constexpr double kRounding = 1e-6;  // of a duration and a step as they are written
  if (std::abs(steps - std::round(steps)) <= kRounding * steps) return;
  warnings.push_back(
      {"broken-step", fmt::format("the run ends at {:.9g} s: time.duration = {} s is not a whole number of steps of {} "
                                  "s, as {:.9g} and {:.9g} s are",
                                  std::round(steps) * time.step, time.duration, time.step,
                                  std::floor(steps) * time.step, std::ceil(steps) * time.step)});
}

/// Settings that do not suit a typical piece of `area` [m2], which is squeezed at `speed` [m/s].
void add_piece_warnings(const model::Case& c, double speed, double area, double collision_time, Warnings& warnings) {
  if (c.failure.smallest_floe > area)
    warnings.push_back({"all-brash", fmt::format("failure.smallest_floe = {} m2, and a typical piece has {:.2g} m2: "
                                                 "most pieces become brash and carry no load; lower it",
                                                 c.failure.smallest_floe, area)});
  if (collision_time < c.time.step)
    warnings.push_back({"long-step", fmt::format("time.step = {} s is longer than the collision time {:.3g} s of a "
                                                 "piece of {:.2g} m2 (Eq. 11): shorten it",
                                                 c.time.step, collision_time, area)});
  if (speed < kAtRest) return;
  // When the structure squeezes a floe against a support, each sweep adds about m v to the impulse
  // (docs/theory/contacts-and-bodies.md, "Squeezed floes"). The floe needs this many sweeps to reach its crushing
  // bound.
  const double mass = (1.0 + c.hydrodynamics.added_mass) * c.ice.density * c.ice.thickness * area;
  const double bound =
      c.time.step * c.ice.compressive_strength * c.ice.crushing_factor * c.ice.thickness * std::sqrt(area);
  const double sweeps = std::ceil(bound / (mass * speed));
  if (sweeps > c.contact.iterations)
    warnings.push_back(
        {"few-iterations",
         fmt::format("contact.iterations = {} are too few for a piece of {:.2g} m2 that is squeezed at {:.3g} m/s "
                     "to carry the load that crushes it: it needs about {:.0f}, or steps of {:.2g} s",
                     c.contact.iterations, area, speed, sweeps, c.time.step * c.contact.iterations / sweeps)});
}

}  // namespace

void add_time_warnings(const Setup& setup, Warnings& warnings) {
  const model::Case& c = setup.resolved;
  const Course& course = setup.course;
  add_statistics_warnings(setup, warnings);
  add_broken_step_warning(c.time, warnings);
  if (comes_at_its_speed(c) && c.time.settle_speed >= course.speed)
    warnings.push_back({"fast-sleepers", fmt::format("time.settle_speed = {} m/s is not below the structure's speed of "
                                                     "{:.3g} m/s: floes fall asleep while they drift with it; lower it",
                                                     c.time.settle_speed, course.speed)});
  const double l_c = setup.scales.characteristic_length;
  add_piece_warnings(c, passing_speed(c, course), 0.25 * l_c * l_c, setup.scales.collision_time, warnings);
}

namespace {

constexpr double kRangeRounds = 1e-3;  ///< share by which h/l_c may miss a model's range: written inputs are rounded
/// Ice breaks about so far ahead of a contact, in characteristic lengths.
constexpr double kEvenOver = 0.5;

/// The models of plates that were solved beforehand know this Poisson's ratio alone. At 0.2 a static edge gives way by
/// 5 % less, and a load bends the ice ahead of it by 2 % more.
constexpr double kSolvedPoissonRatio = 0.3;
constexpr double kNearPoissonRatio = 0.05;

/// A file of the user's own may be for another ratio, which it does not state.
void add_poisson_warning(const model::Case& c, Warnings& warnings) {
  if (std::abs(c.ice.poisson_ratio - kSolvedPoissonRatio) <= kNearPoissonRatio) return;
  const model::FailureSection& failure = c.failure;
  const bool is_interpolated = failure.model == model::FailureModel::kSuperposition ||
                               failure.model == model::FailureModel::kNetwork ||
                               failure.model == model::FailureModel::kDeepNetwork;
  std::string key, remedy;
  if (is_interpolated && failure.file.empty()) {
    key = fmt::format("failure.model = {}", model::name_of(failure.model));
    remedy = "model = \"plate-outline\" with edge = \"static\"";
  } else if (failure.edge == model::EdgeMotion::kDynamic) {
    key = fmt::format("failure.edge = {}", model::name_of(failure.edge));
    remedy = "edge = \"static\"";
  } else {
    return;
  }
  warnings.push_back(
      {"poisson-ratio", fmt::format("ice.poisson_ratio = {:.3g}, and {} was solved with {}: deflections "
                                    "and moments are some per cent off; take {}, or {}",
                                    c.ice.poisson_ratio, key, kSolvedPoissonRatio, kSolvedPoissonRatio, remedy)});
}

}  // namespace

void add_variation_warnings(const Setup& setup, Warnings& warnings) {
  const model::IceSection& ice = setup.resolved.ice;
  if (!ice::varies(ice)) return;
  const double length = model::correlation_length(ice), least = kEvenOver * setup.scales.characteristic_length;
  if (length < least)
    warnings.push_back(
        {"short-correlation",
         fmt::format(
             "the ice varies over ice.variation.correlation_length = {:.3g} m, and the plate of the failure model "
             "is even over its breaking length: expected at least l_c / 2 = {:.3g} m",
             length, least)});
}

void add_model_warnings(const Setup& setup, Warnings& warnings) {
  const model::Case& c = setup.resolved;
  const DerivedScales& scales = setup.scales;
  const failure::BendingCriterion& criterion = *setup.criterion;
  const std::optional<double> trained = criterion.trained_thickness_over_lc();
  if (trained && std::abs(scales.thickness_over_lc / *trained - 1.0) > failure::kThicknessScaled)
    warnings.push_back(
        {"trained-thickness",
         fmt::format("failure.model = {} was trained with h/l_c = {:.3g}, and this ice has {:.3g}: take superposition, "
                     "which knows h/l_c, or train a network for this ice",
                     model::name_of(c.failure.model), *trained, scales.thickness_over_lc)});
  if (const auto range = criterion.thickness_over_lc_range();
      range && (scales.thickness_over_lc < (1.0 - kRangeRounds) * range->first ||
                scales.thickness_over_lc > (1.0 + kRangeRounds) * range->second))
    warnings.push_back(
        {"thickness-range",
         fmt::format("h/l_c = {:.3g} of this ice, and failure.model = {} holds from {:.3g} to {:.3g}: every answer is "
                     "for other ice; check ice.youngs_modulus and ice.thickness, or take model = \"plate\"",
                     scales.thickness_over_lc, model::name_of(c.failure.model), range->first, range->second)});
  add_poisson_warning(c, warnings);
  const failure::Assessment straight =
      criterion.assess({.contact_length = c.ice.thickness, .mu1 = scales.mu1, .mu2 = 0.0});
  if (straight.above_range)
    warnings.push_back(
        {"flat-slope", fmt::format("mu1 = {:.3g} of structure.angle lies above the failure model's range: its "
                                   "inputs will be clamped",
                                   scales.mu1)});
}

/// Land is solid to ice alone.
void add_land_warning(const Setup& setup, Warnings& warnings) {
  const model::Case& c = setup.resolved;
  if (c.field.shore.empty()) return;
  constexpr int kSamples = 400;
  const geometry::IceSheet land = geometry::checked_sheet(ice::read_outlines(c.field.shore, c.field.origin));
  for (int i = 0; i <= kSamples; ++i) {
    const double time = c.time.duration * i / kSamples;
    const Pose pose = structure::unresisted(c.structure, time);
    for (const structure::Outline& section :
         setup.hull->footprint(pose, -setup.scales.draft, setup.scales.freeboard).leading) {
      const std::vector<geometry::Polygon> under = land.within(geometry::ring(section));
      if (under.empty()) continue;
      const Vec2 at = geometry::centroid(under.front());
      warnings.push_back({"over-land", fmt::format("the structure passes over the land of field.shore at ({:.4g}, "
                                                   "{:.4g}) m, from {:.3g} s on: land is solid to ice alone; move "
                                                   "the land or the structure's course",
                                                   at.x, at.y, time)});
      return;
    }
  }
}

std::vector<model::Warning> warnings_of(const Setup& setup) {
  const model::Case& c = setup.resolved;
  Warnings warnings;
  add_ice_warnings(c, warnings);
  add_idle_file_warnings(setup, warnings);
  add_left_out_warnings(c, warnings);
  add_floe_number_warning(c, warnings);
  add_variation_warnings(setup, warnings);
  add_field_warnings(setup, warnings);
  add_land_warning(setup, warnings);
  add_time_warnings(setup, warnings);
  add_structure_warnings(setup, warnings);
  add_model_warnings(setup, warnings);
  add_idle_keys_warning(c, warnings);
  return warnings;
}

std::vector<model::Warning> warnings_of(const model::Case& resolved) { return warnings_of(Setup(resolved)); }

simulation::Run run(const model::Case& resolved, const simulation::RunOptions& options) {
  simulation::Run run = simulation::run(resolved, options);
  if (!run.complete) return run;
  Warnings warnings = warnings_of(*run.setup);
  std::ranges::move(run.summary.warnings, std::back_inserter(warnings));
  std::ranges::move(warnings_of(run.summary, run.loads_seen, resolved.reference), std::back_inserter(warnings));
  run.summary.warnings = std::move(warnings);
  return run;
}

}  // namespace brash::advice
