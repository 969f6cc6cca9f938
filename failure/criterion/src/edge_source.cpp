// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "brash/core/error.hpp"
#include "brash/failure/edge_responses.hpp"

namespace brash::failure {

namespace {

/// The responses to a load of `factor` per unit of the line load.
void scale(EdgeResponses& r, double factor) {
  for (std::vector<double>* series :
       {&r.deflection, &r.edge_moment, &r.axis_moment, &r.static_axis_moment, &r.axis_normal})
    for (double& value : *series) value *= factor;
  r.static_deflection *= factor;
  r.static_edge_moment *= factor;
  r.edge_normal *= factor;
}

}  // namespace

EdgeSource::EdgeSource(const std::string& model) {
  if (model != "fem") model_ = EdgeResponseModel::read(model.empty() ? edge_model_path() : model);
}

EdgeSource::Answer EdgeSource::at(const EdgeGeometry& geometry) const {
  if (model_) {
    const EdgeGeometry known = model_->clamp(geometry);
    Answer answer{model_->at(known), model_->check(geometry).inside()};
    if (geometry.contact_length < known.contact_length)
      scale(answer.responses, geometry.contact_length / known.contact_length);
    return answer;
  }
  auto solved = plate::solve(geometry);
  if (!solved) throw RunError("the moving edge: " + solved.error().what);
  return {std::move(*solved), true};
}

}  // namespace brash::failure
