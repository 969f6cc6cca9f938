// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/floes/floe_bending.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace brash::floes {
namespace {

/// Means below this stress are forgotten [Pa]. It is small beside the strength of any ice, and saves the decay of loads
/// long gone.
constexpr double kNoStress = 1.0;
constexpr std::size_t kBentFloes = 16;  ///< that a worker takes at a time

/// The load in a section in a checkpoint.
struct SavedLoad {
  std::int64_t floe = 0;
  std::int64_t section = 0;
  SectionLoad load;

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("floe", "1", "floe_id of the floe", self.floe);
    visit("section", "1", "number of the section among the floe's", self.section);
    visit("moment", "N m", "mean bending moment", self.load.moment);
    visit("thrust", "N", "mean thrust, tension positive", self.load.thrust);
  }
};

/// The forces of the last step on each awake floe.
std::map<BodyId, std::vector<PointForce>> forces_on_floes(const rigid_body::World& world,
                                                          const std::vector<const rigid_body::ContactLoad*>& contacts) {
  std::map<BodyId, std::vector<PointForce>> forces;
  const auto add = [&](BodyId body, Vec3 point, Vec3 force) {
    if (world.is_settled(body)) return;
    const Pose pose = world.start_pose(body);
    forces[body].push_back({to_body(pose, point), rotate(conjugate(pose.rotation), force)});
  };
  for (const rigid_body::ContactLoad* const contact : contacts) {
    const Vec3 force = contact->normal_force * contact->normal + contact->friction_force;
    add(contact->body, contact->point, force);
    if (contact->other_kind == rigid_body::BodyKind::kFloe) add(contact->other, contact->point, -force);
  }
  return forces;
}

}  // namespace

/// Moves the means by `share` of their distance to the loads under `forces`.
void FloeBending::Bent::approach(std::span<const PointForce> forces, double share) {
  for (SectionLoad& load : mean) {
    load.moment -= share * load.moment;
    load.thrust -= share * load.thrust;
  }
  if (forces.empty()) return;
  const std::vector<SectionLoad> now = sections.loads(forces);
  for (std::size_t i = 0; i < mean.size(); ++i) {
    mean[i].moment += share * now[i].moment;
    mean[i].thrust += share * now[i].thrust;
  }
}

/// With the means of all sections, however the thrust acts [Pa].
double FloeBending::Bent::largest_tension() const {
  double largest = 0.0;
  for (std::size_t i = 0; i < mean.size(); ++i)
    largest = std::max(largest, sections.tension(i, {mean[i].moment, std::abs(mean[i].thrust)}));
  return largest;
}

void FloeBending::average(const rigid_body::World& world, const FloePopulation& floes,
                          const std::vector<const rigid_body::ContactLoad*>& contacts, double dt) {
  const auto forces = forces_on_floes(world, contacts);
  for (const auto& [body, of_floe] : forces) {
    if (floes_.contains(body)) continue;
    Sections sections(floes.at(body).prism);
    if (const std::size_t n = sections.all().size(); n > 0)
      floes_.emplace(body, Bent{std::move(sections), std::vector<SectionLoad>(n)});
  }
  std::vector<std::pair<const BodyId, Bent>*> all;
  for (auto& entry : floes_) all.push_back(&entry);
  std::vector<double> largest(all.size());  // tension [Pa]
  world.workers().each(all.size(), kBentFloes, [&](std::size_t i) {
    auto& [body, bent] = *all[i];
    if (world.is_settled(body)) return;
    const auto now = forces.find(body);
    bent.approach(now == forces.end() ? std::span<const PointForce>() : now->second,
                  averaging_share(floes.at(body), dt));
    largest[i] = bent.largest_tension();
  });
  for (std::size_t i = 0; i < all.size(); ++i)
    if (largest[i] < kNoStress) floes_.erase(all[i]->first);
}

std::vector<Fracture> FloeBending::fractures(const FloePopulation& floes) const {
  std::vector<Fracture> result;
  for (const auto& [body, bent] : floes_) {
    std::size_t at = 0;
    double most = 0.0;
    for (std::size_t i = 0; i < bent.mean.size(); ++i) {
      const double tension = bent.sections.tension(i, bent.mean[i]);
      if (tension <= most) continue;
      at = i;
      most = tension;
    }
    if (most > floes.at(body).plate.ice().flexural_strength) result.push_back({body, bent.sections.all()[at], most});
  }
  return result;
}

void FloeBending::save(const FloePopulation& floes, model::Checkpoint& checkpoint) const {
  model::Table table{"section_load", {}};
  for (const auto& [body, bent] : floes_) {
    for (std::size_t i = 0; i < bent.mean.size(); ++i) {
      const SavedLoad saved{floes.at(body).id, static_cast<std::int64_t>(i), bent.mean[i]};
      model::SavedRow row(table);
      SavedLoad::visit(saved, row);
    }
  }
  checkpoint.tables.push_back(std::move(table));
}

void FloeBending::restore(const FloePopulation& floes, const model::Checkpoint& checkpoint) {
  const std::map<std::int64_t, BodyId> bodies = floes.bodies_by_id();
  const model::Table& table = checkpoint.table("section_load");
  for (std::size_t i = 0; i < table.n_rows(); ++i) {
    SavedLoad saved;
    model::RestoredRow row(table, i);
    SavedLoad::visit(saved, row);
    const BodyId body = bodies.at(saved.floe);
    if (!floes_.contains(body)) {
      Sections sections(floes.at(body).prism);
      std::vector<SectionLoad> none(sections.all().size());
      floes_.emplace(body, Bent{std::move(sections), std::move(none)});
    }
    floes_.at(body).mean.at(static_cast<std::size_t>(saved.section)) = saved.load;
  }
}

}  // namespace brash::floes
