// SPDX-License-Identifier: GPL-3.0-or-later
#include "netcdf_file.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/write_pieces.hpp"

namespace brash::io {
namespace {

/// Of whole numbers, which shrink to a hundredth at any level. Measured quantities are noise in most of their digits:
/// a run's would shrink by a sixth and take most of the time of writing. They are deflated where they repeat.
constexpr int kDeflateLevel = 1;
/// Fewer bytes are written as they are: the index of a compressed variable takes more than it saves.
constexpr std::size_t kLeastDeflated = 4096;
/// Memory that a file begins with; it grows.
constexpr std::size_t kFirstBytes = 1 << 20;
/// Values of continued files that are in memory together: each batch of variables opens all these files once.
constexpr std::size_t kBatchBytes = 32 << 20;
/// Variables of more bytes are written piece by piece.
constexpr std::size_t kMostBytesAtOnce = 4 << 20;
/// A piece. Of a deflated variable it is a chunk: the library keeps one of each variable until the file is whole, and
/// by itself it would take chunks of 16 MB.
constexpr std::size_t kBytesOfPiece = 1 << 20;

template <typename T>
constexpr nc_type kType = NC_NAT;
template <>
constexpr nc_type kType<double> = NC_DOUBLE;
template <>
constexpr nc_type kType<std::int64_t> = NC_INT64;
template <>
constexpr nc_type kType<std::int32_t> = NC_INT;
template <>
constexpr nc_type kType<std::int8_t> = NC_BYTE;

/// Asks for the memory that netCDF may take for a file of `n_bytes`, of which `n_together` are on their way into it at
/// a time. netCDF does not survive a lack of memory.
/// @throws std::bad_alloc when there is less memory.
void ask_for_memory(std::size_t n_bytes, std::size_t n_together) {
  constexpr std::size_t kRoom = 16 << 20;  // for its tables and buffers
  constexpr std::size_t kCopies = 3;       // of values on their way: as they came, in a chunk, deflated
  ::operator delete(::operator new(kRoom + n_bytes + kCopies * n_together));
}

/// Lets the library keep a chunk of a deflated variable that is read piece by piece: it would inflate the chunk again
/// for each piece.
void keep_chunk(int file, int variable, std::size_t n_bytes_of_value) {
  constexpr std::size_t kMostBytes = 64 << 20;
  int storage = NC_CONTIGUOUS;
  std::size_t length = 0;
  if (nc_inq_var_chunking(file, variable, &storage, &length) != NC_NOERR || storage != NC_CHUNKED) return;
  if (length > kMostBytes / n_bytes_of_value) return;
  nc_set_var_chunk_cache(file, variable, length * n_bytes_of_value, /*nelems=*/1, /*preemption=*/1.0F);
}

}  // namespace

void FileImage::Free::operator()(void* memory) const {
  std::free(memory);
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

void write_image(const std::string& path, const FileImage& image) {
  write_pieces(path, [&image, done = false](std::string_view& piece) mutable {
    piece = image.bytes();
    return !std::exchange(done, true);
  });
}

NetcdfWriter::NetcdfWriter(std::string shown) : shown_(std::move(shown)) {
  ask_for_memory(kFirstBytes, 0);
  check(nc_create_mem(netcdf::kNameInMemory, NC_NETCDF4, kFirstBytes, &file_), "file");
  check(nc_set_fill(file_, NC_NOFILL, nullptr), "file");
}

NetcdfWriter::~NetcdfWriter() {
  if (file_ >= 0) nc_abort(file_);
}

void NetcdfWriter::check(int status, const std::string& what) const {
  if (status == NC_NOERR) return;
  throw RunError(fmt::format("{}: {} cannot be written: {}\n  remedy:  check that there is enough memory", shown_, what,
                             nc_strerror(status)));
}

void NetcdfWriter::attribute(const std::string& name, const std::string& text) {
  check(nc_put_att_text(file_, NC_GLOBAL, name.c_str(), text.size(), text.data()), name);
}

void NetcdfWriter::continue_files(const std::vector<std::string>& files) {
  for (const std::string& path : files) {
    const NetcdfReader file(path);
    continued_.push_back({path, file.dimensions(), file.variables()});
  }
}

bool NetcdfWriter::continues(const std::string& variable) const {
  return std::ranges::any_of(continued_, [&](const Continued& file) { return file.variables.contains(variable); });
}

std::size_t NetcdfWriter::length_before(const std::string& dimension) const {
  std::size_t length = 0;
  for (const Continued& file : continued_)
    if (const auto found = file.lengths.find(dimension); found != file.lengths.end()) length += found->second;
  return length;
}

int NetcdfWriter::dimension(const std::string& name, std::size_t length) {
  int id = -1;
  if (nc_inq_dimid(file_, name.c_str(), &id) == NC_NOERR) {
    std::size_t known = 0;
    check(nc_inq_dimlen(file_, id, &known), name);
    BRASH_EXPECTS(known == length, name, known, length);
    return id;
  }
  // A length of zero makes the dimension unlimited, of length zero, as intended.
  check(nc_def_dim(file_, name.c_str(), length, &id), name);
  return id;
}

void NetcdfWriter::describe(int variable, const std::string& name, const Meaning& meaning) {
  const auto put = [&](const char* attribute, const std::string& text) {
    check(nc_put_att_text(file_, variable, attribute, text.size(), text.data()), name);
  };
  if (!meaning.unit.empty()) put("units", meaning.unit);
  put("long_name", meaning.long_name);
  for (const auto& [attribute, text] : meaning.more) put(attribute.c_str(), text);
  if (!meaning.flags.empty())
    check(nc_put_att_int(file_, variable, "flag_values", NC_INT, meaning.flags.size(), meaning.flags.data()), name);
  if (meaning.flag_values.empty()) return;
  check(
      nc_put_att_schar(file_, variable, "flag_values", NC_BYTE, meaning.flag_values.size(), meaning.flag_values.data()),
      name);
}

template <typename T>
void NetcdfWriter::column(const std::string& name, const std::string& along, const Meaning& meaning, std::size_t length,
                          std::function<std::vector<T>()> values) {
  length += length_before(along);
  const std::size_t n_bytes = length * sizeof(T);
  const bool in_pieces = n_bytes > kMostBytesAtOnce;
  const std::size_t piece = in_pieces ? kBytesOfPiece / sizeof(T) : length;
  // In pieces it makes a batch of its own: the layout of the file may not depend on where the continued files part.
  const std::size_t n_together = in_pieces && !continued_.empty() ? kBatchBytes : n_bytes;
  expect(n_bytes, n_together);
  const int dim = dimension(along, length);
  int variable = -1;
  check(nc_def_var(file_, name.c_str(), kType<T>, 1, &dim, &variable), name);
  if ((std::is_integral_v<T> || repeating_.contains(along)) && n_bytes >= kLeastDeflated) {
    check(nc_def_var_deflate(file_, variable, 1, 1, kDeflateLevel), name);
    if (in_pieces) {
      check(nc_def_var_chunking(file_, variable, NC_CHUNKED, &piece), name);
      check(nc_set_var_chunk_cache(file_, variable, kBytesOfPiece, /*nelems=*/1, /*preemption=*/1.0F), name);
    }
  }
  describe(variable, name, meaning);
  if (length == 0) return;
  struct OnTheWay {
    std::vector<T> values{};
    std::size_t n_written = 0;
  };
  const auto add = [this, name, variable, length, piece, way = std::make_shared<OnTheWay>()](std::vector<T> part) {
    if (way->values.empty())
      way->values = std::move(part);
    else
      way->values.insert(way->values.end(), part.begin(), part.end());
    const std::size_t rest = length - way->n_written, n_here = way->values.size();
    BRASH_EXPECTS(n_here <= rest, name, n_here, rest);
    const std::size_t n = n_here == rest ? rest : n_here / piece * piece;
    if (n == 0) return n_here == rest;
    check(nc_put_vara(file_, variable, &way->n_written, &n, way->values.data()), name);
    way->n_written += n;
    way->values.erase(way->values.begin(), way->values.begin() + static_cast<std::ptrdiff_t>(n));
    return n == rest;
  };
  const auto take = [name, along, add](const NetcdfReader& file, const Continued& earlier) {
    const auto n = earlier.lengths.find(along);
    if (n == earlier.lengths.end()) return;
    std::vector<T> part(n->second);
    if (earlier.variables.contains(name)) file.read(name, along, part);
    add(std::move(part));
  };
  const auto write = [name, add, values = std::move(values)] {
    const bool is_whole = add(values());
    BRASH_EXPECTS(is_whole, name);
  };
  pending_.push_back({n_together, take, write});
}

template void NetcdfWriter::column(const std::string&, const std::string&, const Meaning&, std::size_t,
                                   std::function<std::vector<double>()>);
template void NetcdfWriter::column(const std::string&, const std::string&, const Meaning&, std::size_t,
                                   std::function<std::vector<std::int64_t>()>);
template void NetcdfWriter::column(const std::string&, const std::string&, const Meaning&, std::size_t,
                                   std::function<std::vector<std::int32_t>()>);
template void NetcdfWriter::column(const std::string&, const std::string&, const Meaning&, std::size_t,
                                   std::function<std::vector<std::int8_t>()>);

void NetcdfWriter::variable(const std::string& name, const std::string& dimension, const Meaning& meaning,
                            const std::vector<double>& values) {
  column<double>(name, dimension, meaning, values.size(), [values] { return values; });
}
void NetcdfWriter::variable(const std::string& name, const std::string& dimension, const Meaning& meaning,
                            const std::vector<std::int64_t>& values) {
  column<std::int64_t>(name, dimension, meaning, values.size(), [values] { return values; });
}
void NetcdfWriter::variable(const std::string& name, const std::string& dimension, const Meaning& meaning,
                            const std::vector<std::int32_t>& values) {
  column<std::int32_t>(name, dimension, meaning, values.size(), [values] { return values; });
}
void NetcdfWriter::variable(const std::string& name, const std::string& dimension, const Meaning& meaning,
                            const std::vector<std::int8_t>& values) {
  column<std::int8_t>(name, dimension, meaning, values.size(), [values] { return values; });
}

void NetcdfWriter::variable(const std::string& name, const std::string& along, const Meaning& meaning,
                            const std::vector<std::string>& values) {
  std::size_t n_bytes = 0;
  for (const std::string& value : values) n_bytes += value.size();
  expect(n_bytes, n_bytes);
  const int dim = dimension(along, values.size());
  int variable = -1;
  check(nc_def_var(file_, name.c_str(), NC_STRING, 1, &dim, &variable), name);
  describe(variable, name, meaning);
  BRASH_EXPECTS(length_before(along) == 0, name);
  const auto write = [this, name, variable, values] {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const char* text = values[i].c_str();
      check(nc_put_var1_string(file_, variable, &i, &text), name);
    }
  };
  pending_.push_back({.write = write});
}

void NetcdfWriter::container(const std::string& name, const Meaning& meaning) {
  int variable = -1;
  check(nc_def_var(file_, name.c_str(), NC_INT, 0, nullptr, &variable), name);
  describe(variable, name, meaning);
  const auto write = [this, name, variable] {
    const int nothing = 0;
    check(nc_put_var_int(file_, variable, &nothing), name);
  };
  pending_.push_back({.write = write});
}

void NetcdfWriter::expect(std::size_t n_bytes, std::size_t n_together) {
  n_bytes_ += n_bytes;
  n_together_ = std::max(n_together_, n_together);
  ask_for_memory(n_bytes_, std::max(n_together_, continued_.empty() ? 0 : kBatchBytes));
}

FileImage NetcdfWriter::finish() {
  expect(0, 0);
  check(nc_enddef(file_), "file");
  for (auto next = pending_.begin(); next != pending_.end();) {
    const auto first = next;
    for (std::size_t n_bytes = 0; next != pending_.end() && (next == first || n_bytes + next->n_bytes <= kBatchBytes);)
      n_bytes += (next++)->n_bytes;
    for (const Continued& earlier : continued_) {
      const NetcdfReader file(earlier.path);
      for (auto one = first; one != next; ++one)
        if (one->take) one->take(file, earlier);
    }
    for (auto one = first; one != next; ++one) {
      one->write();
      *one = {};
    }
  }
  NC_memio image{};
  const int file = std::exchange(file_, -1);
  check(nc_close_memio(file, &image), "file");
  return {image.memory, image.size};
}

NetcdfReader::NetcdfReader(const std::string& path)
    : path_(path), source_(path), most_values_(most_values_in(source_.n_bytes())), file_(source_.id()) {}

NetcdfReader::NetcdfReader(const std::string& path, std::string bytes)
    : path_(path),
      source_(path, std::move(bytes)),
      most_values_(most_values_in(source_.n_bytes())),
      file_(source_.id()) {}

void NetcdfReader::refuse(const std::string& what) const {
  throw InputError(
      Complaint{path_, what, "a whole file that this version of the program wrote", "copy or write it again"});
}

void NetcdfReader::check(int status, const std::string& what) const {
  if (status != NC_NOERR) refuse(fmt::format("{} cannot be read: {}", what, nc_strerror(status)));
}

std::string NetcdfReader::attribute(const std::string& name) const {
  std::size_t length = 0;
  nc_type type = NC_NAT;
  check(nc_inq_att(file_, NC_GLOBAL, name.c_str(), &type, &length), name);
  if (type != NC_CHAR) refuse(name + " is not a text");
  std::string text(length, '\0');
  check(nc_get_att_text(file_, NC_GLOBAL, name.c_str(), text.data()), name);
  return text;
}

std::size_t NetcdfReader::length(const std::string& dimension) const {
  int id = -1;
  std::size_t result = 0;
  check(nc_inq_dimid(file_, dimension.c_str(), &id), dimension);
  check(nc_inq_dimlen(file_, id, &result), dimension);
  if (result > most_values_)
    refuse(fmt::format("{} states {} values, more than the file's bytes can hold", dimension, result));
  return result;
}

int NetcdfReader::find(const std::string& name, const std::string& dimension, int wanted_type) const {
  int expected = -1;
  int variable = -1;
  int n_dimensions = 0;
  nc_type type = NC_NAT;
  check(nc_inq_dimid(file_, dimension.c_str(), &expected), dimension);
  check(nc_inq_varid(file_, name.c_str(), &variable), name);
  check(nc_inq_var(file_, variable, nullptr, &type, &n_dimensions, nullptr, nullptr), name);
  int found = -1;
  if (n_dimensions == 1) check(nc_inq_vardimid(file_, variable, &found), name);
  if (found != expected || type != wanted_type) refuse(fmt::format("{} has another type or shape", name));
  return variable;
}

bool NetcdfReader::has(const std::string& name) const {
  int variable = 0;
  return nc_inq_varid(file_, name.c_str(), &variable) == NC_NOERR;
}

std::map<std::string, std::size_t> NetcdfReader::dimensions() const {
  int n = 0;
  check(nc_inq_ndims(file_, &n), "dimensions");
  std::map<std::string, std::size_t> all;
  for (int id = 0; id < n; ++id) {
    char name[NC_MAX_NAME + 1] = {};
    check(nc_inq_dimname(file_, id, name), "dimensions");
    all[name] = length(name);
  }
  return all;
}

std::set<std::string> NetcdfReader::variables() const {
  int n = 0;
  check(nc_inq_nvars(file_, &n), "variables");
  std::set<std::string> all;
  for (int id = 0; id < n; ++id) {
    char name[NC_MAX_NAME + 1] = {};
    check(nc_inq_varname(file_, id, name), "variables");
    all.insert(name);
  }
  return all;
}

template <typename T>
void NetcdfReader::read(const std::string& name, const std::string& dimension, std::size_t first, std::size_t n,
                        std::vector<T>& values) const {
  const int variable = find(name, dimension, kType<T>);
  if (first == 0 && n < length(dimension)) keep_chunk(file_, variable, sizeof(T));
  values.resize(n);
  if (n > 0) check(nc_get_vara(file_, variable, &first, &n, values.data()), name);
}

template void NetcdfReader::read(const std::string&, const std::string&, std::size_t, std::size_t,
                                 std::vector<double>&) const;
template void NetcdfReader::read(const std::string&, const std::string&, std::size_t, std::size_t,
                                 std::vector<std::int64_t>&) const;
template void NetcdfReader::read(const std::string&, const std::string&, std::size_t, std::size_t,
                                 std::vector<std::int32_t>&) const;
template void NetcdfReader::read(const std::string&, const std::string&, std::size_t, std::size_t,
                                 std::vector<std::int8_t>&) const;

void NetcdfReader::read(const std::string& name, const std::string& dimension, std::vector<std::string>& values) const {
  const int variable = find(name, dimension, NC_STRING);
  values.resize(length(dimension));
  for (std::size_t i = 0; i < values.size(); ++i) {
    char* text = nullptr;
    check(nc_get_var1_string(file_, variable, &i, &text), name);
    if (text != nullptr) values[i] = text;
    nc_free_string(1, &text);
  }
}

void NetcdfReader::read(const std::string& name, const std::string& dimension, std::vector<double>& values) const {
  read(name, dimension, 0, length(dimension), values);
}
void NetcdfReader::read(const std::string& name, const std::string& dimension,
                        std::vector<std::int64_t>& values) const {
  read(name, dimension, 0, length(dimension), values);
}
void NetcdfReader::read(const std::string& name, const std::string& dimension,
                        std::vector<std::int32_t>& values) const {
  read(name, dimension, 0, length(dimension), values);
}
void NetcdfReader::read(const std::string& name, const std::string& dimension, std::vector<std::int8_t>& values) const {
  read(name, dimension, 0, length(dimension), values);
}

}  // namespace brash::io
