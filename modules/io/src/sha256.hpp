// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <openssl/evp.h>

#include <memory>
#include <string>
#include <string_view>

namespace brash::io {

/// SHA-256 of bytes that come in pieces.
class Sha256 {
 public:
  /// @throws RunError here and from every member when OpenSSL fails.
  Sha256();
  void add(std::string_view bytes);
  /// The digest of all bytes added, 64 hexadecimal digits; nothing can be added afterwards.
  std::string hexadecimal();

 private:
  struct Free {
    void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
  };
  std::unique_ptr<EVP_MD_CTX, Free> context_;
};

}  // namespace brash::io
