// SPDX-License-Identifier: GPL-3.0-or-later
// A pack of floes that comes to rest: bench_rigid_bodies[_ode] DT ITERATIONS. Prints one JSON object.
#include <cstdio>
#include <cstdlib>

#include "pack.hpp"

int main(int argc, char** argv) {
  if (argc < 3) return EXIT_FAILURE;
  const pack::Settings settings{std::atof(argv[1]), std::atoi(argv[2])};
  const pack::Pack floes = pack::make_pack(6, 5, 5);
  const auto engine = pack::make_engine(floes, settings);
  const pack::Outcome outcome = run(floes, *engine, settings.dt);
  std::printf("{\"floes\": %zu, \"seconds\": %.4f, \"position\": %.3e, \"bed\": %.3e, \"wall\": %.3e}\n",
              floes.floes.size(), outcome.seconds, outcome.position_error, outcome.bed_error, outcome.wall_error);
}
