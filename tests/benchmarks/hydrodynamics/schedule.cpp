// SPDX-License-Identifier: GPL-3.0-or-later
// Times of the chunks of every loop of a step of rubble on one thread, and of the parts between the loops:
// bench_schedule [steps] [repeats] [floes...].
//
// In each repeat a new pack takes the same steps, with the same chunks, so a time is the median of its repeats. A pack
// that nobody records takes them too, and tells the processor time of whole steps. The first steps, which find
// neighbours and allocate memory, are left out. Prints a JSON object, with the costs of sharing loops between threads.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <exception>
#include <string>
#include <vector>

#include "field.hpp"
#include "thread_costs.hpp"

namespace {

using namespace brash;
using namespace brash::benchmarks;

constexpr int kLayers = 3;  // of rubble
constexpr int kFirstSteps = 5;

/// Times of one step [s].
struct Step {
  std::vector<double> serial = {};  ///< before each loop, and after the last
  std::vector<double> chunks = {};  ///< of one loop after the other
  std::vector<LoopRecord::Loop> loops = {};
};

void take_step(Field& field) {
  field.water.apply(field.world, field.floes, kStep, {});
  field.world.step(kStep);
}

Step recorded_step(Field& field, Workers& workers, LoopRecord& record) {
  record.loops.clear();
  record.moments.clear();
  workers.record(&record);
  const auto start = Clock::now();
  take_step(field);
  const auto end = Clock::now();
  workers.record(nullptr);
  Step step{.loops = record.loops};
  auto last = start;
  std::size_t next = 0;
  for (const LoopRecord::Loop& loop : record.loops) {
    step.serial.push_back(seconds(record.moments[next] - last));
    for (std::size_t i = 0; i < loop.n_chunks; ++i, ++next)
      step.chunks.push_back(seconds(record.moments[next + 1] - record.moments[next]));
    last = record.moments[next++];
  }
  step.serial.push_back(seconds(end - last));
  return step;
}

/// Calls `step` for each step of a new pack on one thread, the first ones left out.
template <typename TakeStep>
void each_step(int n_floes, int n_steps, TakeStep&& step) {
  Workers workers(1);
  Field field(n_floes, kLayers, {});
  field.world.share_work(workers);
  for (int i = 0; i < kFirstSteps; ++i) take_step(field);
  for (int i = 0; i < n_steps; ++i) step(field, workers);
}

/// Number by number the median of `times` of the repeats of a step.
template <typename Times>
std::vector<double> medians(const std::vector<std::vector<Step>>& repeats, std::size_t step, Times&& times) {
  std::vector<double> result(times(repeats[0][step]).size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    std::vector<double> samples;
    samples.reserve(repeats.size());
    for (const auto& steps : repeats) samples.push_back(times(steps[step]).at(i));
    result[i] = median(samples);
  }
  return result;
}

/// Packs that take the same steps, one for each repeat.
struct Packs {
  std::vector<std::vector<Step>> recorded;
  std::vector<std::vector<double>> whole;  ///< processor time of each step [s]
};

std::string json_of_step(const Packs& packs, std::size_t step) {
  std::vector<double> whole;
  whole.reserve(packs.whole.size());
  for (const auto& steps : packs.whole) whole.push_back(steps[step]);
  const auto serial = medians(packs.recorded, step, [](const Step& s) { return s.serial; });
  const auto chunks = medians(packs.recorded, step, [](const Step& s) { return s.chunks; });
  std::vector<std::string> loops;
  auto next = chunks.begin();
  for (const LoopRecord::Loop& loop : packs.recorded[0][step].loops) {
    const auto end = next + static_cast<std::ptrdiff_t>(loop.n_chunks);
    loops.push_back(
        fmt::format("{{\"caller\": \"{}\", \"chunks_s\": [{:.4g}]}}", loop.caller, fmt::join(next, end, ", ")));
    next = end;
  }
  return fmt::format("{{\"whole_s\": {:.6g}, \"serial_s\": [{:.4g}],\n  \"loops\": [{}]}}", median(whole),
                     fmt::join(serial, ", "), fmt::join(loops, ",\n   "));
}

std::string json_of_pack(int n_wanted, int n_steps, int n_repeats) {
  const std::size_t n_floes = Field(n_wanted, kLayers, {}).floes.floes().size();
  Packs packs;
  LoopRecord record;
  for (int i = 0; i < n_repeats; ++i) {
    auto& whole = packs.whole.emplace_back();
    each_step(n_wanted, n_steps, [&](Field& field, Workers&) {
      const double start = processor_seconds();
      take_step(field);
      whole.push_back(processor_seconds() - start);
    });
    auto& recorded = packs.recorded.emplace_back();
    each_step(n_wanted, n_steps,
              [&](Field& field, Workers& workers) { recorded.push_back(recorded_step(field, workers, record)); });
  }
  std::vector<std::string> steps;
  for (std::size_t step = 0; step < static_cast<std::size_t>(n_steps); ++step)
    steps.push_back(json_of_step(packs, step));
  return fmt::format("{{\"floes\": {}, \"repeats\": {}, \"steps\": [\n {}]}}", n_floes, n_repeats,
                     fmt::join(steps, ",\n "));
}

std::string json_of_costs() {
  const auto [caller, other, end] = median_loop_seconds(false);
  return fmt::format(
      "{{\"clock_s\": {:.3g}, \"near_s\": {:.3g}, \"far_s\": {:.3g}, \"caller_s\": {:.3g}, \"other_s\": {:.3g}, "
      "\"end_s\": {:.3g}, \"awake_s\": {:.3g}, \"roused_s\": {:.3g}, \"rousing_s\": {{\"2\": {:.3g}, \"16\": "
      "{:.3g}}}}}",
      clock_seconds(), near_seconds(), far_seconds(), caller, other, end, awake_seconds(), median_loop_seconds(true)[1],
      rousing_seconds(2), rousing_seconds(16));
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() < 2) {
    fmt::print(stderr, "usage: bench_schedule STEPS REPEATS FLOES...\n");
    return 2;
  }
  std::vector<std::string> packs;
  for (std::size_t i = 2; i < words.size(); ++i)
    packs.push_back(json_of_pack(std::stoi(words[i]), std::stoi(words[0]), std::stoi(words[1])));
  fmt::print("{{\"costs\": {},\n\"packs\": [{}]}}\n", json_of_costs(), fmt::join(packs, ",\n"));
} catch (const std::exception& error) {
  fmt::print(stderr, "bench_schedule: {}\n", error.what());
  return 1;
}
