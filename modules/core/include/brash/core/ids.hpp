// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>

namespace brash {

/// Name of a thing that may be replaced: `index` is the slot, `generation` distinguishes its occupants.
template <typename Tag>
struct Id {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;

  friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

using BodyId = Id<struct BodyTag>;

}  // namespace brash
