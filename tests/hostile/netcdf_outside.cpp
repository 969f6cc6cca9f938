// SPDX-License-Identifier: GPL-3.0-or-later
// Files of HDF5 whose data lie elsewhere: netCDF would read /etc/passwd for whoever asks for it.
#include <hdf5.h>
#include <netcdf.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "brash/core/error.hpp"
#include "brash/io/series.hpp"
#include "brash/netcdf/open.hpp"

namespace {

namespace fs = std::filesystem;

/// A folder of the test with a netCDF file `good.nc` of times and loads, and a file `secret` outside of it.
struct Folder {
  Folder() : path(fs::temp_directory_path() / ("brash-outside-" + std::to_string(::getpid()))) {
    fs::create_directories(path);
    std::ofstream(path / "secret") << std::string(800, 's');
    int file = -1, time = -1, variable = -1;
    BOOST_REQUIRE(nc_create(name("good.nc").c_str(), NC_NETCDF4 | NC_CLOBBER, &file) == NC_NOERR);
    nc_def_dim(file, "time", 10, &time);
    nc_def_var(file, "time", NC_DOUBLE, 1, &time, &variable);
    nc_enddef(file);
    const double times[]{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    nc_put_var_double(file, variable, times);
    BOOST_REQUIRE(nc_close(file) == NC_NOERR);
  }
  ~Folder() { fs::remove_all(path); }
  std::string name(const char* file) const { return (path / file).string(); }

  /// A copy of good.nc, open for HDF5.
  hid_t copy(const char* file) const {
    fs::copy_file(path / "good.nc", path / file);
    return H5Fopen(name(file).c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  }

  fs::path path;
};

void expect_refused(const std::string& path) {
  for (const auto read : {+[](const std::string& file) { brash::netcdf::Source source(file); },
                          +[](const std::string& file) { brash::io::read_series(file); }})
    BOOST_CHECK_EXCEPTION(read(path), brash::InputError, [](const brash::InputError& error) {
      return std::string(error.what()).find("refers to data in other files") != std::string::npos;
    });
}

/// A data set Fx of ten numbers with the properties `list`.
void add_loads(hid_t file, hid_t list) {
  const hsize_t length = 10;
  const hid_t space = H5Screate_simple(1, &length, nullptr);
  const hid_t loads = H5Dcreate2(file, "Fx", H5T_IEEE_F64LE, space, H5P_DEFAULT, list, H5P_DEFAULT);
  BOOST_REQUIRE(loads >= 0);
  H5Dclose(loads);
  H5Sclose(space);
  H5Pclose(list);
  H5Fclose(file);
}

BOOST_FIXTURE_TEST_CASE(a_file_with_all_its_data_is_read, Folder) {
  BOOST_TEST(brash::io::read_series(name("good.nc")).columns.at(0).size() == 10U);
}

BOOST_FIXTURE_TEST_CASE(external_storage_is_refused, Folder) {
  const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(list, name("secret").c_str(), 0, 80);
  add_loads(copy("external.nc"), list);
  expect_refused(name("external.nc"));
}

BOOST_FIXTURE_TEST_CASE(virtual_data_sets_are_refused, Folder) {
  const hsize_t length = 10;
  const hid_t space = H5Screate_simple(1, &length, nullptr);
  const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_virtual(list, space, name("good.nc").c_str(), "time", space);
  add_loads(copy("virtual.nc"), list);
  H5Sclose(space);
  expect_refused(name("virtual.nc"));
}

BOOST_FIXTURE_TEST_CASE(external_and_soft_links_are_refused, Folder) {
  const hid_t outside = copy("link.nc");
  BOOST_REQUIRE(H5Lcreate_external(name("good.nc").c_str(), "/time", outside, "Fx", H5P_DEFAULT, H5P_DEFAULT) >= 0);
  H5Fclose(outside);
  expect_refused(name("link.nc"));
  const hid_t soft = copy("soft.nc");
  BOOST_REQUIRE(H5Lcreate_soft("/time", soft, "Fx", H5P_DEFAULT, H5P_DEFAULT) >= 0);
  H5Fclose(soft);
  expect_refused(name("soft.nc"));
}

BOOST_FIXTURE_TEST_CASE(what_lies_in_a_group_is_looked_at_too, Folder) {
  const hid_t file = copy("group.nc");
  const hid_t group = H5Gcreate2(file, "inner", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_external(name("good.nc").c_str(), "/time", group, "Fx", H5P_DEFAULT, H5P_DEFAULT);
  H5Gclose(group);
  H5Fclose(file);
  expect_refused(name("group.nc"));
}

}  // namespace
