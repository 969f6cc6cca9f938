// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/sha256.hpp"

#include <nettle/sha2.h>

#include <cerrno>
#include <cstdint>
#include <fstream>
#include <system_error>
#include <vector>

#include "brash/core/error.hpp"

namespace brash {
namespace {

[[noreturn]] void fail_to_hash(const std::string& path, const std::string& reason) {
  throw RunError(path + ": cannot be hashed: " + reason + "\n  remedy:  check that the file is there and may be read");
}

}  // namespace

struct Sha256::State {
  sha256_ctx context;
};

Sha256::Sha256() : state_(std::make_unique<State>()) { sha256_init(&state_->context); }

Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
  sha256_update(&state_->context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
}

Sha256::Digest Sha256::digest() {
  Digest digest{};
  sha256_digest(&state_->context, digest.size(), digest.data());
  return digest;
}

std::string hexadecimal(const Sha256::Digest& digest) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : digest) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

std::string sha256(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hexadecimal(hash.digest());
}

std::string sha256_of_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail_to_hash(path, std::generic_category().message(errno));
  Sha256 hash;
  std::vector<char> block(1 << 16);
  do {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    hash.add({block.data(), static_cast<std::size_t>(stream.gcount())});
  } while (stream);
  if (stream.bad()) fail_to_hash(path, "it cannot be read");
  return hexadecimal(hash.digest());
}

}  // namespace brash
