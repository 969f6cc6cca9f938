// SPDX-License-Identifier: GPL-3.0-or-later
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
#include "brash/failure/edge_break.hpp"
#include "brash/failure/edge_responses.hpp"
#include "brash/training/edge_database.hpp"
#include "brash/training/make_model.hpp"
#include "profile_card.hpp"

namespace brash::training {
namespace {

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
  std::vector<EdgeRecord> records;
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

Judged judge(const failure::EdgeResponseModel& model, const EdgeRecord& record) {
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
std::vector<EdgeRecord> unseen(const std::string& path, const std::set<std::string>& learned_plans) {
  if (path.empty()) return {};
  EdgeDatabase test = read_edge_database(path);
  if (!learned_plans.contains(test.plan_sha256)) return std::move(test.records);
  throw InputError(Complaint{path, "is of a plan that the model learns", "geometries that the model has not seen",
                             "solve a plan with points between the grid's for the test"});
}

Test tested(const failure::EdgeResponseModel& model, std::vector<EdgeRecord> records) {
  Test test{.records = std::move(records), .rows = {}};
  for (const EdgeRecord& record : test.records)
    if (record.solved && model.check(record.geometry).inside()) test.rows.push_back(judge(model, record));
  return test;
}

template <typename Value>
std::array<double, 3> quantiles(const std::vector<Judged>& rows, Value value) {
  std::vector<double> values;
  for (const Judged& row : rows) values.push_back(value(row));
  std::ranges::sort(values);
  return {quantile(values, 0.5), quantile(values, 0.95), quantile(values, 1.0)};
}

using Quantiles = std::array<double, 3>;  ///< 50, 95 and 100 %

Quantiles load_errors(const std::vector<Judged>& rows, std::size_t v) {
  return quantiles(rows, [v](const Judged& r) { return 100 * r.load[v]; });
}

Quantiles give_errors(const std::vector<Judged>& rows, std::size_t v) {
  return quantiles(rows, [v](const Judged& r) { return 100 * r.give[v]; });
}

Quantiles length_errors(const std::vector<Judged>& rows, std::size_t v) {
  return quantiles(rows, [v](const Judged& r) { return r.length[v]; });
}

/// Lines of the errors by range.
/// @param contacts  sheet, outlines and their number, each before a comma.
std::string error_lines(const std::string& contacts, const std::vector<Judged>& rows) {
  const auto percent = [&](const char* number, const std::string& speed, const Quantiles& q) {
    return fmt::format("{}{},{},percent,{:.2f},{:.2f},{:.1f}\n", contacts, number, speed, q[0], q[1], q[2]);
  };
  std::string text = percent("deflection", "", quantiles(rows, [](const Judged& r) { return 100 * r.deflection; })) +
                     percent("moment on the axis", "", quantiles(rows, [](const Judged& r) { return 100 * r.moment; }));
  for (std::size_t v = 0; v < kSpeeds.size(); ++v) {
    const std::string speed = fmt::format("{}", kSpeeds[v]);
    const Quantiles length = length_errors(rows, v);
    text += percent("load at break", speed, load_errors(rows, v)) +
            percent("deflection at break", speed, give_errors(rows, v)) +
            fmt::format("{}breaking length,{},l_c,{:.4f},{:.3f},{:.3f}\n", contacts, speed, length[0], length[1],
                        length[2]);
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

/// The 95 % errors at break over the speeds kSpeeds[from] to kSpeeds[to]: a row of the card.
std::string error_row(const std::string& name, const std::vector<Judged>& rows, std::size_t from, std::size_t to) {
  double load = 0.0, give = 0.0, length = 0.0;
  for (std::size_t v = from; v <= to; ++v) {
    load = std::max(load, load_errors(rows, v)[1]);
    give = std::max(give, give_errors(rows, v)[1]);
    length = std::max(length, length_errors(rows, v)[1]);
  }
  return fmt::format("| {} | {} | {:.2f} | {:.2f} | {:.3f} |\n", name, rows.size(), load, give, length);
}

/// One sheet's rows of the card, and its errors by range.
ModelCard of_test(const std::string& sheet, const Test& test) {
  if (test.rows.empty()) return {};
  ModelCard part;
  part.text =
      error_row(sheet + ", at rest", test.rows, 0, 0) +
      error_row(fmt::format("{}, {} m/s", sheet, kSpeeds[1]), test.rows, 1, 1) +
      error_row(fmt::format("{}, {} to {} m/s", sheet, kSpeeds[2], kSpeeds.back()), test.rows, 2, kSpeeds.size() - 1);
  part.errors = error_lines(fmt::format("{},all,{},", sheet, test.rows.size()), test.rows);
  if (const auto some = usual(test.rows); !some.empty())
    part.errors += error_lines(fmt::format("{},c >= 0.2 l_c and b <= 1.2 l_c,{},", sheet, some.size()), some);
  return part;
}

/// The rows of both sheets, and their errors by range.
ModelCard error_tables(const Test& whole, const Test& split) {
  ModelCard of_whole = of_test("whole", whole), of_split = of_test("split", split);
  if (whole.rows.empty() && split.rows.empty()) return {};
  return {
      .text =
          "| sheet, speed | geometries | load [%] | deflection [%] | breaking length [l_c] |\n|---|---|---|---|---|\n" +
          of_whole.text + of_split.text,
      .errors = "sheet,outlines,geometries,number,speed_m_s,unit,median,95_percent,max\n" + of_whole.errors +
                of_split.errors};
}

/// The card to its errors.
std::string description(const failure::EdgeResponseModel& model, const std::string& file, const std::string& errors) {
  const auto& [low, high] = model.range();
  std::string text = fmt::format(
      "# Model card: {}\n\nPredicts how an ice edge with the outline of a trapezoid, on water that has inertia, "
      "responds to a growing line load on its\ntip: the deflection of B and the moments on the centre line and along "
      "the edge at B.\n\n"
      "| input | from | to |\n|---|---|---|\n| b / l_c | {:.4g} | {:.4g} |\n| c / l_c | {:.4g} | {:.4g} |\n"
      "| theta [deg] | {:.4g} | {:.4g} |\n| h / l_c | {:.4g} | {:.4g} |\n",
      file_name(file), low.depth, high.depth, low.contact_length, high.contact_length, degrees(low.angle),
      degrees(high.angle), low.thickness, high.thickness);
  if (errors.empty()) return text;
  return text +
         fmt::format(
             "\n**Errors** at break, within which 95 % of the geometries lie that the model has not seen. The ice "
             "is the validation case's,\npressed by its cone, with E scaled to h / l_c. [By range]({}); its lines "
             "without a speed are of the responses from\n{} sqrt(l_c/g) on, over their largest value at that "
             "time.\n\n{}",
             file_name(errors_file(file)), kEarliest, errors);
}

constexpr const char* kMustNot = R"(
**Not for**

- inputs outside the range;
- another Poisson ratio than 0.3;
- times before 0.07 sqrt(l_c/g), and places within about one ice thickness of the contact;
- water that is shallower than about l_c.
)";

}  // namespace

MadeModel make_edge_model(const ModelFiles& files) {
  std::vector<meta_model::EdgeSample> samples;
  std::set<std::string> plans;
  std::string hashes, data;
  for (const std::string& path : {files.data, files.split}) {
    if (path.empty()) continue;
    const EdgeDatabase learned = read_edge_database(path);
    plans.insert(learned.plan_sha256);
    for (const EdgeRecord& record : learned.records)
      if (record.solved) samples.push_back({record.geometry, record.responses});
    const std::string hash = sha256_of_file(path);
    hashes += (hashes.empty() ? "" : " ") + hash;
    data += fmt::format("- `{}`: SHA-256 `{}`\n", file_name(path), hash);
  }
  auto of_test_whole = unseen(files.test, plans), of_test_split = unseen(files.test_split, plans);
  const auto model = failure::EdgeResponseModel::fit(samples, hashes);
  const std::string content = model.write(files.output);
  // The model is evaluated as it will be read.
  const auto written = failure::EdgeResponseModel::read(files.output);
  const Test whole = tested(written, std::move(of_test_whole)), split = tested(written, std::move(of_test_split));

  const ModelCard errors = error_tables(whole, split);
  const std::string made =
      fmt::format("\n**Made** of {} geometries with {} modes, content SHA-256 `{}`:\n\n    {}\n\n{}", samples.size(),
                  model.n_modes(), content, files.command, data);
  const std::string path = write_card(
      files.output, {.text = description(model, files.output, errors.text) + kMustNot + made, .errors = errors.errors});
  return {.report = fmt::format("{}modes       {}\n", errors.text, model.n_modes()),
          .content_sha256 = content,
          .card = path};
}

}  // namespace brash::training
