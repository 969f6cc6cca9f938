// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "brash/io/results.hpp"
#include "brash/io/table.hpp"
#include "netcdf_file.hpp"

namespace brash::io {

void write_table(const std::string& path, const Table& table) {
  NetcdfWriter file(path);
  for (const auto& [name, text] : table.attributes) file.attribute(name, text);
  for (const TableIndex& index : table.indices) {
    Meaning meaning{"1", index.meaning};
    // CF flag values have the variable's type; names of flags are words without blanks.
    for (std::size_t i = 0; i < index.flags.size(); ++i) meaning.flags.push_back(static_cast<std::int32_t>(i));
    if (!index.flags.empty()) meaning.more = {{"flag_meanings", fmt::format("{}", fmt::join(index.flags, " "))}};
    file.variable(index.name, table.dimension, meaning, index.values);
  }
  for (const TableColumn& column : table.columns)
    file.variable(column.name, table.dimension, {column.unit, column.meaning}, column.values);
  write_image(path, file.finish());
}

}  // namespace brash::io
