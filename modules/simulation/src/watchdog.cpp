// SPDX-License-Identifier: GPL-3.0-or-later
#include "watchdog.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <variant>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "laid_floes.hpp"

namespace brash::simulation {
namespace {

/// Share of the floes' kinetic energy that contacts and still water may seem to give in a step.
constexpr double kRounding = 1e-6;
/// Relative velocity that sequential impulses leave where they end early [m/s]: they end when none changes by 1e-8 m/s
/// more, and come that slowly to their end in a pack at rest.
constexpr double kLeft = 1e-6;

/// The account of a floe in a checkpoint.
struct SavedAccount {
  std::int64_t floe = 0;
  double explained = 0.0;
  double travel = 0.0;

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("floe", "1", "floe_id of the floe", self.floe);
    visit("explained", "J", "energy that its work explains", self.explained);
    visit("travel", "m", "longest travel in a step", self.travel);
  }
};

/// Whether the structure goes along x all the time: it pushes nothing astern.
bool goes_straight(const model::Case& c) {
  const auto* const towed = std::get_if<model::Towed>(&c.structure.motion);
  return towed != nullptr && towed->path.empty();
}

}  // namespace

Watchdog::Watchdog(const model::Case& resolved, const std::pair<Vec3, Vec3>& hull)
    : case_(&resolved), hull_(hull), most_lift_(std::max(1.0, resolved.water.density / resolved.ice.density - 1.0)) {}

/// A floe's own speeds come from the structure, its rise in the water and the current.
void Watchdog::see_structure(const Twist& twist) {
  // The box around the hull and its origin, about which it turns: legs may all lie to one side.
  const auto [least, most] = hull_;
  const Vec3 size{std::max(most.x, 0.0) - std::min(least.x, 0.0), std::max(most.y, 0.0) - std::min(least.y, 0.0),
                  std::max(most.z, 0.0) - std::min(least.z, 0.0)};
  const double speed = norm(twist.linear) + norm(twist.angular) * norm(size);
  const double rise = std::sqrt(kGravity * case_->ice.thickness);
  travel_ = std::max(travel_, case_->time.step * (speed + rise + norm(current_past_ice(*case_))));
}

void Watchdog::begin(const Watched& start, double births) {
  see_structure(start.structure);
  booked_error_ = start.row.energy_error + births;
  for (const auto& [body, floe] : start.floes.floes())
    accounts_[body].explained = start.floes.energy(start.world, body, floe);
}

void Watchdog::look(const Watched& now) {
  see_structure(now.structure);
  open_accounts(now.floes);
  explain_gyration(now.world);
  const std::vector<BodyId>& moving = now.world.moving();
  now.world.workers().each(moving.size(), floes::kCheapFloes, [&](std::size_t i) {
    const floes::Floe& floe = now.floes.at(moving[i]);
    look_at_place(floe, now.world.pose(moving[i]).position, now.row.time);
    look_at_energy(now, moving[i], floe);
  });
  look_at_losses(now);
  look_at_balance(now);
}

/// One account for each floe that is there, empty for a new floe.
void Watchdog::open_accounts(const floes::FloePopulation& floes) {
  if (next_id_ != floes.next_id()) {
    for (const auto& [body, floe] : floes.floes())
      if (floe.id >= next_id_) accounts_.try_emplace(body);
    next_id_ = floes.next_id();
  }
}

void Watchdog::add_piece(double energy, BodyId body, BodyId parent) {
  accounts_[body] = {.explained = energy, .travel = accounts_[parent].travel};
}

void Watchdog::remove(BodyId body, double weight) {
  const auto account = accounts_.extract(body);
  allowed_to_gone_ += allowance(weight, account.empty() ? 0.0 : account.mapped().travel);
}

void Watchdog::save(const floes::FloePopulation& floes, model::Checkpoint& checkpoint) const {
  model::save(checkpoint, "watchdog", *this);
  model::Table table{"watched_floe", {}};
  for (const auto& [body, account] : accounts_) {
    const SavedAccount saved{floes.at(body).id, account.explained, account.travel};
    model::SavedRow row(table);
    SavedAccount::visit(saved, row);
  }
  checkpoint.tables.push_back(std::move(table));
}

void Watchdog::restore(const floes::FloePopulation& floes, const model::Checkpoint& checkpoint) {
  model::restore(checkpoint, "watchdog", *this);
  const std::map<std::int64_t, BodyId> bodies = floes.bodies_by_id();
  const model::Table& table = checkpoint.table("watched_floe");
  for (std::size_t i = 0; i < table.n_rows(); ++i) {
    SavedAccount saved;
    model::RestoredRow row(table, i);
    SavedAccount::visit(saved, row);
    accounts_[bodies.at(saved.floe)] = {saved.explained, saved.travel};
  }
}

