// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/io/origin.hpp"

namespace brash::analysis {
namespace {

/// Takes the cells of a line off the front of `text`. A cell in quotes may hold commas, line ends and doubled quotes.
TextTable::Row take_cells(std::string_view& text) {
  TextTable::Row cells(1);
  for (bool quoted = false; !text.empty();) {
    const char c = text.front();
    text.remove_prefix(1);
    const bool doubled = quoted && c == '"' && text.starts_with('"');
    if (doubled) text.remove_prefix(1);
    if (!quoted && c == '\n') break;
    if (!quoted && c == ',')
      cells.emplace_back();
    else if (!doubled && c == '"' && (quoted || cells.back().empty()))
      quoted = !quoted;
    else
      cells.back() += c;
  }
  if (cells.back().ends_with('\r')) cells.back().pop_back();
  return cells;
}

/// Takes off the apostrophe that a campaign's table has before a text that a spreadsheet would compute.
void unmark(std::string& cell) {
  if (cell.size() > 1 && cell[0] == '\'' && std::string_view("=+-@\t\r").find(cell[1]) != std::string_view::npos)
    cell.erase(0, 1);
}

/// A table of cases has each once: one that is there twice would count twice.
void refuse_repeated_cases(const TextTable& table, const std::string& remedy) {
  const auto name = std::ranges::find(table.names, "case");
  if (name == table.names.end() || std::ranges::find(table.names, "setting") == table.names.end()) return;
  std::set<std::string> found;
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    if (const std::string& one = table.rows[i][static_cast<std::size_t>(name - table.names.begin())];
        !found.insert(one).second)
      throw InputError(Complaint{fmt::format("{}:{}", table.path, i + 2),
                                 fmt::format("case '{}' is there twice", printable(one)), "one line for each case",
                                 remedy});
}

}  // namespace

std::size_t TextTable::column(const std::string& name) const {
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    throw InputError(Complaint{path, fmt::format("has no column '{}'", printable(name)),
                               fmt::format("one of: {}", fmt::join(names, ", ")), "name another column"});
  if (std::find(found + 1, names.end(), name) != names.end())
    throw InputError(Complaint{path, fmt::format("has two columns '{}'", printable(name)), "one column of each name",
                               "rename or remove one of them"});
  return static_cast<std::size_t>(found - names.begin());
}

TextTable read_text_table(const std::string& path, const std::string& allowed, const std::string& remedy) {
  TextTable table;
  table.path = path;
  const std::string characters = read_characters(path, allowed);
  std::string_view text = characters;
  while (!text.empty()) {
    TextTable::Row cells = take_cells(text);
    if (table.names.empty()) {
      table.names = std::move(cells);
    } else if (cells.size() == table.names.size()) {
      std::ranges::for_each(cells, unmark);
      table.rows.push_back(std::move(cells));
    } else {
      throw InputError(Complaint{fmt::format("{}:{}", path, table.rows.size() + 2),
                                 fmt::format("{} values in a table of {} columns", cells.size(), table.names.size()),
                                 "as many values in each line as in the first", remedy});
    }
  }
  if (table.names.size() < 2) throw InputError(Complaint{path, "is not a table", allowed, remedy});
  refuse_repeated_cases(table, remedy);
  return table;
}

std::optional<double> number_in(const std::string& cell) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

TableUnit unit_for(std::span<const double> values, const char* si) {
  double largest = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  if (largest == 0.0 || largest >= 1e3) return {1e3, fmt::format("k{}", si)};
  return largest >= 1.0 ? TableUnit{1.0, si} : TableUnit{1e-3, fmt::format("m{}", si)};
}

std::string p_text(double p) {
  constexpr double kLeast = 1e-6;
  return p < kLeast ? fmt::format("p < {:g}", kLeast) : fmt::format("p = {:.2g}", p);
}

nlohmann::ordered_json estimate_json(const statistics::Estimate& e) {
  return {{"value", e.value}, {"interval_95", {e.interval.lower, e.interval.upper}}};
}

void add_origin(const model::Origin& origin, nlohmann::ordered_json& table) {
  if (!origin.empty()) table["origin"] = origin;
}

std::string origin_text(const nlohmann::ordered_json& table, const std::string& before) {
  if (!table.contains("origin")) return "";
  const auto names = [&](const char* key) { return table["origin"][key].get<std::vector<std::string>>(); };
  return before + io::origin_line({names("presets"), names("programs")}) + "\n";
}

}  // namespace brash::analysis
