// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "brash/core/vec.hpp"

namespace brash::plate {

/// Kind of a stretch of the outline, or of a line inside.
/// kCrack: a line of symmetry that carries no moments.
enum class Side { kFree, kTip, kSymmetryY, kSymmetryX, kCrack, kFar, kInterior };

/// A straight piece of the outline or a line that the mesh must contain.
struct Segment {
  Vec2 from{};
  Vec2 to{};
  Side side = Side::kFree;
};

/// Elements within a distance d of the segment from-to have at most the size `size + gradation * d`.
struct SizeSource {
  Vec2 from{};
  Vec2 to{};
  double size = 0.1;
  double gradation = 0.3;
};

/// A bounded, simply connected plane domain and the element size wanted in it; lengths over l_c.
struct Domain {
  std::vector<Segment> segments;  ///< closed outline and interior lines
  std::vector<SizeSource> sizes;
  double largest_size = 1.0;
};

/// One edge of the mesh that lies on a segment of the domain.
struct TaggedEdge {
  int edge = 0;
  Side side = Side::kFree;
  int segment = 0;  ///< of the domain
};

/// A conforming triangulation; local edge e of a triangle joins its local vertices e and (e + 1) % 3.
struct Mesh {
  std::vector<Vec2> vertices;
  std::vector<std::array<int, 3>> triangles;       ///< counter-clockwise
  std::vector<std::array<int, 2>> edges;           ///< lower vertex first
  std::vector<std::array<int, 3>> triangle_edges;  ///< shape=(n_triangles, 3)
  std::vector<TaggedEdge> tagged;
};

/// Position of a point of the reference triangle.
Vec2 place_in(const Mesh& mesh, int triangle, double xi, double eta);

/// Constrained Delaunay mesh of `domain` with all angles above about 20 degrees where the outline permits.
///
/// @param max_vertices  refinement that makes more is given up; 0: no limit.
tl::expected<Mesh, std::string> mesh_domain(const Domain& domain, std::size_t max_vertices = 0);

}  // namespace brash::plate
