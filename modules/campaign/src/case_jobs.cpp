// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_jobs.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstring>

#include "brash/campaign/campaign.hpp"
#include "brash/core/error.hpp"

namespace brash::campaign {
namespace {

namespace fs = std::filesystem;

constexpr int kInterruptedExit = 3;

/// The end of what a process said, without trailing blanks.
std::string last_words(const std::string& file) {
  constexpr std::size_t kMost = 4000;
  std::string text = read_text(file);
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text.size() > kMost ? text.substr(text.size() - kMost) : text;
}

bool comes_from_outside(int signal) {
  return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP;
}

}  // namespace

Job job_of(const CaseKey& key, const Folder& folder, const std::string& program, const std::string& keep) {
  const std::string partial = folder.partial_folder(key);
  std::error_code reason;
  fs::create_directories(partial, reason);
  if (reason) throw StorageError(fmt::format("{}: cannot be made: {}", partial, reason.message()));
  return {.ticket = 0,
          .command = {program, "campaign-case", folder.setting_file(key.setting), folder.case_folder(key),
                      "--replicate", std::to_string(key.replicate), "--keep", keep},
          .messages = partial + "/messages.txt"};
}

void judge(const CaseKey& key, const Folder& folder, const Exit& exit) {
  if (folder.state(key) == CaseState::kDone) return;
  if (exit.code == kInterruptedExit || comes_from_outside(exit.signal)) return;
  std::string error = last_words(folder.partial_folder(key) + "/messages.txt");
  if (exit.code == kStorageExit) throw StorageError(error);
  if (exit.signal != 0)
    error += fmt::format("{}ended by signal {}", error.empty() ? "" : "\n", sigabbrev_np(exit.signal));
  folder.record_failure(key, exit.code, exit.signal, error);
}

}  // namespace brash::campaign
