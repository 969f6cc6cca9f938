// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "bullet_world.hpp"
#include "field.hpp"

namespace brash::benchmarks {

/// The floes of a field for Bullet's world, before each of `n_steps` steps of the program, which are taken.
inline std::vector<std::vector<FloeThen>> states_before_steps(Field& field, int n_steps) {
  std::vector<std::vector<FloeThen>> states;
  for (int i = 0; i < n_steps; ++i) {
    auto& floes = states.emplace_back();
    for (const auto& [body, floe] : field.floes.floes())
      floes.push_back({floe.id, floe.plate.outline().front(), field.world.pose(body), field.world.twist(body)});
    field.water.apply(field.world, field.floes, kStep, {});
    field.world.step(kStep);
  }
  return states;
}

}  // namespace brash::benchmarks
