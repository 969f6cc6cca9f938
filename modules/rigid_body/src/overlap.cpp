// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brash::rigid_body {
namespace {

/// Corners of a patch nearer to each other than this share of its diameter are one point. Measured on the validation
/// case: a quarter fewer points, mean load 0.7 % and 99 % quantile 6 % off the loads with four points throughout,
/// within the spread of replicates.
constexpr double kMergeWithin = 0.1;

/// Whether the plane of `other` that lies farthest below the middle of `part`'s box parts the two. Mostly it does, if
/// any plane does.
bool are_parted(const PlacedPart& part, const PlacedPart& other) {
  const Vec3 centre = 0.5 * (part.lower + part.upper);
  const auto height = [&](const Plane& plane) { return dot(plane.normal, centre) - plane.offset; };
  const Plane* farthest = &other.planes.front();
  double greatest = height(*farthest);
  for (const Plane& plane : other.planes)
    if (const double h = height(plane); h > greatest) {
      greatest = h;
      farthest = &plane;
    }
  return greatest > 0.0 && part.corners.least_over(*farthest) >= -kTouch;
}

}  // namespace

void update(PlacedPart& part, const Pose& pose) {
  place(*part.part, pose, part.vertices, part.planes);
  part.corners.assign(part.vertices);
  part.lower = part.upper = part.vertices[0];
  for (const Vec3& v : part.vertices) {
    part.lower = {std::min(part.lower.x, v.x), std::min(part.lower.y, v.y), std::min(part.lower.z, v.z)};
    part.upper = {std::max(part.upper.x, v.x), std::max(part.upper.y, v.y), std::max(part.upper.z, v.z)};
  }
}

PlacedPart placed(const ConvexPart& part, const Pose& pose) {
  PlacedPart result{.part = &part, .vertices = {}, .corners = {}, .planes = {}};
  update(result, pose);
  return result;
}

/// Heights of `part` over the planes of `other`, and the separating axes through them, their normals times `outwards`;
/// false when a plane parts the two.
bool OverlapFinder::find_axes(const PlacedPart& part, const PlacedPart& other, double outwards, Heights& heights) {
  heights.reset(part.corners, other.planes.size());
  for (const Plane& plane : other.planes) {
    const double depth = -heights.add(part.corners, plane).least;
    if (depth <= kTouch) return false;
    overlap_.axes.push_back({outwards * plane.normal, depth});
  }
  return true;
}

/// Adds the vertices of `part` that lie in the other and the points where its edges enter and leave that.
void OverlapFinder::add_corners(const PlacedPart& part, const Heights& heights) {
  beyond_.assign(heights, 0.0);
  for (std::size_t i = 0; i < part.vertices.size(); ++i)
    if (beyond_.none(i)) overlap_.vertices.push_back(part.vertices[i]);
  for (const Edge& edge : part.part->edges) {
    const auto from = static_cast<std::size_t>(edge.from), to = static_cast<std::size_t>(edge.to);
    if (beyond_.both(from, to)) continue;
    double enters = 0.0, leaves = 1.0;  // shares of the way along the edge
    beyond_.each_between(from, to, [&](std::size_t plane, bool starts_beyond) {
      const double start = heights.of(from, plane), end = heights.of(to, plane);
      const double at = start / (start - end);
      if (starts_beyond)
        enters = std::max(enters, at);
      else
        leaves = std::min(leaves, at);
    });
    if (enters >= leaves) continue;
    const Vec3 start = part.vertices[from], along = part.vertices[to] - start;
    if (enters > 0.0) overlap_.vertices.push_back(start + enters * along);
    if (leaves < 1.0) overlap_.vertices.push_back(start + leaves * along);
  }
}

const Overlap& OverlapFinder::find(const PlacedPart& a, const PlacedPart& b) {
  overlap_.vertices.clear();
  overlap_.axes.clear();
  if (are_parted(a, b) || are_parted(b, a)) return overlap_;
  if (!find_axes(a, b, 1.0, of_a_) || !find_axes(b, a, -1.0, of_b_)) return overlap_;
  add_corners(a, of_a_);
  add_corners(b, of_b_);
  return overlap_;
}

const Overlap& OverlapFinder::below(const PlacedPart& a, const Plane& surface) {
  overlap_.vertices.clear();
  overlap_.axes.clear();
  of_a_.reset(a.corners, 1);
  if (of_a_.add(a.corners, surface).least < -kTouch) add_corners(a, of_a_);
  return overlap_;
}

