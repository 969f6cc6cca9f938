// SPDX-License-Identifier: GPL-3.0-or-later
// A structure whose front, legs or weight do not suit the case.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "brash/core/constants.hpp"
#include "brash/structure/floating_body.hpp"
#include "brash/structure/mesh_file.hpp"
#include "case_warnings.hpp"

namespace brash::advice {
namespace {

void add_front_warning(const Setup& setup, Warnings& warnings) {
  const model::Case& c = setup.resolved;
  const double slope = setup.scales.front_slope;
  const double steepest = 0.5 * kPi - std::atan(c.ice.friction_structure);
  if (slope < structure::kSteepestSlope && slope >= steepest)
    warnings.push_back({"sticking-front",
                        fmt::format("the front of the structure slopes at {:.4g} degrees: from {:.4g} degrees on, ice "
                                    "with ice.friction_structure = {:.3g} sticks to it, so there it is crushed and not "
                                    "bent",
                                    degrees(slope), degrees(steepest), c.ice.friction_structure)});
  if (slope < structure::kSteepestSlope) return;
  warnings.push_back({"vertical-front",
                      "the front of the structure is vertical: it crushes the ice at ice.crushing_factor * "
                      "ice.compressive_strength and bends none; buckling of the sheet, and a structure whose swaying "
                      "locks to the crushing, are not modelled"});
}

/// Legs that do not mirror each other about x or y have a product of inertia, which a body afloat leaves out.
void add_legs_warning(const model::Case& c, Warnings& warnings) {
  constexpr double kLopsided = 0.05;  // of the product of inertia over the sum of both moments
  if (c.structure.legs.empty()) return;
  const std::vector<Vec2>& legs = c.structure.legs;
  Vec2 middle{};
  for (const Vec2 place : legs) middle += place / static_cast<double>(legs.size());
  double product = 0.0, moments = 0.0;
  for (const Vec2 place : legs) {
    const Vec2 arm = place - middle;
    product += arm.x * arm.y;
    moments += dot(arm, arm);
  }
  if (std::abs(product) <= kLopsided * moments) return;
  warnings.push_back({"lopsided-legs",
                      fmt::format("structure.legs has no symmetry about x or y: the sum of their arms' products x y is "
                                  "{:.3g} m2, and the structure's product of inertia is left out, so it rolls and "
                                  "pitches with wrong periods; lay x along a line of symmetry of the legs",
                                  product)});
}

/// A hull askew to x and y has products of inertia and of added mass, which a body afloat leaves out, unless the case
/// states them without.
void add_askew_warning(const Setup& setup, const model::FloatingBody& body, Warnings& warnings) {
  constexpr double kAskew = 0.05;  // of the product of inertia over the sum of both moments
  if (body.radii_of_gyration && body.added_mass && body.added_inertia) return;
  const structure::HalfEllipsoid half = structure::fitted_ellipsoid(*setup.hull->copies().hull);
  const double xx = half.semi_axes.x * half.semi_axes.x, yy = half.semi_axes.y * half.semi_axes.y;
  if (0.5 * std::abs((xx - yy) * std::sin(2.0 * half.heading)) <= kAskew * (xx + yy)) return;
  warnings.push_back(
      {"askew-hull", fmt::format("the hull's length lies {:.3g} degrees off the structure's x axis: its products of "
                                 "inertia and of added mass are left out, so it rolls and pitches with wrong periods; "
                                 "turn it along x or y with structure.heading, or write "
                                 "structure.motion.radii_of_gyration, added_mass and added_inertia",
                                 degrees(half.heading))});
}

/// It would move by more than this before the ice comes.
constexpr double kSettledDraught = 0.1;         // of its draught [-]
constexpr double kSettledAngle = radians(3.0);  // [rad]

/// Whether the structure settles by so much that its waterplane is another one.
bool settles(const structure::Settling& way, double draught) {
  return !(std::abs(way.heave) <= kSettledDraught * draught && std::abs(way.roll) <= kSettledAngle &&
           std::abs(way.pitch) <= kSettledAngle);
}

/// A structure that is not in balance on the waterplane of its frame, or turns over there. Modes in plan do not count:
/// loads that are nearly in balance make small ones, which mean nothing.
void add_balance_warnings(const Setup& setup, Warnings& warnings) {
  const structure::Settling way = setup.motion->settling();
  if (settles(way, -setup.hull->bounds().first.z)) {
    warnings.push_back(
        {"not-in-balance",
         fmt::format("the structure is not in balance at the start: it heaves by {:.3g} m, rolls by {:.3g} and pitches "
                     "by {:.3g} degrees before the ice comes; on its waterline it displaces {:.4g} kg; check "
                     "structure.motion.mass, centre_of_gravity, thrust and mooring",
                     way.heave, degrees(way.roll), degrees(way.pitch),
                     setup.resolved.water.density * structure::displaced_by_mesh(*setup.hull, {}).volume)});
    return;
  }
  for (const structure::NaturalMode& mode : setup.motion->natural_modes()) {
    const std::string_view name = mode.motion;
    if (mode.squared_frequency >= 0.0 || (name != "heave" && name != "roll" && name != "pitch")) continue;
    warnings.push_back({"turns-over", fmt::format("nothing brings the structure back in {}: its centre of gravity is "
                                                  "too high, or its mooring pushes; lower "
                                                  "structure.motion.centre_of_gravity",
                                                  name)});
    return;
  }
}

/// A natural period that the steps hardly resolve: at ten steps a period the leapfrog's is 1.7 % off (B4).
void add_period_warning(const Setup& setup, Warnings& warnings) {
  constexpr double kSteps = 10.0;
  const model::Case& c = setup.resolved;
  for (const structure::NaturalMode& mode : setup.motion->natural_modes()) {
    if (mode.squared_frequency <= 0.0) continue;
    const double period = 2.0 * kPi / std::sqrt(mode.squared_frequency);
    if (period >= kSteps * c.time.step) continue;
    warnings.push_back({"short-period", fmt::format("the structure's natural period of {:.3g} s, mostly {}, has {:.2g} "
                                                    "steps of time.step = {} s: expected {:.0f} or more; shorten the "
                                                    "step, or check mass and stiffness",
                                                    period, mode.motion, period / c.time.step, c.time.step, kSteps)});
    return;
  }
}

/// What moves a structure that springs hold.
struct Drive {
  double mass = 0.0;       ///< [kg]
  double stiffness = 0.0;  ///< along x [N/m]
  double pull = 0.0;       ///< along x without a stretch of the springs [N]
};

std::optional<Drive> drive_of(const Setup& setup) {
  const model::Case& c = setup.resolved;
  if (const auto* const compliant = std::get_if<model::Compliant>(&c.structure.motion))
    return Drive{compliant->mass, compliant->stiffness, 0.0};
  const auto* const moored = std::get_if<model::Moored>(&c.structure.motion);
  if (moored == nullptr || !moored->lines.empty()) return std::nullopt;
  return Drive{structure::inertia_of(moored->body, *setup.hull, c.water.density).mass, moored->stiffness[0][0],
               moored->body.thrust.x + (moored->pretension.empty() ? 0.0 : moored->pretension[0])};
}

/// A spring so soft that its whole way in the run does not pull with the force that breaks ice, and no momentum that
/// breaks ice over that way.
void add_spring_warning(const Setup& setup, Warnings& warnings) {
  const model::Case& c = setup.resolved;
  const auto drive = drive_of(setup);
  if (!drive || !model::has_level_ice(c.field)) return;
  const double speed = model::speed(c.structure.motion), way = speed * c.time.duration;
  const double pull = drive->stiffness * way + drive->pull;
  const double needed = c.ice.flexural_strength * c.ice.thickness * c.ice.thickness;
  if (pull >= needed || 0.5 * drive->mass * speed * speed >= needed * way) return;
  warnings.push_back({"soft-spring", fmt::format("the spring of the structure pulls with at most {:.3g} N in this run, "
                                                 "and the ice breaks at some sigma_f h^2 = {:.3g} N: the ice stops the "
                                                 "structure; check the unit of the stiffness",
                                                 pull, needed)});
}

/// Where a path has its heading on the wrong side of its course.
struct Backwards {
  const model::Waypoint* first = nullptr;  ///< row of its first such stretch
  double share = 0.0;                      ///< of its travel that such stretches make [-]
};

/// How the course from a row to the next lies to the heading between them.
struct Stretch {
  Vec2 way{};            ///< [m]
  double course = 0.0;   ///< [rad]
  double heading = 0.0;  ///< in the middle [rad]
};

Stretch stretch_of(const model::Waypoint& a, const model::Waypoint& b) {
  const Vec2 way = b.position - a.position;
  return {way, std::atan2(way.y, way.x), a.heading + 0.5 * std::remainder(b.heading - a.heading, 2.0 * kPi)};
}

Backwards backwards(const std::vector<model::Waypoint>& path) {
  constexpr double kAbeam = radians(91.0);  // a structure that goes sideways on purpose, and rounded inputs
  Backwards found;
  double all = 0.0, turned = 0.0;
  for (auto row = path.begin(); row + 1 < path.end(); ++row) {
    const Stretch stretch = stretch_of(*row, *(row + 1));
    all += norm(stretch.way);
    if (std::abs(std::remainder(stretch.heading - stretch.course, 2.0 * kPi)) <= kAbeam) continue;
    turned += norm(stretch.way);
    if (found.first == nullptr) found.first = &*row;
  }
  found.share = all > 0.0 ? turned / all : 0.0;
  return found;
}

constexpr const char* kDegreesMeant =
    "were degrees meant? Write \"10 deg\" in the case file, and name the column of a file heading_deg";

/// A path whose heading begins beyond a circle, or points away from its course over a good part of its travel.
void add_heading_warning(const std::vector<model::Waypoint>& path, Warnings& warnings) {
  constexpr double kLeastShare = 0.1;  // a track at rest wanders a little
  if (std::abs(path.front().heading) > 2.0 * kPi) {
    warnings.push_back({"path-heading", fmt::format("the path begins with a heading of {:.4g} rad, beyond a circle: {}",
                                                    path.front().heading, kDegreesMeant)});
    return;
  }
  const Backwards found = backwards(path);
  if (found.share <= kLeastShare) return;
  const model::Waypoint& row = *found.first;
  const model::Waypoint& next = *(found.first + 1);
  const Stretch stretch = stretch_of(row, next);
  warnings.push_back(
      {"path-heading",
       fmt::format("the structure goes backwards over {:.0f} % of its path: from {:.4g} to {:.4g} s its course is "
                   "{:.4g} rad and its heading {:.4g} rad; if it does not go astern on purpose, {}",
                   100.0 * found.share, row.time, next.time, stretch.course, stretch.heading, kDegreesMeant)});
}

/// A path whose headings change by more than half a circle from row to row, but for small turns through north; or
/// whose headings do not suit its course.
void add_turn_warning(const model::Motion& motion, Warnings& warnings) {
  constexpr double kThroughNorth = 1.0;  // [rad]; of a step in a compass track
  const auto* const towed = std::get_if<model::Towed>(&motion);
  if (towed == nullptr || towed->path.empty()) return;
  const auto turns = [](const model::Waypoint& a, const model::Waypoint& b) {
    const double turn = b.heading - a.heading;
    return std::abs(turn) > kPi && std::abs(std::remainder(turn, 2.0 * kPi)) > kThroughNorth;
  };
  const auto row = std::adjacent_find(towed->path.begin(), towed->path.end(), turns);
  if (row == towed->path.end()) {
    add_heading_warning(towed->path, warnings);
    return;
  }
  warnings.push_back(
      {"path-turns", fmt::format("the path turns from a heading of {:.4g} to {:.4g} rad between {:.4g} "
                                 "and {:.4g} s: {}",
                                 row->heading, (row + 1)->heading, row->time, (row + 1)->time, kDegreesMeant)});
}

/// Whether an angle [rad] of this size looks as if its degrees had lost their unit: the radians are a short number, and
/// the angle is none that people write so.
/// @param plausible  smaller ones are likely meant [rad].
bool looks_like_degrees(double angle, double plausible) {
  constexpr double kPerUnit = 100.0, kRounding = 1e-9;
  constexpr double kUsual = 15.0, kNear = 0.3;  // multiples of it are usual, such as 1.57 rad [degrees]
  const double digits = kPerUnit * std::abs(angle);
  const bool is_short = std::abs(digits - std::round(digits)) < kRounding;
  const bool is_usual = std::abs(std::remainder(degrees(angle), kUsual)) < kNear;
  return std::abs(angle) >= plausible && is_short && !is_usual;
}

/// The angles whose degrees are within the range of radians too. The others are refused where they are read.
void add_angle_warnings(const model::Case& c, Warnings& warnings) {
  constexpr double kTurned = 0.5, kTilted = 0.1;  // [rad]
  const auto look = [&](const char* key, double angle, double plausible) {
    if (!looks_like_degrees(angle, plausible)) return;
    warnings.push_back({"bare-angle", fmt::format("{0} = {1} is in radians, {2:.4g} degrees: was \"{1} deg\" meant?",
                                                  key, angle, degrees(angle))});
  };
  if (const auto* const mesh = std::get_if<model::Mesh>(&c.structure.shape)) {
    look("structure.heading", mesh->heading, kTurned);
    look("structure.heel", mesh->heel, kTilted);
    look("structure.trim", mesh->trim, kTilted);
  }
  if (c.hull.flare) look("hull.flare", *c.hull.flare, kTurned);
}

/// A mesh that points another way than its user meant, or whose convex parts, which floes meet in its place, are not
/// it.
void add_mesh_warnings(const model::Shape& shape, Warnings& warnings) {
  constexpr double kMostError = 0.1;  // of the volume
  const auto* const mesh = std::get_if<model::Mesh>(&shape);
  const auto report = mesh != nullptr ? structure::examine(*mesh) : structure::MeshReport{};
  if (!report) return;
  if (!report->bearing.doubt.empty())
    warnings.push_back(
        {"mesh-turned", fmt::format("{}; {}, or leave it if it is so", report->bearing.doubt, report->bearing.remedy)});
  if (report->parts_error <= kMostError) return;
  warnings.push_back(
      {"loose-parts",
       fmt::format(
           "floes meet {} convex parts in place of the mesh, and their volume is off by {:.2g} %: floes touch the "
           "structure where the mesh has none, or not where it has one; make the mesh smoother, or fill its hollows",
           report->n_parts, 100.0 * report->parts_error)});
}

}  // namespace

const model::FloatingBody* afloat(const model::Motion& motion) {
  if (const auto* const free = std::get_if<model::Free>(&motion)) return &free->body;
  if (const auto* const moored = std::get_if<model::Moored>(&motion)) return &moored->body;
  return nullptr;
}

void add_structure_warnings(const Setup& setup, Warnings& warnings) {
  const model::Case& c = setup.resolved;
  add_front_warning(setup, warnings);
  add_mesh_warnings(c.structure.shape, warnings);
  add_turn_warning(c.structure.motion, warnings);
  add_angle_warnings(c, warnings);
  add_spring_warning(setup, warnings);
  add_period_warning(setup, warnings);
  const model::FloatingBody* const body = afloat(c.structure.motion);
  if (body == nullptr) return;
  add_legs_warning(c, warnings);
  add_askew_warning(setup, *body, warnings);
  add_balance_warnings(setup, warnings);
}

}  // namespace brash::advice
