// SPDX-License-Identifier: GPL-3.0-or-later
#include "convex_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "brash/core/contract.hpp"
#include "hull_triangles.hpp"

namespace brash::rigid_body {
namespace {

/// Share of the solid's extent within which a point counts as on a plane: far above the round-off of the distances
/// (1e-16), far below any feature.
constexpr double kOnPlane = 1e-9;

double extent(std::span<const Vec3> points) {
  double largest = 0.0;
  for (const Vec3& p : points) largest = std::max(largest, norm(p - points[0]));
  return largest;
}

/// The plane through three points, or nothing when they are in line.
std::optional<Plane> plane_through(Vec3 a, Vec3 b, Vec3 c, double tolerance) {
  const Vec3 n = cross(b - a, c - a);
  const double length = norm(n);
  if (length <= tolerance * std::max(norm(b - a), norm(c - a))) return std::nullopt;
  return Plane{n / length, dot(n / length, a)};
}

/// The points of a plane that are on the boundary of their convex hull.
class Boundary {
 public:
  /// @param at  from a point inside the hull [m].
  Boundary(std::span<const Vec2> at, double tolerance) : at_(at), tolerance_(tolerance), contains_(at.size()) {
    const auto farthest_from = [&](Vec2 p) {
      const auto distance = [p](Vec2 q) { return norm(q - p); };
      return static_cast<std::size_t>(std::ranges::max_element(at, {}, distance) - at.begin());
    };
    const std::size_t one = farthest_from({});
    const std::size_t other = farthest_from(at[one]);
    add(one, other);
    add(other, one);
  }

  bool contains(std::size_t i) const { return contains_[i]; }

 private:
  /// Adds the points from one point to another, counter-clockwise (quickhull): the points on their chord, or else the
  /// boundary to and from the point farthest beyond it.
  void add(std::size_t from, std::size_t to) {
    const Vec2 along = normalized(at_[to] - at_[from]);
    const auto beyond = [&](Vec2 p) { return cross(p - at_[from], along); };
    const auto farthest = std::ranges::max_element(at_, {}, beyond);
    if (beyond(*farthest) > tolerance_) {
      const auto middle = static_cast<std::size_t>(farthest - at_.begin());
      add(from, middle);
      return add(middle, to);
    }
    for (std::size_t i = 0; i < at_.size(); ++i)
      if (beyond(at_[i]) >= -tolerance_) contains_[i] = true;
  }

  std::span<const Vec2> at_;
  double tolerance_;
  std::vector<bool> contains_;
};

/// Indices of the points on the boundary of the face on `plane`, counter-clockwise seen from outside.
std::vector<int> loop_on(const Plane& plane, std::span<const Vec3> points, double tolerance) {
  std::vector<int> on;
  Vec3 middle{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::abs(dot(plane.normal, points[i]) - plane.offset) > tolerance) continue;
    on.push_back(static_cast<int>(i));
    middle += points[i];
  }
  middle = middle / static_cast<double>(on.size());
  const auto [u, v] = plane_axes(plane.normal);
  std::vector<Vec2> at;
  for (const int i : on) {
    const Vec3 r = points[static_cast<std::size_t>(i)] - middle;
    at.push_back({dot(r, u), dot(r, v)});
  }
  const Boundary boundary(at, tolerance);
  std::vector<std::pair<double, int>> loop;
  for (std::size_t k = 0; k < on.size(); ++k)
    if (boundary.contains(k)) loop.emplace_back(std::atan2(at[k].y, at[k].x), on[k]);
  std::ranges::sort(loop);
  on.clear();
  for (const auto& [angle, i] : loop) on.push_back(i);
  return on;
}

/// The points, each once.
std::vector<Vec3> distinct(std::span<const Vec3> points, double tolerance) {
  std::vector<Vec3> kept;
  for (const Vec3& p : points) {
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const Vec3& q) { return norm(p - q) <= tolerance; });
    if (!known) kept.push_back(p);
  }
  return kept;
}

