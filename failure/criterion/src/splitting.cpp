// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/failure/splitting.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "brash/core/contract.hpp"
#include "splitting_table.hpp"

namespace brash::failure {
namespace {

/// A place between two entries of an ascending list.
struct Between {
  std::size_t below = 0;
  double share = 0.0;
};

Between find(std::span<const double> list, double value) {
  const auto above = std::upper_bound(list.begin() + 1, list.end() - 1, value);
  const auto below = static_cast<std::size_t>(above - list.begin()) - 1;
  return {below, std::clamp((value - list[below]) / (list[below + 1] - list[below]), 0.0, 1.0)};
}

/// Between crack lengths along a line, between breadths along a power of the breadth.
template <typename Table>
double interpolated(const Table& table, double breadth, double crack) {
  const Between i = find(kBreadths, breadth), j = find(kCrackLengths, crack);
  const auto row = [&](std::size_t n) { return (1.0 - j.share) * table[n][j.below] + j.share * table[n][j.below + 1]; };
  const double share = std::log1p(i.share * (kBreadths[i.below + 1] / kBreadths[i.below] - 1.0)) /
                       std::log(kBreadths[i.below + 1] / kBreadths[i.below]);
  return std::pow(row(i.below), 1.0 - share) * std::pow(row(i.below + 1), share);
}

/// The factor of the push. Beyond the table its two halves are so broad that what turns them grows along a line.
double closing(double breadth, double crack) {
  constexpr double kLast = kBreadths.back(), kBefore = kBreadths[kBreadths.size() - 2];
  const double last = interpolated(kClosing, kLast, crack);
  if (breadth <= kLast) return interpolated(kClosing, breadth, crack);
  return last + (last - interpolated(kClosing, kBefore, crack)) * (breadth - kLast) / (kLast - kBefore);
}

}  // namespace

double stress_intensity(const SplittingLoad& load, const SplitPlate& plate, double share) {
  BRASH_EXPECTS(load.thickness > 0.0 && plate.length > 0.0 && plate.breadth > 0.0, load.thickness, plate.length,
                plate.breadth);
  const double a = std::clamp(share, kCrackLengths.front(), kCrackLengths.back());
  const double breadth = plate.breadth / plate.length;
  const double factor = load.opening * interpolated(kOpening, breadth, a) - load.push * closing(breadth, a);
  return factor / (load.thickness * std::sqrt(plate.length * a) * std::pow(1.0 - a, 1.5));
}

double least_intensity(const SplittingLoad& load, const SplitPlate& plate) {
  // The least is near the mouth, where a long plate does not feel its far end.
  const SplitPlate near{std::min(plate.length, plate.breadth / kBreadths.front()), plate.breadth};
  double least = stress_intensity(load, near, kCrackLengths.front());
  for (const double share : kCrackLengths) least = std::min(least, stress_intensity(load, near, share));
  return least;
}

double splitting_force(double toughness, double thickness, const SplitPlate& plate) {
  return toughness / least_intensity({.opening = 1.0, .thickness = thickness}, plate);
}

}  // namespace brash::failure
