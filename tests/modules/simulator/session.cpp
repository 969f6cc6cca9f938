// SPDX-License-Identifier: GPL-3.0-or-later
// What a page gets of a simulation is what a run records.
#include "brash/simulator/session.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "brash/io/new_case.hpp"
#include "brash/simulation/run.hpp"

namespace {

using brash::simulator::Session;
using nlohmann::json;

/// A second of the validation case, seen five times.
brash::model::Case short_case() {
  return brash::io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml",
                              {"time.duration=1.3", "output.frames_per_second=5"});
}

BOOST_AUTO_TEST_CASE(the_records_of_a_session_are_those_of_a_run) {
  const brash::model::Case c = short_case();
  const brash::model::RunResults recorded = brash::simulation::run(c).results;
  Session session(c);
  std::vector<double> loads;
  std::size_t n_events = 0, n_frames = json::parse(session.start()).at("poses").size(), n_calls = 0;
  BOOST_TEST(n_frames == 1U);
  while (!session.is_done()) {
    const json records = json::parse(session.advance(7));
    for (const json& load : records.at("load").at("Fx")) loads.push_back(load.get<double>());
    n_events += records.at("event").at("time").size();
    BOOST_TEST(!records.at("poses").empty());  // there is always something to draw
    ++n_calls;
  }
  BOOST_TEST(n_calls == 19U);  // 130 steps
  BOOST_TEST(loads.size() == recorded.loads.size());
  for (std::size_t i = 0; i < loads.size(); ++i) BOOST_TEST(loads[i] == recorded.loads[i].total.force.x);
  BOOST_TEST(n_events == recorded.events.size());
  BOOST_TEST(n_events > 0U);
  BOOST_TEST(session.time() == recorded.loads.back().time);
}

BOOST_AUTO_TEST_CASE(a_session_ends_with_its_case) {
  Session session(short_case());
  const json all = json::parse(session.advance(1000));
  BOOST_TEST(all.at("load").at("time").size() == 130U);
  BOOST_TEST(session.is_done());
  BOOST_TEST(json::parse(session.advance(5)).at("load").at("time").empty());
}

BOOST_AUTO_TEST_CASE(the_head_holds_the_structure_and_the_resolved_case) {
  const json head = json::parse(Session(short_case()).head());
  const json& arrays = head.at("arrays");
  const std::size_t n_vertices = arrays.at("mesh.x").size();
  BOOST_TEST(n_vertices > 8U);
  for (const json& corner : arrays.at("mesh.triangles")) BOOST_TEST(corner.get<std::size_t>() < n_vertices);
  BOOST_TEST(arrays.at("waterline.x").size() == arrays.at("waterline.nodes").at(0).get<std::size_t>());
  const std::string toml = head.at("manifest").at("case").at("toml");
  BOOST_TEST(brash::io::to_toml(brash::io::parse_case(toml, "cone.toml")) == toml);
}

BOOST_AUTO_TEST_CASE(a_new_case_of_every_kind_is_a_case) {
  for (const char* kind : {"cone", "faceted-cone", "plane", "wedge-bow", "ship"}) {
    const std::string text = brash::io::new_case(kind);
    BOOST_TEST_CONTEXT(text) BOOST_CHECK_NO_THROW(brash::io::parse_case(text, "new.toml"));
  }
  BOOST_TEST(brash::io::new_case("mesh").find("file = \"hull.stl\"") != std::string::npos);
  BOOST_CHECK_THROW(brash::io::new_case("cube"), brash::InputError);
}

}  // namespace
