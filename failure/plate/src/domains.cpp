// SPDX-License-Identifier: GPL-3.0-or-later
#include "domains.hpp"

#include <algorithm>
#include <cmath>

namespace brash::plate {

namespace {

/// A protrusion less deep than this is a straight edge.
constexpr double kFlat = 1e-6;

// Production sizes over l_c, chosen by the convergence study of docs/theory/failure.md.
constexpr double kTipSize =
    0.05;  ///< near the tip and the roots, or a quarter of the contact length where that is less
constexpr double kCentreSize = 0.15;  ///< along the centre line where the plate breaks
constexpr double kFarSize = 1.6;
constexpr double kHalfWidth = 8.0;   ///< of the sheet beyond the protrusion
constexpr double kGradation = 0.35;  ///< growth of the size with distance

}  // namespace

Vec2 root_of(const WedgePlate& plate) {
  return {plate.depth, 0.5 * plate.contact_length + plate.depth * std::tan(0.5 * plate.angle)};
}

Domain half_of_wedge_plate(const WedgePlate& plate, const MeshOptions& options) {
  const double tip_default = std::min(kTipSize, 0.25 * plate.contact_length);
  const double tip = options.tip_size > 0.0 ? options.tip_size : tip_default;
  const double finer = std::min(1.0, tip / tip_default);
  const double reach = options.half_width > 0.0 ? options.half_width : kHalfWidth;
  const bool is_flat = plate.depth < kFlat;
  const Vec2 corner{0.0, 0.5 * plate.contact_length};
  const Vec2 root = is_flat ? corner : root_of(plate);
  const Vec2 far{root.x + reach, root.y + reach};

  Domain domain;
  domain.largest_size = options.far_size > 0.0 ? options.far_size : kFarSize;
  domain.segments = {{{0.0, 0.0}, {far.x, 0.0}, Side::kSymmetryY},
                     {{far.x, 0.0}, far, Side::kFar},
                     {far, {root.x, far.y}, Side::kFar},
                     {{root.x, far.y}, root, Side::kFree}};
  if (!is_flat) domain.segments.push_back({root, corner, Side::kFree});
  domain.segments.push_back({corner, {0.0, 0.0}, Side::kTip});

  domain.sizes.push_back({{0.0, 0.0}, corner, tip, kGradation});
  domain.sizes.push_back({{0.0, 0.0}, {root.x + 1.5, 0.0}, kCentreSize * finer, kGradation});
  if (!is_flat) domain.sizes.push_back({root, root, std::min(kTipSize, plate.thickness) * finer, kGradation});
  return domain;
}

}  // namespace brash::plate
