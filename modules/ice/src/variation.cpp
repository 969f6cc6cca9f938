// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/ice/variation.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"

namespace brash::ice {
namespace {

/// More waves cost more and bring the correlation of one field nearer to its law; by rings and angles
/// (docs/theory/ice.md).
constexpr int kRings = 16;
constexpr int kAngles = 16;
/// Corners of the first edge in a correlation length. Its chords miss the edge by less than a hundredth of its
/// deviation.
constexpr double kCornersInLength = 8.0;
/// A triangle with sides beyond a correlation length is divided so many times at most. Its 12 288 places are then
/// nearly independent, and the mean errs by less than a hundredth of the deviation of the field.
constexpr int kMostDivisions = 6;

/// Calls `add` with the triangle if no side is longer than `longest`, else with the triangles that it falls into when
/// its sides are halved, and so on.
template <class Add>
void divide(Vec2 a, Vec2 b, Vec2 c, double longest, int divisions, const Add& add) {
  if (divisions == 0 || std::max({norm(b - a), norm(c - b), norm(a - c)}) <= longest) return add(a, b, c);
  const Vec2 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
  divide(a, ab, ca, longest, divisions - 1, add);
  divide(ab, b, bc, longest, divisions - 1, add);
  divide(ca, bc, c, longest, divisions - 1, add);
  divide(ab, bc, ca, longest, divisions - 1, add);
}

}  // namespace

/// The lengths of the wave vectors are stratified into rings of equal weight, and their directions over the half circle
/// in each ring: k and -k are one wave.
GaussianField::GaussianField(double length, statistics::RandomStream random) {
  BRASH_EXPECTS(length > 0.0, length);
  for (int ring = 0; ring < kRings; ++ring) {
    for (int angle = 0; angle < kAngles; ++angle) {
      const double share = (ring + 1.0 - random.uniform()) / kRings;  // in (0, 1]
      const double size = 2.0 / length * std::sqrt(-std::log(share));
      const double direction = kPi * (angle + random.uniform()) / kAngles;
      waves_.push_back({size * Vec2{std::cos(direction), std::sin(direction)}, 2.0 * kPi * random.uniform()});
    }
  }
}

double GaussianField::at(Vec2 place) const {
  double sum = 0.0;
  for (const Wave& wave : waves_) sum += std::cos(dot(wave.vector, place) + wave.phase);
  return std::sqrt(2.0 / static_cast<double>(waves_.size())) * sum;
}

bool varies(const model::IceSection& ice) {
  return ice.variation.thickness > 0.0 || ice.variation.flexural_strength > 0.0;
}

double Variation::LogNormal::at(Vec2 place) const {
  return std::exp(deviation * field.at(place) - 0.5 * deviation * deviation);
}

std::optional<Variation::LogNormal> Variation::field(const model::Case& resolved, double coefficient,
                                                     const char* purpose) {
  if (coefficient == 0.0) return std::nullopt;
  return LogNormal{GaussianField(model::correlation_length(resolved.ice),
                                 {resolved.random.seed, resolved.random.replicate, purpose}),
                   std::sqrt(std::log1p(coefficient * coefficient))};
}

Variation::Variation(const model::Case& resolved)
    : length_(model::correlation_length(resolved.ice)),
      thickness_(field(resolved, resolved.ice.variation.thickness, "thickness")),
      flexural_strength_(field(resolved, resolved.ice.variation.flexural_strength, "flexural_strength")) {
  if (resolved.field.edge_roughness == 0.0) return;
  const double length = model::edge_correlation_length(resolved);
  edge_ = RoughEdge{GaussianField(length, {resolved.random.seed, resolved.random.replicate, "first_edge"}),
                    resolved.field.edge_roughness, length / kCornersInLength};
}

// docs/theory/ice.md, (R3)
std::vector<Vec2> Variation::first_edge(double width) const {
  const int n = edge_ ? std::max(1, static_cast<int>(std::ceil(width / edge_->spacing))) : 1;
  std::vector<Vec2> corners;
  for (int i = 0; i <= n; ++i) {
    const double y = width * (0.5 - static_cast<double>(i) / n);
    corners.push_back({edge_ ? edge_->deviation * edge_->field.at({0.0, y}) : 0.0, y});
  }
  return corners;
}

failure::IceProperties Variation::at(const failure::IceProperties& ice, Vec2 place) const {
  failure::IceProperties here = ice;
  if (thickness_) here.thickness *= thickness_->at(place);
  if (flexural_strength_) here.flexural_strength *= flexural_strength_->at(place);
  return here;
}

failure::IceProperties Variation::mean(const failure::IceProperties& ice, const geometry::Polygon& piece) const {
  if (!*this) return ice;
  double area = 0.0, thickness = 0.0, strength = 0.0;
  const auto add = [&](Vec2 a, Vec2 b, Vec2 c) {
    const double third = cross(b - a, c - a) / 6.0;
    for (const Vec2 middle : {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)}) {
      const failure::IceProperties here = at(ice, middle);
      thickness += third * here.thickness;
      strength += third * here.flexural_strength;
      area += third;
    }
  };
  for (const geometry::Ring& part : geometry::convex_parts(piece)) {
    for (std::size_t i = 1; i + 1 < part.size(); ++i)
      divide(geometry::metres(part[0]), geometry::metres(part[i]), geometry::metres(part[i + 1]), length_,
             kMostDivisions, add);
  }
  failure::IceProperties mean = ice;
  if (thickness_) mean.thickness = thickness / area;
  if (flexural_strength_) mean.flexural_strength = strength / area;
  return mean;
}

}  // namespace brash::ice
