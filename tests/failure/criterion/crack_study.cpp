// SPDX-License-Identifier: GPL-3.0-or-later
// Not a test: writes five breaks of runs for docs/theory/figures/cracks.py, each with the stress on the surface that
// fails. Lengths in metres, frame of the contact: x into the ice.
//
//   crack_study [first seed] > docs/theory/figures/crack-patterns.json

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>

#include "brash/core/constants.hpp"
#include "brash/plate/sheet.hpp"
#include "crack_path.hpp"
#include "edge_of_run.hpp"
#include "outline_sheet.hpp"

namespace {

using namespace brash;
using Json = nlohmann::json;

/// The part of the ice that is drawn [m].
constexpr double kBack = -3.0, kAhead = 7.5, kAside = 9.0, kCell = 0.15;

double rounded(double value) { return std::round(1000.0 * value) / 1000.0; }

Json points(const std::vector<Vec2>& line) {
  Json result = Json::array();
  for (const Vec2 point : line) result.push_back({rounded(point.x), rounded(point.y)});
  return result;
}

/// The larger principal stress in per cent of the strength, row by row along x; -1000 outside the ice.
Json field(const plate::SheetSolution& solution, const failure::IceProperties& ice, failure::Surface side) {
  const double l_c = failure::characteristic_length(ice);
  const double unit = ice.water_density * kGravity * l_c / ice.flexural_strength;
  Json rows = Json::array();
  for (double y = -kAside; y <= kAside + 1e-9; y += kCell) {
    Json row = Json::array();
    for (double x = kBack; x <= kAhead + 1e-9; x += kCell) {
      const auto state = solution.at({x / l_c, y / l_c});
      int value = -1000;
      if (state) {
        const plate::Tensor2 s = failure::stress_on(side, *state, ice.thickness / l_c);
        const double principal = 0.5 * (s.xx + s.yy) + std::hypot(0.5 * (s.xx - s.yy), s.xy);
        value = static_cast<int>(std::lround(100.0 * unit * principal));
      }
      row.push_back(value);
    }
    rows.push_back(row);
  }
  return rows;
}

/// The sheet of a load case at the instant of its break; nothing where it does not break along the stress.
std::optional<Json> drawn(const failure::LoadCase& load, const edge::EdgeModel& model) {
  const failure::Assessment assessment = model.criterion.assess(load);
  if (!assessment.fails || assessment.crack.empty()) return std::nullopt;
  const bool second_order = model.resolved.failure.second_order && !assessment.buckled;
  plate::LoadedSheet sheet = failure::loaded_sheet(load, model.ice, second_order);
  sheet.split = assessment.split;
  const auto solution = plate::solve(sheet);
  if (!solution) return std::nullopt;
  const auto stresses =
      failure::stresses_ahead(sheet, *solution, model.ice, {failure::loads_of(load, model.ice.thickness), model.ice});
  if (!stresses) return std::nullopt;
  Json loads = Json::array();
  for (const failure::SheetLoad& one : load.loads)
    loads.push_back({{"ends", points({one.from, one.to})}, {"out_of_plane", std::round(one.out_of_plane)}});
  return Json{{"outline", points(load.outline)},
              {"crack", points(assessment.crack)},
              {"loads", loads},
              {"breaking_length", rounded(assessment.breaking_length)},
              {"largest", rounded(stresses->largest)},
              {"split", assessment.split},
              {"surface", stresses->side},
              {"stress", field(*solution, model.ice, stresses->side)}};
}

/// The break of the next step, if it is the structure's and its loads are the structure's alone.
std::optional<Json> next_break(testing::EdgeOfRun& run, const edge::EdgeModel& model) {
  const geometry::IceSheet sheet = run.next_sheet(model);
  const auto contacts = run.next_contacts(model, sheet);
  const simulation::StepReport report = run.step();
  for (const model::CrackEvent& event : report.events) {
    if (event.pressing_floe != model::kNoFloe) continue;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const geometry::ContactRegion& region = contacts[i].region;
      if (norm(0.5 * (region.chord_from + region.chord_to) - event.tip) > 1e-6) continue;
      failure::LoadCase load = contacts[i].load;
      if (!edge::place_loads(model, sheet, contacts, i, true, load)) continue;
      auto data = drawn(load, model);
      if (!data || std::abs(data->at("breaking_length").get<double>() / event.breaking_length - 1.0) > 0.02) continue;
      data->emplace("time", rounded(event.time));
      return data;
    }
  }
  return std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
  Json breaks = Json::array();
  // One break after each fifth of a run, of as many runs as it takes.
  for (int seed = argc > 1 ? std::atoi(argv[1]) : 101; breaks.size() < 5; ++seed) {
    testing::EdgeOfRun run(seed);
    const auto criterion = edge::make_criterion(run.resolved, run.ice);
    const edge::EdgeModel model{*run.hull, run.resolved, run.ice, *criterion};
    double from = 0.1 * run.resolved.time.duration;
    while (!run.is_over() && breaks.size() < 5) {
      if (run.simulation.time() < from) {
        (void)run.step();
        continue;
      }
      if (auto one = next_break(run, model)) {
        std::fprintf(stderr, "seed %d, %.2f s\n", seed, run.simulation.time());
        breaks.push_back(std::move(*one));
        from += 0.2 * run.resolved.time.duration;
      }
    }
  }
  const Json window{{"back", kBack}, {"ahead", kAhead}, {"aside", kAside}, {"cell", kCell}};
  std::printf("%s\n", Json{{"window", window}, {"breaks", breaks}}.dump().c_str());
}
