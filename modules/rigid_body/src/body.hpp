// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "brash/rigid_body/world.hpp"
#include "bullet_types.hpp"
#include "convex_part.hpp"
#include "overlap.hpp"

namespace brash::rigid_body {

struct Body;

/// A convex part of a body.
struct Part {
  Part(Body& owner, int number, ConvexPart shape);

  Body* body;
  int number;  ///< within its body
  ConvexPart solid;
  PlacedPart now;
  btBroadphaseProxy* proxy = nullptr;
  bool sought = false;  ///< its neighbours are, just now
};

struct Body {
  BodyId id;
  BodyKind kind = BodyKind::kFloe;
  Pose pose;
  Twist twist;
  Twist mean_twist;    ///< over the last step
  Twist loaded_twist;  ///< after the loads of the last step, before its contacts
  MassProperties mass;
  Wrench load;     ///< for the next step
  Pose next_pose;  ///< of a structure
  bool moved = false;
  bool settled = false;           ///< a floe fixed where it is
  int rank = 0;                   ///< in the order of the step
  std::uint32_t in_solver = 0;    ///< number there, in this step
  std::vector<const Part*> near;  ///< scratch of the search for neighbours
  std::vector<std::unique_ptr<Part>> parts;
  std::unique_ptr<btRigidBody> bullet;  ///< of a floe: its inertia, and its velocities on the way through a step

  bool is_floe() const { return kind == BodyKind::kFloe; }
  /// Whether the step moves it.
  bool is_free() const { return is_floe() && !settled; }
  /// Adds a collision part, unless it is too thin for the margin.
  bool add_part(ConvexPart solid, double margin);
  void make_bullet_body();
  /// Either way it is at rest.
  void set_settled(bool value);
  /// Brings the parts to the present pose.
  void place_parts();
  /// Brings Bullet's body to the present state.
  void update_bullet();
  double kinetic_energy() const;
};

/// Pose after moving with `twist` for `dt` [s], Eqs. 9, 10: the rotation is that of the constant angular velocity.
Pose advanced(const Pose& pose, const Twist& twist, double dt);

/// Whether all numbers are finite.
bool is_finite(const Pose& pose, const Twist& twist);

/// Order by state alone, by id only between bodies in the same place.
bool comes_before(const Body& a, const Body& b);

}  // namespace brash::rigid_body
