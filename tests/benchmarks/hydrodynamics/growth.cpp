// SPDX-License-Identifier: GPL-3.0-or-later
// Water and world of a step against the number of floes, all of them active, then all of them settled:
// bench_growth [--alone] [--awake] [--rubble] [--threads=N] [steps] [floes...]. Beside it Bullet's own world steps the
// same floes, set to the state before each step; with --alone it does not. With --awake no floe is settled: settling
// one takes time in proportion to all pairs. With --rubble there is no pack of one layer.
//
// Times are the process's own, of single steps; memory is the heap's. A step over few floes is over before a processor
// that others use too has shown its speed: as many packs of them are made, one after the other, as have 10^4 floes, and
// times are their mean. Prints a JSON object.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <string>
#include <vector>

#include "field_states.hpp"

namespace {

using namespace brash;
using namespace brash::benchmarks;

double process_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Heap in use [bytes].
double allocated() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd);
}

/// Times of each step but the first, which has to find neighbours and allocate memory [s].
struct StepTimes {
  std::vector<double> water, world, wall, settled, bullet;  ///< `wall` of water and world, the others processor time
};

/// Adds the times of one more pack to their sums.
void add(std::vector<double>& sums, const std::vector<double>& times) {
  sums.resize(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) sums[i] += times[i];
}

/// Seconds since a moment of the past.
double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The measured quantity.
struct Options {
  int n_steps = 5;
  int threads = 1;
  bool beside_bullet = true;
  bool settles = true;
  bool one_layer = true;
};

/// Times of Bullet's steps from the state before each step of the program but the first.
std::vector<double> bullet_seconds(int n_wanted, int layers, int n_steps) {
  Field field(n_wanted, layers, {});
  const auto states = states_before_steps(field, n_steps + 1);
  BulletWorld bullet(field.ice);
  std::vector<double> seconds;
  for (const auto& floes : states) {
    bullet.set_floes(floes);
    const double start = process_seconds();
    bullet.step(kStep);
    seconds.push_back(process_seconds() - start);
  }
  seconds.erase(seconds.begin());
  return seconds;
}

/// Steps all floes of a field; if asked, then fixes them and steps them again.
StepTimes step_times(Field& field, int n_steps, bool settles, std::size_t& n_contacts) {
  StepTimes times;
  for (int i = 0; i <= n_steps; ++i) {
    const double began = wall_seconds();
    const double start = process_seconds();
    field.water.apply(field.world, field.floes, kStep, {});
    const double between = process_seconds();
    field.world.step(kStep);
    if (i == 0) continue;
    times.wall.push_back(wall_seconds() - began);
    times.water.push_back(between - start);
    times.world.push_back(process_seconds() - between);
  }
  n_contacts = field.world.contacts().size();
  if (!settles) return times;
  for (const auto& [body, floe] : field.floes.floes()) field.world.set_settled(body, true);
  for (int i = 0; i < n_steps; ++i) {
    const double start = process_seconds();
    field.water.apply(field.world, field.floes, kStep, {});
    field.world.step(kStep);
    times.settled.push_back(process_seconds() - start);
  }
  return times;
}

std::string measure(int n_wanted, int layers, const Options& options) {
  const int n_steps = options.n_steps;
  const int n_packs = std::max(1, 10000 / n_wanted);
  std::size_t n_floes = 0, n_contacts = 0;
  double bytes = 0.0;
  StepTimes sums;
  Workers workers(options.threads);
  for (int pack = 0; pack < n_packs; ++pack) {
    const double before = allocated();
    Field field(n_wanted, layers, {});
    field.world.share_work(workers);
    const StepTimes times = step_times(field, n_steps, options.settles, n_contacts);
    bytes = allocated() - before;
    n_floes = field.floes.floes().size();
    add(sums.water, times.water);
    add(sums.world, times.world);
    add(sums.settled, times.settled);
    add(sums.wall, times.wall);
    if (options.beside_bullet) add(sums.bullet, bullet_seconds(n_wanted, layers, n_steps));
  }
  for (std::vector<double>* times : {&sums.water, &sums.world, &sums.wall, &sums.settled, &sums.bullet})
    for (double& seconds : *times) seconds /= n_packs;
  return fmt::format(
      "{{\"layers\": {}, \"floes\": {}, \"contacts\": {}, \"bytes\": {}, \"water_s\": [{}], \"world_s\": [{}], "
      "\"wall_s\": [{}], \"settled_s\": [{}], \"bullet_s\": [{}]}}",
      layers, n_floes, n_contacts, bytes, fmt::join(sums.water, ", "), fmt::join(sums.world, ", "),
      fmt::join(sums.wall, ", "), fmt::join(sums.settled, ", "), fmt::join(sums.bullet, ", "));
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  std::vector<std::string> numbers;
  for (const std::string& word : std::vector<std::string>(argv + 1, argv + argc)) {
    if (word == "--alone")
      options.beside_bullet = false;
    else if (word == "--awake")
      options.settles = false;
    else if (word == "--rubble")
      options.one_layer = false;
    else if (word.starts_with("--threads="))
      options.threads = std::stoi(word.substr(word.find('=') + 1));
    else
      numbers.push_back(word);
  }
  if (!numbers.empty()) options.n_steps = std::stoi(numbers[0]);
  std::vector<std::string> rows;
  for (std::size_t i = 1; i < numbers.size(); ++i)
    for (const int layers : {1, 3})
      if (layers > 1 || options.one_layer) rows.push_back(measure(std::stoi(numbers[i]), layers, options));
  fmt::print("[{}]\n", fmt::join(rows, ",\n "));
}
