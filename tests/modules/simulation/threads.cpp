// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brash/core/sha256.hpp"
#include "brash/io/case.hpp"
#include "brash/io/results.hpp"
#include "brash/simulation/run.hpp"

namespace {

using namespace brash;
namespace fs = std::filesystem;

/// The validation case, cut short: it sees dozens of breaks.
model::Case short_case() {
  return io::read_case(BRASH_SOURCE_DIR "/experiments/validation/second_reading.toml",
                       {"time.duration=5", "output.statistics_from=0"});
}

/// Of the files that a run leaves.
std::vector<std::string> hashes(const model::Case& resolved, const simulation::Run& run) {
  const fs::path folder = fs::temp_directory_path() / "brash-test-threads";
  fs::create_directories(folder);
  io::write_results(folder.string(), resolved, run.results);
  std::vector<std::string> all{sha256(simulation::to_json(run.summary))};
  for (const char* const name : {"history.csv", "events.csv", "run.nc"})
    all.push_back(sha256_of_file((folder / name).string()));
  fs::remove_all(folder);
  return all;
}

/// Runs on `first` threads until it is killed after `steps`, then on `second`.
simulation::Run run_in_two(const model::Case& resolved, int first, int second, int steps) {
  std::optional<model::Checkpoint> kept;
  const simulation::CheckpointStore store{
      .name = "memory", .keep = [&](const model::Checkpoint& c) { kept = c; }, .newest = [&] { return kept; }};
  int done = 0;
  const simulation::Run killed = simulation::run(
      resolved, {.checkpoint = store, .interrupted = [&] { return ++done == steps; }, .threads = first});
  BOOST_TEST(!killed.complete);
  return simulation::run(resolved, {.checkpoint = store, .threads = second});
}

BOOST_AUTO_TEST_CASE(no_byte_of_a_run_depends_on_the_number_of_threads) {
  const model::Case resolved = short_case();
  const simulation::Run alone = simulation::run(resolved);
  BOOST_TEST(alone.summary.n_breaks > 5);
  const std::vector<std::string> expected = hashes(resolved, alone);
  for (const int threads : {2, 3, 8}) {
    const simulation::Run run = simulation::run(resolved, {.threads = threads});
    BOOST_TEST(run.threads == threads);
    BOOST_TEST(hashes(resolved, run) == expected, boost::test_tools::per_element());
  }
}

/// Where several contacts are judged in a step, each by a solution of the sheet.
BOOST_AUTO_TEST_CASE(no_byte_depends_on_the_threads_that_solve_sheets) {
  const model::Case resolved = io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml",
                                             {"algorithm.preset=brash", "time.duration=8"});
  const simulation::Run alone = simulation::run(resolved);
  BOOST_TEST(alone.summary.breaks.true_edge > 5);
  const std::vector<std::string> expected = hashes(resolved, alone);
  for (const int threads : {2, 3})
    BOOST_TEST(hashes(resolved, simulation::run(resolved, {.threads = threads})) == expected,
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_killed_run_goes_on_with_another_number_of_threads_to_the_same_bytes) {
  const model::Case resolved = short_case();
  const std::vector<std::string> expected = hashes(resolved, simulation::run(resolved));
  for (const auto& [first, second] : {std::pair{1, 3}, {8, 2}})
    BOOST_TEST(hashes(resolved, run_in_two(resolved, first, second, 333)) == expected,
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_run_that_is_interrupted_inside_a_step_goes_on_from_before_it_to_the_same_bytes) {
  const model::Case resolved = short_case();
  std::optional<model::Checkpoint> kept;
  const simulation::CheckpointStore store{
      .name = "memory", .keep = [&](const model::Checkpoint& c) { kept = c; }, .newest = [&] { return kept; }};
  std::size_t n_steps = 0, asked_after = 0;
  const simulation::Run stopped = simulation::run(
      resolved, {.observer = [&](const auto&, const auto&) { ++n_steps; },
                 .checkpoint = store,
                 .interrupted =
                     [&] {  // the first question after a step comes between two steps, each further one inside the next
                       return std::exchange(asked_after, n_steps) == n_steps && n_steps > 0;
                     },
                 .threads = 2});
  BOOST_TEST(!stopped.complete);
  BOOST_TEST_REQUIRE(kept.has_value());
  BOOST_TEST(kept->results.loads.size() == n_steps);
  BOOST_TEST(
      hashes(resolved, simulation::run(resolved, {.checkpoint = store})) == hashes(resolved, simulation::run(resolved)),
      boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_run_is_interrupted_while_its_ice_is_laid) {
  const model::Case resolved =
      io::read_case(BRASH_SOURCE_DIR "/experiments/fields/cone.toml", {"field.size.least=0.5", "field.size.largest=2"});
  bool began = false;
  const simulation::Run stopped =
      simulation::run(resolved, {.begun = [&] { began = true; }, .interrupted = [] { return true; }});
  BOOST_TEST(!stopped.complete);
  BOOST_TEST(!began);
}

}  // namespace
