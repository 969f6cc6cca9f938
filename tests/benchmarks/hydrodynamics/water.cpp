// SPDX-License-Identifier: GPL-3.0-or-later
// The water on a field of floes beside the world's step over the same floes. Times are those of the process, so that
// other load on the machine matters little.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include "brash/io/case.hpp"
#include "floe_population.hpp"

namespace {

using namespace brash;
using simulation::FloePopulation;

constexpr double kStep = 0.01;

/// The ice and the water of the validation case.
io::Case validation(const std::vector<std::string>& overrides) {
  return io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml", overrides);
}

/// Layers of square floes of 1.4 m, each shifted against the one above and tilted a little, so that they press on their
/// neighbours: one layer is a pack afloat, three are rubble.
struct Field {
  Field(int n_floes, int layers, const std::vector<std::string>& overrides)
      : ice(validation(overrides)),
        world({.ice_structure = {0.027, 0.0, 0.5e6}, .ice_ice = {0.3, 0.0, 0.5e6}}),
        floes(ice) {
    const int side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(n_floes) / layers)));
    for (int layer = 0; layer < layers; ++layer)
      for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
          const Vec2 low = 1.4 * Vec2{i + 0.3 * layer, j + 0.2 * layer};
          const std::vector<Vec2> ring{low, low + Vec2{1.395, 0}, low + Vec2{1.395, 1.395}, low + Vec2{0, 1.395}};
          if (!floes.add(world, {geometry::ring(ring), {}}, 0.0)) continue;
          const BodyId body = floes.floes().rbegin()->first;
          Pose pose = world.pose(body);
          pose.position.z -= 0.335 * layer;
          pose.rotation = {1.0, 0.01 * ((i + j) % 3 - 1), 0.01 * ((i + 2 * j) % 3 - 1), 0.0};
          world.set_state(body, pose, {{0.1 * std::sin(i), 0.1 * std::cos(j), 0.0}, {}});
        }
  }
  Field(const Field&) = delete;

  io::Case ice;
  rigid_body::World world;
  FloePopulation floes;
};

void water(benchmark::State& state, int layers, const std::vector<std::string>& overrides) {
  Field field(static_cast<int>(state.range(0)), layers, overrides);
  field.floes.apply_water(field.world, kStep, {});
  field.world.step(kStep);
  for (auto _ : state) {
    state.PauseTiming();  // the floes move on, so that their neighbours have to be found anew
    field.world.step(kStep);
    state.ResumeTiming();
    field.floes.apply_water(field.world, kStep, {});
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(field.floes.floes().size()));
}

void world_step(benchmark::State& state, int layers) {
  Field field(static_cast<int>(state.range(0)), layers, {});
  field.floes.apply_water(field.world, kStep, {});
  field.world.step(kStep);
  for (auto _ : state) {
    state.PauseTiming();
    field.floes.apply_water(field.world, kStep, {});
    state.ResumeTiming();
    field.world.step(kStep);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(field.floes.floes().size()));
}

const std::vector<std::string> kShaded{};
const std::vector<std::string> kOpen{"hydrodynamics.shading=false"};
const std::vector<std::string> kPaper{"hydrodynamics.drag=paper"};

#define BRASH_FIELD(name, ...) \
  BENCHMARK_CAPTURE(name, __VA_ARGS__)->Arg(10'000)->Iterations(10)->Unit(benchmark::kMillisecond)

BRASH_FIELD(world_step, afloat, 1);
BRASH_FIELD(water, afloat / shaded, 1, kShaded);
BRASH_FIELD(water, afloat / open, 1, kOpen);
BRASH_FIELD(water, afloat / paper, 1, kPaper);
BRASH_FIELD(world_step, rubble, 3);
BRASH_FIELD(water, rubble / shaded, 3, kShaded);
BRASH_FIELD(water, rubble / open, 3, kOpen);
BRASH_FIELD(water, rubble / paper, 3, kPaper);

}  // namespace
