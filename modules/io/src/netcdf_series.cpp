// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/netcdf/open.hpp"
#include "series.hpp"

namespace brash::io {
namespace {

/// Any netCDF file, read without knowledge of its content.
class OpenFile {
 public:
  explicit OpenFile(const std::string& path) : path_(path), source_(path), id_(source_.id()) {}

  struct Variable {
    int id = -1;
    std::string name;
    int dimension = -1;
    nc_type type = NC_NAT;
  };

  /// Numeric variables along one dimension, in the file's order.
  std::vector<Variable> variables() const {
    int n = 0;
    check(nc_inq_nvars(id_, &n), "variables");
    std::vector<Variable> found;
    for (int v = 0; v < n; ++v) {
      Variable variable{v, {}, -1, NC_NAT};
      std::array<char, NC_MAX_NAME + 1> name{};
      int n_dimensions = 0;
      check(nc_inq_var(id_, v, name.data(), &variable.type, &n_dimensions, nullptr, nullptr), "variables");
      const bool numeric = variable.type != NC_CHAR && variable.type <= NC_UINT64;
      if (n_dimensions != 1 || !numeric) continue;
      check(nc_inq_vardimid(id_, v, &variable.dimension), name.data());
      variable.name = name.data();
      found.push_back(variable);
    }
    return found;
  }

  std::string text(const Variable& variable, const char* attribute) const {
    std::size_t length = 0;
    nc_type type = NC_NAT;
    if (nc_inq_att(id_, variable.id, attribute, &type, &length) != NC_NOERR || type != NC_CHAR) return "";
    std::string value(length, '\0');
    check(nc_get_att_text(id_, variable.id, attribute, value.data()), variable.name);
    return value;
  }

  /// Unpacked values, not a number where the file has a fill value.
  std::vector<double> values(const Variable& variable) const {
    std::size_t length = 0;
    check(nc_inq_dimlen(id_, variable.dimension, &length), variable.name);
    if (length > most_values_in(source_.n_bytes())) {
      refuse(variable.name, fmt::format("states {} values, more than the file's bytes can hold", length));
    }
    std::vector<double> result(length);
    if (length > 0) check(nc_get_var_double(id_, variable.id, result.data()), variable.name);
    const double fill = number(variable, "_FillValue", default_fill(variable.type));
    const std::vector<double> missing = numbers(variable, "missing_value");
    const double scale = number(variable, "scale_factor", 1.0), offset = number(variable, "add_offset", 0.0);
    for (double& value : result) {
      const bool absent = value == fill || std::ranges::find(missing, value) != missing.end() || !std::isfinite(value);
      value = absent ? std::numeric_limits<double>::quiet_NaN() : scale * value + offset;
    }
    return result;
  }

 private:
  /// None without the attribute, or if it is text.
  std::vector<double> numbers(const Variable& variable, const char* attribute) const {
    std::size_t length = 0;
    nc_type type = NC_NAT;
    if (nc_inq_att(id_, variable.id, attribute, &type, &length) != NC_NOERR) return {};
    if (type == NC_CHAR || type > NC_UINT64) return {};
    std::vector<double> values(length);
    if (length > 0) check(nc_get_att_double(id_, variable.id, attribute, values.data()), variable.name);
    return values;
  }
  double number(const Variable& variable, const char* attribute, double otherwise) const {
    const std::vector<double> values = numbers(variable, attribute);
    if (values.size() > 1)
      throw InputError(Complaint{fmt::format("{}, {}, {}", path_, variable.name, attribute),
                                 fmt::format("{} numbers", values.size()), "one number",
                                 "write one number there, for the whole variable, or leave the attribute out"});
    return values.empty() ? otherwise : values.front();
  }
  /// The fill value of the library for unwritten values; not for bytes, all of whose values are in use.
  static double default_fill(nc_type type) {
    switch (type) {
      case NC_SHORT:
        return NC_FILL_SHORT;
      case NC_INT:
        return NC_FILL_INT;
      case NC_FLOAT:
        return static_cast<double>(NC_FILL_FLOAT);
      case NC_DOUBLE:
        return NC_FILL_DOUBLE;
      default:
        return std::numeric_limits<double>::quiet_NaN();
    }
  }
  void check(int status, const std::string& what) const {
    if (status != NC_NOERR) refuse(what, nc_strerror(status));
  }
  [[noreturn]] void refuse(const std::string& where, const std::string& what) const {
    throw InputError(Complaint{path_ + ", " + where, what, "a whole netCDF file",
                               "copy or write the file again; a name that does not end in .nc is read as text"});
  }

  std::string path_;
  netcdf::Source source_;
  int id_ = -1;
};

const OpenFile::Variable* times_of(const OpenFile& file, const std::vector<OpenFile::Variable>& variables) {
  for (const OpenFile::Variable& variable : variables)
    if (is_time_name(variable.name)) return &variable;
  for (const OpenFile::Variable& variable : variables)
    if (file.text(variable, "units").find(" since ") != std::string::npos) return &variable;
  return nullptr;
}

}  // namespace

Series read_netcdf_series(const std::string& path, const std::vector<double>& missing) {
  const OpenFile file(path);
  const std::vector<OpenFile::Variable> variables = file.variables();
  const OpenFile::Variable* const times = times_of(file, variables);
  if (times == nullptr)
    throw InputError(Complaint{path, "has no times",
                               "a variable named time or t along one dimension, or one in a unit such as "
                               "'seconds since 2020-01-01'",
                               "name the variable of the times so, or write its unit"});
  Series series;
  series.row_prefix = path + ", sample ";
  for (const OpenFile::Variable& variable : variables) {
    if (variable.dimension != times->dimension) continue;
    if (&variable == times) series.time = series.names.size();
    series.names.push_back(variable.name);
    series.heads.push_back(variable.name);
    series.units.push_back(file.text(variable, "units"));
    series.columns.push_back(file.values(variable));
  }
  const double factor = seconds_in(file.text(*times, "units"), fmt::format("{}, {}", path, times->name));
  std::vector<double>& column = series.columns[*series.time];
  if (column.size() < 2)
    throw InputError(Complaint{fmt::format("{}, {}", path, times->name), fmt::format("{} samples", column.size()),
                               "2 samples at least", "check that it is the right file and whole"});
  for (std::size_t i = 0; i < column.size(); ++i) {
    series.rows.add(i + 1);
    if (std::isnan(column[i])) refuse_missing_time(series.place(i));
    column[i] *= factor;
  }
  series.units[*series.time] = "s";
  if (const std::string unit = file.text(*times, "units"); unit.find(" since ") != std::string::npos)
    series.start = unit.substr(unit.find(" since ") + 7);
  leave_out(series, missing);
  convert_to_si(series);
  return series;
}

}  // namespace brash::io
