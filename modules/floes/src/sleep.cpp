// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/floes/sleep.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brash::floes {
namespace {

/// A floe falls asleep after it has been slow for so long [s]: longer than it heaves once.
constexpr double kTimeToSleep = 2.0;
/// A mean push is forgotten when it is this share of the push that would wake a cube of the ice [-].
constexpr double kNoPush = 1e-3;
/// Farther than any structure goes [m].
constexpr double kFar = 1e9;

/// The point of a box that is nearest to `at`.
Vec2 nearest(const std::pair<Vec3, Vec3>& box, Vec2 at) {
  const auto& [lower, upper] = box;
  return {std::clamp(at.x, lower.x, upper.x), std::clamp(at.y, lower.y, upper.y)};
}

}  // namespace

double Clear::slack(const std::pair<Vec3, Vec3>& box) const {
  if (all_around) return norm(nearest(box, origin) - origin) - distance;
  const auto& [lower, upper] = box;
  const Vec2 farthest{course.x < 0.0 ? lower.x : upper.x, course.y < 0.0 ? lower.y : upper.y};
  return dot(course, origin) - distance - dot(course, farthest);
}

double Sleep::slow_energy(const Floe& floe) const {
  return 0.5 * floe.inertia.mass * case_->time.settle_speed * case_->time.settle_speed;
}

double Sleep::slow_push(double mass) const { return mass * case_->time.settle_speed / kTimeToSleep; }

void Sleep::wake(rigid_body::World& world, FloePopulation& floes, BodyId body) {
  world.set_settled(body, false);
  woken(floes, body);
}

void Sleep::woken(FloePopulation& floes, BodyId body) {
  Floe& floe = floes.at(body);
  floe.rest = {};
  floe.kept_drag = {};
  pushes_.wake(body);
  floes.forget_asleep_height();
}

void Sleep::notice_woken(const rigid_body::World& world, FloePopulation& floes) {
  for (const BodyId body : world.moving())
    if (floes.at(body).rest.asleep) woken(floes, body);
}

void Sleep::wake_within(rigid_body::World& world, FloePopulation& floes, Vec2 at, double radius) {
  for (const auto& [body, floe] : floes.floes()) {
    if (!world.is_settled(body)) continue;
    if (norm(nearest(world.bounds(body), at) - at) < radius) wake(world, floes, body);
  }
}

/// All around, the structure reaches no sleeping floe before it has gone as far as the nearest one is away.
void Sleep::wake_beyond(rigid_body::World& world, FloePopulation& floes, const Clear& clear) {
  if (clear.all_around && norm(clear.origin - looked_.origin) + clear.distance - looked_.distance < slack_) return;
  looked_ = clear;
  slack_ = kFar;
  for (const auto& [body, floe] : floes.floes()) {
    if (!world.is_settled(body)) continue;
    const double slack = clear.slack(world.bounds(body));
    if (slack > 0.0)
      slack_ = std::min(slack_, slack);
    else
      wake(world, floes, body);
  }
}

void Sleep::fall_asleep(rigid_body::World& world, FloePopulation& floes, BodyId body) {
  slack_ = std::min(slack_, looked_.slack(world.bounds(body)));
  floes.put_to_sleep(world, body);
}

void Sleep::begin(rigid_body::World& world, FloePopulation& floes, const Clear& clear) {
  const std::vector<BodyId> moving = world.moving();
  for (auto body = moving.rbegin(); body != moving.rend(); ++body)  // the last leaves a sorted list at no cost
    if (clear.holds(world.bounds(*body))) fall_asleep(world, floes, *body);
}

void Sleep::push(FloePopulation& floes, BodyId body, Vec3 change) {
  floes.at(body).rest.push += change;
  pushed_.push_back(body);
}

void Sleep::wake_pushed(rigid_body::World& world, FloePopulation& floes) {
  for (const BodyId body : pushed_) {
    if (!floes.contains(body) || !world.is_settled(body)) continue;
    const Floe& floe = floes.at(body);
    if (norm(floe.rest.push) > slow_push(floe.inertia.mass)) wake(world, floes, body);
  }
  pushed_.clear();
}

double Sleep::update(rigid_body::World& world, FloePopulation& floes, const Clear& clear) {
  if (case_->time.settle_speed == 0.0) return 0.0;
  const double dt = case_->time.step;
  const double cube = case_->ice.density * std::pow(case_->ice.thickness, 3);
  pushes_.average(world, 1.0 - std::exp(-dt / kTimeToSleep), kNoPush * slow_push(cube),
                  [&](BodyId body, Vec3 change) { push(floes, body, change); });
  const std::vector<BodyId> moving = world.moving();
  wake_pushed(world, floes);
  double taken = 0.0;
  for (const BodyId body : moving) {
    Floe& floe = floes.at(body);
    const double kinetic = world.kinetic_energy(body);
    floe.rest.slow_for = kinetic <= slow_energy(floe) ? floe.rest.slow_for + dt : 0.0;
    if (floe.rest.slow_for < kTimeToSleep || !clear.holds(world.bounds(body))) continue;
    fall_asleep(world, floes, body);
    taken += kinetic;
  }
  return taken;
}

void Sleep::forget(FloePopulation& floes, BodyId body) {
  pushes_.forget(body, [&](BodyId other, Vec3 change) { push(floes, other, change); });
}

void Sleep::save(const FloePopulation& floes, model::Checkpoint& checkpoint) const {
  model::Table table{"push", {}};
  for (const auto& [pair, force] : pushes_.pairs()) {
    const FloePush push{floes.at(pair.first).id, floes.at(pair.second).id, force};
    model::SavedRow row(table);
    FloePush::visit(push, row);
  }
  checkpoint.tables.push_back(std::move(table));
}

void Sleep::restore(const FloePopulation& floes, const model::Checkpoint& checkpoint) {
  const std::map<std::int64_t, BodyId> bodies = floes.bodies_by_id();
  const model::Table& table = checkpoint.table("push");
  for (std::size_t i = 0; i < table.n_rows(); ++i) {
    FloePush push;
    model::RestoredRow row(table, i);
    FloePush::visit(push, row);
    pushes_.restore(bodies.at(push.floe), bodies.at(push.other), push.force);
  }
  for (const auto& [body, floe] : floes.floes())
    if (floe.rest.asleep) pushed_.push_back(body);  // its push may have changed after the last look
}

}  // namespace brash::floes
