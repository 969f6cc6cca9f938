// SPDX-License-Identifier: GPL-3.0-or-later
#include "sha256.hpp"

#include <fmt/format.h>

#include <array>

#include "brash/core/error.hpp"

namespace brash::io {
namespace {

void check(bool worked) {
  if (!worked) throw RunError("OpenSSL cannot compute SHA-256\n  remedy:  check the configuration of OpenSSL");
}

}  // namespace

Sha256::Sha256() : context_(EVP_MD_CTX_new()) {
  check(context_ != nullptr && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
}

void Sha256::add(std::string_view bytes) { check(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) == 1); }

std::string Sha256::hexadecimal() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int n_bytes = 0;
  check(EVP_DigestFinal_ex(context_.get(), digest.data(), &n_bytes) == 1);
  std::string text;
  for (unsigned int i = 0; i < n_bytes; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

}  // namespace brash::io
