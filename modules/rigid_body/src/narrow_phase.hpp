// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "body.hpp"
#include "edge_axes.hpp"
#include "overlap.hpp"

namespace brash::rigid_body {

/// Two parts whose boxes overlap; `first` is a floe's, or both are of sheets.
struct PartPair {
  const Part* first = nullptr;
  const Part* second = nullptr;
};

/// Parts that continue the solids of a pair's two parts. An axis that leads into one of these parts does not
/// separate: the face between two parts of one solid is not a surface.
struct Beside {
  std::span<const Part* const> first;   ///< other parts of the first part's body
  std::span<const Part* const> second;  ///< the same for the second; for a part of a sheet, its other parts near by
  bool none() const { return first.empty() && second.empty(); }
};

/// Where and how two parts touch. Looks at the present poses only: no history, so a step is a function of the state.
class NarrowPhase {
 public:
  /// Whether the parts overlap. Most pairs do not.
  bool overlap(const PartPair& pair);
  /// Whether the overlap that was found last is a contact; then `normal` and `patch` describe it.
  bool find_contact(const Beside& beside);
  /// The same for two parts of sheets, with a normal in the plane. Where no surface bounds the overlap there is none.
  bool find_contact_in_plane(const Beside& beside);

  Vec3 normal{};  ///< unit, from the second part into the first
  Patch patch;

 private:
  SeparatingAxis best_face(const Beside& beside);
  Vec3 direction(const Beside& beside);

  PartPair pair_;  ///< of the last overlap
  OverlapFinder finder_;
  EdgeAxes edge_axes_;
  std::vector<SeparatingAxis> axes_;
};

}  // namespace brash::rigid_body
