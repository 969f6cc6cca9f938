// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "bounded_solver.hpp"
#include "narrow_phase.hpp"

namespace brash::rigid_body {

/// The contacts of one step between sheets that drift, and of such a sheet with fixed ice or a wall. A sheet is there
/// in parts that lie side by side, so a face counts only where no other part of the sheet continues behind it. The
/// bodies of the solver are the sheets; docs/theory/fracture-of-floes.md, (G10).
class SheetContacts {
 public:
  /// @param law  of ice on ice.
  explicit SheetContacts(const ContactLaw& law) : law_(law) {}

  /// Forgets the contacts of the step before, and finds the contacts of pairs of parts whose boxes overlap.
  void find(std::span<const BodyPair> pairs);
  /// Adds all contacts to a solver that knows the sheets by the Body::in_solver of their parts.
  void add_to(BoundedSolver& solver, double dt);
  /// Fills `loads` with the load of each point that carries any after that solver.
  void report(const BoundedSolver& solver, double dt, std::vector<ContactLoad>& loads) const;

 private:
  /// Of a part of a sheet that gives way with a part of another.
  struct Contact {
    Body* first;
    Body* second;
    Vec3 normal;
    Patch patch;

    std::span<const PatchPoint> points() const {
      return std::span(patch.points).first(static_cast<std::size_t>(patch.n_points));
    }
  };
  void list_met(std::span<const BodyPair> pairs);
  std::span<const Part* const> beside(const Body& body, const Body& met_by, std::vector<const Part*>& parts) const;

  ContactLaw law_;
  NarrowPhase narrow_phase_;
  std::vector<std::pair<int, const Part*>> met_;  ///< by the rank of a body: the parts that it meets
  std::vector<const Part*> beside_first_;
  std::vector<const Part*> beside_second_;
  std::vector<Contact> contacts_;    ///< in an order that states alone give
  std::size_t first_in_solver_ = 0;  ///< number of their first point
};

}  // namespace brash::rigid_body
