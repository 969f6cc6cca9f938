// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <map>
#include <string>
#include <vector>

#include "problem.hpp"

namespace brash::io {

/// A case file as a TOML tree with the overrides applied, and where everything in it was written.
struct CaseSource {
  std::string file;
  toml::table tree;
  /// "section.key" and sections that something else than the file wrote -> where that stands.
  std::map<std::string, Place> overridden;
};

/// The text of a file of at most 1 MiB. @throws InputError when it is unreadable or larger.
std::string read_text(const std::string& path, const std::string& kind);
/// The tree of a text, with `section.key=value` overrides applied; `path` names it in messages.
/// @throws InputError  nested too deeply, not TOML, a malformed override.
CaseSource parse_source(const std::string& text, const std::string& path, const std::vector<std::string>& overrides);
/// Puts the sections within sections of a case beside them, under their whole names.
void lift_subsections(toml::table& tree);
/// Applies one `section.key=value` override. @throws InputError when it is malformed.
void apply_override(CaseSource& source, const std::string& text);
/// Replaces the value of `section.key` by `value`, which is written at `place`.
void replace_value(CaseSource& source, const std::string& section, const std::string& key, const toml::node& value,
                   const Place& place);
/// The place of `node` in `file`; its start when it is not known.
Place place_of(const std::string& file, const toml::node& node);

/// Where `section` was written; the start of the file when it was not.
Place place_of(const CaseSource& source, const std::string& section);
/// Where the value of `section.key` was written; else where the section was.
Place place_of(const CaseSource& source, const std::string& section, const std::string& key);
/// The value of `section.key` as it would be written in TOML, or "".
std::string value_text(const CaseSource& source, const std::string& section, const std::string& key);
std::string value_text(const toml::node& node);

}  // namespace brash::io
