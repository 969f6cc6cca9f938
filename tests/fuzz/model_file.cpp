// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: any bytes are a model that answers, or an InputError. The hash of the content, which stops all but a few
// of them at the door, is also set right.
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "brash/core/error.hpp"
#include "brash/core/sha256.hpp"
#include "brash/meta_model/network.hpp"
#include "brash/meta_model/profile_model.hpp"
#include "scratch_file.hpp"

namespace {

template <typename Model>
void read(const std::string& path) {
  try {
    (void)Model::read(path);
  } catch (const brash::InputError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFile file(".json");
  const std::string& path = file.with(text_of(data, size));
  read<brash::meta_model::Network>(path);
  read<brash::meta_model::ProfileModel>(path);

  nlohmann::json model = nlohmann::json::parse(text_of(data, size), nullptr, /*allow_exceptions=*/false);
  if (!model.is_object()) return 0;
  model.erase("content_sha256");
  model["content_sha256"] = brash::sha256(model.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  file.with(model.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  read<brash::meta_model::Network>(path);
  read<brash::meta_model::ProfileModel>(path);
  return 0;
}
