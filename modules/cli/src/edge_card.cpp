// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/write_file.hpp"
#include "brash/database/edge_database.hpp"
#include "brash/failure/edge_break.hpp"
#include "brash/failure/edge_responses.hpp"
#include "brash/meta_model/training.hpp"
#include "messages.hpp"

namespace brash::cli {
namespace {

namespace fs = std::filesystem;
using failure::EdgeGeometry;
using failure::EdgeResponses;

/// Speeds at which the model breaks the edge [m/s]; 0: at rest.
constexpr std::array<double, 6> kSpeeds{0.0, 0.2, 0.5, 1.2, 2.0, 5.0};
/// Earlier times do not count: plate theory and mesh end there.
constexpr double kEarliest = 0.1;

/// The validation case.
failure::IceProperties usual_ice(const EdgeGeometry& geometry) {
  failure::IceProperties ice{.thickness = 0.33,
                             .youngs_modulus = 0.35e9,
                             .flexural_strength = 539e3,
                             .compressive_strength = 1e6,
                             .water_density = 1025.0};
  // l_c / h grows with the fourth root of E / h.
  const double wanted = 1.0 / geometry.thickness, found = failure::characteristic_length(ice) / ice.thickness;
  ice.youngs_modulus *= std::pow(wanted / found, 4.0);
  return ice;
}

/// Errors on one geometry that the model has not seen.
struct Judged {
  const EdgeGeometry* geometry = nullptr;
  double deflection = 0.0;                                      ///< relative, largest over the times
  double moment = 0.0;                                          ///< on the axis, over the largest moment at that time
  std::array<double, kSpeeds.size()> load{}, length{}, give{};  ///< N and w relative, breaking length over l_c
};

struct Test {
  std::vector<database::EdgeRecord> records;
  std::vector<Judged> rows;
};

void note_errors(const EdgeResponses& found, const EdgeResponses& wanted, Judged& row) {
  std::vector<double> on_axis(wanted.station.size());
  for (std::size_t i = 0; i < wanted.time.size(); ++i) {
    if (wanted.time[i] < kEarliest) continue;
    row.deflection = std::max(row.deflection, std::abs(found.deflection[i] / wanted.deflection[i] - 1.0));
    const double* xx = wanted.axis_moment_at(i);
    const double most = *std::max_element(xx, xx + wanted.station.size());
    for (std::size_t s = 0; s < wanted.station.size(); ++s) {
      if (wanted.station[s] > found.station.back()) break;
      const auto above = std::lower_bound(found.station.begin() + 1, found.station.end() - 1, wanted.station[s]);
      const auto k = static_cast<std::size_t>(above - found.station.begin());
      const double share = (wanted.station[s] - found.station[k - 1]) / (found.station[k] - found.station[k - 1]);
      const double value = (1.0 - share) * found.axis_moment_at(i)[k - 1] + share * found.axis_moment_at(i)[k];
      row.moment = std::max(row.moment, std::abs(value - xx[s]) / most);
    }
  }
}

Judged judge(const failure::EdgeResponseModel& model, const database::EdgeRecord& record) {
  Judged row{.geometry = &record.geometry};
  const EdgeResponses found = model.at(record.geometry);
  note_errors(found, record.responses, row);
  const failure::IceProperties ice = usual_ice(record.geometry);
  const double slope = radians(61.4), friction = 0.027, l_c = failure::characteristic_length(ice);
  for (std::size_t v = 0; v < kSpeeds.size(); ++v) {
    const failure::EdgePush push{.speed = kSpeeds[v],
                                 .slope = slope,
                                 .friction = friction,
                                 .mu1 = failure::load_ratios(slope, friction, 0.0).mu1,
                                 .contact_length = record.geometry.contact_length * l_c};
    const auto broken = [&](const EdgeResponses& r) {
      return push.speed > 0.0 ? failure::break_edge(r, ice, push) : failure::break_edge_at_rest(r, ice, push);
    };
    const failure::EdgeBreak a = broken(found), b = broken(record.responses);
    row.load[v] = std::abs(a.load / b.load - 1.0);
    row.give[v] = std::abs(a.deflection / b.deflection - 1.0);
    row.length[v] = std::abs(a.breaking_length - b.breaking_length) / l_c;
  }
  return row;
}

/// The records of a test database, which must not be of a plan that the model has learned.
std::vector<database::EdgeRecord> unseen(const std::string& path, const std::set<std::string>& learned_plans) {
  if (path.empty()) return {};
  database::EdgeDatabase test = database::read_edge_database(path);
  if (!learned_plans.contains(test.plan_sha256)) return std::move(test.records);
  throw InputError(Complaint{path, "is of a plan that the model learns", "geometries that the model has not seen",
                             "solve a plan with points between those of the grid for the test"});
}

Test tested(const failure::EdgeResponseModel& model, std::vector<database::EdgeRecord> records) {
  Test test{.records = std::move(records), .rows = {}};
  for (const database::EdgeRecord& record : test.records)
    if (record.solved && model.check(record.geometry).inside()) test.rows.push_back(judge(model, record));
  return test;
}

template <typename Value>
std::array<double, 3> quantiles(const std::vector<Judged>& rows, Value value) {
  std::vector<double> values;
  for (const Judged& row : rows) values.push_back(value(row));
  std::ranges::sort(values);
  using meta_model::quantile;
  return {quantile(values, 0.5), quantile(values, 0.95), quantile(values, 1.0)};
}

std::string percent(const std::array<double, 3>& q) {
  return fmt::format("{:.2f} | {:.2f} | {:.1f}", 100 * q[0], 100 * q[1], 100 * q[2]);
}

std::string errors_table(const std::vector<Judged>& rows) {
  std::string text = fmt::format(
      "Of the responses from {} sqrt(l_c/g) on, over their largest value at that time [%]:\n\n"
      "| | geometries | median | 95 % | max |\n|---|---|---|---|---|\n",
      kEarliest);
  text += fmt::format("| deflection of B | {} | {} |\n", rows.size(),
                      percent(quantiles(rows, [](const Judged& r) { return r.deflection; })));
  text += fmt::format("| moment on the axis | {} | {} |\n", rows.size(),
                      percent(quantiles(rows, [](const Judged& r) { return r.moment; })));
  text +=
      "\nAt break, of the load N [%], the deflection of B [%] and the breaking length [l_c]:\n\n"
      "| speed [m/s] | N median | 95 % | max | w median | 95 % | max | length median | 95 % | max |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n";
  for (std::size_t v = 0; v < kSpeeds.size(); ++v) {
    const auto length = quantiles(rows, [v](const Judged& r) { return r.length[v]; });
    text += fmt::format(
        "| {} | {} | {} | {:.4f} | {:.3f} | {:.3f} |\n", kSpeeds[v] > 0.0 ? fmt::format("{}", kSpeeds[v]) : "static",
        percent(quantiles(rows, [v](const Judged& r) { return r.load[v]; })),
        percent(quantiles(rows, [v](const Judged& r) { return r.give[v]; })), length[0], length[1], length[2]);
  }
  return text;
}

/// The contacts that structures have before the ice breaks.
std::vector<Judged> usual(const std::vector<Judged>& rows) {
  std::vector<Judged> result;
  std::ranges::copy_if(rows, std::back_inserter(result), [](const Judged& row) {
    return row.geometry->contact_length >= 0.2 && row.geometry->depth <= 1.2;
  });
  return result;
}

std::string of_test(const char* sheet, const std::string& path, const Test& test) {
  if (test.rows.empty()) return "";
  std::string text =
      fmt::format("\n## Errors, {} sheet\n\nThe errors are on {} geometries that the model has not seen (`{}`).\n\n",
                  sheet, test.rows.size(), fs::path(path).filename().string()) +
      errors_table(test.rows);
  if (const auto some = usual(test.rows); !some.empty())
    text += fmt::format("\nThe same on {} of them, with c >= 0.2 l_c and b <= 1.2 l_c.\n\n", some.size()) +
            errors_table(some);
  return text;
}

constexpr const char* kMustNot = R"(
The ice is the validation case's, pressed by its cone, with E scaled to the geometry's h / l_c.

## Must not be used for

- **Inputs outside the range above.** The errors do not hold there.
- **Another Poisson ratio** than the 0.3 of the database.
- **Times before 0.07 sqrt(l_c/g)**, and anything within about one ice thickness of the contact.
- **Water that is shallower than about l_c.**
)";

}  // namespace

