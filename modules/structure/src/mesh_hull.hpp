// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "brash/structure/mesh_file.hpp"
#include "mesh_sections.hpp"

namespace brash::structure {

/// Which way a mesh in the water seems to point, as far as it is long enough for a ship.
Bearing bearing_of(const MeshSections& sections);

/// The parts of a mesh hull that copies share.
struct MeshBody {
  MeshSections sections;
  std::vector<ConvexPart> parts;
  double tolerance = 0.0;  ///< of outlines [m]
  MeshReport report;

  MeshBody(TriangleMesh mesh, MeshReport report);
};

/// A hull of any shape, bounded by a closed mesh.
class MeshHull final : public Hull {
 public:
  explicit MeshHull(std::shared_ptr<const MeshBody> body) : body_(std::move(body)) {}

  std::span<const ConvexPart> parts() const override { return body_->parts; }
  /// From five sections where the mesh bends within the heights, from two where it does not. Holes count as hull.
  Footprint footprint(const Pose& pose, double bottom, double top) const override;
  /// A face steeper than 89.9 degrees leans by that much over the ice, so that its plan has an area.
  std::vector<SidePiece> sides(const Pose& pose, double bottom, double top, const PlanBox& region) const override;
  Surface surface_at(const Pose& pose, Vec3 point) const override;
  Displacement displaced(const Pose& pose) const override;
  const TriangleMesh& mesh() const override { return body_->sections.mesh(); }

 private:
  std::shared_ptr<const MeshBody> body_;
};

std::unique_ptr<const Hull> hull_of(const model::Ship& ship);
/// @throws InputError when the file is not a hull.
std::unique_ptr<const Hull> hull_of(const model::Mesh& mesh);

}  // namespace brash::structure
