// SPDX-License-Identifier: GPL-3.0-or-later
// Not a test: runs a case and writes some of the sheets that its criterion solves, as tests/corpus/sheets/README.md
// says.
//
//   record_sheets CASE N [section.key=value ...] > sheets.txt
//
// The sheets are drawn from strata: what presses, how near the ice is to breaking, whether a radial crack was asked
// for. The answers decide the stratum and nothing else. Counts of all solves go to the standard error.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "brash/io/case.hpp"
#include "brash/simulation/simulation.hpp"
#include "recorded_sheet.hpp"

namespace {

using namespace brash;
using failure::Assessment;
using failure::BendingCriterion;
using failure::LoadCase;

/// Sheets kept of each stratum, drawn evenly from all that belong to it.
constexpr std::size_t kKept = 16;
/// Two sheets of a stratum lie at least so far apart [s].
constexpr double kApart = 0.1;

struct Solved {
  double time = 0.0;
  testing::RecordedSheet sheet;
};

class Reservoir {
 public:
  void offer(double time, const LoadCase& load, const failure::IceProperties& ice, const Assessment& answer) {
    const std::lock_guard lock(mutex_);
    counts_ += answer.solves;
    ++n_;
    if (load.outline.empty() || answer.buckled) {
      ++n_left_out_;
      return;
    }
    const std::string name = stratum(load, answer, ice);
    Stratum& of = strata_[name];
    ++of.n;
    const std::size_t at = of.kept.size() < kKept ? of.kept.size() : random_() % of.n;
    if (at >= kKept) return;
    if (at == of.kept.size()) of.kept.emplace_back();
    testing::SheetReference recorded{answer.sigma_max / ice.flexural_strength, {answer.breaking_length, 0.0}, 0.0};
    of.kept[at] = {time, {name, ice, load, {{answer.split ? "recorded split" : "recorded whole", recorded}}}};
  }

  /// At most n sheets, one of each stratum in turn.
  std::vector<Solved> drawn(std::size_t n) const {
    std::vector<Solved> result;
    for (std::size_t round = 0; round < kKept; ++round) {
      for (const auto& [name, of] : strata_) {
        if (round >= of.kept.size() || result.size() == n) continue;
        const Solved& next = of.kept[round];
        const auto is_near = [&, &name = name](const Solved& other) {
          return other.sheet.name == name && std::abs(other.time - next.time) < kApart;
        };
        if (std::ranges::none_of(result, is_near)) result.push_back(next);
      }
    }
    std::ranges::stable_sort(result, {}, [](const Solved& one) { return std::pair(one.sheet.name, one.time); });
    return result;
  }

  void report() const {
    std::fprintf(stderr, "%zu verdicts; left out, without an edge or buckled: %zu\n", n_, n_left_out_);
    model::SheetSolves::visit(counts_, [](const char* name, const char*, const char*, int value) {
      std::fprintf(stderr, "  %s %d\n", name, value);
    });
    for (const auto& [name, of] : strata_) std::fprintf(stderr, "  %s: %zu\n", name.c_str(), of.n);
  }

 private:
  struct Stratum {
    std::size_t n = 0;
    std::vector<Solved> kept;
  };

  static std::string stratum(const LoadCase& load, const Assessment& answer, const failure::IceProperties& ice) {
    if (answer.outline_refused) return "unsolved";
    const bool is_disc = !load.loads.empty() && load.loads.front().radius > 0.0;
    const bool moves = load.motion.whole.length != 1.0 || load.motion.whole.stress != 1.0;
    const double ratio = answer.sigma_max / ice.flexural_strength;
    constexpr std::array<double, 3> kBounds{0.3, 0.7, 1.0};
    const auto level = std::ranges::count_if(kBounds, [&](double bound) { return ratio > bound; });
    return std::string(is_disc ? "disc"
                       : moves ? "moving"
                               : "resting") +
           (answer.solves.split > 0 ? "-radial-" : "-") +
           std::array{"far", "middle", "near", "above"}[static_cast<std::size_t>(level)];
  }

