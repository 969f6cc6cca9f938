// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

namespace brash::statistics {

/// A stream of random numbers keyed by its purpose: the same key gives the same numbers, in any order of creation.
///
/// Generator: three of GSL's `ranlxd2` (Luescher, 48 bits), added modulo 1. One alone takes a seed of 31 bits only,
/// so among 50 000 streams two would be likely to coincide; three take 93 bits, and two of 10^9 streams coincide with a
/// chance of 5e-11. The seeds are taken from the SHA-256 of the whole key, whose texts are written with their lengths.
class RandomStream {
 public:
  /// A stream of a simulated run. Two runs with equal seed and replicate draw the same, whatever their files are
  /// called.
  /// @param seed       of the case.
  /// @param replicate  which repetition.
  /// @param purpose    e.g. "wedges".
  /// @param counter    which draw event, so that a stream can be reopened without replaying (restart).
  RandomStream(std::uint64_t seed, std::uint64_t replicate, std::string_view purpose, std::uint64_t counter = 0);
  /// A stream of anything else, e.g. of a bootstrap.
  /// @param user  who draws.
  RandomStream(std::uint64_t seed, std::string_view user, std::uint64_t replicate, std::string_view purpose,
               std::uint64_t counter = 0);
  RandomStream(RandomStream&&) noexcept;
  RandomStream& operator=(RandomStream&&) noexcept;
  ~RandomStream();

  /// Uniform in [0, 1), a multiple of 2^-48.
  double uniform();
  /// Uniform whole number in [from, to]; from <= to. Takes one uniform number.
  int uniform_int(int from, int to);
  /// Normal with mean 0 and deviation 1, by inversion: takes one uniform number.
  double normal();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace brash::statistics