/// The triangles of a convex hull that lie in one plane, or nearly: a disc.
struct Disc {
  Plane plane;            ///< of its largest triangle
  std::vector<int> loop;  ///< of vertices, counter-clockwise from outside
  std::vector<char> has;  ///< of each vertex, whether it is in the loop or within
};

/// Joins triangles to discs, the largest triangle first, across their edges while the next corner lies on the plane.
/// Each disc stays a disc, so the loops close a solid however the tolerance falls.
class Discs {
 public:
  Discs(std::span<const Vec3> points, std::span<const std::array<int, 3>> triangles, double tolerance)
      : points_(points), triangles_(triangles), tolerance_(tolerance), is_free_(triangles.size(), true) {
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
      for (int k = 0; k < 3; ++k) across_[{corner(t, k), corner(t, k + 1)}] = t;
  }

  std::vector<Disc> all() {
    std::vector<int> order(triangles_.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::greater<>{}, [&](int t) { return norm(twice_area(t)); });
    std::vector<Disc> discs;
    for (const int t : order)
      if (is_free_[static_cast<std::size_t>(t)]) discs.push_back(grown_from(t));
    return discs;
  }

 private:
  int corner(int t, int k) const { return triangles_[static_cast<std::size_t>(t)][static_cast<std::size_t>(k % 3)]; }
  Vec3 at(int vertex) const { return points_[static_cast<std::size_t>(vertex)]; }
  Vec3 twice_area(int t) const {
    return cross(at(corner(t, 1)) - at(corner(t, 0)), at(corner(t, 2)) - at(corner(t, 0)));
  }

  Disc grown_from(int seed) {
    const Vec3 normal = normalized(twice_area(seed));
    Disc disc{{normal, dot(normal, at(corner(seed, 0)))}, {}, std::vector<char>(points_.size(), 0)};
    is_free_[static_cast<std::size_t>(seed)] = false;
    for (int k = 0; k < 3; ++k) {
      disc.loop.push_back(corner(seed, k));
      disc.has[static_cast<std::size_t>(corner(seed, k))] = 1;
    }
    for (bool grows = true; grows;) {
      grows = false;
      for (std::size_t i = 0; i < disc.loop.size(); ++i) grows |= takes_across(disc, i);
    }
    return disc;
  }

  /// Takes the triangle beyond the edge i of the loop, if it lies in the plane and the disc stays a disc.
  bool takes_across(Disc& disc, std::size_t i) {
    std::vector<int>& loop = disc.loop;
    const auto place = [&](std::size_t k) { return loop[k % loop.size()]; };
    const int from = place(i), to = place(i + 1), t = across_.at({to, from});
    if (!is_free_[static_cast<std::size_t>(t)]) return false;
    int apex = corner(t, 0);
    for (int k = 1; apex == from || apex == to; ++k) apex = corner(t, k);
    if (std::abs(dot(disc.plane.normal, at(apex)) - disc.plane.offset) > tolerance_) return false;
    const std::size_t after = (i + 1) % loop.size(), before = (i + loop.size() - 1) % loop.size();
    if (disc.has[static_cast<std::size_t>(apex)] == 0) {
      loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, apex);
    } else if (loop.size() > 3 && place(i + 2) == apex) {
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(after));
    } else if (loop.size() > 3 && place(before) == apex) {
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      return false;
    }
    disc.has[static_cast<std::size_t>(apex)] = 1;
    is_free_[static_cast<std::size_t>(t)] = false;
    return true;
  }

  std::span<const Vec3> points_;
  std::span<const std::array<int, 3>> triangles_;
  double tolerance_;
  std::vector<char> is_free_;
  std::map<std::pair<int, int>, int> across_;  ///< the triangle on the left of each directed edge
};

