// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/ice/crack_pattern.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "brash/core/contract.hpp"
#include "cut_off.hpp"

namespace brash::ice {
namespace {

Vec2 tip_of(const geometry::ContactRegion& contact) { return 0.5 * (contact.chord_from + contact.chord_to); }

/// Radial cracks meet at the tip, inside crushed ice. One more takes them on to the free edge.
void add_crack_to_edge(const geometry::ContactRegion& contact, std::vector<geometry::Crack>& cracks) {
  const geometry::Crack to_edge{geometry::snap(tip_of(contact)), geometry::snap(contact.midpoint)};
  if (to_edge.from != to_edge.to) cracks.push_back(to_edge);
}

/// Chords of a full breaking circle. Few keep floes convex; with 16 the disc is 2.6 % too small.
constexpr int kArcSides = 16;

class Circumferential : public CrackPattern {
 public:
  explicit Circumferential(const model::FailureSection& section) : wedges_(section.wedges) {}

  CrackPlan plan(const Plate& plate, const geometry::ContactRegion& contact, const failure::Assessment& assessment,
                 statistics::RandomStream& random) const override {
    return disc(plate, contact, assessment.breaking_length, random.uniform_int(wedges_[0], wedges_[1]));
  }

 protected:
  /// The breaking length starts at the tip.
  CrackPlan disc(const Plate& plate, const geometry::ContactRegion& contact, double radius, int n_wedges) const {
    const Vec2 tip = tip_of(contact);
    CrackPlan plan{geometry::circumferential(plate.sheet(), tip, radius, n_wedges, kArcSides), tip, radius, n_wedges};
    add_crack_to_edge(contact, plan.cracked.cracks);
    return plan;
  }

  std::array<int, 2> wedges_;
};

class AlongStress final : public Circumferential {
 public:
  using Circumferential::Circumferential;

  CrackPlan plan(const Plate& plate, const geometry::ContactRegion& contact, const failure::Assessment& assessment,
                 statistics::RandomStream& random) const override {
    const int n_wedges = random.uniform_int(wedges_[0], wedges_[1]);
    const Vec2 tip = tip_of(contact);
    const std::optional<CutOff> cut = cut_off(plate.sheet(), tip, assessment.crack);
    // Plate theory says nothing nearer to a load than the ice is thick.
    if (!cut) return disc(plate, contact, std::max(assessment.breaking_length, plate.ice().thickness), n_wedges);
    CrackPlan plan{{geometry::ring(cut->region), {}}, tip, 0.0, n_wedges, true};
    for (const Vec2 point : cut->region) plan.reach = std::max(plan.reach, norm(point - tip));
    for (int i = 1; i < n_wedges; ++i)
      plan.cracked.cracks.push_back(
          {geometry::snap(tip), geometry::snap(along(cut->crack, static_cast<double>(i) / n_wedges))});
    add_crack_to_edge(contact, plan.cracked.cracks);
    return plan;
  }
};

}  // namespace

std::unique_ptr<CrackPattern> make_crack_pattern(const model::FailureSection& section) {
  switch (section.pattern) {
    case model::CrackPattern::kDisc:
      return std::make_unique<Circumferential>(section);
    case model::CrackPattern::kStress:
      return std::make_unique<AlongStress>(section);
  }
  BRASH_EXPECTS(false, static_cast<int>(section.pattern));
  return nullptr;
}

}  // namespace brash::ice
