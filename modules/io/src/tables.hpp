// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "brash/io/result_columns.hpp"
#include "netcdf_file.hpp"

namespace brash::io {

/// How a member of a row is stored: flags as bytes, numbers as they are.
template <typename T>
struct Stored {
  using Type = T;
};
template <>
struct Stored<bool> {
  using Type = std::int8_t;
};
template <>
struct Stored<model::FloeEnd> {
  using Type = std::int8_t;
};

inline void add_flags(Meaning& meaning, model::FloeEnd) {
  meaning.flag_values = {0, 1, 2};
  meaning.more = {{"flag_meanings", "alive crushed broken"}};
}
template <typename T>
void add_flags(Meaning&, T) {}

/// A visitor of Columns<Row> that writes each as a variable along the rows' dimension.
/// @param length         of the rows.
/// @param for_each_row   calls its argument with each row, when the file is finished: the rows must live until then.
/// @param geometry       container of the rows' polygons, as write_polygons() names it; empty: none.
template <typename Row, typename ForEachRow>
auto column_writer(NetcdfWriter& file, std::size_t length, ForEachRow for_each_row, const std::string& geometry = "") {
  return [=, &file](const std::string& name, const char* unit, const std::string& meaning, auto member) {
    using Member = std::remove_cvref_t<decltype(member(std::declval<const Row&>()))>;
    using Value = typename Stored<Member>::Type;
    Meaning described{unit, meaning};
    add_flags(described, Member{});
    if (!geometry.empty()) described.more.emplace_back("geometry", geometry);
    file.column<Value>(Columns<Row>::prefix + name, Columns<Row>::dimension, described, length,
                       [length, for_each_row, member] {
                         std::vector<Value> values;
                         values.reserve(length);
                         for_each_row([&](const Row& row) { values.push_back(static_cast<Value>(member(row))); });
                         return values;
                       });
  };
}

/// Writes `rows`, which must live until the file is finished, as one variable a column.
template <typename Row>
void write_rows(NetcdfWriter& file, const std::vector<Row>& rows, const std::string& geometry = "") {
  const auto for_each_row = [&rows](const auto& take) {
    for (const Row& row : rows) take(row);
  };
  const auto is_before = [&file](const std::string& name) { return file.continues(Columns<Row>::prefix + name); };
  visit_used(rows, column_writer<Row>(file, rows.size(), for_each_row, geometry), is_before);
}

/// `n` rows from `first` on.
template <typename Row>
std::vector<Row> read_rows(const NetcdfReader& file, std::size_t first, std::size_t n) {
  std::vector<Row> rows(n);
  Columns<Row>::visit([&](const std::string& name, const char*, const std::string&, auto member) {
    if constexpr (requires { Columns<Row>::is_optional(name); })
      if (Columns<Row>::is_optional(name) && !file.has(Columns<Row>::prefix + name)) return;
    using Member = std::remove_cvref_t<decltype(member(rows.front()))>;
    std::vector<typename Stored<Member>::Type> values;
    file.read(Columns<Row>::prefix + name, Columns<Row>::dimension, first, n, values);
    if constexpr (std::is_same_v<Member, model::FloeEnd>)
      for (const std::int8_t value : values)
        if (value < 0 || value > 2) file.refuse(fmt::format("{}{} has an unknown value", Columns<Row>::prefix, name));
    for (std::size_t i = 0; i < rows.size(); ++i) member(rows[i]) = static_cast<Member>(values[i]);
  });
  return rows;
}

template <typename Row>
std::vector<Row> read_rows(const NetcdfReader& file) {
  return read_rows<Row>(file, 0, file.length(Columns<Row>::dimension));
}

/// The coordinates in which the nodes of rings are given, and their unit.
struct NodeFrame {
  std::string unit;
  std::string description;
};

/// Writes rings one after another: `name`_part_node_count along `name`_part, `name`_x and `name`_y along `name`_node.
/// @param for_each_ring  calls its argument with each ring, now and when the file is finished.
template <typename Point, typename ForEachRing>
void write_each_ring(NetcdfWriter& file, const std::string& name, const NodeFrame& frame, ForEachRing for_each_ring) {
  using Number = decltype(Point::x);
  std::vector<std::int32_t> node_counts;
  std::size_t n_nodes = 0;
  for_each_ring([&](const std::vector<Point>& ring) {
    node_counts.push_back(static_cast<std::int32_t>(ring.size()));
    n_nodes += ring.size();
  });
  const auto coordinate = [n_nodes, for_each_ring](Number Point::*member) {
    return [=] {
      std::vector<Number> values;
      values.reserve(n_nodes);
      for_each_ring([&](const std::vector<Point>& ring) {
        for (const Point& node : ring) values.push_back(node.*member);
      });
      return values;
    };
  };
  file.variable(name + "_part_node_count", name + "_part", {"1", "number of nodes of each ring"}, node_counts);
  file.column<Number>(name + "_x", name + "_node", {frame.unit, "nodes, x, " + frame.description, {{"axis", "X"}}},
                      n_nodes, coordinate(&Point::x));
  file.column<Number>(name + "_y", name + "_node", {frame.unit, "nodes, y, " + frame.description, {{"axis", "Y"}}},
                      n_nodes, coordinate(&Point::y));
}

/// The same for `rings`, which must live until the file is finished.
template <typename Point>
void write_rings(NetcdfWriter& file, const std::string& name, const NodeFrame& frame,
                 const std::vector<std::vector<Point>>& rings) {
  write_each_ring<Point>(file, name, frame, [&rings](const auto& take) {
    for (const std::vector<Point>& ring : rings) take(ring);
  });
}

/// `values` cut into runs of `counts`; refuses counts that do not add up to all values.
template <typename Value>
std::vector<std::vector<Value>> split(const NetcdfReader& file, const std::string& name, std::vector<Value> values,
                                      const std::vector<std::int32_t>& counts) {
  std::vector<std::vector<Value>> runs;
  auto next = std::make_move_iterator(values.begin());
  const auto end = std::make_move_iterator(values.end());
  for (const std::int32_t count : counts) {
    if (count < 0 || count > end - next) file.refuse(name + ": the counts do not add up");
    runs.emplace_back(next, next + count);
    next += count;
  }
  if (next != end) file.refuse(name + ": the counts do not add up");
  return runs;
}

template <typename Point>
std::vector<std::vector<Point>> read_rings(const NetcdfReader& file, const std::string& name) {
  std::vector<std::int32_t> node_counts;
  std::vector<decltype(Point::x)> x;
  std::vector<decltype(Point::y)> y;
  file.read(name + "_part_node_count", name + "_part", node_counts);
  file.read(name + "_x", name + "_node", x);
  file.read(name + "_y", name + "_node", y);
  std::vector<Point> nodes;
  nodes.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    Point& node = nodes.emplace_back();
    node.x = x[i];
    node.y = y[i];
  }
  return split(file, name + "_part_node_count", std::move(nodes), node_counts);
}

