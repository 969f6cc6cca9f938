// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/sha256.hpp"

#include <openssl/evp.h>

#include <cerrno>
#include <fstream>
#include <system_error>
#include <vector>

#include "brash/core/error.hpp"

namespace brash {
namespace {

void check(bool worked) {
  if (!worked) throw RunError("OpenSSL cannot compute SHA-256\n  remedy:  check the configuration of OpenSSL");
}

[[noreturn]] void fail_to_hash(const std::string& path, const std::string& reason) {
  throw RunError(path + ": cannot be hashed: " + reason + "\n  remedy:  check that the file is there and may be read");
}

struct Free {
  void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
};

}  // namespace

struct Sha256::State {
  std::unique_ptr<EVP_MD_CTX, Free> context{EVP_MD_CTX_new()};
};

Sha256::Sha256() : state_(std::make_unique<State>()) {
  check(state_->context != nullptr && EVP_DigestInit_ex(state_->context.get(), EVP_sha256(), nullptr) == 1);
}

Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
  check(EVP_DigestUpdate(state_->context.get(), bytes.data(), bytes.size()) == 1);
}

Sha256::Digest Sha256::digest() {
  Digest digest{};
  check(EVP_DigestFinal_ex(state_->context.get(), digest.data(), nullptr) == 1);
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
