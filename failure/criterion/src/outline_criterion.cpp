// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <vector>

#include "brash/plate/plate.hpp"
#include "criteria.hpp"
#include "last_solved.hpp"

namespace brash::failure {
namespace {

/// Vertices of the edge nearer than this to the simplified one are left out, over l_c. The stress of a plate does not
/// see features of the edge that are small against l_c, unless they are of the size of the contact.
constexpr double kTolerance = 0.02;
/// The same over c.
constexpr double kContactTolerance = 0.25;
/// Where the ends of the contact are looked for [m]: the cell of the geometry's grid is a thousand times smaller.
constexpr double kSamePlace = 1e-6;

using Polyline = std::vector<Vec2>;
using Solution = tl::expected<plate::UnitProfiles, plate::PlateError>;

double distance(Vec2 point, Vec2 from, Vec2 to) {
  const Vec2 along = to - from;
  const double square = dot(along, along);
  const double s = square > 0.0 ? std::clamp(dot(point - from, along) / square, 0.0, 1.0) : 0.0;
  return norm(point - (from + s * along));
}

/// Appends the vertices of `line` after `first` up to `last` that simplification keeps (Douglas and Peucker).
void simplify(const Polyline& line, std::size_t first, std::size_t last, double tolerance, Polyline& kept) {
  std::size_t farthest = first;
  double most = tolerance;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double off = distance(line[i], line[first], line[last]);
    if (off > most) {
      most = off;
      farthest = i;
    }
  }
  if (farthest == first) {
    kept.push_back(line[last]);
    return;
  }
  simplify(line, first, farthest, tolerance, kept);
  simplify(line, farthest, last, tolerance, kept);
}

/// Number of the vertex at (0, -c/2) with (0, c/2) after it.
std::optional<std::size_t> contact_of(const Polyline& edge, double contact_length) {
  const Vec2 end{0.0, 0.5 * contact_length};
  for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
    if (norm(edge[i] + end) < kSamePlace && norm(edge[i + 1] - end) < kSamePlace) return i;
  }
  return std::nullopt;
}

/// The edge over l_c, simplified on both sides of the contact; nothing where it does not hold the contact.
std::optional<Polyline> plate_edge(const LoadCase& load, double l_c) {
  const auto contact = contact_of(load.outline, load.contact_length);
  if (!contact) return std::nullopt;
  const double tolerance = std::min(kTolerance * l_c, kContactTolerance * load.contact_length);
  Polyline kept{load.outline.front()};
  if (*contact > 0) simplify(load.outline, 0, *contact, tolerance, kept);
  kept.push_back(load.outline[*contact + 1]);
  if (*contact + 2 < load.outline.size()) {
    simplify(load.outline, *contact + 1, load.outline.size() - 1, tolerance, kept);
  }
  for (Vec2& point : kept) point = point / l_c;
  return kept;
}

/// The floating plate with the free edge as it is, solved for each load case; the trapezoid where that edge is refused.
class OutlineCriterion final : public BendingCriterion {
 public:
  OutlineCriterion(const IceProperties& ice, const BendingOptions& options)
      : ice_(ice),
        options_(options),
        l_c_(characteristic_length(ice)),
        trapezoid_(make_plate_criterion(ice, options)) {}

  bool needs_outline() const override { return true; }

  Assessment assess(const LoadCase& load) const override {
    expect_valid(load);
    if (const auto answer = assess_outline(load)) return *answer;
    Assessment answer = trapezoid_->assess(load);
    answer.outline_refused = true;
    return answer;
  }

 private:
  std::optional<Assessment> assess_outline(const LoadCase& load) const {
    const auto edge = plate_edge(load, l_c_);
    if (!edge) return std::nullopt;
    const double thickness_over_lc = ice_.thickness / l_c_;
    plate::OutlinePlate sheet{.outline = *edge,
                              .contact_length = load.contact_length / l_c_,
                              .thickness = thickness_over_lc,
                              .poisson_ratio = ice_.poisson_ratio,
                              .in_plane_load = in_plane_load(ice_, l_c_, load.pressure, options_)};
    auto profiles = solve(sheet);
    const bool buckled = !profiles && profiles.error().buckled;
    if (buckled) {
      sheet.in_plane_load = 0.0;
      profiles = solve(sheet);
    }
    if (!profiles) return std::nullopt;
    const plate::Response r = plate::respond(*profiles, thickness_over_lc, load.mu1, load.mu2);
    const double sigma = r.sigma_over_p * load.pressure;
    return Assessment{.fails = buckled || sigma > ice_.flexural_strength,
                      .sigma_max = sigma,
                      .breaking_length = r.lbreak_over_lc * l_c_,
                      .buckled = buckled};
  }

  Solution solve(const plate::OutlinePlate& sheet) const {
    return last_.get(sheet, [](const plate::OutlinePlate& fresh) { return plate::solve_outline(fresh); });
  }

  IceProperties ice_;
  BendingOptions options_;
  double l_c_;
  std::unique_ptr<BendingCriterion> trapezoid_;
  mutable LastSolved<plate::OutlinePlate, Solution> last_;
};

}  // namespace

std::unique_ptr<BendingCriterion> make_outline_criterion(const IceProperties& ice, const BendingOptions& options) {
  return std::make_unique<OutlineCriterion>(ice, options);
}

}  // namespace brash::failure