/// Whether `ring` runs clockwise, as the holes of a polygon do.
template <typename Point>
bool is_clockwise(const std::vector<Point>& ring) {
  double area = 0.0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const auto x = [&](std::size_t k) { return static_cast<double>(ring[k].x - ring[0].x); };
    const auto y = [&](std::size_t k) { return static_cast<double>(ring[k].y - ring[0].y); };
    area += x(i) * y(i + 1) - x(i + 1) * y(i);
  }
  return area < 0.0;
}

/// Writes polygons along `dimension`, as a geometry of the CF conventions (1.8, Sec. 7.5) with the container `name`;
/// `name`_part_count says how many rings each polygon has. A polygon may have several parts: each is its outline, then
/// its holes.
/// @param for_each_polygon  calls its argument with the rings of each polygon, now and when the file is finished.
template <typename Point, typename ForEachPolygon>
void write_polygons(NetcdfWriter& file, const std::string& name, const std::string& dimension, const NodeFrame& frame,
                    ForEachPolygon for_each_polygon) {
  std::vector<std::int32_t> node_counts;
  std::vector<std::int32_t> part_counts;
  std::vector<std::int32_t> interior;
  for_each_polygon([&](const std::vector<std::vector<Point>>& polygon) {
    std::int32_t n_nodes = 0;
    for (const std::vector<Point>& ring : polygon) {
      interior.push_back(is_clockwise(ring) ? 1 : 0);
      n_nodes += static_cast<std::int32_t>(ring.size());
    }
    node_counts.push_back(n_nodes);
    part_counts.push_back(static_cast<std::int32_t>(polygon.size()));
  });
  file.container(name, {"",
                        "polygons, " + frame.description,
                        {{"geometry_type", "polygon"},
                         {"node_count", name + "_node_count"},
                         {"part_node_count", name + "_part_node_count"},
                         {"interior_ring", name + "_interior_ring"},
                         {"node_coordinates", name + "_x " + name + "_y"}}});
  file.variable(name + "_node_count", dimension, {"1", "number of nodes of each polygon"}, node_counts);
  file.variable(name + "_part_count", dimension, {"1", "number of rings of each polygon"}, part_counts);
  write_each_ring<Point>(file, name, frame, [for_each_polygon](const auto& take) {
    for_each_polygon([&](const std::vector<std::vector<Point>>& polygon) {
      for (const std::vector<Point>& ring : polygon) take(ring);
    });
  });
  file.variable(name + "_interior_ring", name + "_part", {"1", "1 for a hole, 0 for an outline"}, interior);
}

template <typename Point>
std::vector<std::vector<std::vector<Point>>> read_polygons(const NetcdfReader& file, const std::string& name,
                                                           const std::string& dimension) {
  std::vector<std::int32_t> part_counts;
  file.read(name + "_part_count", dimension, part_counts);
  return split(file, name + "_part_count", read_rings<Point>(file, name), part_counts);
}

}  // namespace brash::io