/// Andrew's monotone chain on plane_points_, counter-clockwise.
void OverlapFinder::hull_2d() {
  std::vector<Vec2>& p = plane_points_;
  std::sort(p.begin(), p.end(), [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  hull_.clear();
  const auto add = [this](Vec2 q, std::size_t base) {
    while (hull_.size() >= base + 2 && cross(hull_.back() - hull_[hull_.size() - 2], q - hull_.back()) <= 0.0)
      hull_.pop_back();
    hull_.push_back(q);
  };
  for (const Vec2& q : p) add(q, 0);
  const std::size_t base = hull_.size() - 1;
  for (std::size_t i = p.size() - 1; i-- > 0;) add(p[i], base);
  hull_.pop_back();
}

/// Shares of the corners of hull_, then merges neighbours.
void OverlapFinder::lump(double u0, double v0) {
  const std::size_t n = hull_.size();
  const Vec2 centre{u0, v0};
  shares_.assign(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const double quarter = 0.25 * cross(hull_[i] - centre, hull_[j] - centre);
    shares_[i] += quarter;
    shares_[j] += quarter;
  }
  const double near = kMergeWithin * diameter();
  while (hull_.size() > 1) {
    std::size_t best = 0;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull_.size(); ++i) {
      const Vec2 edge = hull_[(i + 1) % hull_.size()] - hull_[i];
      if (dot(edge, edge) >= shortest) continue;
      shortest = dot(edge, edge);
      best = i;
    }
    if (hull_.size() <= patch_.points.size() && shortest >= near * near) return;
    const std::size_t next = (best + 1) % hull_.size();
    const double sum = shares_[best] + shares_[next];
    if (sum > 0.0) hull_[best] = hull_[best] + (shares_[next] / sum) * (hull_[next] - hull_[best]);
    shares_[best] = sum;
    hull_.erase(hull_.begin() + static_cast<std::ptrdiff_t>(next));
    shares_.erase(shares_.begin() + static_cast<std::ptrdiff_t>(next));
  }
}

/// Largest distance of two corners of hull_ [m].
double OverlapFinder::diameter() const {
  double largest = 0.0;
  for (std::size_t i = 0; i < hull_.size(); ++i)
    for (std::size_t j = i + 1; j < hull_.size(); ++j)
      largest = std::max(largest, dot(hull_[i] - hull_[j], hull_[i] - hull_[j]));
  return std::sqrt(largest);
}

const Patch& OverlapFinder::project(Vec3 normal) {
  patch_ = {};
  if (overlap_.vertices.size() < 4) return patch_;

  // A frame in the plane normal to the contact normal, its origin at a corner so that large coordinates cancel.
  const auto [u, v] = plane_axes(normal);
  const Vec3 origin = overlap_.vertices[0];
  double lowest = 0.0;
  double highest = 0.0;
  plane_points_.clear();
  for (const Vec3& corner : overlap_.vertices) {
    const Vec3 r = corner - origin;
    plane_points_.push_back({dot(u, r), dot(v, r)});
    lowest = std::min(lowest, dot(normal, r));
    highest = std::max(highest, dot(normal, r));
  }
  hull_2d();

  // Area and centroid.
  double twice_area = 0.0;
  Vec2 moment{};
  for (std::size_t i = 1; i + 1 < hull_.size(); ++i) {
    const Vec2 p = hull_[i] - hull_[0];
    const Vec2 q = hull_[i + 1] - hull_[0];
    const double c = cross(p, q);
    twice_area += c;
    moment += c * (p + q);
  }
  if (!(twice_area > 0.0) || highest - lowest <= kTouch) return patch_;
  const Vec2 centre = hull_[0] + moment / (3.0 * twice_area);
  patch_.area = 0.5 * twice_area;
  patch_.depth = highest - lowest;

  lump(centre.x, centre.y);
  patch_.n_points = static_cast<int>(hull_.size());
  for (std::size_t i = 0; i < hull_.size(); ++i)
    patch_.points[i] = {origin + hull_[i].x * u + hull_[i].y * v + (0.5 * (lowest + highest)) * normal, shares_[i]};
  return patch_;
}

double overlap_area(const PlacedPart& a, const PlacedPart& b, Vec3 normal) {
  OverlapFinder finder;
  finder.find(a, b);
  return finder.project(normal).area;
}

}  // namespace brash::rigid_body
