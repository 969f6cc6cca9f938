// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brash/model/origin.hpp"
#include "brash/statistics/extremes.hpp"

namespace brash::analysis {

/// A CSV file of the program's own with names in its first line; cells as text.
struct TextTable {
  using Row = std::vector<std::string>;

  std::string path;
  Row names;
  std::vector<Row> rows;

  /// @throws InputError naming the columns that there are.
  std::size_t column(const std::string& name) const;
};

/// Reads a table. @throws InputError naming file, line and fault.
/// @param allowed  the expected file, for messages.
/// @param remedy   how to get such a file.
TextTable read_text_table(const std::string& path, const std::string& allowed, const std::string& remedy);

/// The finite number in a cell; nothing when there is none.
std::optional<double> number_in(const std::string& cell);

/// A unit of a table's numbers.
struct TableUnit {
  double one;        ///< of SI
  std::string name;  ///< such as kN
};

/// The unit in which the largest of `values` has a digit before the point: kilo-, or at the scale of a basin less.
/// @param si  the unit of the values, such as N. Values that are not finite do not count.
TableUnit unit_for(std::span<const double> values, const char* si);

/// "p = 0.034"; a value far below any test's own accuracy is a bound.
std::string p_text(double p);

/// A value with its 95 % interval, as `value` and `interval_95`.
nlohmann::ordered_json estimate_json(const statistics::Estimate& estimate);

/// Adds the preset and the program behind a table to its JSON, under `origin`; nothing for a measurement.
void add_origin(const model::Origin& origin, nlohmann::ordered_json& table);

/// The same as a line of the table's text, after `before`; "" without an origin.
std::string origin_text(const nlohmann::ordered_json& table, const std::string& before = "");

}  // namespace brash::analysis
