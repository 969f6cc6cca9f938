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

- **Inputs outside the range above.** The program clamps them and says so in its results. The errors do not hold there.
- **Ice with h / l_c far from the value above.** Eq. 19 scales the bending stress only, neither the membrane stress nor the
  shear flexibility. Solve the plate (`model = "plate"`) instead.
- **Anything within about one ice thickness of the contact.** Plate theory means nothing there.
- **Radial cracks, cracks from the re-entrant roots, splitting or crushing.** The outputs are the circumferential crack only.
- **The place of the crack where two humps of the stress compete**, mostly at b < 0.25 l_c. The peak jumps from one hump to
  the other. The network is smooth and can answer with a place between them. See the share of rows on the plateau.
- **Large in-plane loads.** The data are linear plate theory without the second-order effect of N.
)";

}  // namespace

std::string model_card(const Network& network, const TrainingReport& report, const TrainingOptions& options,
                       const CardContext& context) {
  std::string text = fmt::format("# Model card: {}\n\n", context.model_file);
  text += fmt::format(
      "Eq. 17 with {} logistic hidden units{}. It answers for a trapezoidal protrusion of a\n"
      "floating plate. The outputs are the largest principal stress on the centre line over the contact pressure, "
      "sigma/p, and its\nplace, l_break/l_c.\n\n",
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
      "\n## Errors\n\nThe stress error is predicted / computed - 1 [%]. The absolute one is predicted - computed "
      "sigma/p. The length error is\npredicted - computed l_break / l_c. `on plateau` is the share [%] of rows whose "
      "predicted place has at least 99 % of the\npeak stress. Geometries of the test part took no part in training or "
      "stopping.\n\n";
  text +=
      "| rows of | rows | geometries | stress bias | rms | median | 95 % | max | absolute 95 % | length median | 95 % "
      "| on plateau |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  text += row("training", report.train) + row("validation", report.validation) + row("test", report.test);
  for (const Region& region : report.regions) text += row("test, " + region.name, region.errors);
  return text + kMustNot;
}

}  // namespace brash::meta_model
