// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/geometry/ice_sheet.hpp"
#include "brash/geometry/ledger.hpp"
#include "brash/model/checkpoint.hpp"
#include "plan.hpp"

namespace brash::simulation {

/// What a break made.
struct Broken {
  std::vector<geometry::Polygon> floes;
  geometry::Extent changed;  ///< around all of the sheet that is not as before
};

/// The sheet with its ledger: every operation moves area from one account to another, exactly.
class IceField {
 public:
  /// A rectangle of level ice: x from 0 to `length`, |y| <= width/2 [m].
  IceField(double length, double width);
  /// The ice and the accounts of a run that goes on.
  explicit IceField(const model::Checkpoint& checkpoint);
  void save(model::Checkpoint& checkpoint) const;

  const geometry::IceSheet& sheet() const { return sheet_; }
  const geometry::Ledger& ledger() const { return ledger_; }

  /// Ice inside `section` is crushed and leaves. @return around all of the sheet that is not as before.
  geometry::Extent crush(std::span<const geometry::Point> section);

  /// Breaks a disc free and splits it into wedges; what `section` covers of them is crushed and leaves.
  ///
  /// @param section        the structure's leading section: no floe is born inside the structure.
  /// @param smallest_floe  pieces below this area become brash [m2].
  /// @return the floes, parts of the sheet that lost their connection included.
  Broken break_free(Vec2 centre, double radius, int n_wedges, int sides, std::span<const geometry::Point> section,
                    double smallest_floe);

  /// Books a floe without a body as brash.
  void floe_to_brash(geometry::ExactArea area);
  /// Books a crushed floe as deleted.
  void floe_to_deleted(geometry::ExactArea area);

 private:
  IceField(std::span<const geometry::Polygon> sheet, const geometry::Ledger& ledger);
  void book_cut(const geometry::Cut& cut);
  std::vector<geometry::Polygon> carve(const geometry::Polygon& piece, std::span<const geometry::Point> section);

  geometry::IceSheet sheet_;
  geometry::Ledger ledger_;
};

}  // namespace brash::simulation
