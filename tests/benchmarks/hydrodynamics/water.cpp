// SPDX-License-Identifier: GPL-3.0-or-later
// The water on a field of floes beside the world's step over the same floes. Times are
// processor times of the process, so that other load on the machine matters little.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "field.hpp"

namespace {

using namespace brash::benchmarks;

void water(benchmark::State& state, int layers, const std::vector<std::string>& overrides) {
  Field field(static_cast<int>(state.range(0)), layers, overrides);
  field.water.apply(field.world, field.floes, kStep, {});
  field.world.step(kStep);
  for (auto _ : state) {
    state.PauseTiming();  // the floes move on, so that the water has to find their neighbours again
    field.world.step(kStep);
    state.ResumeTiming();
    field.water.apply(field.world, field.floes, kStep, {});
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(field.floes.floes().size()));
}

void world_step(benchmark::State& state, int layers) {
  Field field(static_cast<int>(state.range(0)), layers, {});
  field.water.apply(field.world, field.floes, kStep, {});
  field.world.step(kStep);
  for (auto _ : state) {
    state.PauseTiming();
    field.water.apply(field.world, field.floes, kStep, {});
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
