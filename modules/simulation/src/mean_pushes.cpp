// SPDX-License-Identifier: GPL-3.0-or-later
#include "mean_pushes.hpp"

#include <algorithm>

namespace brash::simulation {

void MeanPushes::average(const rigid_body::World& world, double share, double least, const Tell& tell) {
  const auto tell_settled = [&](const Pair& pair, Vec3 change) {
    if (world.is_settled(pair.first)) tell(pair.first, change);
    if (world.is_settled(pair.second)) tell(pair.second, -change);
  };
  for (auto& [pair, mean] : pairs_) {
    if (world.is_settled(pair.first) && world.is_settled(pair.second)) continue;
    tell_settled(pair, -share * mean);
    mean = (1.0 - share) * mean;
  }
  for (const rigid_body::ContactLoad& contact : world.contacts()) {
    if (contact.other_kind != rigid_body::BodyKind::kFloe || !rigid_body::bears(contact)) continue;
    const bool in_order = contact.body < contact.other;
    const Pair pair = std::minmax(contact.body, contact.other);
    const Vec3 change = (in_order ? share : -share) * (contact.normal_force * contact.normal + contact.friction_force);
    pairs_[pair] += change;
    tell_settled(pair, change);
  }
  std::erase_if(pairs_, [&](const auto& entry) {
    const auto& [pair, mean] = entry;
    if (norm(mean) >= least) return false;
    tell_settled(pair, -mean);
    return true;
  });
}

void MeanPushes::forget(BodyId floe, const Tell& tell) {
  std::erase_if(pairs_, [&](const auto& entry) {
    const auto& [pair, mean] = entry;
    if (pair.first == floe) tell(pair.second, mean);
    if (pair.second == floe) tell(pair.first, -mean);
    return pair.first == floe || pair.second == floe;
  });
}

}  // namespace brash::simulation
