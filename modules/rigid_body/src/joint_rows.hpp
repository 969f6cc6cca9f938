// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>

#include <span>
#include <vector>

#include "bounded_solver.hpp"

namespace brash::rigid_body {

/// Bullet's constraints as rows of the bounded solver (docs/theory/contacts-and-bodies.md, (C4)), in an order that
/// depends on the bodies' states only.
class JointRows {
 public:
  /// Adds all rows to a solver that knows the bodies by their Body::in_solver.
  void add_to(BoundedSolver& solver, std::span<btTypedConstraint* const> constraints, const btContactSolverInfo& info);
  /// Gives each constraint the impulses that the solver left in its rows.
  void write_back(const BoundedSolver& solver, double dt);

 private:
  /// A row as btTypedConstraint::getInfo2 fills it; vectors have four numbers there.
  struct Row {
    btScalar linear_a[4]{}, angular_a[4]{};
    btScalar linear_b[4]{}, angular_b[4]{};
    btScalar error = 0.0;  ///< wanted relative velocity [m/s]
    btScalar softness = 0.0;
    btScalar least = 0.0;
    btScalar most = 0.0;
  };
  /// Rows of one constraint come in a row.
  struct Joint {
    btTypedConstraint* constraint = nullptr;
    std::size_t first_row = 0;
    int n_rows = 0;
  };

  void fill(btTypedConstraint& constraint, const btContactSolverInfo& info, int n_rows);

  std::vector<Joint> joints_;
  std::vector<Row> rows_;
};

}  // namespace brash::rigid_body