/// The points on `plane` in ascending order, and the plane through the first three points that are not in line: a face
/// comes out the same from whichever side it was found.
std::optional<std::pair<std::vector<int>, Plane>> settle(const Plane& plane, std::span<const Vec3> points,
                                                         double tolerance) {
  std::vector<int> on = loop_on(plane, points, tolerance);
  std::sort(on.begin(), on.end());
  const auto at = [&](std::size_t i) { return points[static_cast<std::size_t>(on[i])]; };
  for (std::size_t j = 1; j < on.size(); ++j)
    for (std::size_t k = j + 1; k < on.size(); ++k)
      if (std::optional<Plane> settled = plane_through(at(0), at(j), at(k), tolerance))
        return std::pair{
            on, dot(settled->normal, plane.normal) > 0.0 ? *settled : Plane{-settled->normal, -settled->offset}};
  return std::nullopt;
}

/// Leaves the vertices that are in a face's loop, in their order.
void keep_corners(ConvexPart& part) {
  std::vector<int> number(part.vertices.size(), -1);
  for (const std::vector<int>& loop : part.faces)
    for (const int i : loop) number[static_cast<std::size_t>(i)] = 0;
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(kept.size());
    kept.push_back(part.vertices[i]);
  }
  for (std::vector<int>& loop : part.faces)
    for (int& i : loop) i = number[static_cast<std::size_t>(i)];
  part.vertices = std::move(kept);
}

/// Each edge once: the loops of the faces beside it run along it in opposite directions. Nothing where they do not.
std::optional<std::vector<Edge>> edges_between(const std::vector<std::vector<int>>& faces) {
  struct Side {
    int from, to, face;
    std::pair<int, int> ends() const { return std::minmax(from, to); }
  };
  std::vector<Side> sides;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t i = 0; i < faces[f].size(); ++i)
      sides.push_back({faces[f][i], faces[f][i + 1 == faces[f].size() ? 0 : i + 1], static_cast<int>(f)});
  std::sort(sides.begin(), sides.end(),
            [](const Side& p, const Side& q) { return p.ends() != q.ends() ? p.ends() < q.ends() : p.from < q.from; });
  std::vector<Edge> edges;
  if (sides.size() % 2 != 0) return std::nullopt;
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    const bool is_edge = sides[i].from == sides[i + 1].to && sides[i].to == sides[i + 1].from;
    const bool is_double = i > 0 && sides[i].ends() == sides[i - 1].ends();
    if (!is_edge || is_double) return std::nullopt;
    edges.push_back({sides[i].from, sides[i].to, sides[i].face, sides[i + 1].face});
  }
  return edges;
}

/// Leaves the part of the convex `polygon` inside `plane`; `scratch` saves it from allocating.
void clip(std::vector<Vec3>& polygon, const Plane& plane, std::vector<Vec3>& scratch) {
  const auto height = [&](Vec3 p) { return dot(plane.normal, p) - plane.offset; };
  scratch.clear();
  Vec3 a = polygon.front();
  double at_a = height(a);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double at_b = height(b);
    if (at_a <= 0.0) scratch.push_back(a);
    if ((at_a < 0.0 && at_b > 0.0) || (at_a > 0.0 && at_b < 0.0))
      scratch.push_back(a + (at_a / (at_a - at_b)) * (b - a));
    a = b;
    at_a = at_b;
  }
  polygon.swap(scratch);
}

}  // namespace

std::array<Vec3, 2> plane_axes(Vec3 normal) {
  const Vec3 other = std::abs(normal.z) < 0.7 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 u = normalized(cross(other, normal));
  return {u, cross(normal, u)};
}

