// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/formats/exports.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/io/file_names.hpp"

namespace brash::formats {

// The list of CMakeLists.txt, as calls: here it declares the functions, below it calls them.
Export BRASH_EXPORTS;

const std::vector<Export>& exports() {
  static const std::vector<Export> all{BRASH_EXPORTS};
  return all;
}

const Export& export_named(const std::string& name) {
  const auto found = std::ranges::find(exports(), name, &Export::name);
  if (found != exports().end()) return *found;
  std::vector<std::string> names;
  for (const Export& one : exports()) names.push_back(one.name);
  throw InputError(Complaint{"export", fmt::format("'{}' is no format", printable(name)),
                             fmt::format("one of: {}", fmt::join(names, ", ")), "name another format"});
}

Exported export_run(const Export& format, const std::string& run, const std::string& output) {
  const std::string file = io::file_in(run, {"run.nc"});
  const std::string to = output.empty() ? (std::filesystem::path(file).parent_path() / format.beside).string() : output;
  if (!format.ending.empty()) {
    refuse_overwriting(to, {file});
    io::check_ending(to, format.kind, {format.ending});
  }
  const Replay replay = read_replay(file);
  return {format.write(replay, to), replay.results.frames.size()};
}

}  // namespace brash::formats
