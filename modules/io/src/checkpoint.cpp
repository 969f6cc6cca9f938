// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/io/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>

#include "brash/core/error.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/version.hpp"
#include "brash/core/write_pieces.hpp"
#include "brash/io/case.hpp"
#include "brash/io/recorded_case.hpp"
#include "result_tables.hpp"
#include "tables.hpp"

namespace brash::io {

namespace {

using Json = nlohmann::json;

constexpr const char* kFormat = "brash-checkpoint-11";
constexpr const char* kRowsFormat = "brash-checkpoint-rows-1";
/// Of every variable and dimension of a table: results so far are in the same file.
constexpr const char* kPrefix = "state_";

std::string dimension_of(const model::Table& table) { return kPrefix + table.name; }
std::string variable_of(const model::Table& table, const model::Column& column) {
  return dimension_of(table) + "_" + column.name;
}

constexpr const char* kind_of(const std::vector<double>&) { return "number"; }
constexpr const char* kind_of(const std::vector<std::int64_t>&) { return "whole number"; }
constexpr const char* kind_of(const std::vector<std::string>&) { return "text"; }
constexpr const char* kind_of(const std::vector<geometry::Polygon>&) { return "polygon"; }

model::ColumnValues values_of_kind(const NetcdfReader& file, const std::string& kind) {
  for (const model::ColumnValues& none :
       {model::ColumnValues(std::vector<double>{}), model::ColumnValues(std::vector<std::int64_t>{}),
        model::ColumnValues(std::vector<std::string>{}), model::ColumnValues(std::vector<geometry::Polygon>{})})
    if (std::visit([](const auto& values) { return kind_of(values); }, none) == kind) return none;
  file.refuse("a table in it has a column of an unknown kind");
}

/// The tables and their columns, without values.
Json contents(const std::vector<model::Table>& tables) {
  Json all = Json::array();
  for (const model::Table& table : tables) {
    Json columns = Json::array();
    for (const model::Column& column : table.columns) {
      const char* const kind = std::visit([](const auto& values) { return kind_of(values); }, column.values);
      columns.push_back({column.name, kind, column.unit, column.meaning});
    }
    all.push_back({{"name", table.name}, {"columns", std::move(columns)}});
  }
  return all;
}

std::vector<model::Table> tables_without_values(const NetcdfReader& file) {
  try {
    std::vector<model::Table> tables;
    for (const Json& table : Json::parse(file.attribute("tables"))) {
      tables.push_back({table.at("name"), {}});
      for (const Json& column : table.at("columns"))
        tables.back().columns.push_back(
            {column.at(0), column.at(2), column.at(3), values_of_kind(file, column.at(1).get<std::string>())});
    }
    return tables;
  } catch (const Json::exception&) {
    file.refuse("its list of tables cannot be read");
  }
}

/// The side of the grid, 2^-30 m, as a unit.
NodeFrame grid_frame(const model::Column& column) { return {"9.313225746154785e-10 m", column.meaning}; }

using Rings = std::vector<geometry::Ring>;

void write_values(NetcdfWriter& file, const model::Table& table, const model::Column& column) {
  const auto write = [&](const auto& values) {
    file.variable(variable_of(table, column), dimension_of(table), {column.unit, column.meaning}, values);
  };
  const auto write_outlines = [&](const std::vector<geometry::Polygon>& polygons) {
    write_polygons<geometry::Point>(file, variable_of(table, column), dimension_of(table), grid_frame(column),
                                    [&polygons](const auto& take) {
                                      for (const geometry::Polygon& polygon : polygons) {
                                        Rings rings{polygon.outline};
                                        rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
                                        take(rings);
                                      }
                                    });
  };
  if (const auto* const polygons = std::get_if<std::vector<geometry::Polygon>>(&column.values))
    write_outlines(*polygons);
  else if (const auto* const numbers = std::get_if<std::vector<double>>(&column.values))
    write(*numbers);
  else if (const auto* const whole = std::get_if<std::vector<std::int64_t>>(&column.values))
    write(*whole);
  else
    write(std::get<std::vector<std::string>>(column.values));
}

void write_table(NetcdfWriter& file, const model::Table& table) {
  for (const model::Column& column : table.columns) write_values(file, table, column);
}

void read_values(const NetcdfReader& file, const model::Table& table, model::Column& column) {
  const std::string name = variable_of(table, column);
  const auto read = [&](auto& values) { file.read(name, dimension_of(table), values); };
  const auto read_outlines = [&](std::vector<geometry::Polygon>& polygons) {
    for (Rings& rings : read_polygons<geometry::Point>(file, name, dimension_of(table))) {
      if (rings.empty()) file.refuse(name + " has a polygon without outline");
      geometry::Polygon& polygon = polygons.emplace_back(geometry::Polygon{std::move(rings.front()), {}});
      std::move(rings.begin() + 1, rings.end(), std::back_inserter(polygon.holes));
    }
  };
  if (auto* const polygons = std::get_if<std::vector<geometry::Polygon>>(&column.values))
    read_outlines(*polygons);
  else if (auto* const numbers = std::get_if<std::vector<double>>(&column.values))
    read(*numbers);
  else if (auto* const whole = std::get_if<std::vector<std::int64_t>>(&column.values))
    read(*whole);
  else
    read(std::get<std::vector<std::string>>(column.values));
}

model::Case read_resolved_case(const NetcdfReader& file) {
  try {
    return parse_recorded_case(file.attribute("case"), file.attribute("case_name") + ".toml", {}, ModelFile::kAnywhere);
  } catch (const InputError& error) {
    file.refuse(std::string("its case cannot be read: ") + error.what());
  }
}

[[noreturn]] void refuse_file(const std::string& path, const std::string& what) {
  throw InputError(Complaint{path, what, "a checkpoint that this version of the program wrote",
                             "use an older checkpoint, or start the run again"});
}

/// The end of a checkpoint: the digest of all before it. HDF5 ignores bytes after its own data, and does not survive
/// every damage to it.
constexpr const char* kSealMark = "brash-sha256:";

std::string seal_of(std::string_view bytes) { return kSealMark + sha256(bytes); }

/// Writes `image` with its seal. @return the digest.
std::string write_sealed(const std::string& path, const FileImage& image) {
  const std::string seal = seal_of(image.bytes());
  const std::string_view pieces[] = {image.bytes(), seal};
  write_pieces(path, [&pieces, i = std::size_t{0}](std::string_view& piece) mutable {
    if (i == std::size(pieces)) return false;
    piece = pieces[i++];
    return true;
  });
  return seal.substr(std::string_view(kSealMark).size());
}

/// The bytes of the sealed file `path`, without the seal.
std::string read_sealed(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse_file(path, "cannot be opened: " + std::generic_category().message(errno));
  // The end is checked first. A file without a seal there is not read into memory, however large it is.
  const std::size_t seal_size = seal_of("").size();
  std::string seal(seal_size, '\0');
  stream.seekg(-static_cast<std::streamoff>(seal_size), std::ios::end);
  const auto size = static_cast<std::size_t>(std::max(std::streamoff{0}, std::streamoff{stream.tellg()}));
  if (!stream.read(seal.data(), static_cast<std::streamsize>(seal_size)) || !seal.starts_with(kSealMark))
    refuse_file(path, "is not a checkpoint, or was cut short");
  std::string bytes(size, '\0');
  stream.seekg(0);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size))) refuse_file(path, "cannot be read");
  if (seal != seal_of(bytes)) refuse_file(path, "is damaged: its bytes do not have the digest at its end");
  return bytes;
}

}  // namespace

