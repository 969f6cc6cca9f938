// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <numeric>
#include <type_traits>
#include <vector>

namespace brash {

/// Loops in the order in which one worker did them, and how long each chunk took: for benchmarks.
struct LoopRecord {
  using Clock = std::chrono::steady_clock;
  struct Loop {
    const char* caller;    ///< name of the function that shared out the loop
    std::size_t n_chunks;  ///< >= 1
  };
  std::vector<Loop> loops;
  std::vector<Clock::time_point> moments;  ///< n_chunks + 1 for each loop: before its first chunk, and after each chunk
};

/// Threads that share out the items of a loop. No result depends on their number, if every item writes only its own
/// results and reads nothing that another item of the loop writes.
///
/// The calling thread works too. With one worker there is no other thread, and a program without threads works. The
/// others look for work for some microseconds after a loop, then they sleep. A loop wakes as many as it has chunks for.
/// A thread takes one chunk of items after another, first its own part of the loop, then what others have left: a
/// thread that the system does not run holds nobody up unless it has begun a chunk. A loop inside an item of another
/// loop is a broken contract.
class Workers {
 public:
  /// @param n  how many, the calling thread among them, >= 1; fewer work where the system gives no more threads.
  explicit Workers(int n = 1);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Logical processors that this process may use, >= 1.
  static int available();

  int count() const { return count_; }

  /// Appends each loop that ends from now on to `record`, which must live as long. Needs count() == 1.
  ///
  /// @param record  none: loops are no longer recorded.
  void record(LoopRecord* record);

  /// Calls `task(begin, end, worker)` for chunks that together are [0, n), each of `chunk` items, the last of the rest.
  ///
  /// @param task    `worker` is a number below count(): no two calls with the same one run at a time.
  /// @param caller  the name of the loop in a record.
  /// @throws what the task threw, of the earliest chunk that threw; all other chunks are done nevertheless.
  template <typename Task>
  void chunks(std::size_t n, std::size_t chunk, Task&& task, const char* caller = __builtin_FUNCTION()) {
    using Type = std::remove_reference_t<Task>;
    share_out({n, chunk, caller}, {[](void* context, std::size_t begin, std::size_t end, int worker) {
                                     (*static_cast<Type*>(context))(begin, end, worker);
                                   },
                                   const_cast<void*>(static_cast<const void*>(std::addressof(task)))});
  }

  /// Calls `task(i)` for each i in [0, n), `chunk` items at a time.
  template <typename Task>
  void each(std::size_t n, std::size_t chunk, Task&& task, const char* caller = __builtin_FUNCTION()) {
    const auto items = [&task](std::size_t begin, std::size_t end, int) {
      for (std::size_t i = begin; i < end; ++i) task(i);
    };
    chunks(n, chunk, items, caller);
  }

  /// `start` and `term(i)` for each i in [0, n), found `chunk` terms at a time and added in the order of i.
  template <typename Term>
  double sum(double start, std::size_t n, std::size_t chunk, Term&& term, const char* caller = __builtin_FUNCTION()) {
    std::vector<double> terms(n);
    const auto find = [&](std::size_t i) { terms[i] = term(i); };
    each(n, chunk, find, caller);
    return std::accumulate(terms.begin(), terms.end(), start);
  }

 private:
  struct Loop {
    std::size_t n = 0;
    std::size_t chunk = 1;
    const char* caller = "";
  };
  /// A task without its type.
  struct Call {
    void (*function)(void* context, std::size_t begin, std::size_t end, int worker) = nullptr;
    void* context = nullptr;
  };
  class Team;

  void share_out(Loop loop, Call call);
  void do_alone(Loop loop, Call call);

  int count_;
  std::unique_ptr<Team> team_;    ///< none with one worker
  LoopRecord* record_ = nullptr;  ///< none: loops are not timed
};

}  // namespace brash
