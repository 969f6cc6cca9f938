// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "brash/floes/floe_population.hpp"
#include "brash/hydrodynamics/structure_flow.hpp"
#include "brash/hydrodynamics/water.hpp"
#include "brash/hydrodynamics/wind.hpp"
#include "brash/structure/motion.hpp"

namespace brash::floes {

/// Water on floes: weight, buoyancy, drag (Eqs. 13, 14), added mass, air on their tops and the structure's flow.
class FloeWater {
 public:
  explicit FloeWater(const model::Case& resolved);

  /// Loads every floe that is awake for the next step of `dt` [s].
  /// @param structure  where it is and how it moves: the water gives way to it (hydrodynamics.structure_flow).
  void apply(rigid_body::World& world, FloePopulation& floes, double dt, const structure::State& structure) const;

  /// How far around a floe other ice matters to the water on it [m].
  double reach() const { return hydrodynamics::kShadingReach * water_.shading_gap; }

 private:
  /// The structure's flow as a floe meets it; with legs, the flow of the nearest one alone.
  struct Flow {
    Vec3 velocity{};      ///< [m/s]
    Vec3 acceleration{};  ///< Du/Dt [m/s2]
  };
  Flow flow_at(Vec3 position, const structure::State& structure) const;
  /// The water around each moving floe, its added mass and the air on its top, at the start of a step of `dt` [s].
  void meet(rigid_body::World& world, BodyId body, Floe& floe, double dt, const structure::State& structure) const;
  /// The water that a floe meets.
  hydrodynamics::Water around(const Floe& floe) const;
  /// Loads a floe, if its drag follows from the kept one. @return whether it is to be computed.
  bool load(rigid_body::World& world, BodyId body, Floe& floe, double dt, const structure::State& structure) const;
  /// Applies weight and the load of the water to a floe that has `drag` at its velocity.
  void apply_to(rigid_body::World& world, BodyId body, Floe& floe, double dt, const hydrodynamics::Drag& drag) const;
  /// Computes the drag of the floes `due`, whose neighbours are sought together.
  void renew_drag(rigid_body::World& world, FloePopulation& floes, const std::vector<BodyId>& due, double dt) const;

  const model::Case* case_;
  hydrodynamics::Water water_;
  hydrodynamics::Wind wind_;
  std::optional<hydrodynamics::StructureFlow> flow_;
  std::vector<Pose> ellipsoids_;  ///< of the flow around each leg, structure's frame
};

/// Gives a floe the added mass of its wet part, by hydrodynamics.added_mass_law, and books the kinetic energy that this
/// takes in Floe::shed. Added mass that leaves keeps its velocity. Added mass that comes moves with the water and takes
/// its share of the momentum, as in an impact on water (docs/theory/water.md, (H19)).
///
/// @param stream  velocity of the water there [m/s].
void take_added_mass(rigid_body::World& world, BodyId body, Floe& floe, const model::Case& resolved, Vec3 stream);

}  // namespace brash::floes
