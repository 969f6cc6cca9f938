// SPDX-License-Identifier: GPL-3.0-or-later
// The database file. One table a shape says name, unit and meaning of each variable and where it lives in a record;
// writing and reading walk the same tables.
#include "store.hpp"

#include <fmt/format.h>
#include <netcdf.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <system_error>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/version.hpp"
#include "brash/core/write_file.hpp"
#include "brash/netcdf/open.hpp"

namespace brash::database {
namespace {

using plate::UnitProfiles;

template <typename Owner, typename... Index>
struct Variable {
  const char* name;
  const char* unit;
  const char* meaning;
  double& (*value)(Owner&, Index...);
};

constexpr std::array<Variable<Record>, 8> kRecordVariables{{
    {"depth", "1", "b / l_c", [](Record& r) -> double& { return r.plate.depth; }},
    {"contact_length", "1", "c / l_c", [](Record& r) -> double& { return r.plate.contact_length; }},
    {"angle", "rad", "theta, full opening angle", [](Record& r) -> double& { return r.plate.angle; }},
    {"thickness", "1", "h / l_c", [](Record& r) -> double& { return r.plate.thickness; }},
    {"root_bending", "1", "largest principal moment at the re-entrant roots, under P",
     [](Record& r) -> double& { return r.profiles.root_bending; }},
    {"root_normal", "1", "largest principal membrane stress there, under N",
     [](Record& r) -> double& { return r.profiles.root_normal; }},
    {"root_tangential", "1", "largest absolute principal membrane stress there, under f",
     [](Record& r) -> double& { return r.profiles.root_tangential; }},
    {"buckling_load", "1", "N / sqrt(k D) at which the plate buckles",
     [](Record& r) -> double& { return r.profiles.in_plane.buckling_load; }},
}};

// On the centre line symmetry leaves xx and yy of bending and normal load, and xy of the tangential one.
constexpr std::array<Variable<UnitProfiles, std::size_t>, 15> kStationVariables{{
    {"station", "1", "|AB| / l_c", [](UnitProfiles& p, std::size_t i) -> double& { return p.station[i]; }},
    {"bending_xx", "1", "moment over P l_c", [](UnitProfiles& p, std::size_t i) -> double& { return p.bending[i].xx; }},
    {"bending_yy", "1", "moment over P l_c", [](UnitProfiles& p, std::size_t i) -> double& { return p.bending[i].yy; }},
    {"bending_xy", "1", "moment over P l_c", [](UnitProfiles& p, std::size_t i) -> double& { return p.bending[i].xy; }},
    {"normal_xx", "1", "stress over p, N", [](UnitProfiles& p, std::size_t i) -> double& { return p.normal[i].xx; }},
    {"normal_yy", "1", "stress over p, N", [](UnitProfiles& p, std::size_t i) -> double& { return p.normal[i].yy; }},
    {"normal_xy", "1", "stress over p, N", [](UnitProfiles& p, std::size_t i) -> double& { return p.normal[i].xy; }},
    {"tangential_xx", "1", "stress over p, f",
     [](UnitProfiles& p, std::size_t i) -> double& { return p.tangential[i].xx; }},
    {"tangential_yy", "1", "stress over p, f",
     [](UnitProfiles& p, std::size_t i) -> double& { return p.tangential[i].yy; }},
    {"tangential_xy", "1", "stress over p, f",
     [](UnitProfiles& p, std::size_t i) -> double& { return p.tangential[i].xy; }},
    {"deflection", "1", "w k l_c / P", [](UnitProfiles& p, std::size_t i) -> double& { return p.deflection[i]; }},
    {"first_xx", "1", "in-plane term of first degree of the moment",
     [](UnitProfiles& p, std::size_t i) -> double& { return p.in_plane.first[i].xx; }},
    {"first_yy", "1", "in-plane term of first degree of the moment",
     [](UnitProfiles& p, std::size_t i) -> double& { return p.in_plane.first[i].yy; }},
    {"rest_xx", "1", "in-plane terms of higher degree of the moment",
     [](UnitProfiles& p, std::size_t i) -> double& { return p.in_plane.rest[i].xx; }},
    {"rest_yy", "1", "in-plane terms of higher degree of the moment",
     [](UnitProfiles& p, std::size_t i) -> double& { return p.in_plane.rest[i].yy; }},
}};

constexpr std::array<Variable<Row>, 8> kRowVariables{{
    {"mu1", "1", "P / N", [](Row& r) -> double& { return r.load.mu1; }},
    {"mu2", "1", "f / N", [](Row& r) -> double& { return r.load.mu2; }},
    {"sigma_over_p", "1", "largest principal stress on the centre line over p",
     [](Row& r) -> double& { return r.response.sigma_over_p; }},
    {"lbreak_over_lc", "1", "its place |AB| / l_c", [](Row& r) -> double& { return r.response.lbreak_over_lc; }},
    {"plateau_from", "1", "start of the 99 % plateau", [](Row& r) -> double& { return r.response.plateau_from; }},
    {"plateau_to", "1", "end of the 99 % plateau", [](Row& r) -> double& { return r.response.plateau_to; }},
    {"sigma_radial_over_p", "1", "stress along the edge at B, other surface, over p",
     [](Row& r) -> double& { return r.response.sigma_radial_over_p; }},
    {"sigma_root_over_p", "1", "bound on the stress at the re-entrant roots over p",
     [](Row& r) -> double& { return r.response.sigma_root_over_p; }},
}};

void resize(UnitProfiles& p, std::size_t n) {
  p.station.resize(n);
  p.bending.resize(n);
  p.normal.resize(n);
  p.tangential.resize(n);
  p.deflection.resize(n);
  p.in_plane.first.resize(n);
  p.in_plane.rest.resize(n);
}

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

struct Shape {
  std::size_t n_records = 0, n_stations = 0, n_rows = 0;
};

Shape shape_of(const Database& database) {
  Shape shape{.n_records = database.records.size()};
  for (const Record& r : database.records) {
    shape.n_stations = std::max(shape.n_stations, r.profiles.station.size());
    shape.n_rows = std::max(shape.n_rows, r.rows.size());
  }
  return shape;
}

void put_doubles(Writer& file, const char* name, const std::vector<double>& values) {
  if (!values.empty()) file.check(nc_put_var_double(file.id(), file.variable(name), values.data()), name);
}

void define_variables(Writer& file, const Shape& shape) {
  int record = 0, station = 0, row = 0;
  file.check(nc_def_dim(file.id(), "geometry", shape.n_records, &record), "geometry");
  // A dimension of length 0 would be an unlimited one.
  file.check(nc_def_dim(file.id(), "centre_line", std::max<std::size_t>(1, shape.n_stations), &station), "centre_line");
  file.check(nc_def_dim(file.id(), "load", std::max<std::size_t>(1, shape.n_rows), &row), "load");
  file.define("index", NC_INT, {record}, "1", "index of the geometry in the design");
  file.define("solved", NC_INT, {record}, "1", "row status: 1 solved, 0 not solved, see `error`");
  file.define("n_elements", NC_INT, {record}, "1", "elements of the mesh");
  file.define("n_stations", NC_INT, {record}, "1", "stations on the centre line that are in use");
  file.define("n_loads", NC_INT, {record}, "1", "load points that are in use");
  file.define("error", NC_STRING, {record}, "", "why the geometry was not solved");
  for (const auto& v : kRecordVariables) file.define(v.name, NC_DOUBLE, {record}, v.unit, v.meaning);
  for (const auto& v : kStationVariables) file.define(v.name, NC_DOUBLE, {record, station}, v.unit, v.meaning);
  for (const auto& v : kRowVariables) file.define(v.name, NC_DOUBLE, {record, row}, v.unit, v.meaning);
}

void put_integers(Writer& file, const std::vector<Record>& records) {
  const auto put = [&](const char* name, auto value) {
    std::vector<int> values;
    for (const Record& r : records) values.push_back(static_cast<int>(value(r)));
    file.check(nc_put_var_int(file.id(), file.variable(name), values.data()), name);
  };
  put("index", [](const Record& r) { return r.geometry; });
  put("solved", [](const Record& r) { return r.solved; });
  put("n_elements", [](const Record& r) { return r.profiles.n_elements; });
  put("n_stations", [](const Record& r) { return r.profiles.station.size(); });
  put("n_loads", [](const Record& r) { return r.rows.size(); });
  std::vector<const char*> messages;
  for (const Record& r : records) messages.push_back(r.error.c_str());
  file.check(nc_put_var_string(file.id(), file.variable("error"), messages.data()), "error");
}

void put_records(Writer& file, std::vector<Record> records, const Shape& shape) {
  constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();
  for (const auto& v : kRecordVariables) {
    std::vector<double> values;
    for (Record& r : records) values.push_back(v.value(r));
    put_doubles(file, v.name, values);
  }
  for (const auto& v : kStationVariables) {
    std::vector<double> values(shape.n_records * std::max<std::size_t>(1, shape.n_stations), kAbsent);
    for (std::size_t g = 0; g < records.size(); ++g) {
      UnitProfiles& p = records[g].profiles;
      for (std::size_t i = 0; i < p.station.size(); ++i) values[g * shape.n_stations + i] = v.value(p, i);
    }
    put_doubles(file, v.name, values);
  }
  for (const auto& v : kRowVariables) {
    std::vector<double> values(shape.n_records * std::max<std::size_t>(1, shape.n_rows), kAbsent);
    for (std::size_t g = 0; g < records.size(); ++g) {
      for (std::size_t i = 0; i < records[g].rows.size(); ++i) {
        values[g * shape.n_rows + i] = v.value(records[g].rows[i]);
      }
    }
    put_doubles(file, v.name, values);
  }
}

std::vector<std::string> read_messages(const Reader& file, std::size_t n) {
  std::vector<char*> raw(n, nullptr);
  file.expect_size("error", n);
  file.check(nc_get_var_string(file.id(), file.variable("error"), raw.data()), "error");
  std::vector<std::string> messages;
  for (const char* message : raw) messages.emplace_back(message == nullptr ? "" : message);
  file.check(nc_free_string(n, raw.data()), "error");
  return messages;
}

/// Refuses numbers that no solved geometry has.
void check_solved(const Reader& file, const Record& r) {
  const auto refuse = [&](const std::string& what) { file.refuse(fmt::format("geometry {}", r.geometry), what); };
  const plate::WedgePlate& g = r.plate;
  const bool in_range =
      g.depth >= 0.0 && g.contact_length > 0.0 && g.angle >= 0.0 && g.angle < kPi && g.thickness > 0.0;
  if (!in_range || !std::isfinite(g.depth + g.contact_length + g.thickness))
    refuse(fmt::format("b/l_c = {}, c/l_c = {}, theta = {}, h/l_c = {} is no geometry", g.depth, g.contact_length,
                       g.angle, g.thickness));
  if (r.profiles.station.size() < 2 || r.rows.empty()) refuse("is solved, but has no profile or no load");
  UnitProfiles profiles = r.profiles;
  for (const auto& v : kStationVariables)
    for (std::size_t i = 0; i < profiles.station.size(); ++i)
      if (!std::isfinite(v.value(profiles, i))) refuse(fmt::format("{} has a value that is not finite", v.name));
  if (std::ranges::adjacent_find(profiles.station, std::greater_equal<>()) != profiles.station.end())
    refuse("has stations that do not rise");
  for (Row row : r.rows)
    for (const auto& v : kRowVariables)
      if (!std::isfinite(v.value(row))) refuse(fmt::format("{} has a value that is not finite", v.name));
}

void read_values(const Reader& file, std::vector<Record>& records) {
  const std::size_t n = records.size(), n_stations = file.dimension("centre_line"), n_rows = file.dimension("load");
  for (const auto& v : kRecordVariables) {
    const auto values = file.doubles(v.name, n);
    for (std::size_t g = 0; g < n; ++g) v.value(records[g]) = values[g];
  }
  for (const auto& v : kStationVariables) {
    const auto values = file.doubles(v.name, n * n_stations);
    for (std::size_t g = 0; g < n; ++g) {
      UnitProfiles& p = records[g].profiles;
      for (std::size_t i = 0; i < p.station.size(); ++i) v.value(p, i) = values[g * n_stations + i];
    }
  }
  for (const auto& v : kRowVariables) {
    const auto values = file.doubles(v.name, n * n_rows);
    for (std::size_t g = 0; g < n; ++g) {
      auto& rows = records[g].rows;
      for (std::size_t i = 0; i < rows.size(); ++i) v.value(rows[i]) = values[g * n_rows + i];
    }
  }
}

void write_netcdf(const std::string& path, const Database& database) {
  const Shape shape = shape_of(database);
  Writer file(path, Writer::New{});
  define_variables(file, shape);
  file.put_text("title", "Failure of a floating plate with a trapezoidal protrusion, by linear plate theory");
  file.put_text("source", fmt::format("brash {}", kVersion));
  file.put_text("plan", database.plan);
  file.put_text("plan_sha256", database.plan_sha256);
  file.put_text("stress", "sigma / p = 6 mu1 / thickness * bending + normal + mu2 * tangential");
  file.check(nc_enddef(file.id()), "definitions");
  put_integers(file, database.records);
  put_records(file, database.records, shape);
  file.close();
}

/// write_netcdf in a process of its own: HDF5 does not survive a disk that is full, not even to its exit.
/// @return 0, or the system's error number.
int write_apart(const std::string& path, const Database& database) {
  // A file that has the name of a part already, a link too, is never opened.
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) return errno;
  const pid_t writer = ::fork();
  if (writer < 0) return errno;
  if (writer == 0) {
    errno = 0;
    try {
      write_netcdf(path, database);
    } catch (const std::exception&) {
      ::_exit(errno > 0 && errno < 256 ? errno : EIO);
    }
    ::_exit(0);
  }
  int ended = 0;
  while (::waitpid(writer, &ended, 0) < 0)
    if (errno != EINTR) return errno;
  return WIFEXITED(ended) ? WEXITSTATUS(ended) : EIO;
}

}  // namespace

