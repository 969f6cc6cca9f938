// SPDX-License-Identifier: GPL-3.0-or-later
#include "netcdf_file.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "brash/core/write_file.hpp"

namespace brash::training {
namespace {

/// @return 0, or the system's error number.
int write_apart(const std::string& part, const std::function<void(const std::string& part)>& write) {
  // A file that has the name of a part already, a link too, is never opened.
  if (::unlink(part.c_str()) != 0 && errno != ENOENT) return errno;
  const pid_t writer = ::fork();
  if (writer < 0) return errno;
  if (writer == 0) {
    errno = 0;
    try {
      write(part);
    } catch (const std::exception&) {
      ::_exit(errno > 0 && errno < 256 ? errno : EIO);
    }
    ::_exit(0);
  }
  int ended = 0;
  while (::waitpid(writer, &ended, 0) < 0)
    if (errno != EINTR) return errno;
  return WIFEXITED(ended) ? WEXITSTATUS(ended) : EIO;
}

}  // namespace

void put_doubles(Writer& file, const char* name, const std::vector<double>& values) {
  if (!values.empty()) file.check(nc_put_var_double(file.id(), file.variable(name), values.data()), name);
}

std::vector<std::string> read_messages(const Reader& file, std::size_t n) {
  std::vector<char*> raw(n, nullptr);
  file.expect_size("error", n);
  file.check(nc_get_var_string(file.id(), file.variable("error"), raw.data()), "error");
  std::vector<std::string> messages;
  for (const char* message : raw) messages.emplace_back(message == nullptr ? "" : message);
  file.check(nc_free_string(n, raw.data()), "error");
  return messages;
}

void write_whole(const std::string& path, const std::function<void(const std::string& part)>& write) {
  const std::string part = part_of(path);
  if (const int status = write_apart(part, write); status != 0) {
    std::remove(part.c_str());
    throw StorageError(
        fmt::format("{}: cannot be written: {}\n  remedy:  check that its folder may be written and has space", path,
                    std::generic_category().message(status)));
  }
  publish(part, path);
}

}  // namespace brash::training
