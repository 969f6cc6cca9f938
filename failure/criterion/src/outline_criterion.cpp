// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "brash/plate/sheet.hpp"
#include "crack_path.hpp"
#include "criteria.hpp"
#include "outline_sheet.hpp"
#include "own_places.hpp"
#include "weak_places.hpp"

namespace brash::failure {
namespace {

/// A sheet is solved where the screen says more than the strength over this: docs/theory/simulation.md.
constexpr double kMargin = 6.0;
/// A sheet is solved again, with cubic elements, where quadratic ones find more than the strength over this.
constexpr double kCoarseMargin = 1.25;

/// The floating sheet with its free edge as it is, under all loads on it, solved for each load case.
class OutlineCriterion final : public BendingCriterion {
 public:
  OutlineCriterion(std::unique_ptr<BendingCriterion> screen, const IceProperties& ice, const BendingOptions& options)
      : screen_(std::move(screen)), ice_(ice), options_(options), l_c_(characteristic_length(ice)) {}

  bool needs_outline() const override { return true; }

  Assessment assess(const LoadCase& load) const override {
    expect_valid(load);
    if (load.pressure == 0.0) return unloaded(load);
    if (const auto harmless = dismiss(load)) return *harmless;
    model::SheetSolves solves;
    std::optional<Assessment> answer;
    if (load.outline.empty()) {
      ++solves.without_edge;
    } else {
      answer = screened(load, solves);
      if (!answer) ++solves.unsolved;
    }
    const bool refused = !answer;
    if (refused) {
      LoadCase alone = load;
      alone.outline.clear();
      alone.loads.clear();
      answer = screened(alone, solves);
      if (!answer) answer = screen_->assess(load);
    }
    answer->outline_refused = refused;
    answer->solves = solves;
    return *answer;
  }

  /// The answer of the trapezoid alone, if even with every load near B it stays far below the strength.
  std::optional<Assessment> dismiss(const LoadCase& load) const override {
    const Assessment quick = screen_->assess(load);
    const double own = load.mu1 * load.pressure * load.contact_length * ice_.thickness;
    double all = load.loads.empty() ? own : 0.0;
    for (const SheetLoad& other : load.loads) {
      all += (std::abs(other.out_of_plane) + std::abs(other.moment) / l_c_) *
             share_at(norm(0.5 * (other.from + other.to)) / l_c_);
    }
    const double most = kMargin * quick.sigma_max * std::max(1.0, all / own) / ice_.flexural_strength;
    if (quick.buckled || most > 1.0) return std::nullopt;
    return Assessment{.sigma_max = quick.sigma_max, .breaking_length = quick.breaking_length, .overload = most};
  }

  std::unique_ptr<BendingCriterion> for_ice(const IceProperties& ice) const override {
    return std::make_unique<OutlineCriterion>(screen_->for_ice(ice), ice, options_);
  }

 private:
  /// How a sheet is solved.
  struct How {
    bool split = false;
    plate::Accuracy accuracy = plate::Accuracy::kFast;
  };

  /// A solved sheet and its stresses on the centre line and beside it.
  struct Solved {
    plate::LoadedSheet sheet;
    plate::SheetSolution solution;
    Stresses stresses;
    WeakPlaces beside;
    double l_c = 0.0;     ///< of the sheet [m]
    double radial = 0.0;  ///< along the edge at B, over the strength

    /// The place that decides, if it lies beside the centre line.
    std::optional<WeakPlace> decisive() const {
      const std::optional<WeakPlace> weakest = beside.weakest();
      return weakest && weakest->stress > stresses.largest ? weakest : std::nullopt;
    }
    double largest() const { return decisive() ? decisive()->stress : stresses.largest; }
    double breaking_length() const {
      const std::optional<WeakPlace> place = decisive();
      return l_c * (place ? norm(place->at) : stresses.place);
    }
  };

  /// Where the ice would break under a load of this kind, however small.
  Assessment unloaded(LoadCase load) const {
    load.pressure = 1.0;
    load.loads.clear();
    model::SheetSolves solves;
    Assessment answer = judge(load, solves).value_or(screen_->assess(load));
    return {.breaking_length = answer.breaking_length};
  }

  /// As `judge`, with coarse elements where they show that the ice holds.
  std::optional<Assessment> screened(const LoadCase& load, model::SheetSolves& solves) const {
    if (options_.coarse_first)
      if (const auto holds = dismiss_coarsely(load, solves)) return holds;
    return judge(load, solves);
  }

  /// The answer of coarse elements where it stays below the strength, whole and, if a radial crack may come first,
  /// split. A split sheet has up to four times the stress of the whole one, so it is solved.
  std::optional<Assessment> dismiss_coarsely(const LoadCase& load, model::SheetSolves& solves) const {
    Assessment answer;
    const auto holds = [&](const std::optional<Solved>& sheet) {
      return sheet && !answer.buckled && kCoarseMargin * sheet->largest() <= 1.0;
    };
    How how{.accuracy = plate::Accuracy::kCoarse};
    const std::optional<Solved> coarse = solve(load, how, answer, solves);
    if (!holds(coarse)) return std::nullopt;
    std::optional<Solved> split;
    if (options_.radial_first && kCoarseMargin * coarse->radial > 1.0) {
      how.split = true;
      split = solve(load, how, answer, solves);
      if (!holds(split)) return std::nullopt;
      answer.split = coarse->radial > 1.0;
    }
    answer.overload = overload(*coarse, split);
    const Solved& decides = answer.split ? *split : *coarse;
    answer.sigma_max = decides.largest() * ice_.flexural_strength;
    answer.breaking_length = decides.breaking_length();
    return answer;
  }

