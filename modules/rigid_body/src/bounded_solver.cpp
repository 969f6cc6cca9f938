// SPDX-License-Identifier: GPL-3.0-or-later
#include "bounded_solver.hpp"

#include <algorithm>
#include <cmath>

namespace brash::rigid_body {

void BoundedSolver::convertContacts(btPersistentManifold** manifolds, int n_manifolds,
                                    const btContactSolverInfo& info) {
  btSequentialImpulseConstraintSolver::convertContacts(manifolds, n_manifolds, info);
  for (int i = 0; i < m_tmpSolverContactConstraintPool.size(); ++i) {
    btSolverConstraint& row = m_tmpSolverContactConstraintPool[i];
    const auto* point = static_cast<const btManifoldPoint*>(row.m_originalContactPoint);
    row.m_upperLimit = bounds[static_cast<std::size_t>(point->m_index0)];
  }
}

void BoundedSolver::copy_in(const btSolverConstraint& from, Row& row, Response& response) const {
  // Bullet leaves out the direction for a body that does not move.
  const bool first_moves = m_tmpSolverBodyPool[from.m_solverBodyIdA].m_originalBody != nullptr;
  const btVector3 direction = first_moves ? from.m_contactNormal1 : -from.m_contactNormal2;
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    row.jacobian_a[i] = Pair{direction[k], from.m_relpos1CrossNormal[k]};
    row.turn_b[i] = from.m_relpos2CrossNormal[k];
    response.turn_a[i] = from.m_angularComponentA[k];
    response.turn_b[i] = from.m_angularComponentB[k];
  }
  row.body_a = static_cast<std::uint32_t>(from.m_solverBodyIdA);
  row.body_b = static_cast<std::uint32_t>(from.m_solverBodyIdB);
  row.rhs = from.m_rhs;
  row.inverse_jacobian = from.m_jacDiagABInv;
  response.jacobian = 1.0 / from.m_jacDiagABInv;
}

/// Of rows without softness, as all contacts here are.
void BoundedSolver::copy_in() {
  const btConstraintArray& tangential = m_tmpSolverContactFrictionConstraintPool;
  const auto n = static_cast<std::size_t>(m_tmpSolverContactConstraintPool.size());
  contacts_.resize(n);
  normals_.resize(n);
  normal_responses_.resize(n);
  tangentials_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const btSolverConstraint& normal = m_tmpSolverContactConstraintPool[static_cast<int>(i)];
    copy_in(normal, normals_[i], normal_responses_[i]);
    for (int k = 0; k < 2; ++k) {
      Tangential& row = tangentials_[i][static_cast<std::size_t>(k)];
      copy_in(tangential[normal.m_frictionIndex + k], row.row, row.response);
    }
    contacts_[i] = {.friction = tangential[normal.m_frictionIndex].m_friction, .bound = normal.m_upperLimit};
  }
  bodies_.resize(static_cast<std::size_t>(m_tmpSolverBodyPool.size()));
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    bodies_[i] = {.velocity = {}, .inverse_mass = m_tmpSolverBodyPool[static_cast<int>(i)].internalGetInvMass().x()};
}

void BoundedSolver::copy_out() {
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const btSolverConstraint& normal = m_tmpSolverContactConstraintPool[static_cast<int>(i)];
    normal.m_appliedImpulse = contacts_[i].normal;
    m_tmpSolverContactFrictionConstraintPool[normal.m_frictionIndex].m_appliedImpulse = contacts_[i].first;
    m_tmpSolverContactFrictionConstraintPool[normal.m_frictionIndex + 1].m_appliedImpulse = contacts_[i].second;
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const auto& [x, y, z] = bodies_[i].velocity;
    btSolverBody& body = m_tmpSolverBodyPool[static_cast<int>(i)];
    body.internalGetDeltaLinearVelocity().setValue(x[0], y[0], z[0]);
    body.internalGetDeltaAngularVelocity().setValue(x[1], y[1], z[1]);
  }
}

/// Changes a row's impulse within its limits; returns the change of relative velocity [m/s].
double BoundedSolver::resolve(const Row& row, const Response& response, Limits limits, double& impulse) {
  const auto relative = [](const Spatial& jacobian, const Spatial& velocity) {
    const Pair sum = jacobian[0] * velocity[0] + jacobian[1] * velocity[1] + jacobian[2] * velocity[2];
    return sum[0] + sum[1];
  };
  BodyState& a = bodies_[row.body_a];
  BodyState& b = bodies_[row.body_b];
  const Spatial jacobian_b{Pair{-row.jacobian_a[0][0], row.turn_b[0]}, Pair{-row.jacobian_a[1][0], row.turn_b[1]},
                           Pair{-row.jacobian_a[2][0], row.turn_b[2]}};
  double change = row.rhs;
  change -= relative(row.jacobian_a, a.velocity) * row.inverse_jacobian;
  change -= relative(jacobian_b, b.velocity) * row.inverse_jacobian;
  double wanted = impulse + change;
  if (wanted < limits.lower || wanted > limits.upper) {
    wanted = wanted < limits.lower ? limits.lower : limits.upper;
    change = wanted - impulse;
  }
  if (change == 0.0) return 0.0;
  impulse = wanted;
  const auto push = [&](BodyState& body, const Spatial& jacobian, const std::array<double, 3>& turn) {
    for (std::size_t k = 0; k < 3; ++k) body.velocity[k] += Pair{jacobian[k][0] * body.inverse_mass, turn[k]} * change;
  };
  push(a, row.jacobian_a, response.turn_a);
  push(b, jacobian_b, response.turn_b);
  return change * response.jacobian;
}

/// Eq. 6 for both tangential rows of a contact, as a disc.
double BoundedSolver::resolve_friction(Contact& contact, const std::array<Tangential, 2>& rows) {
  const double radius = contact.friction * contact.normal;
  if (radius == 0.0 && contact.first == 0.0 && contact.second == 0.0) return 0.0;
  const double first = resolve(rows[0].row, rows[0].response, {-radius, radius}, contact.first);
  const double left = std::sqrt(std::max(0.0, (radius - contact.first) * (radius + contact.first)));
  const double second = resolve(rows[1].row, rows[1].response, {-left, left}, contact.second);
  return std::max(std::abs(first), std::abs(second));
}

btScalar BoundedSolver::solveSingleIteration(int iteration, btCollisionObject**, int, btPersistentManifold**, int,
                                             btTypedConstraint**, int, const btContactSolverInfo&, btIDebugDraw*) {
  if (iteration == 0) copy_in();
  double largest = 0.0;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    Contact& contact = contacts_[i];
    const double change = resolve(normals_[i], normal_responses_[i], {0.0, contact.bound}, contact.normal);
    largest = std::max(largest, std::abs(change));
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i)
    largest = std::max(largest, resolve_friction(contacts_[i], tangentials_[i]));
  return largest * largest;
}

btScalar BoundedSolver::solveGroupCacheFriendlyFinish(btCollisionObject** bodies, int n_bodies,
                                                      const btContactSolverInfo& info) {
  copy_out();
  // Bullet reports impulses only when it warm starts, which would carry history from step to step.
  writeBackContacts(0, m_tmpSolverContactConstraintPool.size(), info);
  return btSequentialImpulseConstraintSolver::solveGroupCacheFriendlyFinish(bodies, n_bodies, info);
}

}  // namespace brash::rigid_body
