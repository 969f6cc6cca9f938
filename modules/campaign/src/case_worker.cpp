// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>

#include "brash/advice/advice.hpp"
#include "brash/campaign/campaign.hpp"
#include "brash/core/error.hpp"
#include "brash/core/folder_lock.hpp"
#include "brash/core/write_file.hpp"
#include "brash/recording/inputs.hpp"
#include "brash/recording/recording.hpp"

namespace brash::campaign {
namespace {

namespace fs = std::filesystem;

/// How long a case waits for an earlier process that still writes its checkpoint [s].
constexpr double kPatience = 10.0;

recording::Kept kept(const std::string& keep) {
  if (keep == "summary") return recording::Kept::kSummary;
  return keep == "history" ? recording::Kept::kHistory : recording::Kept::kRun;
}

/// Removes a checkpoint that cannot be gone on from, because it is damaged or a model that comes with the program has
/// changed since: the case begins again.
void remove_if_unfit(const simulation::CheckpointStore& checkpoint) {
  try {
    checkpoint.newest();
    for (const std::string& file : checkpoint.earlier()) checkpoint.read_earlier(file);
  } catch (const InputError&) {
    recording::remove_checkpoint(checkpoint.name);
  }
}

/// Gives the whole results their final name; results that another process published before stay.
void publish(const std::string& partial, const std::string& folder) {
  std::error_code reason;
  fs::rename(partial, folder, reason);
  if (!reason) {
    // Not earlier: nobody may take a lock of a folder that is about to get its name.
    fs::remove(folder + "/lock");
  } else if (fs::exists(folder + "/summary.json")) {
    fs::remove_all(partial);
  } else {
    throw StorageError(fmt::format("{}: cannot be renamed: {}", partial, reason.message()));
  }
}

}  // namespace

CaseEnd run_case(const CaseTask& task, const std::function<bool()>& interrupted) {
  const std::string partial = task.folder + ".part";
  std::error_code reason;
  for (const std::string& folder : {task.folder, partial})
    if (fs::is_symlink(folder, reason))
      throw InputError(Complaint{folder, "is a link, and a campaign follows none in its folder", "a folder",
                                 "remove the link, or give another folder"});
  fs::create_directories(partial, reason);
  if (reason) throw StorageError(fmt::format("{}: cannot be made: {}", partial, reason.message()));
  const std::optional<FolderLock> lock = FolderLock::take(partial + "/lock", kPatience);
  if (fs::exists(task.folder + "/summary.json")) {
    if (lock) fs::remove_all(partial);
    return CaseEnd::kDone;
  }
  if (!lock) return CaseEnd::kInterrupted;

  remove_parts(partial);
  const recording::Inputs inputs = recording::read_inputs(
      task.case_file, {fmt::format("random.replicate={}", task.replicate)}, io::ModelFile::kAnywhere);
  const std::string checkpoint = partial + "/checkpoint.nc";
  const simulation::CheckpointStore store = recording::checkpoint_file(checkpoint, true, inputs);
  remove_if_unfit(store);
  const simulation::Run run = advice::run(
      inputs.resolved,
      {.begun = [&] { recording::expect_unchanged(inputs); }, .checkpoint = store, .interrupted = interrupted});
  if (!run.complete) return CaseEnd::kInterrupted;
  recording::write_run(partial, inputs, run, {}, kept(task.keep));
  recording::remove_checkpoint(checkpoint);
  publish(partial, task.folder);
  return CaseEnd::kDone;
}

}  // namespace brash::campaign
