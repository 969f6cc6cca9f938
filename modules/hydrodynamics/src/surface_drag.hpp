// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brash/core/plane.hpp"
#include "brash/core/prism.hpp"
#include "brash/core/vec.hpp"
#include "brash/hydrodynamics/water.hpp"
#include "damping.hpp"
#include "wetted_faces.hpp"

namespace brash::hydrodynamics {

/// Drag on the wetted surface, body frame.
struct SurfaceDrag {
  Damping form;          ///< of the whole velocity
  Wrench skin_friction;  ///< about the body frame's origin
};

/// Water that neighbours hold, at points of a floe's surface.
class Shade {
 public:
  /// Keeps those of `neighbours` (world frame) that can matter to `prism` at `pose`; `gap` as in Water.
  Shade(const Prism& prism, const Pose& pose, std::span<const Solid> neighbours, double gap);

  /// Turns to a flat piece of the surface within `radius` of `centre` (body frame).
  void face(Vec3 centre, Vec3 normal, double radius);
  /// Share of the free stream that the piece faced feels at `point` (body frame).
  double open_share(Vec3 point) const;

 private:
  const Pose& pose_;
  double gap_;
  std::vector<Solid> near_;  ///< the floe

  // Of the piece faced: the planes that bound neighbours among its probes, moved back by the probe, in the body frame;
  // and where each neighbour's planes end among them.
  std::vector<Plane> planes_;
  std::vector<std::size_t> ends_;
};

/// Integrates Eq. 13, with the velocity of each place, and skin friction over the wetted surface.
///
/// @param relative  velocity relative to the water, body frame.
SurfaceDrag surface_drag(const Prism& prism, const Waterplane& plane, const Twist& relative, const Water& water,
                         Shade shade);

}  // namespace brash::hydrodynamics
