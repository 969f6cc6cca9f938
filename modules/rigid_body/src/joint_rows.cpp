// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_rows.hpp"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <tuple>

#include "body_world.hpp"

namespace brash::rigid_body {
namespace {

Vec3 vector(const btScalar* v) { return {v[0], v[1], v[2]}; }

const Body* body_or_none(const btRigidBody& body) { return static_cast<const Body*>(body.getUserPointer()); }

std::uint32_t in_solver(const btRigidBody& body) {
  const Body* known = body_or_none(body);
  return known != nullptr ? known->in_solver : BoundedSolver::kFixed;
}

/// Ranks of its bodies, then the order in which links were made.
auto place(const btTypedConstraint& c) {
  const auto rank = [](const btRigidBody& body) {
    const Body* known = body_or_none(body);
    return known != nullptr ? known->rank : -1;
  };
  return std::tuple(rank(c.getRigidBodyA()), rank(c.getRigidBodyB()), c.getUserConstraintId());
}

}  // namespace

void JointRows::fill(btTypedConstraint& constraint, const btContactSolverInfo& info, int n_rows) {
  const std::size_t first = rows_.size();
  const btScalar limit = constraint.getBreakingImpulseThreshold();
  rows_.resize(first + static_cast<std::size_t>(n_rows),
               {.softness = info.m_globalCfm, .least = -limit, .most = limit});
  Row& row = rows_[first];
  btTypedConstraint::btConstraintInfo2 info2{};
  info2.fps = 1.0 / info.m_timeStep;
  info2.erp = info.m_erp;
  info2.m_J1linearAxis = row.linear_a;
  info2.m_J1angularAxis = row.angular_a;
  info2.m_J2linearAxis = row.linear_b;
  info2.m_J2angularAxis = row.angular_b;
  info2.rowskip = sizeof(Row) / sizeof(btScalar);
  info2.m_constraintError = &row.error;
  info2.cfm = &row.softness;
  info2.m_lowerLimit = &row.least;
  info2.m_upperLimit = &row.most;
  info2.m_numIterations = info.m_numIterations;
  info2.m_damping = info.m_damping;
  constraint.getInfo2(&info2);
}

void JointRows::add_to(BoundedSolver& solver, std::span<btTypedConstraint* const> constraints,
                       const btContactSolverInfo& info) {
  joints_.clear();
  rows_.clear();
  for (btTypedConstraint* constraint : constraints)
    if (constraint->isEnabled()) joints_.push_back({.constraint = constraint});
  std::ranges::sort(joints_, {}, [](const Joint& joint) { return place(*joint.constraint); });
  for (Joint& joint : joints_) {
    btTypedConstraint::btConstraintInfo1 info1{};
    joint.constraint->buildJacobian();
    joint.constraint->getInfo1(&info1);
    joint.first_row = rows_.size();
    joint.n_rows = info1.m_numConstraintRows;
    if (joint.n_rows > 0) fill(*joint.constraint, info, joint.n_rows);
    for (std::size_t i = joint.first_row; i < rows_.size(); ++i) {
      const Row& row = rows_[i];
      solver.add(SolverJoint{.first = in_solver(joint.constraint->getRigidBodyA()),
                             .second = in_solver(joint.constraint->getRigidBodyB()),
                             .of_first = {vector(row.linear_a), vector(row.angular_a)},
                             .of_second = {vector(row.linear_b), vector(row.angular_b)},
                             .velocity = row.error,
                             .softness = row.softness,
                             .least = row.least,
                             .most = row.most});
    }
  }
}

void JointRows::write_back(const BoundedSolver& solver, double dt) {
  for (const Joint& joint : joints_) {
    btJointFeedback* const feedback = joint.constraint->getJointFeedback();
    Vec3 force_a{}, force_b{}, moment_a{}, moment_b{};
    double largest = 0.0;
    for (std::size_t i = joint.first_row; i < joint.first_row + static_cast<std::size_t>(joint.n_rows); ++i) {
      const double impulse = solver.joint_impulse(i);
      const double force = impulse / dt;
      largest = std::max(largest, std::abs(impulse));
      force_a += force * vector(rows_[i].linear_a);
      force_b += force * vector(rows_[i].linear_b);
      moment_a += force * vector(rows_[i].angular_a);
      moment_b += force * vector(rows_[i].angular_b);
    }
    joint.constraint->internalSetAppliedImpulse(largest);
    if (feedback == nullptr) continue;
    feedback->m_appliedForceBodyA = to_bullet(force_a);
    feedback->m_appliedForceBodyB = to_bullet(force_b);
    feedback->m_appliedTorqueBodyA = to_bullet(moment_a);
    feedback->m_appliedTorqueBodyB = to_bullet(moment_b);
  }
}

}  // namespace brash::rigid_body
