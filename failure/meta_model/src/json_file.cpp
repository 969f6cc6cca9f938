// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_file.hpp"

#include <fstream>
#include <sstream>

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
  std::ifstream stream(path);
  std::stringstream text;
  if (!stream || !(text << stream.rdbuf())) {
    throw InputError(fmt::format("{}: cannot be read; give a model file written by `brash failure train`", path));
  }
  try {
    return Json::parse(text.str());
  } catch (const Json::parse_error& error) {
    throw InputError(fmt::format("{}: byte {}: is not JSON ({}); give a model file written by `brash failure train`",
                                 path, error.byte, error.what()));
  } catch (const Json::out_of_range& error) {
    throw InputError(
        fmt::format("{}: a number is beyond all that a computer has ({}); write the model again with `brash "
                    "failure train`, or copy it again",
                    path, error.what()));
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
