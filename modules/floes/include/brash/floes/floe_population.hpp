// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "brash/core/prism.hpp"
#include "brash/floes/floe_stress.hpp"
#include "brash/floes/kept_drag.hpp"
#include "brash/hydrodynamics/added_mass.hpp"
#include "brash/hydrodynamics/water.hpp"
#include "brash/ice/plate.hpp"
#include "brash/model/case.hpp"
#include "brash/model/checkpoint.hpp"
#include "brash/model/records.hpp"
#include "brash/rigid_body/world.hpp"
#include "brash/structure/motion.hpp"

namespace brash::floes {

/// Floes that a thread takes at a time in loops of some 0.2 us for each.
constexpr std::size_t kCheapFloes = 64;

/// How near a floe is to rest, and the push that would wake it.
struct Rest {
  double slow_for = 0.0;  ///< it has been slower than time.settle_speed for so long [s]
  bool asleep = false;    ///< it is fixed where it is
  Vec3 push{};            ///< by how much the mean force of other floes on it has changed since it fell asleep [N]

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("slow_for", "s", "time since it became slow", self.slow_for);
    visit("asleep", "1", "whether it is fixed where it is", self.asleep);
    visit("push_", "N", "change of the mean force of other floes since it fell asleep", self.push);
  }
};

/// A plate afloat, with the data that each stage of a step keeps of it.
struct Floe {
  std::int64_t id = 0;
  ice::Plate plate;  ///< in the frame of the level ice that it broke off
  Prism prism{};
  Pose laid{};  ///< in which the prism lies on the outline of the plate
  geometry::ExactArea area{};
  rigid_body::MassProperties inertia{};  ///< with added mass, as far as it is wet
  double wet_share = 1.0;                ///< of the added mass that it has [-]
  hydrodynamics::AddedMass added{};      ///< of AddedMassLaw::kPlate, both faces wet
  double ran_in = 0.0;                   ///< how far water has run in over its top [m]
  double flooded = 1.0;                  ///< share of the part of its top below the waterplane that is wet [-]
  double shed = 0.0;                     ///< kinetic energy that it left to the water with added mass in this step [J]
  double weight = 0.0;                   ///< m g, without added mass [N]
  double rest_potential = 0.0;           ///< potential energy floating at rest [J]
  double collision_time = 0.0;           ///< T_col of Eqs. 11, 12 [s]
  Vec3 stream{};                         ///< velocity of the water around it [m/s]
  KeptDrag kept_drag{};
  Wrench drag{};                   ///< of the last step, form and rotational, about the centre of mass
  Wrench skin_friction{};          ///< of the last step, about the centre of mass
  Wrench pressure{};               ///< as `skin_friction`, of accelerated water and of the air on its top
  MeanStress stress{};             ///< from contact forces
  std::array<double, 6> dipole{};  ///< of the last step: sum of arm x force, symmetric part, as MeanStress::now [N m]
  double contact_pressure = 0.0;   ///< of the last step: the largest normal force of a contact over its area [Pa]
  double compression = 0.0;        ///< that StressLaw compares with the strength, after the last step [Pa]
  Rest rest{};
  double asleep_height = 0.0;  ///< potential energy against floating at rest while it is asleep [J]
  /// Cache: the last pose at which the displacement was asked for, and the displacement there.
  mutable std::optional<std::pair<Pose, hydrodynamics::Displacement>> wet{};

  /// The members that do not follow from its plate.
  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("id", "1", "floe_id of the floe", self.id);
    visit("wet_share", "1", "share of the added mass that it has", self.wet_share);
    visit("ran_in", "m", "how far water has run in over its top", self.ran_in);
    KeptDrag::visit(self.kept_drag, visit);
    MeanStress::visit(self.stress, visit);
    Rest::visit(self.rest, visit);
  }
};

/// The displacement of `floe` at `pose`.
const hydrodynamics::Displacement& displaced(const Floe& floe, const Pose& pose);

/// Mass and inertia of `floe` with the share Floe::wet_share of the added mass.
rigid_body::MassProperties inertia_of(const Floe& floe, const model::Case& resolved);

