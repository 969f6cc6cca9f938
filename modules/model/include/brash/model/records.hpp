// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "brash/core/vec.hpp"

namespace brash::model {

/// Where the structure's work has gone since the start, besides into the floes' energies [J]. Positive: taken from the
/// structure and the floes. Each is forces times velocities, none is a remainder (docs/theory/contacts-and-bodies.md,
/// (E1)).
struct EnergyLosses {
  double edge = 0.0;                ///< the structure's work against the sheet's edge: crushing and its friction
  double bending = 0.0;             ///< the structure's work that bends the sheet's edge, where it moves
  double structure_contact = 0.0;   ///< normal forces between floes and structure: crushing and impact
  double structure_friction = 0.0;  ///< slip between floes and structure
  double sheet_contact = 0.0;       ///< as structure_contact, between floes and the fixed sheet
  double sheet_friction = 0.0;
  double floe_contact = 0.0;  ///< as structure_contact, between floes
  double floe_friction = 0.0;
  double drag = 0.0;           ///< form and rotational drag; negative where a current pushes
  double skin_friction = 0.0;  ///< of the water; negative where a current pulls
  double bed_contact = 0.0;    ///< normal forces between floes and the bed of the water
  double bed_friction = 0.0;   ///< slip on the bed; negative where a bed that moves carries floes

  /// Calls `visit(name, meaning, member)` for each: one list serves files, checkpoints and sums.
  template <typename Visit>
  static void visit(Visit&& visit) {
    visit_without_bed(visit);
    visit_of_bed(visit);
  }
  template <typename Visit>
  static void visit_without_bed(Visit&& visit) {
    visit("edge", "crushing and its friction at the sheet's edge", &EnergyLosses::edge);
    visit("bending", "bending of the sheet's edge", &EnergyLosses::bending);
    visit("structure_contact", "crushing and impact between floes and structure", &EnergyLosses::structure_contact);
    visit("structure_friction", "friction between floes and structure", &EnergyLosses::structure_friction);
    visit("sheet_contact", "crushing and impact between floes and sheet", &EnergyLosses::sheet_contact);
    visit("sheet_friction", "friction between floes and sheet", &EnergyLosses::sheet_friction);
    visit("floe_contact", "crushing and impact between floes", &EnergyLosses::floe_contact);
    visit("floe_friction", "friction between floes", &EnergyLosses::floe_friction);
    visit("drag", "form and rotational drag of the water", &EnergyLosses::drag);
    visit("skin_friction", "skin friction of the water", &EnergyLosses::skin_friction);
  }
  /// Histories and summaries have these only if there is a bed.
  template <typename Visit>
  static void visit_of_bed(Visit&& visit) {
    visit("bed_contact", "crushing and impact between floes and bed", &EnergyLosses::bed_contact);
    visit("bed_friction", "friction between floes and bed", &EnergyLosses::bed_friction);
  }
  double total() const {
    double sum = 0.0;
    visit([&](const char*, const char*, double EnergyLosses::*loss) { sum += this->*loss; });
    return sum;
  }

  friend bool operator==(const EnergyLosses&, const EnergyLosses&) = default;
};

/// Energies of a structure that is a body, seen from the water: velocities are against the water, which has no work
/// then. Works and losses are since the start [J]. They satisfy (docs/theory/structures.md, (B9))
///
///   initial + ice_work + thrust_work + anchor_work = kinetic + hydrostatic + mooring + damping_loss + error.
struct BodyEnergy {
  double kinetic = 0.0;      ///< added mass included
  double hydrostatic = 0.0;  ///< of weight and buoyancy, against the pose at the start
  double mooring = 0.0;      ///< of springs and lines, against the pose at the start
  double ice_work = 0.0;     ///< of the ice on the structure
  double thrust_work = 0.0;
  double anchor_work = 0.0;  ///< of the mooring's feet, where they move through the water
  double damping_loss = 0.0;
  double error = 0.0;  ///< of the integration in time; positive where energy vanished

