// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "brash/io/case.hpp"
#include "brash/model/case.hpp"

namespace brash::recording {

/// A file that a run reads, as it was when it was read.
struct InputFile {
  std::string path;    ///< as given
  std::string sha256;  ///< of its bytes then
  std::size_t n_bytes = 0;
  std::string copy{};   ///< its name in the folder of the run; empty: it comes with the program
  std::string bytes{};  ///< of the copy
};

/// A case with every file behind it. Nothing is hashed later than it is read, so a file that changes during a run is
/// not vouched for.
struct Inputs {
  model::Case resolved;  ///< as the simulation takes it
  std::vector<InputFile> files;

  /// The case as results record it: its own files by the names of the copies, so that a copied folder runs anywhere.
  model::Case recorded() const;
};

/// Reads a case file, and hashes and copies the files that it names.
/// @throws InputError as io::read_case, and naming a file that cannot be read.
Inputs read_inputs(const std::string& case_file, const std::vector<std::string>& overrides = {},
                   io::ModelFile model_file = io::ModelFile::kInItsFolder);

/// The same for a case that has been read, from the text `case_text` of `case_file`.
Inputs inputs_of(const std::string& case_file, const std::string& case_text, const model::Case& resolved);

/// Refuses to continue when a file is not as it was read, once the simulation has read it too.
/// @throws InputError naming the file.
void expect_unchanged(const Inputs& inputs);

/// Calls `visit(folder, file)` for each file that a case names itself, with the folder of its copy, as "inputs/hull/".
void visit_own_files(model::Case& resolved,
                     const std::function<void(const std::string& folder, std::string& file)>& visit);

/// Writes the copies into `directory`.
void write_copies(const Inputs& inputs, const std::string& directory);

}  // namespace brash::recording
