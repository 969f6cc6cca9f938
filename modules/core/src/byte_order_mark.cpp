// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/byte_order_mark.hpp"

#include <cstddef>
#include <cstdint>

namespace brash {
namespace {

void append(std::string& text, std::uint32_t code) {
  const auto add = [&](std::uint32_t lead, int shift) { text += static_cast<char>(lead | (code >> shift)); };
  const auto follow = [&](int shift) { text += static_cast<char>(0x80U | ((code >> shift) & 0x3fU)); };
  if (code < 0x80U) return add(0, 0);
  if (code < 0x800U) {
    add(0xc0U, 6);
  } else if (code < 0x10000U) {
    add(0xe0U, 12);
    follow(6);
  } else {
    add(0xf0U, 18);
    follow(12);
    follow(6);
  }
  follow(0);
}

}  // namespace

std::string in_utf8(std::string bytes) {
  if (!is_utf16(bytes)) {
    bytes.erase(0, bytes.size() - without_byte_order_mark(bytes).size());
    return bytes;
  }
  const std::size_t high = bytes.front() == '\xfe' ? 0 : 1;  // byte of a unit
  const auto unit = [&](std::size_t at) {
    const auto byte = [&](std::size_t i) {
      return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i]));
    };
    return byte(high) << 8U | byte(1 - high);
  };
  std::string text;
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    std::uint32_t code = unit(i);
    const bool is_half = (code & 0xf800U) == 0xd800U;
    const bool has_other = code < 0xdc00U && i + 3 < bytes.size() && (unit(i + 2) & 0xfc00U) == 0xdc00U;
    if (is_half && has_other) {
      code = 0x10000U + ((code - 0xd800U) << 10U) + (unit(i + 2) - 0xdc00U);
      i += 2;
    } else if (is_half) {
      code = 0xfffdU;
    }
    append(text, code);
  }
  return text;
}

}  // namespace brash
