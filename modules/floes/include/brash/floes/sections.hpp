// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "brash/core/prism.hpp"

namespace brash::floes {

/// A straight section through a floe, on the line dot(normal, r) = offset of the body frame. The ice beyond it has
/// dot(normal, r) > offset.
struct Section {
  Vec2 normal{};        ///< unit
  double offset = 0.0;  ///< [m]
  double width = 0.0;   ///< length of ice along the line [m]
  double spread = 0.0;  ///< one over the area of the section; 0 where it is higher than wide: no plate [1/m2]
  double area = 0.0;    ///< beyond it [m2]
  double swing = 0.0;   ///< integral of cross(r, normal) beyond it [m3]
  double lever = 0.0;   ///< integral of the arm, dot(normal, r) - offset, beyond it [m3]
  Vec2 levers{};        ///< integral of the arm times r beyond it, and of the rotary inertia there [m4]
};

/// A force on a floe, body frame.
struct PointForce {
  Vec3 point{};  ///< [m]
  Vec3 force{};  ///< [N]
};

/// The loads in a section.
struct SectionLoad {
  double moment = 0.0;  ///< bending, positive with tension in the lower face [N m]
  double thrust = 0.0;  ///< tension positive [N]
};

/// The sections in which a floe may break, and their loads under forces that accelerate it as a free rigid plate
/// (docs/theory/fracture-of-floes.md).
class Sections {
 public:
  /// Evenly spaced in twelve directions. Each leaves ice as far as one thickness on either side. A floe shorter than
  /// two has none: bending breaks no block, docs/theory/fracture-of-floes.md, (P6).
  explicit Sections(const Prism& floe);

  const std::vector<Section>& all() const { return sections_; }

  /// The load in each section under `forces` and the inertia of the plate, linear in the forces. Weight and buoyancy
  /// give next to none. docs/theory/fracture-of-floes.md, (P1), (P2), (P3), (P5)
  std::vector<SectionLoad> loads(std::span<const PointForce> forces) const;

  /// The largest tension in the two faces under a load in section number `i` [Pa], 0 in a section that is higher than
  /// wide: docs/theory/fracture-of-floes.md, (P4).
  double tension(std::size_t i, const SectionLoad& load) const;

 private:
  std::vector<Section> sections_;  ///< direction after direction
  double thickness_;
  double area_ = 0.0;  ///< of the plan [m2]
  Vec2 second_{};      ///< integrals of x^2 and y^2 over the plan [m4]
};

}  // namespace brash::floes
