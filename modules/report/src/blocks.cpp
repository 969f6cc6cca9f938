// SPDX-License-Identifier: GPL-3.0-or-later
#include "blocks.hpp"

#include <zlib.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "brash/core/contract.hpp"

namespace brash::report {
namespace {

static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");

std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

}  // namespace

template <typename T>
void Blocks::append(const std::string& name, const char* kind, const std::vector<T>& values, double unit) {
  directory_.push_back({{"name", prefix_ + name}, {"kind", kind}, {"count", values.size()}, {"unit", unit}});
  const std::size_t start = bytes_.size();
  bytes_.resize(start + values.size() * sizeof(T));
  for (std::size_t i = 0; i < values.size(); ++i) {
    char number[sizeof(T)];
    std::memcpy(number, &values[i], sizeof(T));
    for (std::size_t plane = 0; plane < sizeof(T); ++plane) bytes_[start + plane * values.size() + i] = number[plane];
  }
}

std::int32_t rounded_to(double unit, double value) {
  const double whole = std::round(value / unit);
  BRASH_EXPECTS(std::abs(whole) <= std::numeric_limits<std::int32_t>::max(), value, unit);
  return static_cast<std::int32_t>(whole);
}

void Blocks::add(const std::string& name, const std::vector<double>& values) { append(name, "f64", values, 1.0); }

void Blocks::add_single(const std::string& name, const std::vector<double>& values) {
  append(name, "f32", std::vector<float>(values.begin(), values.end()), 1.0);
}

void Blocks::add(const std::string& name, const std::vector<std::int32_t>& values, double unit) {
  std::vector<std::uint32_t> coded;
  coded.reserve(values.size());
  std::uint32_t before = 0;
  for (const std::int32_t value : values) {
    // Differences wrap around, so that any two numbers have one.
    const std::uint32_t difference = static_cast<std::uint32_t>(value) - before;
    coded.push_back(difference << 1U ^ (difference >> 31U != 0 ? ~0U : 0U));
    before = static_cast<std::uint32_t>(value);
  }
  append(name, "i32", coded, unit);
}

void Blocks::add_rounded(const std::string& name, const std::vector<double>& values, double unit) {
  std::vector<std::int32_t> rounded;
  rounded.reserve(values.size());
  for (const double value : values) rounded.push_back(rounded_to(unit, value));
  add(name, rounded, unit);
}

std::string Blocks::packed() const {
  // The best level makes a page 2 % smaller and takes six times as long.
  uLongf size = compressBound(bytes_.size());
  std::string deflated(size, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(deflated.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes_.data()), bytes_.size(), Z_BEST_SPEED);
  BRASH_EXPECTS(status == Z_OK, status);
  deflated.resize(size);
  return base64(deflated);
}

}  // namespace brash::report
