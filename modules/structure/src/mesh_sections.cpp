// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_sections.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "triangle_mesh.hpp"

namespace brash::structure {
namespace {

/// Layers of the index. One layer of a ship is a few centimetres high.
constexpr int kLayers = 256;
/// Cosine of the tilt beyond which the layers do not help.
constexpr double kSteep = 0.5;

/// World's height of a point of the body: height = offset + dot(up, point).
struct Heights {
  Vec3 up;
  double offset;

  explicit Heights(const Pose& pose) : up(rotate(conjugate(pose.rotation), {0.0, 0.0, 1.0})), offset(pose.position.z) {}
  double of(Vec3 point) const { return offset + dot(up, point); }
};

std::pair<double, double> range_of(const std::array<Vec3, 3>& triangle) {
  const auto [low, high] = std::minmax({triangle[0].z, triangle[1].z, triangle[2].z});
  return {low, high};
}

}  // namespace

MeshSections::MeshSections(TriangleMesh mesh) : mesh_(std::move(mesh)), neighbours_(neighbours_of(mesh_)) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  least_ = {kFar, kFar, kFar}, most_ = -least_;
  for (const Vec3 v : mesh_.vertices) {
    least_ = {std::min(least_.x, v.x), std::min(least_.y, v.y), std::min(least_.z, v.z)};
    most_ = {std::max(most_.x, v.x), std::max(most_.y, v.y), std::max(most_.z, v.z)};
  }
  const double layer = (most_.z - least_.z) / kLayers;
  const auto layer_of = [&](double z) { return std::clamp(static_cast<int>((z - least_.z) / layer), 0, kLayers - 1); };
  std::vector<std::uint16_t> highest;
  starts_.assign(kLayers + 1, 0);
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const auto [low, high] = range_of(corners(mesh_, t));
    lowest_.push_back(static_cast<std::uint16_t>(layer_of(low)));
    highest.push_back(static_cast<std::uint16_t>(layer_of(high)));
    for (int i = lowest_.back(); i <= highest.back(); ++i) ++starts_[static_cast<std::size_t>(i) + 1];
  }
  for (std::size_t i = 0; i < kLayers; ++i) starts_[i + 1] += starts_[i];
  members_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
    for (std::size_t i = lowest_[t]; i <= highest[t]; ++i) members_[next[i]++] = static_cast<std::uint32_t>(t);
}

/// The heights of the body that a slab of the world reaches: a tilted body has its highest point where it is widest.
std::vector<int> MeshSections::near(const Pose& pose, double bottom, double top) const {
  const Heights heights(pose);
  int from = 0, to = kLayers - 1;
  if (heights.up.z > kSteep) {
    const double x = heights.up.x, y = heights.up.y;
    const double least = std::min(x * least_.x, x * most_.x) + std::min(y * least_.y, y * most_.y);
    const double most = std::max(x * least_.x, x * most_.x) + std::max(y * least_.y, y * most_.y);
    const double low = (bottom - heights.offset - most) / heights.up.z;
    const double high = (top - heights.offset - least) / heights.up.z;
    if (high < least_.z || low > most_.z) return {};
    const double layer = (most_.z - least_.z) / kLayers;
    from = std::clamp(static_cast<int>(std::floor((low - least_.z) / layer)) - 1, 0, kLayers - 1);
    to = std::clamp(static_cast<int>(std::floor((high - least_.z) / layer)) + 1, 0, kLayers - 1);
  }
  std::vector<int> triangles;
  for (int i = from; i <= to; ++i)
    for (std::uint32_t m = starts_[static_cast<std::size_t>(i)]; m < starts_[static_cast<std::size_t>(i) + 1]; ++m)
      if (i == from || lowest_[members_[m]] == i) triangles.push_back(static_cast<int>(members_[m]));
  return triangles;
}

/// A vertex at the height itself counts as below it, so that each triangle is crossed in one segment or not at all. The
/// segments join across the edges that rise through the height, the hull on their left.
Loops MeshSections::at(const Pose& pose, double z, const std::vector<int>& near) const {
  const Heights heights(pose);
  const auto vertex = [&](int t, int k) {
    return static_cast<std::size_t>(mesh_.triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(k % 3)]);
  };
  const auto is_above = [&](std::size_t v) { return heights.of(mesh_.vertices[v]) > z; };
  /// The edge of a triangle through which its section leaves it, or -1.
  const auto exit_of = [&](int t) {
    for (int k = 0; k < 3; ++k)
      if (!is_above(vertex(t, k)) && is_above(vertex(t, k + 1))) return k;
    return -1;
  };
  const auto crossing = [&](std::size_t low, std::size_t high) {
    const Vec3 a = mesh_.vertices[low], b = mesh_.vertices[high];
    const double at_a = heights.of(a), at_b = heights.of(b);
    return plan(to_world(pose, a + (z - at_a) / (at_b - at_a) * (b - a)));
  };
  Loops loops;
  std::vector<bool> seen(mesh_.triangles.size(), false);
  for (const int start : near) {
    if (seen[static_cast<std::size_t>(start)] || exit_of(start) < 0) continue;
    Outline loop;
    for (int t = start; !seen[static_cast<std::size_t>(t)];) {
      seen[static_cast<std::size_t>(t)] = true;
      const int k = exit_of(t);
      loop.push_back(crossing(vertex(t, k), vertex(t, k + 1)));
      t = neighbours_[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)];
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace brash::structure
