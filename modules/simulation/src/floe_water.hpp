// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "brash/hydrodynamics/structure_flow.hpp"
#include "brash/hydrodynamics/water.hpp"
#include "brash/structure/motion.hpp"
#include "floe_population.hpp"

namespace brash::simulation {

/// Water on floes: weight, buoyancy and drag (Eqs. 13, 14).
class FloeWater {
 public:
  explicit FloeWater(const model::Case& resolved);

  /// Loads every floe that is awake for the next step of `dt` [s].
  /// @param structure  where it is and how it moves: the water gives way to it (hydrodynamics.structure_flow).
  void apply(rigid_body::World& world, FloePopulation& floes, double dt, const structure::State& structure);

  /// How far around a floe other ice matters to the water on it [m].
  double reach() const { return hydrodynamics::kShadingReach * water_.shading_gap; }

 private:
  /// The water that a floe at `position` meets.
  hydrodynamics::Water at(Vec3 position, const structure::State& structure) const;
  /// Computes the drag of the floes `due_`, whose neighbours are sought together.
  void renew_drag(rigid_body::World& world, FloePopulation& floes, double dt, const structure::State& structure);

  const model::Case* case_;
  hydrodynamics::Water water_;
  std::optional<hydrodynamics::StructureFlow> flow_;
  std::vector<BodyId> due_;  ///< floes whose drag is to be computed
};

}  // namespace brash::simulation
