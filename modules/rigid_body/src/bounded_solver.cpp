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

/// Changes the row's impulse within its limits; returns the change of relative velocity [m/s].
double BoundedSolver::resolve(const btSolverConstraint& row) {
  return m_resolveSingleConstraintRowGeneric(m_tmpSolverBodyPool[row.m_solverBodyIdA],
                                             m_tmpSolverBodyPool[row.m_solverBodyIdB], row);
}

/// Eq. 6 for both tangential rows of a contact, as a disc.
double BoundedSolver::resolve_friction(const btSolverConstraint& normal) {
  btSolverConstraint& first = m_tmpSolverContactFrictionConstraintPool[normal.m_frictionIndex];
  btSolverConstraint& second = m_tmpSolverContactFrictionConstraintPool[normal.m_frictionIndex + 1];
  const double radius = first.m_friction * normal.m_appliedImpulse;
  if (radius == 0.0 && first.m_appliedImpulse == 0.0 && second.m_appliedImpulse == 0.0) return 0.0;
  first.m_upperLimit = radius;
  first.m_lowerLimit = -radius;
  const double change = resolve(first);
  const double along = first.m_appliedImpulse;
  const double left = std::sqrt(std::max(0.0, (radius - along) * (radius + along)));
  second.m_upperLimit = left;
  second.m_lowerLimit = -left;
  return std::max(std::abs(change), std::abs(resolve(second)));
}

btScalar BoundedSolver::solveSingleIteration(int, btCollisionObject**, int, btPersistentManifold**, int,
                                             btTypedConstraint**, int, const btContactSolverInfo&, btIDebugDraw*) {
  double largest = 0.0;
  const btConstraintArray& contacts = m_tmpSolverContactConstraintPool;
  for (int i = 0; i < contacts.size(); ++i) largest = std::max(largest, std::abs(resolve(contacts[i])));
  for (int i = 0; i < contacts.size(); ++i) largest = std::max(largest, resolve_friction(contacts[i]));
  return largest * largest;
}

btScalar BoundedSolver::solveGroupCacheFriendlyFinish(btCollisionObject** bodies, int n_bodies,
                                                      const btContactSolverInfo& info) {
  // Bullet reports impulses only when it warm starts, which would carry history from step to step.
  writeBackContacts(0, m_tmpSolverContactConstraintPool.size(), info);
  return btSequentialImpulseConstraintSolver::solveGroupCacheFriendlyFinish(bodies, n_bodies, info);
}

}  // namespace brash::rigid_body
