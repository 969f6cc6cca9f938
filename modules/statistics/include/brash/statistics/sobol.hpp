// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace brash::statistics {

constexpr std::size_t kMostSobolDimensions = 40;
constexpr std::size_t kMostSobolPoints = std::size_t{1} << 24;

/// The first points of GSL's Sobol sequence, shifted by random bits.
///
/// More points continue the sequence: the first n are the same for every larger number. In each dimension, the first
/// 2^k points have one in each of 2^k equal parts of the unit interval. The shift (exclusive or of 30 bits) keeps that,
/// and makes each point uniform.
///
/// @param n          number of points, at least 1 and at most kMostSobolPoints.
/// @param dimension  1 to kMostSobolDimensions.
/// @param seed       of the shift.
/// @return shape=(n, dimension), row by row, in (0, 1).
/// @see experiments/sensitivity/README.md, (U1); P. Bratley, B. L. Fox, ACM Trans. Math. Softw. 14 (1988) 88, algorithm
/// 659; A. B. Owen, J. Complexity 14 (1998) 466.
std::vector<double> sobol(std::size_t n, std::size_t dimension, std::uint64_t seed);

}  // namespace brash::statistics