/// T_col = (pi/2) sqrt((1 + alpha) m / K) of a floe of `mass` [kg], Eqs. 11, 12 [s].
double collision_time(const model::Case& resolved, double mass);

/// Weight of a step of `dt` [s] in means over the floe's collision time [-].
double averaging_share(const Floe& floe, double dt);

/// All floes present, by their bodies: births, deaths, sums and energies.
class FloePopulation {
 public:
  explicit FloePopulation(const model::Case& resolved) : case_(&resolved) {}

  /// Gives `plate` a body that floats where its outline is, at rest or with the ice.
  /// @param ice  the frame of the outline, and how it moves; nothing: the world's, at rest.
  /// @return its record; nothing when it is too thin for a body, and `plate` is then left as it is.
  std::optional<model::FloeRecord> add(rigid_body::World& world, ice::Plate&& plate, double time,
                                       const std::optional<structure::State>& ice = std::nullopt);
  /// Gives `plate`, a piece of the floe `parent`, a body that moves on as the parent did.
  /// @param pose, twist  of the parent's body, which is gone.
  /// @return as add().
  std::optional<model::FloeRecord> add_piece(rigid_body::World& world, ice::Plate&& plate, const Floe& parent,
                                             const Pose& pose, const Twist& twist, double time);
  Floe remove(rigid_body::World& world, BodyId body);

  void save(const rigid_body::World& world, model::Checkpoint& checkpoint) const;
  /// Gives the floes of an earlier run their bodies back.
  void restore(rigid_body::World& world, std::span<const ice::Plate> level_ice, const model::Checkpoint& checkpoint);

  const std::map<BodyId, Floe>& floes() const { return floes_; }
  bool contains(BodyId body) const { return body.index < by_body_.size() && by_body_[body.index] != nullptr; }
  /// The floe whose body is `body`, one that is there.
  const Floe& at(BodyId body) const { return *by_body_[body.index]; }
  Floe& at(BodyId body) { return *by_body_[body.index]; }
  std::map<std::int64_t, BodyId> bodies_by_id() const;
  std::int64_t next_id() const { return next_id_; }
  /// Of all floes together.
  const geometry::ExactArea& area() const { return area_; }
  double weight() const { return weight_; }  ///< [N]

  /// Fixes a floe where it is.
  void put_to_sleep(rigid_body::World& world, BodyId body);
  /// To be called when a floe has woken: the potential energy of floes asleep is added up again when it is asked for.
  void forget_asleep_height() { asleep_height_.reset(); }

  /// Potential energy of weight and buoyancy against floating at rest [J].
  double potential_energy(const rigid_body::World& world) const;
  /// Kinetic and potential energy of `floe`, whose body is `body` [J].
  double energy(const rigid_body::World& world, BodyId body, const Floe& floe) const;

  /// Potential energy that the last step gave a floe by parting it from bodies that it overlapped [J].
  double gained_by_parting(const rigid_body::World& world, BodyId body) const;

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("next_id", "1", "floe_id of the next floe", self.next_id_);
  }

 private:
  /// Completes a floe that has its plate. @return whether it is thick enough in plan for a body.
  bool complete(Floe& floe) const;
  /// Gives a complete floe the next id and a body. @return its record, of a floe born at `time` [s].
  model::FloeRecord launch(rigid_body::World& world, Floe floe, const Pose& pose, const Twist& twist, double time);
  void insert(BodyId body, Floe floe);
  double asleep_height() const;
  /// Potential energy against floating at rest [J].
  double raised(const rigid_body::World& world, BodyId body, const Floe& floe) const;

  const model::Case* case_;
  std::map<BodyId, Floe> floes_;
  std::vector<Floe*> by_body_;  ///< by the index of the body
  geometry::ExactArea area_;    ///< of all
  double weight_ = 0.0;         ///< of all [N]
  /// Potential energy of all that are asleep, against floating at rest [J]; nothing where one has changed since.
  mutable std::optional<double> asleep_height_;
  std::int64_t next_id_ = 0;
};

}  // namespace brash::floes
