// SPDX-License-Identifier: GPL-3.0-or-later
#include "profile_card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "brash/core/constants.hpp"
#include "brash/failure/unit_profiles.hpp"
#include "brash/meta_model/training.hpp"

namespace brash::cli {
namespace {

using meta_model::quantile;

std::string line(const char* name, const std::vector<JudgedRow>& rows) {
  if (rows.empty()) return "";
  std::vector<double> stress, length;
  std::set<const plate::WedgePlate*> geometries;
  std::size_t on_plateau = 0;
  for (const JudgedRow& row : rows) {
    stress.push_back(100 * row.stress_error);
    length.push_back(row.length_error);
    geometries.insert(row.plate);
    if (row.on_plateau) ++on_plateau;
  }
  std::ranges::sort(stress);
  std::ranges::sort(length);
  return fmt::format("| {} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.4f} | {:.3f} | {:.3f} | {:.1f} |\n", name,
                     rows.size(), geometries.size(), quantile(stress, 0.5), quantile(stress, 0.95),
                     quantile(stress, 0.99), quantile(stress, 1.0), quantile(length, 0.5), quantile(length, 0.95),
                     quantile(length, 0.99),
                     100.0 * static_cast<double>(on_plateau) / static_cast<double>(rows.size()));
}

using Part = bool (*)(const JudgedRow&);
/// Below sigma/p = 0.25 the ice is crushed before it bends.
constexpr std::array<std::pair<const char*, Part>, 14> kParts{{
    {"all", [](const JudgedRow&) { return true; }},
    {"sigma/p >= 0.25", [](const JudgedRow& r) { return r.sigma_over_p >= 0.25; }},
    {"sigma/p < 0.25 (crushed first)", [](const JudgedRow& r) { return r.sigma_over_p < 0.25; }},
    {"b < 0.25 l_c", [](const JudgedRow& r) { return r.plate->depth < 0.25; }},
    {"0.25 l_c <= b < l_c", [](const JudgedRow& r) { return r.plate->depth >= 0.25 && r.plate->depth < 1.0; }},
    {"b >= l_c", [](const JudgedRow& r) { return r.plate->depth >= 1.0; }},
    {"c < 0.1 l_c", [](const JudgedRow& r) { return r.plate->contact_length < 0.1; }},
    {"0.1 l_c <= c < 0.5 l_c",
     [](const JudgedRow& r) { return r.plate->contact_length >= 0.1 && r.plate->contact_length < 0.5; }},
    {"c >= 0.5 l_c", [](const JudgedRow& r) { return r.plate->contact_length >= 0.5; }},
    {"theta < 45 deg", [](const JudgedRow& r) { return r.plate->angle < radians(45.0); }},
    {"45 deg <= theta < 90 deg",
     [](const JudgedRow& r) { return r.plate->angle >= radians(45.0) && r.plate->angle < radians(90.0); }},
    {"theta >= 90 deg", [](const JudgedRow& r) { return r.plate->angle >= radians(90.0); }},
    {"h < 0.08 l_c", [](const JudgedRow& r) { return r.plate->thickness < 0.08; }},
    {"h >= 0.12 l_c", [](const JudgedRow& r) { return r.plate->thickness >= 0.12; }},
}};

std::string error_tables(const std::vector<JudgedRow>& rows, const std::string& test) {
  std::string text = fmt::format(
      "\n## Errors\n\nThe errors are on {}. The stress error is the size of predicted /\ncomputed - 1 [%]. The length "
      "error is the size of predicted - computed l_break / l_c. `on plateau` is the share [%] of\nrows whose predicted "
      "place has at least 99 % of the peak stress.\n\n"
      "| rows of | rows | geometries | stress median | 95 % | 99 % | max | length median | 95 % | 99 % | on plateau |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n",
      test);
  for (const auto& [name, holds] : kParts) {
    std::vector<JudgedRow> part;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(part), holds);
    text += line(name, part);
  }
  return text;
}

constexpr const char* kMustNot = R"(
## Must not be used for

- **Inputs outside the range above.** The program clamps them and says so. The errors do not hold there.
- **Another Poisson ratio** than the 0.3 of the database.
- **Anything within about one ice thickness of the contact.** Plate theory means nothing there.
- **Radial cracks, cracks from the re-entrant roots, splitting or crushing.**
)";

constexpr const char* kMustNotAsNetwork =
    R"(- **Ice with h / l_c far from the value above.** Eq. 19 scales the bending stress only, neither the membrane stress nor the
  shear flexibility. Take the superposition, which knows h / l_c.
- **Large in-plane loads.** The data are linear plate theory without the second-order effect of N.
)";

}  // namespace

Answers answers_of(const meta_model::ProfileModel& model) {
  return [&model](const meta_model::Input& x, double thickness_over_lc) -> meta_model::Output {
    const auto profiles = model.predict(model.clamp({x.b_lc, x.c_lc, x.theta, thickness_over_lc}));
    const plate::Response r = plate::respond(failure::to_unit_profiles(profiles), thickness_over_lc, x.mu1, x.mu2);
    return {r.sigma_over_p, r.lbreak_over_lc};
  };
}

Answers answers_of(const meta_model::ResponseNetwork& model) {
  return [&model](const meta_model::Input& x, double thickness_over_lc) -> meta_model::Output {
    const meta_model::Output y = model.predict(model.clamp(x));
    return {y.sigma_over_p * model.thickness_over_lc() / thickness_over_lc, y.lbreak_over_lc};
  };
}

