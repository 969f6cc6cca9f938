// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace brash::live {

/// Everything that was published, in order, as server-sent events. Many readers go through it, each at its own pace.
/// They share the events, so that a slow reader keeps no copy.
class Stream {
 public:
  using Event = std::shared_ptr<const std::string>;

  void publish(const std::string& event, const std::string& data);
  /// Lets readers come to an end.
  void close();

  /// The event number `index`; nothing when it is not there yet.
  Event at(std::size_t index) const;
  /// Whether there is no event number `index`, and never will be.
  bool ends_before(std::size_t index) const;

  /// A reader counts as connected while this lives.
  class Reader {
   public:
    explicit Reader(Stream& stream);
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader();

   private:
    Stream& stream_;
  };
  int n_readers() const;
  /// Waits until nobody is connected, `longest` at most.
  void wait_for_readers(std::chrono::milliseconds longest) const;

 private:
  mutable std::mutex mutex_;
  mutable std::condition_variable reader_left_;
  std::vector<Event> events_;
  bool closed_ = false;
  int n_readers_ = 0;
};

}  // namespace brash::live
