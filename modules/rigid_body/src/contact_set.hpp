// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <vector>

#include "broad_phase.hpp"
#include "narrow_phase.hpp"

namespace brash::rigid_body {

/// The contacts of one step: found at the present poses, handed to the solver, reported with what it left in them.
class ContactSet {
 public:
  explicit ContactSet(const WorldSettings& settings)
      : ice_structure_(settings.ice_structure), ice_ice_(settings.ice_ice) {}

  /// Replaces the contacts by those of the pairs, and `bounds` by the limits of their points' normal impulses [N s].
  void find(const std::vector<PartPair>& pairs, double dt, std::vector<double>& bounds);
  /// The settled floes that another body runs into faster than `speed` [m/s].
  std::vector<Body*> settled_and_hit(double speed) const;
  /// For the solver; they hold until the next find().
  std::vector<btPersistentManifold*> manifolds();
  /// Fills `loads` with each point's load after the solver, sorted by (body, other, point).
  void report(double dt, const std::vector<double>& bounds, std::vector<ContactLoad>& loads);

 private:
  /// A contact of two parts on its way through the solver.
  struct Contact {
    Contact(Body& one, Body& other, Vec3 direction, const Patch& overlap)
        : first(&one),
          second(&other),
          normal(direction),
          patch(overlap),
          manifold(one.bullet.get(), other.bullet.get(), 0, BT_LARGE_FLOAT, BT_LARGE_FLOAT) {}

    /// A pair of floes is reported from the lower id.
    bool reported_turned() const { return second->is_floe() && second->id < first->id; }

    Body* first;
    Body* second;
    Vec3 normal;
    Patch patch;
    btPersistentManifold manifold;
  };

  const ContactLaw& law(const Body& second) const {
    return second.kind == BodyKind::kStructure ? ice_structure_ : ice_ice_;
  }
  void add(const PartPair& pair, double dt, std::vector<double>& bounds);
  ContactLoad load(const Contact& contact, int point, double dt, const std::vector<double>& bounds) const;

  /// A contact point on its way into the order of the report.
  struct Listed {
    BodyId body;
    BodyId other;
    Vec3 place;
    const Contact* contact;
    int point;
  };

  ContactLaw ice_structure_;
  ContactLaw ice_ice_;
  NarrowPhase narrow_phase_;
  std::vector<Contact> contacts_;
  std::vector<Listed> listed_;              ///< scratch of report
  std::vector<const Part*> near_sheet_;     ///< scratch of find
  std::vector<const Part*> beside_first_;   ///< scratch of find
  std::vector<const Part*> beside_second_;  ///< scratch of find
};

}  // namespace brash::rigid_body
