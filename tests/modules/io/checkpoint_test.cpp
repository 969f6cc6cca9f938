// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/io/checkpoint.hpp"

#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <limits>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/io/results.hpp"
#include "sample_results.hpp"
#include "scratch.hpp"

using namespace brash;
using namespace brash::io;
using namespace brash::model;

namespace {

Checkpoint sample() {
  Checkpoint checkpoint;
  checkpoint.case_name = "cone";
  checkpoint.case_toml = "[ice]\nthickness = 0.33\n# \xc3\xa9\n";
  // The corners of what the grid covers, and neighbours that a double would not tell apart.
  const std::int64_t far = std::int64_t{8192} << 30;
  checkpoint.sheet = {{{{-far, -far}, {far, -far}, {far, far - 1}, {-far, far}}, {{0, 0}, {0, 1}, {1, 1}}},
                      {{{std::numeric_limits<std::int64_t>::max(), 0}, {(1LL << 53) + 1, 1}, {2, 2}}}};
  CheckpointFloe floe;
  floe.id = 17;
  floe.body = {4294967295u, 3};
  floe.rings = {{{0, 0}, {1LL << 30, 0}, {0, 1LL << 30}}};
  floe.thickness = 0.33;
  floe.pose = {{1.0 / 3.0, -0.0, 5e-324}, {0.5, 0.5, -0.5, 0.5}};
  floe.twist = {{0.1, 0.2, 0.3}, {-1e-300, 1e300, 0.0}};
  floe.stress = {1, 2, 3, 4, 5, 6};
  floe.peak_stress = 1e6 / 3.0;
  floe.bearing = {.force = {1, 2, 1.0 / 3.0}, .thrust = {4, 5}, .weight = 6, .first = {7, 8}, .second = {9, 10, 11}};
  floe.rest = {.slow_for = 2.0 / 3.0, .settled = 1, .push = {12, 13, 1e-9}};
  floe.kept_drag = {.left = 1.0 / 9.0,
                    .sum = 14,
                    .first = {15, 16, 1.0 / 7.0},
                    .squares = {18, 19, 20},
                    .products = {-21, -22, -23},
                    .rotation = 24,
                    .skin_force = {25, 26, 27},
                    .skin_moment = {28, 29, 30},
                    .skin_power = -1e-300,
                    .velocity = {{31, 32, 5e-324}, {33, 34, 35}}};
  checkpoint.floes = {floe, {}};
  checkpoint.pushes = {{17, 0, {1.0 / 3.0, -5e-324, 1e300}}};
  // Twice the area of 50 m x 50 m in squared grid units does not fit in 64 bits.
  checkpoint.ledger = {{"sheet", "5764607523034234880000"}, {"snap", "-170141183460469231731687303715884105728"}};
  checkpoint.counters = {{"step", 1234}, {"breaks", std::numeric_limits<std::int64_t>::max()}};
  checkpoint.numbers = {{"centre_x", -7.0 + 1.0 / 3.0}, {"work", 0.1 + 0.2}, {"tiny", 5e-324}};
  checkpoint.results = sample_results();
  return checkpoint;
}

auto says(const std::string& part) {
  return [part](const InputError& error) {
    return std::string(error.what()).find(part) != std::string::npos &&
           std::string(error.what()).find("remedy") != std::string::npos;
  };
}

}  // namespace

BOOST_AUTO_TEST_SUITE(checkpoints)

BOOST_AUTO_TEST_CASE(a_checkpoint_reads_back_bit_for_bit) {
  const Scratch scratch;
  const Checkpoint written = sample();
  write_checkpoint(scratch.path("checkpoint.nc"), written);
  const Checkpoint read = read_checkpoint(scratch.path("checkpoint.nc"));
  BOOST_TEST((read == written));
  BOOST_TEST(std::signbit(read.floes[0].pose.position.y));
  // Written again it is the same file: nothing was lost, nothing depends on the clock.
  write_checkpoint(scratch.path("again.nc"), read);
  BOOST_TEST(read_bytes(scratch.path("again.nc")) == read_bytes(scratch.path("checkpoint.nc")));
}

BOOST_AUTO_TEST_CASE(the_checkpoint_of_an_empty_world_reads_back) {
  const Scratch scratch;
  write_checkpoint(scratch.path("checkpoint.nc"), {});
  BOOST_TEST((read_checkpoint(scratch.path("checkpoint.nc")) == Checkpoint{}));
}

BOOST_AUTO_TEST_CASE(values_that_the_format_cannot_hold_are_a_bug) {
  const Scratch scratch;
  Checkpoint not_whole = sample();
  not_whole.ledger["sheet"] = "1e9";
  BOOST_CHECK_THROW(write_checkpoint(scratch.path("checkpoint.nc"), not_whole), ContractViolation);
  Checkpoint not_finite = sample();
  not_finite.numbers["work"] = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(write_checkpoint(scratch.path("checkpoint.nc"), not_finite), ContractViolation);
  BOOST_TEST(!std::filesystem::exists(scratch.path("checkpoint.nc")));
}

BOOST_AUTO_TEST_CASE(what_is_no_checkpoint_is_refused) {
  const Scratch scratch;
  BOOST_CHECK_EXCEPTION(read_checkpoint(scratch.path("none.nc")), InputError,
                        says("none.nc: cannot be opened: No such file"));
  write_results(scratch.folder().string(), {}, sample_results());
  BOOST_CHECK_EXCEPTION(read_checkpoint(scratch.path("run.nc")), InputError,
                        says("run.nc: is no checkpoint, or was cut short"));
}

BOOST_AUTO_TEST_CASE(a_cut_checkpoint_is_refused_wherever_it_is_cut) {
  const Scratch scratch;
  write_checkpoint(scratch.path("checkpoint.nc"), sample());
  const std::string bytes = read_bytes(scratch.path("checkpoint.nc"));
  for (int tenths = 0; tenths < 10; ++tenths) {
    const std::string path =
        scratch.write("cut.nc", bytes.substr(0, bytes.size() * static_cast<std::size_t>(tenths) / 10));
    BOOST_CHECK_EXCEPTION(read_checkpoint(path), InputError, says("cut.nc: "));
  }
}

BOOST_AUTO_TEST_CASE(a_checkpoint_with_one_changed_byte_is_refused) {
  const Scratch scratch;
  write_checkpoint(scratch.path("checkpoint.nc"), sample());
  const std::string bytes = read_bytes(scratch.path("checkpoint.nc"));
  for (std::size_t i = 0; i < 50; ++i) {
    std::string changed = bytes;
    changed[bytes.size() * i / 50] ^= 1;
    const std::string path = scratch.write(std::to_string(i) + ".nc", changed);
    BOOST_CHECK_EXCEPTION(read_checkpoint(path), InputError, says(".nc: is damaged"));
  }
}

BOOST_AUTO_TEST_CASE(a_checkpoint_is_a_netcdf_file_for_others) {
  const Scratch scratch;
  write_checkpoint(scratch.path("checkpoint.nc"), sample());
  const std::string command =
      "/usr/bin/python3 -c \"import xarray; run = xarray.open_dataset('" + scratch.path("checkpoint.nc") +
      "'); assert run.present_id.values.tolist() == [17, 0] and run.sheet_x.values[0] == -8192 * 2**30\"";
  BOOST_TEST(std::system(command.c_str()) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
