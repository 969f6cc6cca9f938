// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "brash/core/vec.hpp"
#include "convex_part.hpp"
#include "corners.hpp"

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

/// A translation of a along the normal of a face of either that ends the overlap with b.
struct WayOut {
  Vec3 normal{};       ///< unit, from b into a
  double depth = 0.0;  ///< length of the translation [m]
};

/// The common solid of two convex parts.
struct Overlap {
  std::vector<Vec3> vertices;  ///< its corners, some more than once; empty: the parts do not overlap
  std::vector<WayOut> ways;    ///< one for each face of both, in no order of length
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
  /// Corners of a cut with b. Only faces whose plane passes through the other part are clipped (all others contribute
  /// nothing that they do not share with a face that does), so a hull of many facets costs one sign test per vertex
  /// and facet.
  const Overlap& find(const PlacedPart& a, const PlacedPart& b);

  /// Projects the last overlap along `normal` (unit).
  ///
  /// The points are the corners of the projection at mid-depth. Corner i has the area of the two triangles beside it in
  /// the fan from the centroid, halved: the shares add up to the area and have its centroid, so that a contact that
  /// bears its bound everywhere is loaded as by a uniform pressure. Neighbours are merged (shares added, place weighted
  /// by them, which keeps both) while more than four are left or two are near each other: a narrow strip has two
  /// points.
  const Patch& project(Vec3 normal);

 private:
  bool cull(const PlacedPart& solid, const PlacedPart& other, bool solid_is_b, std::vector<int>& cutting);
  void add_faces(const PlacedPart& a, std::span<const int> faces, const PlacedPart& b, std::span<const int> cutting);
  void hull_2d();
  void lump(double u0, double v0);
  double diameter() const;

  Overlap overlap_;
  Patch patch_;
  std::vector<int> cutting_a_;
  std::vector<int> cutting_b_;
  std::vector<Vec3> polygon_;
  std::vector<Vec3> clipped_;
  std::vector<Vec2> plane_points_;
  std::vector<Vec2> hull_;
  std::vector<double> shares_;
};

/// How far a reaches into b along `normal` (from b into a) [m]; negative when they are apart along it.
double depth_along(const PlacedPart& a, const PlacedPart& b, Vec3 normal);

/// Area of the projection of the overlap of a and b on the plane normal to `normal` [m2].
double overlap_area(const PlacedPart& a, const PlacedPart& b, Vec3 normal);

PlacedPart placed(const ConvexPart& part, const Pose& pose);
void update(PlacedPart& part, const Pose& pose);

}  // namespace brash::rigid_body
