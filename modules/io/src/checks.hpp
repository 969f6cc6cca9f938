// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "brash/model/case.hpp"
#include "resolve.hpp"
#include "toml_source.hpp"

namespace brash::io {

/// A key of a case.
struct Key {
  const char* section;
  const char* name;
};

/// Collects problems of keys of one source.
class Checks {
 public:
  explicit Checks(const CaseSource& source) : source_(source) {}

  /// Reports `key` when something about it does not hold, at the place of `partner` when only `partner` is written.
  void require(bool holds, Key key, Key partner, std::string what, std::string allowed, std::string remedy) {
    if (holds) return;
    std::string written = value_text(source_, key.section, key.name);
    const Key at = written.empty() ? partner : key;
    if (written.empty()) written = "its default";
    problems_.push_back({place_of(source_, at.section, at.name), fmt::format("{}.{}", key.section, key.name),
                         std::move(written), std::move(what), std::move(allowed), "", std::move(remedy)});
  }

  std::vector<Problem> take() { return std::move(problems_); }

 private:
  const CaseSource& source_;
  std::vector<Problem> problems_;
};

/// Shape and motion of the structure, and [hull].
void check_structure(const model::Case& c, Checks& checks);
void check_hull(const model::Case& c, Checks& checks);

/// [field] and its files.
void check_field(const model::Case& c, FieldFiles files, Checks& checks);

}  // namespace brash::io
