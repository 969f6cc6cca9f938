// SPDX-License-Identifier: GPL-3.0-or-later
#include "convex_bodies.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "brash/core/constants.hpp"
#include "brash/core/plane.hpp"
#include "brash/structure/inner_radius.hpp"
#include "triangle_mesh.hpp"

namespace brash::structure {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

/// Volume that parts may have too much, over the mesh's.
constexpr double kMostExcess = 0.01;
/// Parts of one mesh: each costs a contact search per floe nearby.
constexpr std::size_t kMostParts = 32;
/// Corners of one part.
constexpr std::size_t kMostCorners = 256;
/// Beyond so many points the farthest in some directions make a hull. CGAL's search (5.5) takes 20 s for 60 000 points,
/// many in one plane. A hull of 4096 directions lacks a thousandth of a smooth body's volume.
constexpr std::size_t kManyPoints = 20'000;
constexpr int kDirections = 4096;
/// How far a corner that is left out may lie outside the part, over the part's extent.
constexpr double kCornerError = 1e-5;

double coordinate(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
void put(Vec3& v, int axis, double value) { (axis == 0 ? v.x : axis == 1 ? v.y : v.z) = value; }

/// The same mesh with its vertices and triangles in the order of their coordinates. CGAL's order depends on addresses
/// in memory, and results must not.
TriangleMesh in_order(const TriangleMesh& mesh) {
  std::vector<std::size_t> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) {
    const Vec3& v = mesh.vertices[i];
    return std::tuple(v.x, v.y, v.z);
  });
  TriangleMesh sorted;
  std::vector<int> number(order.size());
  for (const std::size_t i : order) {
    number[i] = static_cast<int>(sorted.vertices.size());
    sorted.vertices.push_back(mesh.vertices[i]);
  }
  for (std::array<int, 3> triangle : mesh.triangles) {
    for (int& corner : triangle) corner = number[static_cast<std::size_t>(corner)];
    std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
    sorted.triangles.push_back(triangle);
  }
  std::ranges::sort(sorted.triangles);
  return sorted;
}

/// The closed convex hull of points; without a volume when they lie in a plane.
TriangleMesh hull_of(std::vector<Vec3> points) {
  if (points.size() > kManyPoints) keep_one_of_each(points);
  if (points.size() > kManyPoints) points = extreme_points(std::move(points), kDirections);
  if (points.size() < 4) return {};
  std::vector<Point> cloud;
  for (const Vec3 p : points) cloud.emplace_back(p.x, p.y, p.z);
  SurfaceMesh surface;
  CGAL::convex_hull_3(cloud.begin(), cloud.end(), surface);
  TriangleMesh hull;
  for (const auto v : surface.vertices()) {
    const Point& p = surface.point(v);
    hull.vertices.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : surface.faces()) {
    auto h = surface.halfedge(f);
    std::array<int, 3> triangle{};
    for (int& corner : triangle) {
      corner = static_cast<int>(static_cast<std::size_t>(surface.target(h)));
      h = surface.next(h);
    }
    hull.triangles.push_back(triangle);
  }
  return in_order(hull);
}

/// The part of a polygon on one side of an axis-parallel plane: below it when `sign` is 1, above it when -1.
void keep_side(std::vector<Vec3>& polygon, int axis, double at, double sign) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double at_a = sign * (at - coordinate(a, axis)), at_b = sign * (at - coordinate(b, axis));
    if (at_a >= 0.0) kept.push_back(a);
    if ((at_a > 0.0 && at_b < 0.0) || (at_a < 0.0 && at_b > 0.0)) {
      Vec3 crossing = a + at_a / (at_a - at_b) * (b - a);
      put(crossing, axis, at);
      kept.push_back(crossing);
    }
  }
  polygon = std::move(kept);
}

/// A triangle's part in a box that is open towards one side of one axis.
std::vector<Vec3> within(const std::array<Vec3, 3>& triangle, const Box& box, int open_axis = -1) {
  std::vector<Vec3> polygon(triangle.begin(), triangle.end());
  for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
    keep_side(polygon, axis, coordinate(box.most, axis), 1.0);
    if (axis != open_axis) keep_side(polygon, axis, coordinate(box.least, axis), -1.0);
  }
  return polygon;
}

/// Whether a point lies inside, by the solid angle of the triangles (van Oosterom and Strackee, 1983).
bool is_inside(Vec3 point, const TriangleMesh& mesh) {
  double angle = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [p, q, r] = corners(mesh, t);
    const Vec3 a = p - point, b = q - point, c = r - point;
    const double na = norm(a), nb = norm(b), nc = norm(c);
    angle += 2.0 * std::atan2(dot(a, cross(b, c)), na * nb * nc + dot(a, b) * nc + dot(b, c) * na + dot(c, a) * nb);
  }
  return angle > 2.0 * kPi;
}

