// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded sheets of tests/corpus/sheets against solutions on much finer meshes, by FreeFem++ where it has solved
// them.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "sheet_answer.hpp"

namespace {

using namespace brash;
using testing::RecordedSheet;
using testing::SheetReference;

/// The bounds were chosen before the answers were known.
constexpr double kFastError = 0.03, kCoarseError = 0.10;  ///< of the largest stress, in 95 of 100 sheets
constexpr double kMedianLength = 0.03, kLength = 0.20;    ///< of the place's distance from B, 50 and 90 of 100 [l_c]
constexpr double kNearOne = 0.05;                         ///< closer to the strength, a verdict may differ

std::vector<RecordedSheet> corpus() {
  std::vector<RecordedSheet> all;
  for (const char* file : {"cone", "ship", "pile"}) {
    const auto sheets = testing::read_sheets(std::string(BRASH_SOURCE_DIR "/tests/corpus/sheets/") + file + ".txt");
    all.insert(all.end(), sheets.begin(), sheets.end());
  }
  return all;
}

/// The independent solution of the whole or the split sheet, or the one of the fine mesh where there is no other.
const SheetReference* reference(const RecordedSheet& sheet, bool split) {
  for (const std::string kind : {"independent", "fine"}) {
    const auto found = sheet.references.find(kind + (split ? " split" : " whole"));
    if (found != sheet.references.end()) return &found->second;
  }
  return nullptr;
}

/// Against the references.
struct Errors {
  std::vector<double> stress, length;
  int n_unsolved = 0;
};

Errors errors_of(plate::Accuracy accuracy) {
  Errors errors;
  for (const RecordedSheet& sheet : corpus()) {
    for (const bool split : {false, true}) {
      const SheetReference* known = reference(sheet, split);
      if (!known) continue;
      const auto answer = testing::solve_recorded(sheet, split, accuracy);
      if (!answer) {
        ++errors.n_unsolved;
        continue;
      }
      if (known->ratio == 0.0) {  // every place belongs to stronger loads, but for corners as small as an element
        BOOST_TEST(answer->ratio < kNearOne);
        continue;
      }
      const double l_c = failure::characteristic_length(sheet.ice);
      errors.stress.push_back(std::abs(answer->ratio / known->ratio - 1.0));
      errors.length.push_back(std::abs(norm(answer->place) - norm(known->place)) / l_c);
    }
  }
  return errors;
}

const Errors& errors_of_fast() {
  static const Errors errors = errors_of(plate::Accuracy::kFast);
  return errors;
}

const Errors& errors_of_coarse() {
  static const Errors errors = errors_of(plate::Accuracy::kCoarse);
  return errors;
}

BOOST_AUTO_TEST_CASE(every_sheet_is_solved) {
  BOOST_TEST(errors_of_fast().stress.size() > 100u);
  BOOST_TEST(errors_of_fast().n_unsolved == 0);
  BOOST_TEST(errors_of_coarse().n_unsolved == 0);
}

BOOST_AUTO_TEST_CASE(the_fast_mesh_finds_the_place) {
  BOOST_TEST(testing::quantile(errors_of_fast().length, 0.5) < kMedianLength);
  BOOST_TEST(testing::quantile(errors_of_fast().length, 0.9) < kLength);
}

BOOST_AUTO_TEST_CASE(the_coarse_mesh_finds_the_stress) {
  BOOST_TEST(testing::quantile(errors_of_coarse().stress, 0.95) < kCoarseError);
}

BOOST_AUTO_TEST_CASE(the_fast_mesh_finds_the_stress) {
  BOOST_TEST(testing::quantile(errors_of_fast().stress, 0.95) < kFastError);
}

/// Whether the ice breaks; a radial crack comes first where the stress along the edge at B exceeds the strength.
bool breaks(const RecordedSheet& sheet, bool radial_first) {
  const SheetReference* split = reference(sheet, true);
  return (radial_first && split ? split : reference(sheet, false))->ratio > 1.0;
}

bool is_clear(const RecordedSheet& sheet) {
  const SheetReference *whole = reference(sheet, false), *split = reference(sheet, true);
  const auto near_one = [](double ratio) { return std::abs(ratio - 1.0) < kNearOne; };
  if (near_one(whole->radial) && split && breaks(sheet, true) != breaks(sheet, false)) return false;
  return !near_one((whole->radial > 1.0 && split ? split : whole)->ratio);
}

BOOST_AUTO_TEST_CASE(the_verdict_is_that_of_the_fine_solution) {
  const auto shared = failure::make_criterion(
      model::FailureModel::kPlateOutline, "", corpus().front().ice,
      {.second_order = true, .radial_first = true, .anywhere = true, .coarse_first = true, .trace_crack = true});
  int n_clear = 0;
  for (const RecordedSheet& sheet : corpus()) {
    if (!reference(sheet, false) || !is_clear(sheet)) continue;
    ++n_clear;
    const auto criterion = shared->for_ice(sheet.ice);  // reads no model again
    const failure::Assessment answer = criterion->assess(sheet.load);
    BOOST_TEST_CONTEXT(sheet.name << ", stress over strength " << answer.sigma_max / sheet.ice.flexural_strength) {
      BOOST_TEST(!answer.outline_refused);
      BOOST_TEST(answer.solves.split_unsolved == 0);
      BOOST_TEST(answer.fails == breaks(sheet, reference(sheet, false)->radial > 1.0));
    }
  }
  BOOST_TEST(n_clear > 50);
}

}  // namespace
