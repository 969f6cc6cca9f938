// SPDX-License-Identifier: GPL-3.0-or-later
#include <netcdf.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/io/series.hpp"
#include "scratch.hpp"

namespace {

using namespace brash;

/// The column of the values 1 to 5 in a file in which its variable F has this attribute.
std::vector<double> column_with(const std::string& attribute, const std::vector<double>& numbers) {
  const Scratch scratch;
  const std::string path = scratch.path("loads.nc");
  const auto done = [](int status) { BOOST_TEST_REQUIRE(status == NC_NOERR, nc_strerror(status)); };
  int file = -1, dimension = -1, time = -1, force = -1;
  done(nc_create(path.c_str(), NC_CLOBBER, &file));
  done(nc_def_dim(file, "time", 5, &dimension));
  done(nc_def_var(file, "time", NC_DOUBLE, 1, &dimension, &time));
  done(nc_def_var(file, "F", NC_DOUBLE, 1, &dimension, &force));
  done(nc_put_att_text(file, time, "units", 1, "s"));
  done(nc_put_att_double(file, force, attribute.c_str(), NC_DOUBLE, numbers.size(), numbers.data()));
  done(nc_enddef(file));
  const std::vector<double> values{1.0, 2.0, 3.0, 4.0, 5.0};
  done(nc_put_var_double(file, time, values.data()));
  done(nc_put_var_double(file, force, values.data()));
  done(nc_close(file));
  return io::read_series(path).columns.at(1);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(netcdf_series)

BOOST_AUTO_TEST_CASE(each_of_several_missing_values_is_missing) {
  const std::vector<double> read = column_with("missing_value", {2.0, 4.0, -9.0, -99.0});
  BOOST_TEST_REQUIRE(read.size() == 5U);
  for (const std::size_t i : {0U, 2U, 4U}) BOOST_TEST(read[i] == static_cast<double>(i + 1));
  for (const std::size_t i : {1U, 3U}) BOOST_TEST(std::isnan(read[i]));
}

BOOST_AUTO_TEST_CASE(an_attribute_of_one_number_changes_the_values) {
  BOOST_TEST(column_with("scale_factor", {10.0}).back() == 50.0);
  BOOST_TEST(column_with("add_offset", {10.0}).back() == 15.0);
  BOOST_TEST(std::isnan(column_with("_FillValue", {5.0}).back()));
  BOOST_TEST(std::isnan(column_with("missing_value", {5.0}).back()));
}

BOOST_AUTO_TEST_CASE(many_numbers_in_place_of_one_are_refused) {
  for (const char* attribute : {"scale_factor", "add_offset"})
    BOOST_CHECK_EXCEPTION(
        column_with(attribute, std::vector<double>(4096, 1.0)), InputError, [&](const InputError& error) {
          const std::string text = error.what();
          const auto names = [&](const std::string& part) { return text.find(part) != std::string::npos; };
          return names("loads.nc, F, " + std::string(attribute)) && names("4096 numbers") && names("remedy");
        });
}

BOOST_AUTO_TEST_SUITE_END()
