// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "body_world.hpp"
#include "overlap.hpp"

namespace brash::rigid_body {

/// Bullet as it is: GJK and EPA on hulls with a margin, persistent manifolds, sequential impulses with warm start, its
/// own integration. Two things are added, because ice breaks: Bullet knows no area of a contact, so the bound of each
/// manifold's impulses comes from the exact overlap of its two parts, shared by the manifold's points; and an overlap
/// of breakable ice is not taken back.
class StockWorld final : public BodyWorld {
 public:
  explicit StockWorld(const WorldSettings& settings);

  void performDiscreteCollisionDetection() override;

 private:
  class Rows;

  /// The bound of one of Bullet's contact points.
  struct Bound {
    double area = 0.0;     ///< its share of the overlap [m2]
    double impulse = 0.0;  ///< [N s]
  };

  double least_margin() const override;
  double hull_margin() const override { return settings().collision_margin; }
  /// The manifolds that touch, in an order that depends on the bodies' states as far as Bullet allows.
  const std::vector<btPersistentManifold*>& sorted_manifolds();
  bool wake_hit_bodies();
  /// Sets the law of a manifold's points and finds their bounds.
  void prepare(btPersistentManifold& manifold, double dt, std::vector<Bound>& bounds);
  void integrateTransforms(btScalar dt) override;
  /// Split impulses have moved Bullet's bodies already.
  void note_parted(double dt);
  void report(double dt);
  void report(const btPersistentManifold& manifold, const btManifoldPoint& point, const Bound& bound, double dt);

  OverlapFinder overlaps_;
  std::vector<btPersistentManifold*> manifolds_;
  std::vector<Bound> bounds_;  ///< of the points of the manifolds, in their order
};

}  // namespace brash::rigid_body
