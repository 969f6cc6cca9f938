// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <openssl/evp.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "brash/core/error.hpp"
#include "brash/core/version.hpp"
#include "brash/io/results.hpp"

namespace brash::io {
namespace {

using Json = nlohmann::ordered_json;

struct FreeDigest {
  void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
};

[[noreturn]] void fail_to_hash(const std::string& path, const std::string& reason) {
  throw RunError(
      fmt::format("{}: cannot be hashed: {}\n  remedy:  check that the file is there and may be read", path, reason));
}

/// The first line `model name : ...` of /proc/cpuinfo, or "unknown".
std::string cpu_name() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("model name") && line.find(": ") != std::string::npos) return line.substr(line.find(": ") + 2);
  return "unknown";
}

Json described(const std::filesystem::path& file, const std::string& name) {
  std::error_code reason;
  const std::uintmax_t n_bytes = std::filesystem::file_size(file, reason);
  if (reason) fail_to_hash(file.string(), reason.message());
  return {{"path", name}, {"bytes", n_bytes}, {"sha256", sha256_of_file(file.string())}};
}

}  // namespace

std::string sha256_of_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail_to_hash(path, std::generic_category().message(errno));
  const std::unique_ptr<EVP_MD_CTX, FreeDigest> context(EVP_MD_CTX_new());
  if (!context || EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) != 1)
    fail_to_hash(path, "OpenSSL has no SHA-256");
  std::vector<char> block(1 << 16);
  do {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    if (EVP_DigestUpdate(context.get(), block.data(), static_cast<std::size_t>(stream.gcount())) != 1)
      fail_to_hash(path, "OpenSSL failed");
  } while (stream);
  if (stream.bad()) fail_to_hash(path, "it cannot be read");

  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int n_bytes = 0;
  if (EVP_DigestFinal_ex(context.get(), digest.data(), &n_bytes) != 1) fail_to_hash(path, "OpenSSL failed");
  std::string text;
  for (unsigned int i = 0; i < n_bytes; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

void write_manifest(const std::string& directory, const Case& resolved, const std::vector<std::string>& inputs,
                    const std::vector<std::string>& outputs, const Volatile& context) {
  const std::filesystem::path folder(directory);
  Json manifest;
  manifest["format"] = "brash-manifest-1";
  manifest["program"] = {{"name", "brash"}, {"version", kVersion}};
  for (const ToolVersion& tool : kBuiltWith) manifest["built_with"][tool.name] = tool.version;
  manifest["glibc"] = gnu_get_libc_version();
  manifest["case"] = {{"name", resolved.name}, {"toml", to_toml(resolved)}};
  manifest["seeds"] = {{"seed", resolved.random.seed}, {"replicate", resolved.random.replicate}};
  manifest["inputs"] = Json::array();
  for (const std::string& input : inputs) manifest["inputs"].push_back(described(input, input));
  manifest["outputs"] = Json::array();
  for (const std::string& output : outputs) manifest["outputs"].push_back(described(folder / output, output));
  manifest["volatile"] = {{"started_at", context.started_at},
                          {"wall_seconds", context.wall_seconds},
                          {"stage_seconds", context.stage_seconds},
                          {"host_cpu", context.host_cpu.empty() ? cpu_name() : context.host_cpu}};
  write_file((folder / "manifest.json").string(), manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace brash::io
