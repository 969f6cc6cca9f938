// SPDX-License-Identifier: GPL-3.0-or-later
// The calls of the page in its worker, without a browser.
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "brash/io/case.hpp"

extern "C" {
const char* brash_make(const char* toml, const char* name);
const char* brash_advance(int n_steps);
}

namespace {

using nlohmann::json;

BOOST_AUTO_TEST_CASE(a_text_that_is_no_case_leaves_the_simulation_as_it_is) {
  BOOST_TEST(json::parse(brash_advance(1)).contains("error"));
  const std::string toml = brash::io::to_toml(
      brash::io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml", {"time.duration=1"}));
  BOOST_TEST(json::parse(brash_make(toml.c_str(), "cone")).contains("head"));
  BOOST_TEST(json::parse(brash_advance(3)).at("time").get<double>() == 0.03, boost::test_tools::tolerance(1e-12));
  for (const char* wrong : {"[ice", "[ice]\nthickness = -1\n"}) {
    BOOST_TEST(json::parse(brash_make(wrong, "cone")).contains("error"));
    BOOST_TEST(json::parse(brash_advance(0)).at("time").get<double>() == 0.03, boost::test_tools::tolerance(1e-12));
  }
  BOOST_TEST(json::parse(brash_advance(2)).at("time").get<double>() == 0.05, boost::test_tools::tolerance(1e-12));
}

}  // namespace
