// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "brash/formats/replay.hpp"

namespace brash::formats {

/// A run as other programs read it: `brash export NAME RUN`, and brash.export_run(RUN, NAME).
struct Export {
  std::string name;     ///< of the command
  std::string meaning;  ///< in its help
  std::string output;   ///< what it writes: "file of the replay"
  std::string beside;   ///< its name beside the run.nc, where none is given
  std::string example;  ///< of a name
  std::string ending;   ///< that the name of a file must have; "": it writes a folder
  std::string kind;     ///< of the file, in messages: "a replay in binary glTF"
  /// Writes the run under this name. @return the file to open.
  std::function<std::string(const Replay& run, const std::string& output)> write;
};

/// All that need nothing but the run: the list in this room's CMakeLists.txt.
const std::vector<Export>& exports();

/// @throws InputError naming all exports.
const Export& export_named(const std::string& name);

/// The result of export_run().
struct Exported {
  std::string file;          ///< to open
  std::size_t n_frames = 0;  ///< of the run
};

/// Writes a run for another program.
/// @param run     its folder, or its run.nc.
/// @param output  name of the file or the folder; "": Export::beside.
/// @throws InputError for a run that cannot be read, and for a name of another ending; StorageError.
Exported export_run(const Export& format, const std::string& run, const std::string& output);

}  // namespace brash::formats
