// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/model/case.hpp"

namespace brash::io {

/// Where failure.file may lead. A case file comes from anyone, so it names files in its own folder, or below; the
/// command line names any file, and so does a case that the program itself has resolved and written.
enum class ModelFile { kInItsFolder, kAnywhere };

/// Reads, checks and resolves a case file.
///
/// @param overrides  `section.key=value` as on the command line, applied after the file; the value is TOML, or else a
///                   plain string, so that `ice.thickness=40 cm` needs no quotes.
/// @throws InputError that lists every problem, each with file, line, column (or the override), key, value, the
///         allowed values, the nearest known name and the remedy.
model::Case read_case(const std::string& path, const std::vector<std::string>& overrides = {},
                      ModelFile model_file = ModelFile::kInItsFolder);

/// The keys, `section.key`, that the case file leaves to its preset.
/// @throws InputError when the file is unreadable or no TOML.
std::vector<std::string> keys_set_by_preset(const std::string& path, const std::vector<std::string>& overrides = {});

/// The text of a case file.
/// @throws InputError when it is unreadable or larger than 1 MiB.
std::string read_case_text(const std::string& path);

/// As read_case() for a text; `path` names it in messages, gives the case its name and is where a model file is sought.
model::Case parse_case(const std::string& text, const std::string& path, const std::vector<std::string>& overrides = {},
                       ModelFile model_file = ModelFile::kInItsFolder);

/// The resolved case as TOML in SI, every key that has a value written; reading it gives the same case.
std::string to_toml(const model::Case& resolved);

/// A number of a case, as the schema describes its key; SI.
struct NumberKey {
  std::string section, key;
  std::string unit;  ///< UDUNITS; "1" where there is none
  std::string meaning;
  double least = 0.0, most = 0.0;  ///< both allowed
};

/// The keys of a case whose value is one number: its kind of structure and motion decide which these are.
std::vector<NumberKey> number_keys(const model::Case& resolved);

/// The JSON Schema of a case file, with unit, default, range and meaning of every key.
std::string case_schema();

/// A schema with keywords of JSON Schema alone, as strict validators demand: units and kinds are in the descriptions,
/// and each schema has one type.
/// @param schema  case_schema() or plan_schema().
std::string editor_schema(const std::string& schema);

/// A commented template of a case: every key with its default, required keys with the validation case's values.
/// @param ice  as for new_case().
std::string case_template(const std::string& ice = "basin");

}  // namespace brash::io
