// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_world.hpp"

#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>

#include <cmath>

#include "turning.hpp"

namespace brash::rigid_body {
namespace {

/// Iterations stop when no row changes a relative velocity by more than this [m/s]: 0.01 N on 10 t of ice at 0.01 s.
constexpr double kStill = 1e-8;
/// Share of the turn that a split impulse gives which a step takes [-]: floes that part shall not tumble.
constexpr double kPartingTurn = 0.1;

/// SolverBody::stretch.
double stretch(const Body& body) {
  if (body.in_plane) return -1.0;  // as if it were without end along z
  const MassProperties& mass = body.mass;
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
          .stretch = stretch(body)};
}

btDefaultCollisionConstructionInfo without_manifolds() {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = 1;
  return info;
}

}  // namespace

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
    : BodyWorld(settings, std::make_unique<btDefaultCollisionConfiguration>(without_manifolds()),
                std::make_unique<Rows>()),
      contacts_(settings),
      between_sheets_(settings.ice_ice) {
  static_cast<Rows&>(*solver).world = this;
}

void ExactWorld::performDiscreteCollisionDetection() {
  find_contacts();
  release(contacts_.settled_and_hit());
}

void ExactWorld::release(const std::vector<Body*>& hit) {
  if (hit.empty()) return;
  for (Body* body : hit) {
    set_settled(*body, false);
    body->struck = true;
  }
  list_awake();
  find_contacts();
}

void ExactWorld::find_contacts() {
  updateAabbs();
  computeOverlappingPairs();  // forgets some of the pairs that have parted
  const std::vector<BodyPair>& pairs = sorted_pairs();
  meetings_.clear();
  pairs_of_sheets_.clear();
  for (auto next = pairs.begin(); next != pairs.end();) {
    const auto first = next;
    while (next != pairs.end() && next->first == first->first) ++next;
    if (first->first->is_floe())
      meetings_.push_back({first->first, {&*first, static_cast<std::size_t>(next - first)}});
    else
      pairs_of_sheets_.insert(pairs_of_sheets_.end(), first, next);
  }
  contacts_.find(meetings_, dispatcher, workers());
  between_sheets_.find(pairs_of_sheets_);
  contacts_.find_on_bed(order(), workers());
}

void ExactWorld::calculateSimulationIslands() { getSimulationIslandManager()->initUnionFind(0); }

/// Settled floes do not hold up a struck floe at first. A blow continues to the settled floes that it then runs into.
void ExactWorld::solve(std::span<btTypedConstraint* const> constraints, const btContactSolverInfo& info) {
  while (contacts_.struck_touch_settled()) {
    solve_rows(constraints, info, ContactSet::Which::kWithoutSettled);
    const std::vector<Body*> hit = contacts_.settled_and_hit(bounded_);
    if (hit.empty()) break;
    release(hit);
  }
  solve_rows(constraints, info, ContactSet::Which::kAll);
  joints_.write_back(bounded_, info.m_timeStep);
  each_body([this](Body& body) {
    body.struck = false;
    if (!body.is_free()) return;
    const Twist after = bounded_.twist(body.in_solver);
    body.bullet->setLinearVelocity(to_bullet(after.linear));
    body.bullet->setAngularVelocity(to_bullet(after.angular));
  });
}

void ExactWorld::solve_rows(std::span<btTypedConstraint* const> constraints, const btContactSolverInfo& info,
                            ContactSet::Which which) {
  bounded_.clear(settings().restitution);
  in_solver_.clear();
  for (Body* body : order()) {
    body->in_solver = BoundedSolver::kFixed;
    const bool of_sheet = body->sheet != nullptr || (body->kind == BodyKind::kSheet && body->twist == Twist{});
    if ((of_sheet && !body->is_free()) || body->settled) continue;
    in_solver_.push_back(body);
    body->in_solver = static_cast<std::uint32_t>(in_solver_.size());
  }
  if (Body* const bed = contacts_.moving_bed()) {
    in_solver_.push_back(bed);
    bed->in_solver = static_cast<std::uint32_t>(in_solver_.size());
  }
  if (any_drifts())
    for (Body* body : order())
      if (body->sheet != nullptr) body->in_solver = body->sheet->in_solver;
  bounded_.add_bodies(in_solver_.size(), workers(), [this](std::size_t i) { return to_solver(*in_solver_[i]); });
  joints_.add_to(bounded_, constraints, info);
  contacts_.add_to(bounded_, info.m_timeStep, workers(), which);
  between_sheets_.add_to(bounded_, info.m_timeStep);
  last_change_ = bounded_.solve(settings().iterations, kStill, workers());
}

void ExactWorld::integrateTransforms(btScalar dt) {
  average_velocities();
  contacts_.report(bounded_, dt, loads_, workers());
  between_sheets_.report(bounded_, dt, loads_of_sheets_);
  links().report(dt);
  each_body([this, dt](Body& body) {
    if (body.in_plane)
      finish_in_plane(body);
    else if (body.is_free())
      advance(body, dt);
    else
      move_as_told(body);
  });
}

/// The velocity is new. Its parts are moved as move_sheet_part() says.
void ExactWorld::finish_in_plane(Body& body) {
  if (body.is_free()) body.twist = bounded_.twist(body.in_solver);
  finish(body, body.pose);
}

void ExactWorld::advance(Body& body, double dt) {
  body.twist = bounded_.twist(body.in_solver);
  const Twist parting = bounded_.parting(body.in_solver);
  Pose pose = body.pose;
  body.unparted.reset();
  if (parting != Twist{}) {
    body.unparted = advanced(pose, body.twist, dt);
    pose = advanced(pose, {parting.linear, kPartingTurn * parting.angular}, dt);
  }
  body.gained_by_turning = 0.0;
  if (body.mass.added_across == 0.0) return finish(body, advanced(pose, body.twist, dt));
  const double before = body.kinetic_energy();
  const Turn turn = turned_with_water(body.mass, pose, body.twist, body.stream, dt);
  body.twist = turn.twist;
  finish(body, turn.pose);
  body.gained_by_turning = body.kinetic_energy() - before;
}

}  // namespace brash::rigid_body
