// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gnu/libc-version.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/core/own_path.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/version.hpp"
#include "brash/io/case.hpp"
#include "brash/io/results.hpp"

namespace brash::io {
namespace {

using Json = nlohmann::ordered_json;

/// The first line `model name : ...` of /proc/cpuinfo, or "unknown".
std::string cpu_name() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("model name") && line.find(": ") != std::string::npos) return line.substr(line.find(": ") + 2);
  return "unknown";
}

Json described(const std::filesystem::path& file, const std::string& name) {
  const std::string digest = sha256_of_file(file.string());
  return {{"path", name}, {"bytes", std::filesystem::file_size(file)}, {"sha256", digest}};
}

}  // namespace

std::string sha256_of_program() {
  const std::filesystem::path path = own_path();
  // The link still leads to the running program after a new one has taken its name.
  constexpr const char* kLink = "/proc/self/exe";
  std::error_code ignored;
  return sha256_of_file(std::filesystem::read_symlink(kLink, ignored) == path ? kLink : path.string());
}

void write_manifest(const std::string& directory, const model::Case& resolved, const std::vector<HashedFile>& inputs,
                    const std::vector<std::string>& outputs, const Volatile& context) {
  const std::filesystem::path folder(directory);
  Json manifest;
  manifest["format"] = "brash-manifest-1";
  manifest["program"] = {{"name", "brash"},
                         {"file", own_path().filename().string()},
                         {"version", kVersion},
                         {"commit", kCommit},
                         {"sha256", sha256_of_program()}};
  for (const ToolVersion& tool : kBuiltWith) manifest["built_with"][tool.name] = tool.version;
  manifest["glibc"] = gnu_get_libc_version();
  manifest["case"] = {{"name", resolved.name}, {"toml", to_toml(resolved)}};
  manifest["seeds"] = {{"seed", resolved.random.seed}, {"replicate", resolved.random.replicate}};
  manifest["inputs"] = Json::array();
  for (const HashedFile& input : inputs) {
    manifest["inputs"].push_back({{"path", input.path}, {"bytes", input.n_bytes}, {"sha256", input.sha256}});
    if (!input.copy.empty()) manifest["inputs"].back()["copy"] = input.copy;
  }
  manifest["outputs"] = Json::array();
  for (const std::string& output : outputs) manifest["outputs"].push_back(described(folder / output, output));
  manifest["volatile"] = {{"started_at", context.started_at},
                          {"wall_seconds", context.wall_seconds},
                          {"stage_seconds", context.stage_seconds},
                          {"threads", context.threads},
                          {"host_cpu", context.host_cpu.empty() ? cpu_name() : context.host_cpu}};
  write_file((folder / "manifest.json").string(), manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace brash::io
