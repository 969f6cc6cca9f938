// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "schema.hpp"

namespace brash::io {

/// Whether the schema of a key allows a value: its type, choices, range, lengths and items. Numbers with a fraction of
/// zero are no integers. Every other keyword must be an annotation, which says nothing about values.
/// @param value  in SI.
bool allows(const OrderedJson& key_schema, const nlohmann::json& value);

}  // namespace brash::io
