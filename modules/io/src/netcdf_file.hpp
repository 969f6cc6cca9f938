// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brash/netcdf/open.hpp"

namespace brash::io {

/// The meaning of a netCDF variable.
struct Meaning {
  std::string unit;  ///< UDUNITS; empty: none (containers)
  std::string long_name;
  std::vector<std::pair<std::string, std::string>> more{};  ///< other text attributes
  std::vector<std::int8_t> flag_values{};                   ///< of an enumeration, with flag_meanings in `more`
  std::vector<std::int32_t> flags{};                        ///< the same, of a variable of whole numbers
};

/// The bytes of a file, in the memory of the library that made them: a copy would double the memory of a long run.
class FileImage {
 public:
  FileImage(void* memory, std::size_t size) : memory_(memory), size_(size) {}
  std::string_view bytes() const { return {static_cast<const char*>(memory_.get()), size_}; }

 private:
  /// Also returns freed memory to the system: a run that has written a state would keep it to its end.
  struct Free {
    void operator()(void* memory) const;
  };

  std::unique_ptr<void, Free> memory_;
  std::size_t size_;
};

/// Writes the whole file `image` to `path`, as write_file().
void write_image(const std::string& path, const FileImage& image);

class NetcdfReader;

/// A netCDF-4 file that is being written, in memory: HDF5 does not survive a disk that is full. Its bytes depend
/// only on the written values.
class NetcdfWriter {
 public:
  /// @param shown  name of the file in messages.
  /// @throws RunError here and from every member when the library fails.
  explicit NetcdfWriter(std::string shown);
  ~NetcdfWriter();
  NetcdfWriter(const NetcdfWriter&) = delete;
  NetcdfWriter& operator=(const NetcdfWriter&) = delete;

  void attribute(const std::string& name, const std::string& text);
  /// Puts the values that `files` have, in their order, before those of each variable of the same name, and makes its
  /// dimension longer by as much. A file without the variable has zeros there. To be called before any variable.
  void continue_files(const std::vector<std::string>& files);
  /// Whether one of these files has the variable.
  bool continues(const std::string& variable) const;
  /// Measured quantities along `dimension` repeat, as the poses of floes at rest do: they are deflated too.
  void expect_repeats(const std::string& dimension) { repeating_.insert(dimension); }
  /// Adds a variable along `dimension`, which is made as long as `values` when it is new.
  void variable(const std::string& name, const std::string& dimension, const Meaning& meaning,
                const std::vector<double>& values);
  void variable(const std::string& name, const std::string& dimension, const Meaning& meaning,
                const std::vector<std::int64_t>& values);
  void variable(const std::string& name, const std::string& dimension, const Meaning& meaning,
                const std::vector<std::int32_t>& values);
  void variable(const std::string& name, const std::string& dimension, const Meaning& meaning,
                const std::vector<std::int8_t>& values);
  void variable(const std::string& name, const std::string& dimension, const Meaning& meaning,
                const std::vector<std::string>& values);
  /// The same for the `length` values that `values` makes when the file is finished: a column of rows, so that no more
  /// than one column at a time takes memory beside the rows.
  template <typename T>
  void column(const std::string& name, const std::string& along, const Meaning& meaning, std::size_t length,
              std::function<std::vector<T>()> values);
  /// A variable without values that carries the attributes of a CF geometry.
  void container(const std::string& name, const Meaning& meaning);
  /// The bytes of the whole file; nothing can be added afterwards.
  FileImage finish();

 private:
  /// An earlier file: the lengths of its dimensions, and its variables.
  struct Continued {
    std::string path;
    std::map<std::string, std::size_t> lengths;
    std::set<std::string> variables;
  };
  /// A variable that has no values yet: they wait until all variables are there, since each turn from making a variable
  /// to writing one would go through all of them in the library.
  struct Pending {
    std::size_t n_bytes = 0;  ///< that are in memory at a time
    std::function<void(const NetcdfReader& file, const Continued&)>
        take{};  ///< values of a file that this one continues
    std::function<void()> write{};
  };

  /// Counts values, of which `n_together` are in memory at a time. @throws std::bad_alloc without memory for them.
  void expect(std::size_t n_bytes, std::size_t n_together);
  std::size_t length_before(const std::string& dimension) const;
  void describe(int variable, const std::string& name, const Meaning& meaning);
  int dimension(const std::string& name, std::size_t length);
  void check(int status, const std::string& what) const;

  netcdf::Lock lock_;
  std::string shown_;
  int file_ = -1;
  std::vector<Pending> pending_;
  std::vector<Continued> continued_;
  std::size_t n_bytes_ = 0;     ///< of the values
  std::size_t n_together_ = 0;  ///< of those that are in memory at a time
  std::set<std::string> repeating_;
};

/// A netCDF file that is being read.
class NetcdfReader {
 public:
  /// @throws InputError here and from every member, naming file and variable.
  explicit NetcdfReader(const std::string& path);
  /// Reads the file's `bytes`, which came from `path`.
  NetcdfReader(const std::string& path, std::string bytes);
  std::string attribute(const std::string& name) const;
  /// Never more than the file's bytes can hold.
  std::size_t length(const std::string& dimension) const;
  bool has(const std::string& name) const;
  std::map<std::string, std::size_t> dimensions() const;
  std::set<std::string> variables() const;
  /// Reads the one-dimensional variable `name` along `dimension`.
  void read(const std::string& name, const std::string& dimension, std::vector<double>& values) const;
  void read(const std::string& name, const std::string& dimension, std::vector<std::int64_t>& values) const;
  void read(const std::string& name, const std::string& dimension, std::vector<std::int32_t>& values) const;
  void read(const std::string& name, const std::string& dimension, std::vector<std::int8_t>& values) const;
  void read(const std::string& name, const std::string& dimension, std::vector<std::string>& values) const;
  /// The same of `n` values from `first` on.
  template <typename T>
  void read(const std::string& name, const std::string& dimension, std::size_t first, std::size_t n,
            std::vector<T>& values) const;
  /// Throws the InputError of a file whose content makes no sense.
  [[noreturn]] void refuse(const std::string& what) const;

 private:
  /// The id of the one-dimensional variable `name` of this type along `dimension`.
  int find(const std::string& name, const std::string& dimension, int type) const;
  void check(int status, const std::string& what) const;

  std::string path_;
  netcdf::Source source_;
  std::size_t most_values_ = 0;
  int file_ = -1;
};

}  // namespace brash::io