/// A part of a shell in a box.
struct Piece {
  Box box;
  std::vector<std::size_t> triangles;  ///< of the shell, those that reach into the box
  double volume = 0.0;                 ///< of the shell in the box [m3]
  TriangleMesh hull;                   ///< convex, of the shell in the box
  double excess = 0.0;                 ///< of the hull [m3]
};

/// Volume of the shell in the box up to the box's end along y [m3]. The flux of (y - y_end) through the closed part is
/// its volume, and there is none through the planes of the box. docs/theory/structures.md, (K3)
double volume_up_to(const TriangleMesh& shell, const std::vector<std::size_t>& triangles, const Box& box,
                    double y_end) {
  Box open = box;
  open.most.y = y_end;
  double volume = 0.0;
  for (const std::size_t t : triangles) {
    const std::vector<Vec3> part = within(corners(shell, t), open, 1);
    for (std::size_t i = 2; i < part.size(); ++i) {
      const double area_y = 0.5 * cross(part[i - 1] - part[0], part[i] - part[0]).y;
      volume += area_y * ((part[0].y + part[i - 1].y + part[i].y) / 3.0 - y_end);
    }
  }
  return volume;
}

Piece piece_of(const TriangleMesh& shell, const Box& box, const std::vector<std::size_t>& candidates) {
  Piece piece{.box = box, .triangles = {}, .volume = 0.0, .hull = {}, .excess = 0.0};
  std::vector<Vec3> points;
  for (const std::size_t t : candidates) {
    if (within(corners(shell, t), box, 1).empty()) continue;
    piece.triangles.push_back(t);  // all that lie in front along y: the volume needs them
    const std::vector<Vec3> part = within(corners(shell, t), box);
    points.insert(points.end(), part.begin(), part.end());
  }
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner{i & 1 ? box.most.x : box.least.x, i & 2 ? box.most.y : box.least.y,
                      i & 4 ? box.most.z : box.least.z};
    if (is_inside(corner, shell)) points.push_back(corner);
  }
  piece.volume =
      volume_up_to(shell, piece.triangles, box, box.most.y) - volume_up_to(shell, piece.triangles, box, box.least.y);
  piece.hull = hull_of(std::move(points));
  piece.excess = std::max(0.0, signed_volume(piece.hull) - piece.volume);
  return piece;
}

/// The two halves of a piece across the middle of the axis that lessens the excess most.
std::pair<Piece, Piece> halves(const TriangleMesh& shell, const Piece& piece) {
  std::pair<Piece, Piece> best;
  double least = HUGE_VAL;
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = 0.5 * (coordinate(piece.box.least, axis) + coordinate(piece.box.most, axis));
    Box lower = piece.box, upper = piece.box;
    put(lower.most, axis, middle);
    put(upper.least, axis, middle);
    std::pair<Piece, Piece> made{piece_of(shell, lower, piece.triangles), piece_of(shell, upper, piece.triangles)};
    const double excess = made.first.excess + made.second.excess;
    if (excess >= least) continue;
    least = excess;
    best = std::move(made);
  }
  return best;
}

/// Whether a face is too low for a sure normal.
bool is_sliver(const std::array<Vec3, 3>& triangle, double extent) {
  constexpr double kSliver = 1e-9;  // height over the extent; the normal is wrong by 1e-7
  const double longest =
      std::max({norm(triangle[1] - triangle[0]), norm(triangle[2] - triangle[1]), norm(triangle[0] - triangle[2])});
  return 2.0 * norm(vector_area(triangle)) <= kSliver * extent * longest;
}

/// Some of the corners of a convex body, so that none of the others lies far outside the hull of these.
TriangleMesh with_few_corners(const TriangleMesh& body) {
  std::vector<Vec3> kept;
  for (int i = 0; i < 27; ++i) {
    const Vec3 towards{i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0};
    kept.push_back(*std::ranges::max_element(body.vertices, {}, [&](Vec3 v) { return dot(towards, v); }));
  }
  double extent = 0.0;
  for (const Vec3 v : body.vertices) extent = std::max(extent, norm(v - body.vertices.front()));
  TriangleMesh hull = hull_of(kept);
  while (true) {
    // The vertex that lies farthest outside of each face.
    std::vector<std::pair<double, std::size_t>> missing;
    for (std::size_t t = 0; t < hull.triangles.size(); ++t) {
      const auto triangle = corners(hull, t);
      if (is_sliver(triangle, extent)) continue;
      const Vec3 normal = normalized(vector_area(triangle));
      const auto height = [&](Vec3 v) { return dot(normal, v - triangle[0]); };
      const auto farthest = std::ranges::max_element(body.vertices, {}, height);
      if (height(*farthest) > kCornerError * extent)
        missing.emplace_back(-height(*farthest), static_cast<std::size_t>(farthest - body.vertices.begin()));
    }
    std::ranges::sort(missing);
    const std::size_t room = kMostCorners > hull.vertices.size() ? kMostCorners - hull.vertices.size() : 0;
    if (missing.empty() || room == 0) return hull;
    kept = hull.vertices;
    for (std::size_t i = 0; i < std::min(room, missing.size()); ++i) kept.push_back(body.vertices[missing[i].second]);
    TriangleMesh larger = hull_of(kept);
    if (larger.vertices == hull.vertices) return hull;  // rounding placed vertices outside that are not
    hull = std::move(larger);
  }
}

