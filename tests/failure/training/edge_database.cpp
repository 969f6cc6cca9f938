// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/training/edge_database.hpp"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"

namespace {

using namespace brash;
using namespace brash::training;
namespace fs = std::filesystem;

struct Folder {
  fs::path path = fs::temp_directory_path() / ("brash_edge_database_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

/// Coarse enough for a test.
constexpr const char* kPlan = R"(
[edge]
b_lc = [0.0, 0.3]
c_lc = [0.4, 0.8, 1.6]
theta_deg = [30, 60]
thickness_over_lc = [0.1]
[solver]
scale = 2.5
vectors = 20
)";

EdgePlan plan_of(const std::string& text) {
  const Folder folder;
  const fs::path file = folder.path / "plan.toml";
  std::ofstream(file) << text;
  return read_edge_plan(file);
}

std::string bytes_of(const fs::path& file) {
  std::stringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

BOOST_AUTO_TEST_CASE(a_straight_edge_is_designed_once_for_all_angles) {
  const EdgePlan plan = plan_of(kPlan);
  const auto geometries = design(plan);
  BOOST_TEST(geometries.size() == 9u);  // 3 straight ones, 2 angles of 3 protrusions
  BOOST_TEST(geometries[0].depth == 0.0);
  BOOST_TEST(geometries[3].angle == radians(30.0));
  BOOST_TEST(geometries[8].contact_length == 1.6);
  BOOST_TEST(geometries[8].mass_ratio == 0.88 * 0.1);
}

BOOST_AUTO_TEST_CASE(a_list_that_does_not_rise_and_an_unknown_key_are_refused) {
  std::string falls = kPlan, unknown = kPlan;
  falls.replace(falls.find("0.4, 0.8"), 8, "0.8, 0.4");
  unknown.replace(unknown.find("vectors"), 7, "vectorz");
  BOOST_CHECK_EXCEPTION(plan_of(falls), InputError, [](const InputError& error) {
    return std::string(error.what()).find("`edge.c_lc` has 0.4") != std::string::npos;
  });
  BOOST_CHECK_EXCEPTION(plan_of(unknown), InputError, [](const InputError& error) {
    return std::string(error.what()).find("`solver.vectorz` is not known") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(a_stopped_build_goes_on_to_the_same_bytes) {
  const Folder folder;
  const EdgePlan plan = plan_of(kPlan);
  const std::string whole = (folder.path / "whole.nc").string(), stopped = (folder.path / "stopped.nc").string();
  const Progress all = build(plan, whole);
  BOOST_TEST(all.done == 9);
  BOOST_TEST(all.failed == 0);
  const Progress some = build(plan, stopped, [](const Progress& progress) { return progress.done < 4; });
  BOOST_TEST(some.done == 4);
  BOOST_TEST(!fs::exists(stopped));
  BOOST_TEST(missing_chunks(plan, stopped).size() == 2u);
  solve_chunk(plan, stopped, 4);
  build(plan, stopped);
  BOOST_TEST((bytes_of(stopped) == bytes_of(whole)));
  BOOST_TEST(is_edge_database(whole));

  const EdgeDatabase read = read_edge_database(whole);
  BOOST_TEST(read.records.size() == 9u);
  for (const EdgeRecord& record : read.records) {
    BOOST_TEST(record.solved);
    const plate::EdgeResponses& r = record.responses;
    BOOST_TEST(r.axis_moment.size() == r.time.size() * r.station.size());
    BOOST_TEST(r.static_deflection > 0.0);
  }
  EdgePlan other = plan;
  other.density_ratio = 0.9;
  BOOST_CHECK_THROW(build(other, whole), InputError);
}

}  // namespace
