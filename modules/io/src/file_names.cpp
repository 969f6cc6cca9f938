// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/io/file_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"

namespace brash::io {
namespace {

/// The names of the outputs that a manifest lists; none in a file of another kind.
std::vector<std::string> outputs_in(const std::string& manifest) {
  std::vector<std::string> names;
  const auto json = nlohmann::json::parse(read_json_text(manifest, "the manifest of a run"), nullptr, false);
  if (!json.is_object() || !json.contains("outputs") || !json["outputs"].is_array()) return names;
  for (const nlohmann::json& output : json["outputs"])
    if (output.is_object() && output.contains("path") && output["path"].is_string())
      names.push_back(output["path"].get<std::string>());
  return names;
}

}  // namespace

void check_ending(const std::string& file, std::string_view kind, std::initializer_list<std::string_view> endings) {
  const auto has = [&](std::string_view ending) { return file.ends_with(ending); };
  if (file.empty() || std::ranges::any_of(endings, has)) return;
  throw InputError(Complaint{file, fmt::format("is not a name of {}", kind),
                             fmt::format("a name that ends in {}", fmt::join(endings, " or ")), "change the name"});
}

void refuse_replacing_results(const std::string& output) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path folder = fs::path(output).parent_path(), manifest = folder / "manifest.json";
  if (output.empty() || !fs::is_regular_file(manifest, ignored)) return;
  std::vector<std::string> results = outputs_in(manifest.string());
  results.emplace_back("manifest.json");
  for (const std::string& result : results)
    if (fs::equivalent(output, folder / result, ignored))
      throw InputError(Complaint{output, "would be written over a result that manifest.json beside it lists",
                                 "a file that is not a result of a run or a campaign",
                                 "give another name for what is written"});
}

std::string file_in(const std::string& given, std::initializer_list<std::string_view> names) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::is_directory(given, ignored)) return given;
  for (const std::string_view name : names)
    if (const fs::path file = fs::path(given) / name; fs::exists(file, ignored)) return file.string();
  throw InputError(Complaint{given, fmt::format("is a folder without {}", fmt::join(names, " or ")),
                             "the folder of a run, or the file", "give the folder that `brash run` wrote"});
}

std::string folder_of(const std::string& given) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::is_regular_file(given, ignored)) return given;
  const fs::path folder = fs::path(given).parent_path();
  return folder.empty() ? "." : folder.string();
}

void refuse_missing_folder(const std::string& path) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(fs::absolute(path).parent_path()))
    throw InputError(Complaint{path, "is in no folder", "a file in a folder that exists", "make the folder first"});
}

void refuse_equal_names(const std::vector<std::string>& outputs) {
  namespace fs = std::filesystem;
  std::set<fs::path> places;
  for (const std::string& output : outputs) {
    if (output.empty()) continue;
    std::error_code failed;
    const fs::path place = fs::weakly_canonical(fs::absolute(output), failed);
    if (!places.insert(failed ? fs::path(output) : place).second)
      throw InputError(Complaint{output, "is the name of two files to write", "a name for each", "change one of them"});
  }
}

}  // namespace brash::io
