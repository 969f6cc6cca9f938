// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

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

}  // namespace brash::io
