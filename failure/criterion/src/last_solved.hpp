// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>

namespace brash::failure {

/// Remembers the plates solved last. To first order a plate's fields do not depend on the pressure, and a contact is
/// assessed again within a step, on the same ice under another pressure, once other ice has been crushed. Safe between
/// threads.
template <class Plate, class Solution>
class LastSolved {
 public:
  /// The result of `solve(plate)`, or the remembered result for an equal plate among the last ones.
  template <class Solve>
  Solution get(const Plate& plate, const Solve& solve) {
    {
      const std::lock_guard lock(mutex_);
      for (const auto& [known, solution] : last_) {
        if (known == plate) return solution;
      }
    }
    Solution solution = solve(plate);
    const std::lock_guard lock(mutex_);
    last_.emplace_front(plate, solution);
    if (last_.size() > kKept) last_.pop_back();
    return solution;
  }

 private:
  static constexpr std::size_t kKept = 8;  ///< contacts of a step

  std::mutex mutex_;
  std::deque<std::pair<Plate, Solution>> last_;
};

}  // namespace brash::failure
