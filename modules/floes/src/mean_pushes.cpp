// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/floes/mean_pushes.hpp"

#include <algorithm>

namespace brash::floes {
namespace {

bool is_of(const MeanPushes::Pair& pair, BodyId floe) { return pair.first == floe || pair.second == floe; }

}  // namespace

void MeanPushes::average(const rigid_body::World& world, double share, double least, const Tell& tell) {
  const auto tell_asleep = [&](const Pair& pair, Vec3 change) {
    if (world.is_settled(pair.first)) tell(pair.first, change);
    if (world.is_settled(pair.second)) tell(pair.second, -change);
  };
  for (auto entry = moving_.begin(); entry != moving_.end();) {
    const auto here = entry++;
    auto& [pair, mean] = *here;
    if (world.is_settled(pair.first) && world.is_settled(pair.second)) {
      resting_.insert(moving_.extract(here));
      continue;
    }
    tell_asleep(pair, -share * mean);
    mean = (1.0 - share) * mean;
  }
  for (const rigid_body::ContactLoad& contact : world.contacts()) {
    if (contact.other_kind != rigid_body::BodyKind::kFloe) continue;
    const bool in_order = contact.body < contact.other;
    const Pair pair = std::minmax(contact.body, contact.other);
    const Vec3 change = (in_order ? share : -share) * (contact.normal_force * contact.normal + contact.friction_force);
    moving_[pair] += change;
    tell_asleep(pair, change);
  }
  std::erase_if(moving_, [&](const auto& entry) {
    const auto& [pair, mean] = entry;
    if (norm(mean) >= least) return false;
    tell_asleep(pair, -mean);
    return true;
  });
}

void MeanPushes::wake(BodyId floe) {
  for (auto entry = resting_.begin(); entry != resting_.end();) {
    const auto here = entry++;
    if (is_of(here->first, floe)) moving_.insert(resting_.extract(here));
  }
}

void MeanPushes::forget(BodyId floe, const Tell& tell) {
  wake(floe);
  std::erase_if(moving_, [&](const auto& entry) {
    const auto& [pair, mean] = entry;
    if (pair.first == floe) tell(pair.second, mean);
    if (pair.second == floe) tell(pair.first, -mean);
    return is_of(pair, floe);
  });
}

std::map<MeanPushes::Pair, Vec3> MeanPushes::pairs() const {
  std::map<Pair, Vec3> all = moving_;
  all.insert(resting_.begin(), resting_.end());
  return all;
}

}  // namespace brash::floes
