// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/ice/crack_pattern.hpp"

#include <array>

#include "brash/core/contract.hpp"

namespace brash::ice {
namespace {

class Circumferential final : public CrackPattern {
 public:
  explicit Circumferential(const model::FailureSection& section)
      : wedges_(section.wedges), arc_sides_(section.arc_sides) {}

  CrackPlan plan(const Plate& plate, const geometry::ContactRegion& contact, const failure::Assessment& assessment,
                 statistics::RandomStream& random) const override {
    const double radius = assessment.breaking_length;
    const int n_wedges = random.uniform_int(wedges_[0], wedges_[1]);
    const Vec2 tip = 0.5 * (contact.chord_from + contact.chord_to);  // the breaking length starts here
    geometry::CrackedRegion cracked = geometry::circumferential(plate.sheet(), tip, radius, n_wedges, arc_sides_);
    // The cracks meet at the tip, inside crushed ice. One more takes them on to the free edge.
    const geometry::Crack to_edge{geometry::snap(tip), geometry::snap(contact.midpoint)};
    if (to_edge.from != to_edge.to) cracked.cracks.push_back(to_edge);
    return {std::move(cracked), tip, radius, n_wedges};
  }

 private:
  std::array<int, 2> wedges_;
  int arc_sides_;
};

}  // namespace

std::unique_ptr<CrackPattern> make_crack_pattern(const model::FailureSection& section) {
  switch (section.pattern) {
    case model::CrackPattern::kDisc:
      return std::make_unique<Circumferential>(section);
  }
  BRASH_EXPECTS(false, static_cast<int>(section.pattern));
  return nullptr;
}

}  // namespace brash::ice
