// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/io/case.hpp"
#include "toml_source.hpp"

namespace brash::io {

/// Whether the files of [field] are there: the files of a recorded case need not be.
enum class FieldFiles { kThere, kMayBeGone };

/// The case that `source` describes, under `name`.
/// @throws InputError that lists every problem.
model::Case resolve(const CaseSource& source, const std::string& name, ModelFile model_file = ModelFile::kInItsFolder,
                    FieldFiles files = FieldFiles::kThere);

}  // namespace brash::io
