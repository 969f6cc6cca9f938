// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "brash/edge/edge_contact.hpp"
#include "brash/floes/floe_water.hpp"
#include "brash/io/case.hpp"

namespace brash::benchmarks {

using floes::FloePopulation;

inline constexpr double kStep = 0.01;

/// The ice and the water of the validation case.
inline model::Case validation(const std::vector<std::string>& overrides) {
  return io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml", overrides);
}

/// Layers of square floes of 1.4 m, each shifted against the one above and tilted a little, so that they press on their
/// neighbours: one layer is a pack afloat, three are rubble.
struct Field {
  Field(int n_floes, int layers, const std::vector<std::string>& overrides)
      : ice(validation(overrides)),
        world({.ice_structure = {0.027, 0.5e6}, .ice_ice = {0.3, 0.5e6}}),
        floes(ice),
        water(ice) {
    const int side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(n_floes) / layers)));
    for (int layer = 0; layer < layers; ++layer)
      for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
          const Vec2 low = 1.4 * Vec2{i + 0.3 * layer, j + 0.2 * layer};
          const std::vector<Vec2> ring{low, low + Vec2{1.395, 0}, low + Vec2{1.395, 1.395}, low + Vec2{0, 1.395}};
          brash::ice::Plate plate(0, brash::ice::Hold::kAfloat, edge::ice_properties(ice),
                                  {{geometry::ring(ring), {}}});
          if (!floes.add(world, std::move(plate), 0.0)) continue;
          const BodyId body = floes.floes().rbegin()->first;
          Pose pose = world.pose(body);
          pose.position.z -= 0.335 * layer;
          pose.rotation = {1.0, 0.01 * ((i + j) % 3 - 1), 0.01 * ((i + 2 * j) % 3 - 1), 0.0};
          world.set_state(body, pose, {{0.1 * std::sin(i), 0.1 * std::cos(j), 0.0}, {}});
        }
  }
  Field(const Field&) = delete;

  model::Case ice;
  rigid_body::World world;
  floes::FloePopulation floes;
  floes::FloeWater water;
};

}  // namespace brash::benchmarks
