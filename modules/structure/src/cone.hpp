// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "frustum.hpp"

namespace brash::structure {

/// A round cone: the paper's structure (Table 1, Fig. 9). Its faceted frustum represents it in contacts, and where it
/// heels; upright it has the slope and the displacement of the round cone.
class Cone final : public Frustum {
 public:
  explicit Cone(const model::Cone& cone);

  /// Upright, the vertices lie on the round cone.
  Footprint footprint(const Pose& pose, double bottom, double top) const override;
  Surface surface_at(const Pose& pose, Vec3 point) const override;
  Displacement displaced(const Pose& pose) const override;

 private:
  model::Cone cone_;
};

}  // namespace brash::structure
