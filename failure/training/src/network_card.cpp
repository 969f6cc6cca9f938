// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "brash/core/constants.hpp"
#include "brash/training/network_training.hpp"

namespace brash::training {

using namespace meta_model;

namespace {

/// The region of the rows of which the ice bends before it is crushed.
constexpr const char* kBendingRows = "sigma/p >= 0.25";

std::string row(const std::string& part, const std::string& rows_of, const Errors& e) {
  return fmt::format("{},{},{},{},{:.2f},{:.2f},{:.2f},{:.2f},{:.2f},{:.3f},{:.3f},{:.3f},{:.0f}\n", part, rows_of,
                     e.n_rows, e.n_geometries, 100 * e.stress_bias, 100 * e.stress_rms, 100 * e.stress_median,
                     100 * e.stress_95, 100 * e.stress_max, e.stress_absolute_95, e.length_median, e.length_95,
                     100 * e.length_on_plateau);
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

/// The errors of the test rows in a few words.
std::string errors_in_words(const TrainingReport& report, const std::string& errors_file) {
  const Errors& test = report.test;
  std::string text = fmt::format(
      "\n**Errors** on {} geometries that took no part in the training: 95 % of {} rows have a stress within {:.2f} % "
      "and a length\nwithin {:.3f} l_c. The largest error of the stress is {:.2f} %.",
      test.n_geometries, test.n_rows, 100 * test.stress_95, test.length_95, 100 * test.stress_max);
  for (const Region& region : report.regions)
    if (region.name == kBendingRows)
      text += fmt::format(" The two are {:.2f} and {:.2f} % where the ice bends before it is crushed ({}).",
                          100 * region.errors.stress_95, 100 * region.errors.stress_max, kBendingRows);
  return text + fmt::format("\n[By range]({}).\n", errors_file);
}

constexpr const char* kMustNot = R"(
**Not for**

- inputs outside the range: the program moves them to its border and warns;
- another h / l_c: Eq. 19 scales the bending stress only. Solve the plate (`model = "plate"`) instead;
- the place of the crack where two humps of the stress compete, mostly at b < 0.25 l_c: the network is smooth and can
  answer with a place between them (`on_plateau_percent` is the share of places with 99 % of the peak stress);
- in-plane loads so large that their second-order effect counts;
- places within about one ice thickness of the contact;
- radial cracks, cracks from the re-entrant roots, splitting or crushing.
)";

}  // namespace

std::string error_table(const TrainingReport& report) {
  std::string text =
      "part,rows_of,rows,geometries,stress_bias_percent,stress_rms_percent,stress_median_percent,stress_95_percent,"
      "stress_max_percent,sigma_over_p_95,length_median_lc,length_95_lc,on_plateau_percent\n";
  text += row("training", "all", report.train) + row("validation", "all", report.validation) +
          row("test", "all", report.test);
  for (const Region& region : report.regions) text += row("test", region.name, region.errors);
  return text;
}

std::string model_card(const Network& network, const TrainingReport& report, const TrainingOptions& options,
                       const CardContext& context) {
  std::string text = fmt::format(
      "# Model card: {}\n\n"
      "Predicts the largest stress on the centre line of a trapezoidal protrusion of a floating plate, over the "
      "contact "
      "pressure\n(sigma/p), and its place (l_break/l_c), by Eq. 17 with {} logistic hidden units{}.\n\n",
      context.model_file, options.hidden, options.separate ? " for each of the two" : "");
  text += range_table(network.range());
  text += fmt::format("| h / l_c | {} | {} |\n", network.thickness_over_lc(), network.thickness_over_lc());
  text += errors_in_words(report, context.errors_file) + kMustNot;
  text += fmt::format("\n**Made** with content SHA-256 `{}`:\n\n    {}\n\nSHA-256 of `{}`: `{}`.\n",
                      context.content_sha256, context.command, context.database_file, network.parameters().data_sha256);
  text +=
      fmt::format("\nBest of {} random starts with seed {}, by Levenberg-Marquardt:\n\n", options.starts, options.seed);
  for (const Start& start : report.starts)
    if (start.kept) text += fmt::format("- {}: {} iterations ({})\n", start.serves, start.iterations, start.ended);
  return text;
}

}  // namespace brash::training
