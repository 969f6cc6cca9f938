// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/live/server.hpp"

#include <httplib.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <atomic>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <thread>
#include <utility>

#include "brash/core/error.hpp"
#include "stream.hpp"

namespace brash::live {
namespace {

using namespace std::chrono_literals;

constexpr const char* kHost = "127.0.0.1";
constexpr int kMostReaders = 12;               ///< each holds a thread
constexpr std::size_t kThreads = 16;           ///< of the server; the others answer wishes
constexpr std::size_t kMostBytes = 1024;       ///< of a request's body; wishes have none
constexpr std::chrono::seconds kHeartbeat{1};  ///< a comment is sent so often: a browser that is gone is noticed
constexpr std::chrono::milliseconds kPauseStep{50};
constexpr std::chrono::milliseconds kEndStep{5};   ///< at the end the server is looked at so often
constexpr std::chrono::milliseconds kGrace{1000};  ///< for answers under way at the end; then connections are shut

/// 128 random bits of the system, in hexadecimal.
std::string new_token() {
  std::random_device random;
  std::string token;
  for (int i = 0; i < 4; ++i) {
    static constexpr char kDigits[] = "0123456789abcdef";
    const auto word = static_cast<std::uint32_t>(random());
    for (int shift = 28; shift >= 0; shift -= 4) token += kDigits[word >> static_cast<unsigned>(shift) & 15U];
  }
  return token;
}

/// Ends all connections of this process that lead to `port` of 127.0.0.1: the library names no socket of its own.
void shut_connections(int port) {
  std::error_code failed;
  for (std::filesystem::directory_iterator file("/proc/self/fd", failed), end; !failed && file != end;
       file.increment(failed)) {
    const int socket = std::atoi(file->path().filename().c_str());
    sockaddr_in place{};
    socklen_t size = sizeof place;
    if (::getsockname(socket, reinterpret_cast<sockaddr*>(&place), &size) != 0) continue;
    if (place.sin_family == AF_INET && ntohs(place.sin_port) == port) ::shutdown(socket, SHUT_RDWR);
  }
}

/// Where a browser that was cut off goes on: behind the last event that it has.
std::size_t first_event(const httplib::Request& request) {
  const std::string last = request.get_header_value("Last-Event-ID");
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(last.data(), last.data() + last.size(), number);
  return error == std::errc() && end == last.data() + last.size() && !last.empty() ? number + 1 : 0;
}

}  // namespace

struct Server::Impl {
  std::string page;
  std::string token = new_token();
  std::string address;
  std::string host;
  int port = 0;
  Stream stream;
  std::atomic<bool> is_paused{false}, is_ended{false}, has_listened{false};
  httplib::Server http;
  std::thread thread;

  explicit Impl(std::string html) : page(std::move(html)) {
    http.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    http.set_payload_max_length(kMostBytes);
    http.set_pre_routing_handler(
        [this](const httplib::Request& request, httplib::Response& response) { return admit(request, response); });
    route();
    port = http.bind_to_any_port(kHost);
    if (port <= 0)
      throw RunError("no view: cannot listen on 127.0.0.1\n  remedy:  run without --view, and look at the report");
    host = std::string(kHost) + ":" + std::to_string(port);
    address = "http://" + host + "/" + token + "/";
    thread = std::thread([this] {
      http.listen_after_bind();
      has_listened = true;
    });
  }

  ~Impl() {
    stream.close();
    // A server that is stopped before it listens would listen on. One whose socket has failed listens no more.
    while (!http.is_running() && !has_listened) std::this_thread::sleep_for(1ms);
    http.stop();
    // The library waits for a byte at a time: a sender of endless requests would hold its thread.
    for (auto waited = 0ms; !has_listened; waited += kEndStep) {
      std::this_thread::sleep_for(kEndStep);
      if (waited >= kGrace) shut_connections(port);
    }
    thread.join();
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  /// Lets nobody in without the token, nor a page of another name that leads here.
  httplib::Server::HandlerResponse admit(const httplib::Request& request, httplib::Response& response) const {
    response.set_header("Cache-Control", "no-store");
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("Referrer-Policy", "no-referrer");
    const bool knows_token = request.path.starts_with("/" + token + "/");
    if (knows_token && request.get_header_value("Host") == host) return httplib::Server::HandlerResponse::Unhandled;
    response.status = 403;
    response.set_content("The address of a view holds a token that is made for its run.\n", "text/plain");
    return httplib::Server::HandlerResponse::Handled;
  }

  void route() {
    const std::string root = "/" + token + "/";
    // The library compresses texts that are given whole, at Brotli's best level: more work than seconds of a run.
    http.Get(root, [this](const httplib::Request&, httplib::Response& response) {
      response.set_content_provider(page.size(), "text/html; charset=utf-8",
                                    [this](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
                                      return sink.write(page.data() + offset, length);
                                    });
    });
    http.Get(root + "events",
             [this](const httplib::Request& request, httplib::Response& response) { send_events(request, response); });
    const auto on = [&](const char* wish, auto act) {
      http.Post(root + wish, [act](const httplib::Request&, httplib::Response& response) {
        act();
        response.status = 204;
      });
    };
    on("pause", [this] { wish_pause(true); });
    on("resume", [this] { wish_pause(false); });
    on("stop", [this] { is_ended = true; });
  }

  /// All browsers are told, so that each shows the button that fits.
  void wish_pause(bool paused) {
    if (is_paused.exchange(paused) != paused) stream.publish("paused", paused ? "true" : "false");
  }

  void send_events(const httplib::Request& request, httplib::Response& response) {
    if (stream.n_readers() >= kMostReaders) {
      response.status = 503;
      response.set_content("Too many browsers watch already.\n", "text/plain");
      return;
    }
    const auto reader = std::make_shared<Stream::Reader>(stream);
    response.set_chunked_content_provider(
        "text/event-stream", [this, reader, next = first_event(request)](std::size_t, httplib::DataSink& sink) mutable {
          const Stream::Event event = stream.wait_for(next, kHeartbeat);
          if (event) {
            ++next;
            return sink.write(event->data(), event->size());
          }
          if (!stream.ends_before(next)) return sink.write(":\n\n", 3);
          sink.done();
          return true;
        });
  }
};

Server::Server(std::string page) : impl_(std::make_unique<Impl>(std::move(page))) {}
Server::~Server() = default;

const std::string& Server::address() const { return impl_->address; }

void Server::publish(const std::string& event, const std::string& data) { impl_->stream.publish(event, data); }

bool Server::is_watched() const { return impl_->stream.n_readers() > 0; }

bool Server::is_paused() const { return impl_->is_paused; }

bool Server::is_asked_to_end() const { return impl_->is_ended; }

void Server::wait_while_paused(const std::function<bool()>& ended) const {
  while (impl_->is_paused && !impl_->is_ended && !ended()) std::this_thread::sleep_for(kPauseStep);
}

void Server::finish(std::chrono::milliseconds longest) {
  impl_->stream.close();
  impl_->stream.wait_for_readers(longest);
}

}  // namespace brash::live
