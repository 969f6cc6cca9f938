// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "brash/failure/criterion.hpp"
#include "brash/floes/bearing.hpp"
#include "brash/geometry/ice_sheet.hpp"
#include "brash/geometry/trapezoid.hpp"
#include "brash/ice/variation.hpp"
#include "brash/model/case.hpp"
#include "brash/model/records.hpp"
#include "brash/rigid_body/world.hpp"
#include "brash/structure/hull.hpp"
#include "brash/structure/motion.hpp"

namespace brash::edge {

/// The chord at which the structure would touch an edge at rest. It shows which moving edge is meant.
struct Touch {
  Vec2 tip{};           ///< its middle [m]
  double length = 0.0;  ///< [m]
};

/// How much the loads around a contact bend the ice there, by failure::share_at of their distances [N].
struct Pressing {
  double by_structure = 0.0, by_floes = 0.0;
  double up = 0.0, down = 0.0;  ///< the vertical loads among them

  double sum() const { return by_structure + by_floes; }
  /// What is left where loads up and down bend the ice against each other.
  double net() const { return sum() - 2.0 * std::min(up, down); }
};

/// The structure, or a floe, against the edge of the fixed sheet, at one place, at one instant.
struct EdgeContact {
  geometry::ContactRegion region;
  geometry::Trapezoid wedge;
  failure::LoadCase load;
  failure::Assessment assessment;
  Vec3 on_ice{};        ///< force on the ice, friction included [N]
  Vec3 point{};         ///< where it acts [m]
  Vec3 normal{};        ///< unit, mean over the surface that crushes, into the ice
  double area = 0.0;    ///< of that surface, seen along `normal` [m2]
  double bound = 0.0;   ///< F_n of Eq. 15: the most that the ice carries along `normal` [N]
  double spread = 0.0;  ///< the smaller of its forces to one side of the chord's normal and the other [N]
  bool bends = true;    ///< whether the surface has a slope; a vertical one crushes the ice only
  /// Where the assessment comes from.
  enum class Verdict {
    kSolved,   ///< the criterion
    kKept,     ///< an earlier one: Verdicts::recall()
    kControl,  ///< an earlier one too; the criterion says `control`
  };
  Verdict kept = Verdict::kSolved;
  failure::Assessment control{};
  bool has_verdict = true;             ///< not where a far stronger load beside it has one: assess()
  std::int64_t floe = model::kNoFloe;  ///< that presses
  int level_ice = 0;                   ///< number of the level ice that it is the edge of
  Touch touched{};                     ///< at rest
  Pressing pressing{};                 ///< weigh_loads()
  std::optional<double> edge_age{};    ///< of an edge that moves: since its first touch [s]
  double shift = 0.0;                  ///< how much higher than at rest its edge lies [m]
  failure::IceProperties ice{};        ///< there
};

/// The inputs of the edge contacts besides the sheet.
struct EdgeModel {
  const structure::Hull& hull;
  const model::Case& resolved;
  const failure::IceProperties& ice;
  const failure::BendingCriterion& criterion;
  const ice::Variation* variation = nullptr;  ///< of the ice; nullptr: it is even
};

/// Heights of the level ice floating at rest [m].
struct Freeboard {
  double top = 0.0;
  double bottom = 0.0;
};
Freeboard freeboard(const model::Case& resolved);
/// The same for ice of another thickness [m].
Freeboard freeboard(const model::Case& resolved, double thickness);

/// Ice as the failure criterion sees it.
failure::IceProperties ice_properties(const model::Case& resolved);

/// The criterion that the case names.
std::unique_ptr<failure::BendingCriterion> make_criterion(const model::Case& resolved,
                                                          const failure::IceProperties& ice);

/// Its section at mid-thickness: as much ice lies in this section as in the structure itself. Pieces are born without
/// it; empty where crushed ice stays.
std::vector<geometry::Ring> middle_outlines(const EdgeModel& model, const Pose& pose);
/// Where it has passed through the whole thickness of ice that lies `shift` higher than at rest [m]. This ice leaves;
/// empty where crushed ice stays.
std::vector<geometry::Ring> trailing_outlines(const EdgeModel& model, const Pose& pose, double shift = 0.0);

/// All contacts of the structure with the sheet, each fitted and loaded.
///
/// Crushing: sigma_c R (Eq. 15) along the normal of each part of the structure's surface inside the ice that moves into
/// it, and friction against its slip. `contact.area = "projected"` takes the part's plan for its area. With
/// `failure.crushed_ice = "stays"` the parts then share the plan of all ice under the structure.
/// docs/theory/simulation.md, (S0).
///
/// @param shift_of  how much higher than at rest the edge lies there [m]; empty: nowhere. A contact that the edge
///                  evades stays, without a load.
std::vector<EdgeContact> edge_contacts(const EdgeModel& model, const geometry::IceSheet& sheet,
                                       const structure::State& state,
                                       const std::function<double(const Touch&)>& shift_of = {});

/// The edge under a floe that presses on it; nothing where it hardly presses.
///
/// The mean forces are taken as the line load of the failure model: N along the floe's thrust, f across it, |P| the
/// vertical part. A floe flat under the sheet has no thrust; its line lies along the nearest edge. Its length c is the
/// length of an even load with the same second moment about its middle. It is at least h: plate theory says nothing of
/// less. docs/theory/simulation.md, (S1).
std::optional<EdgeContact> bearing_contact(const EdgeModel& mean, const geometry::IceSheet& sheet, std::int64_t floe,
                                           const floes::Bearing& bearing);

/// Finds EdgeContact::pressing of contacts with one sheet.
void weigh_loads(const EdgeModel& model, std::vector<EdgeContact>& contacts);

/// How an edge moves at a contact; empty: not at all. Threads may call it at a time.
using MotionOf = std::function<failure::EdgeMotion(const EdgeContact&)>;
/// Calls `judge(i)` for each i in [0, n), in any order, on any thread.
using ShareOut = std::function<void(std::size_t n, const std::function<void(std::size_t i)>& judge)>;

/// Evaluates contacts with the same sheet by the model's criterion. A criterion that does not solve the sheet knows
/// loads on the edge alone: floes that press farther inside than the length of their line are not evaluated.
void assess(const EdgeModel& model, const geometry::IceSheet& sheet, std::vector<EdgeContact>& contacts,
            const MotionOf& motion_of, const ShareOut& share_out);
/// On edges that do not move, one contact after the other.
void assess(const EdgeModel& model, const geometry::IceSheet& sheet, std::vector<EdgeContact>& contacts);

/// Where the ice cracks at a contact. A structure that cuts deep before the ice breaks is in a notch, and the chord
/// joins the notch's ends. If half the breaking length ends inside the notch, chord and crack move to the ice ahead, B.
EdgeContact before_the_notch(EdgeContact contact);

}  // namespace brash::edge
