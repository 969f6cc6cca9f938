// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "brash/structure/floating_body.hpp"
#include "brash/structure/motion.hpp"
#include "mooring.hpp"

namespace brash::structure {

/// A rigid body afloat under weight, buoyancy, damping, thrust, ice and, if it has one, a mooring: the leapfrog of
/// docs/theory/structures.md, (B2) to (B6). The ice's load of one step acts, evenly, in the next one. Within a step the
/// body goes straight and turns evenly.
class BodyMotion final : public Motion {
 public:
  /// The loads about the body, beside the ice's.
  struct Surroundings {
    const Hull& hull;
    double water_density = 0.0;  ///< [kg/m3]
    Vec2 current{};              ///< of the water past the ice [m/s]
    double time_step = 0.0;      ///< [s]
  };

  /// @throws InputError when the hull displaces no water, or the step is too long for the body on its restoring loads.
  BodyMotion(const model::FloatingBody& body, const std::optional<model::Moored>& moored, const State& start,
             const Surroundings& surroundings);

  State after(double share) const override;
  void advance(double share) override;
  void bear(const Wrench& load) override;
  Vec2 course() const override;
  model::BodyEnergy energy() const override { return energy_; }
  std::vector<NaturalMode> natural_modes() const override;
  Settling settling() const override;
  void save(model::Checkpoint& checkpoint) const override;
  void restore(const model::Checkpoint& checkpoint) override;

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("velocity_", "m s-1", "of the centre of gravity against the water in the coming step, body axes",
          self.velocity_);
    visit("spin_", "rad s-1", "in the coming step, body axes", self.spin_);
    visit("foot_", "m", "path of the mooring's feet", self.foot_);
    visit("ice_force_", "N", "of the ice in the coming step", self.ice_.force);
    visit("ice_moment_", "N m", "the same, about the centre of gravity", self.ice_.moment);
    visit("anchor_power", "W", "of the mooring's feet, at the last look", self.anchor_power_);
    visit("initial", "J", "kinetic energy at the start", self.initial_);
    model::BodyEnergy::visit([&](const char* name, const char* meaning, double model::BodyEnergy::*energy) {
      visit(name, "J", meaning, self.energy_.*energy);
    });
  }

 private:
  /// Momentum [N s] and angular momentum about the centre of gravity [N m s], sheet axes; of the water too.
  struct Momenta {
    Vec3 linear{}, angular{};
  };
  /// Weight, buoyancy, mooring and thrust at a pose, and their energies.
  struct Loads {
    Wrench load;  ///< about the centre of gravity, sheet axes
    double hydrostatic = 0.0, mooring = 0.0;
    double anchor_power = 0.0;  ///< of the mooring's feet through the water [W]
  };

  Loads loads_at(const Pose& pose) const { return loads_at(pose, body_.thrust); }
  Loads loads_at(const Pose& pose, Vec3 thrust) const;
  /// Damping and the turning moment of the added mass at the present velocities, body axes.
  Wrench water_load() const;
  Momenta momenta(const Quaternion& attitude) const;
  double kinetic(const Momenta& momenta, const Quaternion& attitude) const;
  /// The velocities with which the body leaves the present pose with the momenta `p`, but for half a step of the
  /// water's load, and the step's mean motion.
  void leave_with(const Momenta& p);
  /// Works of the step that ends.
  void book_works(const Loads& loads);
  /// Stiffness of the loads under `thrust` [N] about the present pose, over the roots of the masses of its row and
  /// column: surge, sway, heave, roll, pitch, yaw; sheet axes [1/s2].
  std::array<std::array<double, 6>, 6> stiffness_over_mass(Vec3 thrust) const;
  void expect_stable(double time_step) const;

  const Hull* hull_;
  Inertia inertia_;
  model::FloatingBody body_;
  std::optional<Mooring> mooring_;
  double density_;
  Vec3 current_;
  Vec3 feet_;         ///< velocity of the mooring's feet [m/s]
  double time_step_;  ///< [s]
  Vec3 mass_;         ///< with the added mass, body axes [kg]
  Vec3 moments_;      ///< with the added inertia, body axes [kg m2]
  double hydrostatic_at_start_ = 0.0, mooring_at_start_ = 0.0;

  Vec3 velocity_{};  ///< of the centre of gravity against the water in the coming step, body axes [m/s]
  Vec3 spin_{};      ///< in the coming step, body axes [rad/s]
  Vec3 foot_{};      ///< way of the mooring's feet [m]
  Wrench ice_;       ///< in the coming step, about the centre of gravity
  double anchor_power_ = 0.0, initial_ = 0.0;
  model::BodyEnergy energy_;
};

}  // namespace brash::structure
