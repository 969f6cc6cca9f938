// SPDX-License-Identifier: GPL-3.0-or-later
// Prints responses of a moving edge: b c theta [scale reach n_vectors].
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "brash/plate/edge_responses.hpp"

int main(int argc, char** argv) {
  const auto number = [&](int i, double otherwise) { return argc > i ? std::atof(argv[i]) : otherwise; };
  const auto now = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
  const brash::plate::EdgeGeometry geometry{.depth = number(1, 0.0),
                                            .contact_length = number(2, 0.3),
                                            .angle = number(3, 0.0) * 3.14159265358979 / 180.0,
                                            .mass_ratio = 0.0886,
                                            .thickness = 0.1009,
                                            .split = number(7, 0.0) != 0.0};
  const brash::plate::EdgeOptions options{
      .scale = number(4, 0.0), .reach = number(5, 0.0), .n_vectors = int(number(6, 0.0))};
  const double start = now();
  const auto edge = brash::plate::MovingEdge::prepare(geometry, options);
  if (!edge) return std::puts(edge.error().what.c_str()), 1;
  const double middle = now();
  const auto r = edge->respond(geometry);
  if (!r) return std::puts(r.error().what.c_str()), 1;
  std::printf("elements %d, prepare %.2f s, respond %.2f s\n", edge->n_elements(), middle - start, now() - middle);
  std::printf("%8s %10s %10s %8s %10s %10s\n", "t", "w", "mxx", "at", "mxx min", "myy");
  const auto print = [&](double t, double w, double yy, const double* xx) {
    const std::size_t n = r->station.size();
    const auto most = std::max_element(xx, xx + n) - xx;
    std::printf("%8.4f %10.6f %10.6f %8.4f %10.6f %10.6f\n", t, w, xx[most], r->station[std::size_t(most)],
                *std::min_element(xx, xx + n), yy);
  };
  for (std::size_t i = 0; i < r->time.size(); i += 2)
    print(r->time[i], r->deflection[i], r->edge_moment[i], r->axis_moment_at(i));
  print(1e9, r->static_deflection, r->static_edge_moment, r->static_axis_moment.data());
  return 0;
}
