// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdicts.hpp"

#include <algorithm>

#include "plan.hpp"

namespace brash::simulation {

/// Of a floe by its number; of the structure the nearest, if the middle of one chord lies beside the other chord.
const Verdicts::Kept* Verdicts::find(const EdgeContact& contact) const {
  const Kept* nearest = nullptr;
  double least = 0.0;
  for (const Kept& kept : kept_) {
    if (kept.level_ice != contact.level_ice || kept.floe != contact.floe) continue;
    const double distance = norm(kept.touched.tip - contact.touched.tip);
    const double reach = 0.5 * std::max(kept.touched.length, contact.touched.length);
    if (distance >= reach || (nearest != nullptr && distance >= least)) continue;
    nearest = &kept;
    least = distance;
  }
  return nearest;
}

std::optional<Verdicts::Growth> Verdicts::most_stressed(const std::vector<EdgeContact>& of_structure) const {
  std::optional<Growth> most;
  for (const EdgeContact& contact : of_structure) {
    const Kept* const kept = find(contact);
    if (kept == nullptr || kept->ratio >= 1.0) continue;
    const double pressing = contact.pressing.by_structure + kept->pressing.by_floes;
    const double now = kept->ratio * pressing / kept->pressing.sum();
    if (!most || now > most->now) most = {kept->ratio, now};
  }
  return most;
}

void Verdicts::keep(const std::vector<EdgeContact>& contacts) {
  kept_.clear();
  for (const EdgeContact& contact : contacts)
    if (contact.assessment.solves.n_solved() > 0)
      kept_.push_back({.level_ice = contact.level_ice,
                       .floe = contact.floe,
                       .touched = contact.touched,
                       .ratio = contact.assessment.sigma_max / contact.ice.flexural_strength,
                       .pressing = contact.pressing});
}

void Verdicts::forget_within(int level_ice, Vec2 at, double radius) {
  std::erase_if(kept_,
                [&](const Kept& kept) { return kept.level_ice == level_ice && norm(kept.touched.tip - at) < radius; });
}

void Verdicts::forget_within(int level_ice, const geometry::Extent& box) {
  std::erase_if(kept_, [&](const Kept& kept) { return kept.level_ice == level_ice && is_on(box, kept.touched.tip); });
}

void Verdicts::save(model::Checkpoint& checkpoint) const {
  model::Table table{"verdict", {}};
  for (const Kept& kept : kept_) {
    model::SavedRow row(table);
    Kept::visit(kept, row);
  }
  checkpoint.tables.push_back(std::move(table));
}

void Verdicts::restore(const model::Checkpoint& checkpoint) {
  const model::Table& table = checkpoint.table("verdict");
  kept_.assign(table.n_rows(), {});
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    model::RestoredRow row(table, i);
    Kept::visit(kept_[i], row);
  }
}

}  // namespace brash::simulation
