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

namespace brash::cli {
namespace {

double quantile(std::vector<double> values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

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

constexpr const char* kMustNot = R"(
## Must not be used for

- inputs outside the range above: the program clamps them and says so; the errors do not hold there;
- a Poisson ratio other than that of the database, 0.3;
- anything within about one ice thickness of the contact: plate theory means nothing there;
- radial cracks, cracks from the re-entrant roots, splitting or crushing.
)";

}  // namespace

std::vector<JudgedRow> judge(const meta_model::ProfileModel& model,
                             const std::vector<const database::Record*>& records) {
  std::vector<JudgedRow> rows;
  for (const database::Record* record : records) {
    const plate::WedgePlate& g = record->plate;
    const plate::UnitProfiles unit =
        failure::to_unit_profiles(model.predict(model.clamp({g.depth, g.contact_length, g.angle, g.thickness})));
    for (const database::Row& row : record->rows) {
      const plate::Response r = plate::respond(unit, record->plate.thickness, row.load.mu1, row.load.mu2);
      rows.push_back(
          {.plate = &record->plate,
           .sigma_over_p = row.response.sigma_over_p,
           .stress_error = std::abs(r.sigma_over_p / row.response.sigma_over_p - 1.0),
           .length_error = std::abs(r.lbreak_over_lc - row.response.lbreak_over_lc),
           .on_plateau = r.lbreak_over_lc >= row.response.plateau_from && r.lbreak_over_lc <= row.response.plateau_to});
    }
  }
  return rows;
}

std::string summary(const std::vector<JudgedRow>& rows) {
  std::string text;
  for (const auto& [name, holds] : {kParts[0], kParts[1]}) {
    std::vector<double> stress;
    double on_plateau = 0.0;
    for (const JudgedRow& row : rows) {
      if (!holds(row)) continue;
      stress.push_back(100 * row.stress_error);
      on_plateau += row.on_plateau ? 1.0 : 0.0;
    }
    if (stress.empty()) continue;
    text += fmt::format(
        "{:<18} {:>6} rows  stress error median {:.2f} %, 95 % {:.2f} %, 99 % {:.2f} %, max {:.1f} %; "
        "place on the plateau {:.1f} %\n",
        name, stress.size(), quantile(stress, 0.5), quantile(stress, 0.95), quantile(stress, 0.99),
        quantile(stress, 1.0), 100.0 * on_plateau / static_cast<double>(stress.size()));
  }
  return text;
}

std::string profile_card(const meta_model::ProfileModel& model, const std::vector<JudgedRow>& rows,
                         const ProfileCardContext& context) {
  std::string text = fmt::format("# Model card: {}\n\n", context.model_file);
  text +=
      "Unit profiles on the centre line of a trapezoidal protrusion of a floating plate, interpolated between solved\n"
      "geometries and superposed for mu1, mu2 and l_c / h.\n\n";
  text += fmt::format("- content hash of the model (SHA-256): `{}`\n- data: `{}`, SHA-256 `{}`\n",
                      context.content_sha256, context.database_file, context.data_sha256);
  const auto& [low, high] = model.range();
  text += fmt::format("- {} geometries, {} modes\n\n## Range\n\n| input | from | to |\n|---|---|---|\n",
                      context.n_geometries, model.n_modes());
  text += fmt::format(
      "| b / l_c | {} | {} |\n| c / l_c | {} | {} |\n| theta [deg] | {:.6g} | {:.6g} |\n| h / l_c | {} | {} |\n", low.b_lc,
      high.b_lc, low.c_lc, high.c_lc, degrees(low.theta), degrees(high.theta), low.h_lc, high.h_lc);
  text += fmt::format(
      "\n## Errors\n\nOn {}. Stress: size of predicted / computed - 1 [%];\nlength: size of predicted - computed "
      "l_break / l_c. `on plateau` is the share [%] of rows whose predicted place has at\nleast 99 % of the peak "
      "stress.\n\n"
      "| rows of | rows | geometries | stress median | 95 % | 99 % | max | length median | 95 % | 99 % | on plateau |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n",
      context.test);
  for (const auto& [name, holds] : kParts) {
    std::vector<JudgedRow> part;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(part), holds);
    text += line(name, part);
  }
  return text + kMustNot;
}

}  // namespace brash::cli
