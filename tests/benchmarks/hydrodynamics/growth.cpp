// SPDX-License-Identifier: GPL-3.0-or-later
// Water and world of a step against the number of floes, all of them active, then all of them settled:
// bench_growth [steps] [floes...].
//
// Times are the process's own, of single steps; memory is the heap's. Prints a JSON object.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <malloc.h>

#include <cstdlib>
#include <ctime>

#include "field.hpp"

namespace {

using namespace brash::benchmarks;

double process_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Heap in use [bytes].
double allocated() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd);
}

std::string measure(int n_wanted, int layers, int n_steps) {
  const double before = allocated();
  Field field(n_wanted, layers, {});
  std::vector<double> water, world;
  for (int i = 0; i <= n_steps; ++i) {
    const double start = process_seconds();
    field.floes.apply_water(field.world, kStep, {});
    const double between = process_seconds();
    field.world.step(kStep);
    if (i == 0) continue;  // what a first step has to find and allocate
    water.push_back(between - start);
    world.push_back(process_seconds() - between);
  }
  const auto contacts = field.world.contacts().size();
  const double bytes = allocated() - before;
  for (const auto& [body, floe] : field.floes.floes()) field.world.set_settled(body, true);
  std::vector<double> settled;
  for (int i = 0; i < n_steps; ++i) {
    const double start = process_seconds();
    field.floes.apply_water(field.world, kStep, {});
    field.world.step(kStep);
    settled.push_back(process_seconds() - start);
  }
  const auto n_floes = static_cast<double>(field.floes.floes().size());
  return fmt::format(
      "{{\"layers\": {}, \"floes\": {}, \"contacts\": {}, \"bytes\": {}, \"water_s\": [{}], \"world_s\": [{}], "
      "\"settled_s\": [{}]}}",
      layers, n_floes, contacts, bytes, fmt::join(water, ", "), fmt::join(world, ", "), fmt::join(settled, ", "));
}

}  // namespace

int main(int argc, char** argv) {
  const int n_steps = argc > 1 ? std::atoi(argv[1]) : 5;
  std::vector<std::string> rows;
  for (int i = 2; i < argc; ++i)
    for (const int layers : {1, 3}) rows.push_back(measure(std::atoi(argv[i]), layers, n_steps));
  fmt::print("[{}]\n", fmt::join(rows, ",\n "));
}
