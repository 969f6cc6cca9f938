// SPDX-License-Identifier: GPL-3.0-or-later
// The table of units that the simulator in a page reads has the factors of UDUNITS-2.
#include "units.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <utility>
#include <vector>

namespace {

using brash::io::in_unit_of_table;
using brash::io::in_unit_of_udunits;
using brash::io::UnitFault;

BOOST_AUTO_TEST_CASE(the_table_of_units_has_the_factors_of_udunits) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> usual{
      {"m", {"mm", "cm", "dm", "km", "in", "inch", "inches", "ft", "feet", "nmi", "mile", "meter", "metres", "um"}},
      {"m2", {"cm2", "mm2", "km2", "m^2", "ft2"}},
      {"kg", {"g", "t", "tonne", "Mg", "kg"}},
      {"s", {"ms", "min", "h", "hour", "hours", "day", "minutes"}},
      {"rad", {"deg", "degree", "degrees", "arc_degree", "radian"}},
      {"N", {"kN", "MN", "kg m/s2", "kg m s-2", "newton"}},
      {"Pa", {"kPa", "MPa", "GPa", "bar", "N/m2", "kN/m2", "N/mm2", "N m^-2"}},
      {"m s-1", {"m/s", "km/h", "knot", "knots", "kt", "cm/s", "ft/s"}},
      {"kg m-3", {"kg/m3", "g/cm3", "t/m3"}},
      {"N m-1", {"kN/m", "MN/m", "N/mm"}},
      {"N s m-1", {"kN s/m", "kg/s", "N.s/m"}},
      {"N m s2", {"kg m2", "MN m s2", "J s2"}},
      {"N s2 m-2", {"kg/m"}},
      {"s-1", {"Hz", "kHz", "1/s", "1/min"}},
      {"1", {"%", "percent", "ppt", "m/m", "mm/m"}}};
  for (const auto& [target, units] : usual)
    for (const std::string& unit : units) BOOST_TEST_CONTEXT(unit << " in " << target) {
        const auto known = in_unit_of_udunits(1.7, unit, target);
        const auto read = in_unit_of_table(1.7, unit, target);
        BOOST_REQUIRE(known.has_value());
        BOOST_REQUIRE(read.has_value());
        BOOST_TEST(read->zero == known->zero);
        // A factor that is no short decimal may be off by the roundings of a product.
        BOOST_TEST(read->one == known->one, boost::test_tools::tolerance(4e-16));
      }
}

BOOST_AUTO_TEST_CASE(a_degree_has_all_its_bits) {
  BOOST_TEST(in_unit_of_table(61.4, "deg", "rad")->one == in_unit_of_udunits(61.4, "deg", "rad")->one);
}

BOOST_AUTO_TEST_CASE(the_table_refuses_what_udunits_refuses) {
  for (const char* const unit : {"furlongs_", "MPaa", "metri"})
    for (const auto& read : {in_unit_of_table(1.0, unit, "m"), in_unit_of_udunits(1.0, unit, "m")})
      BOOST_TEST((!read && read.error() == UnitFault::kUnknown), unit);
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{{"s", "m"}, {"%", "rad"}, {"N", "Pa"}})
    for (const auto& read : {in_unit_of_table(1.0, from, to), in_unit_of_udunits(1.0, from, to)})
      BOOST_TEST((!read && read.error() == UnitFault::kOtherKind), from);
}

}  // namespace
