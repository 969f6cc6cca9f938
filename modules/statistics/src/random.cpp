// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/random.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_rng.h>

#include <array>
#include <cmath>
#include <string>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/core/sha256.hpp"
#include "gsl_checked.hpp"

namespace brash::statistics {
namespace {

constexpr std::size_t kGenerators = 3;
using Generator = GslOwner<gsl_rng, gsl_rng_free>;

void append(std::string& bytes, std::uint64_t value) {
  for (int shift = 0; shift < 64; shift += 8) bytes.push_back(static_cast<char>((value >> shift) & 0xff));
}

/// Lengths go in front of the texts, so that no two keys are written alike.
void append(std::string& bytes, std::string_view text) {
  append(bytes, static_cast<std::uint64_t>(text.size()));
  bytes += text;
}

Generator seeded(const Sha256::Digest& digest, std::size_t which) {
  // ranlxd2 uses the lower 31 bits of its seed and takes 0 for 1.
  unsigned long seed = 0;
  for (std::size_t i = 0; i < 4; ++i) seed = (seed << 8) | digest[4 * which + i];
  Generator generator(gsl_rng_alloc(gsl_rng_ranlxd2));
  if (!generator) throw RunError("random stream: out of memory");
  gsl_rng_set(generator.get(), seed & 0x7fffffffUL);
  return generator;
}

}  // namespace

struct RandomStream::Impl {
  std::array<Generator, kGenerators> generators;
};

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t replicate, std::string_view purpose, std::uint64_t counter)
    : RandomStream(seed, "cone", replicate, purpose, counter) {
}  // runs of experiments/validation/cone.toml keep their draws

RandomStream::RandomStream(std::uint64_t seed, std::string_view user, std::uint64_t replicate, std::string_view purpose,
                           std::uint64_t counter)
    : impl_(std::make_unique<Impl>()) {
  quiet_gsl();
  std::string key;
  append(key, seed);
  append(key, user);
  append(key, replicate);
  append(key, purpose);
  append(key, counter);
  Sha256 hash;
  hash.add(key);
  const Sha256::Digest digest = hash.digest();
  for (std::size_t i = 0; i < kGenerators; ++i) impl_->generators[i] = seeded(digest, i);
}

RandomStream::RandomStream(RandomStream&&) noexcept = default;
RandomStream& RandomStream::operator=(RandomStream&&) noexcept = default;
RandomStream::~RandomStream() = default;

double RandomStream::uniform() {
  // Multiples of 2^-48 below 3: the sum is exact, and its fraction is uniform when one term is.
  double sum = 0.0;
  for (const Generator& generator : impl_->generators) sum += gsl_rng_uniform(generator.get());
  return sum - std::floor(sum);
}

int RandomStream::uniform_int(int from, int to) {
  BRASH_EXPECTS(from <= to, from, to);
  const double n = static_cast<double>(to) - static_cast<double>(from) + 1.0;
  // n / 2^48 bounds the unevenness: 1e-14 for n = 3, 2e-5 for the whole range of int.
  return static_cast<int>(static_cast<double>(from) + std::floor(n * uniform()));
}

double RandomStream::normal() {
  // Half a grid step keeps the argument off 0 and 1.
  return gsl_cdf_ugaussian_Pinv(uniform() + 0x1p-49);
}

}  // namespace brash::statistics
