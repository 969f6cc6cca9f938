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

  /// One constraint, an impulse that makes a relative velocity vanish: what tells how far the impulse is from that. The
  /// relative velocity is that of both bodies along the row's direction, of the second against it.
  struct Row {
    Spatial jacobian_a{};            ///< direction, and turn of the first body
    std::array<double, 3> turn_b{};  ///< relative velocity per angular velocity of the second
    std::uint32_t body_a = 0;        ///< in bodies_
    std::uint32_t body_b = 0;        ///< likewise
    double rhs = 0.0;                ///< impulse that would do so alone [N s]
    double inverse_jacobian = 0.0;   ///< impulse per relative velocity [kg]
  };
  /// What a change of the row's impulse does, besides what direction and inverse masses tell.
  struct Response {
    std::array<double, 3> turn_a{};  ///< change of the first body's angular velocity per impulse
    std::array<double, 3> turn_b{};  ///< and of the second's
    double jacobian = 0.0;           ///< relative velocity per impulse [1/kg]
  };
  struct Tangential {
    Row row;
    Response response;
  };
  struct BodyState {
    Spatial velocity{};         ///< change so far
    double inverse_mass = 0.0;  ///< [1/kg]
  };
  struct Limits {
    double lower = 0.0;  ///< [N s]
    double upper = 0.0;  ///< [N s]
  };
  /// A contact point.
  struct Contact {
    double normal = 0.0;  ///< impulse [N s]
    double first = 0.0;   ///< and of the first tangential row
    double second = 0.0;  ///< and of the second
    double friction = 0.0;
    double bound = 0.0;  ///< of the normal impulse [N s]
  };

  void copy_in(const btSolverConstraint& from, Row& row, Response& response) const;
  void copy_in();
  void copy_out();
  double resolve(const Row& row, const Response& response, Limits limits, double& impulse);
  double resolve_friction(Contact& contact, const std::array<Tangential, 2>& rows);

  // Most contact points bear nothing, and of those an iteration reads contact and normal row alone. Each kind lies
  // apart from the others, for what an iteration costs is the memory that it goes through.
  std::vector<Contact> contacts_;
  std::vector<Row> normals_;
  std::vector<Response> normal_responses_;
  std::vector<std::array<Tangential, 2>> tangentials_;
  std::vector<BodyState> bodies_;
};

}  // namespace brash::rigid_body
