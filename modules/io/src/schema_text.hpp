// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace brash::io {

/// The texts of case.schema.json, plan.schema.json and site_ice.json.
extern const char* const kCaseSchemaText;
extern const char* const kPlanSchemaText;
extern const char* const kSiteIceText;

}  // namespace brash::io
