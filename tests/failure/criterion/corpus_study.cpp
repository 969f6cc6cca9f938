// SPDX-License-Identifier: GPL-3.0-or-later
// Not a test: solves recorded sheets on every mesh of the program.
//
//   corpus_study FILE...       prints answers of all meshes, and the quantiles of their errors against FreeFem++
//   corpus_study --fine FILE   writes the file again to the standard output, with the answers of the fine mesh
//   corpus_study --finer FILE  prints the answers of the fine mesh and of elements half as large

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sheet_answer.hpp"
#include "sheet_domain.hpp"

namespace brash::plate {

/// All sizes of the mesh are multiplied by this.
static double mesh_scale = 1.0;

// The linker's option --wrap leads each call of sizes_of() here.
SheetSizes real_sizes_of(Accuracy) asm("__real__ZN5brash5plate8sizes_ofENS0_8AccuracyE");
SheetSizes scaled_sizes_of(Accuracy) asm("__wrap__ZN5brash5plate8sizes_ofENS0_8AccuracyE");
SheetSizes scaled_sizes_of(Accuracy accuracy) {
  SheetSizes sizes = real_sizes_of(accuracy);
  for (double* size : {&sizes.tip, &sizes.tip_share, &sizes.root, &sizes.side, &sizes.centre, &sizes.crack,
                       &sizes.gradation, &sizes.tolerance.near})
    *size *= mesh_scale;
  sizes.most_vertices = static_cast<int>(sizes.most_vertices / (mesh_scale * mesh_scale));
  return sizes;
}

}  // namespace brash::plate

namespace {

using namespace brash;
using testing::RecordedSheet;
using testing::SheetReference;

/// A split sheet is of interest where a radial crack is near.
constexpr double kNearRadial = 0.75;

void print(const char* kind, const std::optional<SheetReference>& answer) {
  if (answer)
    std::printf(" %s %.5f %.3f %.3f %.5f", kind, answer->ratio, answer->place.x, answer->place.y, answer->radial);
  else
    std::printf(" %s - - - -", kind);
}

std::optional<SheetReference> reference(const RecordedSheet& sheet, const std::string& kind) {
  const auto found = sheet.references.find(kind);
  return found == sheet.references.end() ? std::nullopt : std::optional(found->second);
}

/// Errors of one mesh against the independent solution.
struct Errors {
  std::vector<double> stress;  ///< of the largest stress
  std::vector<double> length;  ///< of its place's distance from B [l_c]

  void add(const SheetReference& answer, const SheetReference& known, double l_c) {
    stress.push_back(std::abs(answer.ratio / known.ratio - 1.0));
    length.push_back(std::abs(norm(answer.place) - norm(known.place)) / l_c);
  }
  void print(const std::string& name) const {
    if (stress.empty()) return;
    std::printf("%-32s %4zu ", name.c_str(), stress.size());
    for (const double share : {0.5, 0.9, 0.95, 1.0}) std::printf(" %6.2f %%", 100.0 * testing::quantile(stress, share));
    for (const double share : {0.5, 0.9, 1.0}) std::printf(" %6.3f", testing::quantile(length, share));
    std::printf("\n");
  }
};

/// By mesh, sheet and place.
std::map<std::string, Errors> all_errors;

void compare(const RecordedSheet& sheet) {
  for (const bool split : {false, true}) {
    const std::string of = split ? " split" : " whole";
    const auto known = reference(sheet, "independent" + of);
    if (!known) continue;
    std::printf("%s%s", sheet.name.c_str(), of.c_str());
    print("independent", known);
    const std::string place = testing::is_at_limit(sheet, known->place) ? ", at the limit" : ", elsewhere";
    const auto add = [&](const std::string& mesh, const std::optional<SheetReference>& answer) {
      print(mesh.c_str(), answer);
      if (!answer || known->ratio == 0.0) return;
      const double l_c = failure::characteristic_length(sheet.ice);
      for (const std::string& name : {mesh + of, mesh + place, mesh + ", all"})
        all_errors[name].add(*answer, *known, l_c);
    };
    add("recorded", reference(sheet, "recorded" + of));
    add("coarse", testing::solve_recorded(sheet, split, plate::Accuracy::kCoarse));
    add("fast", testing::solve_recorded(sheet, split, plate::Accuracy::kFast));
    add("fine", reference(sheet, "fine" + of));
    std::printf("\n");
    std::fflush(stdout);
  }
}

void add_fine(RecordedSheet& sheet) {
  const auto whole = testing::solve_recorded(sheet, false, plate::Accuracy::kFine);
  if (!whole) return;
  sheet.references["fine whole"] = *whole;
  if (whole->radial < kNearRadial) return;
  if (const auto split = testing::solve_recorded(sheet, true, plate::Accuracy::kFine))
    sheet.references["fine split"] = *split;
}

/// The comment at the top of a file, and its ice.
void copy_head(const std::string& path) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line) && line.rfind("sheet", 0) != 0;) std::printf("%s\n", line.c_str());
}

void compare_with_finer(const RecordedSheet& sheet) {
  const auto fine = reference(sheet, "fine whole");
  if (!fine) return;
  plate::mesh_scale = 0.5;
  const auto finer = testing::solve_recorded(sheet, false, plate::Accuracy::kFine);
  std::printf("%s", sheet.name.c_str());
  print("fine", fine);
  print("finer", finer);
  std::printf("\n");
  std::fflush(stdout);
}

void study(const std::string& option, const std::string& path) {
  if (option == "--fine") copy_head(path);
  for (RecordedSheet& sheet : testing::read_sheets(path)) {
    if (option == "--fine") {
      add_fine(sheet);
      testing::write_sheet(stdout, sheet);
    } else if (option == "--finer") {
      compare_with_finer(sheet);
    } else {
      compare(sheet);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string option = argc > 1 && argv[1][0] == '-' ? argv[1] : "";
  const int first = option.empty() ? 1 : 2;
  if (argc <= first) return std::fprintf(stderr, "Expected a file of tests/corpus/sheets.\n"), 1;
  for (int i = first; i < argc; ++i) study(option, argv[i]);
  if (!all_errors.empty())
    std::printf("%-32s %4s  %s\n", "mesh and sheet", "n", "stress: 50, 90, 95, 100 %; length over l_c: 50, 90, 100 %");
  for (const auto& [name, errors] : all_errors) errors.print(name);
}
