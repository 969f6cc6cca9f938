// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <utility>

#include "brash/failure/edge_motion.hpp"
#include "brash/failure/edge_responses.hpp"

namespace brash::failure {

EdgeDynamics make_edge_dynamics(const IceProperties& ice, double ice_density) {
  const auto model = std::make_shared<const EdgeResponseModel>(EdgeResponseModel::read(edge_model_path()));
  return {[model](const plate::EdgeGeometry& geometry) { return model->at(model->clamp(geometry)); }, ice, ice_density};
}

}  // namespace brash::failure
