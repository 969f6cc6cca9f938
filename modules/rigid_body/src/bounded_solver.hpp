// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>

#include <array>
#include <cstdint>
#include <vector>

namespace brash::rigid_body {

/// Bullet's sequential impulses with an upper bound on each normal impulse (Eq. 16) and Coulomb's disc for friction.
///
/// Bullet's own iteration resolves contact rows with a kernel that knows the lower limit only, and bounds the two
/// tangential rows one by one, which allows sqrt(2) mu N. Here normal rows have both limits, and the second tangential
/// row gets what the first has left of the disc.
///
/// Bullet sets up the rows and takes the result back. The iterations run on compact copies of rows and velocities, with
/// Bullet's arithmetic: the same sums in the same order, so the same bits.
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
  /// A linear and an angular number side by side.
  using Pair = double __attribute__((vector_size(16)));
  /// A linear and an angular vector: x, y, z.
  using Spatial = std::array<Pair, 3>;

  /// One body's side of a row.
  struct Side {
    Spatial jacobian{};  ///< relative velocity per velocity of the body
    Spatial response{};  ///< change of the body's velocity per impulse
  };
  /// One constraint: keeps an impulse within limits that makes a relative velocity vanish.
  struct Row {
    Side a;
    Side b;
    std::uint32_t body_a = 0;       ///< in velocities_
    std::uint32_t body_b = 0;       ///< likewise
    double rhs = 0.0;               ///< impulse that would do so alone [N s]
    double softness = 0.0;          ///< Bullet's cfm
    double inverse_jacobian = 0.0;  ///< impulse per relative velocity [kg]
    double jacobian = 0.0;          ///< its inverse
    double lower = 0.0;             ///< [N s]
    double upper = 0.0;             ///< [N s]
    double impulse = 0.0;           ///< [N s]
  };
  /// Of a contact point: the normal row, its friction coefficient and the tangential rows.
  struct ContactRows {
    Row normal;
    double friction = 0.0;
    Row first;
    Row second;
  };

  void copy_in(const btSolverConstraint& from, Row& row) const;
  void copy_in();
  void copy_out();
  double resolve(Row& row);
  double resolve_friction(ContactRows& contact);

  std::vector<ContactRows> rows_;
  std::vector<Spatial> velocities_;  ///< changes of the bodies' velocities so far
};

}  // namespace brash::rigid_body
