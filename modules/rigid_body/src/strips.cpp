// SPDX-License-Identifier: GPL-3.0-or-later
#include "strips.hpp"

#include <algorithm>
#include <numeric>

namespace brash::rigid_body {
namespace {

/// Bodies in a strip, at least: some microseconds of work for a sweep. Fewer cost more in starts of loops.
constexpr std::uint32_t kLeastBodies = 16;
/// Contacts of bodies farther apart in the order than this, and than this share of all bodies, are left for the end.
constexpr std::uint32_t kFar = 64;
constexpr std::uint32_t kFarShare = 8;

/// Its place in the order, if one body alone is moved.
Ends sorted(Ends ends) {
  if (ends.first == 0 || ends.second == 0)
    return {std::max(ends.first, ends.second), std::max(ends.first, ends.second)};
  return {std::min(ends.first, ends.second), std::max(ends.first, ends.second)};
}

}  // namespace

/// Each strip ends behind the farthest body that the strip before touches.
void Strips::divide(std::size_t n_bodies) {
  strip_of_.resize(n_bodies + 1);
  n_strips_ = 0;
  std::uint32_t least = 0;
  for (std::uint32_t body = 1; body <= n_bodies; ++n_strips_) {
    const auto end = std::min(static_cast<std::uint32_t>(n_bodies), std::max(body + kLeastBodies - 1, least));
    for (; body <= end; ++body) {
      strip_of_[body] = n_strips_;
      least = std::max(least, farthest_[body]);
    }
  }
}

void Strips::lay(std::span<const Ends> contacts, std::size_t n_bodies) {
  const std::uint32_t far = std::max(kFar, static_cast<std::uint32_t>(n_bodies) / kFarShare);
  const auto is_left = [&](Ends ends) { return ends.first == 0 || ends.second - ends.first > far; };
  farthest_.assign(n_bodies + 1, 0);
  for (const Ends& contact : contacts)
    if (const Ends ends = sorted(contact); !is_left(ends))
      farthest_[ends.first] = std::max(farthest_[ends.first], ends.second);
  divide(n_bodies);

  of_contact_.resize(contacts.size());
  begins_.assign(n_strips_ + 2, 0);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Ends ends = sorted(contacts[i]);
    of_contact_[i] = is_left(ends) ? n_strips_ : strip_of_[ends.first];
    ++begins_[of_contact_[i] + 1];
  }
  std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
  contacts_.resize(contacts.size());
  std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
  for (std::size_t i = 0; i < contacts.size(); ++i) contacts_[next[of_contact_[i]]++] = static_cast<std::uint32_t>(i);
}

}  // namespace brash::rigid_body
