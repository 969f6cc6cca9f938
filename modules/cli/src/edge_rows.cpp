// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "brash/analysis/closed_forms.hpp"
#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/failure/edge_break.hpp"
#include "brash/failure/edge_responses.hpp"
#include "brash/io/case.hpp"
#include "brash/model/choices.hpp"
#include "failure_rows.hpp"
#include "messages.hpp"

namespace brash::cli {
namespace {

failure::IceProperties ice_of(const model::Case& c) {
  return {.thickness = c.ice.thickness,
          .youngs_modulus = c.ice.youngs_modulus,
          .poisson_ratio = c.ice.poisson_ratio,
          .flexural_strength = c.ice.flexural_strength,
          .compressive_strength = c.ice.compressive_strength,
          .crushing_factor = c.ice.crushing_factor,
          .water_density = c.water.density};
}

void expect_no_thickness(const std::vector<PredictedRow>& rows, const std::string& name) {
  for (const PredictedRow& row : rows) {
    if (row.lc_over_h > 0.0)
      throw InputError(Complaint{name, "has a column lc_over_h, which the case states",
                                 "b_lc,c_lc,theta_deg,mu1,mu2 beside a case", "remove that column"});
  }
}

/// The names of the models of edges at rest are not files.
void refuse_model_at_rest(const std::string& name) {
  if (!model::named<model::FailureModel>(name) || std::filesystem::exists(name)) return;
  throw InputError(Complaint{"--model " + name, "is a model of edges at rest, and a moving edge needs its own",
                             "fem, or the path of a model that `brash failure train` made of moving edges",
                             "leave --model out: the model of a moving edge comes with the program"});
}

}  // namespace

void predict_moving_edges(const EdgePredictOptions& options) {
  refuse_model_at_rest(options.model);
  const model::Case resolved = io::read_case(options.case_file, options.overrides);
  std::string header;
  const std::vector<PredictedRow> rows = read_predicted_rows(options.rows, header);
  expect_no_thickness(rows, options.rows.empty() ? "standard input" : options.rows);
  const failure::IceProperties ice = ice_of(resolved);
  const double l_c = failure::characteristic_length(ice), slope = analysis::waterline_slope(resolved);
  if (!(slope < 0.5 * kPi))
    throw InputError(Complaint{options.case_file, "has a vertical wall at the waterline, which does not bend the ice",
                               "a structure that slopes", "give its surface a slope, or leave --case out"});
  const failure::EdgeSource edges(options.model);
  print("{},speed,N,t_break,w_edge,lbreak,first,in_range\n", header);
  for (const PredictedRow& row : rows) {
    const failure::EdgeGeometry geometry{.depth = row.input.b_lc,
                                         .contact_length = row.input.c_lc,
                                         .angle = row.input.theta,
                                         .mass_ratio = failure::mass_ratio(ice, resolved.ice.density),
                                         .thickness = ice.thickness / l_c};
    const auto [responses, in_range] = edges.at(geometry);
    for (const double speed : options.speeds) {
      const failure::EdgePush push{.speed = speed,
                                   .slope = slope,
                                   .friction = resolved.ice.friction_structure,
                                   .mu1 = row.input.mu1,
                                   .contact_length = row.input.c_lc * l_c};
      const failure::EdgeBreak b =
          speed > 0.0 ? failure::break_edge(responses, ice, push) : failure::break_edge_at_rest(responses, ice, push);
      print("{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{},{}\n", row.text, speed, b.load, b.time, b.deflection,
            b.breaking_length, b.radial_first ? "radial" : "circumferential", in_range);
    }
  }
}

}  // namespace brash::cli
