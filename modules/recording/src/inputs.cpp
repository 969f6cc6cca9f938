// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/recording/inputs.hpp"

#include <filesystem>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/write_file.hpp"
#include "brash/failure/criterion.hpp"

namespace brash::recording {
namespace {

namespace fs = std::filesystem;

/// The folder of the copies in the folder of a run.
constexpr const char* kFolder = "inputs/";
/// Size of the largest model file, as for all JSON.
constexpr std::size_t kMostMebibytes = 64;

std::string copy_of_model(const model::Case& resolved) {
  return kFolder + ("model/" + fs::path(resolved.failure.file).filename().string());
}

}  // namespace

model::Case Inputs::recorded() const {
  model::Case recorded = resolved;
  if (!recorded.failure.file.empty()) recorded.failure.file = copy_of_model(resolved);
  return recorded;
}

Inputs inputs_of(const std::string& case_file, const std::string& case_text, const model::Case& resolved) {
  Inputs inputs{resolved, {}};
  inputs.files.push_back(
      {case_file, sha256(case_text), case_text.size(), kFolder + fs::path(case_file).filename().string(), case_text});
  const std::string model = failure::model_path(resolved.failure.model, resolved.failure.file);
  if (model.empty()) return inputs;
  std::string bytes = read_text_file(model, "the file of a failure model", kMostMebibytes);
  inputs.files.push_back({model, sha256(bytes), bytes.size()});
  if (!resolved.failure.file.empty()) {
    inputs.files.back().copy = copy_of_model(resolved);
    inputs.files.back().bytes = std::move(bytes);
  }
  return inputs;
}

Inputs read_inputs(const std::string& case_file, const std::vector<std::string>& overrides, io::ModelFile model_file) {
  const std::string text = io::read_case_text(case_file);
  return inputs_of(case_file, text, io::parse_case(text, case_file, overrides, model_file));
}

void expect_unchanged(const Inputs& inputs) {
  for (std::size_t i = 1; i < inputs.files.size(); ++i) {
    const InputFile& file = inputs.files[i];
    if (sha256(read_text_file(file.path, "the file of a failure model", kMostMebibytes)) == file.sha256) continue;
    throw InputError(Complaint{file.path, "has changed while the run was reading it", "one file for the whole run",
                               "run again when nobody writes it"});
  }
}

void write_copies(const Inputs& inputs, const std::string& directory) {
  for (const InputFile& file : inputs.files)
    if (!file.copy.empty()) write_file(directory + "/" + file.copy, file.bytes);
}

}  // namespace brash::recording
