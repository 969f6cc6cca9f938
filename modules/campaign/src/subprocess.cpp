// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/campaign/subprocess.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "brash/core/error.hpp"

extern char** environ;  // POSIX

namespace brash::campaign {
namespace {

/// A pipe whose ends are closed when it goes.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0)
      throw RunError(fmt::format("no pipe: {}", std::generic_category().message(errno)));
  }
  ~Pipe() {
    ::close(ends_[0]);
    close_writing();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reading() const { return ends_[0]; }
  int writing() const { return ends_[1]; }
  void close_writing() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// Reads both pipes to their ends, as they fill.
void read_all(const Pipe& out, const Pipe& err, Printed& printed) {
  std::array<pollfd, 2> open{{{out.reading(), POLLIN, 0}, {err.reading(), POLLIN, 0}}};
  std::array<char, 4096> block{};
  while (open[0].fd >= 0 || open[1].fd >= 0) {
    if (::poll(open.data(), open.size(), -1) < 0 && errno != EINTR) return;
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (open[i].fd < 0 || open[i].revents == 0) continue;
      const ssize_t n = ::read(open[i].fd, block.data(), block.size());
      if (n > 0) (i == 0 ? printed.out : printed.err).append(block.data(), static_cast<std::size_t>(n));
      if (n == 0 || (n < 0 && errno != EINTR)) open[i].fd = -1;
    }
  }
}

}  // namespace

Printed run_command(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  Pipe out;
  Pipe err;
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_addopen(&streams, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&streams, out.writing(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&streams, err.writing(), STDERR_FILENO);
  pid_t process = 0;
  const int status = posix_spawnp(&process, arguments.front(), &streams, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&streams);
  if (status != 0)
    throw RunError(fmt::format("{}: cannot be started: {}", command.front(), std::generic_category().message(status)));
  out.close_writing();
  err.close_writing();
  Printed printed;
  read_all(out, err, printed);
  int ended = 0;
  while (::waitpid(process, &ended, 0) < 0 && errno == EINTR) {
  }
  printed.code = WIFEXITED(ended) ? WEXITSTATUS(ended) : 128 + WTERMSIG(ended);
  return printed;
}

}  // namespace brash::campaign
