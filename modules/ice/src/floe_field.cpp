// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/ice/floe_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "brash/geometry/ice_sheet.hpp"
#include "floe_sizes.hpp"
#include "power_cells.hpp"
#include "random_placement.hpp"

namespace brash::ice {
namespace {

using geometry::Ring;

/// A field has no more floes than this: a run of half a million takes 8 GB, and some 10 s a step
/// (docs/performance.md).
constexpr std::size_t kMostFloes = 500'000;
/// Sides of a disc.
constexpr int kDiscSides = 24;
/// The sites of a Voronoi field are the centres of octagons of this share of their cells, placed at random: far below
/// the share at which random places run out, 0.55 for equal discs. It decides how even the cells' shapes are.
constexpr double kSeedShare = 0.42;
constexpr int kSeedSides = 8;
/// The cells of a Voronoi field leave this share of it free at least: their areas have that relative error.
constexpr double kLeastGap = 2.0 * kAreaError;
/// Steps of the concentration in which the reachable one is sought.
constexpr double kConcentrationStep = 0.05;

/// The cells of a power diagram, each shrunk about its centroid to its floe: docs/theory/ice.md, (F5). Empty
/// where the floes do not fit.
std::vector<Ring> eroded_cells(const Domain& domain, const std::vector<double>& areas,
                               statistics::RandomStream& random) {
  double sum = 0.0;
  for (const double area : areas) sum += area;
  if (sum > (1.0 - kLeastGap) * domain.area()) return {};  // the last floe is too large for the rest of the field
  std::vector<double> cell_areas, seed_areas;
  for (const double area : areas) {
    cell_areas.push_back(area / sum * domain.area());
    seed_areas.push_back(kSeedShare * cell_areas.back());
  }
  const std::vector<Ring> seeds = place_at_random(domain, seed_areas, kSeedSides, {}, random);
  if (seeds.empty()) return {};
  // A disc inside each octagon: no two discs meet, so each site has a cell.
  std::vector<Site> sites;
  for (std::size_t i = 0; i < seeds.size(); ++i)
    sites.push_back({geometry::centroid({seeds[i], {}}), seed_areas[i] / (kSeedSides * std::tan(kPi / kSeedSides))});
  const std::vector<std::vector<Vec2>> cells = cells_of_areas(domain, std::move(sites), cell_areas);
  std::vector<Ring> floes;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Vec2 centre = centroid_of(cells[i]);
    const double scale = std::sqrt(areas[i] / area_of(cells[i]));
    std::vector<geometry::Point> corners;
    for (const Vec2 corner : cells[i]) corners.push_back(geometry::snap(centre + scale * (corner - centre)));
    floes.push_back(convex_hull(std::move(corners)));
  }
  return floes;
}

std::vector<Ring> rings_of(const model::FloeFieldSection& floes, const Domain& domain, const std::vector<double>& areas,
                           std::span<const Ring> keep_out, statistics::RandomStream& random) {
  switch (floes.shape) {
    case model::FloeShape::kVoronoi:
      return eroded_cells(domain, areas, random);
    case model::FloeShape::kSquares:
      return place_at_random(domain, areas, 4, keep_out, random);
    case model::FloeShape::kDiscs:
      return place_at_random(domain, areas, kDiscSides, keep_out, random);
  }
  BRASH_EXPECTS(false, static_cast<int>(floes.shape));
  return {};
}

/// Area of the field that the convex `keep_out` cover; rings of one structure do overlap, and count once.
double covered(const Domain& domain, std::span<const Ring> keep_out) {
  const double half = 0.5 * domain.width;
  const std::vector<Vec2> corners{{0.0, -half}, {domain.length, -half}, {domain.length, half}, {0.0, half}};
  const geometry::Polygon rectangle{geometry::ring(corners), {}};
  auto sheet = geometry::IceSheet::from_polygons(std::span(&rectangle, 1));
  BRASH_EXPECTS(sheet.has_value(), "a rectangle");
  for (const Ring& ring : keep_out) (void)sheet->cut(ring);
  return domain.area() - sheet->area().square_metres();
}

/// The floes outside `keep_out`; they overlap nowhere.
FloePacking checked(std::vector<Ring> rings, const Domain& domain, std::span<const Ring> keep_out) {
  FloePacking packing;
  PlacedRings placed(domain, std::sqrt(domain.area() / static_cast<double>(rings.size())));
  geometry::ExactArea area;
  for (Ring& ring : rings) {
    if (std::ranges::any_of(keep_out, [&](const Ring& other) { return overlap(ring, other); })) {
      ++packing.n_left_out;
      continue;
    }
    BRASH_EXPECTS(!placed.meets(ring), packing.floes.size());
    placed.add(ring);
    area += geometry::signed_area(ring);
    packing.floes.push_back({std::move(ring), {}});
  }
  packing.concentration = area.square_metres() / (domain.area() - covered(domain, keep_out));
  return packing;
}

std::optional<FloePacking> try_to_pack(const model::FieldSection& field, const std::vector<double>& areas,
                                       std::span<const Ring> keep_out, statistics::RandomStream& random) {
  const Domain domain{field.length, field.width};
  std::vector<Ring> rings = rings_of(field.floes, domain, areas, keep_out, random);
  if (rings.empty()) return std::nullopt;
  return checked(std::move(rings), domain, keep_out);
}

/// The error of a field that would have about `n` floes.
FloeFieldError too_many(double n, const model::FloeSizes& sizes) {
  constexpr double kSmall = 1.0, kCentimetres = 100.0;  // a median of less than a metre may be a number in cm
  const double stated = stated_size(sizes), digits = std::pow(10.0, std::floor(std::log10(n)) - 1.0);
  const std::string meant = stated < kSmall ? fmt::format("; the sizes begin with {:.3g} m: was {:.3g} m meant?",
                                                          stated, kCentimetres * stated)
                                            : "";
  return {"field.concentration",
          fmt::format("takes about {:.0f} floes of these sizes", std::round(n / digits) * digits),
          fmt::format("at most {} floes", kMostFloes), "raise field.size, or make the field smaller" + meant};
}

}  // namespace

