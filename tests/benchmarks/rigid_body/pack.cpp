// SPDX-License-Identifier: GPL-3.0-or-later
#include "pack.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace pack {

namespace {

constexpr double kSide = 1.5;
constexpr double kThickness = 0.33;
constexpr double kDensity = 900.0;
constexpr double kStartGap = 0.002;  ///< along x and z, closed in the end
constexpr double kRowGap = 0.02;     ///< across, stays open

/// Edges of the floes of a layer in one direction: whole floes, or shifted by half with halves at the ends.
std::vector<double> edges(int n, bool shifted) {
  std::vector<double> result{0.0};
  for (int i = 0; i < n; ++i) result.push_back((i + (shifted ? 0.5 : 1.0)) * kSide);
  if (shifted) result.push_back(n * kSide);
  return result;
}

}  // namespace

double Pack::mass() const {
  double sum = 0.0;
  for (const Floe& floe : floes) sum += floe.mass;
  return sum;
}

Pack make_pack(int along, int across, int layers) {
  Pack pack;
  for (int k = 0; k < layers; ++k) {
    const std::vector<double> x = edges(along, k % 2 == 1);
    const std::vector<double> y = edges(across, k % 2 == 1);
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
      for (std::size_t j = 0; j + 1 < y.size(); ++j) {
        Floe floe;
        floe.size = {x[i + 1] - x[i], y[j + 1] - y[j] - kRowGap, kThickness};
        floe.rest = {0.5 * (x[i] + x[i + 1]), 0.5 * (y[j] + y[j + 1] - across * kSide), (k + 0.5) * kThickness};
        floe.start = floe.rest;
        floe.start.x += kStartGap * static_cast<double>(i + 1);
        floe.start.z += kStartGap * (k + 1);
        floe.mass = kDensity * floe.size.x * floe.size.y * floe.size.z;
        pack.floes.push_back(floe);
      }
  }
  return pack;
}

Outcome run(const Pack& pack, Engine& engine, double dt) {
  const int steps = static_cast<int>(std::lround(kSeconds / dt));
  const int measured = static_cast<int>(std::lround(kMeasured / dt));
  const double weight = pack.mass() * kGravity;
  Outcome outcome;
  for (int i = 0; i < steps; ++i) {
    const std::clock_t start = std::clock();
    const Loads loads = engine.step();
    outcome.seconds += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / kSeconds;
    if (i < steps - measured) continue;
    outcome.bed_error += std::abs(loads.bed / weight - 1.0) / measured;
    outcome.wall_error += std::abs(loads.wall / (kPush * weight) - 1.0) / measured;
  }
  for (std::size_t i = 0; i < pack.floes.size(); ++i) {
    const Vec3 is = engine.centre(i);
    const Vec3& rest = pack.floes[i].rest;
    outcome.position_error = std::max(outcome.position_error, std::hypot(is.x - rest.x, is.y - rest.y, is.z - rest.z));
  }
  return outcome;
}

}  // namespace pack
