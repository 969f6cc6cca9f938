// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory_resource>
#include <utility>
#include <vector>

#include "surface_drag.hpp"

namespace brash::hydrodynamics {
namespace {

/// The share that a plane of a neighbour leaves at a point, 1/2 - distance / gap, linear in the point; body frame. A
/// neighbour holds the least of its ramps, between 0 and 1.
struct Ramp {
  double at;
  Vec3 slope;

  Lanes operator()(const Vectors& p) const { return at + dot(p, slope); }
};

/// The neighbours' planes as ramps on one floe.
class Ramps {
 public:
  Ramps(std::span<const Vectors> probes, const Pose& pose, double gap) : slope_(-1.0 / gap) {
    Vectors low = probes.front(), high = low;
    for (const Vectors& p : probes) {
      low = {min(low.x, p.x), min(low.y, p.y), min(low.z, p.z)};
      high = {max(high.x, p.x), max(high.y, p.y), max(high.z, p.z)};
    }
    const Vec3 lower{least(low.x), least(low.y), least(low.z)};
    const Vec3 upper{greatest(high.x), greatest(high.y), greatest(high.z)};
    centre_ = 0.5 * (lower + upper);
    half_ = 0.5 * (upper - lower);
    radius_ = norm(half_) / gap;
    world_centre_ = to_world(pose, centre_);
    const Quaternion to_axes = conjugate(pose.rotation);
    ex_ = rotate(to_axes, {slope_, 0.0, 0.0});
    ey_ = rotate(to_axes, {0.0, slope_, 0.0});
    ez_ = rotate(to_axes, {0.0, 0.0, slope_});
  }

  /// Writes the ramps of a neighbour that are anywhere among the probes below 1, first the least in the middle; there
  /// is room for four more than its planes.
  /// @return where they end; nullptr if it holds no water there, for one of its ramps is nowhere positive.
  Ramp* of(Solid solid, Ramp* const first) const;

 private:
  double slope_;
  Vec3 centre_, half_;  ///< of the box around the probes
  double radius_;       ///< by so much a ramp differs in the box at most from that in the middle
  Vec3 world_centre_;   ///< the centre in the world frame
  Vec3 ex_, ey_, ez_;   ///< the world's axes in the body frame, times the slope
};

Ramp* Ramps::of(Solid solid, Ramp* const first) const {
  Ramp* end = first;  // a ramp that is left out is written over by the next
  Ramp* nearest = first;
  double least_middle = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < solid.size(); i += 4) {
    const auto plane = [&](std::size_t k) -> const Plane& { return solid[std::min(i + k, solid.size() - 1)]; };
    const Plane &a = plane(0), &b = plane(1), &c = plane(2), &d = plane(3);
    const Vectors normal{{a.normal.x, b.normal.x, c.normal.x, d.normal.x},
                         {a.normal.y, b.normal.y, c.normal.y, d.normal.y},
                         {a.normal.z, b.normal.z, c.normal.z, d.normal.z}};
    const Lanes middle = 0.5 + slope_ * (dot(normal, world_centre_) - Lanes(a.offset, b.offset, c.offset, d.offset));
    if (least(middle) >= 1.0 + radius_) continue;
    const Vectors slope{dot(normal, {ex_.x, ey_.x, ez_.x}), dot(normal, {ex_.y, ey_.y, ez_.y}),
                        dot(normal, {ex_.z, ey_.z, ez_.z})};
    const Lanes change = dot(abs(slope), half_);
    if (least(middle + change) <= 0.0) return nullptr;
    const Lanes at = middle - dot(slope, centre_), lowest = middle - change;
    const std::size_t n = solid.size() - i;
    for (std::size_t k = 0; k < 4; ++k) {
      *end = {at[k], {slope.x[k], slope.y[k], slope.z[k]}};
      const bool kept = (lowest[k] < 1.0) & (k < n), nearer = kept & (middle[k] < least_middle);
      least_middle = nearer ? middle[k] : least_middle;
      nearest = nearer ? end : nearest;
      end += kept;
    }
  }
  if (end == first) *end++ = {1.0, {}};
  std::swap(*first, *nearest);
  return end;
}

}  // namespace

void open_shares(std::span<const Vectors> probes, const Pose& pose, std::span<const Solid> neighbours, double gap,
                 std::span<Lanes> open) {
  std::fill(open.begin(), open.end(), Lanes(1.0));
  if (neighbours.empty()) return;
  std::array<std::byte, 8192> room;
  std::pmr::monotonic_buffer_resource memory(room.data(), room.size());
  std::size_t n_planes = 0;
  for (const Solid solid : neighbours) n_planes = std::max(n_planes, solid.size());
  std::pmr::vector<Ramp> ramps(n_planes + 4, &memory);
  std::pmr::vector<std::size_t> near(probes.size(), &memory);

  const Ramps all(probes, pose, gap);
  for (const Solid solid : neighbours) {
    const Ramp* const end = all.of(solid, ramps.data());
    if (end == nullptr) continue;
    // Mostly the ramp that is the least in the middle shows which probes are out of reach.
    const Ramp nearest = ramps.front();
    std::size_t n_near = 0;
    for (std::size_t i = 0; i < probes.size(); ++i) {
      near[n_near] = i;
      n_near += any_above(-nearest.at, dot(probes[i], nearest.slope));
    }
    for (const std::size_t i : std::span(near).first(n_near)) {
      const Vectors probe = probes[i];
      Lanes held = 1.0;
      for (const Ramp* ramp = ramps.data(); ramp < end; ++ramp) held = min(held, (*ramp)(probe));
      open[i] = open[i] - max(held, 0.0);
    }
  }
  for (Lanes& share : open) share = max(share, 0.0);
}

}  // namespace brash::hydrodynamics
