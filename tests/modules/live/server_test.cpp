// SPDX-License-Identifier: GPL-3.0-or-later
// What clients may not do to the server of a view, and its end. A server that does not end is stopped by the time
// limit of the test.
#include "brash/live/server.hpp"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace std::chrono_literals;
using brash::live::Limits;
using brash::live::Server;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kFlood = 64 << 20;  // more than the system keeps for a socket

sockaddr_in place_of(const Server& server) {
  const std::string& address = server.address();
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  place.sin_port = htons(static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))));
  return place;
}

int connection_to(const sockaddr_in& place) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  BOOST_TEST_REQUIRE(::connect(socket, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0);
  return socket;
}

/// What the server answers to a text, until it ends the connection.
std::string answer_of(const Server& server, const std::string& text) {
  const int socket = connection_to(place_of(server));
  BOOST_TEST(::send(socket, text.data(), text.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(text.size()));
  std::string answer;
  char bytes[4096];
  for (ssize_t n = 0; (n = ::recv(socket, bytes, sizeof bytes, 0)) > 0;)
    answer.append(bytes, static_cast<std::size_t>(n));
  ::close(socket);
  return answer;
}

/// A request with the token. @param fields  of its header, each with its line's end.
std::string request_for(const Server& server, const std::string& method, const std::string& name,
                        const std::string& fields = "") {
  const std::string host = server.address().substr(7, server.address().find('/', 7) - 7);
  return method + server.address().substr(7 + host.size()) + name + " HTTP/1.1\r\nHost: " + host + "\r\n" + fields +
         "\r\n";
}

/// Sends copies of `line` behind `beginning` until the server takes no more, 64 MiB at most. @return the sent bytes.
std::size_t flood(const Server& server, const std::string& beginning, const std::string& line) {
  const int socket = connection_to(place_of(server));
  std::string lines;
  while (lines.size() < 65536) lines += line;
  BOOST_TEST(::send(socket, beginning.data(), beginning.size(), MSG_NOSIGNAL) ==
             static_cast<ssize_t>(beginning.size()));
  std::size_t sent = 0;
  for (ssize_t n = 0; sent < kFlood && (n = ::send(socket, lines.data(), lines.size(), MSG_NOSIGNAL)) > 0;)
    sent += static_cast<std::size_t>(n);
  ::close(socket);
  return sent;
}

/// The server's own socket, which listens at this place.
int listener_at(const sockaddr_in& place) {
  for (int socket = 0; socket < 1024; ++socket) {
    sockaddr_in own{};
    socklen_t size = sizeof own;
    int listens = 0;
    socklen_t listens_size = sizeof listens;
    if (::getsockname(socket, reinterpret_cast<sockaddr*>(&own), &size) == 0 && own.sin_port == place.sin_port &&
        ::getsockopt(socket, SOL_SOCKET, SO_ACCEPTCONN, &listens, &listens_size) == 0 && listens != 0)
      return socket;
  }
  return -1;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_client_sends_no_more_than_a_bounded_number_of_bytes) {
  const Server server("<html></html>");
  BOOST_TEST(flood(server, "GET / HTTP/1.1\r\n", "Name: value\r\n") < kFlood);
  const std::string unfinished = request_for(server, "GET ", "");
  BOOST_TEST(flood(server, unfinished.substr(0, unfinished.size() - 2), "Name: value\r\n") < kFlood);
  const std::string chunked = request_for(server, "POST ", "resume", "Transfer-Encoding: chunked\r\n");
  BOOST_TEST(flood(server, chunked, "4\r\nbody\r\n") < kFlood);
  BOOST_TEST(answer_of(server, request_for(server, "GET ", "")).ends_with("<html></html>"));
}

BOOST_AUTO_TEST_CASE(the_token_is_checked_before_the_header_is_there) {
  const Server server("<html></html>", {.request = 60s});
  BOOST_TEST(answer_of(server, "GET /0123/ HTTP/1.1\r\nHost: ").starts_with("HTTP/1.1 403 "));
}

BOOST_AUTO_TEST_CASE(a_page_of_another_origin_is_refused) {
  const Server server("<html></html>");
  const std::string own = "Origin: " + server.address().substr(0, server.address().find('/', 7)) + "\r\n";
  for (const std::string fields : {"Origin: http://evil.example\r\n", "Origin: null\r\n"}) {
    BOOST_TEST(answer_of(server, request_for(server, "POST ", "stop", fields)).starts_with("HTTP/1.1 403 "));
    BOOST_TEST(!server.is_asked_to_end());
  }
  BOOST_TEST(answer_of(server, request_for(server, "POST ", "stop", own)).starts_with("HTTP/1.1 204 "));
  BOOST_TEST(server.is_asked_to_end());
}

BOOST_AUTO_TEST_CASE(a_request_that_comes_byte_by_byte_ends_at_its_deadline) {
  const Server server("<html></html>", {.request = 300ms});
  const int socket = connection_to(place_of(server));
  const std::string header = request_for(server, "GET ", "", "Name: ");
  ::send(socket, header.data(), header.size() - 2, MSG_NOSIGNAL);
  const auto begin = Clock::now();
  char byte = 0;
  while (Clock::now() - begin < 20s && ::recv(socket, &byte, 1, MSG_DONTWAIT) != 0) {
    ::send(socket, "a", 1, MSG_NOSIGNAL);
    std::this_thread::sleep_for(20ms);
  }
  BOOST_TEST((Clock::now() - begin < 20s));
  ::close(socket);
}

BOOST_AUTO_TEST_CASE(a_reader_that_takes_nothing_is_cut_off_and_keeps_no_copy) {
  Server server("<html></html>", {.answer = 300ms});
  const int socket = connection_to(place_of(server));
  const std::string request = request_for(server, "GET ", "events");
  ::send(socket, request.data(), request.size(), MSG_NOSIGNAL);
  while (!server.is_watched()) std::this_thread::sleep_for(1ms);
  const std::string megabyte(1 << 20, 'x');
  for (int i = 0; i < 16; ++i) server.publish("records", megabyte);  // more than the system keeps for a socket
  const auto begin = Clock::now();
  while (server.is_watched() && Clock::now() - begin < 20s) std::this_thread::sleep_for(10ms);
  BOOST_TEST(!server.is_watched());
  ::close(socket);
}

BOOST_AUTO_TEST_CASE(readers_beyond_the_limit_are_told_so) {
  Server server("<html></html>", {.readers = 1});
  const int socket = connection_to(place_of(server));
  const std::string request = request_for(server, "GET ", "events");
  ::send(socket, request.data(), request.size(), MSG_NOSIGNAL);
  while (!server.is_watched()) std::this_thread::sleep_for(1ms);
  BOOST_TEST(answer_of(server, request).starts_with("HTTP/1.1 503 "));
  ::close(socket);
}

BOOST_AUTO_TEST_CASE(connections_that_ask_nothing_hold_up_nobody) {
  const Server server("<html></html>", {.request = 1h});
  std::vector<int> silent;
  for (int i = 0; i < 200; ++i) silent.push_back(connection_to(place_of(server)));
  BOOST_TEST(answer_of(server, request_for(server, "GET ", "")).ends_with("<html></html>"));
  for (const int socket : silent) ::close(socket);
}

BOOST_AUTO_TEST_CASE(a_reader_gets_what_was_published_before_and_after_it_came) {
  Server server("<html></html>");
  server.publish("records", "1");
  std::jthread later([&] {
    while (!server.is_watched()) std::this_thread::sleep_for(1ms);
    server.publish("records", "2");
    server.finish(10s);
  });
  const std::string one = "id: 0\nevent: records\ndata: 1\n\n", two = "id: 1\nevent: records\ndata: 2\n\n";
  const std::string answer = answer_of(server, request_for(server, "GET ", "events"));
  BOOST_TEST(answer.ends_with("\r\n\r\n" + one + two));
  const std::string rest = answer_of(server, request_for(server, "GET ", "events", "last-event-id: 0\r\n"));
  BOOST_TEST(rest.ends_with("\r\n\r\n" + two));
}

BOOST_AUTO_TEST_CASE(a_server_ends_beside_senders_that_never_finish_a_request) {
  std::optional<Server> server("<html></html>");
  const sockaddr_in place = place_of(*server);
  std::vector<int> senders;
  for (int i = 0; i < 20; ++i) senders.push_back(connection_to(place));
  const std::string begun = request_for(*server, "GET ", "", "Name: ");
  for (const int socket : senders)
    BOOST_TEST(::send(socket, begun.data(), begun.size() - 2, MSG_NOSIGNAL) == static_cast<ssize_t>(begun.size() - 2));
  // Bytes keep coming, so that no connection is silent.
  std::jthread bytes([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      for (const int socket : senders) ::send(socket, "a", 1, MSG_NOSIGNAL);
      std::this_thread::sleep_for(100ms);
    }
  });
  std::this_thread::sleep_for(300ms);
  server.reset();
  bytes = {};
  char byte = 0;
  for (const int socket : senders) {
    BOOST_TEST(::recv(socket, &byte, 1, MSG_DONTWAIT) <= 0);
    ::close(socket);
  }
}

BOOST_AUTO_TEST_CASE(a_server_that_listens_no_more_ends) {
  std::optional<Server> server("<html></html>");
  const sockaddr_in place = place_of(*server);
  ::close(connection_to(place));
  const int listener = listener_at(place);
  BOOST_TEST_REQUIRE(listener >= 0);
  ::shutdown(listener, SHUT_RDWR);
  std::this_thread::sleep_for(300ms);  // in which it finds out
  server.reset();
  BOOST_TEST(listener_at(place) == -1);
}
