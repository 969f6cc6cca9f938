// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "schema.hpp"
#include "toml_source.hpp"

namespace brash::io {

/// The file as JSON in SI, checked against `schema`, with the defaults filled in; without the schema's free parts.
/// @throws InputError that lists every problem.
nlohmann::json validated(const CaseSource& source, const Schema& schema);

}  // namespace brash::io
