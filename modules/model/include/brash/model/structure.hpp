// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/model/choices.hpp"

namespace brash::model {

/// `kind = "cone"`: a round cone on a vertical axis.
struct Cone {
  double angle = 0.0;                       ///< slope from the horizontal [rad], in (0, pi/2)
  double waterline_width = 0.0;             ///< diameter at the waterplane
  double height = 0.0;                      ///< from keel to top
  double height_under_water = 0.0;          ///< from keel to waterplane
  Breaking breaking = Breaking::kDownward;  ///< downward: narrower below; upward: narrower above
  int facets = 64;                          ///< plane sides that represent the round surface in contacts

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

/// `kind = "ship"`: an icebreaker's hull from its particulars in [hull].
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

/// A row of a path: where the structure's origin is at a time, sheet frame.
struct Waypoint {
  double time = 0.0;     ///< [s]
  Vec2 position{};       ///< [m]
  double heading = 0.0;  ///< of the structure's x axis, from the sheet's towards y [rad]

  friend bool operator==(const Waypoint&, const Waypoint&) = default;
};

/// `kind = "towed"`: along x at a constant speed, or along a path, whatever the ice does.
struct Towed {
  double speed = 0.0;            ///< 0 with a path
  std::vector<Waypoint> path{};  ///< from time 0 on; empty: along x at `speed`

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

/// A structure that is a rigid body afloat: its mass, and its loads beside weight, buoyancy and ice. Vectors are along
/// the hull's axes. The defaults of the absent members come from the displaced water (structure/floating_body.hpp).
struct FloatingBody {
  std::optional<double> mass{};              ///< [kg]
  std::optional<Vec3> centre_of_gravity{};   ///< hull's frame [m]
  std::optional<Vec3> radii_of_gyration{};   ///< about the axes through the centre of gravity [m]
  std::optional<Vec3> added_mass{};          ///< [kg]
  std::optional<Vec3> added_inertia{};       ///< [kg m2]
  Vec3 linear_damping{};                     ///< [N s/m]
  Vec3 quadratic_damping{};                  ///< [N s2/m2]
  Vec3 angular_damping{};                    ///< [N m s]
  Vec3 quadratic_angular_damping{};          ///< [N m s2]
  Vec3 thrust{};                             ///< hull's frame; with a speed in open water the bollard pull [N]
  std::optional<double> open_water_speed{};  ///< where the net thrust has fallen to zero [m/s]; absent: it is constant
  Vec3 thrust_arm{};                         ///< from the centre of gravity to the point of action [m]

  friend bool operator==(const FloatingBody&, const FloatingBody&) = default;
};

/// What the net thrust of a ship loses with its speed v through the water: T(v) = bollard - linear v - quadratic v^2.
/// The resistance of open water is in it.
struct ThrustLoss {
  double linear = 0.0;     ///< [N s/m]
  double quadratic = 0.0;  ///< [N s2/m2]
};
/// T(v) = bollard (1 - v / (3 v_ow) - 2/3 (v / v_ow)^2).
///
/// @param bollard           bollard pull [N].
/// @param open_water_speed  speed in open water v_ow, where T is zero [m/s], > 0.
/// @see S. Juva, K. Riska, On the power requirement in the Finnish-Swedish ice class rules, 2002.
inline ThrustLoss thrust_loss(double bollard, double open_water_speed) {
  return {bollard / (3.0 * open_water_speed), 2.0 * bollard / (3.0 * open_water_speed * open_water_speed)};
}

/// `kind = "free"`: a body afloat with six degrees of freedom.
struct Free {
  double speed = 0.0;  ///< along x at the start
  FloatingBody body{};

  friend bool operator==(const Free&, const Free&) = default;
};

/// An elastic line from an anchor on the sea bed to the structure.
struct MooringLine {
  Vec3 anchor{};           ///< from the origin of the structure at the start, z from the water's surface [m]
  Vec3 fairlead{};         ///< hull's frame [m]
  double length = 0.0;     ///< without tension [m]
  double weight = 0.0;     ///< in water [N/m]
  double stiffness = 0.0;  ///< E A [N]

  friend bool operator==(const MooringLine&, const MooringLine&) = default;
};

/// `kind = "moored"`: the same body on springs or lines. Their feet go along x through the ice at a constant speed.
struct Moored {
  double speed = 0.0;
  FloatingBody body{};
  std::vector<std::array<double, 6>> stiffness{};  ///< 6 rows: of the origin, sheet axes [N/m, N, N m]; or none
  std::vector<double> pretension{};                ///< 6 values: force and moment at the start [N, N m]; or none
  std::vector<MooringLine> lines{};

  friend bool operator==(const Moored&, const Moored&) = default;
};

/// `kind = "driven"`: as another program says, step by step; until it does, along x at a constant speed.
struct Driven {
  double speed = 0.0;

  friend bool operator==(const Driven&, const Driven&) = default;
};

/// How a structure moves; [structure.motion] kind names them in this order.
using Motion = std::variant<Towed, Compliant, Free, Moored, Driven>;
enum class MotionKind { kTowed, kCompliant, kFree, kMoored, kDriven };
template <>
inline constexpr auto kNames<MotionKind> = std::to_array<Named<MotionKind>>({{MotionKind::kTowed, "towed"},
                                                                             {MotionKind::kCompliant, "compliant"},
                                                                             {MotionKind::kFree, "free"},
                                                                             {MotionKind::kMoored, "moored"},
                                                                             {MotionKind::kDriven, "driven"}});
inline MotionKind kind_of(const Motion& motion) { return static_cast<MotionKind>(motion.index()); }

/// Speed along x through the ice: of the tow, of the mooring's feet, or at the start [m/s]; 0 with a path.
inline double speed(const Motion& motion) {
  return std::visit([](const auto& m) { return m.speed; }, motion);
}

/// [structure]
struct StructureSection {
  Shape shape;
  std::vector<Vec2> legs{};  ///< places of copies of the shape, structure's frame, all alike; empty: one, at the origin
  Motion motion;
  MotionFrame frame = MotionFrame::kStructureMoves;
  double start_distance = 0.0;  ///< from its origin to the ice edge at the start; not of a path

  friend bool operator==(const StructureSection&, const StructureSection&) = default;
};

}  // namespace brash::model
