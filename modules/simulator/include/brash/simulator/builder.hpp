// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace brash::simulator {

/// The page of the case builder, HTML; empty in a build without Node.js.
extern const std::string_view kBuilder;

}  // namespace brash::simulator
