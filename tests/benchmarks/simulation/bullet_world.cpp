// SPDX-License-Identifier: GPL-3.0-or-later
#include "bullet_world.hpp"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcherMt.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolverMt.h>
#include <LinearMath/btThreads.h>

#include <cmath>
#include <stdexcept>

#include "brash/floes/plan.hpp"
#include "brash/simulation/setup.hpp"
#include "bullet_types.hpp"

namespace brash::benchmarks {

using rigid_body::to_bullet;

namespace {

/// Sets how many of Bullet's threads work, the calling thread among them.
void use_threads(int threads) {
  static const std::unique_ptr<btITaskScheduler> scheduler(btCreateDefaultTaskScheduler());
  if (!scheduler)
    throw std::runtime_error(
        "this Bullet was built without threads: run ./dev bench threads_beside_bullet, which builds it with them");
  btSetTaskScheduler(scheduler.get());
  scheduler->setNumThreads(threads);
  if (scheduler->getNumThreads() != threads)
    throw std::runtime_error(
        "Bullet has a thread for each core, and this machine has fewer cores than threads asked for");
}

}  // namespace

BulletWorld::BulletWorld(const model::Case& c)
    : case_(c),
      dispatcher_(std::make_unique<btCollisionDispatcher>(&configuration_)),
      solver_(std::make_unique<btSequentialImpulseConstraintSolver>()),
      world_(
          std::make_unique<btDiscreteDynamicsWorld>(dispatcher_.get(), &broad_phase_, solver_.get(), &configuration_)) {
  set_up();
}

BulletWorld::BulletWorld(const model::Case& c, int threads) : case_(c) {
  use_threads(threads);  // before the dispatcher, which has a list for each thread
  dispatcher_ = std::make_unique<btCollisionDispatcherMt>(&configuration_);
  solver_ = std::make_unique<btSequentialImpulseConstraintSolverMt>();
  pool_ = std::make_unique<btConstraintSolverPoolMt>(threads);
  world_ = std::make_unique<btDiscreteDynamicsWorldMt>(dispatcher_.get(), &broad_phase_, pool_.get(), solver_.get(),
                                                       &configuration_);
  set_up();
}

void BulletWorld::set_up() {
  world_->setGravity({0, 0, 0});  // the run's velocities are set before each step
  world_->getSolverInfo().m_numIterations = case_.contact.iterations;
  world_->getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
}

BulletWorld::~BulletWorld() {
  for (auto& [id, floe] : floes_) world_->removeRigidBody(floe.body.get());
  for (auto& [key, tiles] : sheet_)
    for (auto& tile : tiles) world_->removeRigidBody(tile.body.get());
  if (structure_.body) world_->removeRigidBody(structure_.body.get());
}

void BulletWorld::add_structure(const std::vector<Vec3>& hull, const Pose& pose) {
  structure_ = make({rigid_body::convex_hull(hull)}, {0.0, {}}, pose, case_.ice.friction_structure);
  structure_.body->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
  world_->addRigidBody(structure_.body.get(), 2, 1);
}

void BulletWorld::place_structure(const Pose& from, const Pose& to, Vec3 velocity) {
  structure_.body->setInterpolationWorldTransform(to_bullet(from));
  structure_.body->setWorldTransform(to_bullet(to));
  structure_.body->setLinearVelocity(to_bullet(velocity));
}

void BulletWorld::set_floes(const std::vector<FloeThen>& floes) {
  std::map<std::int64_t, BulletBody> now;
  for (const FloeThen& floe : floes) {
    auto known = floes_.extract(floe.id);
    BulletBody body = known.empty() ? make_floe(floe) : std::move(known.mapped());
    body.body->setWorldTransform(to_bullet(floe.pose));
    body.body->setLinearVelocity(to_bullet(floe.twist.linear));
    body.body->setAngularVelocity(to_bullet(floe.twist.angular));
    body.body->activate(true);
    now.emplace(floe.id, std::move(body));
  }
  for (auto& [id, gone] : floes_) world_->removeRigidBody(gone.body.get());
  floes_ = std::move(now);
}

int BulletWorld::n_points() {
  int n = 0;
  for (int i = 0; i < dispatcher_->getNumManifolds(); ++i)
    n += dispatcher_->getInternalManifoldPointer()[i]->getNumContacts();
  return n;
}

std::vector<Pose> BulletWorld::poses() const {
  std::vector<Pose> poses;
  for (const auto& [id, floe] : floes_) {
    const btTransform& at = floe.body->getWorldTransform();
    const btQuaternion turn = at.getRotation();
    poses.push_back({rigid_body::from_bullet(at.getOrigin()), {turn.w(), turn.x(), turn.y(), turn.z()}});
  }
  return poses;
}

BulletBody BulletWorld::make(const std::vector<rigid_body::ConvexPart>& solids, const rigid_body::MassProperties& mass,
                             const Pose& pose, double friction) const {
  BulletBody made;
  made.compound = std::make_unique<btCompoundShape>();
  for (const rigid_body::ConvexPart& solid : solids) {
    const std::vector<Vec3> corners = rigid_body::inset_vertices(solid, case_.contact.margin);
    if (corners.size() < 4) continue;
    made.parts.push_back(std::make_unique<btConvexHullShape>(&corners[0].x, static_cast<int>(corners.size()),
                                                             static_cast<int>(sizeof(Vec3))));
    made.parts.back()->setMargin(case_.contact.margin);
    made.compound->addChildShape(btTransform::getIdentity(), made.parts.back().get());
  }
  btCollisionShape* shape = made.compound.get();
  if (made.parts.size() == 1) shape = made.parts[0].get();
  const btRigidBody::btRigidBodyConstructionInfo info(mass.mass, nullptr, shape, to_bullet(mass.inertia));
  made.body = std::make_unique<btRigidBody>(info);
  made.body->setWorldTransform(to_bullet(pose));
  made.body->setFriction(friction);
  return made;
}

BulletBody BulletWorld::make_floe(const FloeThen& floe) {
  const double thickness = case_.ice.thickness;
  std::vector<std::vector<Vec2>> parts;
  for (const geometry::Ring& part : geometry::convex_parts(floe.outline)) parts.push_back(floes::to_metres(part));
  const auto placed =
      rigid_body::place_prism(floes::rings_in_metres(floe.outline), parts, thickness, floe.pose.position.z);
  const auto mass = rigid_body::mass_properties(placed.prism, case_.ice.density, case_.hydrodynamics.added_mass);
  std::vector<rigid_body::ConvexPart> solids;
  for (const auto& ring : placed.prism.parts)
    solids.push_back(rigid_body::convex_prism(ring, -0.5 * thickness, 0.5 * thickness));
  BulletBody made = make(solids, mass, floe.pose, std::sqrt(case_.ice.friction_ice));
  world_->addRigidBody(made.body.get(), 1, 3);
  return made;
}

void BulletWorld::set_sheet(const std::vector<geometry::Polygon>& sheet, double bottom, double top) {
  std::map<Outline, std::vector<BulletBody>> now;
  for (const geometry::Polygon& polygon : sheet)
    for (const geometry::Ring& part : geometry::convex_parts(polygon)) {
      const std::vector<Vec2> ring = floes::to_metres(part);
      Outline key;
      for (const Vec2 v : ring) key.emplace_back(v.x, v.y);
      auto known = sheet_.extract(key);
      if (known.empty()) {
        BulletBody tile =
            make({rigid_body::convex_prism(ring, bottom, top)}, {0.0, {}}, {}, std::sqrt(case_.ice.friction_ice));
        if (tile.parts.empty()) continue;
        world_->addRigidBody(tile.body.get(), 2, 1);
        now[key].push_back(std::move(tile));
      } else {
        now[key] = std::move(known.mapped());
      }
    }
  for (auto& [key, tiles] : sheet_)
    for (auto& tile : tiles) world_->removeRigidBody(tile.body.get());
  sheet_ = std::move(now);
}

}  // namespace brash::benchmarks
