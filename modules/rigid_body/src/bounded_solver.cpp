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

void BoundedSolver::copy_in(const btSolverConstraint& from, Row& row) const {
  const auto copy = [](const btVector3& linear, const btVector3& angular, Spatial& to) {
    for (int k = 0; k < 3; ++k) to[static_cast<std::size_t>(k)] = Pair{linear[k], angular[k]};
  };
  const btVector3& inverse_mass_a = m_tmpSolverBodyPool[from.m_solverBodyIdA].internalGetInvMass();
  const btVector3& inverse_mass_b = m_tmpSolverBodyPool[from.m_solverBodyIdB].internalGetInvMass();
  copy(from.m_contactNormal1, from.m_relpos1CrossNormal, row.a.jacobian);
  copy(from.m_contactNormal1 * inverse_mass_a, from.m_angularComponentA, row.a.response);
  copy(from.m_contactNormal2, from.m_relpos2CrossNormal, row.b.jacobian);
  copy(from.m_contactNormal2 * inverse_mass_b, from.m_angularComponentB, row.b.response);
  row.body_a = static_cast<std::uint32_t>(from.m_solverBodyIdA);
  row.body_b = static_cast<std::uint32_t>(from.m_solverBodyIdB);
  row.rhs = from.m_rhs;
  row.softness = from.m_cfm;
  row.inverse_jacobian = from.m_jacDiagABInv;
  row.jacobian = 1.0 / from.m_jacDiagABInv;
  row.lower = from.m_lowerLimit;
  row.upper = from.m_upperLimit;
  row.impulse = from.m_appliedImpulse;
}

void BoundedSolver::copy_in() {
  const btConstraintArray& friction = m_tmpSolverContactFrictionConstraintPool;
  rows_.resize(static_cast<std::size_t>(m_tmpSolverContactConstraintPool.size()));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const btSolverConstraint& normal = m_tmpSolverContactConstraintPool[static_cast<int>(i)];
    const btSolverConstraint& first = friction[normal.m_frictionIndex];
    copy_in(normal, rows_[i].normal);
    rows_[i].friction = first.m_friction;
    copy_in(first, rows_[i].first);
    copy_in(friction[normal.m_frictionIndex + 1], rows_[i].second);
  }
  velocities_.assign(static_cast<std::size_t>(m_tmpSolverBodyPool.size()), Spatial{});
}

void BoundedSolver::copy_out() {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const btSolverConstraint& normal = m_tmpSolverContactConstraintPool[static_cast<int>(i)];
    normal.m_appliedImpulse = rows_[i].normal.impulse;
    m_tmpSolverContactFrictionConstraintPool[normal.m_frictionIndex].m_appliedImpulse = rows_[i].first.impulse;
    m_tmpSolverContactFrictionConstraintPool[normal.m_frictionIndex + 1].m_appliedImpulse = rows_[i].second.impulse;
  }
  for (std::size_t i = 0; i < velocities_.size(); ++i) {
    const auto& [x, y, z] = velocities_[i];
    btSolverBody& body = m_tmpSolverBodyPool[static_cast<int>(i)];
    body.internalGetDeltaLinearVelocity().setValue(x[0], y[0], z[0]);
    body.internalGetDeltaAngularVelocity().setValue(x[1], y[1], z[1]);
  }
}

/// Changes the row's impulse within its limits; returns the change of relative velocity [m/s].
double BoundedSolver::resolve(Row& row) {
  const auto relative = [](const Spatial& jacobian, const Spatial& velocity) {
    const Pair sum = jacobian[0] * velocity[0] + jacobian[1] * velocity[1] + jacobian[2] * velocity[2];
    return sum[0] + sum[1];
  };
  Spatial& a = velocities_[row.body_a];
  Spatial& b = velocities_[row.body_b];
  double change = row.rhs - row.impulse * row.softness;
  change -= relative(row.a.jacobian, a) * row.inverse_jacobian;
  change -= relative(row.b.jacobian, b) * row.inverse_jacobian;
  double impulse = row.impulse + change;
  if (impulse < row.lower || impulse > row.upper) {
    impulse = impulse < row.lower ? row.lower : row.upper;
    change = impulse - row.impulse;
  }
  row.impulse = impulse;
  const auto push = [&](Spatial& velocity, const Spatial& response) {
    velocity = {velocity[0] + response[0] * change, velocity[1] + response[1] * change,
                velocity[2] + response[2] * change};
  };
  push(a, row.a.response);
  push(b, row.b.response);
  return change * row.jacobian;
}

/// Eq. 6 for both tangential rows of a contact, as a disc.
double BoundedSolver::resolve_friction(ContactRows& contact) {
  auto& [normal, friction, first, second] = contact;
  const double radius = friction * normal.impulse;
  if (radius == 0.0 && first.impulse == 0.0 && second.impulse == 0.0) return 0.0;
  first.upper = radius;
  first.lower = -radius;
  const double change = resolve(first);
  const double along = first.impulse;
  const double left = std::sqrt(std::max(0.0, (radius - along) * (radius + along)));
  second.upper = left;
  second.lower = -left;
  return std::max(std::abs(change), std::abs(resolve(second)));
}

btScalar BoundedSolver::solveSingleIteration(int iteration, btCollisionObject**, int, btPersistentManifold**, int,
                                             btTypedConstraint**, int, const btContactSolverInfo&, btIDebugDraw*) {
  if (iteration == 0) copy_in();
  double largest = 0.0;
  for (ContactRows& contact : rows_) largest = std::max(largest, std::abs(resolve(contact.normal)));
  for (ContactRows& contact : rows_) largest = std::max(largest, resolve_friction(contact));
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
