// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "brash/core/vec.hpp"
#include "convex_part.hpp"
#include "corners.hpp"
#include "heights.hpp"

namespace brash::rigid_body {

/// Overlaps thinner than this are touch, not contact [m]: the grid on which the ice's outline lives (2^-30 m).
inline constexpr double kTouch = 0x1p-30;

/// A convex part where it is now.
struct PlacedPart {
  const ConvexPart* part = nullptr;
  std::vector<Vec3> vertices;
  Corners corners;  ///< the vertices once more, for their distances
  std::vector<Plane> planes;
  Vec3 lower{};  ///< axis-aligned box
  Vec3 upper{};
};

/// An axis along which a translation of a ends the overlap with b.
struct SeparatingAxis {
  Vec3 normal{};       ///< unit, from b into a
  double depth = 0.0;  ///< length of the translation [m]
};

/// The common solid of two convex parts.
struct Overlap {
  std::vector<Vec3> vertices;        ///< its corners, some more than once; empty: the parts do not overlap
  std::vector<SeparatingAxis> axes;  ///< one for each face of both, in no order of length
};

/// A point of a contact with its share of the contact's area.
struct PatchPoint {
  Vec3 position{};
  double area = 0.0;
};

/// The overlap seen along the contact normal.
struct Patch {
  double area = 0.0;   ///< of the projection on the plane normal to the contact normal [m2]
  double depth = 0.0;  ///< extent along the normal [m]
  std::array<PatchPoint, 4> points{};
  int n_points = 0;
};

/// Scratch space, so that no call allocates.
class OverlapFinder {
 public:
  /// The overlap's corners are the corners of either part inside the other part, and the points where an edge of one
  /// part passes a face of the other. Only planes that pass through the other part cut its edges, so a hull of many
  /// facets costs one height per facet and vertex.
  const Overlap& find(const PlacedPart& a, const PlacedPart& b);
  /// The part of `a` below the surface of a solid half-space, without axes.
  const Overlap& below(const PlacedPart& a, const Plane& surface);
  const Overlap& last() const { return overlap_; }
  /// Of the last overlap: a's vertices over planes of b, and b's over planes of a.
  const Heights& heights_of_a() const { return of_a_; }
  const Heights& heights_of_b() const { return of_b_; }

  /// Projects the last overlap along `normal` (unit).
  ///
  /// The points are the corners of the projection at mid-depth. Corner i has the area of the two triangles beside it in
  /// the fan from the centroid, halved: the shares add up to the area and have its centroid, so that a contact that
  /// carries its bound everywhere is loaded as by a uniform pressure. Neighbours are merged (shares added, place
  /// weighted by them, which keeps both) while more than four are left or two are near each other: a narrow strip has
  /// two points.
  const Patch& project(Vec3 normal);

 private:
  bool find_axes(const PlacedPart& part, const PlacedPart& other, double outwards, Heights& heights);
  void add_corners(const PlacedPart& part, const Heights& heights);
  void hull_2d();
  void lump(double u0, double v0);
  double diameter() const;

  Overlap overlap_;
  Patch patch_;
  Heights of_a_;
  Heights of_b_;
  Beyond beyond_;
  std::vector<Vec2> plane_points_;
  std::vector<Vec2> hull_;
  std::vector<double> shares_;
};

/// Area of the projection of the overlap of a and b on the plane normal to `normal` [m2].
double overlap_area(const PlacedPart& a, const PlacedPart& b, Vec3 normal);

PlacedPart placed(const ConvexPart& part, const Pose& pose);
void update(PlacedPart& part, const Pose& pose);

}  // namespace brash::rigid_body
