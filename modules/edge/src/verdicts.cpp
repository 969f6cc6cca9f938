// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/edge/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brash/floes/plan.hpp"

namespace brash::edge {
namespace {

/// A verdict is kept while the overload stays below 1, times kLeastMargin, and kMoreMargin more at the longest age.
constexpr double kLeastMargin = 1.1, kMoreMargin = 1.0;
/// A contact is solved where the loads of either kind changed by more than this share of all, the vertical ones by more
/// than this share of their net, or its length.
constexpr double kLoadJump = 1.0, kLengthJump = 0.25;
/// Whatever the load, the stress of an edge that has just begun to move grows with a power of its age. So a verdict is
/// kept no longer than this share of the age.
constexpr double kShareOfEdge = 0.5;
/// Rounding of times.
constexpr double kRoundingOfTimes = 1e-6;
/// One contact in so many is a control.
constexpr int kControls = 17;

/// By the time of a contact's first solution and by its floe, so that a resumed run takes the same ones.
bool is_control(double now, const EdgeContact& contact) {
  return (std::llround(1e3 * now) + contact.floe + 1) % kControls == 0;
}

}  // namespace

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

std::optional<Verdicts::Growth> Verdicts::most_overloaded(const std::vector<EdgeContact>& of_structure) const {
  std::optional<Growth> most;
  for (const EdgeContact& contact : of_structure) {
    const Kept* const kept = find(contact);
    if (kept == nullptr || kept->is_bound || kept->overload >= 1.0) continue;
    const double now = kept->overload * kept->growth({contact.pressing.by_structure, kept->pressing.by_floes});
    if (!most || now > most->now) most = {kept->overload, now};
  }
  return most;
}

bool Verdicts::may_keep(const Kept& kept, const EdgeContact& contact, double now) const {
  const double longest =
      std::min(lateness_, kShareOfEdge * contact.edge_age.value_or(std::numeric_limits<double>::infinity()));
  const double age = (now - kept.time) / longest;
  if (kept.is_stale || age > 1.0 - kRoundingOfTimes) return false;
  const double jump = kLoadJump * kept.pressing.sum();
  const Pressing& pressing = contact.pressing;
  const double lifted = (pressing.up - pressing.down) - (kept.pressing.up - kept.pressing.down);
  if (std::abs(pressing.by_structure - kept.pressing.by_structure) > jump ||
      std::abs(pressing.by_floes - kept.pressing.by_floes) > jump ||
      std::abs(lifted) > kLoadJump * kept.pressing.net() ||
      std::abs(contact.touched.length - kept.touched.length) > kLengthJump * kept.touched.length)
    return false;
  // A load that falls may have held another one up.
  const double most = std::max({1.0, kept.growth(pressing), pressing.net() / kept.pressing.net()});
  return kept.overload * most * (kLeastMargin + kMoreMargin * age) < 1.0;
}

void Verdicts::recall(double now, std::vector<EdgeContact>& contacts) const {
  if (lateness_ == 0.0) return;
  for (EdgeContact& contact : contacts) {
    const Kept* const kept = find(contact);
    if (kept == nullptr || !may_keep(*kept, contact, now)) continue;
    contact.kept = kept->is_control ? EdgeContact::Verdict::kControl : EdgeContact::Verdict::kKept;
    contact.assessment = {.sigma_max = kept->stress * kept->growth(contact.pressing),
                          .breaking_length = kept->breaking_length};
  }
}

model::KeptCounts Verdicts::keep(double now, const std::vector<EdgeContact>& contacts) {
  model::KeptCounts counts;
  std::vector<Kept> all;
  for (const EdgeContact& contact : contacts) {
    const Kept* const before = find(contact);
    if (contact.kept != EdgeContact::Verdict::kSolved) {
      ++counts.kept;
      counts.controls += contact.kept == EdgeContact::Verdict::kControl ? 1 : 0;
      all.push_back(*before);
      all.back().touched.tip = contact.touched.tip;
      if (contact.control.fails && before->fails_from < 0.0) all.back().fails_from = now;
      continue;
    }
    if (before != nullptr && before->fails_from >= 0.0) {
      ++counts.late;
      counts.latest = std::max(counts.latest, now - before->fails_from);
    }
    if (contact.assessment.overload == 0.0) continue;
    all.push_back({.level_ice = contact.level_ice,
                   .floe = contact.floe,
                   .touched = contact.touched,
                   .time = now,
                   .overload = contact.assessment.overload,
                   .stress = contact.assessment.sigma_max,
                   .breaking_length = contact.assessment.breaking_length,
                   .pressing = contact.pressing,
                   .is_bound = contact.assessment.solves.n_solved() == 0,
                   .is_control = before != nullptr ? before->is_control : is_control(now, contact)});
  }
  kept_ = std::move(all);
  return counts;
}

void Verdicts::forget_within(int level_ice, Vec2 at, double radius, double around) {
  std::erase_if(kept_,
                [&](const Kept& kept) { return kept.level_ice == level_ice && norm(kept.touched.tip - at) < radius; });
  for (Kept& kept : kept_)
    if (kept.level_ice == level_ice && norm(kept.touched.tip - at) < around) kept.is_stale = true;
}

void Verdicts::forget_within(int level_ice, const geometry::Extent& box) {
  std::erase_if(kept_,
                [&](const Kept& kept) { return kept.level_ice == level_ice && floes::is_on(box, kept.touched.tip); });
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

}  // namespace brash::edge
