// SPDX-License-Identifier: GPL-3.0-or-later
#include "mean_pushes.hpp"

#include <algorithm>

namespace brash::simulation {

void MeanPushes::average(const rigid_body::World& world, double share, double least) {
  for (auto& [pair, force] : pairs_)
    if (!world.is_settled(pair.first) || !world.is_settled(pair.second)) force = (1.0 - share) * force;
  for (const rigid_body::ContactLoad& contact : world.contacts()) {
    if (contact.other_kind != rigid_body::BodyKind::kFloe || !rigid_body::bears(contact)) continue;
    const Vec3 force = contact.normal_force * contact.normal + contact.friction_force;
    const bool in_order = contact.body < contact.other;
    pairs_[std::minmax(contact.body, contact.other)] += (in_order ? share : -share) * force;
  }
  std::erase_if(pairs_, [&](const auto& entry) { return norm(entry.second) < least; });
}

std::map<BodyId, Vec3> MeanPushes::on_floes() const {
  std::map<BodyId, Vec3> sums;
  for (const auto& [pair, force] : pairs_) {
    sums[pair.first] += force;
    sums[pair.second] += -1.0 * force;
  }
  return sums;
}

void MeanPushes::forget(BodyId floe) {
  std::erase_if(pairs_, [&](const auto& entry) { return entry.first.first == floe || entry.first.second == floe; });
}

}  // namespace brash::simulation
