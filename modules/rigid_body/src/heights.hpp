// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "brash/core/plane.hpp"
#include "corners.hpp"

namespace brash::rigid_body {

/// Heights of a part's vertices over those planes of another part that pass through it [m].
class Heights {
 public:
  /// Room for `n_planes` planes under `corners`; none is kept yet.
  void reset(const Corners& corners, std::size_t n_planes) {
    n_planes_ = 0;
    stride_ = corners.n_heights();
    if (values_.size() < n_planes * stride_) values_.resize(n_planes * stride_);
  }
  /// Least and greatest height over `plane`, which is kept if it passes through the part.
  Extent add(const Corners& corners, const Plane& plane) {
    const Extent extent = corners.heights_over(plane, values_.data() + n_planes_ * stride_);
    if (extent.greatest > 0.0) ++n_planes_;
    return extent;
  }

  std::size_t n_planes() const { return n_planes_; }
  /// Length of a row: as many as the vertices, or one more.
  std::size_t stride() const { return stride_; }
  const double* row(std::size_t plane) const { return values_.data() + plane * stride_; }
  double of(std::size_t vertex, std::size_t plane) const { return row(plane)[vertex]; }

 private:
  std::size_t n_planes_ = 0;
  std::size_t stride_ = 0;
  std::vector<double> values_;  ///< a row for each plane
};

/// For each vertex the planes that it lies beyond: one bit for each.
class Beyond {
 public:
  /// Sets the bits of the planes that a vertex is more than `reach` [m] above.
  void assign(const Heights& heights, double reach) {
    n_words_ = (heights.n_planes() + kBits - 1) / kBits;
    const std::size_t stride = stride_ = heights.stride();
    words_.assign(n_words_ * stride, 0);
    for (std::size_t k = 0; k < heights.n_planes(); ++k) {
      const double* const row = heights.row(k);
      std::uint64_t* const words = words_.data() + k / kBits * stride;
      const std::uint64_t bit = std::uint64_t{1} << k % kBits;
      for (std::size_t i = 0; i < stride; ++i) words[i] |= row[i] > reach ? bit : 0;
    }
  }

  /// Whether the vertex is beyond no plane.
  bool none(std::size_t i) const {
    std::uint64_t all = 0;
    for (std::size_t w = 0; w < n_words_; ++w) all |= word(i, w);
    return all == 0;
  }
  /// Whether both vertices are beyond the same plane.
  bool both(std::size_t i, std::size_t j) const {
    std::uint64_t common = 0;
    for (std::size_t w = 0; w < n_words_; ++w) common |= word(i, w) & word(j, w);
    return common != 0;
  }
  /// Calls visit(plane, whether it is vertex i) for each plane that one of the two is beyond.
  template <typename Visit>
  void each_between(std::size_t i, std::size_t j, Visit visit) const {
    for (std::size_t w = 0; w < n_words_; ++w) {
      const std::uint64_t first = word(i, w);
      for (std::uint64_t rest = first ^ word(j, w); rest != 0; rest &= rest - 1) {
        const int bit = std::countr_zero(rest);
        visit(w * kBits + static_cast<std::size_t>(bit), (first >> bit & 1) != 0);
      }
    }
  }

 private:
  static constexpr std::size_t kBits = 64;

  std::uint64_t word(std::size_t vertex, std::size_t w) const { return words_[w * stride_ + vertex]; }

  std::size_t n_words_ = 0;
  std::size_t stride_ = 0;
  std::vector<std::uint64_t> words_;  ///< a row for each 64 planes
};

}  // namespace brash::rigid_body
