// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "brash/geometry/polygon.hpp"

namespace brash::geometry {

/// A straight crack inside the region that is cut.
struct Crack {
  Point from;
  Point to;
};

/// The result of one cut. Afterwards sheet, pieces and detached parts tile the old sheet:
/// `area before = area after + pieces + detached + snap`, exactly; docs/theory/geometry.md, (2).
struct Cut {
  /// The ice inside the region, split by the cracks: one simple polygon a piece.
  std::vector<Polygon> pieces;
  /// Area that the rounding of crossings to the grid moved out of (or into, negative) the ice; computed from the
  /// re-routed edges, not as a remainder.
  ExactArea snap;
  /// How many vertices rounding to the grid made, or led an edge of the ice to. It is above 0 where `snap` is not 0.
  std::int64_t n_rounded = 0;
  /// Around all free edges that went or came: more than the pieces, for an edge that is cut is moved as a whole by the
  /// rounding of the crossing.
  Extent changed{};
};

/// Why a sheet could not be made or cut.
struct GeometryError {
  std::string what;
};

/// One connected overlap of a structure's section with the ice.
///
/// The overlap's outline is made of free edge (ice ends there) and of the section's boundary (ice continues there).
/// Where the two alternate more than once, the longest run of free edge is the front and everything else counts as one
/// chord. Two overlaps have no chord: a section wholly surrounded by ice (no free edge on the outline) and a part of
/// the ice wholly inside the section (nothing else). Then contact_length = 0 and normal = 0: the ice pushes to no one
/// side.
struct ContactRegion {
  /// The overlap itself.
  Polygon overlap;
  /// Where the section's boundary enters and leaves the ice, counter-clockwise along the section [m].
  Vec2 chord_from;
  Vec2 chord_to;
  /// |chord_to - chord_from| [m]: the contact length c.
  double contact_length = 0.0;
  /// Collision point B: the middle by arc length of the free edge within the section, on that edge [m]; the centroid of
  /// the overlap where there is no free edge.
  Vec2 midpoint;
  /// Unit normal of the chord, from the structure into the ice.
  Vec2 normal;
};

/// The ice sheet: its free edges as an exact polygon set on the grid, with a spatial index.
///
/// Every cut is exact up to the rounding of new crossings to the grid (2^-30 m), which is counted. The cost of a cut
/// or a query depends on the edges near it, not on the size of the sheet.
class IceSheet {
 public:
  /// @param polygons  the ice, any orientation; simple and disjoint.
  /// @return the sheet, or which polygon is at fault and where.
  static tl::expected<IceSheet, GeometryError> from_polygons(std::span<const Polygon> polygons);

  IceSheet(IceSheet&&) noexcept;
  IceSheet& operator=(IceSheet&&) noexcept;
  ~IceSheet();

  ExactArea area() const;
  std::size_t n_vertices() const;
  /// How many connected parts it has. Costs nothing.
  std::size_t n_parts() const;
  /// The connected parts, each with its holes; sorted by the smallest vertex of the outline.
  std::vector<Polygon> polygons() const;
  bool contains(Vec2 point) const;

  /// Takes the ice inside `region` (simple, counter-clockwise) out of the sheet and splits it along `cracks`.
  ///
  /// Cuts that disconnect the sheet, touch it, run along its edges, swallow whole parts or meet no ice are defined
  /// outcomes. Cracks count inside the region only; a crack that splits no piece leaves no trace. Pieces are sorted
  /// by the smallest vertex of their outline, with which it starts. Parts that touch in a vertex only are separate;
  /// holes may touch their outline and each other in vertices.
  /// @throws ContractViolation when the region is not such a ring or the areas do not close; the sheet is unchanged.
  Cut cut(std::span<const Point> region, std::span<const Crack> cracks = {});

  /// As cut(), for ice that is crushed: vertices at which the new edges go on straight within the rounding are removed,
  /// so a side that regions move along stays one edge. `snap` holds the area; the pieces may miss the sheet by as much.
  Cut crush(std::span<const Point> region);

  /// Takes every part but the largest out of the sheet: ice that a cut has broken off. Costs nothing while the sheet
  /// hangs together, and the number of loops when it does not.
  std::vector<Polygon> release_detached();

  /// Takes every part of which `is_loose` holds out of the sheet. The only part of a sheet stays, and is not asked
  /// about.
  std::vector<Polygon> release_if(const std::function<bool(const Polygon&)>& is_loose);

  /// The overlaps of the simple counter-clockwise `section` with the ice, sorted by the angle of their midpoint about
  /// the mean of the section's vertices.
  ///
  /// A hollow section may meet the ice in several places, each an overlap of its own; so are overlaps that share only a
  /// vertex.
  /// @throws ContractViolation when the section crosses itself or runs clockwise.
  std::vector<ContactRegion> contacts(std::span<const Point> section) const;

  /// The ice inside the simple counter-clockwise `window`, without taking it.
  std::vector<Polygon> within(std::span<const Point> window) const;

  /// The free edge near a point: the chains of ice boundary within `radius` of `at`, ended on that circle, as polylines
  /// with ice on the left [m], the one nearest to `at` first. A closed chain repeats its first point.
  std::vector<std::vector<Vec2>> free_edge(Vec2 at, double radius) const;

  /// Reads everything and throws ContractViolation unless the whole sheet keeps the promises of the cuts: loops are
  /// closed and their sums right, edges meet in vertices only, none runs through the pixel of another vertex, ice is
  /// on the left.
  void check() const;

 private:
  struct Impl;
  explicit IceSheet(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// A region to cut out, and the cracks that divide it.
struct CrackedRegion {
  Ring region;  ///< simple, counter-clockwise
  std::vector<Crack> cracks;
};

/// Plans the circle and the even radial cracks of cut_circumferential() without cutting.
CrackedRegion circumferential(const IceSheet& sheet, Vec2 centre, double radius, int n_wedges, int sides = 16);

/// Cuts the ice within `radius` of `centre` free and divides it by radial cracks.
///
/// The circle becomes a polygon of `sides` chords with a vertex where each crack ends. `n_wedges - 1` radial cracks
/// share the span of the arc that lies in ice. Inside the ice one more runs through the arc's gap, or closes the turn.
/// A hole that reaches across a wedge divides it further.
///
/// @param centre    collision point B on the free edge, sheet frame [m].
/// @param radius    breaking length l_break [m], > 0.
/// @param n_wedges  number of wedges, 3 to 5 (Nevel), at least 1 [-].
/// @param sides     chords of the full circle, at least 3.
/// @see paper, Sec. 2.2.2, Fig. 2.
Cut cut_circumferential(IceSheet& sheet, Vec2 centre, double radius, int n_wedges, int sides = 16);

/// The same with radial cracks at the given `angles` [rad], counter-clockwise from x.
Cut cut_circumferential(IceSheet& sheet, Vec2 centre, double radius, std::span<const double> angles, int sides = 16);

/// Splits `floe` along the line through `from` and `to`.
Cut split(const Polygon& floe, Point from, Point to);

}  // namespace brash::geometry
