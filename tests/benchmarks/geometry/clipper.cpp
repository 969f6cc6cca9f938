// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <polyclipping/clipper.hpp>

#include "events.hpp"

// The same events with Clipper 6 on the same integer grid.
namespace {

using namespace brash;
using ClipperLib::Paths;

ClipperLib::Path path_of(const geometry::Ring& ring) {
  ClipperLib::Path path;
  for (const geometry::Point p : ring) path.emplace_back(p.x, p.y);
  return path;
}

Paths run(ClipperLib::ClipType type, const Paths& subject, const ClipperLib::Path& clip) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(subject, ClipperLib::ptSubject, true);
  clipper.AddPath(clip, ClipperLib::ptClip, true);
  Paths result;
  clipper.Execute(type, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return result;
}

void clipper_event(benchmark::State& state) {
  const benchmarks::Workload workload = benchmarks::make_workload(state.range(0), 32, 100);
  const std::size_t n_events = benchmarks::affordable(100.0 + 0.35 * static_cast<double>(state.range(0)), workload);
  for (auto _ : state) {
    Paths sheet{path_of(workload.sheet.outline)};
    const double start = benchmarks::processor_time();
    for (std::size_t i = 0; i < n_events; ++i) {
      const ClipperLib::Path disc = path_of(workload.events[i].region);
      const Paths overlap = run(ClipperLib::ctIntersection, sheet, disc);
      sheet = run(ClipperLib::ctDifference, sheet, disc);
      for (const geometry::Ring& ring : benchmarks::sectors(workload.events[i])) {
        benchmark::DoNotOptimize(run(ClipperLib::ctIntersection, overlap, path_of(ring)));
      }
    }
    state.SetIterationTime((benchmarks::processor_time() - start) / static_cast<double>(n_events));
  }
}
BENCHMARK(clipper_event)
    ->RangeMultiplier(10)
    ->Range(100, 100000)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond)
    ->Iterations(1);

}  // namespace
