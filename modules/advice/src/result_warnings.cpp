// SPDX-License-Identifier: GPL-3.0-or-later
// Results that cannot support their use.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "brash/advice/advice.hpp"
#include "brash/simulation/warnings.hpp"
#include "case_warnings.hpp"

namespace brash::advice {

using simulation::kFewSamples;
using simulation::LoadsSeen;
using simulation::RunSummary;

namespace {

/// A measured mean in another unit is off by a thousand; a model is not off by this much.
constexpr double kFarFromReference = 50.0;

void add_reference_warning(const RunSummary& s, const model::ReferenceSection& reference, Warnings& warnings) {
  if (!reference.mean_horizontal || std::isnan(s.horizontal.mean)) return;
  const double ours = std::abs(s.horizontal.mean), theirs = std::abs(*reference.mean_horizontal);
  if (theirs < kFarFromReference * ours && ours < kFarFromReference * theirs) return;
  warnings.push_back(
      {"far-from-reference",
       fmt::format("the mean horizontal load is {:.3g} N, and reference.mean_horizontal = {:.4g} N: a bare "
                   "number is in N; was another unit meant, such as \"{:.4g} kN\"?",
                   s.horizontal.mean, *reference.mean_horizontal, *reference.mean_horizontal)});
}

void add_unsettled_warning(const RunSummary& s, std::size_t n_steps, Warnings& warnings) {
  if (2 * static_cast<std::size_t>(s.n_unsettled_steps) <= n_steps) return;
  warnings.push_back(
      {"unsettled-contacts",
       fmt::format(
           "the contacts of {} of {} steps are not settled: their last sweep changes a relative velocity by more "
           "than 8e-5 m/s and 3 % of the speed of structure and water against each other, by {:.2g} m/s in the "
           "mean step, so floes may sink into each other and loads be too low; raise contact.iterations, or shorten "
           "time.step",
           s.n_unsettled_steps, n_steps, s.mean_last_change)});
}

/// A ship's resistance is steady when the ice under its bottom is.
void add_coverage_warning(const LoadsSeen& loads, Warnings& warnings) {
  constexpr double kSteady = 0.05;  // of the bottom
  const auto [first, second] = loads.covered();
  if (!(second - first > kSteady)) return;
  warnings.push_back(
      {"filling-hull", fmt::format("floes cover {:.0f} % of the hull's bottom in the first half of the statistics and "
                                   "{:.0f} % in the second: the resistance is not steady yet; run longer, and raise "
                                   "output.statistics_from",
                                   100.0 * first, 100.0 * second)});
}

/// Floes that are crushed leave the run, and pieces too small for a floe become brash.
void add_deletion_warning(const geometry::Ledger& ledger, Warnings& warnings) {
  constexpr double kMost = 0.5;  // of the ice that broke off: more of it has gone than floats
  const double deleted = ledger.deleted.square_metres(), brash = ledger.brash.square_metres();
  const double broken = deleted + brash + ledger.floes.square_metres();
  if (!(deleted + brash > kMost * broken)) return;
  warnings.push_back(
      {"deleted-ice",
       fmt::format(
           "{:.0f} % of the ice that broke off is no longer there: {:.3g} m2 left with crushed floes, and {:.3g} m2 "
           "became brash. It loads the structure no more, so loads may be too low; compare with "
           "contact.floe_stress = \"averaged\" and crushing_bound = \"all\", or lower failure.smallest_floe",
           100.0 * (deleted + brash) / broken, deleted, brash)});
}

std::string no_load_text(std::optional<double> last, double statistics_from) {
  constexpr const char* kCheck = "check the structure's course, its distance at the start, and where the ice lies";
  if (!last) return fmt::format("no ice touched the structure in the whole run: {}", kCheck);
  return fmt::format(
      "no ice touched the structure after {:.3g} s, and the statistics begin at {:.3g} s: {}, or lower "
      "output.statistics_from",
      *last, statistics_from, kCheck);
}

}  // namespace

Warnings warnings_of(const RunSummary& s, const LoadsSeen& loads, const model::ReferenceSection& reference) {
  Warnings warnings;
  const std::optional<double> last = loads.last_load();
  const bool no_load = !last || (!std::isnan(s.horizontal.mean) && *last <= s.window.from);
  if (no_load) warnings.push_back({"no-load", no_load_text(last, s.window.from)});
  if (s.n_breaks == 0 && !s.initial_floes && last)  // the loads of a field are of its floes
    warnings.push_back({"no-breaks",
                        "the ice has not broken in this run: the loads are of crushing and floes alone; "
                        "run longer, or check the strengths of the ice"});
  if (!no_load && s.horizontal.effective_sample_size < kFewSamples && !std::isnan(s.horizontal.mean))
    warnings.push_back(
        {"few-samples",
         fmt::format("the load has {:.1f} independent samples from {:.3g} s on, expected {:.0f} or more: "
                     "its interval means nothing; run longer, or take more replicates",
                     s.horizontal.effective_sample_size, s.window.from, kFewSamples)});
  if (!no_load) add_reference_warning(s, reference, warnings);
  add_unsettled_warning(s, loads.n_steps(), warnings);
  add_coverage_warning(loads, warnings);
  add_deletion_warning(s.ledger, warnings);
  return warnings;
}

}  // namespace brash::advice
