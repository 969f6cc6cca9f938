// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "events.hpp"

namespace {

using namespace brash;
using benchmarks::Workload;

constexpr std::size_t kEvents = 500;

/// Time of one event on a sheet of range(0) vertices with discs of range(1) sides.
void kernel_event(benchmark::State& state) {
  const Workload workload = benchmarks::make_workload(state.range(0), static_cast<int>(state.range(1)), kEvents);
  const geometry::Polygon polygons[] = {workload.sheet};
  std::size_t pieces = 0;
  for (auto _ : state) {
    geometry::IceSheet sheet = geometry::IceSheet::from_polygons(polygons).value();
    const double start = benchmarks::processor_time();
    for (const benchmarks::Event& event : workload.events) {
      pieces += sheet.cut(event.region, event.cracks).pieces.size();
      pieces += sheet.release_detached().size();
    }
    state.SetIterationTime((benchmarks::processor_time() - start) / kEvents);
  }
  state.counters["pieces"] = static_cast<double>(pieces) / static_cast<double>(kEvents * state.iterations());
}
BENCHMARK(kernel_event)
    ->ArgsProduct({{100, 1000, 10000, 100000}, {32}})
    ->ArgsProduct({{10000}, {8, 16, 64}})
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond)
    ->Iterations(20);

/// A contact query: overlap of a section of 6.8 m radius with the sheet, at its edge.
void kernel_contacts(benchmark::State& state) {
  const Workload workload = benchmarks::make_workload(state.range(0), 32, kEvents);
  const geometry::Polygon polygons[] = {workload.sheet};
  geometry::IceSheet sheet = geometry::IceSheet::from_polygons(polygons).value();
  const geometry::Ring section = geometry::disc(metres(workload.sheet.outline[0]) + Vec2{6.0, 0.0}, 6.8, 64);
  for (auto _ : state) benchmark::DoNotOptimize(sheet.contacts(section));
}
BENCHMARK(kernel_contacts)->RangeMultiplier(10)->Range(100, 100000)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
