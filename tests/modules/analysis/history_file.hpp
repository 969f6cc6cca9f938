// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "brash/analysis/load_history.hpp"
#include "brash/core/error.hpp"

namespace brash::analysis {

/// A file that lives as long as the test.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text, const char* name = "history.csv")
      : folder_(std::filesystem::temp_directory_path() / ("brash-analysis-" + std::to_string(getpid()))),
        path_(folder_ / name) {
    std::filesystem::create_directories(folder_);
    std::ofstream(path_) << text;
  }
  ~TemporaryFile() { std::filesystem::remove_all(folder_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path folder_, path_;
};

/// The message of the InputError that reading throws.
inline std::string complaint(const std::string& text, const HistoryChoice& choice = {}) {
  const TemporaryFile file(text);
  try {
    read_history(file.path(), choice);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing thrown";
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace brash::analysis
