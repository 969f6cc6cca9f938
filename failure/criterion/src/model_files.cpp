// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/failure/model_files.hpp"

#include <cstdlib>
#include <filesystem>
#include <mutex>

#include "brash/core/own_path.hpp"
#include "brash/failure/criterion.hpp"
#include "brash/failure/edge_responses.hpp"
#include "criteria.hpp"

namespace brash::failure {

using model::FailureModel;

namespace {

namespace fs = std::filesystem;

constexpr const char* kModelPathVariable = "BRASH_MODEL_PATH";

/// Where the models that come with the program are: with the sources for a program in the build tree, else in
/// share/brash/models of the installation.
fs::path shipped_models() {
  const fs::path program = own_path();
  const bool in_build_tree = program.lexically_relative(BRASH_BUILD_DIR).string().rfind("..", 0) != 0;
  for (fs::path folder = program.parent_path(); !in_build_tree && folder.has_relative_path();
       folder = folder.parent_path()) {
    if (std::error_code ignored; fs::is_directory(folder / "share/brash/models", ignored))
      return folder / "share/brash/models";
  }
  return BRASH_MODEL_DIR;
}

/// The folder of use_models_in(), for all threads.
struct CarriedModels {
  std::mutex mutex;
  fs::path folder;
};
CarriedModels& carried_models() {
  static CarriedModels models;
  return models;
}

fs::path model_folder() {
  {
    const std::lock_guard lock(carried_models().mutex);
    if (!carried_models().folder.empty()) return carried_models().folder;
  }
  const char* const named = std::getenv(kModelPathVariable);
  return named != nullptr && *named != '\0' ? named : shipped_models();
}

}  // namespace

std::string shipped(const std::string& name) { return (model_folder() / ("cone_" + name + ".json")).string(); }

std::string edge_model_path() { return shipped("edge"); }

std::string model_path(FailureModel model, const std::string& file) {
  if (!model::options_of(model, !file.empty()).file) return "";
  if (!file.empty()) return file;
  return shipped(std::string(name_of(model)));
}

std::vector<std::string> model_files(const model::FailureSection& failure) {
  std::vector<std::string> files;
  const std::string own = model_path(failure.model, failure.file);
  if (!own.empty()) files.push_back(own);
  if (failure.model == FailureModel::kSuperposition && failure.order == model::CrackOrder::kRadialFirst)
    files.push_back(shipped("superposition_split"));
  if (failure.model == FailureModel::kPlate || failure.model == FailureModel::kPlateOutline)
    files.push_back(shipped("superposition"));
  if (failure.edge == model::EdgeMotion::kDynamic) files.push_back(edge_model_path());
  return files;
}

void use_models_in(const std::string& folder) {
  const std::lock_guard lock(carried_models().mutex);
  carried_models().folder = folder;
}

}  // namespace brash::failure
