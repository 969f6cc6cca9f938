// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/model/case.hpp"

namespace brash::structure {

/// Vertices of a convex body in the hull's frame [m].
using ConvexPart = std::vector<Vec3>;

/// A simple polygon of the plan, counter-clockwise, sheet frame [m].
using Outline = std::vector<Vec2>;

/// The plan of a hull within the thickness of the ice. Either may be several polygons, or none.
struct Footprint {
  std::vector<Outline> leading;   ///< union of the sections over the thickness: where the hull touches the ice
  std::vector<Outline> trailing;  ///< intersection of the sections: where it has passed through the ice
};

/// The surface of a hull at a point.
struct Surface {
  Vec3 normal{};                                          ///< unit, out of the hull, world frame
  double slope = 0.0;                                     ///< from the horizontal [rad], in (0, pi/2]
  model::Breaking breaking = model::Breaking::kDownward;  ///< which way the surface bends ice that it meets
};

/// A box of the plan, sheet frame [m]. All of it holds everything.
struct PlanBox {
  Vec2 lower{-HUGE_VAL, -HUGE_VAL};
  Vec2 upper{HUGE_VAL, HUGE_VAL};
};

/// A plane piece of the sides of a hull.
struct SidePiece {
  Vec3 normal{};              ///< unit, out of the hull, world frame
  std::vector<Vec3> outline;  ///< convex, world frame [m]
};

/// The section of a hull in the water's surface.
struct Waterplane {
  double area = 0.0;    ///< [m2]
  double radius = 0.0;  ///< of the circle with that area [m]
  Vec2 centre{};        ///< [m]
};

/// The displacement of a hull in still water.
struct Displacement {
  double volume = 0.0;  ///< [m3]
  Vec3 centre{};        ///< of buoyancy [m]
  Waterplane waterplane;
};

/// A closed surface of triangles, each counter-clockwise as seen from outside; hull's frame [m].
struct TriangleMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;
};

class Hull;

/// A structure as copies of one hull, all turned alike.
struct HullCopies {
  const Hull* hull = nullptr;  ///< of one copy
  std::vector<Vec2> places{};  ///< of their origins, frame of the structure [m]; never empty
};

/// The closed surface of a structure: an immutable value behind one interface, whatever its shape.
///
/// Its frame is the frame of the structure: z upwards, the origin on the waterplane, x ahead. Poses place it in the
/// world, where the water's surface is z = 0.
class Hull {
 public:
  virtual ~Hull() = default;

  /// Convex parts whose union is the hull. Contacts with floes use them.
  virtual std::span<const ConvexPart> parts() const = 0;

  /// The plan of the hull between the heights `bottom` and `top` [m], world frame.
  virtual Footprint footprint(const Pose& pose, double bottom, double top) const = 0;

  /// The sides of the hull between the heights `bottom` and `top` [m], without deck and keel; of a hull with many
  /// pieces only those whose plan may reach into `region`.
  virtual std::vector<SidePiece> sides(const Pose& pose, double bottom, double top, const PlanBox& region) const = 0;

  /// The side of the hull next to `point`, world frame [m]. Horizontal faces, deck and keel, count for nothing.
  virtual Surface surface_at(const Pose& pose, Vec3 point) const = 0;

  /// The displacement of the hull where it lies; all zero when it is out of the water.
  virtual Displacement displaced(const Pose& pose) const = 0;

  /// The legs of a structure that has any; otherwise the hull itself.
  virtual HullCopies copies() const { return {this, {Vec2{}}}; }

  /// The surface that report, ParaView and pictures draw, and nothing else.
  virtual const TriangleMesh& mesh() const = 0;

  /// Least and largest coordinates of the mesh, hull's frame [m].
  std::pair<Vec3, Vec3> bounds() const;

  /// Distance from the origin to the farthest point of the mesh [m].
  double reach() const;
};

/// Where a hull that goes along `course` meets ice between two heights first.
struct Foremost {
  Surface surface;     ///< there
  double reach = 0.0;  ///< how far along the course the hull reaches, from the origin of the plan [m]
};
/// @param course  direction in plan, of any length; the hull meets the ice somewhere.
Foremost foremost(const Hull& hull, const Pose& pose, double bottom, double top, Vec2 course);

/// Half an ellipsoid below the waterplane, in place of a hull under water.
struct HalfEllipsoid {
  Vec3 semi_axes{};      ///< along its own x and y, and downwards [m]
  Vec2 centre{};         ///< hull's frame [m]
  double heading = 0.0;  ///< of its x axis, hull's frame [rad]
};
/// The half ellipsoid with a hull's displaced volume, its waterplane's area and the ratio of that area's principal
/// second moments. The hull lies as its frame says, in the water, and has no legs.
HalfEllipsoid fitted_ellipsoid(const Hull& hull);

/// Faces steeper than this are vertical [rad]: ice crushes on them and does not bend. 89.5 degrees, beyond the slopes
/// that the failure models cover.
inline constexpr double kSteepestSlope = 1.5620697;

/// The hull of a shape.
/// @throws InputError when it is a mesh whose file is not a hull, as examine() says.
std::unique_ptr<const Hull> make_hull(const model::Shape& shape);
/// The hull of a structure, with its legs. They may not touch.
std::unique_ptr<const Hull> make_hull(const model::StructureSection& structure);

}  // namespace brash::structure
