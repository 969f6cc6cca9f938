// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace brash::cli {

/// Refuses to write a file under a name that promises another format.
///
/// @param file     as the user named it; empty: none is written.
/// @param kind     of file, such as "a picture".
/// @param endings  that such files have, with their dots.
/// @throws InputError naming the file, the endings and the remedy.
void check_ending(const std::string& file, std::string_view kind, std::initializer_list<std::string_view> endings);

}  // namespace brash::cli
