// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_placement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "brash/core/constants.hpp"
#include "brash/core/interruption.hpp"

namespace brash::ice {
namespace {

/// A ring finds no place after so many trials [-]. Ten times as many raise the reachable concentration by about 0.01.
constexpr int kTrials = 10000;

geometry::Extent box_of(std::span<const geometry::Point> ring) {
  geometry::Extent box;
  for (const geometry::Point p : ring) box.add(geometry::metres(p));
  return box;
}

bool boxes_meet(const geometry::Extent& a, const geometry::Extent& b) {
  return a.lower.x < b.upper.x && b.lower.x < a.upper.x && a.lower.y < b.upper.y && b.lower.y < a.upper.y;
}

/// A regular polygon about the origin.
struct Regular {
  int sides = 4;
  double radius = 0.0;  ///< of its corners [m]

  Regular(double area, int n) : sides(n), radius(std::sqrt(2.0 * area / (n * std::sin(2.0 * kPi / n)))) {}

  /// How far it reaches along x and y when turned by `phase`; at most, if it is nearly round.
  Vec2 reach(double phase) const {
    if (sides > 4) return {radius, radius};
    Vec2 reach{};
    for (int i = 0; i < sides; ++i) {
      const double angle = phase + 2.0 * kPi * i / sides;
      reach.x = std::max(reach.x, radius * std::abs(std::cos(angle)));
      reach.y = std::max(reach.y, radius * std::abs(std::sin(angle)));
    }
    return reach;
  }
};

bool is_within(const Domain& domain, const geometry::Extent& box) {
  return box.lower.x >= 0.0 && box.upper.x <= domain.length && box.lower.y >= -0.5 * domain.width &&
         box.upper.y <= 0.5 * domain.width;
}

}  // namespace

PlacedRings::PlacedRings(const Domain& domain, double side)
    : side_(side),
      low_(-0.5 * domain.width),
      n_columns_(static_cast<int>(domain.length / side) + 1),
      n_rows_(static_cast<int>(domain.width / side) + 1),
      cells_(static_cast<std::size_t>(n_columns_) * static_cast<std::size_t>(n_rows_)) {}

PlacedRings::Cells PlacedRings::cells_of(const geometry::Extent& box) const {
  const auto index = [&](double distance, int n) {
    return std::clamp(static_cast<int>(std::floor(distance / side_)), 0, n - 1);
  };
  return {index(box.lower.x, n_columns_), index(box.upper.x, n_columns_), index(box.lower.y - low_, n_rows_),
          index(box.upper.y - low_, n_rows_)};
}

const std::vector<std::size_t>& PlacedRings::cell(int i, int j) const {
  return cells_[static_cast<std::size_t>(j) * static_cast<std::size_t>(n_columns_) + static_cast<std::size_t>(i)];
}

bool PlacedRings::meets(std::span<const geometry::Point> ring) const {
  const geometry::Extent box = box_of(ring);
  const Cells at = cells_of(box);
  for (int j = at.low; j <= at.high; ++j)
    for (int i = at.left; i <= at.right; ++i)
      for (const std::size_t other : cell(i, j))
        if (boxes_meet(box, boxes_[other]) && overlap(ring, rings_[other])) return true;
  return false;
}

void PlacedRings::add(geometry::Ring ring) {
  const geometry::Extent box = box_of(ring);
  const Cells at = cells_of(box);
  for (int j = at.low; j <= at.high; ++j)
    for (int i = at.left; i <= at.right; ++i)
      cells_[static_cast<std::size_t>(j) * static_cast<std::size_t>(n_columns_) + static_cast<std::size_t>(i)]
          .push_back(rings_.size());
  rings_.push_back(std::move(ring));
  boxes_.push_back(box);
}

std::vector<geometry::Ring> place_at_random(const Domain& domain, std::span<const double> areas, int sides,
                                            std::span<const geometry::Ring> keep_out,
                                            statistics::RandomStream& random) {
  std::vector<std::size_t> order(areas.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });

  PlacedRings placed(domain, std::sqrt(domain.area() / static_cast<double>(areas.size())));
  const auto find_place = [&](const Regular& shape) -> geometry::Ring {
    for (int trial = 0; trial < kTrials; ++trial) {
      const double phase = 2.0 * kPi / sides * random.uniform();
      const Vec2 reach = shape.reach(phase);
      const Vec2 room{domain.length - 2.0 * reach.x, domain.width - 2.0 * reach.y};
      const double along = random.uniform(), across = random.uniform();
      if (room.x <= 0.0 || room.y <= 0.0) continue;
      const Vec2 centre{reach.x + along * room.x, -0.5 * domain.width + reach.y + across * room.y};
      geometry::Ring ring = geometry::disc(centre, shape.radius, sides, phase);
      const auto is_met = [&](const geometry::Ring& other) { return overlap(ring, other); };
      if (is_within(domain, box_of(ring)) && std::ranges::none_of(keep_out, is_met) && !placed.meets(ring)) return ring;
    }
    return {};
  };

  std::vector<geometry::Ring> rings(areas.size());
  for (const std::size_t i : order) {
    look_for_interruption();
    geometry::Ring ring = find_place(Regular(areas[i], sides));
    if (ring.empty()) return {};
    rings[i] = ring;
    placed.add(std::move(ring));
  }
  return rings;
}

}  // namespace brash::ice
