// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <mutex>
#include <string>

namespace brash::netcdf {

/// Held while netCDF or HDF5 is in use: neither library knows threads.
class Lock {
 public:
  Lock();

 private:
  std::unique_lock<std::recursive_mutex> lock_;
};

/// A netCDF file that is open for reading, from memory: nothing in it, and nothing in its name, leads to another file
/// or to the network. Holds the Lock as long as it lives.
class Source {
 public:
  /// Reads the file at `path`, and opens it.
  ///
  /// @throws InputError when it is a folder, a pipe or a device, cannot be read, is not a netCDF file, or refers to
  ///         data outside of it (external storage, external links, virtual data sets).
  explicit Source(const std::string& path);
  /// Opens `bytes`, which came from `path`. @throws InputError as above.
  Source(const std::string& path, std::string bytes);
  ~Source();
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  int id() const { return id_; }  ///< for the netCDF library
  std::size_t n_bytes() const { return bytes_.size(); }

 private:
  Lock lock_;
  std::string bytes_;
  int id_ = -1;
};

/// The name that files in memory have for the library, which takes a real one for an address or for options (`://`,
/// `#mode=`).
inline constexpr const char* kNameInMemory = "memory.nc";

}  // namespace brash::netcdf
