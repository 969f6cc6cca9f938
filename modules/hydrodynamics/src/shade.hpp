// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "brash/core/plane.hpp"
#include "brash/core/prism.hpp"
#include "brash/core/vec.hpp"

namespace brash::hydrodynamics {

/// One number for each of four points: the arithmetic of the four runs side by side.
using Lanes = Eigen::Array4d;

/// Four points.
struct Points {
  Lanes x;
  Lanes y;
  Lanes z;
};

/// The points centre + s u + t v with s and t from -1 to 1.
struct Patch {
  Vec3 centre{};
  Vec3 u{};
  Vec3 v{};
};

/// Water that neighbours hold, at points of a floe's surface.
///
/// A neighbour counts where the probes of a point come nearer to it than half the gap. What lies farther from the whole
/// floe, or from a whole face of it, is left out before any point is asked for; so are the planes that all probes are
/// well behind. Neither changes a share.
class Shade {
 public:
  /// Keeps of `neighbours` (world frame) what can matter to `prism` at `pose`; `gap` as in Water.
  Shade(const Prism& prism, const Pose& pose, std::span<const Solid> neighbours, double gap);

  /// Turns to a flat convex face, which lies within `around` (all in the body frame).
  void face(std::span<const Vec3> corners, Vec3 normal, const Patch& around);
  /// Whether no point of the face feels the stream.
  bool closed() const { return closed_; }
  /// Share of the free stream that the face feels at `points` (body frame).
  Lanes open_share(const Points& points) const;

 private:
  struct NearPlane {
    Plane world;
    Plane body;  ///< the same in the body frame, for what needs no last digit
  };
  void keep(Solid solid, Vec3 box_centre, Vec3 half_box);

  const Pose& pose_;
  double gap_;

  // Of the floe: the planes that bound neighbours among its probes, and where each neighbour's planes end among them.
  std::vector<NearPlane> near_;
  std::vector<std::size_t> near_ends_;

  // Of the face: likewise, the planes moved back by the probe, in the body frame.
  std::vector<Plane> planes_;
  std::vector<std::size_t> ends_;
  bool closed_ = false;
};

}  // namespace brash::hydrodynamics
