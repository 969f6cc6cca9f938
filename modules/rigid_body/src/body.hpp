// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
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
};

/// An axis-aligned box in the world [m]; the default box is empty.
struct Box {
  Vec3 lower{kFar, kFar, kFar};
  Vec3 upper{-kFar, -kFar, -kFar};

  static constexpr double kFar = std::numeric_limits<double>::infinity();
};

/// Whether boxes are no farther apart along each axis than `reach` [m].
bool within_reach(const Box& a, const Box& b, double reach);
inline Box box(const Part& part) { return {part.now.lower, part.now.upper}; }

/// A floe, a structure or a prism of the sheet, and its objects in Bullet.
struct Body {
  BodyId id;
  BodyKind kind = BodyKind::kFloe;
  Pose pose;
  Pose start_pose;  ///< at the start of the last step
  Twist twist;
  Twist start_twist;               ///< at the start of the last step
  Twist mean_twist;                ///< over the last step
  Twist loaded_twist;              ///< after the loads of the last step, before its contacts
  MassProperties mass;             ///< none: the sheet, and a structure whose motion is given
  Wrench load;                     ///< for the next step
  Vec3 stream;                     ///< velocity of the water around it
  double gained_by_turning = 0.0;  ///< World::gained_by_turning() [J]
  std::optional<Pose> unparted;    ///< World::unparted_pose()
  Vec3 gyration;                   ///< angular velocity that the gyroscopic moment gave it in this step [rad/s]
  double gyroscopic_share = 0.0;   ///< World::gyroscopic_share() [J]
  Pose next_pose;                  ///< of a structure or a sheet whose motion is given
  bool moved = false;
  bool settled = false;           ///< a floe fixed where it is
  bool struck = false;            ///< a settled floe that a blow has released in this step
  bool in_plane = false;          ///< a sheet that drifts: it has no parts, and moves in x, y and yaw
  Body* sheet = nullptr;          ///< of a part: the sheet that drifts with it; null where no contact moves the part
  int rank = 0;                   ///< in the order of the step
  std::uint32_t in_solver = 0;    ///< number there, in this step
  Box box;                        ///< of its parts where it is now
  bool box_is_known = false;      ///< to Bullet's broad phase
  bool sought = false;            ///< its neighbours are, just now
  std::vector<Body*> beside;      ///< scratch of the search: bodies whose boxes are within reach
  std::vector<const Part*> near;  ///< scratch of the search for neighbours
  std::vector<std::unique_ptr<Part>> parts;
  std::vector<std::unique_ptr<btConvexHullShape>> hulls;  ///< one for each part, or none
  std::unique_ptr<btCollisionShape> shape;                ///< of all parts together; null where one hull is all
  std::unique_ptr<btRigidBody> bullet;

  bool is_floe() const { return kind == BodyKind::kFloe; }
  /// Whether it is a sheet that drifts, or a part of one.
  bool drifts() const { return in_plane || sheet != nullptr; }
  /// Whether the step moves it.
  bool is_free() const { return mass.mass > 0.0 && !settled; }
  /// Whether contacts move it, or the sheet that it is part of.
  bool gives_way() const { return is_free() || (sheet != nullptr && sheet->is_free()); }
  /// Adds a collision part, unless it is too thin for the margin.
  bool add_part(ConvexPart solid, double margin);
  /// Makes Bullet's body. Its hulls are inset by `margin` [m], which Bullet adds again.
  void make_bullet_body(double margin);
  /// A floe is fixed where it is, or released; either way it is at rest.
  void set_settled(bool value);
  void set_mass(const MassProperties& value);
  /// Brings the parts and Bullet's body to the present pose.
  void place();
  double kinetic_energy() const;
  /// At its pose, with a spin [rad/s], in kg m2/s.
  Vec3 angular_momentum(Vec3 spin) const;
};

/// Two bodies whose boxes overlap, in the order in which a contact between them is handled.
struct BodyPair {
  Body* first;  ///< a floe, or a part of a sheet as the second is
  Body* second;
};

/// Pose after moving with `twist` for `dt` [s], Eqs. 9, 10: the rotation at constant angular velocity.
Pose advanced(const Pose& pose, const Twist& twist, double dt);

/// Whether all numbers are finite.
bool is_finite(const Pose& pose, const Twist& twist);

/// Order by state alone, by id only between bodies in the same place.
bool comes_before(const Body& a, const Body& b);

}  // namespace brash::rigid_body
