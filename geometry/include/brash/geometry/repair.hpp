// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"

namespace brash::geometry {

/// Something that keeps polygons from being a sheet.
struct Fault {
  std::size_t first, second;  ///< numbers of the polygons; twice the same one for a fault of its own
  std::string what;           ///< such as "polygon 0 crosses polygon 1 at (5, 10)"
};

/// All faults: of each polygon on its own, then of pairs that cross or overlap. IceSheet::from_polygons() takes
/// polygons without any.
std::vector<Fault> faults_of(std::span<const Polygon> polygons);

/// The faults of each polygon on its own; fault_of() has them without numbers.
std::vector<Fault> own_faults_of(std::span<const Polygon> polygons);

/// Faults in words, twenty at most, parted by semicolons; empty: there are none.
std::string text_of(std::span<const Fault> faults);

/// Polygons without faults and the account of their areas: `given = kept + overlap + folded + snap`, exactly.
struct Repair {
  /// A polygon of the result.
  struct Part {
    Polygon polygon;
    std::size_t from;  ///< number of the polygon that it is of
  };
  std::vector<Part> parts;           ///< in the order of `from`; simple and apart, but for common vertices and edges
  std::vector<std::size_t> changed;  ///< numbers of the polygons whose shape is another one
  std::vector<std::size_t> gone;     ///< numbers of the changed polygons that have no part
  std::vector<Fault> faults;         ///< that were repaired
  ExactArea given;                   ///< of the polygons that came in, each as its rings run
  ExactArea kept;                    ///< of the parts
  ExactArea overlap;                 ///< of places that c polygons cover, c - 1 times
  ExactArea folded;                  ///< that outlines which cross themselves count wrongly
  ExactArea snap;                    ///< that the rounding of crossings moved out of other polygons

  ExactArea missing() const { return given - (kept + overlap + folded + snap); }
  bool closes() const { return missing() == ExactArea{}; }
};

/// Removes the faults of polygons. Polygons far from a fault stay as they are.
///
/// A place is ice of a polygon if its outline winds around it and none of its holes does. A place of several polygons
/// goes to the first of these polygons. New vertices are rounded to the grid, for all polygons there at once. The cost
/// grows with the square of the edges of polygons that lie together and are at fault.
///
/// @param polygons  any; rings within the grid.
/// @return the repair, or why there is none.
/// @see docs/theory/geometry.md, (4).
tl::expected<Repair, GeometryError> repair(std::span<const Polygon> polygons);

}  // namespace brash::geometry
