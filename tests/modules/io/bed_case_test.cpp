// SPDX-License-Identifier: GPL-3.0-or-later
// The bed of the water in case files: read, written, and refused where ice or structure could not float over it.
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "brash/io/results.hpp"
#include "sample_results.hpp"
#include "scratch.hpp"

using namespace brash;
using namespace brash::io;

namespace {

model::Case read(const std::vector<std::string>& settings) { return parse_case(kLeastCase, "bed.toml", settings); }

/// The message names the value, the allowed values and a remedy.
void refuses(const std::vector<std::string>& settings, const std::string& found, const std::string& allowed,
             const std::string& remedy) {
  std::string message;
  try {
    read(settings);
  } catch (const InputError& error) {
    message = error.what();
  }
  for (const std::string& part : {found, allowed, remedy})
    BOOST_TEST(message.find(part) != std::string::npos, "expected \"" << part << "\" in: " << message);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bed_case)

BOOST_AUTO_TEST_CASE(water_is_deep_unless_it_has_a_depth) {
  BOOST_TEST(!read({}).water.depth.has_value());
  BOOST_TEST(to_toml(read({})).find("\ndepth = ") == std::string::npos);
  const model::Case c = read({"water.depth=55 cm", "water.bed_friction=0.45"});
  BOOST_TEST(c.water.depth.value() == 0.55);
  BOOST_TEST(c.water.bed_friction == 0.45);
  BOOST_TEST((parse_case(to_toml(c), "again.toml").water == c.water));
}

BOOST_AUTO_TEST_CASE(the_bed_rests_with_the_ice_or_with_the_structure_past_which_it_drifts) {
  BOOST_TEST(bed_past_ice(read({"water.depth=1"})).x == 0.0);
  for (const char* const frame : {"ice-drifts", "ice-drifts-through-still-water"}) {
    const model::Case c = read({"water.depth=1", std::string("structure.motion.frame=") + frame});
    BOOST_TEST(bed_past_ice(c).x == 1.202);
    BOOST_TEST(bed_past_ice(c).y == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(ice_and_structures_that_do_not_float_over_the_bed_are_refused) {
  refuses({"water.depth=0"}, "0", ">= 0.01", "");
  refuses({"water.depth=-1"}, "-1", ">= 0.01", "");
  refuses({"water.depth=0.28"}, "the ice does not float", "more than the ice's draught, 0.289756 m",
          "deepen the water or thin the ice");
  refuses({"water.depth=0.28", "field.border=free"}, "the ice does not float", "0.289756 m", "thin the ice");
  BOOST_TEST(read({"water.depth=0.3"}).water.depth.value() == 0.3);  // the towed cone stands in the bed
  BOOST_TEST(read({"water.depth=0.3", "field.border=free"}).water.depth.value() == 0.3);
  const std::string free = "structure.motion.kind=free";
  refuses({"water.depth=5.6", free}, "the structure does not float", "more than its draught, 5.68 m",
          "deepen the water");
  BOOST_TEST(read({"water.depth=5.7", free}).water.depth.value() == 5.7);
  refuses({"water.depth=1", "contact.engine=bullet"}, "know no bed", "absent with contact.engine",
          "take engine = \"brash\"");
  const std::string path = "structure.motion.path=[[0,-9,0,0],[20,14,2,0.2]]";
  std::string text = kLeastCase;
  const std::string straight = "speed = 1.202\nstart_distance = 7\n";
  text.replace(text.find(straight), straight.size(), "");
  BOOST_TEST(parse_case(text, "path.toml", {path, "water.depth=1"}).water.depth.value() == 1.0);
  BOOST_CHECK_EXCEPTION(
      parse_case(text, "path.toml", {path, "water.depth=1", "structure.motion.frame=ice-drifts"}), InputError,
      [](const InputError& error) { return std::string(error.what()).find("no one speed") != std::string::npos; });
}

BOOST_AUTO_TEST_CASE(a_history_has_the_columns_of_the_bed_only_if_ice_has_come_to_it) {
  const Scratch scratch;
  const auto header = [&](const model::RunResults& results) {
    write_results(scratch.folder().string(), read({}), results);
    const std::string bytes = read_bytes(scratch.path("history.csv"));
    return bytes.substr(0, bytes.find('\n'));
  };
  model::RunResults results = sample_results();
  BOOST_TEST(header(results).find("bed") == std::string::npos);
  results.loads[2].bed = {{1.0, 0.5, -9.0}, {0.25, 0.0, 2.0}};
  results.loads[2].losses.bed_friction = 3.0;
  BOOST_TEST(header(results).ends_with(",bed_Fx,bed_Fy,bed_Fz,bed_Mx,bed_Mz,loss_bed_friction"));
  BOOST_TEST((read_results(scratch.path("run.nc")).loads == results.loads));
}

BOOST_AUTO_TEST_SUITE_END()
