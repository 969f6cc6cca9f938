// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/io/checkpoint.hpp"

#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <limits>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "brash/io/results.hpp"
#include "sample_results.hpp"
#include "scratch.hpp"

using namespace brash;
using namespace brash::io;
using namespace brash::model;

namespace {

Case some_case() { return read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml"); }

Checkpoint sample() {
  Checkpoint checkpoint;
  checkpoint.resolved = some_case();
  checkpoint.resolved.name = "cone \xc3\xa9";
  // The corners of the grid, and neighbours that a double would not tell apart.
  const std::int64_t far = std::int64_t{8192} << 30;
  const auto point = [](std::int64_t x, std::int64_t y) { return geometry::Point::of_units(x, y); };
  const geometry::Polygon with_hole{{point(-far, -far), point(far, -far), point(far, far - 1), point(-far, far)},
                                    {{point(0, 0), point(0, 1), point(1, 1)}}};
  const geometry::Polygon farther{
      {point(std::numeric_limits<std::int64_t>::max(), 0), point((1LL << 53) + 1, 1), point(2, 2)}, {}};
  const std::int64_t most = std::numeric_limits<std::int64_t>::max();
  checkpoint.tables = {{"floe",
                        {{"outline", "1", "outline, exact", std::vector{with_hole, farther}},
                         {"id", "1", "floe_id of the floe", std::vector<std::int64_t>{17, most}},
                         {"y", "m", "place, y", std::vector{-0.0, 5e-324}},
                         {"peak_stress", "Pa", "largest compression so far", std::vector{1e6 / 3.0, -1e300}}}},
                       {"ledger",
                        {{"sheet", "1", "twice an area, squared grid units",
                          std::vector<std::string>{"5764607523034234880000", "", "caf\xc3\xa9"}}}},
                       {"push", {{"force_x", "N", "mean force, x", std::vector<double>{}}}},
                       {"nothing", {}}};
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
  BOOST_TEST(std::signbit(std::get<std::vector<double>>(read.table("floe").column("y").values)[0]));
  // Written again it is the same file: nothing was lost, nothing depends on the clock.
  write_checkpoint(scratch.path("again.nc"), read);
  BOOST_TEST(read_bytes(scratch.path("again.nc")) == read_bytes(scratch.path("checkpoint.nc")));
}

BOOST_AUTO_TEST_CASE(the_checkpoint_of_an_empty_world_reads_back) {
  const Scratch scratch;
  const Checkpoint empty{.resolved = some_case(), .tables = {}, .results = {}};
  write_checkpoint(scratch.path("checkpoint.nc"), empty);
  BOOST_TEST((read_checkpoint(scratch.path("checkpoint.nc")) == empty));
}

BOOST_AUTO_TEST_CASE(the_checkpoint_of_floes_from_a_file_that_it_does_not_name_reads_back) {
  const Scratch scratch;
  scratch.write("floes.wkt", "POLYGON ((20 -5, 30 -5, 30 5, 20 5, 20 -5))");
  std::string text = kLeastCase;
  text.insert(text.find("[field]\n") + 8, "kind = \"floes\"\nfile = \"floes.wkt\"\n");
  Checkpoint written{.resolved = read_case(scratch.write("floes.toml", text)), .tables = {}, .results = {}};
  written.resolved.field.file.clear();  // as recording::checkpoint_file() does
  write_checkpoint(scratch.path("checkpoint.nc"), written);
  BOOST_TEST((read_checkpoint(scratch.path("checkpoint.nc")) == written));
}

BOOST_AUTO_TEST_CASE(a_table_whose_columns_differ_in_length_is_a_bug) {
  const Scratch scratch;
  Checkpoint uneven = sample();
  std::get<std::vector<double>>(uneven.table("floe").column("y").values).pop_back();
  BOOST_CHECK_THROW(write_checkpoint(scratch.path("checkpoint.nc"), uneven), ContractViolation);
  BOOST_TEST(!std::filesystem::exists(scratch.path("checkpoint.nc")));
}

BOOST_AUTO_TEST_CASE(what_is_no_checkpoint_is_refused) {
  const Scratch scratch;
  BOOST_CHECK_EXCEPTION(read_checkpoint(scratch.path("none.nc")), InputError,
                        says("none.nc: cannot be opened: No such file"));
  write_results(scratch.folder().string(), {}, sample_results());
  BOOST_CHECK_EXCEPTION(read_checkpoint(scratch.path("run.nc")), InputError,
                        says("run.nc: is not a checkpoint, or was cut short"));
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
  const std::string command = "/usr/bin/python3 -c \"import xarray; run = xarray.open_dataset('" +
                              scratch.path("checkpoint.nc") +
                              "'); assert run.state_floe_id.values.tolist() == [17, 2**63 - 1] and "
                              "run.state_floe_outline_x.values[0] == -8192 * 2**30\"";
  BOOST_TEST(std::system(command.c_str()) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
