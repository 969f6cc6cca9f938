// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/error.hpp"
#include "brash/failure/edge_responses.hpp"

namespace brash::failure {

EdgeSource::EdgeSource(const std::string& model) {
  if (model != "fem") model_ = EdgeResponseModel::read(model.empty() ? edge_model_path() : model);
}

EdgeSource::Answer EdgeSource::at(const EdgeGeometry& geometry) const {
  if (model_) return {model_->at(model_->clamp(geometry)), model_->check(geometry).inside()};
  auto solved = plate::solve(geometry);
  if (!solved) throw RunError("the moving edge: " + solved.error().what);
  return {std::move(*solved), true};
}

}  // namespace brash::failure
