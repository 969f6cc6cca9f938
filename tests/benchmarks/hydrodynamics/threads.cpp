// SPDX-License-Identifier: GPL-3.0-or-later
// Wall time of a step of rubble on one thread and on two: bench_threads program|bullet [steps] [floes...].
//
// `program` is water and world. `bullet` is Bullet's own world for threads over the same floes, set to the program's
// state before each step. It needs a Bullet that was built with threads. As many packs as have 10^4 floes take the
// steps, each on one thread, on two and on two again, and times are the means of the first two. The first step, which
// finds neighbours, is left out. The places of the floes after each step are compared bit by bit. Prints a JSON object.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstdint>
#include <exception>
#include <string>
#include <vector>

#include "field_states.hpp"

namespace {

using namespace brash;
using namespace brash::benchmarks;

constexpr int kLayers = 3;  // of rubble

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Steps of one pack: wall time of each [s], and the floes after each.
struct Steps {
  std::vector<double> seconds;
  std::vector<std::vector<Pose>> poses;
};

/// The program's steps of a new pack.
Steps step_program(int n_floes, int threads, int n_steps) {
  Workers workers(threads);
  Field field(n_floes, kLayers, {});
  field.world.share_work(workers);
  Steps steps;
  for (int i = 0; i < n_steps; ++i) {
    const double start = wall_seconds();
    field.water.apply(field.world, field.floes, kStep, {});
    field.world.step(kStep);
    steps.seconds.push_back(wall_seconds() - start);
    auto& poses = steps.poses.emplace_back();
    for (const auto& [body, floe] : field.floes.floes()) poses.push_back(field.world.pose(body));
  }
  return steps;
}

/// Steps of Bullet's world, each from one of the states.
Steps step_bullet(const model::Case& c, int threads, const std::vector<std::vector<FloeThen>>& states) {
  BulletWorld bullet(c, threads);
  Steps steps;
  for (const auto& floes : states) {
    bullet.set_floes(floes);
    const double start = wall_seconds();
    bullet.step(kStep);
    steps.seconds.push_back(wall_seconds() - start);
    steps.poses.push_back(bullet.poses());
  }
  return steps;
}

bool same_bits(const Pose& a, const Pose& b) {
  using Bits = std::array<std::uint64_t, sizeof(Pose) / sizeof(std::uint64_t)>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

/// The largest share of a pack's floes that one step of two leaves at another place, and the distance [m].
struct Difference {
  double share = 0.0;
  double distance = 0.0;

  void add(const Steps& first, const Steps& second) {
    for (std::size_t i = 0; i < first.poses.size(); ++i) {
      int n = 0;
      for (std::size_t k = 0; k < first.poses[i].size(); ++k) {
        n += same_bits(first.poses[i][k], second.poses[i][k]) ? 0 : 1;
        distance = std::max(distance, norm(first.poses[i][k].position - second.poses[i][k].position));
      }
      share = std::max(share, static_cast<double>(n) / static_cast<double>(first.poses[i].size()));
    }
  }
};

/// Adds the times of all steps but the first to their sums.
void add(std::vector<double>& sums, const std::vector<double>& seconds) {
  sums.resize(seconds.size() - 1);
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += seconds[i + 1];
}

std::string measure(bool of_bullet, int n_wanted, int n_steps) {
  Field field(n_wanted, kLayers, {});
  const std::size_t n_floes = field.floes.floes().size();
  const auto states = states_before_steps(field, of_bullet ? n_steps + 1 : 0);
  const int n_packs = std::max(1, 10000 / n_wanted);
  std::vector<double> one, two;
  Difference of_threads, of_runs;
  for (int pack = 0; pack < n_packs; ++pack) {
    const auto on = [&](int threads) {
      return of_bullet ? step_bullet(field.ice, threads, states) : step_program(n_wanted, threads, n_steps + 1);
    };
    const Steps alone = on(1), shared = on(2), again = on(2);
    add(one, alone.seconds);
    add(two, shared.seconds);
    of_threads.add(alone, shared);
    of_runs.add(shared, again);
  }
  for (std::vector<double>* times : {&one, &two})
    for (double& seconds : *times) seconds /= n_packs;
  return fmt::format(
      "{{\"floes\": {}, \"one_s\": [{}], \"two_s\": [{}], \"share_elsewhere\": {}, \"distance_m\": {}, "
      "\"share_elsewhere_again\": {}, \"distance_again_m\": {}}}",
      n_floes, fmt::join(one, ", "), fmt::join(two, ", "), of_threads.share, of_threads.distance, of_runs.share,
      of_runs.distance);
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() < 3 || (words[0] != "program" && words[0] != "bullet")) {
    fmt::print(stderr, "usage: bench_threads program|bullet STEPS FLOES...\n");
    return 2;
  }
  std::vector<std::string> rows;
  for (std::size_t i = 2; i < words.size(); ++i)
    rows.push_back(measure(words[0] == "bullet", std::stoi(words[i]), std::stoi(words[1])));
  fmt::print("[{}]\n", fmt::join(rows, ",\n "));
} catch (const std::exception& error) {
  fmt::print(stderr, "bench_threads: {}\n", error.what());
  return 1;
}
