// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "brash/model/choices.hpp"

namespace brash::model {

/// `kind = "cone"`: a round cone on a vertical axis.
struct Cone {
  double angle = 0.0;                       ///< slope from the horizontal [rad], in (0, pi/2)
  double waterline_width = 0.0;             ///< diameter at the waterplane
  double height = 0.0;                      ///< from keel to top
  double height_under_water = 0.0;          ///< from keel to waterplane
  Breaking breaking = Breaking::kDownward;  ///< downward: narrower below; upward: narrower above
  int facets = 64;                          ///< plane sides that stand for the round surface in contacts

  friend bool operator==(const Cone&, const Cone&) = default;
};

/// The shape of a structure; [structure] kind names them in this order.
using Shape = std::variant<Cone>;
enum class StructureKind { kCone };
template <>
inline constexpr auto kNames<StructureKind> = std::to_array<Named<StructureKind>>({{StructureKind::kCone, "cone"}});
inline StructureKind kind_of(const Shape& shape) { return static_cast<StructureKind>(shape.index()); }

/// `kind = "towed"`: along x at a constant speed, whatever the ice does.
struct Towed {
  double speed = 0.0;

  friend bool operator==(const Towed&, const Towed&) = default;
};

/// How a structure moves; [structure.motion] kind names them in this order.
using Motion = std::variant<Towed>;
enum class MotionKind { kTowed };
template <>
inline constexpr auto kNames<MotionKind> = std::to_array<Named<MotionKind>>({{MotionKind::kTowed, "towed"}});
inline MotionKind kind_of(const Motion& motion) { return static_cast<MotionKind>(motion.index()); }

/// Speed of a structure through the ice where nothing resists it [m/s].
inline double speed(const Motion& motion) {
  return std::visit([](const auto& m) { return m.speed; }, motion);
}

/// [structure]
struct StructureSection {
  Shape shape;
  Motion motion;
  MotionFrame frame = MotionFrame::kStructureMoves;
  double start_distance = 0.0;  ///< from its origin to the ice edge at the start

  friend bool operator==(const StructureSection&, const StructureSection&) = default;
};

}  // namespace brash::model
