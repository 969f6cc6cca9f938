// SPDX-License-Identifier: GPL-3.0-or-later
#include "card_files.hpp"

#include <filesystem>

#include "brash/core/write_file.hpp"
#include "brash/training/make_model.hpp"

namespace brash::training {

namespace fs = std::filesystem;

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

std::string card_file(const std::string& model) { return fs::path(model).replace_extension(".md").string(); }

std::string errors_file(const std::string& model) {
  return fs::path(model).replace_extension("").string() + "_errors.csv";
}

std::string write_card(const std::string& model, const ModelCard& card) {
  if (!card.errors.empty()) write_file(errors_file(model), card.errors);
  write_file(card_file(model), card.text);
  return card_file(model);
}

}  // namespace brash::training
