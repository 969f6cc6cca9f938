// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_world.hpp"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>

#include <cmath>
#include <new>

#include "turning.hpp"

namespace brash::rigid_body {
namespace {

/// Iterations stop when no row changes a relative velocity by more than this [m/s]: 0.1 N on 10 t of ice at 0.01 s.
constexpr double kStill = 1e-8;
/// Share of the turn that a split impulse gives which a step takes [-]: floes that part shall not tumble.
constexpr double kPartingTurn = 0.1;

/// SolverBody::stretch.
double stretch(const MassProperties& mass) {
  return mass.added_across == 0.0 ? 0.0 : std::sqrt(mass.mass / (mass.mass + mass.added_across)) - 1.0;
}

SolverBody to_solver(const Body& body) {
  if (!body.is_free()) return {.position = body.pose.position, .twist = body.twist};
  const btRigidBody& b = *body.bullet;
  const btMatrix3x3 axes = b.getWorldTransform().getBasis().transpose();
  const btVector3& inverse_inertia = b.getInvInertiaDiagLocal();
  const auto axis = [&](int i) { return std::sqrt(inverse_inertia[i]) * from_bullet(axes[i]); };
  return {.position = body.pose.position,
          .twist = {from_bullet(b.getLinearVelocity()), from_bullet(b.getAngularVelocity())},
          .inverse_mass = b.getInvMass(),
          .axes = {axis(0), axis(1), axis(2)},
          .normal = rotate(body.pose.rotation, {0.0, 0.0, 1.0}),
          .stretch = stretch(body.mass)};
}

/// Finds the exact overlaps of two bodies. No manifold: a step's overlaps are gone with it.
class OverlapAlgorithm final : public btCollisionAlgorithm {
 public:
  OverlapAlgorithm(const btCollisionAlgorithmConstructionInfo& info, ContactSet& contacts)
      : btCollisionAlgorithm(info), contacts_(contacts) {}

  void processCollision(const btCollisionObjectWrapper* one, const btCollisionObjectWrapper* other,
                        const btDispatcherInfo&, btManifoldResult*) override {
    contacts_.find(body_of(*one->getCollisionObject()), body_of(*other->getCollisionObject()));
  }
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1.0;
  }
  void getAllContactManifolds(btManifoldArray&) override {}

  struct CreateFunc final : btCollisionAlgorithmCreateFunc {
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper*,
                                                   const btCollisionObjectWrapper*) override {
      void* const place = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(OverlapAlgorithm));
      return new (place) OverlapAlgorithm(info, *contacts);
    }
    ContactSet* contacts = nullptr;
  };

 private:
  ContactSet& contacts_;
};

bool is_solid(int shape_type) {
  return shape_type == CONVEX_HULL_SHAPE_PROXYTYPE || shape_type == COMPOUND_SHAPE_PROXYTYPE;
}

btDefaultCollisionConstructionInfo without_manifolds() {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = 1;
  return info;
}

}  // namespace

/// Which algorithm finds the contacts of two bodies.
class ExactWorld::Rules final : public btDefaultCollisionConfiguration {
 public:
  Rules() : btDefaultCollisionConfiguration(without_manifolds()) {}
  btCollisionAlgorithmCreateFunc* getCollisionAlgorithmCreateFunc(int one, int other) override {
    if (is_solid(one) && is_solid(other)) return &overlaps;
    return btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(one, other);
  }

  OverlapAlgorithm::CreateFunc overlaps;
};

/// The bounded solver as Bullet calls one: once for all bodies together, and once more for the rows that islands have
/// left, which are none.
class ExactWorld::Rows final : public btConstraintSolver {
 public:
  btScalar solveGroup(btCollisionObject**, int n_bodies, btPersistentManifold**, int, btTypedConstraint** constraints,
                      int n_constraints, const btContactSolverInfo& info, btIDebugDraw*, btDispatcher*) override {
    if (n_bodies > 0) world->solve({constraints, static_cast<std::size_t>(n_constraints)}, info);
    return world->last_change();
  }
  void reset() override {}
  btConstraintSolverType getSolverType() const override { return BT_SEQUENTIAL_IMPULSE_SOLVER; }

  ExactWorld* world = nullptr;
};

ExactWorld::ExactWorld(const WorldSettings& settings)
    : BodyWorld(settings, std::make_unique<Rules>(), std::make_unique<Rows>()), contacts_(settings) {
  static_cast<Rules&>(*configuration).overlaps.contacts = &contacts_;
  static_cast<Rows&>(*solver).world = this;
}

void ExactWorld::performDiscreteCollisionDetection() {
  find_contacts();
  const std::vector<Body*> hit = contacts_.settled_and_hit(settings().release_speed);
  for (Body* body : hit) set_settled(*body, false);
  if (!hit.empty()) find_contacts();
  contacts_.add(given(), [this](BodyId id) { return &get(id); });
}

void ExactWorld::find_contacts() {
  updateAabbs();
  computeOverlappingPairs();  // forgets some of the pairs that have parted
  contacts_.clear();
  const std::vector<Pair>& pairs = sorted_pairs();
  for (auto next = pairs.begin(); next != pairs.end();) {
    auto end = next;
    contacts_.begin(*next->first);
    for (; end != pairs.end() && end->first == next->first; ++end) contacts_.meet(*end->second);
    for (; next != end; ++next) dispatcher.getNearCallback()(*next->pair, dispatcher, getDispatchInfo());
    contacts_.end();
  }
}

void ExactWorld::solve(std::span<btTypedConstraint* const> constraints, const btContactSolverInfo& info) {
  bounded_.clear(settings().restitution);
  for (Body* body : order()) {
    const bool fixed = (body->kind == BodyKind::kSheet && body->twist == Twist{}) || body->settled;
    body->in_solver = fixed ? BoundedSolver::kFixed : bounded_.add(to_solver(*body));
  }
  joints_.add_to(bounded_, constraints, info);
  contacts_.add_to(bounded_, info.m_timeStep);
  last_change_ = bounded_.solve(settings().iterations, kStill);
  joints_.write_back(bounded_, info.m_timeStep);
  for (Body* body : order()) {
    if (!body->is_free()) continue;
    const Twist after = bounded_.twist(body->in_solver);
    body->bullet->setLinearVelocity(to_bullet(after.linear));
    body->bullet->setAngularVelocity(to_bullet(after.angular));
  }
}

void ExactWorld::integrateTransforms(btScalar dt) {
  average_velocities();
  contacts_.report(bounded_, dt, loads_);
  links().report(dt);
  for (Body* body : order())
    if (body->is_free())
      advance(*body, dt);
    else
      move_as_told(*body);
}

void ExactWorld::advance(Body& body, double dt) {
  body.twist = bounded_.twist(body.in_solver);
  const Twist parting = bounded_.parting(body.in_solver);
  Pose pose = body.pose;
  if (parting != Twist{}) pose = advanced(pose, {parting.linear, kPartingTurn * parting.angular}, dt);
  body.gained_by_turning = 0.0;
  if (body.mass.added_across == 0.0) return finish(body, advanced(pose, body.twist, dt));
  const double before = body.kinetic_energy();
  const Turn turn = turned_with_water(body.mass, pose, body.twist, body.stream, dt);
  body.twist = turn.twist;
  finish(body, turn.pose);
  body.gained_by_turning = body.kinetic_energy() - before;
}

}  // namespace brash::rigid_body
