// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "brash/core/constants.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/version.hpp"
#include "chunked_build.hpp"
#include "netcdf_file.hpp"

namespace brash::training {
namespace {

using plate::EdgeResponses;

struct Scalar {
  const char* name;
  const char* unit;
  const char* meaning;
  double& (*value)(EdgeRecord&);
};
constexpr std::array<Scalar, 7> kScalars{{
    {"depth", "1", "b / l_c", [](EdgeRecord& r) -> double& { return r.geometry.depth; }},
    {"contact_length", "1", "c / l_c", [](EdgeRecord& r) -> double& { return r.geometry.contact_length; }},
    {"angle", "rad", "theta, full opening angle", [](EdgeRecord& r) -> double& { return r.geometry.angle; }},
    {"mass_ratio", "1", "rho_i h / (rho_w l_c)", [](EdgeRecord& r) -> double& { return r.geometry.mass_ratio; }},
    {"thickness", "1", "h / l_c", [](EdgeRecord& r) -> double& { return r.geometry.thickness; }},
    {"static_deflection", "1", "w rho_w g l_c / Q of B at rest",
     [](EdgeRecord& r) -> double& { return r.responses.static_deflection; }},
    {"static_edge_moment", "1", "yy at B over Q l_c at rest",
     [](EdgeRecord& r) -> double& { return r.responses.static_edge_moment; }},
}};
constexpr Scalar kEdgeNormal{"edge_normal", "1", "membrane stress yy at B over p, under N",
                             [](EdgeRecord& r) -> double& { return r.responses.edge_normal; }};

/// How long a series is, in times and stations.
struct Extent {
  bool times = false;
  bool stations = false;
};
struct Series {
  const char* name;
  const char* meaning;
  Extent extent;
  std::vector<double> EdgeResponses::*values;
};
constexpr std::array<Series, 7> kSeries{{
    {"time", "t / sqrt(l_c / g)", {true, false}, &EdgeResponses::time},
    {"station", "|AB| / l_c", {false, true}, &EdgeResponses::station},
    {"deflection", "w rho_w g l_c / Q of B under a ramp, over t", {true, false}, &EdgeResponses::deflection},
    {"edge_moment", "yy at B over Q l_c under a ramp, over t", {true, false}, &EdgeResponses::edge_moment},
    {"axis_moment", "xx over Q l_c under a ramp, over t", {true, true}, &EdgeResponses::axis_moment},
    {"static_axis_moment", "xx over Q l_c at rest", {false, true}, &EdgeResponses::static_axis_moment},
    {"axis_normal", "membrane stress xx over p, under N", {false, true}, &EdgeResponses::axis_normal},
}};

struct Shape {
  std::size_t n_records = 0, n_times = 1, n_stations = 1;

