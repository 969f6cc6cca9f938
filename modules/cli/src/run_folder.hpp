// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "brash/core/folder_lock.hpp"
#include "brash/model/case.hpp"
#include "brash/recording/inputs.hpp"
#include "brash/simulation/run.hpp"

namespace brash::cli {

/// Makes `directory` this process's alone, for as long as the returned lock lives, and removes the half-written files
/// of a killed process. Results that it had whole get their names.
/// @throws InputError when another process runs in it, it holds a campaign or is a case of one, or it holds files with
/// names of results that no run left. @throws StorageError when it cannot be written.
FolderLock open_run_folder(const std::string& directory);

/// Refuses to begin a run at 0 s where a finished or an interrupted one lies.
/// @param other_remedy  ends the remedy, such as ", or take --replace".
/// @throws InputError with the remedy.
void refuse_replacing(const std::string& directory, const std::string& other_remedy = "");

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
  /// Writes everything that a finished run leaves: pictures, results, summary, manifest, report.
  void write(const recording::Inputs& inputs, const simulation::Run& run) const;

 private:
  std::string directory_;
};

/// @throws InputError when `directory` is no folder of a run or a campaign.
void expect_manifest(const std::string& directory);

/// Writes report.html of the run in `directory`, or of the campaign and of every run that it kept whole.
/// @return its path. @throws InputError naming a file that is missing. @throws RunError in a build without the page.
std::string write_report(const std::string& directory);

}  // namespace brash::cli
