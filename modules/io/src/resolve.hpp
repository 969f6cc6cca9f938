// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "brash/io/case.hpp"
#include "schema.hpp"
#include "toml_source.hpp"

namespace brash::io {

/// Whether the files of [field] are there: the files of a recorded case need not be.
enum class FieldFiles { kThere, kMayBeGone };

/// The case that `source` describes, under `name`.
/// @throws InputError that lists every problem.
model::Case resolve(const CaseSource& source, const std::string& name, ModelFile model_file = ModelFile::kInItsFolder,
                    FieldFiles files = FieldFiles::kThere);

/// The problems of values that are each allowed but do not go together.
std::vector<Problem> cross_check(const model::Case& resolved, const CaseSource& source, FieldFiles files);

/// The file as JSON in SI, checked against `schema`, with the defaults filled in; without the schema's free parts.
/// @throws InputError that lists every problem.
nlohmann::json validated(const CaseSource& source, const Schema& schema);

}  // namespace brash::io
