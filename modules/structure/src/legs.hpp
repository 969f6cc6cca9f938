// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "brash/structure/regions.hpp"

namespace brash::structure {

/// A rigid structure of several legs: copies of one hull that do not touch and turn with the structure.
class Legs final : public Hull {
 public:
  /// @param leg     has no legs itself.
  /// @param places  of the legs' origins, structure's frame [m]; one or more.
  Legs(std::unique_ptr<const Hull> leg, std::vector<Vec2> places);

  std::span<const ConvexPart> parts() const override { return parts_; }
  /// The outlines of one leg after another. Heeled, the legs' plans may cover each other: then their union.
  Footprint footprint(const Pose& pose, double bottom, double top) const override;
  std::vector<SidePiece> sides(const Pose& pose, double bottom, double top, const PlanBox& region) const override;
  /// Of the leg to which the point belongs: LegRegions.
  Surface surface_at(const Pose& pose, Vec3 point) const override;
  Displacement displaced(const Pose& pose) const override;
  HullCopies copies() const override { return {leg_.get(), places_}; }
  const TriangleMesh& mesh() const override { return mesh_; }

 private:
  Pose pose_of(Vec2 place, const Pose& structure) const;

  std::unique_ptr<const Hull> leg_;
  std::vector<Vec2> places_;
  LegRegions regions_;
  std::vector<ConvexPart> parts_;
  TriangleMesh mesh_;
};

}  // namespace brash::structure
