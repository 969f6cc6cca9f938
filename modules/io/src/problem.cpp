// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "brash/core/error.hpp"
#include "brash/core/text.hpp"

namespace brash::io {

std::string Place::text() const {
  if (!override_text.empty()) return fmt::format("{}, --set {}", escaped(file), printable(override_text));
  return fmt::format("{}:{}:{}", escaped(file), line, column);
}

void refuse(std::vector<Problem> problems) {
  // Problems follow the order of the file; problems of overrides come last.
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

}  // namespace brash::io