void fit_edges(const EdgeFiles& files) {
  std::vector<meta_model::EdgeSample> samples;
  std::set<std::string> plans;
  std::string hashes, data;
  for (const std::string& path : {files.database, files.split}) {
    if (path.empty()) continue;
    const database::EdgeDatabase learned = database::read_edge_database(path);
    plans.insert(learned.plan_sha256);
    for (const database::EdgeRecord& record : learned.records)
      if (record.solved) samples.push_back({record.geometry, record.responses});
    const std::string hash = sha256_of_file(path);
    hashes += (hashes.empty() ? "" : " ") + hash;
    data += fmt::format("- data: `{}`, SHA-256 `{}`\n", fs::path(path).filename().string(), hash);
  }
  auto of_test_whole = unseen(files.test, plans), of_test_split = unseen(files.test_split, plans);
  const auto model = failure::EdgeResponseModel::fit(samples, hashes);
  const std::string content = model.write(files.output);
  // The model is judged as it will be read.
  const auto written = failure::EdgeResponseModel::read(files.output);
  const Test whole = tested(written, std::move(of_test_whole)), split = tested(written, std::move(of_test_split));

  const auto& [low, high] = model.range();
  const std::string name = fs::path(files.output).filename().string();
  std::string card = fmt::format(
      "# Model card: {}\n\nResponses of a moving ice edge to a growing line load on the tip of a trapezoid: the "
      "deflection of B and the\n"
      "moments on the centre line and along the edge at B, with the water's inertia "
      "(docs/theory/fracture-of-the-edge.md).\n\n"
      "- content hash of the model (SHA-256): `{}`\n{}- {} geometries, {} modes\n\n## Range\n\n"
      "| input | from | to |\n|---|---|---|\n| b / l_c | {:.4g} | {:.4g} |\n| c / l_c | {:.4g} | {:.4g} |\n"
      "| theta [deg] | {:.4g} | {:.4g} |\n| h / l_c | {:.4g} | {:.4g} |\n",
      name, content, data, samples.size(), model.n_modes(), low.depth, high.depth, low.contact_length,
      high.contact_length, degrees(low.angle), degrees(high.angle), low.thickness, high.thickness);
  card += of_test("whole", files.test, whole) + of_test("split", files.test_split, split) + kMustNot;
  const std::string card_file = fs::path(files.output).replace_extension(".md").string();
  write_file(card_file, card);
  if (!whole.rows.empty()) print("{}", errors_table(whole.rows));
  print("modes       {}\nmodel       {}\nsha256      {}\ncard        {}\n", model.n_modes(), files.output, content,
        card_file);
}

}  // namespace brash::cli
