// SPDX-License-Identifier: GPL-3.0-or-later
// Preloaded, it makes the monotonic clock run twenty thousand times faster: two minutes pass in 6 ms.
#define _GNU_SOURCE
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

static const long long kFactor = 20000;

int clock_gettime(clockid_t clock, struct timespec* now) {
  static const long long kNanoseconds = 1000000000;
  static long long begun = -1;
  const int status = (int)syscall(SYS_clock_gettime, clock, now);
  if (status != 0 || clock != CLOCK_MONOTONIC) return status;
  long long time = now->tv_sec * kNanoseconds + now->tv_nsec;
  if (begun < 0) begun = time;
  time = begun + kFactor * (time - begun);
  now->tv_sec = time / kNanoseconds;
  now->tv_nsec = time % kNanoseconds;
  return 0;
}
