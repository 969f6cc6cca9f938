// SPDX-License-Identifier: GPL-3.0-or-later
#include "stock_world.hpp"

#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "brash/core/contract.hpp"
#include "contact_load.hpp"

namespace brash::rigid_body {
namespace {

/// The part of a body that a manifold point belongs to; Bullet numbers the children of compounds only.
const Part& part_of(const Body& body, int child) { return *body.parts[static_cast<std::size_t>(std::max(child, 0))]; }

/// Where bodies meet, by their ranks, then by their parts.
auto place(const btPersistentManifold& m) {
  const btManifoldPoint& p = m.getContactPoint(0);
  return std::tuple(body_of(*m.getBody0()).rank, body_of(*m.getBody1()).rank, p.m_index0, p.m_index1);
}

btVector3 friction_impulse(const btManifoldPoint& p) {
  return p.m_appliedImpulseLateral1 * p.m_lateralFrictionDir1 + p.m_appliedImpulseLateral2 * p.m_lateralFrictionDir2;
}

}  // namespace

/// Bullet's solver with an upper limit on the rows of contacts and softness in the rows of springs.
class StockWorld::Rows final : public btSequentialImpulseConstraintSolver {
 public:
  StockWorld* world = nullptr;

 private:
  void convertContacts(btPersistentManifold**, int n_manifolds, const btContactSolverInfo& info) override {
    if (n_manifolds == 0) return;  // the call for the manifolds that islands have left
    // Bullet's kernel for contacts looks at the lower limit only, and each change of mode brings it back.
    setConstraintRowSolverLowerLimit(getScalarConstraintRowSolverGeneric());
    world->bounds_.clear();
    for (btPersistentManifold* manifold : world->sorted_manifolds()) {
      const std::size_t first_point = world->bounds_.size();
      world->prepare(*manifold, info.m_timeStep, world->bounds_);
      const int first_row = m_tmpSolverContactConstraintPool.size();
      convertContact(manifold, info);
      for (int i = first_row; i < m_tmpSolverContactConstraintPool.size(); ++i) {
        btSolverConstraint& row = m_tmpSolverContactConstraintPool[i];
        const auto* const point = static_cast<const btManifoldPoint*>(row.m_originalContactPoint);
        row.m_upperLimit =
            world->bounds_[first_point + static_cast<std::size_t>(point - &manifold->getContactPoint(0))].impulse;
      }
    }
  }

  /// A link's softness is one of its impulse, as in the bounded solver; Bullet's rows leave it out of their mass.
  void convertJoints(btTypedConstraint** joints, int n_joints, const btContactSolverInfo& info) override {
    btSequentialImpulseConstraintSolver::convertJoints(joints, n_joints, info);
    for (int i = 0; i < m_tmpSolverNonContactConstraintPool.size(); ++i) {
      btSolverConstraint& row = m_tmpSolverNonContactConstraintPool[i];
      const btScalar given = row.m_cfm * row.m_jacDiagABInv;
      row.m_rhs /= 1.0 + given;
      row.m_jacDiagABInv /= 1.0 + given;
      row.m_cfm = given / (1.0 + given);
    }
  }
};

StockWorld::StockWorld(const WorldSettings& settings)
    : BodyWorld(settings, std::make_unique<btDefaultCollisionConfiguration>(), std::make_unique<Rows>()) {
  static_cast<Rows&>(*solver).world = this;
  // Without warm start Bullet does not write impulses back. With one direction friction lags behind the slip.
  getSolverInfo().m_solverMode = SOLVER_USE_WARMSTARTING | SOLVER_USE_2_FRICTION_DIRECTIONS;
}

double StockWorld::least_margin() const { return gContactBreakingThreshold; }

void StockWorld::performDiscreteCollisionDetection() {
  btDiscreteDynamicsWorld::performDiscreteCollisionDetection();
  if (wake_hit_bodies()) btDiscreteDynamicsWorld::performDiscreteCollisionDetection();
}

const std::vector<btPersistentManifold*>& StockWorld::sorted_manifolds() {
  manifolds_.clear();
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    btPersistentManifold* const manifold = dispatcher.getManifoldByIndexInternal(i);
    if (manifold->getNumContacts() > 0) manifolds_.push_back(manifold);
  }
  std::ranges::stable_sort(manifolds_, {}, [](const btPersistentManifold* m) { return place(*m); });
  return manifolds_;
}

/// Wakes the sleeping floes that another body runs into. @return whether there are any.
bool StockWorld::wake_hit_bodies() {
  std::vector<Body*> hit;
  for (const btPersistentManifold* m : sorted_manifolds()) {
    Body &a = body_of(*m->getBody0()), &b = body_of(*m->getBody1());
    if (!a.settled && !b.settled) continue;
    for (int i = 0; i < m->getNumContacts(); ++i) {
      const btManifoldPoint& p = m->getContactPoint(i);
      const Vec3 at = from_bullet(p.getPositionWorldOnB());
      const Vec3 closing = velocity_at(b.twist, at - b.pose.position) - velocity_at(a.twist, at - a.pose.position);
      if (p.getDistance() > 0.0 || dot(from_bullet(p.m_normalWorldOnB), closing) <= settings().release_speed) continue;
      hit.push_back(a.settled ? &a : &b);
      break;
    }
  }
  for (Body* body : hit) set_settled(*body, false);
  if (!hit.empty()) list_awake();
  return !hit.empty();
}

