// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_table.hpp"

#include "brash/core/input_file.hpp"
#include "brash/core/nesting.hpp"

namespace brash::training {

toml::table parse_plan(const std::string& path) {
  const std::string text = read_text_file(path, "a plan of a failure database (TOML)", 1);
  if (const auto deep = find_deep_nesting(text))
    throw InputError(Complaint{fmt::format("{}:{}:{}", path, deep->line, deep->column), "is nested too deeply",
                               fmt::format("at most {} levels", kDeepestNesting), kRemedy});
  try {
    return toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    const auto at = error.source().begin;
    throw InputError(Complaint{fmt::format("{}:{}:{}", path, at.line, at.column), std::string(error.description()),
                               "TOML 1.0: lines `key = value` under a line `[section]`", kRemedy});
  }
}

}  // namespace brash::training