std::vector<JudgedRow> judge(const Answers& model, const std::vector<const database::Record*>& records) {
  std::vector<JudgedRow> rows;
  for (const database::Record* record : records) {
    const plate::WedgePlate& g = record->plate;
    for (const auto& [load, computed] : record->rows) {
      const auto y = model({g.depth, g.contact_length, g.angle, load.mu1, load.mu2}, g.thickness);
      rows.push_back(
          {.plate = &record->plate,
           .sigma_over_p = computed.sigma_over_p,
           .stress_error = std::abs(y.sigma_over_p / computed.sigma_over_p - 1.0),
           .length_error = std::abs(y.lbreak_over_lc - computed.lbreak_over_lc),
           .on_plateau = y.lbreak_over_lc >= computed.plateau_from && y.lbreak_over_lc <= computed.plateau_to});
    }
  }
  return rows;
}

std::string summary(const std::vector<JudgedRow>& rows) {
  std::string text;
  for (const auto& [name, holds] : {kParts[0], kParts[1]}) {
    std::vector<double> stress;
    std::set<const plate::WedgePlate*> geometries;
    double on_plateau = 0.0;
    for (const JudgedRow& row : rows) {
      if (!holds(row)) continue;
      stress.push_back(100 * row.stress_error);
      geometries.insert(row.plate);
      on_plateau += row.on_plateau ? 1.0 : 0.0;
    }
    if (stress.empty()) continue;
    std::ranges::sort(stress);
    text += fmt::format(
        "{:<18} {:>6} rows of {} geometries  stress error median {:.2f} %, 95 % {:.2f} %, 99 % {:.2f} %, max {:.1f} %; "
        "place on the plateau {:.1f} %\n",
        name, stress.size(), geometries.size(), quantile(stress, 0.5), quantile(stress, 0.95), quantile(stress, 0.99),
        quantile(stress, 1.0), 100.0 * on_plateau / static_cast<double>(stress.size()));
  }
  return text;
}

std::string profile_card(const meta_model::ProfileModel& model, const std::vector<JudgedRow>& rows,
                         const CardFacts& facts) {
  std::string text = fmt::format("# Model card: {}\n\n", facts.model_file);
  text +=
      "Unit profiles on the centre line of a trapezoidal protrusion of a floating plate. They are interpolated "
      "between\nsolved geometries and superposed for mu1, mu2 and l_c / h.\n\n";
  text += fmt::format("- content hash of the model (SHA-256): `{}`\n- data: `{}`, SHA-256 `{}`\n", facts.content_sha256,
                      facts.database_file, facts.data_sha256);
  const auto& [low, high] = model.range();
  text += fmt::format("- {} geometries, {} modes\n\n## Range\n\n| input | from | to |\n|---|---|---|\n",
                      facts.n_learned, model.n_modes());
  text += fmt::format(
      "| b / l_c | {} | {} |\n| c / l_c | {} | {} |\n| theta [deg] | {:.6g} | {:.6g} |\n| h / l_c | {} | {} |\n",
      low.b_lc, high.b_lc, low.c_lc, high.c_lc, degrees(low.theta), degrees(high.theta), low.h_lc, high.h_lc);
  return text + error_tables(rows, facts.test) + kMustNot;
}

std::string hump_card(const meta_model::TrainedHumps& trained, const std::vector<JudgedRow>& rows,
                      const CardFacts& facts) {
  const meta_model::HumpParameters& p = trained.network.parameters();
  std::string text = fmt::format(
      "# Model card: {}\n\n"
      "A network with the inputs and outputs of Eq. 17. It answers for a trapezoidal protrusion of a floating plate. "
      "The outputs\nare the largest principal stress on the centre line over the contact pressure, sigma/p, and its "
      "place, l_break/l_c. The\nhump beside the load and the hump beyond {} l_c have an answer each, and the larger "
      "stress counts.\n\n"
      "- content hash of the model (SHA-256): `{}`\n- trained on {} rows answered by `{}`, SHA-256 `{}`\n"
      "- h / l_c of these rows: {}\n- hidden layers of each of the four networks: {} logistic units, {} weights\n",
      facts.model_file, meta_model::kHumpBoundary, facts.content_sha256, facts.n_learned, facts.database_file,
      facts.data_sha256, p.thickness_over_lc, fmt::join(p.hidden, ", "), p.stress[0].weights.size());
  for (const meta_model::LayeredFit& fit : trained.fits) {
    text +=
        fmt::format("- {}: {} iterations of Levenberg-Marquardt ({}), loss {:.3g} in training, {:.3g} in validation\n",
                    fit.name, fit.iterations, fit.ended, fit.training_loss, fit.validation_loss);
  }
  const meta_model::Input &low = p.range.lower, &high = p.range.upper;
  text += fmt::format(
      "\n## Range\n\n| input | from | to |\n|---|---|---|\n"
      "| b / l_c | {:.4g} | {:.4g} |\n| c / l_c | {:.4g} | {:.4g} |\n| theta [deg] | {:.4g} | {:.4g} |\n"
      "| mu1 = P/N | {:.4g} | {:.4g} |\n| mu2 = f/N | {:.4g} | {:.4g} |\n",
      low.b_lc, high.b_lc, low.c_lc, high.c_lc, degrees(low.theta), degrees(high.theta), low.mu1, high.mu1, low.mu2,
      high.mu2);
  return text + error_tables(rows, facts.test) + kMustNot + kMustNotAsNetwork;
}

}  // namespace brash::cli
