// SPDX-License-Identifier: GPL-3.0-or-later
// Times of recorded sheets, stage by stage, on the coarse mesh and on the fast one.
//
//   bench_sheets FILE [repetitions] [answers]    prints one JSON object; FILE as tests/corpus/sheets/solved.txt
//
// A time is the mean over the sheets of the least of the repetitions: other work on the machine only adds to it. The
// stresses of all sheets go into `answers`, so that two versions of the program can be compared.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "brash/plate/sheet.hpp"

namespace {

namespace plate = brash::plate;
using brash::Vec2;

constexpr double kReach = 2.5;  ///< of the places beside the centre line that a criterion checks, over l_c
constexpr double kLine = 4.0;   ///< length of the centre line that it checks, over l_c

std::vector<plate::LoadedSheet> read(const char* path) {
  std::ifstream file(path);
  std::vector<plate::LoadedSheet> sheets;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "sheet") {
      auto& sheet = sheets.emplace_back();
      words >> sheet.thickness >> sheet.poisson_ratio >> sheet.second_order >> sheet.split;
    } else if (kind == "edge") {
      auto& load = sheets.back().edge_loads.emplace_back();
      words >> load.from.x >> load.from.y >> load.to.x >> load.to.y >> load.in_plane.x >> load.in_plane.y >>
          load.out_of_plane >> load.moment;
    } else if (kind == "patch") {
      auto& load = sheets.back().patch_loads.emplace_back();
      words >> load.at.x >> load.at.y >> load.radius >> load.out_of_plane;
    } else if (kind == "outline") {
      for (Vec2 point; words >> point.x >> point.y;) sheets.back().outline.push_back(point);
    }
  }
  return sheets;
}

/// Mesh, membrane, bending, stress [s].
using Stages = std::array<double, 4>;

struct Sum {
  Stages seconds{};
  int n_solved = 0;
  int n_elements = 0;
};

void print_states(std::FILE* answers, const plate::LineProfile& line, const std::vector<plate::SheetPlace>& places) {
  const auto print = [&](const plate::SheetState& state) {
    const auto& [m, n, w] = state;
    std::fprintf(answers, "%.17g %.17g %.17g %.17g %.17g %.17g %.17g\n", m.xx, m.yy, m.xy, n.xx, n.yy, n.xy, w);
  };
  for (const plate::SheetState& state : line.state) print(state);
  for (const plate::SheetPlace& place : places) print(place.state);
}

/// Solves a sheet once; false where it has no solution.
bool measure(const plate::LoadedSheet& sheet, Stages& seconds, int& n_elements, std::FILE* answers) {
  const auto solution = plate::solve(sheet);
  if (!solution) return false;
  const std::clock_t start = std::clock();
  const auto line = solution->along({0.0, 0.0}, {1.0, 0.0}, kLine);
  const auto places = solution->at_nodes([](Vec2 place) { return norm(place) < kReach; });
  const auto& times = solution->times();
  seconds = {times.mesh, times.membrane, times.bending, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC};
  n_elements = solution->n_elements();
  if (answers != nullptr) print_states(answers, line, places);
  return true;
}

Sum run(const std::vector<plate::LoadedSheet>& sheets, plate::Accuracy accuracy, int repetitions, std::FILE* answers) {
  Sum sum;
  for (plate::LoadedSheet sheet : sheets) {
    sheet.accuracy = accuracy;
    Stages least{1.0, 1.0, 1.0, 1.0};
    int n_elements = 0;
    bool is_solved = true;
    if (answers != nullptr) std::fprintf(answers, "sheet\n");
    for (int i = 0; i < repetitions && is_solved; ++i) {
      Stages seconds{};
      is_solved = measure(sheet, seconds, n_elements, i == 0 ? answers : nullptr);
      for (std::size_t s = 0; s < seconds.size(); ++s) least[s] = std::min(least[s], seconds[s]);
    }
    if (!is_solved) continue;
    for (std::size_t s = 0; s < least.size(); ++s) sum.seconds[s] += least[s];
    sum.n_elements += n_elements;
    ++sum.n_solved;
  }
  return sum;
}

void print(const char* name, const Sum& sum, const char* end) {
  const auto mean = [&](double total) { return total / std::max(1, sum.n_solved); };
  const auto& [mesh, membrane, bending, stress] = sum.seconds;
  std::printf(
      "  \"%s\": {\"solved\": %d, \"elements\": %.0f, \"mesh_ms\": %.3f, \"membrane_ms\": %.3f, \"bending_ms\": %.3f, "
      "\"stress_ms\": %.3f, \"all_ms\": %.3f}%s\n",
      name, sum.n_solved, mean(sum.n_elements), 1e3 * mean(mesh), 1e3 * mean(membrane), 1e3 * mean(bending),
      1e3 * mean(stress), 1e3 * mean(mesh + membrane + bending + stress), end);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return EXIT_FAILURE;
  const auto sheets = read(argv[1]);
  const int repetitions = argc > 2 ? std::max(1, std::atoi(argv[2])) : 5;
  std::FILE* answers = argc > 3 ? std::fopen(argv[3], "w") : nullptr;
  std::printf("{\n");
  print("coarse", run(sheets, plate::Accuracy::kCoarse, repetitions, answers), ",");
  if (std::getenv("COARSE") == nullptr) print("fast", run(sheets, plate::Accuracy::kFast, repetitions, answers), "");
  std::printf("}\n");
  if (answers != nullptr) std::fclose(answers);
}
