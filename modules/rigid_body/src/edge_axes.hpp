// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "overlap.hpp"

namespace brash::rigid_body {

/// Finds the separating axes of an overlap along which an edge of one part leaves an edge of the other. Scratch space,
/// so that no call allocates.
///
/// Such an axis is normal to both edges, and each edge is the last of its part along it. Then the axis lies between the
/// normals of the two faces beside the edge. Arcs on the sphere of directions show this without a look at any other
/// corner (Gregorius, The separating axis test between convex polyhedra, Game Developers Conference, 2013). With the
/// axes of the faces these are all directions in which the Minkowski difference of two convex solids has a face. So the
/// axis of least depth among them has the least depth of all. Along that axis the edges meet in a point of both: their
/// distance is at most its depth, and edges farther apart need no look.
class EdgeAxes {
 public:
  /// The axes from b into a with a depth below `limit` [m], least depth first, of edges no farther apart than `limit`;
  /// `overlap` has just found the overlap of a and b.
  std::span<const SeparatingAxis> find(const OverlapFinder& overlap, const PlacedPart& a, const PlacedPart& b,
                                       double limit);

 private:
  /// An edge where it is now.
  struct PlacedEdge {
    Vec3 from;
    Vec3 along;  ///< to its other end
    Vec3 left;   ///< normals of the faces beside it
    Vec3 right;
    Vec3 lower;  ///< axis-aligned box
    Vec3 upper;
  };
  void collect_near(const PlacedPart& part, const Heights& heights, double reach, std::vector<PlacedEdge>& edges);
  void try_pair(const PlacedEdge& e, const PlacedEdge& f, double limit);

  Beyond beyond_;
  std::vector<PlacedEdge> edges_a_;
  std::vector<PlacedEdge> edges_b_;
  std::vector<SeparatingAxis> axes_;
};

}  // namespace brash::rigid_body
