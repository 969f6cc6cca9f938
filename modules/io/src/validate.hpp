// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "toml_source.hpp"

namespace brash::io {

/// The case as JSON in SI, checked against the schema, with the defaults filled in.
/// @throws InputError that lists what is wrong.
nlohmann::json validated(const CaseSource& source);

}  // namespace brash::io
