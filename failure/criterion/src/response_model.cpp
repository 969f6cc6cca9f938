// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/failure/response_model.hpp"

#include <cmath>
#include <filesystem>

#include "brash/core/error.hpp"
#include "brash/failure/criterion.hpp"
#include "brash/failure/unit_profiles.hpp"

namespace brash::failure {
namespace {

/// h / l_c of rows that do not state it: the rounded ratio of the paper's validation case.
constexpr double kUsualThickness = 0.1;

/// The thickest plate of a database, h / l_c: ice that is thicker bends as no plate.
constexpr double kThickest = 1.0;

/// The plate itself; every row is in range that the plate theory can hold.
class PlateResponse final : public ResponseModel {
 public:
  ModelResponse respond(const meta_model::Input& x, double thickness_over_lc) const override {
    const double h = thickness_over_lc > 0.0 ? thickness_over_lc : kUsualThickness;
    const auto profiles = plate::solve({.depth = x.b_lc, .contact_length = x.c_lc, .angle = x.theta, .thickness = h});
    if (!profiles) throw RunError("the plate: " + profiles.error().what);
    const plate::Response r = plate::respond(*profiles, h, x.mu1, x.mu2);
    return {r.sigma_over_p, r.lbreak_over_lc, h <= kThickest};
  }
};

/// A network, inputs moved into its range, the stress scaled by Eq. 19 where the row states h / l_c.
class NetworkResponse final : public ResponseModel {
 public:
  explicit NetworkResponse(const std::string& file) : network_(meta_model::read_network(file)) {}

  ModelResponse respond(const meta_model::Input& x, double thickness_over_lc) const override {
    const meta_model::Output y = network_->predict(network_->clamp(x));
    const double scale = thickness_over_lc > 0.0 ? network_->thickness_over_lc() / thickness_over_lc : 1.0;
    const bool scales = std::abs(1.0 / scale - 1.0) <= kThicknessScaled;
    return {scale * y.sigma_over_p, y.lbreak_over_lc, scales && network_->check(x).inside()};
  }

 private:
  std::unique_ptr<meta_model::ResponseNetwork> network_;
};

/// Interpolated unit profiles, superposed exactly; h / l_c as for the plate.
class SuperpositionResponse final : public ResponseModel {
 public:
  explicit SuperpositionResponse(const std::string& file) : model_(meta_model::ProfileModel::read(file)) {}

  ModelResponse respond(const meta_model::Input& x, double thickness_over_lc) const override {
    const double h = thickness_over_lc > 0.0 ? thickness_over_lc : kUsualThickness;
    const meta_model::Geometry wanted{x.b_lc, x.c_lc, x.theta, h};
    const plate::Response r = plate::respond(to_unit_profiles(model_.predict(model_.clamp(wanted))), h, x.mu1, x.mu2);
    return {r.sigma_over_p, r.lbreak_over_lc, model_.check(wanted).inside()};
  }

 private:
  meta_model::ProfileModel model_;
};

}  // namespace

std::unique_ptr<ResponseModel> make_response_model(const std::string& model) {
  if (model == "fem") return std::make_unique<PlateResponse>();
  const auto known = model::named<model::FailureModel>(model);
  const std::string shipped = known ? model_path(*known, "") : "";
  const std::string file = shipped.empty() ? model : shipped;
  if (std::error_code ignored; shipped.empty() && !std::filesystem::exists(model, ignored)) {
    throw InputError(Complaint{"model '" + model + "'", "neither a model of this name nor such a file is there",
                               "network, deep-network, superposition, fem, or the path of a model that `brash failure "
                               "train` wrote",
                               "correct the name or the path"});
  }
  if (meta_model::model_format(file) == meta_model::kProfileFormat)
    return std::make_unique<SuperpositionResponse>(file);
  return std::make_unique<NetworkResponse>(file);
}

}  // namespace brash::failure