std::vector<Piece> pieces_of(const TriangleMesh& shell) {
  const Box box = box_around(shell.vertices);
  Piece whole{
      .box = box, .triangles = {}, .volume = signed_volume(shell), .hull = hull_of(shell.vertices), .excess = 0.0};
  whole.triangles.resize(shell.triangles.size());
  std::iota(whole.triangles.begin(), whole.triangles.end(), std::size_t{0});
  whole.excess = std::max(0.0, signed_volume(whole.hull) - whole.volume);
  std::vector<Piece> pieces{std::move(whole)};
  const auto excess = [&] {
    return std::accumulate(pieces.begin(), pieces.end(), 0.0, [](double s, const Piece& p) { return s + p.excess; });
  };
  const double allowed = kMostExcess * signed_volume(shell);
  while (excess() > allowed && pieces.size() < kMostParts) {
    const auto worst = std::ranges::max_element(pieces, {}, &Piece::excess);
    auto [lower, upper] = halves(shell, *worst);
    *worst = std::move(lower);
    pieces.push_back(std::move(upper));
  }
  return pieces;
}

/// The planes of a convex hull's faces. A sliver has no sure normal, and its neighbours represent it.
std::vector<Plane> planes_of(const TriangleMesh& hull, double extent) {
  std::vector<Plane> planes;
  for (std::size_t t = 0; t < hull.triangles.size(); ++t) {
    const auto triangle = corners(hull, t);
    if (is_sliver(triangle, extent)) continue;
    const Vec3 normal = normalized(vector_area(triangle));
    planes.push_back({normal, dot(normal, triangle[0])});
  }
  return planes;
}

/// How deep the deepest point of a solid lies, among those with the coordinates of `point` before `axis`. The depth is
/// concave, so golden sections find it; they stop at one of `enough`.
double depth_within(Solid solid, const Box& box, Vec3 point, int axis, double enough) {
  if (axis == 3) return -signed_distance(solid, point);
  constexpr double kGolden = 0.6180339887498949;
  constexpr int kSections = 44;  // 0.618^44 = 6e-10
  const auto depth_at = [&](double coordinate) {
    put(point, axis, coordinate);
    return depth_within(solid, box, point, axis + 1, enough);
  };
  double from = coordinate(box.least, axis), to = coordinate(box.most, axis);
  double left = to - kGolden * (to - from), right = from + kGolden * (to - from);
  double at_left = depth_at(left), at_right = depth_at(right);
  for (int i = 0; i < kSections && std::max(at_left, at_right) < enough; ++i) {
    if (at_left < at_right) {
      from = std::exchange(left, right);
      at_left = at_right;
      right = from + kGolden * (to - from);
      at_right = depth_at(right);
    } else {
      to = std::exchange(right, left);
      at_right = at_left;
      left = to - kGolden * (to - from);
      at_left = depth_at(left);
    }
  }
  return std::max(at_left, at_right);
}

}  // namespace

ConvexBodies convex_bodies(const TriangleMesh& mesh) {
  const auto [shell_of, n_shells] = shells_of(mesh);
  ConvexBodies bodies;
  double wrong = 0.0;
  for (int s = 0; s < n_shells; ++s) {
    const TriangleMesh shell = part_of(mesh, [&, &of = shell_of](std::size_t t) { return of[t] == s; });
    for (const Piece& piece : pieces_of(shell)) {
      const double volume = signed_volume(piece.hull);
      if (!(volume > 0.0)) continue;
      const TriangleMesh body = with_few_corners(piece.hull);
      wrong += piece.excess + std::max(0.0, std::max(volume, piece.volume) - signed_volume(body));
      bodies.parts.push_back(body.vertices);
    }
  }
  bodies.error = wrong / signed_volume(mesh);
  return bodies;
}

double inner_radius(const ConvexPart& part, double enough) {
  const Box box = box_around(part);
  const std::vector<Plane> planes = planes_of(hull_of(part), norm(box.most - box.least));
  if (planes.empty()) return 0.0;
  const Vec3 sum = std::accumulate(part.begin(), part.end(), Vec3{});
  const double depth = -signed_distance(planes, sum / static_cast<double>(part.size()));
  return depth >= enough ? depth : std::max(depth, depth_within(planes, box, {}, 0, enough));
}

}  // namespace brash::structure
