// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "bounded_solver.hpp"
#include "narrow_phase.hpp"

namespace brash::rigid_body {

/// The contacts of one step: found at the present poses, handed to the solver, reported with the impulses that it left
/// in them.
class ContactSet {
 public:
  explicit ContactSet(const WorldSettings& settings)
      : ice_structure_(settings.ice_structure), ice_ice_(settings.ice_ice) {
    ground_.id = kNoBody;
    ground_.kind = BodyKind::kSheet;
  }

  /// Forgets all contacts.
  void clear() { contacts_.clear(); }
  /// Contacts of `first`, a floe, come next, until end(). Floes come in the order of the step.
  void begin(Body& first);
  /// Its box and the box of `second` overlap. All these bodies are told before the first of its contacts is found.
  void meet(const Body& second);
  /// Finds the contacts of the floe with one of those bodies. The two may come either way round, the bodies in the
  /// order of the step.
  void find(Body& one, Body& other);
  void end();
  /// Adds contacts that were found elsewhere; of bodies in the order of the step.
  void add(std::span<const GivenContact> given, const std::function<Body*(BodyId)>& find_body);
  /// The settled floes that another body runs into faster than `speed` [m/s].
  std::vector<Body*> settled_and_hit(double speed) const;
  /// Adds all of them to a solver that knows the bodies by their Body::in_solver.
  void add_to(BoundedSolver& solver, double dt) const;
  /// Fills `loads` with the load of each point that bears any after that solver, sorted by (body, other, point).
  void report(const BoundedSolver& solver, double dt, std::vector<ContactLoad>& loads);

 private:
  /// A contact of two parts, or one that was given.
  struct Contact {
    /// A pair of floes is reported from the lower id.
    bool reported_turned() const { return first->is_floe() && second->is_floe() && second->id < first->id; }
    /// Whether its impulses move a body: the solver finds them.
    bool moves_a_body() const { return first->is_free() || second->is_free(); }
    std::span<const PatchPoint> points() const {
      return std::span(patch.points).first(static_cast<std::size_t>(patch.n_points));
    }

    Body* first;
    Body* second;
    int first_part;
    Vec3 normal;
    Patch patch;
    ContactLaw law;
  };

  const ContactLaw& law(const Body& second) const {
    return second.kind == BodyKind::kStructure ? ice_structure_ : ice_ice_;
  }
  void find(const Part& part, Body& second);
  std::span<const Part* const> beside(const Part& part, const Part& of_second);
  /// The impulse of a point between bodies that nothing moves, in a step of `dt` [s]: its bound, while they close up.
  static PointImpulse crushed(const Contact& contact, const PatchPoint& point, double dt);
  static ContactLoad load(const Contact& contact, const PatchPoint& point, const PointImpulse& impulse, double dt);

  /// A contact on its way into the order of the report.
  struct Listed {
    BodyId body;
    BodyId other;
    std::size_t number;  ///< of its first point, in the solver if that knows it
    const Contact* contact;
  };
  /// A point of two bodies, likewise.
  struct ListedPoint {
    std::size_t number;
    PointImpulse impulse;
    const Contact* contact;
    const PatchPoint* point;
  };

  ContactLaw ice_structure_;
  ContactLaw ice_ice_;
  Body ground_;  ///< bears a given contact without another body
  NarrowPhase narrow_phase_;
  std::vector<Contact> contacts_;
  std::vector<Listed> listed_;              ///< scratch of report
  std::vector<ListedPoint> points_;         ///< scratch of report: of one pair of bodies
  Body* first_ = nullptr;                   ///< whose contacts come
  std::size_t first_contact_ = 0;           ///< of that floe
  std::vector<const Part*> near_sheet_;     ///< the parts of the sheet that it meets
  std::vector<const Part*> beside_first_;   ///< scratch of find
  std::vector<const Part*> beside_second_;  ///< scratch of find
};

}  // namespace brash::rigid_body
