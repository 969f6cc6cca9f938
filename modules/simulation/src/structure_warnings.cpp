// SPDX-License-Identifier: GPL-3.0-or-later
// A structure whose front, legs or weight do not suit the case.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>

#include "brash/core/constants.hpp"
#include "brash/structure/floating_body.hpp"
#include "brash/structure/hull.hpp"
#include "brash/structure/motion.hpp"
#include "case_warnings.hpp"

namespace brash::simulation {
namespace {

bool is_afloat(const model::Motion& motion) {
  return std::holds_alternative<model::Free>(motion) || std::holds_alternative<model::Moored>(motion);
}

void add_front_warning(const DerivedScales& scales, Warnings& warnings) {
  if (scales.front_slope < structure::kSteepestSlope) return;
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
void add_balance_warnings(const model::Case& c, Warnings& warnings) {
  const auto hull = structure::make_hull(c.structure);
  const auto motion = structure::make_motion(c, *hull);
  const structure::Settling way = motion->settling();
  if (settles(way, -hull->bounds().first.z)) {
    warnings.push_back(
        {"not-in-balance",
         fmt::format("the structure is not in balance at the start: it heaves by {:.3g} m, rolls by {:.3g} and pitches "
                     "by {:.3g} degrees before the ice comes; on its waterline it displaces {:.4g} kg; check "
                     "structure.motion.mass, centre_of_gravity, thrust and mooring",
                     way.heave, degrees(way.roll), degrees(way.pitch),
                     c.water.density * structure::displaced_by_mesh(*hull, {}).volume)});
    return;
  }
  for (const structure::NaturalMode& mode : motion->natural_modes()) {
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
void add_period_warning(const model::Case& c, Warnings& warnings) {
  constexpr double kSteps = 10.0;
  const auto hull = structure::make_hull(c.structure);
  for (const structure::NaturalMode& mode : structure::make_motion(c, *hull)->natural_modes()) {
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

/// A spring so soft that its whole way in the run does not pull with the force that breaks ice.
void add_spring_warning(const model::Case& c, Warnings& warnings) {
  double stiffness = 0.0;
  if (const auto* const compliant = std::get_if<model::Compliant>(&c.structure.motion))
    stiffness = compliant->stiffness;
  else if (const auto* const moored = std::get_if<model::Moored>(&c.structure.motion); moored && moored->lines.empty())
    stiffness = moored->stiffness[0][0];
  else
    return;
  const double pull = stiffness * model::speed(c.structure.motion) * c.time.duration;
  const double needed = c.ice.flexural_strength * c.ice.thickness * c.ice.thickness;
  if (pull >= needed || c.field.kind != model::FieldKind::kLevelIce) return;
  warnings.push_back({"soft-spring", fmt::format("the spring of the structure pulls with at most {:.3g} N in this run, "
                                                 "and the ice breaks at some sigma_f h^2 = {:.3g} N: the structure "
                                                 "stays before the ice; check the unit of the stiffness",
                                                 pull, needed)});
}

/// A path that turns by more than half a circle from row to row.
void add_turn_warning(const model::Motion& motion, Warnings& warnings) {
  const auto* const towed = std::get_if<model::Towed>(&motion);
  if (towed == nullptr) return;
  const auto turns = [](const model::Waypoint& a, const model::Waypoint& b) {
    return std::abs(b.heading - a.heading) > kPi;
  };
  const auto row = std::ranges::adjacent_find(towed->path, turns);
  if (row == towed->path.end()) return;
  warnings.push_back({"path-turns", fmt::format("the path turns from a heading of {:.4g} to {:.4g} rad between {:.4g} "
                                                "and {:.4g} s: were degrees meant? Name the column heading_deg",
                                                row->heading, (row + 1)->heading, row->time, (row + 1)->time)});
}

}  // namespace

void add_structure_warnings(const model::Case& c, const DerivedScales& scales, Warnings& warnings) {
  add_front_warning(scales, warnings);
  add_turn_warning(c.structure.motion, warnings);
  add_spring_warning(c, warnings);
  add_period_warning(c, warnings);
  if (!is_afloat(c.structure.motion)) return;
  add_legs_warning(c, warnings);
  add_balance_warnings(c, warnings);
}

}  // namespace brash::simulation
