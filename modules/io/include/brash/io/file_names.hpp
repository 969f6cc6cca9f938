// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace brash::io {

/// Takes a note on content that a reader left out of a file. It begins with the file's name. Empty: no notes.
using Notes = std::function<void(const std::string& note)>;

/// Refuses to write a file under a name that promises another format.
///
/// @param file     as the user named it; empty: none is written.
/// @param kind     of file, such as "a picture".
/// @param endings  that such files have, with their dots.
/// @throws InputError naming the file, the endings and the remedy.
void check_ending(const std::string& file, std::string_view kind, std::initializer_list<std::string_view> endings);

/// Refuses to write over a result of a run or a campaign: the manifest.json beside the output, or a file that it lists.
///
/// @param output  path to write; empty: nothing is written.
/// @throws InputError naming the output.
void refuse_replacing_results(const std::string& output);

/// The file of a run or a campaign that a command reads: `given`, or the first of `names` in it if it is a folder.
/// @throws InputError naming a folder that has none.
std::string file_in(const std::string& given, std::initializer_list<std::string_view> names);

/// The folder of a run or a campaign that is given by its folder or by a file in it.
std::string folder_of(const std::string& given);

/// Refuses a file to write whose folder is missing.
/// @throws InputError naming the file.
void refuse_missing_folder(const std::string& path);

/// Refuses outputs of one command with one path, of which only the last would stay. Empty ones are passed over.
/// @throws InputError naming the path.
void refuse_equal_names(const std::vector<std::string>& outputs);

}  // namespace brash::io
