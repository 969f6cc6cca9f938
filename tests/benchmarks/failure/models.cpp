// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include "brash/failure/criterion.hpp"
#include "brash/meta_model/network.hpp"
#include "brash/plate/plate.hpp"

namespace {

using namespace brash;

/// Table 1 of the paper.
constexpr failure::IceProperties kIce{
    .thickness = 0.33, .youngs_modulus = 0.35e9, .flexural_strength = 539e3, .compressive_strength = 1e6};

/// Part of i times an irrational step that is left beyond whole numbers: fills [0, 1) evenly, the same each time.
double spread(std::size_t i, double step) { return std::fmod(static_cast<double>(i + 1) * step, 1.0); }

/// Row `i` of any number of them, spread over the middle of the models' range.
meta_model::Input input(std::size_t i) {
  return {.b_lc = 1.5 * spread(i, 0.8191725134),
          .c_lc = 0.05 + 0.5 * spread(i, 0.6710436067),
          .theta = 0.3 + 1.5 * spread(i, 0.5497004779),
          .mu1 = 0.2 + spread(i, 0.4503046119),
          .mu2 = 0.2 * spread(i, 0.3688760387) - 0.1};
}

failure::LoadCase load_case(std::size_t i, double l_c) {
  const meta_model::Input x = input(i);
  return {.depth = x.b_lc * l_c,
          .contact_length = x.c_lc * l_c,
          .angle = x.theta,
          .mu1 = x.mu1,
          .mu2 = x.mu2,
          .pressure = 1e5};
}

/// A network over range(0) rows in one call.
void network_rows(benchmark::State& state, model::FailureModel model) {
  const auto network = meta_model::read_network(failure::model_path(model, ""));
  std::vector<meta_model::Input> inputs;
  for (std::size_t i = 0; i < static_cast<std::size_t>(state.range(0)); ++i) inputs.push_back(network->clamp(input(i)));
  std::vector<meta_model::Output> outputs(inputs.size());
  for (auto _ : state) {
    network->predict(inputs, outputs);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK_CAPTURE(network_rows, network, model::FailureModel::kNetwork)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(network_rows, deep_network, model::FailureModel::kDeepNetwork)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond);

/// One assessment, as a contact asks for it.
void assess(benchmark::State& state, model::FailureModel model) {
  const auto criterion = failure::make_criterion(model, "", kIce);
  const double l_c = failure::characteristic_length(kIce);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(criterion->assess(load_case(i++, l_c)));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK_CAPTURE(assess, network, model::FailureModel::kNetwork);
BENCHMARK_CAPTURE(assess, deep_network, model::FailureModel::kDeepNetwork);
BENCHMARK_CAPTURE(assess, wedge, model::FailureModel::kWedge);
BENCHMARK_CAPTURE(assess, superposition, model::FailureModel::kSuperposition)->Unit(benchmark::kMicrosecond);

/// The plate itself (`--model fem`).
void fem_row(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) {
    const meta_model::Input x = input(i++);
    const auto profiles = plate::solve({.depth = x.b_lc, .contact_length = x.c_lc, .angle = x.theta});
    if (!profiles) {
      state.SkipWithError(profiles.error().what.c_str());
      break;
    }
    benchmark::DoNotOptimize(plate::respond(*profiles, 0.1, x.mu1, x.mu2));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(fem_row)->Unit(benchmark::kMillisecond)->Iterations(20);

}  // namespace
