// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <filesystem>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "scratch.hpp"

using namespace brash;
using namespace brash::io;

namespace {

/// The least case with another motion in place of speed and start distance.
std::string with_motion(const std::string& keys, bool keeps_speed = false) {
  std::string text = kLeastCase;
  const std::string straight = "speed = 1.202\nstart_distance = 7\n";
  text.replace(text.find(straight), straight.size(), (keeps_speed ? straight : "") + "[structure.motion]\n" + keys);
  return text;
}

model::Case read(const std::string& text) { return parse_case(text, "motion.toml"); }

std::string message_of(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void check_refused(const std::string& text, const std::string& part) {
  const std::string message = message_of(text);
  BOOST_TEST(message.find(part) != std::string::npos, "expected \"" << part << "\" in: " << message);
}

const std::string kPath = "path = [[0, -9, 0, 0], [\"10 s\", 3, 0, \"10 deg\"], [20, 1400e-2, \"200 cm\", 0.2]]\n";

}  // namespace

BOOST_AUTO_TEST_SUITE(motion_case)

BOOST_AUTO_TEST_CASE(a_path_takes_the_place_of_speed_and_start_distance) {
  const model::Case c = read(with_motion(kPath));
  const auto& path = std::get<model::Towed>(c.structure.motion).path;
  BOOST_REQUIRE(path.size() == 3u);
  BOOST_TEST(path[1].heading == radians(10));
  BOOST_TEST(path[2].position.y == 2.0);
  BOOST_TEST((read(to_toml(c)).structure == c.structure));
}

BOOST_AUTO_TEST_CASE(a_path_in_a_file_becomes_its_table) {
  const Scratch scratch;
  scratch.write("way.csv", "time,x,y,heading_deg\n0,-9,0,0\n10,3,0,10\n20,14,2,15\n");
  const model::Case c = read_case(scratch.write("case.toml", with_motion("path = \"way.csv\"\n")));
  const auto& path = std::get<model::Towed>(c.structure.motion).path;
  BOOST_REQUIRE(path.size() == 3u);
  BOOST_TEST(path[2].heading == radians(15));
  BOOST_TEST(to_toml(c).find("path = [[0.0, -9.0, 0.0, 0.0]") != std::string::npos);

  const auto refused = [&](const std::string& name, const std::string& part) {
    try {
      read_case(scratch.write("case.toml", with_motion("path = \"" + name + "\"\n")));
    } catch (const InputError& error) {
      BOOST_TEST(std::string(error.what()).find(part) != std::string::npos, error.what());
      return;
    }
    BOOST_TEST(false, name + " is read");
  };
  refused("../way.csv", "leads out of the folder");
  scratch.write("no_heading.csv", "time,x,y\n0,-9,0\n10,3,0\n");
  refused("no_heading.csv", "has no column heading");
  scratch.write("in_seconds.csv", "time,x,y,heading_s\n0,-9,0,0\n10,3,0,1\n");
  refused("in_seconds.csv", "has no column heading");
  scratch.write("gap.csv", "time,x,y,heading\n0,-9,,0\n20,3,0,1\n");
  refused("gap.csv", "has no number");
}

BOOST_AUTO_TEST_CASE(a_structure_that_backs_into_the_ice_is_judged_by_its_stern) {
  // The plane slopes ahead; its back is vertical and bends no ice.
  const auto towed = [](const std::string& heading) {
    std::string text = with_motion("path = [[0, -12, 0, " + heading + "], [20, 12, 0, " + heading + "]]\n");
    text.insert(text.find("[structure]") + 12, "kind = \"plane\"\nlength = 9\n");
    return text;
  };
  BOOST_TEST(message_of(towed("0")) == "");
  check_refused(towed("\"180 deg\""), "the structure's front is vertical and bends no ice");
}

BOOST_AUTO_TEST_CASE(a_path_that_is_none_and_keys_beside_it_are_refused) {
  check_refused(with_motion(kPath, true), "structure.speed = 1.202: cannot be combined with structure.motion.path");
  check_refused(with_motion(kPath, true),
                "structure.start_distance = 7: cannot be combined with structure.motion.path");
  check_refused(with_motion(kPath + "speed = 3\n"),
                "structure.motion.speed = 3: cannot be combined with structure.motion.path");
  check_refused(with_motion("path = [[0, -9, 0, 0], [10, 3, 0, 0]]\n"), "it ends at 10 s, before the run");
  check_refused(with_motion("path = [[1, -9, 0, 0], [20, 3, 0, 0]]\n"), "it begins at 1 s");
  check_refused(with_motion("path = [[0, -9, 0, 0], [20, 3, 0, 0], [20, 4, 0, 0]]\n"), "its times do not ascend");
  check_refused(with_motion("path = [[0, -9, 0, 0], [20, 9000, 0, 0]]\n"), "it leaves the plane of the ice");
  check_refused(with_motion("path = [[0, -1, 0, 0], [20, 9, 0, 0]]\n"), "the structure starts inside the ice");
  check_refused(with_motion("path = [[0, -9, 0], [20, 9, 0, 0]]\n"), "structure.motion.path");
  check_refused(with_motion("path = [[0, -9, 0, 0]]\n"), "structure.motion.path");
  check_refused(with_motion("path = [[0, \"1 s\", 0, 0], [20, 3, 0, 0]]\n"), "structure.motion.path");
  check_refused(with_motion(kPath + "frame = \"ice-drifts-through-still-water\"\n"), "no one speed");
  check_refused(with_motion("kind = \"free\"\n" + kPath, true), "is not a key of structure.motion.kind");
  check_refused(with_motion(""), "structure.speed: is missing");
}

BOOST_AUTO_TEST_CASE(a_body_has_the_values_that_are_written_and_leaves_the_others_to_the_hull) {
  const model::Case c =
      read(with_motion("kind = \"free\"\nthrust = [\"300 kN\", 0, 0]\nradii_of_gyration = [4, 4, 5]\n", true));
  const auto& free = std::get<model::Free>(c.structure.motion);
  BOOST_TEST(free.speed == 1.202);
  BOOST_TEST(free.body.thrust.x == 3e5);
  BOOST_TEST(free.body.radii_of_gyration->z == 5.0);
  BOOST_TEST(!free.body.mass.has_value());
  BOOST_TEST((free.body.linear_damping == Vec3{}));
  BOOST_TEST((read(to_toml(c)).structure == c.structure));
  check_refused(with_motion("kind = \"compliant\"\nstiffness = 1e6\n", true), "structure.motion.mass: is missing");
  check_refused(with_motion("thrust = [1, 0, 0]\n", true), "is not a key of structure.motion.kind");
}

BOOST_AUTO_TEST_CASE(a_thrust_that_falls_is_a_bollard_pull_ahead_and_the_only_drag_in_surge) {
  const std::string falling = "kind = \"free\"\nopen_water_speed = \"16 knots\"\n";
  const model::Case c =
      read(with_motion(falling + "thrust = [\"900 kN\", 0, 0]\nlinear_damping = [0, 1e4, 1e5]\n", true));
  const auto& body = std::get<model::Free>(c.structure.motion).body;
  BOOST_TEST(*body.open_water_speed == 16.0 * 1852.0 / 3600.0);
  BOOST_TEST((read(to_toml(c)).structure == c.structure));
  // The bollard pull less both losses is zero at the speed in open water.
  const auto [linear, quadratic] = model::thrust_loss(9e5, *body.open_water_speed);
  const double v = *body.open_water_speed;
  BOOST_TEST(linear * v + quadratic * v * v == 9e5, boost::test_tools::tolerance(1e-14));
  for (const char* const thrust : {"", "thrust = [-9e5, 0, 0]\n", "thrust = [9e5, 1, 0]\n", "thrust = [9e5, 0, -1]\n"})
    check_refused(with_motion(falling + thrust, true), "open_water_speed makes a thrust ahead fall");
  check_refused(with_motion(falling + "thrust = [9e5, 0, 0]\nlinear_damping = [1, 0, 0]\n", true),
                "structure.motion.linear_damping");
  check_refused(with_motion(falling + "thrust = [9e5, 0, 0]\nquadratic_damping = [1, 0, 0]\n", true),
                "holds the resistance of the water already");
  check_refused(with_motion("kind = \"free\"\nthrust = [9e5, 0, 0]\nopen_water_speed = 0\n", true),
                "allowed: a finite number >= 0.1 and <= 100");
  check_refused(with_motion("open_water_speed = 8\n", true), "is not a key of structure.motion.kind");
  check_refused(with_motion("kind = \"moored\"\nstiffness_matrix = [[1e5, 0, 0, 0, 0, 0], [0, 1e5, 0, 0, 0, 0], "
                            "[0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0]]\n"
                            "open_water_speed = 8\n",
                            true),
                "open_water_speed makes a thrust ahead fall");
}

BOOST_AUTO_TEST_CASE(a_mooring_is_read_and_one_that_cannot_hold_is_refused) {
  const std::string line = "lines = [[\"200 m\", 0, -30, 5, 0, 0, 205, \"1 kN/m\", \"300 MN\"]]\n";
  const model::Case c =
      read(with_motion("kind = \"moored\"\npretension = [1, 2, 3, 4, 5, 6]\nstiffness_matrix = [[1e5, 0, 0, 0, 0, 2], "
                       "[0, 0, 0, 0, 0, 0], "
                       "[0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [2, 0, 0, 0, 0, 0]]\n" +
                           line,
                       true));
  const auto& moored = std::get<model::Moored>(c.structure.motion);
  BOOST_TEST(moored.lines.at(0).weight == 1000.0);
  BOOST_TEST(moored.lines.at(0).stiffness == 3e8);
  BOOST_TEST(moored.stiffness.at(0).at(5) == 2.0);
  BOOST_TEST(moored.pretension.at(5) == 6.0);
  BOOST_TEST((read(to_toml(c)).structure == c.structure));
  check_refused(with_motion("kind = \"moored\"\n", true), "the structure is moored to nothing");
  check_refused(with_motion("kind = \"moored\"\nlines = [[200, 0, 30, 5, 0, 0, 205, 1e3, 3e8]]\n", true),
                "an anchor lies above its fairlead");
  check_refused(with_motion("kind = \"moored\"\nlines = [[200, 0, -30, 5, 0, 0, 205, 0, 3e8]]\n", true),
                "a line has no length, weight or stiffness");
  std::string lopsided = to_toml(c);
  const std::size_t at = lopsided.find("[2.0, 0.0, 0.0");
  BOOST_REQUIRE(at != std::string::npos);
  check_refused(lopsided.replace(at, 3, "[3"), "is not symmetric");
}

BOOST_AUTO_TEST_CASE(legs_are_places_of_the_shape_that_do_not_touch) {
  const auto with_legs = [](const std::string& legs) {
    std::string text = kLeastCase;
    return text.replace(text.find("start_distance = 7"), 18, "start_distance = 20\nlegs = " + legs);
  };
  const model::Case c = read(with_legs("[[\"8 m\", 10], [8, -10]]"));
  BOOST_REQUIRE(c.structure.legs.size() == 2u);
  BOOST_TEST((c.structure.legs[1] == Vec2{8.0, -10.0}));
  BOOST_TEST((read(to_toml(c)).structure == c.structure));
  BOOST_TEST(read(kLeastCase).structure.legs.empty());
  // The cone is 17.3 m wide at its top.
  check_refused(with_legs("[[0, 10], [17, -7]]"), "legs 1 and 2 touch, or may touch");
  check_refused(with_legs("[[0, 10], [17, -7]]"), "places more than 17.3");
  check_refused(with_legs("[[0, 10, 0]]"), "an array of 1 to 8, each [m, m]");
  check_refused(with_legs("[[0, 40], [0, -40]]"), "the sheet is narrower than the structure");
  check_refused(with_legs("[[20, 0], [-20, 0]]"), "the structure starts inside the ice");
  check_refused(with_legs("[[0, 1500]]"), "each [m, m], all >= -1000 and <= 1000");
}

BOOST_AUTO_TEST_CASE(no_leg_is_beyond_the_plane_of_the_ice) {
  std::string towed = kLeastCase;
  towed.replace(towed.find("start_distance = 7"), 18, "start_distance = 8000\nlegs = [[-1000, 0], [0, 0]]");
  check_refused(towed, "the structure starts outside the plane of the ice");
  std::string turned = with_motion("path = [[0, -8000, 0, 0], [20, -7990, 0, 0]]\n");
  turned.insert(turned.find("[structure.motion]"), "legs = [[0, 1000]]\n");
  check_refused(turned, "it leaves the plane of the ice");
}

BOOST_AUTO_TEST_CASE(a_ship_has_no_legs) {
  std::string text = kLeastCase;
  text.replace(text.find("angle"), text.find("speed") - text.find("angle"), "kind = \"ship\"\nlegs = [[0, 0]]\n");
  check_refused(text, "structure.legs");
}

BOOST_AUTO_TEST_SUITE_END()
