// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace brash::io {

/// Throws RunError for `path` with the system's reason.
[[noreturn]] void fail_to_write(const std::string& path, int reason);

/// A file that appears under its name when whole: it is written to partial() and renamed by publish().
/// Without publish() nothing stays behind.
class WholeFile {
 public:
  explicit WholeFile(std::string path);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  const std::string& partial() const { return partial_; }
  void publish();

 private:
  std::string path_;
  std::string partial_;
  bool published_ = false;
};

}  // namespace brash::io
