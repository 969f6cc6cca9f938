// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/nesting.hpp"

#include <algorithm>

namespace brash {
namespace {

/// The first position after the string that begins at `at`; a string of one line ends with its line.
std::size_t after_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool escapes = quote == '"';
  const bool multi_line = text.substr(at, 3) == std::string_view(escapes ? "\"\"\"" : "'''");
  std::size_t i = at + (multi_line ? 3 : 1);
  for (; i < text.size(); ++i) {
    if (escapes && text[i] == '\\')
      ++i;
    else if (multi_line && text.substr(i, 3) == text.substr(at, 3))
      return i + 3;
    else if (!multi_line && (text[i] == quote || text[i] == '\n'))
      return i + (text[i] == quote ? 1 : 0);
  }
  return text.size();
}

TextPosition position_of(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  const std::size_t newline = before.rfind('\n');
  return {1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
          static_cast<int>(newline == std::string_view::npos ? at + 1 : at - newline)};
}

}  // namespace

std::optional<TextPosition> find_deep_nesting(std::string_view text) {
  int brackets = 0;
  int dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    switch (text[i]) {
      case '"':
      case '\'':
        i = after_string(text, i);
        continue;
      case '#':
        i = std::min(text.find('\n', i), text.size());
        continue;
      case '[':
      case '{':
        ++brackets;
        dots = 0;
        break;
      case ']':
      case '}':
        brackets = std::max(brackets - 1, 0);
        break;
      case '.':
        ++dots;
        break;
      case ',':
      case '=':
      case '\n':
        dots = 0;
        break;
      default:
        break;
    }
    if (brackets > kDeepestNesting || dots > kDeepestNesting) return position_of(text, i);
    ++i;
  }
  return std::nullopt;
}

}  // namespace brash
