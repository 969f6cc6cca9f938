// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace brash::live {

/// How much of this process a client may take. A client that takes more is cut off.
struct Limits {
  std::size_t header = 8192;                 ///< bytes of a request before its body
  std::size_t body = 1024;                   ///< bytes; wishes have none
  std::size_t connections = 64;              ///< the oldest one without the token makes room for a new one
  int readers = 12;                          ///< browsers that take the stream; the next one is refused (503)
  std::chrono::milliseconds request{5000};   ///< time for a whole request, so that no client is slow without end
  std::chrono::milliseconds answer{30'000};  ///< time in which a client has to take one answer, or one event
};

/// Shows one page to browsers on this machine, with a stream of what is published, and takes their wishes.
///
/// It listens on 127.0.0.1, on a port of the system's choice. Its address holds a token of 128 random bits that is made
/// for this server: whoever has the address may watch, pause and stop. Every other request is refused (403), and so is
/// a request from a page of another origin. The token is checked with the first line of a request. A client that is
/// slow, or is killed, holds up nobody else, and never the caller.
class Server {
 public:
  /// @param page  HTML. Beside it lie `events`, the stream (server-sent events), and `pause`, `resume` and `stop`,
  /// which take POST requests.
  /// @throws RunError when it cannot listen.
  explicit Server(std::string page, Limits limits = {});
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server();

  /// http://127.0.0.1:PORT/TOKEN/
  const std::string& address() const;

  /// Sends one event to every browser, to those that come later too.
  /// @param data  one line of text.
  void publish(const std::string& event, const std::string& data);

  /// Whether a browser takes the stream now. What nobody takes need not be made yet.
  bool is_watched() const;

  /// Whether a browser asked for a pause that continues.
  bool is_paused() const;

  /// Whether a browser asked for an end.
  bool is_asked_to_end() const;

  /// Returns at once unless a browser asked for a pause: then when the pause ends, an end is asked for, or `ended`.
  void wait_while_paused(const std::function<bool()>& ended) const;

  /// Waits until the browsers that are connected have received everything, `longest` at most, and ends their streams.
  void finish(std::chrono::milliseconds longest);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace brash::live
