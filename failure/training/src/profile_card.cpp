// SPDX-License-Identifier: GPL-3.0-or-later
#include "profile_card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include "brash/core/constants.hpp"
#include "brash/core/write_file.hpp"
#include "brash/failure/unit_profiles.hpp"
#include "brash/training/make_model.hpp"
#include "brash/training/network_training.hpp"

namespace brash::training {
namespace {

/// The errors of some rows, rising.
struct Spread {
  std::vector<double> stress;  ///< [%]
  std::vector<double> length;  ///< over l_c
  std::size_t geometries = 0;
  double on_plateau = 0.0;  ///< share of the rows [%]
};

Spread spread(const std::vector<JudgedRow>& rows) {
  Spread result;
  std::set<const plate::WedgePlate*> geometries;
  for (const JudgedRow& row : rows) {
    result.stress.push_back(100 * row.stress_error);
    result.length.push_back(row.length_error);
    geometries.insert(row.plate);
    result.on_plateau += row.on_plateau ? 1.0 : 0.0;
  }
  std::ranges::sort(result.stress);
  std::ranges::sort(result.length);
  result.geometries = geometries.size();
  result.on_plateau *= 100.0 / static_cast<double>(rows.size());
  return result;
}

std::string row(const char* name, const std::vector<JudgedRow>& rows) {
  if (rows.empty()) return "";
  const Spread s = spread(rows);
  return fmt::format("{},{},{},{:.2f},{:.2f},{:.2f},{:.2f},{:.4f},{:.3f},{:.3f},{:.1f}\n", name, rows.size(),
                     s.geometries, quantile(s.stress, 0.5), quantile(s.stress, 0.95), quantile(s.stress, 0.99),
                     quantile(s.stress, 1.0), quantile(s.length, 0.5), quantile(s.length, 0.95),
                     quantile(s.length, 0.99), s.on_plateau);
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

std::vector<JudgedRow> part_of(const std::vector<JudgedRow>& rows, Part holds) {
  std::vector<JudgedRow> part;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(part), holds);
  return part;
}

/// The errors by range.
std::string error_table(const std::vector<JudgedRow>& rows) {
  std::string text =
      "rows_of,rows,geometries,stress_median_percent,stress_95_percent,stress_99_percent,stress_max_percent,"
      "length_median_lc,length_95_lc,length_99_lc,on_plateau_percent\n";
  for (const auto& [name, holds] : kParts) text += row(name, part_of(rows, holds));
  return text;
}

/// The errors in a few words; "" without a row.
std::string errors_in_words(const std::vector<JudgedRow>& rows, const CardFacts& facts) {
  if (rows.empty()) return "";
  const Spread all = spread(rows);
  std::string text = fmt::format(
      "\n**Errors** on {}: 95 % of {} rows have a stress within {:.2f} % and a length within {:.3f} l_c. The largest "
      "error of the\nstress is {:.2f} %.",
      facts.test, rows.size(), quantile(all.stress, 0.95), quantile(all.length, 0.95), quantile(all.stress, 1.0));
  if (const auto bending = part_of(rows, kParts[1].second); !bending.empty()) {
    const Spread some = spread(bending);
    text += fmt::format(" The two are {:.2f} and {:.2f} % where the ice bends before it is crushed (sigma/p >= 0.25).",
                        quantile(some.stress, 0.95), quantile(some.stress, 1.0));
  }
  return text + fmt::format("\n[By range]({}).\n", facts.errors_file);
}

constexpr const char* kMustNot = R"(
**Not for**

- inputs outside the range: the program moves them to its border and warns;
- another Poisson ratio than 0.3;
- places within about one ice thickness of the contact;
- radial cracks, cracks from the re-entrant roots, splitting or crushing.
)";

constexpr const char* kMustNotAsNetwork = R"(
**Not for**

- inputs outside the range: the program moves them to its border and warns;
- another Poisson ratio than 0.3;
- another h / l_c: Eq. 19 scales the bending stress only. The superposition knows h / l_c;
- in-plane loads so large that their second-order effect counts;
- places within about one ice thickness of the contact;
- radial cracks, cracks from the re-entrant roots, splitting or crushing.
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

std::vector<JudgedRow> judge(const Answers& model, const std::vector<const Record*>& records) {
  std::vector<JudgedRow> rows;
  for (const Record* record : records) {
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
    const auto part = part_of(rows, holds);
    if (part.empty()) continue;
    const Spread s = spread(part);
    text += fmt::format(
        "{:<18} {:>6} rows of {} geometries  stress error median {:.2f} %, 95 % {:.2f} %, 99 % {:.2f} %, max {:.1f} %; "
        "place on the plateau {:.1f} %\n",
        name, part.size(), s.geometries, quantile(s.stress, 0.5), quantile(s.stress, 0.95), quantile(s.stress, 0.99),
        quantile(s.stress, 1.0), s.on_plateau);
  }
  return text;
}

ModelCard profile_card(const meta_model::ProfileModel& model, const std::vector<JudgedRow>& rows,
                       const CardFacts& facts) {
  const auto& [low, high] = model.range();
  const std::string text = fmt::format(
      "# Model card: {}\n\n"
      "Predicts the largest stress on the centre line of a trapezoidal protrusion of a floating plate, over the "
      "contact "
      "pressure\n(sigma/p), and its place (l_break/l_c). The model interpolates unit profiles between solved "
      "geometries "
      "and superposes them\nfor mu1, mu2 and l_c / h.\n\n"
      "| input | from | to |\n|---|---|---|\n"
      "| b / l_c | {} | {} |\n| c / l_c | {} | {} |\n| theta [deg] | {:.6g} | {:.6g} |\n| h / l_c | {} | {} |\n",
      facts.model_file, low.b_lc, high.b_lc, low.c_lc, high.c_lc, degrees(low.theta), degrees(high.theta), low.h_lc,
      high.h_lc);
  const std::string made = fmt::format(
      "\n**Made** of {} geometries with {} modes, content SHA-256 `{}`:\n\n    {}\n\nSHA-256 of `{}`: `{}`.\n",
      facts.n_learned, model.n_modes(), facts.content_sha256, facts.command, facts.database_file, facts.data_sha256);
  return {.text = text + errors_in_words(rows, facts) + kMustNot + made, .errors = error_table(rows)};
}

ModelCard hump_card(const TrainedHumps& trained, const std::vector<JudgedRow>& rows, const CardFacts& facts) {
  const meta_model::HumpParameters& p = trained.network.parameters();
  const meta_model::Input &low = p.range.lower, &high = p.range.upper;
  const std::string text = fmt::format(
      "# Model card: {}\n\n"
      "Predicts the largest stress on the centre line of a trapezoidal protrusion of a floating plate, over the "
      "contact "
      "pressure\n(sigma/p), and its place (l_break/l_c): the inputs and outputs of Eq. 17. The humps beside the load "
      "and "
      "beyond {} l_c have\nnetworks of their own, and the larger stress counts.\n\n"
      "| input | from | to |\n|---|---|---|\n"
      "| b / l_c | {:.4g} | {:.4g} |\n| c / l_c | {:.4g} | {:.4g} |\n| theta [deg] | {:.4g} | {:.4g} |\n"
      "| mu1 = P/N | {:.4g} | {:.4g} |\n| mu2 = f/N | {:.4g} | {:.4g} |\n| h / l_c | {} | {} |\n",
      facts.model_file, meta_model::kHumpBoundary, low.b_lc, high.b_lc, low.c_lc, high.c_lc, degrees(low.theta),
      degrees(high.theta), low.mu1, high.mu1, low.mu2, high.mu2, p.thickness_over_lc, p.thickness_over_lc);
  std::string made = fmt::format(
      "\n**Made** of {} rows answered by `{}` (SHA-256 `{}`), content SHA-256 `{}`:\n\n    {}\n\n"
      "Four networks with {} logistic units in their hidden layers and {} weights each:\n\n"
      "| network | iterations | loss in training | in validation |\n|---|---|---|---|\n",
      facts.n_learned, facts.database_file, facts.data_sha256, facts.content_sha256, facts.command,
      fmt::join(p.hidden, ", "), p.stress[0].weights.size());
  for (const LayeredFit& fit : trained.fits)
    made += fmt::format("| {} | {} | {:.3g} | {:.3g} |\n", fit.name, fit.iterations, fit.training_loss,
                        fit.validation_loss);
  return {.text = text + errors_in_words(rows, facts) + kMustNotAsNetwork + made, .errors = error_table(rows)};
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

std::string card_file(const std::string& model) {
  return std::filesystem::path(model).replace_extension(".md").string();
}

std::string errors_file(const std::string& model) {
  return std::filesystem::path(model).replace_extension("").string() + "_errors.csv";
}

std::string write_card(const std::string& model, const ModelCard& card) {
  if (!card.errors.empty()) write_file(errors_file(model), card.errors);
  write_file(card_file(model), card.text);
  return card_file(model);
}

}  // namespace brash::training
