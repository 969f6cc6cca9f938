// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace brash {

/// `text` with control characters and what is not UTF-8 escaped: what a file says may not steer a terminal.
std::string escaped(const std::string& text);
/// The same, cut after 80 bytes.
std::string printable(const std::string& text);

}  // namespace brash
