// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/sobol.hpp"

#include <gsl/gsl_qrng.h>

#include <array>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/statistics/random.hpp"
#include "gsl_checked.hpp"

namespace brash::statistics {
namespace {

constexpr double kCells = 0x1p30;  // GSL's sequence has 30 bits

using Sequence = GslOwner<gsl_qrng, gsl_qrng_free>;

}  // namespace

std::vector<double> sobol(std::size_t n, std::size_t dimension, std::uint64_t seed) {
  BRASH_EXPECTS(n >= 1 && n <= kMostSobolPoints, n, kMostSobolPoints);
  BRASH_EXPECTS(dimension >= 1 && dimension <= kMostSobolDimensions, dimension, kMostSobolDimensions);
  quiet_gsl();
  const Sequence sequence(gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned int>(dimension)));
  if (!sequence) throw RunError("Sobol sequence: out of memory");
  std::array<std::uint32_t, kMostSobolDimensions> shift{};
  RandomStream random(seed, "sobol", 0, "shift");
  for (std::uint32_t& bits : shift) bits = static_cast<std::uint32_t>(random.uniform() * kCells);

  // GSL leaves out the sequence's first point, the origin.
  std::array<double, kMostSobolDimensions> point{};
  std::vector<double> points;
  points.reserve(n * dimension);
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0) check_gsl(gsl_qrng_get(sequence.get(), point.data()), "Sobol sequence");
    for (std::size_t j = 0; j < dimension; ++j) {
      const auto cell = static_cast<std::uint32_t>(std::llround(point[j] * kCells));
      points.push_back(((cell ^ shift[j]) + 0.5) / kCells);
    }
  }
  return points;
}

}  // namespace brash::statistics
