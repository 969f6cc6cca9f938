// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace brash::io {

/// The texts of case.schema.json and plan.schema.json.
extern const char* const kCaseSchemaText;
extern const char* const kPlanSchemaText;

}  // namespace brash::io
