// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "bearing.hpp"
#include "brash/core/prism.hpp"
#include "brash/geometry/polygon.hpp"
#include "brash/hydrodynamics/structure_flow.hpp"
#include "brash/hydrodynamics/water.hpp"
#include "brash/model/case.hpp"
#include "brash/model/checkpoint.hpp"
#include "brash/model/records.hpp"
#include "brash/rigid_body/world.hpp"
#include "kept_drag.hpp"
#include "mean_pushes.hpp"

namespace brash::simulation {

/// How near a floe is to rest, and what would end it.
struct Rest {
  double slow_for = 0.0;  ///< it has been slower than time.settle_speed for so long [s]
  bool settled = false;   ///< it is fixed where it is
  Vec3 push{};            ///< by how much the mean force of other floes on it has changed since it was settled [N]

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("slow_for", "s", "time since it became slow", self.slow_for);
    visit("settled", "1", "whether it is fixed where it is", self.settled);
    visit("push_", "N", "change of the mean force of other floes since it was settled", self.push);
  }
};

/// Of one floe's contacts in one step.
struct ContactSums {
  std::array<double, 6> dipole{};  ///< symmetric part of arm x force (xx, yy, zz, xy, yz, zx) [N m]
  Bearing bearing{};               ///< on the sheet's edge
};

/// A free piece of ice.
struct Floe {
  std::int64_t id = 0;
  geometry::Polygon outline;  ///< where it broke off, sheet frame
  Prism prism;
  geometry::ExactArea area;
  rigid_body::MassProperties inertia{};  ///< with added mass
  double weight = 0.0;                   ///< m g, without added mass [N]
  double rest_potential = 0.0;           ///< potential energy floating at rest [J]
  double collision_time = 0.0;           ///< T_col of Eqs. 11, 12 [s]
  /// Mean stress (xx, yy, zz, xy, yz, zx) from contact forces, averaged over T_col; tension positive [Pa].
  std::array<double, 6> stress{};
  double peak_compression = 0.0;  ///< [Pa]
  Bearing bearing{};              ///< on the sheet's edge, averaged over T_col
  Rest rest{};
  double settled_height = 0.0;  ///< potential energy against floating at rest while it is settled [J]
  KeptDrag kept_drag{};
  Wrench drag{};           ///< of the last step, form and rotational, about the centre of mass
  Wrench skin_friction{};  ///< likewise
  ContactSums in_step{};   ///< of the last step, while it moves
  /// Where it was last asked what the floe displaces, and that.
  mutable std::optional<std::pair<Pose, hydrodynamics::Displacement>> wet{};

  /// What follows from nothing else.
  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("id", "1", "floe_id of the floe", self.id);
    visit("outline", "1", "outline where it broke off, sheet frame", self.outline);
    visit("stress_xx", "Pa", "mean stress", self.stress[0]);
    visit("stress_yy", "Pa", "mean stress", self.stress[1]);
    visit("stress_zz", "Pa", "mean stress", self.stress[2]);
    visit("stress_xy", "Pa", "mean stress", self.stress[3]);
    visit("stress_yz", "Pa", "mean stress", self.stress[4]);
    visit("stress_zx", "Pa", "mean stress", self.stress[5]);
    visit("peak_stress", "Pa", "largest compression so far", self.peak_compression);
    Bearing::visit(self.bearing, visit);
    Rest::visit(self.rest, visit);
    KeptDrag::visit(self.kept_drag, visit);
  }
};

/// All floes present: births, water, the stress that decides about crushing, deaths.
class FloePopulation {
 public:
  explicit FloePopulation(const model::Case& resolved);

  /// Gives `polygon` a body at rest in the level ice. @return its record, or nothing when it is too thin for a body.
  std::optional<model::FloeRecord> add(rigid_body::World& world, const geometry::Polygon& polygon, double time);

  void save(const rigid_body::World& world, model::Checkpoint& checkpoint) const;
  /// Gives the floes of an earlier run their bodies back.
  void restore(rigid_body::World& world, const model::Checkpoint& checkpoint);

  /// Weight, buoyancy and drag on every floe for the next step (Eqs. 13, 14).
  /// @param structure  its centre on the waterplane [m]; the water gives way to it (hydrodynamics.structure_flow).
  void apply_water(rigid_body::World& world, double dt, Vec2 structure);

