// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "brash/core/vec.hpp"

namespace brash::rigid_body {

/// Points with their coordinates apart, so that the distances of two of them along a direction are found side by side;
/// each distance is that of dot(), to the bit.
class Corners {
 public:
  void assign(std::span<const Vec3> points);

  /// Least and greatest distance along `direction`; at least one point.
  std::pair<double, double> extent(Vec3 direction) const;
  /// The first of the points that are farthest along `direction`.
  std::size_t farthest(Vec3 direction) const;

 private:
  using Pair = double __attribute__((vector_size(16)));
  /// Two points.
  struct Two {
    Pair x;
    Pair y;
    Pair z;
    Pair along(Vec3 direction) const { return direction.x * x + direction.y * y + direction.z * z; }
  };

  /// As many of them are looked at together.
  static constexpr std::size_t kBlock = 4;

  static Pair greater(Pair a, Pair b) { return a > b ? a : b; }
  static Pair lesser(Pair a, Pair b) { return a < b ? a : b; }

  std::vector<Two> twos_;  ///< whole blocks, filled up with the last point
};

inline void Corners::assign(std::span<const Vec3> points) {
  const std::size_t n_blocks = (points.size() + 2 * kBlock - 1) / (2 * kBlock);
  twos_.resize(kBlock * n_blocks);
  for (std::size_t i = 0; i < twos_.size(); ++i) {
    const Vec3 a = points[std::min(2 * i, points.size() - 1)], b = points[std::min(2 * i + 1, points.size() - 1)];
    twos_[i] = Two{Pair{a.x, b.x}, Pair{a.y, b.y}, Pair{a.z, b.z}};
  }
}

inline std::pair<double, double> Corners::extent(Vec3 direction) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Pair least{kInfinity, kInfinity}, greatest{-kInfinity, -kInfinity};
  for (const Two& two : twos_) {
    const Pair at = two.along(direction);
    least = lesser(at, least);
    greatest = greater(at, greatest);
  }
  return {std::min(least[0], least[1]), std::max(greatest[0], greatest[1])};
}

inline std::size_t Corners::farthest(Vec3 direction) const {
  double greatest = -std::numeric_limits<double>::infinity();
  std::size_t first = 0;
  for (std::size_t begin = 0; begin < twos_.size(); begin += kBlock) {
    std::array<Pair, kBlock> at;
    for (std::size_t i = 0; i < kBlock; ++i) at[i] = twos_[begin + i].along(direction);
    const Pair of_pairs = greater(greater(at[0], at[1]), greater(at[2], at[3]));
    const double most = std::max(of_pairs[0], of_pairs[1]);
    if (!(most > greatest)) continue;
    greatest = most;
    unsigned those = 0;  // one bit for each point of the block
    for (std::size_t i = 0; i < kBlock; ++i)
      those |= (static_cast<unsigned>(at[i][0] == most) | static_cast<unsigned>(at[i][1] == most) << 1) << 2 * i;
    first = 2 * begin + static_cast<std::size_t>(std::countr_zero(those));
  }
  return first;
}

}  // namespace brash::rigid_body
