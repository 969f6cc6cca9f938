// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/recording/inputs.hpp"
#include "brash/simulation/run.hpp"

namespace brash::recording {

/// The checkpoint file `path` as the store of a run: each state replaces the older one, by rename when whole.
/// @param resume  the run continues from the file, if it is there.
/// Its functions throw InputError for a file that holds no state of a run, StorageError when it cannot be written.
simulation::CheckpointStore checkpoint_file(const std::string& path, bool resume);

/// The same for a run with its inputs: a state also holds the hashes of all files but the case, and is refused for a
/// run with others. Their paths are no part of it, so a copied folder resumes anywhere.
simulation::CheckpointStore checkpoint_file(const std::string& path, bool resume, const Inputs& inputs);

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
