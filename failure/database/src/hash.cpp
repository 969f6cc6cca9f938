// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <sstream>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "store.hpp"

namespace brash::database {

std::string sha256(const std::string& text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned int size = 0;
  const int ok = EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_sha256(), nullptr);
  BRASH_EXPECTS(ok == 1, ok);
  std::string hex;
  for (unsigned int i = 0; i < size; ++i) hex += fmt::format("{:02x}", digest[i]);
  return hex;
}

std::string file_sha256(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream bytes;
  if (!stream || !(bytes << stream.rdbuf())) {
    throw InputError(fmt::format("{}: cannot be read; give a file that exists and is not empty", path));
  }
  return sha256(bytes.str());
}

}  // namespace brash::database
