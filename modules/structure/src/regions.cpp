// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/regions.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"

namespace brash::structure {
namespace {

constexpr double kBowAngle = 10.0 * kPi / 180.0;    // of the waterline with the course, at the bow's end
constexpr double kBottomSlope = 7.0 * kPi / 180.0;  // of the bottom from the horizontal, at most
constexpr double kShoulders = 0.04;                 // lengths of the waterline that they reach abaft its full breadth
constexpr double kFull = 0.999;                     // of the largest breadth: the waterline is parallel there

/// An edge of the waterline.
struct Chord {
  Vec2 from, to;
  double forward() const { return std::max(from.x, to.x); }
  double after() const { return std::min(from.x, to.x); }
  /// Its angle with the course, positive where it faces ahead [rad].
  double angle() const { return std::asin(std::clamp((to.y - from.y) / norm(to - from), -1.0, 1.0)); }
};

std::vector<Chord> chords_of(const Hull& hull) {
  std::vector<Chord> chords;
  for (const Outline& outline : hull.footprint(Pose{}, 0.0, 0.0).leading)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Chord chord{outline[i], outline[(i + 1) % outline.size()]};
      if (norm(chord.to - chord.from) > 0.0) chords.push_back(chord);
    }
  return chords;
}

}  // namespace

HullRegions::HullRegions(const Hull& hull) {
  const std::vector<Chord> chords = chords_of(hull);
  BRASH_EXPECTS(!chords.empty());
  double starboard = HUGE_VAL, port = -HUGE_VAL, stem = -HUGE_VAL, stern = HUGE_VAL;
  for (const Chord& chord : chords) {
    starboard = std::min(starboard, chord.from.y);
    port = std::max(port, chord.from.y);
    stem = std::max(stem, chord.from.x);
    stern = std::min(stern, chord.from.x);
  }
  const double middle = 0.5 * (port + starboard), full = kFull * 0.5 * (port - starboard);
  double parallel_from = -HUGE_VAL, parallel_to = HUGE_VAL;
  for (const Chord& chord : chords) {
    if (std::abs(chord.from.y - middle) < full) continue;
    parallel_from = std::max(parallel_from, chord.from.x);
    parallel_to = std::min(parallel_to, chord.from.x);
  }
  bow_end_ = stem;
  for (const Chord& chord : chords)
    if (chord.angle() >= kBowAngle && chord.forward() > parallel_from) bow_end_ = std::min(bow_end_, chord.after());
  bow_end_ = std::max(bow_end_, parallel_from);
  stern_start_ = parallel_to;
  shoulders_end_ = std::max(parallel_from - kShoulders * (stem - stern), stern_start_);
}

model::HullRegion HullRegions::at(Vec3 point, Vec3 outward) const {
  if (-outward.z >= std::cos(kBottomSlope)) return model::HullRegion::kBottom;
  if (point.x >= bow_end_) return model::HullRegion::kBow;
  if (point.x >= shoulders_end_) return model::HullRegion::kShoulders;
  return point.x >= stern_start_ ? model::HullRegion::kSides : model::HullRegion::kStern;
}

LegRegions::LegRegions(const HullCopies& legs) : places_(legs.places) {
  BRASH_EXPECTS(!places_.empty() && places_.size() <= model::kMostLegs, places_.size());
  const auto [least, most] = legs.hull->bounds();
  least_ = plan(least);
  most_ = plan(most);
}

std::size_t LegRegions::at(Vec3 point) const {
  const auto distance = [&](Vec2 place) {
    const Vec2 p = plan(point) - place;
    return norm(Vec2{std::max({least_.x - p.x, p.x - most_.x, 0.0}), std::max({least_.y - p.y, p.y - most_.y, 0.0})});
  };
  return static_cast<std::size_t>(std::ranges::min_element(places_, {}, distance) - places_.begin());
}

std::size_t Regions::at(Vec3 point, Vec3 outward) const {
  if (const auto* const legs = std::get_if<LegRegions>(&regions_)) return model::kHullRegions + legs->at(point);
  return static_cast<std::size_t>(std::get<HullRegions>(regions_).at(point, outward));
}

std::optional<Regions> regions_of(const model::StructureSection& structure, const Hull& hull) {
  if (!structure.legs.empty()) return Regions(LegRegions(hull.copies()));
  const bool is_long =
      std::holds_alternative<model::Ship>(structure.shape) || std::holds_alternative<model::Mesh>(structure.shape);
  if (!is_long || hull.displaced(Pose{}).waterplane.area <= 0.0) return std::nullopt;
  return Regions(HullRegions(hull));
}

}  // namespace brash::structure
