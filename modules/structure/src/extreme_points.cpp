// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "convex_bodies.hpp"
#include "triangle_mesh.hpp"

namespace brash::structure {
namespace {

/// Neighbouring points and the box around them.
struct Block {
  std::span<const Vec3> points;
  Box box;
};

/// Halves points across the longest side of their box until each block has few.
void divide(std::span<Vec3> points, std::vector<Block>& blocks) {
  constexpr std::size_t kFewPoints = 64;
  const Block whole{points, box_around(points)};
  if (points.size() <= kFewPoints) {
    blocks.push_back(whole);
    return;
  }
  const Vec3 size = whole.box.size();
  const auto along = size.x >= std::max(size.y, size.z) ? &Vec3::x : size.y >= size.z ? &Vec3::y : &Vec3::z;
  const std::size_t half = points.size() / 2;
  std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(half), points.end(),
                   [along](const Vec3& a, const Vec3& b) { return a.*along < b.*along; });
  divide(points.first(half), blocks);
  divide(points.subspan(half), blocks);
}

/// How far a point is in a direction, and of points as far, its place among them.
auto distance_and_order(Vec3 towards, const Vec3& v) { return std::tuple(dot(towards, v), v.x, v.y, v.z); }

/// The farthest point in a direction. A block is skipped if the corner of its box is not as far. Rounding is monotone,
/// so the corner bounds its points exactly.
Vec3 farthest(Vec3 towards, const std::vector<Block>& blocks) {
  const auto bound = [&](const Block& block) {
    return dot(towards, {towards.x > 0.0 ? block.box.most.x : block.box.least.x,
                         towards.y > 0.0 ? block.box.most.y : block.box.least.y,
                         towards.z > 0.0 ? block.box.most.z : block.box.least.z});
  };
  const auto order = [&](const Vec3& v) { return distance_and_order(towards, v); };
  const auto farthest_of = [&](const Block& block) { return *std::ranges::max_element(block.points, {}, order); };
  Vec3 best = farthest_of(*std::ranges::max_element(blocks, {}, bound));
  for (const Block& block : blocks)
    if (bound(block) >= dot(towards, best))
      best = std::max(best, farthest_of(block), [&](const Vec3& a, const Vec3& b) { return order(a) < order(b); });
  return best;
}

}  // namespace

void keep_one_of_each(std::vector<Vec3>& points) {
  std::ranges::sort(points, {}, [](const Vec3& v) { return std::tuple(v.x, v.y, v.z); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

Vec3 spread_direction(int i, int n) {
  constexpr double kGoldenAngle = 2.399963229728653;
  const double z = 1.0 - (2.0 * i + 1.0) / n, r = std::sqrt(1.0 - z * z), around = kGoldenAngle * i;
  return {r * std::cos(around), r * std::sin(around), z};
}

std::vector<Vec3> extreme_points(std::vector<Vec3> points, int n) {
  std::vector<Block> blocks;
  divide(points, blocks);
  std::vector<Vec3> far;
  far.reserve(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) far.push_back(farthest(spread_direction(i, n), blocks));
  keep_one_of_each(far);
  return far;
}

}  // namespace brash::structure
