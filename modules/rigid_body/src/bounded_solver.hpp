// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>

#include <vector>

namespace brash::rigid_body {

/// Bullet's sequential impulses with an upper bound on each normal impulse (Eq. 16) and Coulomb's disc for friction.
///
/// Bullet's own iteration resolves contact rows with a kernel that knows the lower limit only, and bounds the two
/// tangential rows one by one, which allows sqrt(2) mu N. Here normal rows go through the generic kernel, and the
/// second tangential row gets what the first has left of the disc.
class BoundedSolver : public btSequentialImpulseConstraintSolver {
 public:
  /// Bound of a contact point's normal impulse [N s], found by the point's `m_index0`.
  std::vector<double> bounds;

  /// Iterations of the last solve.
  int iterations_used() const { return m_analyticsData.m_numIterationsUsed; }

 protected:
  void convertContacts(btPersistentManifold** manifolds, int n_manifolds, const btContactSolverInfo& info) override;
  btScalar solveSingleIteration(int iteration, btCollisionObject** bodies, int n_bodies,
                                btPersistentManifold** manifolds, int n_manifolds, btTypedConstraint** constraints,
                                int n_constraints, const btContactSolverInfo& info, btIDebugDraw* draw) override;
  btScalar solveGroupCacheFriendlyFinish(btCollisionObject** bodies, int n_bodies,
                                         const btContactSolverInfo& info) override;

 private:
  double resolve(const btSolverConstraint& row);
  double resolve_friction(const btSolverConstraint& normal);
};

}  // namespace brash::rigid_body
