// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/training/database.hpp"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"

namespace {

using namespace brash;
using namespace brash::training;
namespace fs = std::filesystem;

struct Folder {
  fs::path path = fs::temp_directory_path() / ("brash_database_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

constexpr const char* kPlan = R"(
[design]
geometries = 20
rows_per_geometry = 3
[range]
b_lc = { from = 0.0, to = 1.0, spacing = "quadratic" }
c_lc = { from = 0.1, to = 1.0, spacing = "logarithmic" }
theta_deg = { from = 20.0, to = 100.0 }
mu1 = { from = 0.1, to = 3.0, spacing = "logarithmic" }
mu2 = { from = -0.3, to = 0.3 }
thickness_over_lc = 0.1
[plate]
poisson_ratio = 0.3
)";

Plan plan_of(const std::string& text) {
  const Folder folder;
  const fs::path file = folder.path / "plan.toml";
  std::ofstream(file) << text;
  return read_plan(file);
}

/// kPlan with `from` replaced by `to` must be refused with a message that holds `wanted` and the line.
void expect_refusal(const std::string& from, const std::string& to, const std::string& wanted) {
  std::string text = kPlan;
  const auto at = text.find(from);
  BOOST_REQUIRE(at != std::string::npos);
  text.replace(at, from.size(), to);
  BOOST_CHECK_EXCEPTION(plan_of(text), InputError, [&](const InputError& error) {
    const std::string message = error.what();
    BOOST_TEST(message.find("plan.toml") != std::string::npos, message);
    BOOST_TEST(message.find(wanted) != std::string::npos, message);
    return true;
  });
}

std::string bytes_of(const fs::path& file) {
  std::stringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

BOOST_AUTO_TEST_CASE(a_plan_is_read_in_si) {
  const Plan plan = plan_of(kPlan);
  BOOST_TEST(plan.geometries == 20);
  BOOST_TEST(plan.theta.from == radians(20.0));
  BOOST_TEST(plan.thickness_over_lc.from == 0.1);
  BOOST_TEST(plan.thickness_over_lc.to == 0.1);
  BOOST_TEST((plan.c_lc.spacing == Spacing::kLogarithmic));
  BOOST_TEST((plan.theory == plate::Theory::kReissnerMindlin));
}

BOOST_AUTO_TEST_CASE(a_plan_with_a_mistake_is_refused_with_its_place) {
  expect_refusal("geometries = 20", "geometrys = 20", "`design.geometries` is missing");
  expect_refusal("rows_per_geometry = 3", "rows_per_geometry = 3\nrows = 4",
                 "plan.toml:5:8: `design.rows` is not known");
  expect_refusal("geometries = 20", "geometries = 2.5", "whole number");
  expect_refusal("from = 0.1, to = 1.0", "from = 2.0, to = 1.0", "`range.c_lc.to` is below");
  expect_refusal("from = 0.1, to = 1.0", "from = 0.1, too = 1.0", "`range.c_lc.to` is missing");
  expect_refusal("b_lc = { from = 0.0", "b_lc = { from = -1.0", "bays with linear spacing");
  expect_refusal("\"quadratic\"", "\"cubic\"", "`range.b_lc.spacing` = ");
  expect_refusal("to = 100.0", "to = 190.0", "= 190 is not allowed\n  allowed: a number from 0 to 170");
  expect_refusal("to = 100.0", "to = nan", "= nan is not allowed");
  expect_refusal("[plate]", "[plat]", "`plate` is missing");
  expect_refusal("geometries = 20", "geometries = ", "plan.toml:3");
  BOOST_CHECK_THROW(read_plan("/nonexistent/plan.toml"), InputError);
}

BOOST_AUTO_TEST_CASE(the_plan_that_comes_with_the_program_is_readable) {
  const Plan plan = read_plan(std::string(BRASH_SOURCE_DIR) + "/experiments/failure_database/plan.toml");
  BOOST_TEST(plan.b_lc.to == 2.0);
  BOOST_TEST(plan.theta.to == radians(150.0));
}

BOOST_AUTO_TEST_CASE(the_design_fills_its_box_reaches_its_ends_and_grows_at_its_end) {
  Plan plan = plan_of(kPlan);
  plan.geometries = 200;
  const auto points = design(plan);
  int at_edge = 0, low_c = 0;
  for (const DesignPoint& p : points) {
    BOOST_TEST((p.plate.depth >= 0.0 && p.plate.depth <= 1.0));
    BOOST_TEST((p.plate.contact_length >= 0.1 && p.plate.contact_length <= 1.0));
    BOOST_TEST(p.plate.thickness == 0.1);
    BOOST_TEST(p.loads.size() == 3u);
    for (const LoadPoint& load : p.loads) BOOST_TEST((load.mu1 >= 0.1 && load.mu1 <= 3.0 && std::abs(load.mu2) <= 0.3));
    at_edge += p.plate.depth == 0.0 ? 1 : 0;
    low_c += p.plate.contact_length < std::sqrt(0.1) ? 1 : 0;
  }
  // 6 % is folded onto the ends, half of it on b = 0; Sobol's discrepancy at 200 points is a few points.
  BOOST_TEST(std::abs(at_edge - 6) <= 3);
  BOOST_TEST(std::abs(low_c - 100) <= 5);

  plan.geometries = 50;
  const auto fewer = design(plan);
  for (std::size_t i = 0; i < fewer.size(); ++i) {
    BOOST_TEST(fewer[i].plate.depth == points[i].plate.depth);
    BOOST_TEST(fewer[i].loads[2].mu1 == points[i].loads[2].mu1);
  }
}

BOOST_AUTO_TEST_CASE(rows_are_what_the_plate_answers_and_survive_the_file) {
  const Folder folder;
  Plan plan = plan_of(kPlan);
  plan.geometries = 3;
  const fs::path file = folder.path / "data.nc";
  const Progress progress = build(plan, file);
  BOOST_TEST(progress.done == 3);
  BOOST_TEST(progress.failed == 0);
  const Database data = read_database(file);
  BOOST_TEST(data.plan == to_text(plan));
  BOOST_REQUIRE(data.records.size() == 3u);
  const auto points = design(plan);
  for (const Record& r : data.records) {
    const DesignPoint& point = points[static_cast<std::size_t>(r.geometry)];
    const auto profiles = plate::solve(point.plate, plan.mesh);
    BOOST_REQUIRE(profiles);
    BOOST_TEST(r.solved);
    BOOST_TEST(r.plate.depth == point.plate.depth);
    BOOST_TEST(r.profiles.n_elements == profiles->n_elements);
    BOOST_TEST(r.profiles.station == profiles->station);
    BOOST_REQUIRE(r.rows.size() == 3u);
    for (std::size_t i = 0; i < r.rows.size(); ++i) {
      const auto& load = point.loads[i];
      const plate::Response direct = plate::respond(*profiles, 0.1, load.mu1, load.mu2);
      const plate::Response stored = plate::respond(r.profiles, 0.1, load.mu1, load.mu2);
      BOOST_TEST(r.rows[i].load.mu2 == load.mu2);
      BOOST_TEST(r.rows[i].response.sigma_over_p == direct.sigma_over_p);
      BOOST_TEST(r.rows[i].response.lbreak_over_lc == direct.lbreak_over_lc);
      BOOST_TEST(stored.sigma_over_p == direct.sigma_over_p);
      BOOST_TEST(stored.sigma_root_over_p == direct.sigma_root_over_p);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_stopped_build_goes_on_and_ends_in_the_same_bytes) {
  const Folder folder;
  const Plan plan = plan_of(kPlan);
  const std::string whole = folder.path / "whole.nc", stopped = folder.path / "stopped.nc";
  BOOST_TEST(build(plan, whole).done == 20);

  const Progress first = build(plan, stopped, [](const Progress&) { return false; });
  BOOST_TEST(first.done == 16);
  BOOST_TEST(!fs::exists(stopped));
  // A kill in the middle of a write leaves such a file.
  std::ofstream(stopped + ".chunks/000016.nc.1.part") << "half";
  const Progress second = build(plan, stopped);
  BOOST_TEST(second.done == 20);
  BOOST_TEST(!fs::exists(stopped + ".chunks"));
  BOOST_TEST(bytes_of(stopped) == bytes_of(whole));

  std::set<int> geometries;
  for (const Record& r : read_database(stopped).records) geometries.insert(r.geometry);
  BOOST_TEST(geometries.size() == 20u);
  BOOST_TEST(*geometries.rbegin() == 19);
}

BOOST_AUTO_TEST_CASE(a_database_of_another_plan_is_neither_extended_nor_overwritten) {
  const Folder folder;
  Plan plan = plan_of(kPlan);
  plan.geometries = 2;
  const fs::path file = folder.path / "data.nc";
  build(plan, file);
  const std::string before = bytes_of(file);
  BOOST_TEST(build(plan, file).done == 2);  // the same plan: left alone
  plan.rows_per_geometry = 4;
  BOOST_CHECK_THROW(build(plan, file), InputError);
  BOOST_TEST(bytes_of(file) == before);
}

BOOST_AUTO_TEST_CASE(a_file_that_is_no_database_is_refused) {
  const Folder folder;
  std::ofstream(folder.path / "text.nc") << "not netCDF";
  BOOST_CHECK_THROW(read_database(folder.path / "text.nc"), InputError);
  BOOST_CHECK_THROW(read_database("/nonexistent.nc"), InputError);
}

}  // namespace
