// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletDynamics/ConstraintSolver/btPoint2PointConstraint.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <memory>
#include <vector>

#include "body.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::rigid_body {

/// The links of a world: Bullet's point-to-point constraints, and their loads in the last step.
class Links {
 public:
  explicit Links(btDiscreteDynamicsWorld& world) : world_(&world) {}
  ~Links();
  Links(const Links&) = delete;
  Links& operator=(const Links&) = delete;

  /// Ties a point of `body` to a point of `other`, each in the frame of its body [m]; without `other`, to a place in
  /// the world [m].
  LinkId add(Body& body, Vec3 point, Body* other, Vec3 other_point, const LinkLaw& law);
  void remove(LinkId id);
  bool contains(LinkId id) const;
  /// The body goes, and its links with it.
  void forget(const Body& body);
  bool hold(const Body& body) const;

  /// Sets how much the links give way in a step of `dt` [s].
  void prepare(double dt);
  /// Reports the forces that the solver left, while bodies are still where the step began.
  void report(double dt);
  /// Adds the gaps, once the bodies have moved.
  void measure();
  const std::vector<LinkLoad>& loads() const { return loads_; }

 private:
  struct Link {
    LinkId id;
    Body* body;
    Body* other;  ///< null: a fixed place
    Vec3 point;
    Vec3 other_point;
    LinkLaw law;
    std::unique_ptr<btPoint2PointConstraint> constraint;
    std::unique_ptr<btJointFeedback> feedback;
  };

  void unhook(Link& link);

  btDiscreteDynamicsWorld* world_;
  btRigidBody fixed_{btRigidBody::btRigidBodyConstructionInfo(0.0, nullptr, nullptr)};  ///< to which floes are moored
  std::vector<Link> links_;                                                             ///< in the order of their ids
  std::uint32_t next_ = 0;
  std::vector<LinkLoad> loads_;
};

}  // namespace brash::rigid_body
