// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_file.hpp"

#include <fstream>

#include "brash/core/input_file.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/version.hpp"
#include "brash/core/write_file.hpp"
#include "brash/meta_model/network.hpp"

namespace brash::meta_model {
namespace {

constexpr const char* kHashKey = "content_sha256";

std::string content_hash(Json model) {
  model.erase(kHashKey);
  return sha256(model.dump());
}

Json parse(const std::string& path) {
  constexpr const char* kAllowed = "a model written by `brash failure train` (JSON)";
  const std::string text = read_json_text(path, kAllowed);
  try {
    return Json::parse(text);
  } catch (const Json::exception& error) {  // syntax, or a number beyond the range of a double
    throw InputError(Complaint{path, fmt::format("is not JSON: {}", error.what()), kAllowed, "copy or write it again"});
  }
}

}  // namespace

Json read_model(const std::string& path, const std::string& format, int version) {
  const Json model = parse(path);
  const Place place(path, model, "");
  place["format"].expect_text(format);
  if (place["format_version"].number() != version) {
    place["format_version"].refuse(
        fmt::format("is {}, this program reads {}", place["format_version"].number(), version));
  }
  const std::string stated = place[kHashKey].text(), found = content_hash(model);
  if (stated != found) {
    place[kHashKey].refuse(fmt::format("is {}, but the content has {}: the file was changed", stated, found));
  }
  return model;
}

std::string write_model(const std::string& path, const std::string& format, int version, Json model, int indentation) {
  model["format"] = format;
  model["format_version"] = version;
  model["program_version"] = kVersion;
  model[kHashKey] = content_hash(model);
  write_file(path, model.dump(indentation) + '\n');
  return model.at(kHashKey).get<std::string>();
}

std::string model_format(const std::string& path) {
  const Json model = parse(path);
  return Place(path, model, "")["format"].text();
}

}  // namespace brash::meta_model
