// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "brash/core/vec.hpp"
#include "brash/model/structure.hpp"

namespace brash::structure {

/// The load of a mooring on a structure, about its origin, sheet axes, and the energy that it holds.
struct MooringLoad {
  Wrench load;
  double energy = 0.0;  ///< [J]
};

/// Springs and lines. What they do is a function of the pose, and conserves energy.
class Mooring {
 public:
  /// @param start  pose of the structure where the springs have their pretension.
  Mooring(const model::Moored& moored, const Pose& start) : moored_(moored), start_(start) {}

  /// @param shift  way of the feet since the start [m].
  /// @throws RunError naming a line whose fairlead is not above its anchor.
  MooringLoad at(const Pose& pose, Vec3 shift) const;

 private:
  MooringLoad springs(const Pose& pose, Vec3 shift) const;
  MooringLoad line(std::size_t index, const Pose& pose, Vec3 shift) const;

  model::Moored moored_;
  Pose start_;
};

}  // namespace brash::structure
