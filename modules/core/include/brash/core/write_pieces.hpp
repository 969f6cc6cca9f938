// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace brash {

/// As write_file() for a file of pieces, which need not be in memory together.
/// @param next  makes its argument the next piece, which stays there until the next call; false: there is none.
/// @throws StorageError as write_file().
void write_pieces(const std::string& path, const std::function<bool(std::string_view& piece)>& next);

}  // namespace brash
