// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "body_world.hpp"
#include "bounded_solver.hpp"
#include "contact_set.hpp"
#include "joint_rows.hpp"
#include "sheet_contacts.hpp"

namespace brash::rigid_body {

/// The engine of this program in Bullet's world: contacts are exact overlaps of the parts that Bullet's broad phase and
/// dispatcher let meet, a bounded solver takes the place of Bullet's, and a step is a function of the bodies' states.
class ExactWorld final : public BodyWorld {
 public:
  explicit ExactWorld(const WorldSettings& settings);

  /// Settled floes that are run into are released first, so that they take the blow as free floes.
  void performDiscreteCollisionDetection() override;

 private:
  class Rows;

  /// The rows of all bodies are solved together.
  void calculateSimulationIslands() override;
  void find_contacts();
  /// Releases settled floes that a blow reaches, and finds the contacts again.
  void release(const std::vector<Body*>& hit);
  void solve(std::span<btTypedConstraint* const> constraints, const btContactSolverInfo& info);
  void solve_rows(std::span<btTypedConstraint* const> constraints, const btContactSolverInfo& info,
                  ContactSet::Which which);
  /// New velocities from the solver, then Eqs. 9 and 10.
  void integrateTransforms(btScalar dt) override;
  void advance(Body& body, double dt);
  void finish_in_plane(Body& body);

  ContactSet contacts_;
  SheetContacts between_sheets_;
  JointRows joints_;
  std::vector<Body*> in_solver_;  ///< the bodies that the solver knows, in the order of their numbers there
  std::vector<ContactSet::Meeting> meetings_;  ///< scratch of find_contacts
  std::vector<BodyPair> pairs_of_sheets_;      ///< scratch of find_contacts
  BoundedSolver bounded_;
};

}  // namespace brash::rigid_body
