// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
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

/// `kind = "faceted-cone"`: a pyramid without its tip, one plane side ahead.
struct FacetedCone {
  double angle = 0.0;                       ///< slope of the sides from the horizontal [rad], in (0, pi/2]
  double waterline_width = 0.0;             ///< diameter of the circle inside the waterplane
  double height = 0.0;                      ///< from keel to top
  double height_under_water = 0.0;          ///< from keel to waterplane
  Breaking breaking = Breaking::kDownward;  ///< downward: narrower below; upward: narrower above
  int sides = 8;

  friend bool operator==(const FacetedCone&, const FacetedCone&) = default;
};

/// `kind = "plane"`: a block whose front is one plane; sides and back are vertical.
struct Plane {
  double angle = 0.0;                       ///< slope of the front from the horizontal [rad], in (0, pi/2]
  double waterline_width = 0.0;             ///< across its way
  double length = 0.0;                      ///< at the waterline, along its way
  double height = 0.0;                      ///< from keel to top
  double height_under_water = 0.0;          ///< from keel to waterplane
  Breaking breaking = Breaking::kDownward;  ///< downward: the front leans over the ice; upward: away from it

  friend bool operator==(const Plane&, const Plane&) = default;
};

/// `kind = "wedge-bow"`: a block whose front is a wedge of two planes; sides and back are vertical.
struct WedgeBow {
  double angle = 0.0;                       ///< slope of the two planes from the horizontal [rad], in (0, pi/2]
  double entrance = 0.0;                    ///< between their waterlines and the way [rad], in (0, pi/2)
  double waterline_width = 0.0;             ///< across its way
  double length = 0.0;                      ///< at the waterline, from stem to back
  double height = 0.0;                      ///< from keel to top
  double height_under_water = 0.0;          ///< from keel to waterplane
  Breaking breaking = Breaking::kDownward;  ///< downward: the planes lean over the ice; upward: away from it

  friend bool operator==(const WedgeBow&, const WedgeBow&) = default;
};

/// [hull]: the particulars of a ship, for the closed form of Lindqvist and for `structure.kind = "ship"`. The first
/// five keys come together or not at all. The others have defaults that follow from these five.
struct HullSection {
  std::optional<double> length;  ///< at the waterline
  std::optional<double> breadth;
  std::optional<double> draught;
  std::optional<double> stem_angle;       ///< of the stem from the horizontal [rad]
  std::optional<double> waterline_angle;  ///< of the waterline's entrance from the centre line [rad]
  std::optional<double> depth;            ///< from keel to deck
  std::optional<double> bow_length;       ///< of the waterline, from the stem to the parallel part
  std::optional<double> flare;            ///< of the sides from the vertical, outwards above [rad]
  std::optional<double> midbody;          ///< length of the waterline's parallel part
  std::optional<double> stern_angle;      ///< of the stern from the horizontal [rad]

  friend bool operator==(const HullSection&, const HullSection&) = default;
};

/// `kind = "ship"`: an icebreaker's hull from its particulars, those of [hull].
struct Ship {
  HullSection hull;

  friend bool operator==(const Ship&, const Ship&) = default;
};

/// `kind = "mesh"`: a closed surface of triangles in a file, x ahead and z upwards.
struct Mesh {
  std::string file;      ///< absolute; empty in a checkpoint, which has the file's hash
  double scale = 1.0;    ///< metres to one unit of the file
  double draught = 0.0;  ///< from the lowest point to the waterplane
  double heading = 0.0;  ///< about the vertical, to port [rad]
  double heel = 0.0;     ///< to starboard [rad]
  double trim = 0.0;     ///< bow up [rad]

  friend bool operator==(const Mesh&, const Mesh&) = default;
};

/// The shape of a structure; [structure] kind names them in this order.
using Shape = std::variant<Cone, FacetedCone, Plane, WedgeBow, Ship, Mesh>;
enum class StructureKind { kCone, kFacetedCone, kPlane, kWedgeBow, kShip, kMesh };
template <>
inline constexpr auto kNames<StructureKind> =
    std::to_array<Named<StructureKind>>({{StructureKind::kCone, "cone"},
                                         {StructureKind::kFacetedCone, "faceted-cone"},
                                         {StructureKind::kPlane, "plane"},
                                         {StructureKind::kWedgeBow, "wedge-bow"},
                                         {StructureKind::kShip, "ship"},
                                         {StructureKind::kMesh, "mesh"}});
inline StructureKind kind_of(const Shape& shape) { return static_cast<StructureKind>(shape.index()); }

/// `kind = "towed"`: along x at a constant speed, whatever the ice does.
struct Towed {
  double speed = 0.0;

  friend bool operator==(const Towed&, const Towed&) = default;
};

/// `kind = "compliant"`: a mass on a spring and a dashpot in plan. Their foot goes along x through the ice at a
/// constant speed. It does not turn, heave or pitch.
struct Compliant {
  double speed = 0.0;
  double mass = 0.0;       ///< with the water's added mass [kg]
  double stiffness = 0.0;  ///< [N/m]
  double damping = 0.0;    ///< [N s/m]

  friend bool operator==(const Compliant&, const Compliant&) = default;
};

/// `kind = "driven"`: as another program says, step by step; until it does, along x at a constant speed.
struct Driven {
  double speed = 0.0;

  friend bool operator==(const Driven&, const Driven&) = default;
};

/// How a structure moves; [structure.motion] kind names them in this order.
using Motion = std::variant<Towed, Compliant, Driven>;
enum class MotionKind { kTowed, kCompliant, kDriven };
template <>
inline constexpr auto kNames<MotionKind> = std::to_array<Named<MotionKind>>({{MotionKind::kTowed, "towed"},
                                                                             {MotionKind::kCompliant, "compliant"},
                                                                             {MotionKind::kDriven, "driven"}});
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
