// SPDX-License-Identifier: GPL-3.0-or-later
// A pack of floes that comes to rest: bench_rigid_bodies[_PEER] DT ITERATIONS [SIZE [CRUSHING]], SIZE as 6x5x5: floes
// along, across and layers. Prints one JSON object. bench_rigid_bodies pack SIZE prints the pack, for engines that run
// on their own.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "pack.hpp"

namespace {

void print(const pack::Pack& floes) {
  std::printf("{\"gravity\": %g, \"push\": %g, \"friction\": %g, \"seconds\": %g, \"measured\": %g, \"floes\": [",
              pack::kGravity, pack::kPush, pack::kFriction, pack::kSeconds, pack::kMeasured);
  const char* separator = "";
  for (const auto& [size, start, rest, mass] : floes.floes) {
    std::printf("%s{\"size\": [%.17g, %.17g, %.17g], \"start\": [%.17g, %.17g, %.17g], ", separator, size.x, size.y,
                size.z, start.x, start.y, start.z);
    std::printf("\"rest\": [%.17g, %.17g, %.17g], \"mass\": %.17g}", rest.x, rest.y, rest.z, mass);
    separator = ",\n";
  }
  std::printf("]}\n");
}

}  // namespace

int main(int argc, char** argv) {
  const bool prints_pack = argc == 3 && std::strcmp(argv[1], "pack") == 0;
  if (argc < 3 || argc > 5) return EXIT_FAILURE;
  int along = 0, across = 0, layers = 0;
  const char* size = prints_pack ? argv[2] : argc > 3 ? argv[3] : "6x5x5";
  if (std::sscanf(size, "%dx%dx%d", &along, &across, &layers) != 3) return EXIT_FAILURE;
  const pack::Pack floes = pack::make_pack(along, across, layers);
  if (prints_pack) {
    print(floes);
    return EXIT_SUCCESS;
  }
  pack::Settings settings;
  settings.dt = std::atof(argv[1]);
  settings.iterations = std::atoi(argv[2]);
  if (argc > 4) settings.crushing = std::atof(argv[4]);
  const auto engine = pack::make_engine(floes, settings);
  const pack::Outcome outcome = run(floes, *engine, settings.dt);
  std::printf("{\"floes\": %zu, \"seconds\": %.4f, \"position\": %.3e, \"bed\": %.3e, \"wall\": %.3e}\n",
              floes.floes.size(), outcome.seconds, outcome.position_error, outcome.bed_error, outcome.wall_error);
}
