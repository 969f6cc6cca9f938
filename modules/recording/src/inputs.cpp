// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/recording/inputs.hpp"

#include <filesystem>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/write_file.hpp"
#include "brash/failure/model_files.hpp"
#include "brash/model/case_keys.hpp"

namespace brash::recording {
namespace {

namespace fs = std::filesystem;

/// The folder of the copies in the folder of a run.
constexpr const char* kFolder = "inputs/";
/// Sizes of the largest inputs.
constexpr std::size_t kMostMebibytesOfModel = 64, kMostMebibytesOfMesh = 512;

/// The name of the copy of an input in the folder of a run.
std::string copy_of(const char* what, const std::string& file) {
  return kFolder + (what + ("/" + fs::path(file).filename().string()));
}

/// The folder of the copy of a file of [field].
const char* folder_of(const char* key) { return key == std::string_view("file") ? "field" : key; }

/// All failure models behind a case. Those that come with the program are hashed and not copied.
void add_models(const model::Case& resolved, std::vector<InputFile>& files) {
  for (const std::string& model : failure::model_files(resolved.failure)) {
    std::string bytes = read_text_file(model, "the file of a failure model", kMostMebibytesOfModel);
    files.push_back({model, sha256(bytes), bytes.size()});
    if (model != resolved.failure.file) continue;
    files.back().copy = copy_of("model", model);
    files.back().bytes = std::move(bytes);
  }
}

/// A file that the case names, with its copy in the run's folder.
void add_file(const char* what, const char* kind, const std::string& path, std::vector<InputFile>& files) {
  std::string bytes = read_text_file(path, kind, kMostMebibytesOfMesh);
  files.push_back({path, sha256(bytes), bytes.size(), copy_of(what, path)});
  files.back().bytes = std::move(bytes);
}

}  // namespace

model::Case Inputs::recorded() const {
  model::Case recorded = resolved;
  visit_own_files(recorded, [](const std::string& folder, std::string& file) {
    file = folder + fs::path(file).filename().string();
  });
  return recorded;
}

void visit_own_files(model::Case& resolved,
                     const std::function<void(const std::string& folder, std::string& file)>& visit) {
  const auto visit_named = [&](const char* what, std::string& file) {
    if (!file.empty()) visit(std::string(kFolder) + what + "/", file);
  };
  visit_named("model", resolved.failure.file);
  if (auto* const mesh = std::get_if<model::Mesh>(&resolved.structure.shape)) visit_named("hull", mesh->file);
  model::visit_files_of_field(resolved.field,
                              [&](const char* key, std::string& file) { visit_named(folder_of(key), file); });
}

Inputs inputs_of(const std::string& case_file, const std::string& case_text, const model::Case& resolved) {
  Inputs inputs{resolved, {}};
  inputs.files.push_back(
      {case_file, sha256(case_text), case_text.size(), kFolder + fs::path(case_file).filename().string(), case_text});
  add_models(resolved, inputs.files);
  if (const auto* const mesh = std::get_if<model::Mesh>(&resolved.structure.shape))
    add_file("hull", "a mesh", mesh->file, inputs.files);
  model::visit_files_of_field(resolved.field, [&](const char* key, const std::string& file) {
    if (!file.empty()) add_file(folder_of(key), "a file of the ice", file, inputs.files);
  });
  return inputs;
}

Inputs read_inputs(const std::string& case_file, const std::vector<std::string>& overrides, io::ModelFile model_file) {
  const std::string text = io::read_case_text(case_file);
  return inputs_of(case_file, text, io::parse_case(text, case_file, overrides, model_file));
}

void expect_unchanged(const Inputs& inputs) {
  for (std::size_t i = 1; i < inputs.files.size(); ++i) {
    const InputFile& file = inputs.files[i];
    if (sha256(read_text_file(file.path, "an input", kMostMebibytesOfMesh)) == file.sha256) continue;
    throw InputError(Complaint{file.path, "has changed while the run was reading it", "one file for the whole run",
                               "run again when nobody writes it"});
  }
}

void write_copies(const Inputs& inputs, const std::string& directory) {
  for (const InputFile& file : inputs.files)
    if (!file.copy.empty()) write_file(directory + "/" + file.copy, file.bytes);
}

}  // namespace brash::recording