ConvexPart convex_prism(std::span<const Vec2> ring, double bottom, double top) {
  BRASH_EXPECTS(ring.size() >= 3 && bottom < top, ring.size(), bottom, top);
  const int n = static_cast<int>(ring.size());
  ConvexPart part;
  std::vector<int> lower;
  std::vector<int> upper;
  for (int i = 0; i < n; ++i) {
    part.vertices.push_back({ring[i].x, ring[i].y, bottom});
    lower.insert(lower.begin(), i);
  }
  for (int i = 0; i < n; ++i) {
    part.vertices.push_back({ring[i].x, ring[i].y, top});
    upper.push_back(n + i);
  }
  part.planes = {{{0, 0, -1}, -bottom}, {{0, 0, 1}, top}};
  part.faces = {lower, upper};
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    const Vec2 edge = ring[j] - ring[i];
    BRASH_EXPECTS(norm(edge) > 0.0, i);
    const Vec2 out = -perpendicular(edge) / norm(edge);
    part.planes.push_back({{out.x, out.y, 0.0}, dot(out, ring[i])});
    part.faces.push_back({i, j, n + j, n + i});
  }
  part.edges = edges_between(part.faces).value();
  return part;
}

ConvexPart convex_hull(std::span<const Vec3> points) {
  BRASH_EXPECTS(points.size() >= 4, points.size());
  const double tolerance = kOnPlane * extent(points);
  ConvexPart part;
  part.vertices = distinct(points, tolerance);

  const std::vector<std::array<int, 3>> triangles = hull_triangles(part.vertices);
  BRASH_EXPECTS(!triangles.empty(), "points in one plane", points.size());
  const std::vector<Disc> discs = Discs(part.vertices, triangles, tolerance).all();

  // A face has all the points on its plane. Where the tolerance leaves it open which these are, faces found so may not
  // close, and the discs are the faces.
  std::map<std::vector<int>, Plane> faces;
  for (const Disc& disc : discs)
    if (const auto settled = settle(disc.plane, part.vertices, tolerance)) faces.insert(*settled);
  for (const auto& [indices, plane] : faces) {
    part.planes.push_back(plane);
    part.faces.push_back(loop_on(plane, part.vertices, tolerance));
  }
  if (!edges_between(part.faces)) {
    part.planes.clear();
    part.faces.clear();
    for (const Disc& disc : discs) {
      part.planes.push_back(disc.plane);
      part.faces.push_back(disc.loop);
    }
  }
  keep_corners(part);
  part.edges = edges_between(part.faces).value();
  return part;
}

std::vector<Vec3> inset_vertices(const ConvexPart& part, double inset) {
  const double size = extent(part.vertices);
  std::vector<Vec3> corners;
  std::vector<Vec3> clipped;
  for (std::size_t f = 0; f < part.planes.size(); ++f) {
    const Plane& plane = part.planes[f];
    const auto [u, v] = plane_axes(plane.normal);
    const Vec3 middle = part.vertices[static_cast<std::size_t>(part.faces[f][0])] - inset * plane.normal;
    std::vector<Vec3> face{middle - 2 * size * (u + v), middle + 2 * size * (u - v), middle + 2 * size * (u + v),
                           middle - 2 * size * (u - v)};
    for (std::size_t g = 0; g < part.planes.size() && !face.empty(); ++g) {
      if (g == f) continue;
      clip(face, {part.planes[g].normal, part.planes[g].offset - inset}, clipped);
    }
    corners.insert(corners.end(), face.begin(), face.end());
  }
  return distinct(corners, kOnPlane * size);
}

bool outlasts_inset(const ConvexPart& part, double inset) {
  Vec3 middle{};
  for (const Vec3& v : part.vertices) middle += v / static_cast<double>(part.vertices.size());
  const double round_off = kOnPlane * extent(part.vertices);
  const auto is_deep = [&](const Plane& plane) {
    return plane.offset - dot(plane.normal, middle) > inset + 4.0 * round_off;
  };
  return std::ranges::all_of(part.planes, is_deep) || inset_vertices(part, inset).size() >= 4;
}

void place(const ConvexPart& part, const Pose& pose, std::vector<Vec3>& vertices, std::vector<Plane>& planes) {
  vertices.clear();
  planes.clear();
  for (const Vec3& v : part.vertices) vertices.push_back(to_world(pose, v));
  for (const Plane& plane : part.planes) {
    const Vec3 n = rotate(pose.rotation, plane.normal);
    planes.push_back({n, plane.offset + dot(n, pose.position)});
  }
}

}  // namespace brash::rigid_body
