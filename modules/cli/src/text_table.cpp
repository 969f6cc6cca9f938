// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"

namespace brash::cli {
namespace {

TextTable::Row cells_of(const std::string& line) {
  TextTable::Row cells;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t end = std::min(line.find(',', from), line.size());
    cells.push_back(line.substr(from, end - from));
    from = end + 1;
  }
  return cells;
}

}  // namespace

std::size_t TextTable::column(const std::string& name) const {
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    throw InputError(Complaint{path, fmt::format("has no column '{}'", printable(name)),
                               fmt::format("one of: {}", fmt::join(names, ", ")), "name another column"});
  return static_cast<std::size_t>(found - names.begin());
}

TextTable read_text_table(const std::string& path, const std::string& allowed, const std::string& remedy) {
  TextTable table;
  table.path = path;
  std::istringstream file(read_text_file(path, allowed));
  for (std::string line; std::getline(file, line);) {
    if (line.ends_with('\r')) line.pop_back();
    TextTable::Row cells = cells_of(line);
    if (table.names.empty()) {
      table.names = std::move(cells);
    } else if (cells.size() == table.names.size()) {
      table.rows.push_back(std::move(cells));
    } else {
      throw InputError(Complaint{fmt::format("{}:{}", path, table.rows.size() + 2),
                                 fmt::format("{} values in a table of {} columns", cells.size(), table.names.size()),
                                 "as many values in each line as in the first", remedy});
    }
  }
  if (table.names.size() < 2) throw InputError(Complaint{path, "is no table", allowed, remedy});
  return table;
}

std::optional<double> number_in(const std::string& cell) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace brash::cli
