// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "brash/core/plane.hpp"
#include "brash/core/vec.hpp"

namespace brash::rigid_body {

/// Where two faces of a solid meet.
struct Edge {
  int from = 0;  ///< vertices
  int to = 0;
  int left = 0;  ///< faces beside it, seen from outside
  int right = 0;
};

/// A convex solid: its faces' planes, its vertices, each face as a loop of vertices (counter-clockwise from outside),
/// and its edges.
struct ConvexPart {
  std::vector<Vec3> vertices;
  std::vector<Plane> planes;
  std::vector<std::vector<int>> faces;  ///< one loop for each plane
  std::vector<Edge> edges;              ///< in the order of their vertices
};

/// The prism over a convex counter-clockwise plan `ring` [m] between two heights [m].
ConvexPart convex_prism(std::span<const Vec2> ring, double bottom, double top);

/// The convex hull of `points` [m], coplanar points in one face. Points closer to a plane than 1e-9 of the extent lie
/// on it. Points inside a face or the hull are no vertices. Faces close a solid for any points that do not lie in a
/// plane.
ConvexPart convex_hull(std::span<const Vec3> points);

/// Two unit vectors that make a right-handed frame with the unit vector `normal`.
std::array<Vec3, 2> plane_axes(Vec3 normal);

/// Vertices of the solid with every face moved inwards by `inset` [m]; nothing when it is too thin for that.
std::vector<Vec3> inset_vertices(const ConvexPart& part, double inset);
/// Whether that leaves a solid. Known at once where the middle of the vertices lies deep enough.
bool outlasts_inset(const ConvexPart& part, double inset);

/// `part` moved by `pose`, faces not copied.
void place(const ConvexPart& part, const Pose& pose, std::vector<Vec3>& vertices, std::vector<Plane>& planes);

}  // namespace brash::rigid_body
