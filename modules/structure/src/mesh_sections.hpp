// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "brash/structure/hull.hpp"

namespace brash::structure {

/// Loops that bound a region of the plan: outlines counter-clockwise, holes clockwise.
using Loops = std::vector<Outline>;

/// The outlines of the union of regions, holes left out. Simple, counter-clockwise, vertices on a grid of 2^-20 m.
/// @param tolerance  how far a vertex may lie from the outlines that leave it out [m].
std::vector<Outline> united(const std::vector<Loops>& regions, double tolerance);

/// The outlines of the part that all regions have in common, moved in by `inset` [m] on every side; otherwise alike.
std::vector<Outline> common(const std::vector<Loops>& regions, double tolerance, double inset);

/// A closed mesh with its triangles sorted by height, for questions about the few triangles that are near the ice.
class MeshSections {
 public:
  explicit MeshSections(TriangleMesh mesh);

  const TriangleMesh& mesh() const { return mesh_; }

  /// Triangles that reach into the heights from `bottom` to `top`, world frame [m]; some beside them, each once.
  std::vector<int> near(const Pose& pose, double bottom, double top) const;

  /// The section at the height z, world frame [m], of the mesh whose triangles near z are `near`.
  Loops at(const Pose& pose, double z, const std::vector<int>& near) const;

 private:
  TriangleMesh mesh_;
  std::vector<std::array<int, 3>> neighbours_;
  Vec3 least_{}, most_{};
  /// Triangles by the layers of equal height that they reach into: layer i begins at starts_[i].
  std::vector<std::uint32_t> starts_, members_;
  std::vector<std::uint16_t> lowest_;  ///< layer of each triangle
};

}  // namespace brash::structure
