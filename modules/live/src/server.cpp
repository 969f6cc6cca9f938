// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/live/server.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <charconv>
#include <cstdint>
#include <future>
#include <list>
#include <optional>
#include <random>
#include <sstream>
#include <string_view>
#include <thread>
#include <utility>

#include "brash/core/error.hpp"
#include "stream.hpp"

namespace brash::live {
namespace {

using namespace std::chrono_literals;
namespace net = boost::asio;
namespace http = boost::beast::http;
using boost::system::error_code;
using net::ip::tcp;

constexpr std::chrono::seconds kHeartbeat{1};  ///< a comment is sent so often: a browser that is gone is noticed
constexpr std::chrono::milliseconds kPauseStep{50};
constexpr std::chrono::milliseconds kAcceptAgain{100};  ///< after a failure, such as too many open files
constexpr std::chrono::milliseconds kGrace{1000};       ///< for answers under way at the end, and for a last goodbye
constexpr std::size_t kReadAtOnce = 4096;
constexpr std::size_t kIgnored = 65'536;  ///< bytes of a refused client that are read, so that it sees the answer

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

/// Boost's string views are of another type in each version.
template <typename Text>
std::string_view view_of(const Text& text) {
  return {text.data(), text.size()};
}

/// Where a browser that was cut off continues: behind the last event that it has.
std::size_t event_after(std::string_view last) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(last.data(), last.data() + last.size(), number);
  return error == std::errc() && end == last.data() + last.size() && !last.empty() ? number + 1 : 0;
}

}  // namespace

/// The state that clients share. The thread of the server and the caller both use it.
struct View {
  std::string page;
  Limits limits;
  std::string token = new_token();
  std::string host{};  ///< and port
  Stream stream{};
  std::atomic<bool> is_paused{false}, is_asked_to_end{false};
  std::function<void()> published{};  ///< wakes the readers

  std::string root() const { return "/" + token + "/"; }

  void publish(const std::string& event, const std::string& data) {
    stream.publish(event, data);
    published();
  }

  /// All browsers get a message, so that each shows the button that fits.
  void wish_pause(bool paused) {
    if (is_paused.exchange(paused) != paused) publish("paused", paused ? "true" : "false");
  }

  /// @return whether there is such a wish.
  bool fulfil(std::string_view wish) {
    if (wish == "pause" || wish == "resume")
      wish_pause(wish == "pause");
    else if (wish == "stop")
      is_asked_to_end = true;
    else
      return false;
    return true;
  }
};

/// One connection: it reads one request, answers it, and ends. It lives as long as an operation of it waits.
class Client : public std::enable_shared_from_this<Client> {
 public:
  Client(tcp::socket socket, View& view)
      : view_(view), stream_(std::move(socket)), heartbeat_(stream_.get_executor()), buffer_(2 * view.limits.header) {
    parser_.eager(true);
    parser_.header_limit(static_cast<std::uint32_t>(view.limits.header));
    parser_.body_limit(view.limits.body);
  }

  void start() {
    stream_.expires_after(view_.limits.request);  // for all reads together
    read();
  }
  /// Whether it has shown the token.
  bool is_admitted() const { return is_admitted_; }
  /// Looks for events that are new.
  void wake() { heartbeat_.cancel(); }
  void shut() { stream_.close(); }

 private:
  void read() {
    if (buffer_.size() + kReadAtOnce > buffer_.max_size()) return refuse_length();
    stream_.async_read_some(buffer_.prepare(kReadAtOnce), [self = shared_from_this()](error_code error, std::size_t n) {
      if (!error) self->have_read(n);
    });
  }

  void have_read(std::size_t n) {
    buffer_.commit(n);
    error_code error;
    buffer_.consume(parser_.put(buffer_.data(), error));
    if (error == http::error::body_limit || error == http::error::header_limit) return refuse_length();
    if (error && error != http::error::need_more) return;
    const std::string_view target = view_of(parser_.get().target());
    const bool is_refused = parser_.is_header_done() ? !admits() : !target.empty() && !target.starts_with(view_.root());
    if (is_refused)
      return refuse(http::status::forbidden, "The address of a view holds a token that is made for its run.\n");
    is_admitted_ = parser_.is_header_done();
    if (parser_.is_done())
      answer();
    else
      read();
  }

