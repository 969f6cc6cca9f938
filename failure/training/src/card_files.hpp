// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace brash::training {

/// The name of a file without its folders.
std::string file_name(const std::string& path);

/// A model card and the errors that it summarises.
struct ModelCard {
  std::string text;    ///< Markdown
  std::string errors;  ///< CSV, or empty
};

/// Writes card and errors beside the model `model`; the card's path.
std::string write_card(const std::string& model, const ModelCard& card);

}  // namespace brash::training
