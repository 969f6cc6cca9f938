// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/workers.hpp"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <exception>
#include <limits>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "brash/core/contract.hpp"
#include "brash/core/thread_variables.hpp"

namespace brash {
namespace {

/// Looks for work before a thread sleeps or lets others run: some 20 us. A loop of the solver is over in less, and a
/// thread that slept would come too late for the next one. Much more takes processor time from other programs.
constexpr int kLooks = 1000;
/// A loop has at most so many chunks: their numbers fit in 20 bits. Chunks are larger in longer loops.
constexpr std::size_t kMostChunks = (std::size_t{1} << 20) - 1;

/// Whether this thread is inside an item of a loop.
thread_local bool inside = false;

struct Inside {
  Inside() { inside = true; }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;
  ~Inside() { inside = false; }
};

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

std::size_t n_chunks(std::size_t n, std::size_t chunk) { return n / chunk + (n % chunk != 0 ? 1 : 0); }

/// The exception of the earliest chunk that threw.
class FirstError {
 public:
  void keep(std::size_t chunk) {
    const std::scoped_lock lock(mutex_);
    if (chunk >= chunk_) return;
    chunk_ = chunk;
    error_ = std::current_exception();
  }
  /// Only once all chunks are done.
  void rethrow() {
    if (!error_) return;
    chunk_ = kNone;
    std::rethrow_exception(std::exchange(error_, nullptr));
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::mutex mutex_;
  std::size_t chunk_ = kNone;
  std::exception_ptr error_;
};

/// The chunks of a worker that nobody has taken, and the loop to which they belong, in one word. Who exchanges the word
/// has the chunk, and knows that the loop continues until that chunk is done.
struct Left {
  std::uint64_t word;

  Left(std::uint32_t loop, std::size_t next, std::size_t end)
      : word(std::uint64_t{loop} << 40 | std::uint64_t{next} << 20 | std::uint64_t{end}) {}
  explicit Left(std::uint64_t w) : word(w) {}
  std::size_t next() const { return (word >> 20) & kMostChunks; }
  bool none() const { return next() >= (word & kMostChunks); }
  std::uint64_t without_next() const { return word + (std::uint64_t{1} << 20); }
};

/// Signals are for the threads of the program.
class WithoutSignals {
 public:
  WithoutSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  WithoutSignals(const WithoutSignals&) = delete;
  WithoutSignals& operator=(const WithoutSignals&) = delete;
  ~WithoutSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

}  // namespace

/// The other threads, and the loop at which all work.
class Workers::Team {
 public:
  explicit Team(int n) : shares_(static_cast<std::size_t>(n)) {
    const WithoutSignals inherited;
    threads_.reserve(static_cast<std::size_t>(n - 1));
    try {
      for (int worker = 1; worker < n; ++worker) threads_.emplace_back([this, worker] { serve(worker); });
    } catch (const std::system_error&) {  // the system gives no more; those that are there take all shares
    } catch (const std::bad_alloc&) {
    }
  }
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  ~Team() {
    ended_ = true;
    call_up(threads_.size());
    for (std::thread& thread : threads_) thread.join();
  }

  void run(Loop loop, Call call) {
    const std::size_t n = n_chunks(loop.n, loop.chunk), n_workers = shares_.size();
    loop_ = loop;
    call_ = call;
    done_.store(0, std::memory_order_relaxed);
    const std::uint32_t number = (number_.load(std::memory_order_relaxed) + 1) & 0xffffff;
    for (std::size_t worker = 0; worker < n_workers; ++worker)
      shares_[worker].left.store(Left(number, n * worker / n_workers, n * (worker + 1) / n_workers).word,
                                 std::memory_order_release);
    call_up(n - 1);
    work(0);
    for (int looks = 0; done_.load(std::memory_order_acquire) < n; ++looks)
      if (looks < kLooks)
        pause();
      else
        std::this_thread::yield();
    error_.rethrow();
  }

 private:
  struct alignas(64) Share {
    std::atomic<std::uint64_t> left{0};
  };