  /// Calls `visit(name, meaning, member)` for each: one list serves files and checkpoints.
  template <typename Visit>
  static void visit(Visit&& visit) {
    visit("kinetic", "kinetic energy against the water, added mass included", &BodyEnergy::kinetic);
    visit("hydrostatic", "energy of weight and buoyancy, against the start", &BodyEnergy::hydrostatic);
    visit("mooring", "energy of the mooring, against the start", &BodyEnergy::mooring);
    visit("ice_work", "work of the ice on it since the start", &BodyEnergy::ice_work);
    visit("thrust_work", "work of the thrust since the start", &BodyEnergy::thrust_work);
    visit("anchor_work", "work of the mooring's feet since the start", &BodyEnergy::anchor_work);
    visit("damping_loss", "energy that damping took since the start", &BodyEnergy::damping_loss);
    visit("error", "error of the integration since the start", &BodyEnergy::error);
  }

  friend bool operator==(const BodyEnergy&, const BodyEnergy&) = default;
};

/// Regions of a ship's hull, from the stem to the stern, then below: docs/theory/structures.md, (K7).
enum class HullRegion { kBow, kShoulders, kSides, kStern, kBottom };
constexpr std::size_t kHullRegions = 5;
/// Each leg of a structure with legs is a region.
constexpr std::size_t kMostLegs = 8;

/// Force of the ice on a region of the structure [N], load axes; and how much of the region ice covers.
struct RegionLoad {
  Vec3 total{};
  Vec3 crushing{};       ///< the part of `total` from the edge of level ice; the rest is of floes
  double covered = 0.0;  ///< share of the wetted surface of a region of a hull that floes cover [-]

  friend bool operator==(const RegionLoad&, const RegionLoad&) = default;
};

/// In the order of HullRegion, then of the legs.
struct RegionLoads : std::array<RegionLoad, kHullRegions + kMostLegs> {
  /// Calls `visit(name, meaning, index)` for each region: one list serves files and sums.
  template <typename Visit>
  static void visit(Visit&& visit) {
    visit("bow", "the bow", 0);
    visit("shoulders", "the shoulders", 1);
    visit("sides", "the sides", 2);
    visit("stern", "the stern", 3);
    visit("bottom", "the bottom", 4);
    constexpr std::array<std::array<const char*, 2>, kMostLegs> kLegs{{{"leg_1", "leg 1"},
                                                                       {"leg_2", "leg 2"},
                                                                       {"leg_3", "leg 3"},
                                                                       {"leg_4", "leg 4"},
                                                                       {"leg_5", "leg 5"},
                                                                       {"leg_6", "leg 6"},
                                                                       {"leg_7", "leg 7"},
                                                                       {"leg_8", "leg 8"}}};
    for (std::size_t i = 0; i < kMostLegs; ++i) visit(kLegs[i][0], kLegs[i][1], kHullRegions + i);
  }
};

/// Load on the structure over a step, in load axes: x against the structure's heading, y to starboard, z upwards;
/// moments about the structure's origin on the waterplane. A structure that does not turn heads along x, so the ice
/// drifts against it along the x of the loads. The energies of a row satisfy
///
///   work + birth_energy = kinetic_energy + potential_energy + losses.total() + removed_energy + energy_error.
struct LoadRow {
  double time = 0.0;              ///< [s]
  Wrench total;                   ///< [N], [N m]
  Wrench crushing;                ///< crushing at the sheet's edge
  Wrench floe_normal;             ///< normal contact forces of floes
  Wrench floe_friction;           ///< friction of floes
  Wrench bed;                     ///< load of the ice on the bed of the water, in the same axes
  double kinetic_energy = 0.0;    ///< of all floes [J]
  double potential_energy = 0.0;  ///< of all floes in gravity and buoyancy, against floating at rest [J]
  double work = 0.0;              ///< done by the structure on the ice since the start [J]
  /// Energy of floes at their birth, and their gain in their first step that no load explains, since the start [J].
  double birth_energy = 0.0;
  /// Energy since the start of ice that was deleted, became brash, fell asleep or left a sheet, and of the added mass
  /// that pieces have less than their floe [J].
  double removed_energy = 0.0;
  EnergyLosses losses;
  /// Residual of the balance: errors of the integration in time since the start; positive where energy vanished [J].
  double energy_error = 0.0;
  /// The ledger in m2, as doubles of the exact areas.
  double area_sheet = 0.0;
  double area_floes = 0.0;
  double area_crushed = 0.0;
  double area_deleted = 0.0;
  double area_brash = 0.0;
  double area_snap = 0.0;
  int n_floes = 0;
  int n_contacts = 0;   ///< points at which floes press on the structure
  Vec2 structure{};     ///< place of the structure's origin [m]
  Vec2 velocity{};      ///< of it, mean over the step [m/s]
  double height = 0.0;  ///< of that origin above the water's surface [m]
  double rise = 0.0;    ///< its velocity upwards, mean over the step [m/s]
  Vec3 attitude{};      ///< roll, pitch and heading: turned by the heading first, by the roll last [rad]
  Vec3 spin{};          ///< angular velocity, mean over the step, sheet frame [rad/s]
  BodyEnergy body;      ///< of a free or moored structure
  RegionLoads regions;  ///< of a ship, a mesh or a structure with legs

