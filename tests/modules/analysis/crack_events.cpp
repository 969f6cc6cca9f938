// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "brash/analysis/crack_run.hpp"
#include "brash/core/error.hpp"

namespace brash::analysis {
namespace {

bool names(const InputError& error, const std::string& what) {
  BOOST_TEST_INFO(error.what());
  return std::string(error.what()).find(what) != std::string::npos;
}

BOOST_AUTO_TEST_CASE(events_are_refused_with_line_and_column) {
  const auto refused = [](const std::string& text, const std::string& what) {
    BOOST_CHECK_EXCEPTION(read_crack_events("e.csv", text), InputError,
                          [&](const InputError& e) { return names(e, what); });
  };
  refused("x,y,radius,wedges\n1,2,3\n", "e.csv, line 2: '1,2,3': 3 fields");
  refused("1,2,-3,4", "e.csv, line 1: radius = '-3'");
  refused("1,2,nan,4", "radius = 'nan'");
  refused("1,2,1e-12,4", "radius = '1e-12' is not allowed\n  allowed: a number of metres, at least 7.45e-09");
  refused("1,inf,1,4", "y = 'inf' is not allowed\n  allowed: the circle must stay within");
  refused("1,2,3,0", "wedges = '0'");
  refused("1,2,3,2.5", "wedges = '2.5'");
  refused("1,2,3,", "wedges = ''");
  refused("1,2,3,5,0.1 0.2", "wedges = '5' is not allowed\n  allowed: 2 angles make 3 wedges");
  refused("1,2,3,3,0.1 b", "angles = '0.1 b'");
  refused("1,2,3,3,60 120",
          "angles = '60 120' is not allowed\n  allowed: radians within a full turn, 2 pi; 60 degrees");
  refused("1,2,3,3,-0.1 -6.4", "angles = '-0.1 -6.4'");
  refused("y,x,radius,wedges\n", "x = 'y'");
  BOOST_TEST(read_crack_events("e.csv", "").empty());
  BOOST_TEST(read_crack_events("e.csv", "\xef\xbb\xbfx,y,radius,wedges\n1,2,3,4\n").at(0).line == 2);
  const auto events = read_crack_events("e.csv", "x, y ,radius,wedges,angles\r\n+1, 2e0 ,3,2, 0.5;0.7\r\n");
  BOOST_REQUIRE(events.size() == 1u);
  BOOST_TEST((events[0].angles == std::vector<double>{0.5, 0.7}));
}

}  // namespace
}  // namespace brash::analysis
