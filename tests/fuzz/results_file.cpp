// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: a run.nc whose tables say anything is results that make sense, or an InputError. The bytes change a whole
// file, value by value and length by length; HDF5 itself, which does not survive all bytes, is not searched.
#include <netcdf.h>
#include <netcdf_mem.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/io/results.hpp"
#include "brash/io/series.hpp"
#include "brash/netcdf/open.hpp"
#include "sample_results.hpp"
#include "scratch_file.hpp"

namespace {

namespace fs = std::filesystem;

/// The bytes of a small whole run.nc.
const std::string& whole_file() {
  static const std::string bytes = [] {
    const fs::path folder = fs::temp_directory_path() / ("brash-fuzz-results-" + std::to_string(::getpid()));
    brash::io::write_results(folder.string(), brash::model::Case{}, sample_results());
    std::string read = brash::read_text_file((folder / "run.nc").string(), "results");
    fs::remove_all(folder);
    return read;
  }();
  return bytes;
}

class Bytes {
 public:
  explicit Bytes(std::string_view text) : text_(text) {}
  bool empty() const { return at_ >= text_.size(); }
  int next() { return empty() ? 0 : static_cast<unsigned char>(text_[at_++]); }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

constexpr std::array<double, 16> kValues{0.0,
                                         -0.0,
                                         1.0,
                                         -1.0,
                                         2.0,
                                         127.0,
                                         255.0,
                                         1e9,
                                         -1e9,
                                         2147483647.0,
                                         1e300,
                                         -1e300,
                                         5e-324,
                                         std::numeric_limits<double>::quiet_NaN(),
                                         std::numeric_limits<double>::infinity(),
                                         8193.0};

/// A change of one variable, from the bytes (variable, what, where).
struct Change {
  int variable, what, where;
};

std::vector<Change> changes_in(Bytes& bytes) {
  std::vector<Change> changes;
  while (!bytes.empty() && changes.size() < 8) changes.push_back({bytes.next(), bytes.next(), bytes.next()});
  return changes;
}

/// The lengths of dimensions, some of them changed.
std::vector<std::size_t> copy_dimensions(int from, int to, int seed) {
  int n = 0;
  nc_inq_ndims(from, &n);
  std::vector<std::size_t> lengths(static_cast<std::size_t>(n));
  for (int d = 0; d < n; ++d) {
    std::array<char, NC_MAX_NAME + 1> name{};
    nc_inq_dim(from, d, name.data(), &lengths[static_cast<std::size_t>(d)]);
    if (seed > 0 && seed % n == d) lengths[static_cast<std::size_t>(d)] = static_cast<std::size_t>(seed / n + 1);
    int id = 0;
    nc_def_dim(to, name.data(), lengths[static_cast<std::size_t>(d)], &id);
  }
  return lengths;
}

void copy_variable(int from, int to, int id, const std::vector<std::size_t>& lengths,
                   const std::vector<Change>& changes, int n_variables) {
  std::array<char, NC_MAX_NAME + 1> name{};
  nc_type type = NC_NAT;
  int n_dimensions = 0, dimension = 0;
  nc_inq_var(from, id, name.data(), &type, &n_dimensions, nullptr, nullptr);
  if (n_dimensions == 1) nc_inq_vardimid(from, id, &dimension);
  std::size_t before = 1;
  if (n_dimensions == 1) nc_inq_dimlen(from, dimension, &before);
  const std::size_t length = n_dimensions == 1 ? lengths[static_cast<std::size_t>(dimension)] : 1;
  std::vector<double> values(std::max(before, length), 0.0);
  nc_get_var_double(from, id, values.data());
  for (const Change& change : changes) {
    if (change.variable % n_variables != id) continue;
    if (change.what == 255) return;  // the variable is missing
    if (change.what == 254) type = type == NC_DOUBLE ? NC_INT : NC_DOUBLE;
    values[static_cast<std::size_t>(change.where) % values.size()] =
        kValues[static_cast<std::size_t>(change.what) % 16];
  }
  int made = 0;
  if (nc_def_var(to, name.data(), type, n_dimensions, &dimension, &made) != NC_NOERR) return;
  nc_enddef(to);
  // A value that the type does not hold is written as it comes.
  if (length > 0) nc_put_var_double(to, made, values.data());
  nc_redef(to);
}

std::string changed_file(std::string_view text) {
  const brash::netcdf::Source whole("whole.nc", whole_file());
  Bytes bytes(text);
  int file = 0, n = 0;
  nc_create_mem(brash::netcdf::kNameInMemory, NC_NETCDF4, 1 << 16, &file);
  const std::vector<std::size_t> lengths = copy_dimensions(whole.id(), file, bytes.next());
  const std::vector<Change> changes = changes_in(bytes);
  nc_inq_nvars(whole.id(), &n);
  for (int id = 0; id < n; ++id) copy_variable(whole.id(), file, id, lengths, changes, n);
  NC_memio image{};
  nc_close_memio(file, &image);
  const std::unique_ptr<void, decltype(&std::free)> memory(image.memory, &std::free);
  return {static_cast<const char*>(image.memory), image.size};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFile file(".nc");
  const std::string& path = file.with(changed_file(text_of(data, size)));
  try {
    const brash::model::RunResults results = brash::io::read_results(path);
    for (const brash::model::LoadRow& row : results.loads)
      if (!std::isfinite(row.time)) std::abort();
  } catch (const brash::InputError&) {
  }
  try {
    (void)brash::io::read_series(path);
  } catch (const brash::InputError&) {
  }
  return 0;
}
