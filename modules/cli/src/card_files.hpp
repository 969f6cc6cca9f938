// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace brash::cli {

/// The name of a file without its folders.
std::string file_name(const std::string& path);

/// The model card (Markdown) beside the model's file.
std::string card_file(const std::string& model);
/// The errors by range (CSV) beside the model's file.
std::string errors_file(const std::string& model);

/// A model card and the errors that it summarises.
struct ModelCard {
  std::string text;    ///< Markdown
  std::string errors;  ///< CSV, or empty
};

/// Writes card and errors beside the model `model`; the card's path.
std::string write_card(const std::string& model, const ModelCard& card);

/// The command `brash failure train ...` as the user gave it, without the folders of its files.
std::string command_line(const CLI::App& command);

}  // namespace brash::cli
