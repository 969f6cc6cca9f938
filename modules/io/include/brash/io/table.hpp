// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace brash::io {

/// A column of numbers; a missing one is NaN.
struct TableColumn {
  std::string name;
  std::string unit;  ///< UDUNITS; empty: not stated
  std::string meaning;
  std::vector<double> values;
};

/// A column of whole numbers that represent names: number i is `flags[i]` where flags are given.
struct TableIndex {
  std::string name;
  std::string meaning;
  std::vector<std::int32_t> values;
  std::vector<std::string> flags;
};

/// Columns of one length.
struct Table {
  std::string dimension;                                        ///< the kind of a row
  std::vector<std::pair<std::string, std::string>> attributes;  ///< of the whole file
  std::vector<TableIndex> indices;
  std::vector<TableColumn> columns;
};

/// Writes `table` as netCDF-4 (CF) to `path` by rename when whole; its bytes depend on the table alone.
/// @throws RunError naming the file and the reason.
void write_table(const std::string& path, const Table& table);

}  // namespace brash::io