void write_database(const std::string& path, const Database& database) {
  const std::string part = part_of(path);
  if (const int status = write_apart(part, database); status != 0) {
    std::remove(part.c_str());
    throw StorageError(
        fmt::format("{}: cannot be written: {}\n  remedy:  check that its folder may be written and has space", path,
                    std::generic_category().message(status)));
  }
  publish(part, path);
}

Database read_database(const std::string& path) {
  const Reader file(path);
  Database database{.plan = file.text("plan"), .plan_sha256 = file.text("plan_sha256")};
  if (sha256(database.plan) != database.plan_sha256) {
    file.refuse("plan_sha256", "does not fit the plan: the file was changed");
  }
  const std::size_t n = file.dimension("geometry");
  const std::size_t most_stations = file.dimension("centre_line"), most_rows = file.dimension("load");
  const auto index = file.ints("index", n), solved = file.ints("solved", n), n_elements = file.ints("n_elements", n);
  const auto n_stations = file.ints("n_stations", n), n_rows = file.ints("n_loads", n);
  const auto messages = read_messages(file, n);
  for (std::size_t g = 0; g < n; ++g) {
    const auto stations = static_cast<std::size_t>(n_stations[g]), rows = static_cast<std::size_t>(n_rows[g]);
    if (stations > most_stations || rows > most_rows) {
      file.refuse(fmt::format("geometry {}", index[g]), "has more stations or loads than the file");
    }
    Record r{.geometry = index[g], .solved = solved[g] == 1, .error = messages[g]};
    r.profiles.n_elements = n_elements[g];
    resize(r.profiles, stations);
    r.rows.resize(rows);
    database.records.push_back(std::move(r));
  }
  read_values(file, database.records);
  for (const Record& r : database.records)
    if (r.solved) check_solved(file, r);
  return database;
}

}  // namespace brash::database
