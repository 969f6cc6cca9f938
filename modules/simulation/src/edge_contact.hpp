// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/failure/criterion.hpp"
#include "brash/geometry/ice_sheet.hpp"
#include "brash/geometry/trapezoid.hpp"
#include "brash/io/case.hpp"
#include "brash/structure/cone.hpp"

namespace brash::simulation {

/// The structure against the edge of the fixed sheet, at one place, at one instant.
struct EdgeContact {
  geometry::ContactRegion region;
  geometry::Trapezoid wedge;
  failure::LoadCase load;
  failure::Assessment assessment;
  Vec3 force{};  ///< on the structure [N], Eq. 15 with friction
  Vec3 point{};  ///< where it acts [m]
};

/// What the edge contacts depend on besides the sheet.
struct EdgeModel {
  const structure::Cone& cone;
  const io::Case& resolved;
  const failure::IceProperties& ice;
  const failure::BendingCriterion& criterion;
};

/// Heights of the level ice floating at rest [m].
struct Freeboard {
  double top = 0.0;
  double bottom = 0.0;
};
Freeboard freeboard(const io::Case& resolved);

/// Ice as the failure criterion sees it.
failure::IceProperties ice_properties(const io::Case& resolved);

/// The criterion that the case names.
std::unique_ptr<failure::BendingCriterion> make_criterion(const io::Case& resolved, const failure::IceProperties& ice);

/// The section of the structure that meets the ice first: at the ice's top when it breaks downward, else at its bottom.
geometry::Ring leading_section(const EdgeModel& model, Vec2 centre);
/// The section that has passed through the whole thickness.
geometry::Ring trailing_section(const EdgeModel& model, Vec2 centre);

/// All contacts of the structure at `centre` with the sheet, each fitted, loaded and assessed.
///
/// Crushing: F_n = sigma_c A R (Eq. 15). A is the area of the structure's surface inside the ice: the overlap in plan
/// over cos(slope), or the overlap itself for `contact.area = "projected"`.
std::vector<EdgeContact> edge_contacts(const EdgeModel& model, const geometry::IceSheet& sheet, Vec2 centre);

}  // namespace brash::simulation
