// SPDX-License-Identifier: GPL-3.0-or-later
#include "shade.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brash::hydrodynamics {
namespace {

/// What is left out is this much [m] farther off than it would have to be: many times the round-off of a distance.
constexpr double kMargin = 1e-9;

Vec3 mean(std::span<const Vec3> points) {
  const bool four = points.size() == 4;  // a quarter is exact, and a product is faster than a quotient
  Vec3 sum{};
  for (const Vec3 p : points) sum += four ? 0.25 * p : p / static_cast<double>(points.size());
  return sum;
}

/// At least the length of a vector.
double size(Vec3 v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

}  // namespace

Shade::Shade(const Prism& prism, const Pose& pose, std::span<const Solid> neighbours, double gap)
    : pose_(pose), gap_(gap) {
  if (gap <= 0.0 || neighbours.empty()) return;
  Vec2 low = prism.rings.front().front(), high = low;
  for (const Vec2 vertex : prism.rings.front()) {
    low = {std::min(low.x, vertex.x), std::min(low.y, vertex.y)};
    high = {std::max(high.x, vertex.x), std::max(high.y, vertex.y)};
  }
  const Vec3 centre{0.5 * (low.x + high.x), 0.5 * (low.y + high.y), 0.0};
  const Vec3 half{0.5 * (high.x - low.x) + gap, 0.5 * (high.y - low.y) + gap, 0.5 * prism.thickness + gap};
  near_.reserve(8 * neighbours.size());
  near_ends_.reserve(neighbours.size());
  for (const Solid solid : neighbours) keep(solid, centre, half);
  planes_.reserve(near_.size());
  ends_.reserve(near_ends_.size());
}

/// Keeps the planes of `solid` that pass among the probes, which the box in the body frame holds; nothing of a solid
/// that is out of their reach.
void Shade::keep(Solid solid, Vec3 box_centre, Vec3 half_box) {
  const double cut = 0.5 * gap_ + kMargin;
  const Vec3 centre = to_world(pose_, box_centre);
  const double radius = norm(half_box);
  for (const Plane& plane : solid)
    if (dot(plane.normal, centre) - plane.offset > radius + cut) return;
  const Quaternion to_axes = conjugate(pose_.rotation);
  const std::size_t first = near_.size();
  for (const Plane& plane : solid) {
    const double distance = dot(plane.normal, centre) - plane.offset;
    if (distance < -(radius + cut)) continue;
    const Vec3 normal = rotate(to_axes, plane.normal);
    const double extent =
        std::abs(normal.x) * half_box.x + std::abs(normal.y) * half_box.y + std::abs(normal.z) * half_box.z;
    if (distance < -(extent + cut)) continue;
    if (distance > extent + cut) {
      near_.resize(first);
      return;
    }
    near_.push_back({plane, {normal, plane.offset - dot(plane.normal, pose_.position)}});
  }
  near_ends_.push_back(near_.size());
}

void Shade::face(std::span<const Vec3> corners, Vec3 normal, const Patch& around) {
  planes_.clear();
  ends_.clear();
  closed_ = false;
  if (near_ends_.empty()) return;
  const Vec3 centre = mean(corners);
  const Vec3 middle = to_world(pose_, centre) + gap_ * rotate(pose_.rotation, normal);
  const Vec3 around_probe = around.centre + gap_ * normal;
  const double cut = 0.5 * gap_ + kMargin;
  const double farthest = size(around.u) + size(around.v) + cut;
  std::size_t begin = 0;
  for (const std::size_t end : near_ends_) {
    const std::size_t first = planes_.size();
    bool apart = false;
    for (std::size_t i = begin; i < end; ++i) {
      const auto& [world, body] = near_[i];
      const double distance = dot(body.normal, around_probe) - body.offset;
      // Most are far apart, and no closer look is needed.
      const double reach =
          distance > farthest ? cut : std::abs(dot(body.normal, around.u)) + std::abs(dot(body.normal, around.v)) + cut;
      apart = distance > reach;
      if (apart) {
        std::swap(near_[begin], near_[i]);  // it is likely to part the next face from this neighbour too
        break;
      }
      if (distance >= -reach)
        planes_.push_back({body.normal, dot(body.normal, centre) - (dot(world.normal, middle) - world.offset)});
    }
    begin = end;
    if (apart) {
      planes_.resize(first);
    } else {
      closed_ |= planes_.size() == first;
      ends_.push_back(planes_.size());
    }
  }
}

Lanes Shade::open_share(const Points& points) const {
  Lanes held = Lanes::Zero();
  std::size_t i = 0;
  for (const std::size_t end : ends_) {
    Lanes share = Lanes::Ones();
    for (; i < end; ++i) {
      const auto& [n, offset] = planes_[i];
      share = share.min(0.5 - (n.x * points.x + n.y * points.y + n.z * points.z - offset) / gap_);
    }
    held += share.max(0.0);
  }
  return (1.0 - held).max(0.0);
}

}  // namespace brash::hydrodynamics