/// No floe is farther from the field than the field is large, but for its drift in current and wind and for what the
/// structure pushes along. None is farther below or above the structure than the structure is high, or than ice piles.
void Watchdog::look_at_place(const floes::Floe& floe, Vec3 place, double time) const {
  const model::Case& c = *case_;
  const double drift = norm(current_past_ice(c)) + norm(c.wind.velocity), pushed = travel_ / c.time.step * time;
  const double astern = c.field.length + c.field.width + drift * time + (goes_straight(c) ? 0.0 : pushed);
  const double aside = c.field.length + c.field.width + drift * time + pushed;
  const double keel = hull_.first.z, height = hull_.second.z - keel, pile = border_height(c);
  const bool in_plan =
      place.x >= -astern && place.x <= c.field.length + aside && std::abs(place.y) <= 0.5 * c.field.width + aside;
  const double lowest = std::min(keel - height, -pile), highest = std::max(keel + 2.0 * height, pile);
  if (in_plan && place.z >= lowest && place.z <= highest) return;
  throw RunError(fmt::format("floe {} is at ({:.6g}, {:.6g}, {:.6g}) m, where nothing can have brought it", floe.id,
                             place.x, place.y, place.z));
}

/// In the order of the floes, so that the sum does not depend on the number of threads.
void Watchdog::explain_gyration(const rigid_body::World& world) {
  for (const BodyId body : world.moving()) {
    const double share = world.gyroscopic_share(body);
    accounts_.at(body).explained += share;
    gyroscopic_ += share;
  }
}

/// No floe has more energy than contacts, water and its height gave it. Its force F changes once, too: from nearly
/// nothing afloat to its weight in air. So the errors of its steps, dt F (u' - u) / 2, add up to as much again.
void Watchdog::look_at_energy(const Watched& now, BodyId body, const floes::Floe& floe) {
  const double energy = now.floes.energy(now.world, body, floe);
  const double received = now.energy.received(body);
  Account& account = accounts_.at(body);
  account.explained += received;
  account.travel = std::max(account.travel, case_->time.step * norm(now.world.twist(body).linear));
  const double allowed = 2.0 * allowance(floe.weight, account.travel);
  if (energy - account.explained <= allowed) return;
  throw RunError(
      fmt::format("floe {} of {:.4g} kg has an energy of {:.6g} J, of which its work explains {:.6g} J and "
                  "the time step {:.3g} J",
                  floe.id, floe.inertia.mass, energy, account.explained, allowed));
}

double Watchdog::allowance_of_all(const floes::FloePopulation& floes, double enough) const {
  double sum = allowed_to_gone_;
  for (const auto& [body, floe] : floes.floes()) {
    if (sum >= enough) break;
    const auto account = accounts_.find(body);
    sum += allowance(floe.weight, account == accounts_.end() ? 0.0 : account->second.travel);
  }
  return sum;
}

/// Sum of the contacts' normal impulses of the last step [N s].
double Watchdog::impulses(const rigid_body::World& world) const {
  double sum = 0.0;
  for (const auto* contacts : {&world.contacts(), &world.contacts_of_sheets()})
    for (const rigid_body::ContactLoad& contact : *contacts) sum += contact.normal_force;
  return sum * case_->time.step;
}

/// Contacts take energy, and so does water at rest (docs/theory/contacts-and-bodies.md, (E4)).
void Watchdog::look_at_losses(const Watched& now) const {
  const double rounding = kRounding * (1.0 + now.row.kinetic_energy);
  const double given = rounding + kLeft * impulses(now.world);
  const auto& [contacts, water] = now.taken;
  // Stock Bullet parts rigid bodies by velocities, and begins with the impulses of the step before. Both may give
  // energy.
  const bool may_give = case_->contact.engine == model::ContactEngine::kBullet &&
                        case_->contact.crushing_bound == model::CrushingBound::kLevelIce;
  if (!may_give && !(contacts >= -given))
    throw RunError(fmt::format("contacts gave the floes {:.6g} J in this step", -contacts));
  const bool still = current_past_ice(*case_) == Vec2{} && !case_->hydrodynamics.structure_flow;
  if (still && !(water >= -rounding)) throw RunError(fmt::format("drag gave the floes {:.6g} J in this step", -water));
}

/// Both ledgers close: the ledger of area to the last unit, the ledger of energy to the error of the time step.
void Watchdog::look_at_balance(const Watched& now) const {
  if (!now.area.closes())
    throw RunError("the ledger does not close: " + now.area.missing().to_string() + " m2 are missing");
  if (now.floes.area() != now.area.floes)
    throw RunError("the ledger does not fit the floes: they lack " + (now.area.floes - now.floes.area()).to_string() +
                   " m2");
  const double error = now.row.energy_error - booked_error_ + gyroscopic_;
  const double rounding = kRounding * (1.0 + std::abs(now.row.work));
  const double allowed = allowance_of_all(now.floes, std::abs(error)) + rounding;
  if (!(std::abs(error) <= allowed))
    throw RunError(
        fmt::format("the energies do not close: {:.6g} J of {:.6g} J of work are missing, the time step "
                    "explains {:.3g} J",
                    error, now.row.work, allowed));
}

}  // namespace brash::simulation
