// SPDX-License-Identifier: GPL-3.0-or-later
// The end of a server of a view. A server that does not end is stopped by the time limit of the test.
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
using brash::live::Server;

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

BOOST_AUTO_TEST_CASE(a_server_ends_beside_senders_that_never_finish_a_request) {
  std::optional<Server> server("<html></html>");
  const sockaddr_in place = place_of(*server);
  // More of them than the server has threads.
  std::vector<int> senders;
  for (int i = 0; i < 20; ++i) senders.push_back(connection_to(place));
  for (const int socket : senders) BOOST_TEST(::send(socket, "GET / HTTP/1.1\r\nName: ", 22, MSG_NOSIGNAL) == 22);
  // Each byte comes well within the library's patience for one, for longer than the test may take.
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