  std::size_t of(Extent extent) const { return (extent.times ? n_times : 1) * (extent.stations ? n_stations : 1); }
};

Shape shape_of(const EdgeDatabase& database) {
  Shape shape{.n_records = database.records.size()};
  for (const EdgeRecord& r : database.records) {
    shape.n_times = std::max(shape.n_times, r.responses.time.size());
    shape.n_stations = std::max(shape.n_stations, r.responses.station.size());
  }
  return shape;
}

void define_variables(Writer& file, const Shape& shape) {
  int record = 0, time = 0, station = 0;
  file.check(nc_def_dim(file.id(), "geometry", shape.n_records, &record), "geometry");
  file.check(nc_def_dim(file.id(), "instant", shape.n_times, &time), "instant");
  file.check(nc_def_dim(file.id(), "centre_line", shape.n_stations, &station), "centre_line");
  file.define("index", NC_INT, {record}, "1", "index of the geometry in the design");
  file.define("solved", NC_INT, {record}, "1", "row status: 1 solved, 0 not solved, see `error`");
  file.define("split", NC_INT, {record}, "1", "1: by a radial crack");
  file.define("error", NC_STRING, {record}, "", "why the geometry was not solved");
  for (const auto& v : kScalars) file.define(v.name, NC_DOUBLE, {record}, v.unit, v.meaning);
  file.define(kEdgeNormal.name, NC_DOUBLE, {record}, kEdgeNormal.unit, kEdgeNormal.meaning);
  for (const auto& v : kSeries) {
    std::vector<int> dimensions{record};
    if (v.extent.times) dimensions.push_back(time);
    if (v.extent.stations) dimensions.push_back(station);
    file.define(v.name, NC_DOUBLE, dimensions, "1", v.meaning);
  }
}

void put_records(Writer& file, std::vector<EdgeRecord> records, const Shape& shape) {
  const auto put_ints = [&](const char* name, auto value) {
    std::vector<int> values;
    for (const EdgeRecord& r : records) values.push_back(static_cast<int>(value(r)));
    file.check(nc_put_var_int(file.id(), file.variable(name), values.data()), name);
  };
  put_ints("index", [](const EdgeRecord& r) { return r.index; });
  put_ints("solved", [](const EdgeRecord& r) { return r.solved; });
  put_ints("split", [](const EdgeRecord& r) { return r.geometry.split; });
  std::vector<const char*> messages;
  for (const EdgeRecord& r : records) messages.push_back(r.error.c_str());
  file.check(nc_put_var_string(file.id(), file.variable("error"), messages.data()), "error");
  const auto put_scalar = [&](const Scalar& v) {
    std::vector<double> values;
    for (EdgeRecord& r : records) values.push_back(v.value(r));
    put_doubles(file, v.name, values);
  };
  for (const auto& v : kScalars) put_scalar(v);
  put_scalar(kEdgeNormal);
  for (const auto& v : kSeries) {
    std::vector<double> values;
    for (const EdgeRecord& r : records) {
      const auto& of_record = r.responses.*v.values;
      values.insert(values.end(), of_record.begin(), of_record.end());
      values.resize(values.size() + shape.of(v.extent) - of_record.size(), std::numeric_limits<double>::quiet_NaN());
    }
    put_doubles(file, v.name, values);
  }
}

void write_netcdf(const std::string& path, const EdgeDatabase& database) {
  const Shape shape = shape_of(database);
  Writer file(path, Writer::New{});
  define_variables(file, shape);
  file.put_text("title", "How a moving edge of a floating plate with a trapezoidal protrusion answers a growing load");
  file.put_text("source", fmt::format("brash {}", kVersion));
  file.put_text("plan", database.plan);
  file.put_text("plan_sha256", database.plan_sha256);
  file.check(nc_enddef(file.id()), "definitions");
  put_records(file, database.records, shape);
  file.close();
}

/// Refuses numbers that no solved geometry has.
void check_solved(const Reader& file, const EdgeRecord& r) {
  const auto refuse = [&](const std::string& what) { file.refuse(fmt::format("geometry {}", r.index), what); };
  const plate::EdgeGeometry& g = r.geometry;
  if (!(std::isfinite(g.depth) && g.contact_length > 0.0 && g.angle >= 0.0 && g.angle < kPi && g.thickness > 0.0 &&
        g.mass_ratio > 0.0))
    refuse("is not a geometry");
  for (const auto& v : kSeries)
    for (const double value : r.responses.*v.values)
      if (!std::isfinite(value)) refuse(fmt::format("{} has a value that is not finite", v.name));
  for (const auto* rising : {&r.responses.time, &r.responses.station})
    if (std::ranges::adjacent_find(*rising, std::greater_equal<>()) != rising->end())
      refuse("has times or stations that do not rise");
}

}  // namespace

void write_edge_database(const std::string& path, const EdgeDatabase& database) {
  write_whole(path, [&](const std::string& part) { write_netcdf(part, database); });
}

bool is_edge_database(const std::string& path) {
  const Reader file(path);
  int dimension = 0;
  return nc_inq_dimid(file.id(), "instant", &dimension) == NC_NOERR;
}

EdgeDatabase read_edge_database(const std::string& path) {
  const Reader file(path);
  EdgeDatabase database{.plan = file.text("plan"), .plan_sha256 = file.text("plan_sha256")};
  if (sha256(database.plan) != database.plan_sha256)
    file.refuse("plan_sha256", "does not fit the plan: the file was changed");
  const Shape shape{file.dimension("geometry"), file.dimension("instant"), file.dimension("centre_line")};
  const std::size_t n = shape.n_records;
  const auto index = file.ints("index", n), solved = file.ints("solved", n), split = file.ints("split", n);
  const auto messages = read_messages(file, n);
  for (std::size_t i = 0; i < n; ++i) {
    EdgeRecord r{.index = index[i], .solved = solved[i] == 1, .error = messages[i]};
    r.geometry.split = split[i] == 1;
    database.records.push_back(std::move(r));
  }
  const auto read_scalar = [&](const Scalar& v) {
    const auto values = file.doubles(v.name, n);
    for (std::size_t i = 0; i < n; ++i) v.value(database.records[i]) = values[i];
  };
  for (const auto& v : kScalars) read_scalar(v);
  read_scalar(kEdgeNormal);
  for (const auto& v : kSeries) {
    const std::size_t size = shape.of(v.extent);
    const auto values = file.doubles(v.name, n * size);
    for (std::size_t i = 0; i < n; ++i) {
      const auto from = values.begin() + static_cast<std::ptrdiff_t>(i * size);
      if (database.records[i].solved)
        (database.records[i].responses.*v.values).assign(from, from + static_cast<std::ptrdiff_t>(size));
    }
  }
  for (const EdgeRecord& r : database.records)
    if (r.solved) check_solved(file, r);
  return database;
}

}  // namespace brash::training
