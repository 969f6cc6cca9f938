// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

#include "brash/live/server.hpp"
#include "brash/model/case.hpp"
#include "brash/simulation/run.hpp"
#include "brash/simulator/growing_records.hpp"

namespace brash::cli {

/// A run in progress, shown in a browser on this machine. It reads the run and changes nothing of it.
class LiveView {
 public:
  /// @throws RunError without a page, or when no server can be started.
  explicit LiveView(const model::Case& resolved);

  const std::string& address() const { return server_.address(); }

  /// Makes the run show itself here, and stop when a browser asks for it. Keeps what `options` has.
  /// The view must outlive the run.
  void watch(simulation::RunOptions& options);

  /// Shows the browsers how the run ended, and lets them take the rest.
  /// @param text  for the reader.
  void end(const std::string& text);

 private:
  void send();
  /// Sends what waits, if anything does and a browser takes it. Until then the records are kept as they are.
  void send_rest();

  live::Server server_;
  simulator::GrowingRecords records_;
  std::chrono::steady_clock::time_point sent_{};  ///< when records were sent last
  bool waits_ = false;                            ///< there is something to draw since
};

}  // namespace brash::cli
