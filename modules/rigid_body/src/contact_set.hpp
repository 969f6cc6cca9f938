// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>

#include <optional>
#include <span>
#include <vector>

#include "bounded_solver.hpp"
#include "brash/core/workers.hpp"
#include "narrow_phase.hpp"

namespace brash::rigid_body {

/// The contacts of one step: found at the present poses, handed to the solver, reported with the impulses that it left
/// in them.
class ContactSet {
 public:
  explicit ContactSet(const WorldSettings& settings)
      : ice_structure_(settings.ice_structure),
        ice_ice_(settings.ice_ice),
        bed_(settings.bed),
        release_speed_(settings.release_speed) {
    bed_body_.id = kNoBody;
    bed_body_.kind = BodyKind::kBed;
    if (!bed_) return;
    bed_body_.twist.linear = {bed_->velocity.x, bed_->velocity.y, 0.0};
    bed_body_.mean_twist = bed_body_.loaded_twist = bed_body_.twist;
  }

  /// A floe and the bodies whose boxes overlap its own, in the order of the step; all have it first.
  struct Meeting {
    Body* first;
    std::span<const BodyPair> pairs;
  };
  /// Forgets the contacts of the step before and finds the contacts of these floes, which come in the order of the
  /// step.
  /// @param dispatcher  says which bodies do not collide: two that are linked, for one.
  void find(std::span<const Meeting> meetings, btDispatcher& dispatcher, Workers& workers);
  /// Adds the contacts of floes with the bed; `bodies` in the order of the step.
  void find_on_bed(std::span<Body* const> bodies, Workers& workers);
  /// The bed for a solver, if it moves; else none, and it is BoundedSolver::kFixed.
  Body* moving_bed() { return bed_body_.twist == Twist{} ? nullptr : &bed_body_; }
  /// The settled floes that another body runs into faster than WorldSettings::release_speed.
  std::vector<Body*> settled_and_hit() const;
  /// All contacts, or without the contacts of struck floes with settled ones.
  enum class Which { kAll, kWithoutSettled };
  /// Adds them to a solver that knows the bodies by their Body::in_solver.
  void add_to(BoundedSolver& solver, double dt, Workers& workers, Which which = Which::kAll);
  /// Whether a struck floe touches a settled one.
  bool struck_touch_settled() const;
  /// The settled floes that a struck one runs into faster than WorldSettings::release_speed, at its velocity
  /// after that solver.
  std::vector<Body*> settled_and_hit(const BoundedSolver& solver) const;
  /// Fills `loads` with the load of each point that carries any after that solver, sorted by (body, other, point).
  void report(const BoundedSolver& solver, double dt, std::vector<ContactLoad>& loads, Workers& workers);

 private:
  /// A contact of two parts.
  struct Contact {
    /// A pair of floes is reported from the lower id.
    bool reported_turned() const { return first->is_floe() && second->is_floe() && second->id < first->id; }
    std::span<const PatchPoint> points() const {
      return std::span(patch.points).first(static_cast<std::size_t>(patch.n_points));
    }

    Body* first;
    Body* second;
    int first_part;
    Vec3 normal;
    Patch patch;
    ContactLaw law;
    bool moves_a_body;  ///< whether its impulses do: the solver finds them
  };

  /// The search of a thread: scratch space.
  struct Search {
    Beside beside(const Part& part, const Part& of_second);

    NarrowPhase narrow_phase;
    OverlapFinder below;                  ///< finds parts of floes below the surface of the bed
    std::vector<const Part*> near_sheet;  ///< the parts of the sheet that the floe meets
    std::vector<const Part*> beside_first;
    std::vector<const Part*> beside_second;
  };
  /// The contacts of some floes that follow each other.
  struct Found {
    std::vector<Contact> contacts;
    std::vector<Body*> hit;  ///< settled_and_hit()
  };

  const ContactLaw& law(const Body& second) const {
    return second.kind == BodyKind::kStructure ? ice_structure_ : ice_ice_;
  }
  void find(const Meeting& meeting, btDispatcher& dispatcher, Search& search, Found& found) const;
  void find(const Part& part, Body& second, Search& search, std::vector<Contact>& contacts) const;
  void find_on_bed(const Body& floe, OverlapFinder& finder, std::vector<Contact>& contacts);
  static bool is_of_struck_and_settled(const Contact& contact);
  bool hits_settled(const Contact& contact) const;
  bool closes_fast(const Contact& contact, const Twist& first, const Twist& second) const;
  /// The impulse of a point between bodies that nothing moves, in a step of `dt` [s]: its bound, while they close up.
  static PointImpulse crushed(const Contact& contact, const PatchPoint& point, double dt);
  static ContactLoad load(const Contact& contact, const PatchPoint& point, const PointImpulse& impulse, double dt);

  /// A contact on its way into the order of the report.
  struct Listed {
    BodyId other;
    std::size_t number;  ///< in the order of the step
    std::size_t solved;  ///< number of its first point in the solver, if that knows it
    const Contact* contact;
  };
  /// A contact, and the body from which it is reported.
  struct Reported {
    std::size_t body;      ///< index of its id
    std::size_t n_solved;  ///< points in the solver
    Listed listed;
  };
  /// A point of two bodies, on its way into the order of the report.
  struct ListedPoint {
    std::size_t number;
    PointImpulse impulse;
    const Contact* contact;
    const PatchPoint* point;
  };
  void list_by_body(Workers& workers);
  void report_body(std::span<Listed> listed, const BoundedSolver& solver, double dt, std::vector<ListedPoint>& points,
                   std::vector<ContactLoad>& loads) const;

  ContactLaw ice_structure_;
  ContactLaw ice_ice_;
  std::optional<Bed> bed_;
  double release_speed_;                          ///< [m/s]
  Body bed_body_;                                 ///< the bed as the other body of its contacts
  std::vector<Search> searches_;                  ///< of each worker
  std::vector<Found> found_;                      ///< of each chunk of floes
  std::vector<std::vector<Contact>> on_bed_;      ///< of each chunk of bodies
  std::vector<const Contact*> solved_;            ///< those that the solver knows
  std::vector<const Contact*> contacts_;          ///< all, in the order of the step
  std::vector<std::size_t> of_body_;              ///< scratch of report: where the contacts of each body begin
  std::vector<Reported> reported_;                ///< scratch of report: of each contact
  std::vector<Listed> listed_;                    ///< scratch of report
  std::vector<std::vector<ListedPoint>> points_;  ///< scratch of report: of one pair of bodies, of each worker
  std::vector<std::vector<ContactLoad>> loads_;   ///< scratch of report: of each chunk of bodies
};

}  // namespace brash::rigid_body
