// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace brash {

/// Open brackets at once, and dots in one key, that a TOML text may have: readers of TOML recurse.
inline constexpr int kDeepestNesting = 16;

struct TextPosition {
  int line = 1;
  int column = 1;
};

/// Where `text` nests deeper than kDeepestNesting, comments and strings apart; nothing when it does not.
std::optional<TextPosition> find_deep_nesting(std::string_view text);

}  // namespace brash