  /// Wakes no more threads than find a chunk. To wake one takes the caller some microseconds: of many threads the first
  /// would sleep again before it has woken the last, loop after loop.
  void call_up(std::size_t n_wanted) {
    number_.fetch_add(1);
    if (n_wanted >= threads_.size()) return number_.notify_all();
    for (std::size_t n_awake = threads_.size() - n_asleep_.load(); n_awake < n_wanted; ++n_awake) number_.notify_one();
  }

  void serve(int worker) {
    if (!make_thread_variables()) return;  // the others take its share
    for (std::uint32_t seen = 0; !ended_.load(std::memory_order_acquire);) {
      for (int looks = 0; looks < kLooks && number_.load(std::memory_order_acquire) == seen; ++looks) pause();
      if (number_.load(std::memory_order_acquire) == seen) sleep(seen);
      seen = number_.load(std::memory_order_acquire);
      work(worker);
    }
  }

  /// A thread may be about to sleep when call_up() counts it as awake: it then sees that the number has changed.
  void sleep(std::uint32_t seen) {
    n_asleep_.fetch_add(1);
    number_.wait(seen, std::memory_order_acquire);
    n_asleep_.fetch_sub(1);
  }

  /// Takes chunks until there are none, its own share first.
  void work(int worker) {
    const Inside mark;
    for (std::size_t i = 0; i < shares_.size(); ++i) {
      std::atomic<std::uint64_t>& left = shares_[(static_cast<std::size_t>(worker) + i) % shares_.size()].left;
      Left now(left.load(std::memory_order_acquire));
      while (!now.none()) {
        if (!left.compare_exchange_weak(now.word, now.without_next(), std::memory_order_acq_rel,
                                        std::memory_order_acquire))
          continue;
        do_chunk(now.next(), worker);
        now = Left(left.load(std::memory_order_acquire));
      }
    }
  }

  void do_chunk(std::size_t number, int worker) {
    const std::size_t begin = number * loop_.chunk;
    try {
      call_.function(call_.context, begin, std::min(loop_.n, begin + loop_.chunk), worker);
    } catch (...) {
      error_.keep(number);
    }
    done_.fetch_add(1, std::memory_order_release);
  }

  std::vector<Share> shares_;
  Loop loop_;
  Call call_;
  alignas(64) std::atomic<std::size_t> done_{0};      ///< chunks
  alignas(64) std::atomic<std::uint32_t> number_{0};  ///< of the loop; goes round
  std::atomic<bool> ended_{false};
  alignas(64) std::atomic<std::size_t> n_asleep_{0};  ///< threads
  FirstError error_;
  std::vector<std::thread> threads_;
};

Workers::Workers(int n) : count_(n) {
  BRASH_EXPECTS(n >= 1, n);
  if (n > 1) team_ = std::make_unique<Team>(n);
}

Workers::~Workers() = default;

int Workers::available() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

void Workers::record(LoopRecord* record) {
  BRASH_EXPECTS(count_ == 1, "times of the chunks of several threads", count_);
  record_ = record;
}

void Workers::share_out(Loop loop, Call call) {
  BRASH_EXPECTS(loop.chunk > 0);
  BRASH_EXPECTS(!inside, "a loop inside an item of a loop");
  if (loop.n == 0) return;
  loop.chunk = std::max(loop.chunk, loop.n / kMostChunks + 1);
  if (team_ && loop.n > loop.chunk) return team_->run(loop, call);
  do_alone(loop, call);
}

void Workers::do_alone(Loop loop, Call call) {
  const Inside mark;
  FirstError error;
  const auto note_moment = [this] {
    if (record_ != nullptr) record_->moments.push_back(LoopRecord::Clock::now());
  };
  note_moment();
  for (std::size_t begin = 0; begin < loop.n; begin += loop.chunk) {
    try {
      call.function(call.context, begin, std::min(loop.n, begin + loop.chunk), 0);
    } catch (...) {
      error.keep(begin);
    }
    note_moment();
  }
  if (record_ != nullptr) record_->loops.push_back({loop.caller, n_chunks(loop.n, loop.chunk)});
  error.rethrow();
}

}  // namespace brash
