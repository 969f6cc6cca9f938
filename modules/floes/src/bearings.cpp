// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/floes/bearings.hpp"

#include <algorithm>

#include "brash/floes/plan.hpp"

namespace brash::floes {
namespace {

/// A bearing in a checkpoint, its floe by Floe::id.
struct SavedBearing {
  std::int64_t floe = 0;
  std::int64_t level_ice = 0;
  Bearing bearing;

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("floe", "1", "floe_id of the floe", self.floe);
    visit("level_ice", "1", "number of the level ice that it presses on", self.level_ice);
    Bearing::visit(self.bearing, visit);
  }
};

}  // namespace

void Bearings::average(const rigid_body::World& world, const FloePopulation& floes,
                       const std::vector<const rigid_body::ContactLoad*>& contacts,
                       const std::function<std::optional<int>(BodyId)>& level_ice_of, double dt,
                       const std::function<rigid_body::ContactLoad(int, const rigid_body::ContactLoad&)>& in_sheet) {
  std::map<Pair, Bearing> now;
  for (const rigid_body::ContactLoad* const contact : contacts) {
    if (contact->other_kind != rigid_body::BodyKind::kSheet) continue;
    const std::optional<int> level_ice = level_ice_of(contact->other);
    if (!level_ice) continue;
    const Pair pair{contact->body, *level_ice};
    add_contact(now[pair], in_sheet ? in_sheet(pair.second, *contact) : *contact);
    mean_.try_emplace(pair);
  }
  for (auto entry = mean_.begin(); entry != mean_.end();) {
    const auto here = entry++;
    auto& [pair, mean] = *here;
    const bool awake = !world.is_settled(pair.first);
    if (awake) approach(mean, now[pair], averaging_share(floes.at(pair.first), dt));
    if (!awake || mean == Bearing{}) mean_.erase(here);
  }
}

void Bearings::forget(BodyId floe) {
  std::erase_if(mean_, [&](const auto& entry) { return entry.first.first == floe; });
}

void Bearings::forget_within(int level_ice, Vec2 at, double radius) {
  std::erase_if(mean_, [&](const auto& entry) {
    const auto& [pair, mean] = entry;
    return pair.second == level_ice && mean.weight > 0.0 && norm(plan(mean.first / mean.weight) - at) < radius;
  });
}

void Bearings::forget_within(int level_ice, const geometry::Extent& box) {
  std::erase_if(mean_, [&](const auto& entry) {
    const auto& [pair, mean] = entry;
    return pair.second == level_ice && mean.weight > 0.0 && is_on(box, plan(mean.first / mean.weight));
  });
}

void Bearings::save(const FloePopulation& floes, model::Checkpoint& checkpoint) const {
  model::Table table{"bearing", {}};
  for (const auto& [pair, mean] : mean_) {
    const SavedBearing saved{floes.at(pair.first).id, pair.second, mean};
    model::SavedRow row(table);
    SavedBearing::visit(saved, row);
  }
  checkpoint.tables.push_back(std::move(table));
}

void Bearings::restore(const FloePopulation& floes, const model::Checkpoint& checkpoint) {
  const std::map<std::int64_t, BodyId> bodies = floes.bodies_by_id();
  const model::Table& table = checkpoint.table("bearing");
  for (std::size_t i = 0; i < table.n_rows(); ++i) {
    SavedBearing saved;
    model::RestoredRow row(table, i);
    SavedBearing::visit(saved, row);
    mean_[{bodies.at(saved.floe), static_cast<int>(saved.level_ice)}] = saved.bearing;
  }
}

}  // namespace brash::floes
