// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include "events.hpp"

// The same events with Boost.Geometry in doubles.
namespace {

using namespace brash;
namespace bg = boost::geometry;
using BoostPolygon = bg::model::polygon<bg::model::d2::point_xy<double>, false, true>;
using BoostPolygons = bg::model::multi_polygon<BoostPolygon>;

BoostPolygon polygon_of(const geometry::Ring& ring) {
  BoostPolygon polygon;
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    const Vec2 p = metres(ring[i % ring.size()]);
    bg::append(polygon.outer(), bg::model::d2::point_xy<double>(p.x, p.y));
  }
  return polygon;
}

void boost_event(benchmark::State& state) {
  const benchmarks::Workload workload = benchmarks::make_workload(state.range(0), 32, 100);
  const std::size_t n_events = benchmarks::affordable(100.0 + 0.1 * static_cast<double>(state.range(0)), workload);
  for (auto _ : state) {
    BoostPolygons sheet{polygon_of(workload.sheet.outline)};
    const double start = benchmarks::processor_time();
    for (std::size_t i = 0; i < n_events; ++i) {
      const BoostPolygon disc = polygon_of(workload.events[i].region);
      BoostPolygons overlap, rest;
      bg::intersection(sheet, disc, overlap);
      bg::difference(sheet, disc, rest);
      for (const geometry::Ring& ring : benchmarks::sectors(workload.events[i])) {
        BoostPolygons wedge;
        bg::intersection(overlap, polygon_of(ring), wedge);
        benchmark::DoNotOptimize(wedge);
      }
      sheet = std::move(rest);
    }
    state.SetIterationTime((benchmarks::processor_time() - start) / static_cast<double>(n_events));
  }
}
BENCHMARK(boost_event)
    ->RangeMultiplier(10)
    ->Range(100, 100000)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond)
    ->Iterations(1);

}  // namespace
