// SPDX-License-Identifier: GPL-3.0-or-later
// Not a test: solves recorded sheets on every mesh of the program.
//
//   corpus_study FILE          prints each sheet with its references and its answers on the coarse and the fast mesh
//   corpus_study --fine FILE   writes the file again to the standard output, with the answers of the fine mesh
//   corpus_study --finer FILE  prints the answers of the fine mesh and of elements half as large

#include <cstdio>
#include <fstream>
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

void compare(const RecordedSheet& sheet) {
  for (const bool split : {false, true}) {
    const std::string of = split ? " split" : " whole";
    const auto fine = reference(sheet, "fine" + of);
    if (!fine) continue;
    std::printf("%s%s", sheet.name.c_str(), of.c_str());
    print("recorded", reference(sheet, "recorded" + of));
    print("coarse", testing::solve_recorded(sheet, split, plate::Accuracy::kCoarse));
    print("fast", testing::solve_recorded(sheet, split, plate::Accuracy::kFast));
    print("fine", fine);
    print("independent", reference(sheet, "independent" + of));
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

}  // namespace

int main(int argc, char** argv) {
  const std::string option = argc > 2 ? argv[1] : "";
  if (argc < 2) return std::fprintf(stderr, "Expected a file of tests/corpus/sheets.\n"), 1;
  const std::string path = argv[argc - 1];
  std::vector<RecordedSheet> sheets = testing::read_sheets(path);
  if (option == "--fine") copy_head(path);
  for (RecordedSheet& sheet : sheets) {
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
