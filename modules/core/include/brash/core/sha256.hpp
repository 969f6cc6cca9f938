// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

namespace brash {

/// SHA-256 of bytes that come in pieces.
class Sha256 {
 public:
  using Digest = std::array<unsigned char, 32>;

  Sha256();
  ~Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;

  void add(std::string_view bytes);
  /// The digest of all bytes added. The next bytes begin another digest.
  Digest digest();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A digest as 64 hexadecimal digits.
std::string hexadecimal(const Sha256::Digest& digest);

/// SHA-256 of `bytes` as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

/// SHA-256 of a file's bytes as 64 hexadecimal digits.
/// @throws RunError when the file cannot be read.
std::string sha256_of_file(const std::string& path);

}  // namespace brash
