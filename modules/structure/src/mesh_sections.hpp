// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "plan_polygons.hpp"

namespace brash::structure {

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
