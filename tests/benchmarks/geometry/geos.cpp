// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>
#include <geos_c.h>

#include "events.hpp"

// The same events with GEOS OverlayNG in doubles.
namespace {

using namespace brash;

GEOSGeometry* polygon_of(const geometry::Ring& ring) {
  const auto n = static_cast<unsigned>(ring.size());
  GEOSCoordSequence* points = GEOSCoordSeq_create(n + 1, 2);
  for (unsigned i = 0; i <= n; ++i) {
    const Vec2 p = metres(ring[i % n]);
    GEOSCoordSeq_setXY(points, i, p.x, p.y);
  }
  return GEOSGeom_createPolygon(GEOSGeom_createLinearRing(points), nullptr, 0);
}

void geos_event(benchmark::State& state) {
  const benchmarks::Workload workload = benchmarks::make_workload(state.range(0), 32, 100);
  const std::size_t n_events = benchmarks::affordable(250.0 + 0.6 * static_cast<double>(state.range(0)), workload);
  initGEOS(nullptr, nullptr);
  for (auto _ : state) {
    GEOSGeometry* sheet = polygon_of(workload.sheet.outline);
    const double start = benchmarks::processor_time();
    for (std::size_t i = 0; i < n_events; ++i) {
      GEOSGeometry* disc = polygon_of(workload.events[i].region);
      GEOSGeometry* overlap = GEOSIntersection(sheet, disc);
      GEOSGeometry* rest = GEOSDifference(sheet, disc);
      for (const geometry::Ring& ring : benchmarks::sectors(workload.events[i])) {
        GEOSGeometry* sector = polygon_of(ring);
        GEOSGeom_destroy(GEOSIntersection(overlap, sector));
        GEOSGeom_destroy(sector);
      }
      GEOSGeom_destroy(overlap);
      GEOSGeom_destroy(disc);
      GEOSGeom_destroy(sheet);
      sheet = rest;
    }
    state.SetIterationTime((benchmarks::processor_time() - start) / static_cast<double>(n_events));
    GEOSGeom_destroy(sheet);
  }
  finishGEOS();
}
BENCHMARK(geos_event)
    ->RangeMultiplier(10)
    ->Range(100, 100000)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond)
    ->Iterations(1);

}  // namespace
