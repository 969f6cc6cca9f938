// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "series.hpp"

namespace brash::io {
namespace {

std::string_view unquoted(std::string_view cell) {
  const bool quoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return quoted ? without_blanks(cell.substr(1, cell.size() - 2)) : cell;
}

}  // namespace

char separator_of(std::string_view first_line) {
  for (const char candidate : {';', '\t', ','})
    if (first_line.find(candidate) != std::string_view::npos) return candidate;
  return ' ';
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  while (true) {
    std::size_t end = 0;
    for (bool quoted = false; end < line.size() && (quoted || line[end] != separator); ++end)
      if (line[end] == '"') quoted = !quoted;
    const std::string_view cell = without_blanks(line.substr(0, end));
    if (separator != ' ' || !cell.empty()) cells.push_back(unquoted(cell));  // "" between quotes is a cell
    if (end == line.size() || cells.size() > kMostColumns) return cells;
    line.remove_prefix(end + 1);
  }
}

std::vector<std::string_view> with_units(const std::vector<std::string_view>& cells) {
  const auto begins = [](std::string_view cell) { return cell.starts_with('[') || cell.starts_with('('); };
  const auto ends = [](std::string_view cell) { return cell.ends_with(']') || cell.ends_with(')'); };
  if (cells.empty() || begins(cells.front())) return cells;
  std::vector<std::string_view> joined;
  bool is_open = false;
  for (const std::string_view cell : cells) {
    const bool belongs = is_open || begins(cell);
    if (belongs)
      joined.back() = {joined.back().data(),
                       static_cast<std::size_t>(cell.data() + cell.size() - joined.back().data())};
    else
      joined.push_back(cell);
    is_open = belongs && !ends(cell);
  }
  return is_open ? cells : joined;
}

std::optional<double> number_in(std::string_view cell, Layout& layout) {
  constexpr std::array<std::string_view, 6> kMissingWords{"", "nan", "NaN", "NA", "-", "NAN"};
  if (std::ranges::find(kMissingWords, cell) != kMissingWords.end()) return std::numeric_limits<double>::quiet_NaN();
  std::string text(cell.substr(cell.front() == '+' ? 1 : 0));
  const std::size_t at = text.find_first_of(".,");
  const char mark = at == std::string::npos ? layout.decimal_mark : text[at];
  const bool allowed = mark != ',' || layout.separator == ';' || layout.separator == '\t';
  if (!allowed || (layout.decimal_mark != 0 && mark != layout.decimal_mark)) return std::nullopt;
  if (at != std::string::npos) text[at] = '.';
  double value = 0.0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc{} || end != last || !std::isfinite(value)) return std::nullopt;
  layout.decimal_mark = mark;
  return value;
}

}  // namespace brash::io
