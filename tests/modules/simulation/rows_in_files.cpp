// SPDX-License-Identifier: GPL-3.0-or-later
// Long runs, whose earlier rows are in files beside the checkpoint.
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/core/sha256.hpp"
#include "brash/io/case.hpp"
#include "brash/io/results.hpp"
#include "brash/recording/recording.hpp"
#include "brash/simulation/run.hpp"

namespace {

using namespace brash;
namespace fs = std::filesystem;

/// Two legs: their columns are in the history from the first touch on, and the first file of rows has none.
model::Case two_legs() {
  return io::parse_case(
      "[algorithm]\npreset = \"paper\"\n"
      "[ice]\nthickness = 0.33\nyoungs_modulus = 0.35e9\nflexural_strength = 539e3\n"
      "[structure]\nangle = \"61.4 deg\"\nwaterline_width = 6\nheight = 6\nheight_under_water = 4\n"
      "legs = [[0, -12], [0, 12]]\nspeed = 1.2\nstart_distance = 5\n"
      "[field]\nlength = 50\nwidth = 90\ninitial_crack = false\n[failure]\nmodel = \"wedge\"\n"
      "[contact]\nengine = \"brash\"\n"  // it resumes to the bit
      "[time]\nduration = 6\n",
      "legs.toml", {});
}

/// A folder of the test's own.
class Folder {
 public:
  explicit Folder(const std::string& name) : path_(fs::temp_directory_path() / ("brash-test-" + name)) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string path(const std::string& name) const { return (path_ / name).string(); }
  std::string checkpoint() const { return path("checkpoint.nc"); }

 private:
  fs::path path_;
};

/// Hashes of the files that a run leaves, and its summary.
std::map<std::string, std::string> results_of(const simulation::Run& run, const Folder& folder) {
  io::write_results(folder.path("results"), two_legs(), run.results, run.earlier);
  std::map<std::string, std::string> all{{"summary", simulation::to_json(run.summary)}};
  for (const char* const name : {"history.csv", "events.csv", "run.nc"})
    all[name] = sha256_of_file(folder.path("results/" + std::string(name)));
  return all;
}

constexpr std::size_t kFewBytes = 100'000;  // some sixty rows of the loads

BOOST_AUTO_TEST_SUITE(rows_in_files)

BOOST_AUTO_TEST_CASE(rows_in_files_leave_the_bytes_of_rows_in_memory) {
  const Folder folder("rows");
  const simulation::Run whole = simulation::run(two_legs());
  BOOST_TEST(whole.summary.n_breaks > 2);
  const simulation::Run in_files = simulation::run(
      two_legs(),
      {.checkpoint = recording::checkpoint_file(folder.checkpoint(), false), .most_bytes_in_memory = kFewBytes});
  BOOST_TEST(in_files.earlier.size() > 5u);
  BOOST_TEST(in_files.results.loads.size() < 100u);
  BOOST_TEST((results_of(in_files, folder) == results_of(whole, folder)));
}

/// Runs with an end after each of `moments`, and then to the end.
simulation::Run interrupted(const Folder& folder, std::vector<double> moments, recording::Rows rows_at_the_end) {
  for (const double moment : moments) {
    double now = 0.0;
    const simulation::Run stopped = simulation::run(
        two_legs(),
        {.observer = [&](const simulation::Simulation& s, const simulation::StepReport&) { now = s.time(); },
         .checkpoint = recording::checkpoint_file(folder.checkpoint(), true),
         .interrupted = [&] { return now >= moment; },
         .most_bytes_in_memory = kFewBytes});
    BOOST_TEST(!stopped.complete);
  }
  return simulation::run(two_legs(),
                         {.checkpoint = recording::checkpoint_file(folder.checkpoint(), true, rows_at_the_end),
                          .most_bytes_in_memory = kFewBytes});
}

BOOST_AUTO_TEST_CASE(a_resumed_run_with_rows_in_files_leaves_the_bytes_of_the_whole_one) {
  const Folder folder("resumed-rows");
  const simulation::Run whole = simulation::run(two_legs());
  const simulation::Run resumed = interrupted(folder, {1.0, 3.3, 4.7}, recording::Rows::kInFiles);
  BOOST_TEST((results_of(resumed, folder) == results_of(whole, folder)));
}

BOOST_AUTO_TEST_CASE(a_run_in_memory_continues_one_with_rows_in_files) {
  const Folder folder("rows-to-memory");
  const simulation::Run whole = simulation::run(two_legs());
  const simulation::Run resumed = interrupted(folder, {3.3}, recording::Rows::kInMemory);
  BOOST_TEST(resumed.earlier.empty());
  BOOST_TEST((resumed.results == whole.results));
}

BOOST_AUTO_TEST_CASE(rows_that_are_missing_damaged_or_of_another_run_are_refused) {
  const Folder folder("bad-rows");
  interrupted(folder, {3.3}, recording::Rows::kInFiles);
  const std::vector<std::string> files = recording::files_of_rows(folder.checkpoint());
  BOOST_REQUIRE(files.size() > 3u);
  const auto continue_run = [&] {
    simulation::run(two_legs(), {.checkpoint = recording::checkpoint_file(folder.checkpoint(), true)});
  };
  const auto says = [](const std::string& words) {
    return [words](const InputError& error) { return std::string(error.what()).find(words) != std::string::npos; };
  };
  const std::string first = folder.path("checkpoint.rows-0001.nc"), second = folder.path("checkpoint.rows-0002.nc");
  fs::rename(first, folder.path("kept"));
  BOOST_CHECK_EXCEPTION(continue_run(), InputError, says("checkpoint.rows-0001.nc: cannot be opened"));
  fs::copy_file(second, first);
  BOOST_CHECK_EXCEPTION(continue_run(), InputError, says("checkpoint.rows-0001.nc: holds rows of another run"));
  fs::resize_file(first, fs::file_size(first) - 1);
  BOOST_CHECK_EXCEPTION(continue_run(), InputError, says("checkpoint.rows-0001.nc: is not a checkpoint, or was cut"));
  fs::remove(first);
  fs::rename(folder.path("kept"), first);
  BOOST_CHECK_NO_THROW(continue_run());
}

BOOST_AUTO_TEST_CASE(a_checkpoint_is_moved_and_removed_with_its_rows) {
  const Folder folder("moved-rows");
  interrupted(folder, {1.0}, recording::Rows::kInFiles);
  const std::string moved = folder.path("case.failed.nc");
  const std::size_t n_files = recording::files_of_rows(folder.checkpoint()).size();
  BOOST_TEST(!recording::move_checkpoint(folder.checkpoint(), moved));
  BOOST_TEST(recording::files_of_rows(folder.checkpoint()).empty());
  BOOST_TEST(recording::files_of_rows(moved).size() == n_files);
  const simulation::Run again = simulation::run(two_legs(), {.checkpoint = recording::checkpoint_file(moved, true)});
  BOOST_TEST(again.complete);
  recording::remove_checkpoint(moved);
  BOOST_TEST(fs::is_empty(folder.path("")));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
