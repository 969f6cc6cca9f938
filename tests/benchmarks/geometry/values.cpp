// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "brash/geometry/trapezoid.hpp"
#include "fit_cases.hpp"

namespace {

using namespace brash;
using namespace brash::geometry;

/// One trapezoid fit to an edge with 3 cm of noise and a vertex every 0.3 m; range(0): whether c is known.
void trapezoid_fit(benchmark::State& state) {
  std::mt19937_64 generator(7);
  std::vector<std::vector<fit_cases::Polyline>> cases;
  for (int i = 0; i < 100; ++i) {
    const double b = 0.3 + shapes::uniform(generator), theta = radians(20 + 80 * shapes::uniform(generator));
    cases.push_back({fit_cases::roughened(fit_cases::trapezoid_edge(b, 0.4, theta, 8.0), 0.3, 0.03, generator)});
  }
  const FitRequest request{{0, 0}, {1, 0}, state.range(0) == 1 ? 0.4 : 0.0, 3.0};
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(fit_trapezoid(cases[i++ % cases.size()], request));
}
BENCHMARK(trapezoid_fit)->Arg(1)->Arg(0)->Unit(benchmark::kMicrosecond);

/// Convex parts of one wedge of 6 to 14 vertices.
void wedge_parts(benchmark::State& state) {
  std::mt19937_64 generator(11);
  std::vector<Polygon> wedges;
  for (int i = 0; i < 100; ++i) wedges.push_back({shapes::wedge(generator), {}});
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(convex_parts(wedges[i++ % wedges.size()]));
}
BENCHMARK(wedge_parts)->Unit(benchmark::kMicrosecond);

}  // namespace
