// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "brash/core/sha256.hpp"
#include "brash/core/version.hpp"
#include "brash/core/write_file.hpp"
#include "collect.hpp"
#include "folder.hpp"

namespace brash::campaign {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// Paths of the files that the crate lists, relative to the folder, in an order that does not depend on the file
/// system.
std::vector<std::string> listed(const fs::path& folder) {
  std::vector<std::string> settings;
  std::vector<std::string> cases;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder / "settings", ignored))
    if (entry.path().extension() == ".toml") settings.push_back("settings/" + entry.path().filename().string());
  for (const auto& entry : fs::directory_iterator(folder / "cases", ignored))
    if (entry.path().extension() != ".part" && fs::exists(entry.path() / "manifest.json"))
      cases.push_back("cases/" + entry.path().filename().string() + "/manifest.json");
  std::ranges::sort(settings);
  std::ranges::sort(cases);
  std::vector<std::string> all{"campaign.csv", "campaign.nc", "summary.json", "manifest.json"};
  all.insert(all.end(), settings.begin(), settings.end());
  all.insert(all.end(), cases.begin(), cases.end());
  return all;
}

std::string media_type(const fs::path& path) {
  if (path.extension() == ".csv") return "text/csv";
  if (path.extension() == ".nc") return "application/x-netcdf";
  return path.extension() == ".toml" ? "application/toml" : "application/json";
}

Json file_entity(const fs::path& folder, const std::string& path) {
  return {{"@id", path},
          {"@type", "File"},
          {"encodingFormat", media_type(path)},
          {"contentSize", std::to_string(fs::file_size(folder / path))},
          {"sha256", sha256_of_file((folder / path).string())}};
}

Json parsed(const fs::path& path) { return Json::parse(read_text(path), nullptr, /*allow_exceptions=*/false); }

/// When the newest case was started; the campaign's own manifest holds no time.
std::string newest_start(const fs::path& folder, const std::vector<std::string>& paths) {
  std::string newest;
  for (const std::string& path : paths) {
    const Json manifest = parsed(folder / path);
    const Json::json_pointer at("/volatile/started_at");
    if (manifest.contains(at) && manifest[at].is_string()) newest = std::max(newest, manifest[at].get<std::string>());
  }
  return newest;
}

/// The entities of an earlier description.
Json earlier_entities(const fs::path& crate) {
  const Json earlier = parsed(crate);
  if (!earlier.is_object() || !earlier.contains("@graph") || !earlier["@graph"].is_array()) return Json::array();
  return earlier["@graph"];
}

/// The id of an entity, or that a reference leads to; nothing where there is none.
Json id_of(const Json& entity) { return entity.is_object() ? entity.value("@id", Json()) : Json(); }

/// Takes over the user's statements about the whole: who made the results, and under which licence they are given.
void keep_users_words(const Json& earlier, Json& root) {
  for (const Json& entity : earlier) {
    if (id_of(entity) != "./") continue;
    for (const char* const key : {"license", "author"})
      if (entity.contains(key)) root[key] = entity[key];
  }
}

/// Adds the earlier entities to which `value` leads, and those to which they lead, unless `graph` has them.
void keep_referred(const Json& earlier, const Json& value, Json& graph) {
  if (!value.is_structured()) return;
  for (const Json& part : value) keep_referred(earlier, part, graph);
  const auto is_it = [id = id_of(value)](const Json& entity) { return !id.is_null() && id_of(entity) == id; };
  const auto found = std::ranges::find_if(earlier, is_it);
  if (found == earlier.end() || std::ranges::any_of(graph, is_it)) return;
  graph.push_back(*found);
  keep_referred(earlier, *found, graph);
}

}  // namespace

void write_crate(const std::string& directory) {
  const fs::path folder(directory);
  const std::vector<std::string> paths = listed(folder);
  Json parts = Json::array();
  Json files = Json::array();
  for (const std::string& path : paths) {
    parts.push_back({{"@id", path}});
    files.push_back(file_entity(folder, path));
  }
  Json root{{"@id", "./"},
            {"@type", "Dataset"},
            {"name", "brash campaign " + fs::absolute(folder).lexically_normal().filename().string()},
            {"description", "Simulations of a structure that breaks ice, over a grid of settings with replicates."},
            {"datePublished", newest_start(folder, paths)},
            {"hasPart", parts},
            {"mentions", {{"@id", "#campaign"}}}};
  const Json earlier = earlier_entities(folder / kCrateFile);
  keep_users_words(earlier, root);
  Json graph{{{"@id", kCrateFile},
              {"@type", "CreativeWork"},
              {"conformsTo", {{"@id", "https://w3id.org/ro/crate/1.1"}}},
              {"about", {{"@id", "./"}}}},
             root,
             {{"@id", "#brash"}, {"@type", "SoftwareApplication"}, {"name", "brash"}, {"version", kVersion}},
             {{"@id", "#campaign"},
              {"@type", "CreateAction"},
              {"name", "brash campaign"},
              {"instrument", {{"@id", "#brash"}}},
              {"result", parts}}};
  graph.insert(graph.end(), files.begin(), files.end());
  for (const char* const key : {"license", "author"}) keep_referred(earlier, root.value(key, Json()), graph);
  // SHA-256 is not in the context of version 1.1.
  const Json crate{{"@context", {"https://w3id.org/ro/crate/1.1/context", {{"sha256", "https://schema.org/sha256"}}}},
                   {"@graph", graph}};
  write_file((folder / kCrateFile).string(), crate.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace brash::campaign
