// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <netcdf.h>

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/netcdf/open.hpp"

namespace brash::training {

/// An open netCDF file; a failure throws `Error`: RunError when writing, InputError when reading.
template <typename Error>
class File {
 public:
  explicit File(std::string path) : path_(std::move(path)), source_(std::in_place, path_), id_(source_->id()) {}
  struct New {};
  /// One that is made. Until it is closed it is in memory: its bytes are written at once, and a failure has a reason.
  /// An absolute path is never taken for an address.
  File(const std::string& path, New) : path_(std::filesystem::absolute(path).string()) {
    check(nc_create(path_.c_str(), NC_NETCDF4 | NC_CLOBBER | NC_DISKLESS | NC_PERSIST, &id_), "file");
    open_ = true;
  }
  ~File() {
    if (open_) nc_abort(id_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  void check(int code, const std::string& what) const {
    if (code != NC_NOERR) refuse(what, nc_strerror(code));
  }
  [[noreturn]] void refuse(const std::string& what, const std::string& fault) const {
    const InputError complaint(Complaint{path_ + ", " + what, fault,
                                         "a whole database of `brash failure database` (netCDF)",
                                         "check folder and space, and compute or copy the database again"});
    throw Error(complaint.what());
  }
  void close() {
    open_ = false;
    check(nc_close(id_), "close");
  }
  int id() const { return id_; }

  int define(const char* name, int type, const std::vector<int>& dimensions, const char* unit, const char* meaning) {
    int variable = 0;
    check(nc_def_var(id_, name, type, static_cast<int>(dimensions.size()), dimensions.data(), &variable), name);
    check(nc_put_att_text(id_, variable, "units", std::string_view(unit).size(), unit), name);
    check(nc_put_att_text(id_, variable, "long_name", std::string_view(meaning).size(), meaning), name);
    if (type == NC_DOUBLE && dimensions.size() > 1) check(nc_def_var_deflate(id_, variable, 1, 1, 4), name);
    return variable;
  }
  void put_text(const char* name, const std::string& text) {
    check(nc_put_att_text(id_, NC_GLOBAL, name, text.size(), text.c_str()), name);
  }
  std::string text(const char* name) const {
    std::size_t size = 0;
    check(nc_inq_attlen(id_, NC_GLOBAL, name, &size), name);
    std::string value(size, '\0');
    check(nc_get_att_text(id_, NC_GLOBAL, name, value.data()), name);
    return value;
  }
  std::size_t dimension(const char* name) const {
    int dimension = 0;
    std::size_t size = 0;
    check(nc_inq_dimid(id_, name, &dimension), name);
    check(nc_inq_dimlen(id_, dimension, &size), name);
    if (size > most_values_in(source_->n_bytes()))
      refuse(name, fmt::format("states {} values, more than the file's bytes can hold", size));
    return size;
  }
  int variable(const char* name) const {
    int variable = 0;
    check(nc_inq_varid(id_, name, &variable), name);
    return variable;
  }
  /// The library fills a variable's own size, whatever the room for it.
  void expect_size(const char* name, std::size_t size) const {
    int n_dimensions = 0;
    std::array<int, NC_MAX_VAR_DIMS> dimensions{};
    check(nc_inq_var(id_, variable(name), nullptr, nullptr, &n_dimensions, dimensions.data(), nullptr), name);
    std::size_t held = 1;
    for (int i = 0; i < n_dimensions && held <= size; ++i) {
      std::size_t length = 0;
      check(nc_inq_dimlen(id_, dimensions[i], &length), name);
      held *= length;
    }
    if (held != size || size > most_values_in(source_->n_bytes()))
      refuse(name, fmt::format("has not the {} values that the dimensions ask for", size));
  }
  std::vector<double> doubles(const char* name, std::size_t size) const {
    expect_size(name, size);
    std::vector<double> values(size);
    if (size > 0) check(nc_get_var_double(id_, variable(name), values.data()), name);
    return values;
  }
  std::vector<int> ints(const char* name, std::size_t size) const {
    expect_size(name, size);
    std::vector<int> values(size);
    if (size > 0) check(nc_get_var_int(id_, variable(name), values.data()), name);
    return values;
  }

 private:
  netcdf::Lock lock_;
  std::string path_;
  std::optional<netcdf::Source> source_;  ///< of a file that is read
  int id_ = 0;
  bool open_ = false;  ///< a file that is made
};

using Writer = File<RunError>;
using Reader = File<InputError>;

/// Writes the doubles of a variable.
void put_doubles(Writer& file, const char* name, const std::vector<double>& values);

/// The texts of the variable `error`, one for each of the `n` records.
std::vector<std::string> read_messages(const Reader& file, std::size_t n);

/// Calls `write` for a part in a process of its own, and renames the part to `path` when it is whole: HDF5 does not
/// survive a disk that is full, not even to its exit.
/// @throws StorageError when it cannot be written.
void write_whole(const std::string& path, const std::function<void(const std::string& part)>& write);

}  // namespace brash::training
