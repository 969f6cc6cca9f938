// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace brash::cli {

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

}  // namespace brash::cli
