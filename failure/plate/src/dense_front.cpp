// SPDX-License-Identifier: GPL-3.0-or-later
#include "dense_front.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

// Two versions of the kernels, of which the processor's own is taken when the program starts. Both do the same
// operations in the same order: wider registers change no result.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define BRASH_WIDE [[gnu::target_clones("avx2", "default"), gnu::flatten]]
#else
#define BRASH_WIDE
#endif

namespace brash::plate {

namespace {

using Index = Eigen::Index;

/// Width of the blocks of columns and height of the tiles: a tile's sums stay in registers.
constexpr int kTile = 4;
/// Numbers of a column, as the compiler's vector type: Eigen's would have the registers of the oldest processor.
using Vector = double __attribute__((vector_size(kTile * sizeof(double))));

/// Subtracts from a tile of a matrix the product of `depth` columns of other rows with the entries of the tile's
/// columns.
template <int kColumns>
inline void subtract_tile(const double* rows, const double* columns, Index stride, Index depth, double* target,
                          Index target_stride) {
  Vector sum[kColumns] = {};  // NOLINT(modernize-avoid-c-arrays): std::array would lose the vector's attributes
  for (Index p = 0; p < depth; ++p, rows += stride, columns += stride) {
    Vector row;
    std::memcpy(&row, rows, sizeof(row));
    for (int j = 0; j < kColumns; ++j) sum[j] += columns[j] * row;
  }
  for (int j = 0; j < kColumns; ++j) {
    Vector column;
    std::memcpy(&column, target + j * target_stride, sizeof(column));
    column -= sum[j];
    std::memcpy(target + j * target_stride, &column, sizeof(column));
  }
}

/// The same for one row.
template <int kColumns>
inline void subtract_row(const double* row, const double* columns, Index stride, Index depth, double* target,
                         Index target_stride) {
  std::array<double, kColumns> sum{};
  for (Index p = 0; p < depth; ++p, row += stride, columns += stride) {
    for (int j = 0; j < kColumns; ++j) sum[static_cast<std::size_t>(j)] += columns[j] * *row;
  }
  for (int j = 0; j < kColumns; ++j) target[j * target_stride] -= sum[static_cast<std::size_t>(j)];
}

/// target -= a b', where b is the top of a; shape of the target=(height, kColumns), of a=(height, depth).
template <int kColumns>
inline void subtract_columns(const double* a, Index stride, Index depth, double* target, Index target_stride,
                             Index height) {
  Index i = 0;
  for (; i + kTile <= height; i += kTile) subtract_tile<kColumns>(a + i, a, stride, depth, target + i, target_stride);
  for (; i < height; ++i) subtract_row<kColumns>(a + i, a, stride, depth, target + i, target_stride);
}

inline void subtract_columns(const double* a, Index stride, Index depth, double* target, Index target_stride,
                             Index height, Index width) {
  switch (width) {
    case 1:
      return subtract_columns<1>(a, stride, depth, target, target_stride, height);
    case 2:
      return subtract_columns<2>(a, stride, depth, target, target_stride, height);
    case 3:
      return subtract_columns<3>(a, stride, depth, target, target_stride, height);
    default:
      return subtract_columns<kTile>(a, stride, depth, target, target_stride, height);
  }
}

/// Cholesky's factorisation of a few columns, from the diagonal down.
inline bool factorise(double* columns, Index stride, Index height, Index width) {
  for (Index j = 0; j < width; ++j) {
    double* column = columns + j * stride;
    if (!(column[j] > 0.0)) return false;
    column[j] = std::sqrt(column[j]);
    const double inverse = 1.0 / column[j];
    for (Index i = j + 1; i < height; ++i) column[i] *= inverse;
    for (Index l = j + 1; l < width; ++l) {
      double* other = columns + l * stride;
      const double factor = column[l];
      for (Index i = l; i < height; ++i) other[i] -= factor * column[i];
    }
  }
  return true;
}

}  // namespace

BRASH_WIDE bool eliminate(double* own, int k, double* left, int r) {
  const Index height = k + r + 1;
  for (Index j = 0; j < k; j += kTile) {
    const Index width = std::min<Index>(kTile, k - j);
    double* columns = own + j * height + j;
    subtract_columns(own + j, height, j, columns, height, height - j, width);
    if (!factorise(columns, height, height - j, width)) return false;
  }
  for (Index j = 0; j < r; j += kTile) {
    subtract_columns(own + k + j, height, k, left + j * (r + 1) + j, r + 1, r + 1 - j, std::min<Index>(kTile, r - j));
  }
  return true;
}

void substitute(const double* own, int k, int r, double* unknowns) {
  const Index n = k + r;
  for (Index j = k - 1; j >= 0; --j) {
    const double* column = own + j * (n + 1);
    const Eigen::Map<const Eigen::VectorXd> factor(column + j + 1, n - j - 1);
    const Eigen::Map<const Eigen::VectorXd> known(unknowns + j + 1, n - j - 1);
    unknowns[j] = (column[n] - factor.dot(known)) / column[j];
  }
}

}  // namespace brash::plate
