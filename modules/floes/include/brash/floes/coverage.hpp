// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/floes/floe_population.hpp"
#include "brash/model/records.hpp"
#include "brash/rigid_body/world.hpp"
#include "brash/structure/hull.hpp"
#include "brash/structure/regions.hpp"

namespace brash::floes {

/// Shares of the wetted surface of each region that floes cover [-].
using CoveredShares = std::array<double, model::kHullRegions>;

/// How much of a ship's wetted hull lies under floes: a place of the hull is covered when the point half an ice
/// thickness out from it lies in a floe. docs/theory/structures.md, (K9).
class Coverage {
 public:
  /// @param hull       with regions; its mesh below z = 0 is the wetted surface.
  /// @param thickness  of the ice [m].
  Coverage(const structure::Hull& hull, const structure::Regions& regions, double thickness);

  /// @param structure  pose of the hull.
  CoveredShares by(const rigid_body::World& world, const FloePopulation& floes, const Pose& structure) const;

 private:
  /// A small piece of the hull.
  struct Place {
    Vec3 ahead{};        ///< half a thickness out from its middle, hull's frame [m]
    double area = 0.0;   ///< [m2]
    std::size_t region;  ///< model::HullRegion
  };
  /// The places in a cube.
  struct Cell {
    Vec3 centre{};        ///< hull's frame [m]
    double radius = 0.0;  ///< of a sphere that holds the cube [m]
    std::vector<std::size_t> places;
  };
  void gather_cells(double side);
  void mark_under(const Prism& prism, const Pose& pose, const Pose& structure, std::vector<char>& marks) const;

  std::vector<Place> places_;
  std::vector<Cell> cells_;  ///< from stern to bow
  CoveredShares area_{};     ///< of each region [m2]
  double reach_ = 0.0;       ///< from the hull's origin to the farthest place [m]
};

}  // namespace brash::floes
