// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorldMt.h>
#include <btBulletDynamicsCommon.h>

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "brash/geometry/polygon.hpp"
#include "brash/model/case.hpp"
#include "brash/rigid_body/world.hpp"
#include "convex_part.hpp"

namespace brash::benchmarks {

/// A floe before a step of the program.
struct FloeThen {
  std::int64_t id = 0;
  geometry::Polygon outline;  ///< where it broke off, sheet frame
  Pose pose;
  Twist twist;
};

/// A body with its shapes; shapes outlive it.
struct BulletBody {
  std::vector<std::unique_ptr<btConvexHullShape>> parts;
  std::unique_ptr<btCompoundShape> compound;
  std::unique_ptr<btRigidBody> body;
};

/// Bullet's world as its manual sets it up, with the case's margin and iterations, over the floes, the sheet and the
/// structure of a state of the program.
class BulletWorld {
 public:
  explicit BulletWorld(const model::Case& c);
  /// The same with Bullet's classes for threads: its dispatcher, its solvers and its scheduler, on `threads` threads.
  /// All worlds share the scheduler, so that the latest world says how many threads work.
  ///
  /// @throws std::runtime_error  if Bullet was built without threads, or has fewer of them.
  BulletWorld(const model::Case& c, int threads);
  ~BulletWorld();
  BulletWorld(const BulletWorld&) = delete;

  void add_structure(const std::vector<Vec3>& hull, const Pose& pose);
  void place_structure(const Pose& from, const Pose& to, Vec3 velocity);
  /// Floes as they are before a step; missing floes leave the world.
  void set_floes(const std::vector<FloeThen>& floes);
  /// The sheet, in convex parts; known parts stay.
  void set_sheet(const std::vector<geometry::Polygon>& sheet, double bottom, double top);
  void step(double dt) { world_->stepSimulation(dt, 0); }
  int n_points();
  /// Of the floes, in the order of their ids.
  std::vector<Pose> poses() const;

 private:
  using Outline = std::vector<std::pair<double, double>>;

  void set_up();
  BulletBody make(const std::vector<rigid_body::ConvexPart>& solids, const rigid_body::MassProperties& mass,
                  const Pose& pose, double friction) const;
  BulletBody make_floe(const FloeThen& floe);

  const model::Case& case_;
  btDefaultCollisionConfiguration configuration_;
  btDbvtBroadphase broad_phase_;
  std::unique_ptr<btCollisionDispatcher> dispatcher_;
  std::unique_ptr<btConstraintSolver> solver_;      ///< with threads of large islands, which it solves on all of them
  std::unique_ptr<btConstraintSolverPoolMt> pool_;  ///< with threads of small islands, each of which one thread solves
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
  std::map<std::int64_t, BulletBody> floes_;
  std::map<Outline, std::vector<BulletBody>> sheet_;
  BulletBody structure_;
};

}  // namespace brash::benchmarks