  std::mutex mutex_;
  std::mt19937_64 random_{20};
  std::size_t n_ = 0, n_left_out_ = 0;
  model::SheetSolves counts_;
  std::map<std::string, Stratum> strata_;
};

struct Recorder {
  Reservoir reservoir;
  double time = 0.0;
} recorder;

/// Passes everything on, and offers each sheet that was solved.
class RecordingCriterion final : public BendingCriterion {
 public:
  RecordingCriterion(std::unique_ptr<BendingCriterion> criterion, const failure::IceProperties& ice)
      : criterion_(std::move(criterion)), ice_(ice) {}

  Assessment assess(const LoadCase& load) const override {
    Assessment answer = criterion_->assess(load);
    if (answer.solves.coarse + answer.solves.cubic > 0 && load.pressure > 0.0)
      recorder.reservoir.offer(recorder.time, load, ice_, answer);
    return answer;
  }
  std::optional<Assessment> dismiss(const LoadCase& load) const override { return criterion_->dismiss(load); }
  bool above_range(const LoadCase& load) const override { return criterion_->above_range(load); }
  bool needs_outline() const override { return criterion_->needs_outline(); }
  std::optional<double> trained_thickness_over_lc() const override { return criterion_->trained_thickness_over_lc(); }
  std::optional<std::pair<double, double>> thickness_over_lc_range() const override {
    return criterion_->thickness_over_lc_range();
  }
  std::unique_ptr<BendingCriterion> for_ice(const failure::IceProperties& ice) const override {
    return std::make_unique<RecordingCriterion>(criterion_->for_ice(ice), ice);
  }

 private:
  std::unique_ptr<BendingCriterion> criterion_;
  failure::IceProperties ice_;
};

}  // namespace

// The linker's option --wrap leads each call of failure::make_criterion here; so the program needs no hook.
#define BRASH_MAKE_CRITERION                                                                         \
  "_ZN5brash7failure14make_criterionENS_5model12FailureModelERKNSt7__cxx1112basic_stringIcSt11char_" \
  "traitsIcESaIcEEERKNS0_13IcePropertiesERKNS0_14BendingOptionsE"
std::unique_ptr<BendingCriterion> real_make_criterion(
    model::FailureModel, const std::string&, const failure::IceProperties&,
    const failure::BendingOptions&) asm("__real_" BRASH_MAKE_CRITERION);
std::unique_ptr<BendingCriterion> recording_criterion(
    model::FailureModel, const std::string&, const failure::IceProperties&,
    const failure::BendingOptions&) asm("__wrap_" BRASH_MAKE_CRITERION);

std::unique_ptr<BendingCriterion> recording_criterion(model::FailureModel model, const std::string& file,
                                                      const failure::IceProperties& ice,
                                                      const failure::BendingOptions& options) {
  return std::make_unique<RecordingCriterion>(real_make_criterion(model, file, ice, options), ice);
}

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "Expected a case and a number of sheets: record_sheets CASE N [section.key=value ...]\n");
    return 1;
  }
  std::vector<std::string> overrides{"algorithm.preset=brash"};
  overrides.insert(overrides.end(), argv + 3, argv + argc);
  const model::Case resolved = io::read_case(argv[1], overrides);
  simulation::Simulation simulation(resolved);
  while (simulation.time() < resolved.time.duration - 1e-9) {
    recorder.time = simulation.time();
    (void)simulation.step();
  }
  recorder.reservoir.report();

  std::printf("# Case %s with", resolved.name.c_str());
  for (const std::string& override : overrides) std::printf(" %s", override.c_str());
  std::printf(".\n");
  std::map<std::string, int> numbers;
  bool has_ice = false;
  for (Solved& one : recorder.reservoir.drawn(static_cast<std::size_t>(std::atoi(argv[2])))) {
    if (!has_ice) testing::write_ice(stdout, one.sheet.ice);
    has_ice = true;
    one.sheet.name += "-" + std::to_string(++numbers[one.sheet.name]);
    testing::write_sheet(stdout, one.sheet);
  }
}
