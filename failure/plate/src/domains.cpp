// SPDX-License-Identifier: GPL-3.0-or-later
#include "domains.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "production_sizes.hpp"
#include "solve_at_order.hpp"

namespace brash::plate {

namespace {

/// A protrusion or a bay less deep than this is a straight edge.
constexpr double kFlat = 1e-6;

}  // namespace

double production_tip_size(const WedgePlate& plate) { return std::min(kTipSize, kTipShare * plate.contact_length); }

Vec2 root_of(const WedgePlate& plate) {
  return {plate.depth, 0.5 * plate.contact_length + std::abs(plate.depth) * std::tan(0.5 * plate.angle)};
}

Domain half_of_wedge_plate(const WedgePlate& plate, const MeshOptions& options) {
  const double tip = options.tip_size > 0.0 ? options.tip_size : production_tip_size(plate);
  const double scale = tip / production_tip_size(plate);
  const double gradation = scale * kGradation;
  const double reach = options.half_width > 0.0 ? options.half_width : kHalfWidth;
  const bool is_flat = std::abs(plate.depth) < kFlat;
  const Vec2 corner{0.0, 0.5 * plate.contact_length};
  const Vec2 root = is_flat ? corner : root_of(plate);
  const double base = std::max(0.0, root.x);
  const Vec2 far{base + reach, root.y + reach};

  Domain domain;
  domain.largest_size = options.far_size > 0.0 ? options.far_size : reach;
  domain.segments = {{{0.0, 0.0}, {far.x, 0.0}, plate.split ? Side::kCrack : Side::kSymmetryY},
                     {{far.x, 0.0}, far, Side::kFar},
                     {far, {root.x, far.y}, Side::kFar},
                     {{root.x, far.y}, root, Side::kFree},
                     {corner, {0.0, 0.0}, Side::kTip}};
  domain.sizes = {{{0.0, 0.0}, corner, tip, gradation},
                  {corner, corner, tip * kTipCornerShare, gradation},
                  {{0.0, 0.0}, {base + kBreakingZone, 0.0}, kCentreSize * scale, gradation}};
  if (!is_flat) {
    domain.segments.push_back({root, corner, Side::kFree});
    domain.sizes.push_back({corner, root, kSideSize * scale, gradation});
    domain.sizes.push_back({root, root, std::min(kRootSize, kRootShare * root.y) * scale, gradation});
  }
  return domain;
}

Domain half_of_moving_plate(const WedgePlate& plate, double reach, double scale) {
  const bool is_flat = std::abs(plate.depth) < kFlat;
  const Vec2 corner{0.0, 0.5 * plate.contact_length};
  const Vec2 root = is_flat ? corner : root_of(plate);
  const double base = std::max(0.0, root.x);
  const Vec2 far{base + reach, root.y + reach};
  Domain domain;
  domain.largest_size = reach;
  domain.segments = {{{0.0, 0.0}, {far.x, 0.0}, Side::kSymmetryY},
                     {{far.x, 0.0}, far, Side::kFar},
                     {far, {root.x, far.y}, Side::kFar},
                     {{root.x, far.y}, root, Side::kFree},
                     {corner, {0.0, 0.0}, Side::kTip}};
  const double gradation = kGradation;
  const auto add = [&](Vec2 from, Vec2 to, double size) {
    domain.sizes.push_back({from, to, scale * size, gradation});
  };
  add({0.0, 0.0}, {base + kBreakingZone, 0.0}, kMovingCentreSize);
  const double tip = moving_tip_size(plate.contact_length);
  add({0.0, 0.0}, {0.0, std::min(corner.y, kMovingTipReach)}, tip);
  add(corner, corner, kMovingCornerShare * tip);
  if (!is_flat) {
    domain.segments.push_back({root, corner, Side::kFree});
    add(root, root, std::min(kRootSize, kRootShare * root.y));
  }
  // Along the free edge, from B on, by stretches that double.
  const std::array<Vec2, 4> edge{Vec2{0.0, 0.0}, corner, root, Vec2{root.x, far.y}};
  for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
    const double length = norm(edge[i + 1] - edge[i]);
    for (double from = 0.0, step = kMovingTipReach; from < length; from += step, step *= 2.0) {
      const auto at = [&](double s) { return edge[i] + (std::min(s, length) / length) * (edge[i + 1] - edge[i]); };
      add(at(from), at(from + step), kMovingEdgeSize + kMovingEdgeGrowth * norm(at(from)));
    }
  }
  return domain;
}

}  // namespace brash::plate