  friend bool operator==(const LoadRow&, const LoadRow&) = default;
};

/// In place of a floe where the structure itself acts.
constexpr std::int64_t kNoFloe = -1;

/// One crack event; the columns of events.csv.
struct CrackEvent {
  double time = 0.0;
  Vec2 at{};           ///< B [m]
  double depth = 0.0;  ///< b [m]
  double contact_length = 0.0;
  double angle = 0.0;  ///< theta [rad]
  double fit_error = 0.0;
  double mu1 = 0.0;
  double mu2 = 0.0;
  double pressure = 0.0;
  double sigma_max = 0.0;
  double breaking_length = 0.0;
  int wedges = 0;
  int pieces = 0;
  bool in_range = true;
  int substeps = 1;
  double area_before = 0.0;  ///< of the sheet [m2]
  double area_after = 0.0;
  Vec2 tip{};      ///< middle of the trapezoid's tip edge [m]
  Vec2 towards{};  ///< unit vector from the tip into the ice, along the trapezoid's axis
  std::int64_t pressing_floe = kNoFloe;
  double edge_age = 0.0;           ///< since the structure touched the edge first; 0 where it does not move [s]
  double edge_deflection = 0.0;    ///< as the edge is pushed; 0 where it does not move [m]
  double thickness = 0.0;          ///< of the ice at the contact [m]
  double flexural_strength = 0.0;  ///< of the ice at the contact [Pa]
  double overload = 0.0;           ///< loads over those at which the ice just fails; 0: not known

  friend bool operator==(const CrackEvent&, const CrackEvent&) = default;
};

/// A drifting sheet that split in its plane; docs/theory/fracture-of-floes.md, (G6), (G7).
struct SheetSplit {
  double time = 0.0;
  Vec2 at{};                      ///< on the edge, where the crack began [m]
  Vec2 towards{};                 ///< unit vector along the crack
  double length = 0.0;            ///< W: ice ahead along the crack [m]
  double breadth = 0.0;           ///< B: twice the narrower side [m]
  double opening = 0.0;           ///< P [N]
  double push = 0.0;              ///< N [N]
  double stress_intensity = 0.0;  ///< the least K_I on the crack's way [Pa m^0.5]
  double thickness = 0.0;         ///< [m]
  double area_before = 0.0;       ///< of all sheets [m2]
  double area_after = 0.0;
  int pieces = 0;  ///< parts of the sheet, the largest among them

  friend bool operator==(const SheetSplit&, const SheetSplit&) = default;
};

enum class FloeEnd { kAlive, kCrushed, kBroken };

constexpr const char* name_of(FloeEnd end) {
  switch (end) {
    case FloeEnd::kAlive:
      return "alive";
    case FloeEnd::kCrushed:
      return "crushed";
    case FloeEnd::kBroken:
      return "broken";
  }
  return "";
}

/// A floe's life; its outline in its body frame is stored once.
struct FloeRecord {
  std::int64_t id = 0;
  std::vector<std::vector<Vec2>> rings;  ///< outline and holes, body frame [m]
  double area = 0.0;                     ///< exact area as double [m2]
  double birth = 0.0;                    ///< [s]
  double death = 0.0;                    ///< [s], duration when alive at the end
  FloeEnd end = FloeEnd::kAlive;
  double peak_stress = 0.0;       ///< largest of the deletion criterion's stress [Pa]
  Pose birth_pose{};              ///< of a piece of level ice, where it lay there
  std::int64_t parent = kNoFloe;  ///< FloeRecord::id of the floe that it is a piece of; none of a piece of level ice
  double thickness = 0.0;         ///< [m]

