// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "brash/edge/edge_contact.hpp"

namespace brash::edge {

/// The ice at a contact. Plate theory knows even ice alone, so a contact is loaded and evaluated as if all of the sheet
/// were as it is there. docs/theory/ice.md
class LocalIce {
 public:
  /// At a place, frame of the sheet [m].
  LocalIce(const EdgeModel& sheet, Vec2 place);
  /// Where `contact` is.
  LocalIce(const EdgeModel& sheet, const EdgeContact& contact);

  const failure::IceProperties& ice() const { return ice_; }
  /// Refers to this object.
  EdgeModel model() const { return {sheet_.hull, sheet_.resolved, ice_, criterion_ ? *criterion_ : sheet_.criterion}; }

 private:
  LocalIce(const EdgeModel& sheet, const failure::IceProperties& ice);

  const EdgeModel& sheet_;
  failure::IceProperties ice_;
  std::unique_ptr<failure::BendingCriterion> criterion_;  ///< nothing where the ice is even
};

}  // namespace brash::edge
