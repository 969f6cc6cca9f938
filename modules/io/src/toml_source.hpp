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
  /// "section.key" and sections that only an override wrote -> the override's text.
  std::map<std::string, std::string> overridden;
};

/// Reads the text of a case file, named `path` in messages, and applies `section.key=value` overrides.
/// @throws InputError  nested too deeply, not TOML, a malformed override.
CaseSource parse_source(const std::string& text, const std::string& path, const std::vector<std::string>& overrides);

/// Where `section` was written; the start of the file when it was not.
Place place_of(const CaseSource& source, const std::string& section);
/// Where the value of `section.key` was written; else where the section was.
Place place_of(const CaseSource& source, const std::string& section, const std::string& key);
/// The value of `section.key` as it would be written in TOML, or "".
std::string value_text(const CaseSource& source, const std::string& section, const std::string& key);
std::string value_text(const toml::node& node);

}  // namespace brash::io