void write_checkpoint(const std::string& path, const model::Checkpoint& checkpoint) {
  write_checkpoint(path, checkpoint.resolved, checkpoint.tables, checkpoint.results);
}

void write_checkpoint(const std::string& path, const model::Case& resolved, const std::vector<model::Table>& tables,
                      const model::RunResults& results) {
  NetcdfWriter file(path);
  file.attribute("format", kFormat);
  file.attribute("source", std::string("brash ") + kVersion);
  file.attribute("case_name", resolved.name);
  file.attribute("case", to_toml(resolved));
  file.attribute("tables", contents(tables).dump());
  for (const model::Table& table : tables) write_table(file, table);
  write_tables(file, results);
  write_sealed(path, file.finish());
}

model::Checkpoint read_checkpoint(const std::string& path) {
  const NetcdfReader file(path, read_sealed(path));
  if (file.attribute("format") != kFormat) file.refuse("it is not a checkpoint of this version");
  model::Checkpoint checkpoint;
  checkpoint.resolved = read_resolved_case(file);
  checkpoint.tables = tables_without_values(file);
  for (model::Table& table : checkpoint.tables)
    for (model::Column& column : table.columns) read_values(file, table, column);
  checkpoint.results = read_tables(file);
  return checkpoint;
}

std::string write_earlier_rows(const std::string& path, const model::RunResults& rows) {
  NetcdfWriter file(path);
  file.attribute("format", kRowsFormat);
  write_tables(file, rows);
  return write_sealed(path, file.finish());
}

model::RunResults read_earlier_rows(const std::string& path, const std::string& digest) {
  std::string bytes = read_sealed(path);
  if (sha256(bytes) != digest) refuse_file(path, "holds rows of another run than its checkpoint");
  const NetcdfReader file(path, std::move(bytes));
  if (file.attribute("format") != kRowsFormat) file.refuse("it does not hold rows of a run");
  return read_tables(file);
}

}  // namespace brash::io