void StockWorld::prepare(btPersistentManifold& manifold, double dt, std::vector<Bound>& bounds) {
  const Body &a = body_of(*manifold.getBody0()), &b = body_of(*manifold.getBody1());
  const bool structure = a.kind == BodyKind::kStructure || b.kind == BodyKind::kStructure;
  const ContactLaw& law = structure ? settings().ice_structure : settings().ice_ice;
  const int n = manifold.getNumContacts();
  const btManifoldPoint& first = manifold.getContactPoint(0);
  const bool overlap =
      overlaps_.find(part_of(a, first.m_index0).now, part_of(b, first.m_index1).now).vertices.size() >= 4;
  for (int i = 0; i < n; ++i) {
    btManifoldPoint& p = manifold.getContactPoint(i);
    p.m_combinedFriction = law.friction;
    const double area = overlap ? overlaps_.project(from_bullet(p.m_normalWorldOnB)).area / n : 0.0;
    double bound = SIMD_INFINITY;
    if (std::isfinite(law.crushing_pressure)) {
      bound = dt * law.crushing_pressure * area;
      p.m_contactPointFlags |= BT_CONTACT_FLAG_HAS_CONTACT_ERP;  // an overlap is crushed ice
      p.m_contactERP = 0.0;
      p.m_appliedImpulse = std::min(p.m_appliedImpulse, bound / getSolverInfo().m_warmstartingFactor);
    }
    bounds.push_back({area, bound});
  }
}

void StockWorld::integrateTransforms(btScalar dt) {
  average_velocities();
  note_parted(dt);
  report(dt);
  links().report(dt);
  btDiscreteDynamicsWorld::integrateTransforms(dt);
  for (Body* body : order()) {
    if (!body->is_free()) {
      move_as_told(*body);
      continue;
    }
    const btRigidBody& b = *body->bullet;
    body->twist = {from_bullet(b.getLinearVelocity()), from_bullet(b.getAngularVelocity())};
    const btQuaternion q = b.getWorldTransform().getRotation();
    finish(*body, {from_bullet(b.getWorldTransform().getOrigin()), {q.w(), q.x(), q.y(), q.z()}});
  }
}

void StockWorld::note_parted(double dt) {
  for (Body* body : order()) {
    body->unparted.reset();
    const btRigidBody& b = *body->bullet;
    if (!body->is_free() || b.getWorldTransform() == to_bullet(body->pose)) continue;
    const Twist twist{from_bullet(b.getLinearVelocity()), from_bullet(b.getAngularVelocity())};
    body->unparted = advanced(body->pose, twist, dt);
  }
}

void StockWorld::report(double dt) {
  loads_.clear();
  std::size_t i = 0;
  for (const btPersistentManifold* manifold : manifolds_)
    for (int k = 0; k < manifold->getNumContacts(); ++k, ++i)
      report(*manifold, manifold->getContactPoint(k), bounds_[i], dt);
  std::ranges::stable_sort(loads_, [](const ContactLoad& p, const ContactLoad& q) {
    return std::tie(p.body, p.other, p.point.x, p.point.y, p.point.z) <
           std::tie(q.body, q.other, q.point.x, q.point.y, q.point.z);
  });
}

/// Bullet's impulses act on each body at its own point.
void StockWorld::report(const btPersistentManifold& manifold, const btManifoldPoint& p, const Bound& bound, double dt) {
  const double normal_impulse = p.m_appliedImpulse;
  const Vec3 friction = from_bullet(friction_impulse(p));
  if (normal_impulse == 0.0 && friction == Vec3{}) return;
  const Body &a = body_of(*manifold.getBody0()), &b = body_of(*manifold.getBody1());
  const Vec3 of_a = from_bullet(p.getPositionWorldOnA()), of_b = from_bullet(p.getPositionWorldOnB());
  const Vec3 normal = from_bullet(p.m_normalWorldOnB);
  const bool turn = !a.is_floe() || (b.is_floe() && b.id < a.id);
  ContactLoad load = turn ? contact_load(b, a, of_b, of_a, -normal, normal_impulse, -friction, dt)
                          : contact_load(a, b, of_a, of_b, normal, normal_impulse, friction, dt);
  load.area = bound.area;
  load.depth = std::max(0.0, -p.getDistance());
  load.at_bound = normal_impulse >= bound.impulse;
  loads_.push_back(load);
}

}  // namespace brash::rigid_body
