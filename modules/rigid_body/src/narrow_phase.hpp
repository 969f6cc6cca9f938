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

/// Where and how two parts touch. Looks at the present poses only: no history, so a step is a function of the state.
class NarrowPhase {
 public:
  /// Whether the parts overlap; then `normal` and `patch` describe how.
  ///
  /// @param beside_first   other parts of the first part's body. An axis that leads into one of them does not
  ///                       separate: the face between two parts of one solid is no surface.
  /// @param beside_second  likewise for the second; for a part of the sheet, the sheet's other parts near by.
  bool find(const PartPair& pair, std::span<const Part* const> beside_first,
            std::span<const Part* const> beside_second);

  /// Likewise for two parts of sheets, with a normal in the plane. Where no surface bounds the overlap there is none.
  bool find_in_plane(const PartPair& pair, std::span<const Part* const> beside_first,
                     std::span<const Part* const> beside_second);

  Vec3 normal{};  ///< unit, from the second part into the first
  Patch patch;

 private:
  /// The parts beside the two parts of the pair.
  struct Beside {
    std::span<const Part* const> first;
    std::span<const Part* const> second;
    bool none() const { return first.empty() && second.empty(); }
  };
  SeparatingAxis best_face(const Overlap& overlap, const Beside& beside);
  Vec3 direction(const PartPair& pair, const Overlap& overlap, const Beside& beside);

  OverlapFinder finder_;
  EdgeAxes edge_axes_;
  std::vector<SeparatingAxis> axes_;
};

}  // namespace brash::rigid_body