  friend bool operator==(const FloeRecord&, const FloeRecord&) = default;
};

/// Pose of one floe in one frame.
struct FloePose {
  std::int64_t floe = 0;  ///< FloeRecord::id
  Pose pose;
  double contact_force = 0.0;  ///< sum of the magnitudes of the normal forces on it in the step before [N]

  friend bool operator==(const FloePose&, const FloePose&) = default;
};

/// One frame of the replay.
struct Frame {
  double time = 0.0;
  Pose structure;
  std::vector<FloePose> floes;

  friend bool operator==(const Frame&, const Frame&) = default;
};

/// The sheet after the cracks of a step.
struct CrackedSheet {
  double time = 0.0;                     ///< [s]
  std::vector<std::vector<Vec2>> rings;  ///< outline, then holes [m]

  friend bool operator==(const CrackedSheet&, const CrackedSheet&) = default;
};

/// Everything a run leaves, filled while it goes.
struct RunResults {
  std::vector<LoadRow> loads;
  std::vector<CrackEvent> events;
  std::vector<SheetSplit> splits;
  std::vector<FloeRecord> floes;
  std::vector<Frame> frames;
  std::vector<CrackedSheet> cracked_sheets;
  std::vector<std::vector<Vec2>> initial_sheet;  ///< rings [m]
  std::vector<std::vector<Vec2>> final_sheet;    ///< rings [m]

  friend bool operator==(const RunResults&, const RunResults&) = default;
};

/// How a sheet with free borders moves in the plane.
struct SheetMotion {
  double mass = 0.0;     ///< [kg]
  Vec2 centre{};         ///< place of its centre of mass [m]
  double heading = 0.0;  ///< it has turned by [rad]
  Vec2 velocity{};       ///< of the centre [m/s]
  double spin = 0.0;     ///< [rad/s]
};

/// How verdicts on solved sheets were found, and why some were not: `plate-outline`.
struct SheetSolves {
  int coarse = 0;            ///< solutions with quadratic elements, to screen
  int cubic = 0;             ///< solutions with cubic elements
  int split = 0;             ///< of both, of a sheet that a radial crack has split
  int without_edge = 0;      ///< contacts that no free edge faces: the trapezoid took its place
  int unsolved = 0;          ///< sheets that could not be solved: the trapezoid took their place
  int split_unsolved = 0;    ///< split sheets that could not be solved: the verdict is of the whole one
  int holding_together = 0;  ///< verdicts above the strength without a crack that cuts B off: no break

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("solved_coarse", "1", "solutions of sheets with quadratic elements", self.coarse);
    visit("solved_cubic", "1", "solutions of sheets with cubic elements", self.cubic);
    visit("solved_split", "1", "of these, of sheets that a radial crack had split", self.split);
    visit("without_edge", "1", "contacts that no free edge faces", self.without_edge);
    visit("unsolved", "1", "sheets that could not be solved", self.unsolved);
    visit("split_unsolved", "1", "split sheets that could not be solved", self.split_unsolved);
    visit("holding_together", "1", "verdicts above the strength without a crack", self.holding_together);
  }
  int n_solved() const { return coarse + cubic; }
  SheetSolves& operator+=(const SheetSolves& other) {
    coarse += other.coarse;
    cubic += other.cubic;
    split += other.split;
    without_edge += other.without_edge;
    unsolved += other.unsolved;
    split_unsolved += other.split_unsolved;
    holding_together += other.holding_together;
    return *this;
  }
};

/// Verdicts that were kept from an earlier solution: docs/theory/simulation.md, (S6).
struct KeptCounts {
  int kept = 0;         ///< verdicts
  int controls = 0;     ///< kept verdicts, solved all the same, to count misses
  int late = 0;         ///< controls that had failed before their contact was solved
  double latest = 0.0;  ///< the longest time that a late control had [s]

  KeptCounts& operator+=(const KeptCounts& other) {
    kept += other.kept;
    controls += other.controls;
    late += other.late;
    latest = std::max(latest, other.latest);
    return *this;
  }

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("kept", "1", "verdicts kept from an earlier solution", self.kept);
    visit("controls", "1", "kept verdicts that were solved all the same", self.controls);
    visit("late", "1", "failures among the controls that came late", self.late);
    visit("latest", "s", "the longest time by which one did", self.latest);
  }
};

}  // namespace brash::model
