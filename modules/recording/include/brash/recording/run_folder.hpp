// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "brash/core/folder_lock.hpp"
#include "brash/recording/inputs.hpp"
#include "brash/simulation/run.hpp"

namespace brash::recording {

/// Makes `directory` this process's alone, for as long as the returned lock lives, and removes the half-written files
/// of a killed process. Results that it had whole get their names.
/// @throws InputError when another process runs in it, it holds a campaign or is a case of one, or it holds files with
/// names of results that no run left. @throws StorageError when it cannot be written.
FolderLock open_run_folder(const std::string& directory);

/// Refuses to begin a run at 0 s where a finished or an interrupted one lies.
/// @param other_remedy  ends the remedy, such as ", or take --replace".
/// @throws InputError with the remedy.
void refuse_replacing(const std::string& directory, const std::string& other_remedy = "");

/// A picture of a run.
struct Picture {
  std::string name;  ///< of its file in the folder of the run
  std::string bytes;
};

/// The results of a run. They lie in a folder of their own, `results.part`, until they are whole: then they replace the
/// older ones, and a run that dies before leaves those as they were. The lock of the folder must outlive this.
class NewResults {
 public:
  explicit NewResults(std::string directory) : directory_(std::move(directory)) {}
  NewResults(const NewResults&) = delete;
  NewResults& operator=(const NewResults&) = delete;
  /// Removes what was written without an end.
  ~NewResults();

  /// Makes their folder: from now on `directory` says that it is of a run.
  void begin() const;
  /// Writes everything that a finished run leaves but its report: pictures, results, summary, manifest. Then all have
  /// their names. @throws StorageError naming the file that cannot be written.
  void write(const Inputs& inputs, const simulation::Run& run, const std::vector<Picture>& pictures) const;

  const std::string& directory() const { return directory_; }

 private:
  std::string directory_;
};

}  // namespace brash::recording
