// SPDX-License-Identifier: GPL-3.0-or-later
// The database file. One table a shape says name, unit and meaning of each variable and where it lives in a record;
// writing and reading walk the same tables.
#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/version.hpp"
#include "chunked_build.hpp"
#include "netcdf_file.hpp"

namespace brash::training {
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

/// Refuses numbers that no solved geometry has.
void check_solved(const Reader& file, const Record& r) {
  const auto refuse = [&](const std::string& what) { file.refuse(fmt::format("geometry {}", r.geometry), what); };
  const plate::WedgePlate& g = r.plate;
  const bool in_range =
      std::isfinite(g.depth) && g.contact_length > 0.0 && g.angle >= 0.0 && g.angle < kPi && g.thickness > 0.0;
  if (!in_range || !std::isfinite(g.depth + g.contact_length + g.thickness))
    refuse(fmt::format("b/l_c = {}, c/l_c = {}, theta = {}, h/l_c = {} is not a geometry", g.depth, g.contact_length,
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

}  // namespace

void write_database(const std::string& path, const Database& database) {
  write_whole(path, [&](const std::string& part) { write_netcdf(part, database); });
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

}  // namespace brash::training
