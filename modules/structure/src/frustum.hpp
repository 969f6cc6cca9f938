// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "brash/structure/hull.hpp"

namespace brash::structure {

/// A convex body with plane sides between a lower and an upper ring of as many vertices.
class Frustum : public Hull {
 public:
  /// @param lower  counter-clockwise as seen from above, at one height; hull's frame [m].
  /// @param upper  the same, vertex i above vertex i of `lower` along the slope.
  Frustum(std::vector<Vec3> lower, const std::vector<Vec3>& upper);

  std::span<const ConvexPart> parts() const override { return {&vertices_, 1}; }
  Footprint footprint(const Pose& pose, double bottom, double top) const override;
  std::vector<SidePiece> sides(const Pose& pose, double bottom, double top, const PlanBox& region) const override;
  Surface surface_at(const Pose& pose, Vec3 point) const override;
  Displacement displaced(const Pose& pose) const override;
  const TriangleMesh& mesh() const override { return mesh_; }

 private:
  struct Side {
    Vec3 normal;    ///< unit, outwards
    double offset;  ///< of its plane from the origin along the normal [m]
  };

  Outline section(const std::vector<Vec3>& world, double z) const;
  Outline drawn_in(Outline outline, const Pose& pose, double bottom, double top) const;

  ConvexPart vertices_;  ///< the lower ring, then the upper one
  std::vector<Side> sides_;
  TriangleMesh mesh_;
};

/// Cotangent of 89.9 degrees. A vertical face crushes ice over a strip of its plan; the vertical part of its force is
/// this share of the horizontal one. docs/theory/structures.md, (K2)
inline constexpr double kLean = 1.745331e-3;

/// Whether a side with this outward normal is vertical, so that it has to lean.
inline bool is_steep(Vec3 normal) { return std::abs(normal.z) < kLean; }

/// A steep piece that leans over the ice: at the height `top` it stays, further down it moves inwards.
SidePiece leaning(const SidePiece& piece, double top);

/// The part of a convex polygon between two heights.
std::vector<Vec3> slab_of(std::vector<Vec3> polygon, double bottom, double top);

/// The surface with the outward normal `normal`, unit, world frame.
Surface surface_with(Vec3 normal);

/// The displacement of the part of a closed mesh below z = 0; `world` are its vertices in the world frame [m].
Displacement displacement_of(const TriangleMesh& mesh, const std::vector<Vec3>& world);

/// A round cone: the paper's structure (Table 1, Fig. 9). Its faceted frustum represents it in contacts, and where it
/// heels; upright it has the slope and the displacement of the round cone.
class Cone final : public Frustum {
 public:
  explicit Cone(const model::Cone& cone);

  /// Upright, the vertices lie on the round cone.
  Footprint footprint(const Pose& pose, double bottom, double top) const override;
  Surface surface_at(const Pose& pose, Vec3 point) const override;
  Displacement displaced(const Pose& pose) const override;

 private:
  model::Cone cone_;
};

// Shapes with plane sides that stand between a keel and a top.
std::unique_ptr<const Hull> hull_of(const model::FacetedCone& cone);
std::unique_ptr<const Hull> hull_of(const model::Plane& plane);
std::unique_ptr<const Hull> hull_of(const model::WedgeBow& bow);

}  // namespace brash::structure
