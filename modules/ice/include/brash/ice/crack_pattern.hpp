// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "brash/geometry/ice_sheet.hpp"
#include "brash/ice/plate.hpp"
#include "brash/model/case.hpp"
#include "brash/statistics/random.hpp"

namespace brash::ice {

/// Where a plate is to crack: the ice within the region breaks off, split along the cracks.
struct CrackPlan {
  geometry::CrackedRegion cracked;
  Vec2 centre{};       ///< of a circle around the region, plate frame [m]
  double reach = 0.0;  ///< its radius [m]
  int n_wedges = 1;    ///< between the cracks
  bool along_stress = false;
};

/// How ice cracks where it fails in bending.
class CrackPattern {
 public:
  virtual ~CrackPattern() = default;
  /// @param contact     where the plate is loaded, plate frame: midpoint B and normal into the ice.
  /// @param assessment  with the breaking length, and the crack in the plate's frame where the criterion knows it.
  /// @param random      of this break alone.
  virtual CrackPlan plan(const Plate& plate, const geometry::ContactRegion& contact,
                         const failure::Assessment& assessment, statistics::RandomStream& random) const = 0;
};

/// The pattern that the case chooses:
/// - kDisc: a circle around B with the breaking length as radius, divided by radial cracks into 3 to 5
///   wedges (after Nevel). Paper, Sec. 2.2.2, Fig. 2.
/// - kStress: the crack of the assessment from free edge to free edge, divided as the disc is, at equal lengths of the
///   crack. The disc where there is no such crack.
std::unique_ptr<CrackPattern> make_crack_pattern(const model::FailureSection& section);

}  // namespace brash::ice
