// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace brash::report {

/// The page without its data, as the viewer's build made it; empty in a build without Node.js.
extern const std::string_view kPage;

/// The page with `data` in it. Nothing in `data`, whatever its texts say, can end the element that holds it.
/// @param packed  base64 text.
/// @throws RunError in a build without a page.
std::string page_with(const nlohmann::ordered_json& data, const std::string& packed);

/// The same for a page that a server shows: it may ask that server, and nobody else.
std::string live_page_with(const nlohmann::ordered_json& data, const std::string& packed);

/// The JSON file `path`.
/// @throws InputError naming the file and its fault.
nlohmann::ordered_json read_json(const std::string& path);

}  // namespace brash::report