  void refuse_length() { refuse(http::status::payload_too_large, "A request of a view is short.\n"); }

  /// Lets nobody in without the token, nor a page of another name that leads here.
  bool admits() const {
    const auto& request = parser_.get();
    const auto origin = request.find(http::field::origin);
    return view_of(request.target()).starts_with(view_.root()) && view_of(request[http::field::host]) == view_.host &&
           (origin == request.end() || view_of(origin->value()) == "http://" + view_.host);
  }

  void answer() {
    const auto& request = parser_.get();
    std::string_view name = view_of(request.target()).substr(view_.root().size());
    name = name.substr(0, name.find('?'));
    if (request.method() == http::verb::get && name.empty())
      return send(http::status::ok, "text/html; charset=utf-8", view_.page);
    if (request.method() == http::verb::get && name == "events") return begin_events();
    if (request.method() == http::verb::post && view_.fulfil(name)) return send(http::status::no_content, "", "");
    refuse(http::status::not_found, "A view has no such page.\n");
  }

  void refuse(http::status status, const char* why) { send(status, "text/plain", why); }

  static http::response<http::empty_body> header(http::status status, const char* type) {
    http::response<http::empty_body> response(status, 11);
    if (*type != '\0') response.set(http::field::content_type, type);
    response.set(http::field::cache_control, "no-store");
    response.set("X-Content-Type-Options", "nosniff");
    response.set("Referrer-Policy", "no-referrer");
    response.keep_alive(false);
    return response;
  }

  /// @param body  outlives the connection.
  void send(http::status status, const char* type, std::string_view body) {
    auto response = header(status, type);
    if (status != http::status::no_content) response.content_length(body.size());
    write(text_of(response), body, &Client::leave);
  }

  /// The stream ends with its connection.
  void begin_events() {
    if (view_.stream.n_readers() >= view_.limits.readers)
      return refuse(http::status::service_unavailable, "Too many browsers watch already.\n");
    reader_.emplace(view_.stream);
    next_ = event_after(view_of(parser_.get()["Last-Event-ID"]));
    write(text_of(header(http::status::ok, "text/event-stream")), {}, &Client::send_next);
  }

  static Stream::Event text_of(const http::response<http::empty_body>& response) {
    std::ostringstream text;
    text << response.base();
    return std::make_shared<const std::string>(text.str());
  }

  /// Sends one event at a time, and takes the next when the client has taken this one: nothing piles up for it.
  void send_next() {
    static const auto kComment = std::make_shared<const std::string>(":\n\n");
    const bool beats = std::exchange(is_beat_due_, false);
    if (Stream::Event event = view_.stream.at(next_)) {
      ++next_;
      return write(std::move(event), {}, &Client::send_next);
    }
    if (view_.stream.ends_before(next_)) return leave();
    if (beats) return write(kComment, {}, &Client::send_next);
    heartbeat_.expires_after(kHeartbeat);
    heartbeat_.async_wait([self = shared_from_this()](error_code woken) {
      self->is_beat_due_ = !woken;
      self->send_next();
    });
  }

  /// @param body  follows the text, and outlives the connection.
  void write(Stream::Event text, std::string_view body, void (Client::*then)()) {
    const std::array bytes{net::buffer(*text), net::buffer(body.data(), body.size())};
    stream_.expires_after(view_.limits.answer);
    net::async_write(stream_, bytes,
                     [self = shared_from_this(), text = std::move(text), then](error_code error, std::size_t) {
                       if (!error) ((*self).*then)();
                     });
  }

  /// A connection that is closed with bytes unread loses the answer: the rest is read for a moment.
  void leave() {
    reader_.reset();
    error_code ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    stream_.expires_after(kGrace);
    ignore(kIgnored);
  }

  void ignore(std::size_t most) {
    buffer_.clear();
    stream_.async_read_some(buffer_.prepare(kReadAtOnce),
                            [self = shared_from_this(), most](error_code error, std::size_t n) {
                              if (!error && n < most) self->ignore(most - n);
                            });
  }

