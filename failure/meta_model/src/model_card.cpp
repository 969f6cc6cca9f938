// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "brash/core/constants.hpp"
#include "brash/meta_model/training.hpp"

namespace brash::meta_model {
namespace {

std::string row(const std::string& name, const Errors& e) {
  return fmt::format(
      "| {} | {} | {} | {:+.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.3f} | {:.3f} | {:.3f} | {:.0f} |\n", name,
      e.n_rows, e.n_geometries, 100 * e.stress_bias, 100 * e.stress_rms, 100 * e.stress_median, 100 * e.stress_95,
      100 * e.stress_max, e.stress_absolute_95, e.length_median, e.length_95, 100 * e.length_on_plateau);
}

std::string range_table(const Range& r) {
  std::string text = "| input | from | to |\n|---|---|---|\n";
  text += fmt::format("| b / l_c | {:.4g} | {:.4g} |\n", r.lower.b_lc, r.upper.b_lc);
  text += fmt::format("| c / l_c | {:.4g} | {:.4g} |\n", r.lower.c_lc, r.upper.c_lc);
  text += fmt::format("| theta [deg] | {:.4g} | {:.4g} |\n", degrees(r.lower.theta), degrees(r.upper.theta));
  text += fmt::format("| mu1 = P/N | {:.4g} | {:.4g} |\n", r.lower.mu1, r.upper.mu1);
  text += fmt::format("| mu2 = f/N | {:.4g} | {:.4g} |\n", r.lower.mu2, r.upper.mu2);
  return text;
}

constexpr const char* kMustNot = R"(
## Must not be used for

- inputs outside the range above: the program clamps them and says so in its results; the errors do not hold there;
- ice with h / l_c far from the value above: Eq. 19 scales the bending stress only, neither the membrane stress nor the
  shear flexibility; solve the plate (`model = "plate"`) instead;
- anything within about one ice thickness of the contact: plate theory means nothing there;
- radial cracks, cracks from the re-entrant roots, splitting or crushing: the outputs are the circumferential crack only;
- the place of the crack where two humps of the stress compete (mostly b < 0.25 l_c): the peak jumps from one to the
  other and the network, which is smooth, can answer with a place between them; see the share of rows on the plateau;
- large in-plane loads: the data are linear plate theory without the second-order effect of N.
)";

}  // namespace

std::string model_card(const Network& network, const TrainingReport& report, const TrainingOptions& options,
                       const CardContext& context) {
  std::string text = fmt::format("# Model card: {}\n\n", context.model_file);
  text += fmt::format(
      "Eq. 17 with {} logistic hidden units{}: the largest principal stress on the centre line over\n"
      "the contact pressure, sigma/p, and the place of it, l_break/l_c, of a trapezoidal protrusion of a floating "
      "plate.\n\n",
      options.hidden, options.separate ? " for each of the two outputs" : " and two outputs");
  text += fmt::format("- content hash of the model (SHA-256): `{}`\n", context.content_sha256);
  text += fmt::format("- training data: `{}`, SHA-256 `{}`\n", context.database_file, network.parameters().data_sha256);
  text += fmt::format("- h / l_c of the training data: {}\n", network.thickness_over_lc());
  for (const Start& start : report.starts) {
    if (start.kept) {
      text += fmt::format("- {}: best of {} random starts with seed {}, {} iterations of Levenberg-Marquardt ({})\n",
                          start.serves, options.starts, options.seed, start.iterations, start.ended);
    }
  }
  text += "\n## Range\n\n" + range_table(network.range());
  text +=
      "\n## Errors\n\nStress: predicted / computed - 1 [%], and predicted - computed sigma/p (absolute); length: "
      "predicted - computed l_break / l_c. `on plateau` is "
      "the share [%] of\nrows whose predicted place has at least 99 % of the peak stress. Geometries of the test part "
      "took no part in training\nor stopping.\n\n";
  text +=
      "| rows of | rows | geometries | stress bias | rms | median | 95 % | max | absolute 95 % | length median | 95 % "
      "| on plateau |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  text += row("training", report.train) + row("validation", report.validation) + row("test", report.test);
  for (const Region& region : report.regions) text += row("test, " + region.name, region.errors);
  return text + kMustNot;
}

}  // namespace brash::meta_model
