// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "brash/floes/floe_population.hpp"
#include "brash/floes/mean_pushes.hpp"

namespace brash::floes {

/// The part of the plan where the structure does not come soon: behind it, or all around it beyond a distance.
struct Clear {
  Vec2 origin{};          ///< of the structure
  Vec2 course{};          ///< unit
  double distance = 0.0;  ///< from the origin, along the course or in any direction [m]
  bool all_around = false;

  /// Whether a box is wholly in it.
  bool holds(const std::pair<Vec3, Vec3>& box) const { return slack(box) > 0.0; }
  /// How far the structure may move before a box in it no longer is, if it keeps its course or `all_around` is set [m].
  double slack(const std::pair<Vec3, Vec3>& box) const;
};

/// Puts floes to sleep that have been slow for long, and wakes them; for time.settle_speed > 0.
/// docs/theory/simulation.md, (S2).
class Sleep {
 public:
  explicit Sleep(const model::Case& resolved) : case_(&resolved) {}

  /// After a step of the world, which may have woken floes.
  void notice_woken(const rigid_body::World& world, FloePopulation& floes);

  /// Wakes the floes that others push on more, or less, than when they fell asleep. Puts those to sleep that have been
  /// slow for long.
  /// @param clear  only floes wholly in it fall asleep.
  /// @return the kinetic energy that this took [J].
  double update(rigid_body::World& world, FloePopulation& floes, const Clear& clear);

  /// Puts floes that float at rest, with nothing that drives them, to sleep at the start of a run.
  void begin(rigid_body::World& world, FloePopulation& floes, const Clear& clear);

  /// Level ice has broken within `radius` of `at`, and may have held floes there.
  void wake_within(rigid_body::World& world, FloePopulation& floes, Vec2 at, double radius);

  /// The structure may come where a floe is not wholly in `clear`: it wakes, for a structure meets no sleeping floe.
  void wake_beyond(rigid_body::World& world, FloePopulation& floes, const Clear& clear);

  /// The floe is about to be removed.
  void forget(FloePopulation& floes, BodyId body);

  void save(const FloePopulation& floes, model::Checkpoint& checkpoint) const;
  /// Once all floes are restored.
  void restore(const FloePopulation& floes, const model::Checkpoint& checkpoint);

 private:
  void wake(rigid_body::World& world, FloePopulation& floes, BodyId body);
  void woken(FloePopulation& floes, BodyId body);
  void fall_asleep(rigid_body::World& world, FloePopulation& floes, BodyId body);
  /// Wakes the floes among `pushed_` whose push may move them.
  void wake_pushed(rigid_body::World& world, FloePopulation& floes);
  /// Changes the mean force on a floe since it fell asleep [N].
  void push(FloePopulation& floes, BodyId body, Vec3 change);
  /// The kinetic energy of a floe at time.settle_speed [J].
  double slow_energy(const Floe& floe) const;
  /// The force that would bring a mass [kg] to time.settle_speed in the time of falling asleep [N].
  double slow_push(double mass) const;

  const model::Case* case_;
  MeanPushes pushes_;
  std::vector<BodyId> pushed_;  ///< floes whose push has changed since it was looked at
  Clear looked_{};              ///< of the last look at all that sleep
  double slack_ = 0.0;          ///< least of all that sleep, against that look [m]
};

}  // namespace brash::floes
