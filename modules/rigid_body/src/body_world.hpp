// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>
#include <BulletCollision/CollisionDispatch/btCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletDynamics/ConstraintSolver/btConstraintSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <memory>
#include <span>
#include <vector>

#include "body.hpp"
#include "brash/core/workers.hpp"
#include "brash/rigid_body/world.hpp"
#include "links.hpp"

namespace brash::rigid_body {

/// The objects that Bullet's world refers to: there before it and after it.
struct BulletParts {
  BulletParts(std::unique_ptr<btCollisionConfiguration> rules, std::unique_ptr<btConstraintSolver> rows)
      : configuration(std::move(rules)), solver(std::move(rows)), dispatcher(configuration.get()) {}

  std::unique_ptr<btCollisionConfiguration> configuration;
  std::unique_ptr<btConstraintSolver> solver;
  btCollisionDispatcher dispatcher;
  btDbvtBroadphase tree;
  std::vector<std::unique_ptr<Body>> bodies;  ///< in the order of their ids
};

/// Bullet's world over the bodies of a World. This part is common to all engines: the bodies, their boxes, the order
/// of a step and the velocities that loads give. An engine finds the contacts, solves them and moves the bodies.
class BodyWorld : protected BulletParts, public btDiscreteDynamicsWorld {
 public:
  BodyWorld(const WorldSettings& settings, std::unique_ptr<btCollisionConfiguration> rules,
            std::unique_ptr<btConstraintSolver> rows);
  ~BodyWorld() override;
  BodyWorld(const BodyWorld&) = delete;
  BodyWorld& operator=(const BodyWorld&) = delete;

  const WorldSettings& settings() const { return settings_; }
  /// Who shares out the loops over bodies and contacts; at first the calling thread alone.
  void share_work(Workers& workers) { workers_ = &workers; }
  Workers& workers() { return *workers_; }
  bool contains(BodyId id) const;
  Body& get(BodyId id);
  const std::vector<std::unique_ptr<Body>>& all() const { return bodies; }
  const std::vector<BodyId>& moving() const { return moving_; }
  BodyId insert(std::unique_ptr<Body> body);
  void remove(BodyId id);
  void set_settled(Body& body, bool settled);
  /// Advances all bodies by `dt` [s].
  void step(double dt);
  const std::vector<ContactLoad>& loads() const { return loads_; }
  const std::vector<ContactLoad>& loads_of_sheets() const { return loads_of_sheets_; }
  double last_change() const { return last_change_; }
  Links& links() { return links_; }
  /// Fills Body::near of each of the floes with the parts of other bodies within `reach` [m] of its own.
  void find_near(std::span<const BodyId> floes, double reach);

  /// A body's box encloses its parts, so that pairs are a function of the bodies' states. It reaches half the way to
  /// the neighbours that are asked for.
  void updateAabbs() override;

 protected:
  /// Bodies that a thread takes at a time, at some 0.1 us for each.
  static constexpr std::size_t kBodies = 128;

  /// The pairs that Bullet's broad phase knows now, in the order of the step. The first is a floe, or both are parts of
  /// sheets.
  const std::vector<BodyPair>& sorted_pairs();
  /// The bodies in the order of the step.
  const std::vector<Body*>& order() const { return order_; }
  /// How much larger than its parts a box is, at least [m].
  virtual double least_margin() const { return 0.0; }
  /// Inset of the hulls, which Bullet adds again as their margin [m].
  virtual double hull_margin() const { return 0.0; }

  /// Whether there is a sheet that drifts.
  bool any_drifts() const { return filter_ != nullptr; }
  /// Parts move with their sheets that drift. @param twist  of Body, which parts take from their sheets.
  void follow_sheets(Twist Body::*twist);

  /// Velocities with the applied loads and the gyroscopic moment, before contacts.
  void predictUnconstraintMotion(btScalar dt) override;
  /// Bodies have the velocities that they were given.
  void saveKinematicState(btScalar) override {}
  void createPredictiveContacts(btScalar) override {}
  /// Bullet never puts a body to sleep.
  void updateActivationState(btScalar) override {}

  /// Mean velocities of the step, once the solver has set Bullet's; Body::twist is still the twist at its start.
  void average_velocities();
  /// Ends the step of a body that moves freely. Its twist is already the twist at the end.
  static void finish(Body& body, const Pose& pose);
  /// Ends the step of any other.
  static void move_as_told(Body& body);
  /// Calls `task` for each body that is not settled in the order of the step, several at a time.
  template <typename Task>
  void each_body(Task&& task) {
    workers_->each(awake_.size(), kBodies, [&](std::size_t i) { task(*awake_[i]); });
  }
  /// To be called when a body has woken within a step.
  void list_awake();

  std::vector<ContactLoad> loads_;
  std::vector<ContactLoad> loads_of_sheets_;
  double last_change_ = 0.0;

 private:
  void add_to_bullet(Body& body);
  void part_settled();
  void bring_into_order();
  void list_as_moving(const Body& body, bool moves);

  /// Calls `task` for all pairs that Bullet's broad phase knows, several at a time.
  template <typename Task>
  void each_known_pair(Task&& task);

  WorldSettings settings_;
  Workers alone_{1};
  Workers* workers_ = &alone_;
  std::vector<Body*> by_index_;                    ///< of every body there has been; null where it is gone
  std::vector<BodyId> moving_;                     ///< floes that are not settled, sorted
  std::vector<Body*> order_;                       ///< the order of the last step; empty when bodies came or went since
  std::vector<Body*> awake_;                       ///< bodies in `order_` that are not settled
  double reach_ = 0.0;                             ///< of the last search for neighbours [m]
  bool has_settled_ = false;                       ///< whether a body has since the last step
  std::vector<std::vector<BodyPair>> some_pairs_;  ///< scratch: of each chunk of the pairs that Bullet knows
  std::vector<std::size_t> of_first_;              ///< scratch of sorted_pairs
  std::vector<BodyPair> pairs_;
  Links links_{*this};
  std::unique_ptr<btOverlapFilterCallback> filter_;  ///< of pairs, once a sheet drifts
};

inline Body& body_of(const btCollisionObject& object) { return *static_cast<Body*>(object.getUserPointer()); }

}  // namespace brash::rigid_body
