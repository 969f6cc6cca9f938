// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_name.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "brash/core/error.hpp"

namespace brash::cli {

void check_ending(const std::string& file, std::string_view kind, std::initializer_list<std::string_view> endings) {
  const auto has = [&](std::string_view ending) { return file.ends_with(ending); };
  if (file.empty() || std::ranges::any_of(endings, has)) return;
  throw InputError(Complaint{file, fmt::format("is no name of {}", kind),
                             fmt::format("a name that ends in {}", fmt::join(endings, " or ")), "change the name"});
}

}  // namespace brash::cli
