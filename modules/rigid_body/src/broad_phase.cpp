// SPDX-License-Identifier: GPL-3.0-or-later
#include "broad_phase.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>

namespace brash::rigid_body {
namespace {

constexpr int kMobile = 1;
constexpr int kFixed = 2;

bool within_reach(const PlacedPart& a, const PlacedPart& b, double reach) {
  return a.lower.x <= b.upper.x + reach && b.lower.x <= a.upper.x + reach && a.lower.y <= b.upper.y + reach &&
         b.lower.y <= a.upper.y + reach && a.lower.z <= b.upper.z + reach && b.lower.z <= a.upper.z + reach;
}

/// Each box is larger than its part by half the reach, so that the tree knows all neighbours.
btVector3 lower(const Part& part, double reach) {
  return to_bullet(part.now.lower) - btVector3(0.5 * reach, 0.5 * reach, 0.5 * reach);
}
btVector3 upper(const Part& part, double reach) {
  return to_bullet(part.now.upper) + btVector3(0.5 * reach, 0.5 * reach, 0.5 * reach);
}

}  // namespace

/// Bullet's tree leaves to its user what it made for each box. Taking the boxes out one by one would look through all
/// pairs for each.
BroadPhase::~BroadPhase() {
  for (btDbvtProxy* proxy : tree_.m_stageRoots)
    while (proxy != nullptr) {
      btDbvtProxy* const next = proxy->links[1];
      btAlignedFree(proxy);
      proxy = next;
    }
}

void BroadPhase::add(Part& part) {
  known_ = false;
  const bool mobile = part.body->is_free();
  part.proxy = tree_.createProxy(lower(part, reach), upper(part, reach), CONVEX_HULL_SHAPE_PROXYTYPE, &part,
                                 mobile ? kMobile : kFixed, mobile ? kMobile | kFixed : kMobile, nullptr);
}

void BroadPhase::remove(Part& part) {
  known_ = false;
  tree_.destroyProxy(part.proxy, nullptr);
  part.proxy = nullptr;
}

void BroadPhase::move(Part& part) {
  known_ = false;
  tree_.setAabb(part.proxy, lower(part, reach), upper(part, reach), nullptr);
}

const std::vector<NearPair>& BroadPhase::near_pairs() {
  if (known_) return near_;
  known_ = true;
  near_.clear();
  const btBroadphasePairArray& found = tree_.getOverlappingPairCache()->getOverlappingPairArray();
  for (int i = 0; i < found.size(); ++i) {
    auto* const a = static_cast<Part*>(found[i].m_pProxy0->m_clientObject);
    auto* const b = static_cast<Part*>(found[i].m_pProxy1->m_clientObject);
    if (a->body != b->body && within_reach(a->now, b->now, reach))
      near_.push_back({a, b, within_reach(a->now, b->now, 0.0)});
  }
  return near_;
}

const std::vector<PartPair>& BroadPhase::pairs() {
  tree_.calculateOverlappingPairs(nullptr);  // forgets some of the pairs that have parted
  const auto place = [](const Part& part) {
    const auto number = static_cast<std::uint32_t>(part.number);
    return std::pair(!part.body->is_floe(), static_cast<std::uint64_t>(part.body->rank) << 32 | number);
  };
  ordered_.clear();
  for (const auto& [a, b, overlap] : near_pairs()) {
    if (!overlap) continue;
    const auto place_a = place(*a), place_b = place(*b);
    if (place_a < place_b)
      ordered_.push_back({place_a.second, place_b.second, {a, b}});
    else
      ordered_.push_back({place_b.second, place_a.second, {b, a}});
  }
  std::sort(ordered_.begin(), ordered_.end(), [](const Ordered& p, const Ordered& q) {
    return std::tie(p.first, p.second) < std::tie(q.first, q.second);
  });
  pairs_.clear();
  for (const Ordered& p : ordered_) pairs_.push_back(p.pair);
  return pairs_;
}

}  // namespace brash::rigid_body
