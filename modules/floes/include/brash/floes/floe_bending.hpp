// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "brash/floes/floe_population.hpp"
#include "brash/floes/sections.hpp"
#include "brash/model/checkpoint.hpp"

namespace brash::floes {

/// A floe that bends more than its ice can take, and the section in which it splits.
struct Fracture {
  BodyId body;
  Section section;
  double tension = 0.0;  ///< mean, in the upper or lower face [Pa]
};

/// The loads in the sections of awake floes, each averaged over its floe's collision time
/// (docs/theory/fracture-of-floes.md).
class FloeBending {
 public:
  /// Averages over a step of `dt` [s].
  /// @param contacts  contacts_by_place().
  void average(const rigid_body::World& world, const FloePopulation& floes,
               const std::vector<const rigid_body::ContactLoad*>& contacts, double dt);

  /// Floes whose tension exceeds their flexural strength, each with its most stressed section, sorted by body.
  std::vector<Fracture> fractures(const FloePopulation& floes) const;

  /// The floe no longer exists.
  void forget(BodyId floe) { floes_.erase(floe); }

  void save(const FloePopulation& floes, model::Checkpoint& checkpoint) const;
  void restore(const FloePopulation& floes, const model::Checkpoint& checkpoint);

 private:
  struct Bent {
    Sections sections;
    std::vector<SectionLoad> mean;  ///< of each section

    void approach(std::span<const PointForce> forces, double share);
    double largest_tension() const;
  };

  std::map<BodyId, Bent> floes_;  ///< those with contacts now or not long ago
};

}  // namespace brash::floes