  View& view_;
  boost::beast::tcp_stream stream_;
  net::steady_timer heartbeat_;
  boost::beast::flat_buffer buffer_;
  http::request_parser<http::string_body> parser_;
  bool is_admitted_ = false;
  std::optional<Stream::Reader> reader_;  ///< while it takes the stream
  std::size_t next_ = 0;                  ///< event
  bool is_beat_due_ = false;              ///< if there is no event
};

struct Server::Impl {
  View view;
  std::string address;
  net::io_context io{1};  ///< its handlers run in one thread
  tcp::acceptor acceptor{io};
  net::steady_timer accept_again{io};
  std::list<std::weak_ptr<Client>> clients;  ///< the oldest first
  std::future<void> handlers;

  Impl(std::string page, Limits limits) : view{.page = std::move(page), .limits = limits} {
    listen();
    view.host = "127.0.0.1:" + std::to_string(acceptor.local_endpoint().port());
    view.published = [this] { net::post(io, [this] { for_each_client(&Client::wake); }); };
    address = "http://" + view.host + view.root();
    accept();
    handlers = std::async(std::launch::async, [this] { io.run(); });
  }

  /// Answers that are under way have a moment to reach their clients.
  ~Impl() {
    view.stream.close();
    net::post(io, [this] { end(); });
    if (handlers.wait_for(kGrace) != std::future_status::ready) io.stop();
    handlers.wait();
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void listen() {
    try {
      const tcp::endpoint here(net::ip::address_v4::loopback(), 0);
      acceptor.open(here.protocol());
      acceptor.bind(here);
      acceptor.listen();
    } catch (const boost::system::system_error&) {
      throw RunError("no view: cannot listen on 127.0.0.1\n  remedy:  run without --view, and look at the report");
    }
  }

  void accept() {
    acceptor.async_accept([this](error_code error, tcp::socket socket) {
      if (!acceptor.is_open()) return;
      if (!error) {
        take(std::move(socket));
        return accept();
      }
      accept_again.expires_after(kAcceptAgain);
      accept_again.async_wait([this](error_code cancelled) {
        if (!cancelled) accept();
      });
    });
  }

  /// When there are too many connections, the oldest one that has not shown the token ends.
  void take(tcp::socket socket) {
    clients.remove_if([](const auto& client) { return client.expired(); });
    if (clients.size() >= view.limits.connections) {
      const auto stranger = std::find_if(clients.begin(), clients.end(), [](const auto& client) {
        const auto living = client.lock();
        return !living || !living->is_admitted();
      });
      if (stranger == clients.end()) return;
      if (const auto living = stranger->lock()) living->shut();
      clients.erase(stranger);
    }
    const auto client = std::make_shared<Client>(std::move(socket), view);
    clients.push_back(client);
    client->start();
  }

  void for_each_client(void (Client::*act)()) {
    for (const auto& client : clients)
      if (const auto living = client.lock()) ((*living).*act)();
  }

  /// Afterwards the handlers run until the last answer is sent.
  void end() {
    error_code ignored;
    acceptor.close(ignored);
    accept_again.cancel();
    for (const auto& client : clients) {
      const auto living = client.lock();
      if (!living) continue;
      living->wake();
      if (!living->is_admitted()) living->shut();
    }
  }
};

Server::Server(std::string page, Limits limits) : impl_(std::make_unique<Impl>(std::move(page), limits)) {}
Server::~Server() = default;

const std::string& Server::address() const { return impl_->address; }

void Server::publish(const std::string& event, const std::string& data) { impl_->view.publish(event, data); }

bool Server::is_watched() const { return impl_->view.stream.n_readers() > 0; }

bool Server::is_paused() const { return impl_->view.is_paused; }

bool Server::is_asked_to_end() const { return impl_->view.is_asked_to_end; }

void Server::wait_while_paused(const std::function<bool()>& ended) const {
  const View& view = impl_->view;
  while (view.is_paused && !view.is_asked_to_end && !ended()) std::this_thread::sleep_for(kPauseStep);
}

void Server::finish(std::chrono::milliseconds longest) {
  impl_->view.stream.close();
  impl_->view.published();
  impl_->view.stream.wait_for_readers(longest);
}

}  // namespace brash::live
