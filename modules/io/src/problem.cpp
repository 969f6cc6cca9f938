// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "brash/core/error.hpp"

namespace brash::io {

std::string Place::text() const {
  if (!override_text.empty()) return fmt::format("{}, --set {}", escaped(file), printable(override_text));
  return fmt::format("{}:{}:{}", escaped(file), line, column);
}

void refuse(std::vector<Problem> problems) {
  // What the file says first comes first; overrides come after the file.
  std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
    const bool a_late = !a.place.override_text.empty();
    const bool b_late = !b.place.override_text.empty();
    return std::tuple(a_late, a.place.line, a.place.column) < std::tuple(b_late, b.place.line, b.place.column);
  });
  constexpr std::size_t kMostShown = 20;
  std::string message;
  for (std::size_t i = 0; i < std::min(problems.size(), kMostShown); ++i) {
    const Problem& problem = problems[i];
    if (!message.empty()) message += '\n';
    message += fmt::format("{}: {}", problem.place.text(), printable(problem.key));
    if (!problem.value.empty()) message += " = " + printable(problem.value);
    message += ": " + escaped(problem.what);
    message += "\n  allowed: " + escaped(problem.allowed);
    if (!problem.nearest.empty()) message += "\n  nearest: " + escaped(problem.nearest);
    message += "\n  remedy:  " + escaped(problem.remedy);
  }
  if (problems.size() > kMostShown) message += fmt::format("\n... and {} more", problems.size() - kMostShown);
  throw InputError(message);
}

namespace {

/// Levenshtein's distance: the least number of insertions, deletions and replacements between two names.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, replaced}));
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
  constexpr std::size_t kLongestName = 64;
  if (name.size() > kLongestName) return "";
  const std::string* nearest = nullptr;
  std::size_t least = 0;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(name, candidate);
    if (nearest == nullptr || distance < least) {
      nearest = &candidate;
      least = distance;
    }
  }
  // More than half of the letters wrong is no similarity.
  if (nearest == nullptr || 2 * least > std::max(name.size(), nearest->size())) return "";
  return *nearest;
}

namespace {

/// Bytes of the UTF-8 character that begins at `at`; 0 when none does.
std::size_t character_length(const std::string& text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
  if (at + length > text.size()) return 0;
  for (std::size_t i = at + 1; i < at + length; ++i)
    if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) return 0;
  return length;
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    const auto byte = static_cast<unsigned char>(text[i]);
    if (length == 0 || byte < 0x20 || byte == 0x7f)
      shown += fmt::format("\\x{:02x}", byte);
    else
      shown += text.substr(i, length);
    i += std::max<std::size_t>(length, 1);
  }
  return shown;
}

std::string printable(const std::string& text) {
  constexpr std::size_t kLongest = 80;
  if (text.size() <= kLongest) return escaped(text);
  // A character of several bytes is not cut: the bytes after its first begin with the bits 10.
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return escaped(text.substr(0, end)) + "...";
}

}  // namespace brash::io
