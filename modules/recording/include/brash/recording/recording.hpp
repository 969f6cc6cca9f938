// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <system_error>
#include <vector>

#include "brash/recording/inputs.hpp"
#include "brash/simulation/run.hpp"

namespace brash::recording {

/// Where the rows of a long run are while it runs: all in memory, or the earlier ones in files beside the checkpoint.
enum class Rows { kInMemory, kInFiles };

/// The checkpoint file `path` as the store of a run: each state replaces the older one, by rename when whole. Earlier
/// rows are in files beside it, whose names and hashes the state has.
/// @param resume  the run continues from the file, if it is there.
/// Its functions throw InputError for a file that holds no state of a run, StorageError when it cannot be written.
simulation::CheckpointStore checkpoint_file(const std::string& path, bool resume, Rows rows = Rows::kInFiles);

/// The same for a run with its inputs: a state also holds the hashes of all files but the case, and is refused for a
/// run with others. Their paths are no part of it, so a copied folder resumes anywhere.
simulation::CheckpointStore checkpoint_file(const std::string& path, bool resume, const Inputs& inputs,
                                            Rows rows = Rows::kInFiles);

/// Removes the checkpoint `path`, if it is there, and then the files of its rows.
void remove_checkpoint(const std::string& path);

/// Gives the checkpoint `path` and the files of its rows another name.
std::error_code move_checkpoint(const std::string& path, const std::string& to);

/// The files of rows beside the checkpoint `path`, whether it names them or not.
std::vector<std::string> files_of_rows(const std::string& path);

/// `results` with the rows of all files of the store before their own.
model::RunResults with_earlier(const simulation::CheckpointStore& store, model::RunResults results);

/// The results of a run that are kept: its summary, its load history as well, or all results.
enum class Kept { kSummary, kHistory, kRun };

/// Writes run.nc, history.csv, events.csv, summary.json, copies of the inputs and, last, manifest.json into
/// `directory`, made if missing.
/// @param pictures   names of files already in `directory` that belong to the run.
/// @param kept       which of the results to write; summary.json and manifest.json always.
/// @throws RunError naming the file and the system's reason.
void write_run(const std::string& directory, const Inputs& inputs, const simulation::Run& run,
               const std::vector<std::string>& pictures = {}, Kept kept = Kept::kRun);

}  // namespace brash::recording
