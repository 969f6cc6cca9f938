// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/ice/plate.hpp"
#include "brash/model/case.hpp"
#include "brash/model/checkpoint.hpp"
#include "brash/model/records.hpp"
#include "brash/rigid_body/world.hpp"
#include "brash/structure/motion.hpp"

namespace brash::edge {

/// Where the frame of a sheet is, and how it moves: x, y and yaw, world frame.
struct Drift {
  Vec2 position{};     ///< of the frame's origin [m]
  double angle = 0.0;  ///< yaw [rad]
  Vec2 velocity{};     ///< of the origin [m/s]
  double spin = 0.0;   ///< yaw rate [rad/s]

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("position_", "m", "place of the frame's origin", self.position);
    visit("angle", "rad", "yaw", self.angle);
    visit("velocity_", "m s-1", "velocity of the origin", self.velocity);
    visit("spin", "rad s-1", "yaw rate", self.spin);
  }
};

/// A sheet as a rigid body in the plane, its own frame.
struct SheetBody {
  double mass = 0.0;       ///< [kg]
  double inertia = 0.0;    ///< about the centre [kg m2]
  Vec2 centre{};           ///< [m]
  double area = 0.0;       ///< [m2]
  Vec2 lower{}, upper{};   ///< box around it [m]
  double thickness = 0.0;  ///< [m]

  /// Area over the largest side of the box [m].
  double breadth() const;
};

/// Mass, centre and inertia of ice with these outlines.
SheetBody sheet_body(const std::vector<geometry::Polygon>& outlines, double thickness, double density);

/// Whether ice afloat is broad enough to bend as a plate.
/// @param smallest  field.smallest_plate, in characteristic lengths of `ice`.
bool is_plate(const std::vector<geometry::Polygon>& outlines, const failure::IceProperties& ice, double smallest);

/// Work on the sheets in a step [J]; contacts between bodies report theirs.
struct WorkOnSheets {
  double edge = 0.0;  ///< of the structure at their edges
  double form = 0.0;  ///< of the water's form drag
  double skin = 0.0;  ///< of its skin friction
  double wind = 0.0;
};

/// The sheets of level ice with free borders as bodies afloat, each by its number; docs/theory/fracture-of-floes.md.
/// They move in x, y and yaw. Weight and buoyancy are in balance, and bending is the failure model's.
///
/// In a step the structure sees a sheet move evenly at its velocity of the start, along advance(). The step of the
/// world then finds the new velocity, from the loads of structure, water and wind and from contacts with floes, walls
/// and other sheets. Sheets with fixed borders have the world's frame, and are not kept here.
class DriftingSheets {
 public:
  /// @param world  where each sheet becomes a body; it outlives the sheets.
  /// @param drift  whether sheets drift at all.
  DriftingSheets(const model::Case& resolved, rigid_body::World& world, bool drift)
      : case_(&resolved), world_(&world), drift_(drift) {}

  bool any() const { return drift_; }

  /// The next sheet.
  void add(const ice::Plate& plate, const Drift& drift = {});
  /// The outline of a sheet has changed. Every point of the rest keeps its velocity. @return the kinetic energy that
  /// went with the ice that it lost [J].
  double weigh(const ice::Plate& plate);

  const Drift& drift(int number) const { return at(number).now; }
  const SheetBody& body(int number) const { return at(number).body; }
  /// In the world; none where sheets do not drift.
  BodyId id(int number) const { return any() ? at(number).id : rigid_body::kNoBody; }
  /// Of its frame, now.
  Pose pose(int number) const { return any() ? pose_of(at(number).now) : Pose{}; }
  /// Of its frame, at the start of the step.
  Pose start_pose(int number) const { return any() ? pose_of(at(number).start) : Pose{}; }
  /// Of its frame, at the start of the step.
  Twist twist(int number) const;
  /// The structure in the frame of the sheet, `later` [s] from now.
  structure::State seen_from(int number, const structure::State& structure, double later = 0.0) const;

  /// Out of the frame, where it is now.
  Vec3 to_world(int number, Vec3 point) const { return any() ? brash::to_world(pose(number), point) : point; }
  Vec3 turned(int number, Vec3 v) const { return any() ? rotate(pose(number).rotation, v) : v; }
  /// Into the frame, where it was at the start of the step: contacts of bodies are found there.
  Vec3 to_sheet(int number, Vec3 point) const { return any() ? to_body(start_pose(number), point) : point; }
  Vec3 turned_back(int number, Vec3 v) const { return any() ? rotate(conjugate(start_pose(number).rotation), v) : v; }

  void begin_step();
  /// All sheets move on evenly for a time [s].
  void advance(double seconds);
  /// A mean force of the structure over the step at a point [N], [m], world.
  void push(int number, Vec3 force, Vec3 point);
  /// Hands the sheets over to the next step of the world, with the loads of structure, water and wind (G3), (G4).
  /// @param dt  length of the step [s].
  void hand_over(double dt);
  /// Takes their velocities back (G1), (G2). @return the work of these loads (G5).
  WorkOnSheets take_back(double dt);

  /// The pushes of the structure so far move a sheet that is about to become a floe. @return their work [J].
  double take_pushes(int number, double dt);
  /// The next sheet is a piece of another, and moves as it does.
  void add_part(const ice::Plate& plate, int parent);

  double kinetic_energy() const;
  double kinetic_energy(int number) const { return any() ? kinetic(at(number)) : 0.0; }
  /// Each sheet, by its number.
  std::vector<model::SheetMotion> motions() const;

  void save(model::Checkpoint& checkpoint) const;
  void restore(std::span<const ice::Plate> level_ice, const model::Checkpoint& checkpoint);

 private:
  struct Push {
    Vec2 force{};         ///< [N]
    double moment = 0.0;  ///< about the centre [N m]
  };
  struct Sheet {
    BodyId id;
    Drift now, start;
    SheetBody body;
    Push of_structure, form, skin, wind;
  };
  const Sheet& at(int number) const { return sheets_.at(static_cast<std::size_t>(number)); }
  static Pose pose_of(const Drift& drift);
  static double kinetic(const Sheet& sheet);
  void load_by_water(Sheet& sheet, double dt) const;
  void load_by_wind(Sheet& sheet) const;

  const model::Case* case_;
  rigid_body::World* world_;
  bool drift_;
  std::vector<Sheet> sheets_;
};

}  // namespace brash::edge
