// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/failure/criterion.hpp"

namespace brash::failure {

/// From a place to a stretch.
double distance(Vec2 place, Vec2 from, Vec2 to);

/// Which places of a sheet the verdict of a contact checks: each belongs to the load that bends it most. So a floe's
/// contact does not break for the structure's stress, and no ice between two contacts stays unchecked.
///
/// A load bends a place by (|P| + |M| / l_c) share_at(d / l_c), d away from it. Loads without a verdict of their own
/// own no place.
/// @see docs/theory/fracture-of-the-edge.md, (8)
class OwnPlaces {
 public:
  /// @param loads  the contact's own first, at least one; frame of LoadCase::outline.
  OwnPlaces(const std::vector<SheetLoad>& loads, const IceProperties& ice);

  /// @param place  [m].
  bool contain(Vec2 place) const;
  /// From the own load [m].
  double distance(Vec2 place) const { return loads_.front().distance(place); }

 private:
  struct Source {
    Vec2 from{}, to{};
    double radius = 0.0;
    double weight = 0.0;  ///< |P| + |M| / l_c [N]
    bool checked = true;

    double distance(Vec2 place) const;
  };

  double l_c_, thickness_;
  std::vector<Source> loads_;
};

}  // namespace brash::failure
