// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <tl/expected.hpp>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"

namespace brash::geometry {

/// The union of polygons and the account of their areas: `given = united + overlap + snap`, exactly.
struct Union {
  /// Simple and apart, but for common vertices. Sorted by the smallest vertex of the outline, with which it starts.
  std::vector<Polygon> polygons;
  ExactArea given;    ///< of the polygons that came in
  ExactArea united;   ///< of the union
  ExactArea overlap;  ///< of places that c polygons cover, c - 1 times
  /// Area that the rounding of crossings moved out of the polygons; of the edges that it moved, not a remainder.
  ExactArea snap;
  std::int64_t n_rounded = 0;  ///< crossings that became vertices, each rounded to the grid

  ExactArea missing() const { return given - (united + overlap + snap); }
  bool closes() const { return missing() == ExactArea{}; }
};

/// Unites polygons. They may overlap, touch, share edges, lie in each other's holes or be there twice.
///
/// @param polygons  each simple on its own, any orientation.
/// @return the union, or the error of the polygon that is not simple.
tl::expected<Union, GeometryError> unite(std::span<const Polygon> polygons);

/// A polygon that rounding its vertices to the grid had made cross itself, made simple again.
struct Repaired {
  std::vector<Polygon> parts;  ///< as of Union; none where nothing was wider than the grid
  ExactArea changed;           ///< covered otherwise than once before
};

/// Leads the edges of `polygon` through the pixels of their crossings, and drops whiskers, which have no area left.
/// @return nothing where its faults are larger than rounding makes them: more than four grid units beside its edges.
std::optional<Repaired> without_round_off(const Polygon& polygon);

}  // namespace brash::geometry
