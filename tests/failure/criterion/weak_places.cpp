// SPDX-License-Identifier: GPL-3.0-or-later
// Where a sheet is weakest beside its centre line, and the crack from there. Lengths over l_c.
#include "weak_places.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "crack_path.hpp"
#include "outline_sheet.hpp"
#include "own_places.hpp"

namespace {

using namespace brash;
namespace tt = boost::test_tools;

const failure::IceProperties kIce{
    .thickness = 0.33, .youngs_modulus = 0.35e9, .flexural_strength = 539e3, .compressive_strength = 1e6};
constexpr double kThickness = 0.1009;

/// A straight edge, pressed on `contact_length`.
plate::LoadedSheet straight(double contact_length, bool split, plate::Accuracy accuracy = plate::Accuracy::kFast) {
  const double half = 0.5 * contact_length, normal = 0.01;
  return {.outline = {{0.0, -8.0}, {0.0, -half}, {0.0, half}, {0.0, 8.0}},
          .edge_loads = {{{0.0, -half}, {0.0, half}, {normal, 0.0}, 0.511 * normal, 0.0}},
          .thickness = kThickness,
          .split = split,
          .accuracy = accuracy};
}

plate::SheetSolution solved(const plate::LoadedSheet& sheet) {
  auto solution = plate::solve(sheet);
  BOOST_REQUIRE(solution.has_value());
  return std::move(*solution);
}

struct Judged {
  failure::Stresses line;
  failure::WeakPlaces beside;
};

/// The loads of a sheet, the first one the own.
failure::OwnPlaces own_places(const plate::LoadedSheet& sheet) {
  const double l_c = failure::characteristic_length(kIce);
  std::vector<failure::SheetLoad> loads;
  for (const plate::EdgeLoad& load : sheet.edge_loads)
    loads.push_back({.from = l_c * load.from, .to = l_c * load.to, .out_of_plane = load.out_of_plane});
  return {loads, kIce};
}

Judged judged(const plate::LoadedSheet& sheet) {
  const plate::SheetSolution solution = solved(sheet);
  const auto line = failure::stresses_ahead(sheet, solution, kIce, own_places(sheet));
  BOOST_REQUIRE(line.has_value());
  return {*line, failure::weak_places(sheet, solution, kIce, own_places(sheet))};
}

BOOST_AUTO_TEST_CASE(a_split_sheet_bends_as_two_corners_about_their_bisectors) {
  // A force on the split edge gives each half one half of it, at the half's corner. The right angle that is loaded at
  // its truncated tip is the same corner. By symmetry the stress there is largest along the bisector or beside it, and
  // the line beside the crack carries far less.
  plate::LoadedSheet split = straight(0.02, true, plate::Accuracy::kFine);
  split.edge_loads.front().in_plane = {};
  split.edge_loads.front().out_of_plane = 2.0;
  plate::LoadedSheet corner = split;
  corner.split = false;
  corner.outline = {{4.0, -4.01}, {0.0, -0.01}, {0.0, 0.01}, {4.0, 4.01}};
  corner.edge_loads = {{{0.0, -0.01}, {0.0, 0.01}, {}, 1.0, 0.0}};
  const plate::SheetSolution halves = solved(split), tip = solved(corner);
  for (const double r : {0.4, 0.6, 0.8, 1.2}) {
    const auto state = halves.at({r / std::numbers::sqrt2, r / std::numbers::sqrt2});
    const auto known = tip.at({r - 0.01, 0.0});  // its sides meet 0.01 outside
    const auto crack = halves.at({r, 0.0});
    BOOST_REQUIRE((state && known && crack));
    const double here = failure::principal(state->moment), there = failure::principal(known->moment);
    BOOST_TEST_MESSAGE("r = " << r << ": " << here << ", corner " << there << ", at the crack "
                              << failure::principal(crack->moment));
    BOOST_TEST(here == there, tt::tolerance(0.03));
    if (r < 0.7) BOOST_TEST(failure::principal(crack->moment) < 0.7 * here);
  }
}

BOOST_AUTO_TEST_CASE(beside_the_centre_line_a_straight_edge_is_weaker) {
  // Largest stress beside the line over that on it, from a search of the fine mesh on a grid of 0.02.
  struct Known {
    double contact_length;
    bool split;
    double ratio;
  };
  for (const auto& [c, split, ratio] : {Known{0.3, false, 1.228}, Known{0.3, true, 1.732}, Known{0.5, false, 1.229},
                                        Known{0.5, true, 1.646}, Known{1.0, false, 1.214}, Known{1.0, true, 1.455}}) {
    for (const auto accuracy : {plate::Accuracy::kFast, plate::Accuracy::kFine}) {
      const Judged here = judged(straight(c, split, accuracy));
      const double found = here.beside.weakest()->stress / here.line.largest;
      BOOST_TEST_MESSAGE("c = " << c << " split " << split << ": " << found << ", known " << ratio);
      BOOST_TEST(found == ratio, tt::tolerance(accuracy == plate::Accuracy::kFine ? 0.01 : 0.04));
      // Both halves are alike.
      BOOST_TEST(here.beside.below->stress == here.beside.above->stress, tt::tolerance(0.04));
    }
  }
}

BOOST_AUTO_TEST_CASE(no_place_is_judged_nearer_than_h_to_a_load_the_edge_or_the_radial_crack) {
  for (const bool split : {false, true}) {
    const failure::WeakPlaces beside = judged(straight(0.3, split)).beside;
    for (const Vec2 at : {beside.below->at, beside.above->at}) {
      BOOST_TEST(at.x >= kThickness);
      BOOST_TEST(std::hypot(at.x, std::max(0.0, std::abs(at.y) - 0.15)) >= kThickness);
      if (split) BOOST_TEST(std::abs(at.y) >= kThickness);
    }
  }
}

/// A straight edge with the loads `p` [k l_c^3] at the places `y`, each on 0.3 l_c, the first one the own.
plate::LoadedSheet row(const std::vector<std::pair<double, double>>& loads) {
  const double own = loads.front().first;
  plate::LoadedSheet sheet{.outline = {{0.0, -8.0}, {0.0, 8.0}}, .thickness = kThickness};
  for (const auto& [y, p] : loads)
    sheet.edge_loads.push_back({{0.0, y - own - 0.15}, {0.0, y - own + 0.15}, {}, p, 0.0});
  return sheet;
}

/// The larger stress of line and sheet in one verdict.
double verdict(const plate::LoadedSheet& sheet) {
  const Judged here = judged(sheet);
  const auto weakest = here.beside.weakest();
  return std::max(here.line.largest, weakest ? weakest->stress : 0.0);
}

BOOST_AUTO_TEST_CASE(a_weak_load_does_not_break_the_ice_by_the_stress_of_a_strong_one) {
  const double alone = verdict(row({{0.0, 0.01}}));
  // The strong load acts upward, so it bends the other surface; and downward.
  for (const double strong : {-1.0, 1.0})
    BOOST_TEST(verdict(row({{0.0, 0.01}, {1.5, strong}})) < 3.0 * alone, "strong " << strong);
  // Metres away all of the ice that is looked at belongs to the strong one.
  BOOST_TEST(verdict(row({{0.0, 1e-4}, {1.5, 1.0}})) < 0.02 * verdict(row({{0.0, 1.0}})));
}

BOOST_AUTO_TEST_CASE(a_tiny_load_beside_a_strong_one_changes_no_answer) {
  const double alone = verdict(row({{0.0, 1.0}}));
  for (const double tiny : {-1e-9, 1e-9})
    for (const double y : {0.4, 0.8, 1.5})
      BOOST_TEST(verdict(row({{0.0, 1.0}, {y, tiny}})) == alone, tt::tolerance(0.03));
}

BOOST_AUTO_TEST_CASE(the_ice_beside_a_contact_without_a_verdict_is_checked_by_the_strong_one) {
  const plate::LoadedSheet sheet = row({{0.0, 1.0}, {0.9, 0.9}});
  const plate::SheetSolution solution = solved(sheet);
  const double l_c = failure::characteristic_length(kIce);
  std::vector<failure::SheetLoad> loads;
  for (const plate::EdgeLoad& load : sheet.edge_loads)
    loads.push_back({.from = l_c * load.from, .to = l_c * load.to, .out_of_plane = load.out_of_plane});
  const failure::OwnPlaces both(loads, kIce);
  loads[1].has_verdict = false;
  const failure::OwnPlaces strong(loads, kIce);
  const Vec2 beside{0.5 * l_c, 0.95 * l_c}, close{0.05 * l_c, 0.9 * l_c};
  BOOST_TEST(strong.contain(beside));
  BOOST_TEST(!both.contain(beside));
  BOOST_TEST(!strong.contain(close));  // nearer than h to a load plate theory says nothing
}

BOOST_AUTO_TEST_CASE(each_place_of_a_row_of_contacts_is_checked_once) {
  const std::vector<std::pair<double, double>> loads{{-2.0, 0.3}, {-0.7, 1.0}, {0.2, 0.6}, {1.1, 0.9}, {2.6, 0.5}};
  const double l_c = failure::characteristic_length(kIce);
  std::vector<failure::OwnPlaces> all;
  for (std::size_t own = 0; own < loads.size(); ++own) {
    std::vector<failure::SheetLoad> placed;
    for (const auto& [y, p] : loads)
      placed.push_back({.from = {0.0, l_c * (y - 0.15)}, .to = {0.0, l_c * (y + 0.15)}, .out_of_plane = p});
    std::swap(placed[0], placed[own]);
    all.emplace_back(placed, kIce);
  }
  for (double y = -4.0; y < 4.0; y += 0.11)
    for (double x = 0.3; x < 2.5; x += 0.1) {
      const auto has = [&](const failure::OwnPlaces& places) { return places.contain({l_c * x, l_c * y}); };
      BOOST_TEST(std::ranges::count_if(all, has) == 1);
    }
}

BOOST_AUTO_TEST_CASE(both_halves_of_a_split_sheet_crack_from_the_free_edge_to_the_radial_crack) {
  const plate::LoadedSheet sheet = straight(0.3, true);
  const plate::SheetSolution solution = solved(sheet);
  const failure::WeakPlaces beside = failure::weak_places(sheet, solution, kIce, own_places(sheet));
  const auto crack = failure::crack_through_halves(sheet, solution, beside.below->at, beside.above->at, 1.0);
  BOOST_REQUIRE(crack.size() > 10u);
  BOOST_TEST(crack.front().x < 0.0);
  BOOST_TEST(crack.front().y < 0.0);
  BOOST_TEST(crack.back().x < 0.0);
  BOOST_TEST(crack.back().y > 0.0);
  for (std::size_t i = 1; i + 1 < crack.size(); ++i) BOOST_TEST(crack[i].x > 0.0);
  // Alike on both sides, and as far along the radial crack as along the edge: the corner's own symmetry.
  const double ahead = failure::distance_ahead(crack).value();
  BOOST_TEST(-crack.front().y == crack.back().y, tt::tolerance(0.1));
  BOOST_TEST(ahead == crack.back().y, tt::tolerance(0.25));
}

BOOST_AUTO_TEST_CASE(the_crack_through_a_place_of_a_whole_sheet_runs_from_edge_to_edge) {
  const plate::LoadedSheet sheet = straight(0.3, false);
  const plate::SheetSolution solution = solved(sheet);
  const Vec2 place = failure::weak_places(sheet, solution, kIce, own_places(sheet)).weakest()->at;
  const auto crack = failure::crack_through(sheet, solution, place, 1.0);
  BOOST_REQUIRE(crack.size() > 10u);
  BOOST_TEST(crack.front().x < 0.0);
  BOOST_TEST(crack.back().x < 0.0);
  BOOST_TEST(crack.front().y < crack.back().y);
  BOOST_TEST(failure::distance_ahead(crack).has_value());
}

BOOST_AUTO_TEST_CASE(a_crack_cuts_off_the_ice_at_b_and_crosses_the_line_at_the_breaking_length) {
  const double l_c = failure::characteristic_length(kIce);
  const auto criterion =
      failure::make_criterion(model::FailureModel::kPlateOutline, "", kIce, {.anywhere = true, .trace_crack = true});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share;
  int n_cracks = 0;
  for (int edge = 0; edge < 60; ++edge) {
    // Teeth and bays beside a short contact.
    failure::LoadCase load{.contact_length = 0.2 * l_c, .mu1 = 0.511, .pressure = 2e6};
    std::vector<Vec2> above{{0.0, 0.1}}, below{{0.0, -0.1}};
    for (std::vector<Vec2>* side : {&above, &below})
      for (double y = 0.1 + 0.2 * share(random); y < 5.0; y += 0.2 + 0.6 * share(random))
        side->push_back({1.6 * share(random) - 0.3, side == &above ? y + 0.05 : -y - 0.05});
    load.outline.assign(below.rbegin(), below.rend());
    load.outline.insert(load.outline.end(), above.begin(), above.end());
    for (Vec2& point : load.outline) point = l_c * point;
    const failure::Assessment answer = criterion->assess(load);
    if (answer.crack.empty() || answer.outline_refused) continue;
    ++n_cracks;
    const auto ahead = failure::distance_ahead(answer.crack);
    BOOST_TEST_REQUIRE(ahead.has_value(), "edge " << edge);
    BOOST_TEST(answer.breaking_length == *ahead, tt::tolerance(1e-9));
  }
  BOOST_TEST_MESSAGE(n_cracks << " cracks");
  BOOST_TEST(n_cracks > 30);
}

BOOST_AUTO_TEST_CASE(the_criterion_judges_the_weaker_of_line_and_sheet) {
  const double l_c = failure::characteristic_length(kIce);
  failure::LoadCase load{.contact_length = 0.3 * l_c, .mu1 = 0.511, .pressure = 1e6};
  const auto judge = [&](bool anywhere, bool radial_first) {
    return failure::make_criterion(model::FailureModel::kPlateOutline, "", kIce,
                                   {.radial_first = radial_first, .anywhere = anywhere, .trace_crack = true})
        ->assess(load);
  };
  for (const bool radial_first : {false, true}) {
    const failure::Assessment line = judge(false, radial_first), sheet = judge(true, radial_first);
    BOOST_TEST(line.split == radial_first);
    BOOST_TEST(sheet.split == radial_first);
    BOOST_TEST(sheet.sigma_max > 1.15 * line.sigma_max);
    BOOST_TEST(sheet.fails);
    BOOST_TEST(sheet.breaking_length == l_c * failure::distance_ahead(sheet.crack).value() / l_c, tt::tolerance(1e-9));
    if (radial_first) BOOST_TEST(sheet.breaking_length < 0.75 * line.breaking_length);
  }
  // A narrow protrusion bends as a beam: the line says all.
  load.depth = 0.5 * l_c;
  load.contact_length = 0.1 * l_c;
  load.angle = 0.5;
  BOOST_TEST(judge(true, false).sigma_max == judge(false, false).sigma_max, tt::tolerance(0.02));
}

// Quadratic elements dismiss a sheet only where cubic ones do not break it, whole or split.
BOOST_AUTO_TEST_CASE(coarse_elements_first_give_the_same_verdict) {
  const double l_c = failure::characteristic_length(kIce);
  const auto criterion = [&](bool coarse_first) {
    return failure::make_criterion(
        model::FailureModel::kPlateOutline, "", kIce,
        {.second_order = true, .radial_first = true, .anywhere = true, .coarse_first = coarse_first});
  };
  const auto fine = criterion(false), coarse = criterion(true);
  int n_dismissed = 0;
  for (const double depth : {0.0, 0.4})
    for (const double length : {0.1, 0.4, 1.2})
      for (double pressure = 1e5; pressure < 2e6; pressure *= 1.15) {
        const failure::LoadCase load{.depth = depth * l_c,
                                     .contact_length = length * l_c,
                                     .angle = depth > 0.0 ? 1.0 : 0.0,
                                     .mu1 = 0.511,
                                     .pressure = pressure};
        const failure::Assessment exact = fine->assess(load), quick = coarse->assess(load);
        BOOST_TEST_CONTEXT("depth " << depth << ", length " << length << ", pressure " << pressure) {
          BOOST_TEST(quick.fails == exact.fails);
          if (exact.fails || quick.sigma_max == exact.sigma_max) {
            BOOST_TEST(quick.sigma_max == exact.sigma_max);
            BOOST_TEST(quick.breaking_length == exact.breaking_length);
          } else {
            ++n_dismissed;
            BOOST_TEST(quick.sigma_max == exact.sigma_max, tt::tolerance(0.1));
          }
        }
      }
  BOOST_TEST(n_dismissed > 10);
}

}  // namespace