  /// Mean stress of each floe from the last step's contacts (Love-Weber) and what it presses on the sheet, both
  /// averaged over its collision time T_col.
  void average_contacts(const rigid_body::World& world, double dt);

  /// The sheet has broken within `radius` of `at`: forgets what floes pressed on it there, and lets go the settled
  /// floes that it may have held.
  void sheet_broke(rigid_body::World& world, Vec2 at, double radius);

  /// After a step of the world, which may have let settled floes go.
  void notice_let_go(const rigid_body::World& world);

  /// Lets go the settled floes that others push on more, or less, than when they came to rest, and fixes those that
  /// have been slow for long; for time.settle_speed > 0. docs/theory/simulation.md, (S2).
  /// @param astern  only floes wholly below this x are fixed [m].
  /// @return the kinetic energy that this took [J].
  double settle(rigid_body::World& world, double astern);

  /// Moving floes whose mean compressive stress exceeds `strength` [Pa], sorted by body.
  std::vector<BodyId> overstressed(const rigid_body::World& world, double strength) const;

  Floe remove(rigid_body::World& world, BodyId body);

  /// Potential energy of weight and buoyancy against floating at rest [J].
  double potential_energy(const rigid_body::World& world) const;
  /// Kinetic and potential energy of `floe`, whose body is `body` [J].
  double energy(const rigid_body::World& world, BodyId body, const Floe& floe) const;

  /// How far around a floe other ice matters to the water on it [m].
  double reach() const { return hydrodynamics::kShadingReach * water_.shading_gap; }
  const std::map<BodyId, Floe>& floes() const { return floes_; }
  /// The floe whose body is `body`, one that is there.
  const Floe& at(BodyId body) const { return *by_body_[body.index]; }
  /// Of all floes together.
  const geometry::ExactArea& area() const { return area_; }
  double weight() const { return weight_; }  ///< [N]
  std::int64_t next_id() const { return next_id_; }

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("next_id", "1", "floe_id of the next floe", self.next_id_);
  }

 private:
  /// Completes a floe that has its outline. @return where its body was born; nothing when it is too thin for a body.
  std::optional<Pose> complete(Floe& floe) const;
  void restore_pushes(const model::Table& table);

  /// The kinetic energy of a floe at time.settle_speed [J].
  double slow_energy(const Floe& floe) const;
  /// The water that a floe at `position` meets, the structure being where it is.
  hydrodynamics::Water water_at(Vec3 position, Vec2 structure) const;
  /// Applies weight and what `water` does to a floe that has `drag` at its velocity.
  void apply_water_to(rigid_body::World& world, BodyId body, double dt, const hydrodynamics::Water& water,
                      const hydrodynamics::Drag& drag);
  /// The force that would bring a mass [kg] to time.settle_speed in the time of coming to rest [N].
  double slow_push(double mass) const;
  void let_go(rigid_body::World& world, BodyId body, Floe& floe);
  /// The floe is no longer settled.
  void woken(BodyId body, Floe& floe);
  void add_up_settled();
  /// Changes the mean force on a floe since it was settled [N].
  void push(BodyId body, Vec3 change);
  /// Of the settled floes on which the push has changed, those that it may move.
  void let_go_pushed(rigid_body::World& world);
  Floe& at(BodyId body) { return *by_body_[body.index]; }
  void insert(BodyId body, Floe floe);
  /// Potential energy against floating at rest [J].
  double raised(const rigid_body::World& world, BodyId body, const Floe& floe) const;

  const model::Case* case_;
  hydrodynamics::Water water_;
  std::optional<hydrodynamics::StructureFlow> flow_;
  std::vector<BodyId> due_;  ///< scratch of apply_water
  std::map<BodyId, Floe> floes_;
  std::vector<Floe*> by_body_;   ///< by the index of the body
  geometry::ExactArea area_;     ///< of all
  double weight_ = 0.0;          ///< of all [N]
  double settled_height_ = 0.0;  ///< potential energy of all that are settled, against floating at rest [J]
  MeanPushes pushes_;            ///< where floes settle
  std::vector<BodyId> pushed_;   ///< floes whose push has changed since it was looked at
  std::int64_t next_id_ = 0;
};

}  // namespace brash::simulation
