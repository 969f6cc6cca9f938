// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <benchmark/benchmark.h>

#include <list>

#include "events.hpp"

// The same events with CGAL's exact Boolean operations on plain segments.
namespace {

using namespace brash;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalRing = CGAL::Polygon_2<Kernel>;
using CgalPolygon = CGAL::Polygon_with_holes_2<Kernel>;

CgalRing ring_of(const geometry::Ring& ring) {
  CgalRing result;
  for (const geometry::Point p : ring) result.push_back(Kernel::Point_2(metres(p).x, metres(p).y));
  return result;
}

void cgal_event(benchmark::State& state) {
  const benchmarks::Workload workload = benchmarks::make_workload(state.range(0), 32, 30);
  const std::size_t n_events = benchmarks::affordable(1e4 + 6.0 * static_cast<double>(state.range(0)), workload);
  for (auto _ : state) {
    std::list<CgalPolygon> sheet{CgalPolygon(ring_of(workload.sheet.outline))};
    const double start = benchmarks::processor_time();
    for (std::size_t i = 0; i < n_events; ++i) {
      const CgalPolygon disc(ring_of(workload.events[i].region));
      std::list<CgalPolygon> overlap, rest;
      for (const CgalPolygon& polygon : sheet) {
        CGAL::intersection(polygon, disc, std::back_inserter(overlap), CGAL::Tag_false());
        CGAL::difference(polygon, disc, std::back_inserter(rest), CGAL::Tag_false());
      }
      for (const geometry::Ring& ring : benchmarks::sectors(workload.events[i])) {
        std::list<CgalPolygon> wedges;
        for (const CgalPolygon& polygon : overlap) {
          CGAL::intersection(polygon, CgalPolygon(ring_of(ring)), std::back_inserter(wedges), CGAL::Tag_false());
        }
      }
      sheet = std::move(rest);
    }
    state.SetIterationTime((benchmarks::processor_time() - start) / static_cast<double>(n_events));
  }
}
BENCHMARK(cgal_event)
    ->RangeMultiplier(10)
    ->Range(100, 100000)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond)
    ->Iterations(1);

}  // namespace