  /// Nothing where the sheet cannot be meshed.
  std::optional<Assessment> judge(const LoadCase& load, model::SheetSolves& solves) const {
    Assessment answer;
    const std::optional<Solved> whole = solve(load, {}, answer, solves);
    if (!whole) return std::nullopt;
    std::optional<Solved> split;
    if (options_.radial_first && whole->radial > 1.0) {
      split = solve(load, {.split = true}, answer, solves);
      answer.split = split.has_value();
      solves.split_unsolved += split ? 0 : 1;
    }
    answer.overload = overload(*whole, split);
    const Solved& decides = split ? *split : *whole;
    answer.sigma_max = decides.largest() * ice_.flexural_strength;
    answer.fails = answer.buckled || answer.sigma_max > ice_.flexural_strength;
    answer.breaking_length = decides.breaking_length();
    if (answer.fails && options_.trace_crack) {
      trace(decides, answer);
      answer.fails = !answer.crack.empty();
      solves.holding_together += answer.fails ? 0 : 1;
    }
    return answer;
  }

  /// The ice fails where the whole sheet does, or where a radial crack opens and the split sheet fails.
  double overload(const Solved& whole, const std::optional<Solved>& split) const {
    if (!options_.radial_first) return whole.largest();
    return std::max(whole.largest(), split ? std::min(whole.radial, split->largest()) : whole.radial);
  }

  /// The crack, and the breaking length where it is not on the line already. Empty where no crack cuts B off.
  void trace(const Solved& solved, Assessment& answer) const {
    const auto& [sheet, solution, stresses, halves, l_c, radial] = solved;
    std::vector<Vec2> crack;
    if (const auto place = solved.decisive()) {
      const auto at = [](const std::optional<WeakPlace>& weak) {
        return weak ? std::optional(weak->at) : std::nullopt;
      };
      crack = sheet.split ? crack_through_halves(sheet, solution, at(halves.below), at(halves.above), 1.0)
                          : crack_through(sheet, solution, place->at, 1.0);
      if (const auto ahead = distance_ahead(crack))
        answer.breaking_length = l_c * *ahead;
      else
        crack.clear();  // it does not cut B off
    }
    if (crack.empty() && stresses.largest > 1.0) {
      crack = crack_from_line(sheet, solution, stresses.place, stresses.side);
      if (!crack.empty()) answer.breaking_length = l_c * stresses.place;
    }
    for (const Vec2 point : crack) answer.crack.push_back(l_c * point);
  }

  /// To first order if the plate buckles.
  std::optional<Solved> solve(const LoadCase& load, How how, Assessment& answer, model::SheetSolves& solves) const {
    const SheetMotion& motion = how.split ? load.motion.split : load.motion.whole;
    IceProperties ice = ice_;
    ice.water_density /= std::pow(motion.length, 4);  // l_c is shorter by `length`, and D stays
    plate::LoadedSheet sheet = loaded_sheet(load, ice, options_.second_order, motion.stress);
    sheet.split = how.split;
    sheet.accuracy = how.accuracy;
    ++(how.accuracy == plate::Accuracy::kCoarse ? solves.coarse : solves.cubic);
    solves.split += how.split ? 1 : 0;
    auto solution = plate::solve(sheet);
    if (!solution && solution.error().buckled) {
      answer.buckled = true;
      sheet.second_order = false;
      solution = plate::solve(sheet);
    }
    if (!solution) return std::nullopt;
    const OwnPlaces own(loads_of(load, ice_.thickness), ice_);
    const auto on_line = stresses_ahead(sheet, *solution, ice, own);
    if (!on_line && !options_.anywhere) return std::nullopt;
    const Stresses stresses = on_line.value_or(Stresses{});
    const WeakPlaces beside = options_.anywhere ? weak_places(sheet, *solution, ice, own) : WeakPlaces{};
    const double radial = motion.radial / motion.stress * stresses.radial_bending + stresses.radial_membrane;
    return Solved{std::move(sheet), std::move(*solution), stresses, beside, characteristic_length(ice), radial};
  }

  std::unique_ptr<BendingCriterion> screen_;
  IceProperties ice_;
  BendingOptions options_;
  double l_c_;
};

}  // namespace

std::unique_ptr<BendingCriterion> make_outline_criterion(std::unique_ptr<BendingCriterion> screen,
                                                         const IceProperties& ice, const BendingOptions& options) {
  return std::make_unique<OutlineCriterion>(std::move(screen), ice, options);
}

}  // namespace brash::failure