double size_of(const geometry::Polygon& floe) { return std::sqrt(geometry::area(floe).square_metres()); }

double expected_floes(const model::FieldSection& field) {
  return field.floes.concentration.value() * field.length * field.width / mean_area(field.floes.size);
}

tl::expected<FloePacking, FloeFieldError> pack_floes(const model::FieldSection& field, std::span<const Ring> keep_out,
                                                     statistics::RandomStream random) {
  std::vector<Ring> kept_out;
  for (const Ring& ring : keep_out) kept_out.push_back(convex_hull(ring));
  keep_out = kept_out;
  const double asked = field.floes.concentration.value();
  const bool at_random = field.floes.shape != model::FloeShape::kVoronoi;
  const double free = field.length * field.width - (at_random ? covered({field.length, field.width}, keep_out) : 0.0);
  const double expected = asked * free / mean_area(field.floes.size);
  if (expected > static_cast<double>(kMostFloes)) return tl::unexpected(too_many(expected, field.floes.size));
  const auto error = [](std::string what, std::string allowed, std::string remedy) {
    return tl::unexpected(
        FloeFieldError{"field.concentration", std::move(what), std::move(allowed), std::move(remedy)});
  };
  const int n_steps = static_cast<int>(asked / kConcentrationStep) + 1;
  for (int step = 0; step < n_steps; ++step) {
    const double concentration = asked - step * kConcentrationStep;
    const auto areas = draw_areas(field.floes.size, concentration * free, kMostFloes, random);
    if (!areas) return tl::unexpected(too_many(expected, field.floes.size));
    std::optional<FloePacking> packing = try_to_pack(field, *areas, keep_out, random);
    if (packing && step == 0) return std::move(*packing);
    if (packing)
      return error("is more than floes of this shape and these sizes reach at random places",
                   fmt::format("at most {:.3g}, which was reached", std::min(packing->concentration, concentration)),
                   at_random ? "lower it, spread the sizes, or take field.shape = \"voronoi\""
                             : "lower it or field.size, enlarge the field, or take another random.seed");
  }
  return error("finds no place for one floe", "floes smaller than the field", "lower field.size, or enlarge the field");
}

}  // namespace brash::ice
