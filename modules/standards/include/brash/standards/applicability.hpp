// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace brash::standards {

/// Why a closed form says nothing about the given input, in words for a user.
struct NotApplicable {
  std::string reason;
};

}  // namespace brash::standards
