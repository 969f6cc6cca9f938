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

template <typename Table>
double interpolated(const Table& table, double breadth, double crack) {
  const Between i = find(kBreadths, breadth), j = find(kCrackLengths, crack);
  const auto row = [&](std::size_t n) { return (1.0 - j.share) * table[n][j.below] + j.share * table[n][j.below + 1]; };
  return (1.0 - i.share) * row(i.below) + i.share * row(i.below + 1);
}

}  // namespace

double stress_intensity(const SplittingLoad& load, const SplitPlate& plate, double share) {
  BRASH_EXPECTS(load.thickness > 0.0 && plate.length > 0.0 && plate.breadth > 0.0, load.thickness, plate.length,
                plate.breadth);
  const double a = std::clamp(share, kCrackLengths.front(), kCrackLengths.back());
  const double breadth = plate.breadth / plate.length;
  const double factor =
      load.opening * interpolated(kOpening, breadth, a) - load.push * interpolated(kClosing, breadth, a);
  return factor / (load.thickness * std::sqrt(plate.length * a) * std::pow(1.0 - a, 1.5));
}

double least_intensity(const SplittingLoad& load, const SplitPlate& plate) {
  double least = stress_intensity(load, plate, kCrackLengths.front());
  for (const double share : kCrackLengths) least = std::min(least, stress_intensity(load, plate, share));
  return least;
}

double splitting_force(double toughness, double thickness, const SplitPlate& plate) {
  return toughness / least_intensity({.opening = 1.0, .thickness = thickness}, plate);
}

}  // namespace brash::failure
