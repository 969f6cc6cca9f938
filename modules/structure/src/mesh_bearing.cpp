// SPDX-License-Identifier: GPL-3.0-or-later
// Which way a mesh seems to point. Files do not say it: one program has x astern, another one y upwards.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "frustum.hpp"
#include "mesh_hull.hpp"
#include "triangle_mesh.hpp"

namespace brash::structure {
namespace {

/// Length over breadth and height from which on a mesh is taken for a ship [-]; others may stand any way.
constexpr double kLong = 2.0;
/// A mesh mirrors itself about a plane, if its centroid lies so near to the plane, over its extent [-].
constexpr double kMirrored = 0.01;
/// And clearly does not from here on [-].
constexpr double kNotMirrored = 0.03;
/// The ends of the waterline are compared at this distance from them, over its length [-].
constexpr double kNearEnd = 0.05;
/// How much wider than the back the front of a ship may be there [-].
constexpr double kWider = 1.5;
/// A ship's centre of buoyancy lies higher above the keel, over the draught [-].
constexpr double kLowBuoyancy = 0.485;

Vec3 centroid_of(const TriangleMesh& mesh) {
  const Vec3 apex = mesh.vertices.front();
  Vec3 moment{};
  double volume = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = corners(mesh, t);
    const double part = dot(a - apex, cross(b - apex, c - apex)) / 6.0;
    volume += part;
    moment += 0.25 * part * (apex + a + b + c);
  }
  return moment / volume;
}

/// Breadth of outlines at x [m]; 0 where they do not reach.
double breadth_at(const Loops& loops, double x) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const Outline& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
      if ((a.x - x) * (b.x - x) > 0.0 || a.x == b.x) continue;
      const double y = a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y);
      least = std::min(least, y);
      most = std::max(most, y);
    }
  return std::max(0.0, most - least);
}

Bearing astern(const MeshSections& sections) {
  const Loops waterline = sections.at({}, 0.0, sections.near({}, 0.0, 0.0));
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const Outline& loop : waterline)
    for (const Vec2 v : loop) least = std::min(least, v.x), most = std::max(most, v.x);
  const double inward = kNearEnd * (most - least);
  const double front = breadth_at(waterline, most - inward), back = breadth_at(waterline, least + inward);
  if (front <= kWider * back) return {};
  return {
      fmt::format("the mesh seems to go stern first: near its ends the waterline is {:.3g} m wide ahead and {:.3g} m "
                  "astern",
                  front, back),
      "turn it by structure.heading = \"180 deg\""};
}

}  // namespace

Bearing bearing_of(const MeshSections& sections) {
  const TriangleMesh& mesh = sections.mesh();
  const Box box = box_around(mesh.vertices);
  const Vec3 size = box.size();
  if (size.x < kLong * std::max(size.y, size.z)) return {};
  const Vec3 off = centroid_of(mesh) - box.middle();
  const double to_port = off.y / size.y, upwards = off.z / size.z;
  if (std::abs(upwards) < kMirrored && std::abs(to_port) > kNotMirrored)
    return {
        fmt::format("the mesh seems to lie on its side, with {}y upwards in its file: it mirrors itself about a level "
                    "plane",
                    to_port > 0.0 ? "" : "minus "),
        fmt::format("turn it by structure.heel = \"{} deg\"", to_port > 0.0 ? 90 : -90)};
  const double height = 1.0 + displacement_of(mesh, mesh.vertices).centre.z / -box.least.z;
  if (std::abs(to_port) < kMirrored && height < kLowBuoyancy)
    return {
        fmt::format("the mesh seems to float upside down: its centre of buoyancy lies {:.2g} draughts above its lowest "
                    "point, and a ship's higher than {:g}",
                    height, kLowBuoyancy),
        "turn it by structure.heel = \"180 deg\""};
  return astern(sections);
}

}  // namespace brash::structure
