// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/resource.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "brash/core/error.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/version.hpp"
#include "brash/io/case.hpp"
#include "brash/io/checkpoint.hpp"
#include "brash/io/result_pieces.hpp"
#include "brash/io/results.hpp"
#include "netcdf_file.hpp"
#include "sample_results.hpp"
#include "scratch.hpp"

using namespace brash;
using namespace brash::io;
using namespace brash::model;

namespace {

const std::string kSource = BRASH_SOURCE_DIR;

Case validation() { return read_case(kSource + "/experiments/validation/cone.toml"); }

std::vector<std::string> lines_of(const std::string& path) {
  std::istringstream stream(read_bytes(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::size_t n_files(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

/// The message that `action` fails with while no file may grow beyond `n_bytes`: a stand-in for a full disk.
template <typename Error, typename Action>
std::string message_on_full_disk(rlim_t n_bytes, Action action) {
  rlimit before{};
  BOOST_REQUIRE(::getrlimit(RLIMIT_FSIZE, &before) == 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{n_bytes, before.rlim_max};
  BOOST_REQUIRE(::setrlimit(RLIMIT_FSIZE, &small) == 0);
  std::string message;
  try {
    action();
  } catch (const Error& error) {
    message = error.what();
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  return message;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(results)

BOOST_AUTO_TEST_CASE(what_is_written_reads_back_bit_for_bit) {
  const Scratch scratch;
  const RunResults written = sample_results();
  write_results(scratch.folder().string(), validation(), written);
  const RunResults read = read_results(scratch.path("run.nc"));
  BOOST_TEST((read == written));
  BOOST_TEST(std::signbit(read.loads[0].total.moment.z));
}

BOOST_AUTO_TEST_CASE(a_run_in_which_nothing_happened_is_written_too) {
  const Scratch scratch;
  write_results(scratch.folder().string(), validation(), {});
  BOOST_TEST((read_results(scratch.path("run.nc")) == RunResults{}));
  BOOST_TEST(lines_of(scratch.path("history.csv")).size() == 1u);
  BOOST_TEST(lines_of(scratch.path("events.csv")).size() == 1u);
}

/// Results with a replay of floes at rest.
RunResults results_of_replay(std::size_t n_frames, std::size_t n_floes) {
  RunResults results = sample_results();
  Frame frame = results.frames.at(0);
  for (std::size_t i = 0; i < n_floes; ++i) {
    const double digits = std::sqrt(static_cast<double>(i + 2));
    frame.floes.push_back({.floe = 0,
                           .pose = {{digits, 3.0 * digits, 5.0 * digits}, {0.6, 0.0, 0.0, 0.8}},
                           .contact_force = 1e3 * digits});
  }
  results.frames.assign(n_frames, frame);
  return results;
}

// Each pose has a whole number and eight others.
constexpr double kBytesOfPose = 9.0 * sizeof(double);

BOOST_AUTO_TEST_CASE(a_long_replay_of_floes_at_rest_takes_little_room) {
  const Scratch scratch;
  constexpr std::size_t kFrames = 2000, kFloes = 50;
  const RunResults results = results_of_replay(kFrames, kFloes);
  write_results(scratch.folder().string(), validation(), results);
  BOOST_TEST(static_cast<double>(std::filesystem::file_size(scratch.path("run.nc"))) <
             0.05 * kBytesOfPose * kFrames * kFloes);
  BOOST_TEST((read_results(scratch.path("run.nc")) == results));
}

BOOST_AUTO_TEST_CASE(long_results_have_the_same_bytes_wherever_their_earlier_rows_part) {
  RunResults all = results_of_replay(3000, 250);  // columns of 6 MB, which are written in pieces
  all.loads.resize(3000, all.loads.empty() ? LoadRow{} : all.loads.back());
  for (std::size_t i = 0; i < all.loads.size(); ++i) all.loads[i].time = 0.01 * static_cast<double>(i + 1);
  const Scratch whole, parted;
  write_results(whole.folder().string(), validation(), all);
  std::vector<std::string> earlier;
  RunResults last = all;
  for (const std::size_t n_frames : {700UL, 1100UL}) {
    RunResults part;
    const auto n = static_cast<std::ptrdiff_t>(n_frames);
    part.frames.assign(last.frames.begin(), last.frames.begin() + n);
    part.loads.assign(last.loads.begin(), last.loads.begin() + n);
    last.frames.erase(last.frames.begin(), last.frames.begin() + n);
    last.loads.erase(last.loads.begin(), last.loads.begin() + n);
    earlier.push_back(parted.path("rows-" + std::to_string(n_frames) + ".nc"));
    write_earlier_rows(earlier.back(), part);
  }
  write_results(parted.folder().string(), validation(), last, earlier);
  BOOST_TEST((read_bytes(whole.path("run.nc")) == read_bytes(parted.path("run.nc"))));
  BOOST_TEST((read_results(parted.path("run.nc")) == all));
}

BOOST_AUTO_TEST_CASE(long_results_are_read_piece_by_piece) {
  const Scratch scratch;
  RunResults results = results_of_replay(2000, 50);
  results.loads.resize(50000, results.loads.empty() ? LoadRow{} : results.loads.back());
  for (std::size_t i = 0; i < results.loads.size(); ++i) results.loads[i].time = 0.01 * static_cast<double>(i + 1);
  write_results(scratch.folder().string(), validation(), results);
  std::vector<LoadRow> loads;
  std::vector<Frame> frames;
  std::size_t n_pieces = 0;
  RunResults read = read_results(scratch.path("run.nc"), {.loads =
                                                              [&](std::vector<LoadRow>&& rows, std::size_t n) {
                                                                ++n_pieces;
                                                                BOOST_TEST(n == results.loads.size());
                                                                loads.insert(loads.end(), rows.begin(), rows.end());
                                                              },
                                                          .frame = [&](Frame&& next) { frames.push_back(next); }});
  BOOST_TEST(n_pieces > 2U);
  BOOST_TEST(read.loads.empty());
  BOOST_TEST(read.frames.empty());
  read.loads = loads;
  read.frames = frames;
  BOOST_TEST((read == results));
}

/// The most memory that the process has held [bytes].
double peak_memory() {
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

BOOST_AUTO_TEST_CASE(results_and_states_are_written_without_copies_in_memory) {
  const Scratch scratch;
  constexpr std::size_t kFrames = 2000, kFloes = 200;
  const RunResults results = results_of_replay(kFrames, kFloes);
  const double bytes = kBytesOfPose * kFrames * kFloes;
  write_results(scratch.folder().string(), validation(), {});  // the library takes some memory once
  const double before = peak_memory();
  write_results(scratch.folder().string(), validation(), results);
  write_checkpoint(scratch.path("checkpoint.nc"), validation(), {}, results);
  // HDF5 keeps the columns that it deflates until the file is whole. Two copies of the poses came on top of that.
  BOOST_TEST(peak_memory() - before < 1.5 * bytes);
  BOOST_TEST((read_checkpoint(scratch.path("checkpoint.nc")).results == results));
}

BOOST_AUTO_TEST_CASE(the_outline_of_a_second_sheet_is_no_hole) {
  const Scratch scratch;
  RunResults results = sample_results();
  const std::vector<Vec2> far{{60, -25}, {70, -25}, {70, 25}, {60, 25}};
  const std::vector<Vec2> hole_of_far{{64, -1}, {64, 1}, {66, 1}};
  results.cracked_sheets.at(1).rings.push_back(far);
  results.cracked_sheets.at(1).rings.push_back(hole_of_far);
  write_results(scratch.folder().string(), validation(), results);
  std::vector<std::int32_t> interior;
  NetcdfReader(scratch.path("run.nc"))
      .read("cracked_sheet_outline_interior_ring", "cracked_sheet_outline_part", interior);
  // The first sheet has an outline; the second an outline and its hole, and another outline and its hole.
  const std::vector<std::int32_t> expected{0, 0, 1, 0, 1};
  BOOST_TEST(interior == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(two_writes_give_the_same_bytes) {
  const Scratch scratch;
  write_results(scratch.path("a"), validation(), sample_results());
  // HDF5 stamps objects with whole seconds unless told not to.
  ::usleep(1'100'000);
  write_results(scratch.path("b"), validation(), sample_results());
  for (const char* name : {"run.nc", "history.csv", "events.csv"})
    BOOST_TEST(read_bytes(scratch.path(std::string("a/") + name)) == read_bytes(scratch.path(std::string("b/") + name)),
               name);
  BOOST_TEST(n_files(scratch.folder() / "a") == 3u);
}

BOOST_AUTO_TEST_CASE(the_load_history_has_a_line_a_step) {
  const Scratch scratch;
  write_results(scratch.folder().string(), validation(), sample_results());
  const std::vector<std::string> lines = lines_of(scratch.path("history.csv"));
  BOOST_REQUIRE(lines.size() == 6u);
  BOOST_TEST(
      lines[0] ==
      "time,Fx,Fy,Fz,Mx,My,Mz,crushing_Fx,crushing_Fy,crushing_Fz,crushing_Mx,crushing_My,crushing_Mz,"
      "floe_normal_Fx,floe_normal_Fy,floe_normal_Fz,floe_normal_Mx,floe_normal_My,floe_normal_Mz,"
      "floe_friction_Fx,floe_friction_Fy,floe_friction_Fz,floe_friction_Mx,floe_friction_My,floe_friction_Mz,"
      "kinetic_energy,potential_energy,work,birth_energy,removed_energy,loss_edge,loss_bending,loss_structure_contact,"
      "loss_structure_friction,loss_sheet_contact,loss_sheet_friction,loss_floe_contact,loss_floe_friction,"
      "loss_drag,loss_skin_friction,energy_error,area_sheet,area_floes,area_crushed,area_deleted,"
      "area_brash,area_snap,n_floes,n_contacts,structure_x,structure_y,structure_vx,structure_vy");
  BOOST_TEST(lines[1] ==
             "0.01,0.3333333333333333,-2.5,100000,0.1,0.2,-0,0.1,0.2,0.3,1,2,3,1.1,1.2,1.3,4,5,6,2.1,2.2,2.3,7,8,9,"
             "12.5,0.25,1000,0.125,0.5,1.5,2.5,3.5,4.5,5.5,6.5,7.5,-8.5,9.5,10.5,-0.001,2499,1,1e-09,0.5,0.03,-1e-18,1,"
             "2,-6.5,0.25,1.5,-0.125");
}

BOOST_AUTO_TEST_CASE(events_have_breaks_and_the_ends_of_floes_in_the_order_of_time) {
  const Scratch scratch;
  write_results(scratch.folder().string(), validation(), sample_results());
  const std::vector<std::string> lines = lines_of(scratch.path("events.csv"));
  BOOST_REQUIRE(lines.size() == 5u);
  BOOST_TEST(lines[0] ==
             "time,x,y,b,c,theta,mu1,mu2,p,sigma_max,l_break,wedges,in_range,substeps,area_before,area_after,fit_error,"
             "pieces,tip_x,tip_y,towards_x,towards_y,pressing_floe,t_break,w_edge,thickness,"
             "flexural_strength,overload,event,cause,floe,floe_area,peak_stress");
  BOOST_TEST(
      lines[1] ==
      "0.02,0.1,-0.2,0.5,0.3,1.0471975511965976,0.511,0.027,500000,540000,1.7,4,1,2,2499,2495.5,0.011,5,0.2,-0.2,"
      "0.6,-0.8,-1,0.25,0.0625,0.375,490000,1.0625,break,,,,");
  BOOST_TEST(lines[2] == "0.03,,,,,,,,,,,,,,,,,,,,,,,,,,,,deleted,crushed,1,0.5,1250000");
  BOOST_TEST(lines[3].starts_with("0.04,0.1,"));
  BOOST_TEST(lines[4] == "0.04,,,,,,,,,,,,,,,,,,,,,,,,,,,,broken,bending,7,4,0");
}

BOOST_AUTO_TEST_CASE(a_split_of_a_sheet_is_an_event_and_is_read_again) {
  const Scratch scratch;
  RunResults results = sample_results();
  results.splits.push_back({0.03, {1.5, -2.0}, {1.0, 0.0}, 40.0, 30.0, 5e5, 1e5, 2e5, 0.375, 2495.5, 1200.25, 2});
  write_results(scratch.folder().string(), validation(), results);
  BOOST_TEST((read_results(scratch.path("run.nc")) == results));
  const std::vector<std::string> lines = lines_of(scratch.path("events.csv"));
  BOOST_REQUIRE(lines.size() == 6u);
  BOOST_TEST(lines[2] == "0.03,1.5,-2,,,,,,,,,,,,2495.5,1200.25,,2,,,1,0,,,,0.375,,,split,toughness,,,");
}

BOOST_AUTO_TEST_CASE(a_full_disk_leaves_no_file_under_its_name) {
  for (const rlim_t n_bytes : {0u, 2000u, 20000u}) {
    const Scratch scratch;
    const Case resolved = validation();
    const RunResults results = sample_results();
    const std::string message =
        message_on_full_disk<RunError>(n_bytes, [&] { write_results(scratch.folder().string(), resolved, results); });
    BOOST_TEST(message.find("run.nc: ") != std::string::npos, message);
    BOOST_TEST(message.find("remedy") != std::string::npos, message);
    BOOST_TEST(n_files(scratch.folder()) == 0u);
  }
}

BOOST_AUTO_TEST_CASE(a_file_that_is_no_run_is_refused) {
  const Scratch scratch;
  const auto names = [](const std::string& part) {
    return [part](const InputError& error) { return std::string(error.what()).find(part) != std::string::npos; };
  };
  BOOST_CHECK_EXCEPTION(read_results(scratch.path("none.nc")), InputError, names("none.nc: cannot be read"));
  BOOST_CHECK_EXCEPTION(read_results(scratch.write("a.nc", "text")), InputError, names("a.nc: "));
  // A run cut short in the middle.
  write_results(scratch.folder().string(), validation(), sample_results());
  const std::string bytes = read_bytes(scratch.path("run.nc"));
  BOOST_CHECK_EXCEPTION(read_results(scratch.write("half.nc", bytes.substr(0, bytes.size() / 2))), InputError,
                        names("half.nc: "));
}

BOOST_AUTO_TEST_CASE(xarray_reads_the_run_as_documented) {
  const Scratch scratch;
  write_results(scratch.folder().string(), validation(), sample_results());
  const std::string command =
      "/usr/bin/python3 '" + kSource + "/tests/modules/io/open_with_xarray.py' '" + scratch.path("run.nc") + "'";
  BOOST_TEST(std::system(command.c_str()) == 0);
}

BOOST_AUTO_TEST_CASE(the_manifest_says_what_repeats_the_run) {
  const Scratch scratch;
  const Case resolved = validation();
  const std::string input = scratch.write("abc.txt", "abc");
  write_results(scratch.path("out"), resolved, sample_results());
  write_manifest(scratch.path("out"), resolved, {{input, sha256_of_file(input), 3, "inputs/input"}},
                 {"run.nc", "history.csv"}, {"2026-01-01T00:00:00Z", 1.5, ""});
  const auto manifest = nlohmann::json::parse(read_bytes(scratch.path("out/manifest.json")));
  BOOST_TEST(manifest["program"]["version"] == kVersion);
  BOOST_TEST(manifest["program"]["file"] == "test_io_unit");
  BOOST_TEST(manifest["built_with"].contains("compiler"));
  BOOST_TEST(manifest["built_with"].contains("CGAL"));
  BOOST_TEST(!manifest["glibc"].get<std::string>().empty());
  BOOST_TEST(manifest["seeds"]["seed"] == 1);
  // The SHA-256 of "abc" as in FIPS 180-2, appendix B.1.
  BOOST_TEST(manifest["inputs"][0]["sha256"] == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  BOOST_TEST(manifest["inputs"][0]["path"] == input);
  BOOST_TEST(manifest["inputs"][0]["bytes"] == 3);
  BOOST_TEST(manifest["inputs"][0]["copy"] == "inputs/input");
  BOOST_TEST(manifest["outputs"][1]["path"] == "history.csv");
  BOOST_TEST(manifest["outputs"][0]["sha256"] == sha256_of_file(scratch.path("out/run.nc")));
  BOOST_TEST(manifest["volatile"]["wall_seconds"] == 1.5);
  BOOST_TEST(!manifest["volatile"]["host_cpu"].get<std::string>().empty());

  // The resolved case in it is a case file.
  const Case again = read_case(scratch.write("cone.toml", manifest["case"]["toml"]));
  BOOST_TEST((again == resolved));
}

BOOST_AUTO_TEST_CASE(only_the_volatile_part_of_the_manifest_changes_between_equal_runs) {
  const Scratch scratch;
  write_manifest(scratch.path("a"), validation(), {}, {}, {"2026-01-01T00:00:00Z", 1.5, "one"});
  write_manifest(scratch.path("b"), validation(), {}, {}, {"2026-01-02T00:00:00Z", 2.5, "two"});
  auto a = nlohmann::json::parse(read_bytes(scratch.path("a/manifest.json")));
  auto b = nlohmann::json::parse(read_bytes(scratch.path("b/manifest.json")));
  BOOST_TEST(a != b);
  a.erase("volatile");
  b.erase("volatile");
  BOOST_TEST(a == b);
}

BOOST_AUTO_TEST_CASE(a_manifest_of_a_missing_file_is_refused) {
  const Scratch scratch;
  BOOST_CHECK_EXCEPTION(
      write_manifest(scratch.folder().string(), validation(), {}, {"no.nc"}, {}), RunError, [](const RunError& error) {
        return std::string(error.what()).find("no.nc: cannot be hashed: No such file") != std::string::npos;
      });
  BOOST_TEST(n_files(scratch.folder()) == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
