// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "brash/core/plane.hpp"
#include "brash/core/vec.hpp"

namespace brash::rigid_body {

/// The least and the greatest of some numbers.
struct Extent {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
};

/// Points with their coordinates apart, so that the heights of two points over a plane are found side by side.
class Corners {
 public:
  void assign(std::span<const Vec3> points);

  /// Room that the heights of all points take.
  std::size_t n_heights() const { return 2 * twos_.size(); }
  /// Fills `heights` (n_heights() numbers, the last perhaps twice) with the heights of the points over `plane` [m].
  Extent heights_over(const Plane& plane, double* heights) const;
  /// The least of these heights [m].
  double least_over(const Plane& plane) const;

 private:
  using Pair = double __attribute__((vector_size(16)));
  /// Two points.
  struct Two {
    Pair x;
    Pair y;
    Pair z;

    Pair over(const Plane& plane) const {
      const Vec3 n = plane.normal;
      return n.x * x + n.y * y + n.z * z - plane.offset;
    }
  };

  std::vector<Two> twos_;
};

inline void Corners::assign(std::span<const Vec3> points) {
  twos_.resize((points.size() + 1) / 2);
  for (std::size_t i = 0; i < twos_.size(); ++i) {
    const Vec3 a = points[2 * i], b = points[std::min(2 * i + 1, points.size() - 1)];
    twos_[i] = Two{Pair{a.x, b.x}, Pair{a.y, b.y}, Pair{a.z, b.z}};
  }
}

inline Extent Corners::heights_over(const Plane& plane, double* heights) const {
  const Extent none;
  Pair least{none.least, none.least}, greatest{none.greatest, none.greatest};
  for (const Two& two : twos_) {
    const Pair height = two.over(plane);
    least = height < least ? height : least;
    greatest = height > greatest ? height : greatest;
    *heights++ = height[0];
    *heights++ = height[1];
  }
  return {std::min(least[0], least[1]), std::max(greatest[0], greatest[1])};
}

inline double Corners::least_over(const Plane& plane) const {
  const Extent none;
  Pair least{none.least, none.least};
  for (const Two& two : twos_) {
    const Pair height = two.over(plane);
    least = height < least ? height : least;
  }
  return std::min(least[0], least[1]);
}

}  // namespace brash::rigid_body
