// SPDX-License-Identifier: GPL-3.0-or-later
// Warnings of the validation case with settings.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "brash/advice/advice.hpp"
#include "brash/io/case.hpp"

namespace brash::test {

inline const std::string kSource = BRASH_SOURCE_DIR;

inline model::Case validation(const std::vector<std::string>& settings = {}) {
  return io::read_case(kSource + "/experiments/validation/cone.toml", settings);
}

inline bool has(const std::vector<model::Warning>& warnings, const std::string& id) {
  return std::ranges::any_of(warnings, [&](const model::Warning& warning) { return warning.id == id; });
}

inline std::string text_of(const std::vector<model::Warning>& warnings, const std::string& id) {
  const auto found = std::ranges::find(warnings, id, &model::Warning::id);
  return found == warnings.end() ? "" : found->text;
}

inline std::vector<model::Warning> warnings_with(const std::vector<std::string>& settings) {
  return advice::warnings_of(validation(settings));
}

inline bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace brash::test
