// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/ice/variation.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "level_ice.hpp"

namespace {

using namespace brash;
using namespace brash::ice;
using namespace brash::ice::testing;

constexpr double kLength = 3.0;

model::Case varied(double of_thickness, double of_strength, std::uint64_t seed = 1) {
  model::Case c;
  c.name = "varied";
  c.ice.thickness = properties().thickness;
  c.ice.flexural_strength = properties().flexural_strength;
  c.ice.variation = {of_thickness, of_strength, kLength};
  c.field.length = c.field.width = 50.0;
  c.random.seed = seed;
  return c;
}

GaussianField field(std::uint64_t seed) { return {kLength, {seed, "case", 0, "thickness"}}; }

/// Mean and variance of values, and the mean of products of pairs.
struct Moments {
  double n = 0.0, sum = 0.0, squares = 0.0;

  void add(double x) {
    n += 1.0;
    sum += x;
    squares += x * x;
  }
  double mean() const { return sum / n; }
  double variance() const { return squares / n - mean() * mean(); }
};

BOOST_AUTO_TEST_SUITE(variation)

/// Over many fields, at one place and at two: within four standard errors of the law.
BOOST_AUTO_TEST_CASE(fields_have_the_mean_the_deviation_and_the_correlation_of_their_law) {
  constexpr int kFields = 1000;
  const double of_root = 4.0 / std::sqrt(kFields);
  const std::vector<double> distances{0.25, 0.5, 1.0, 1.5, 2.5};
  Moments at_place;
  std::vector<Moments> products(2 * distances.size());
  for (int seed = 1; seed <= kFields; ++seed) {
    const GaussianField g = field(static_cast<std::uint64_t>(seed));
    const double here = g.at({10.0, -20.0});
    at_place.add(here);
    for (std::size_t i = 0; i < distances.size(); ++i) {
      products[2 * i].add(here * g.at({10.0 + kLength * distances[i], -20.0}));
      products[2 * i + 1].add(here * g.at(Vec2{10.0, -20.0} + kLength * distances[i] * Vec2{-0.6, 0.8}));
    }
  }
  BOOST_TEST(std::abs(at_place.mean()) < of_root);
  BOOST_TEST(std::abs(at_place.variance() - 1.0) < std::sqrt(2.0) * of_root);
  for (std::size_t i = 0; i < products.size(); ++i) {
    const double law = std::exp(-distances[i / 2] * distances[i / 2]);
    BOOST_TEST(std::abs(products[i].mean() - law) < std::sqrt(1.0 + law * law) * of_root);
  }
}

/// Of 120 x 120 correlation lengths, whose mean over so many independent places is known to 1 %.
BOOST_AUTO_TEST_CASE(one_field_over_a_large_sheet_has_them_too) {
  const GaussianField g = field(7);
  const int n = 240;
  const double spacing = 0.5 * kLength;
  Moments values, near, far;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Vec2 place{spacing * i, spacing * j};
      const double here = g.at(place);
      values.add(here);
      near.add(here * g.at(place + Vec2{spacing, 0.0}));
      far.add(here * g.at(place + Vec2{0.0, 3.0 * kLength}));
    }
  }
  BOOST_TEST(std::abs(values.mean()) < 0.05);
  BOOST_TEST(std::abs(values.variance() - 1.0) < 0.05);
  BOOST_TEST(std::abs(near.mean() - std::exp(-0.25)) < 0.05);
  BOOST_TEST(std::abs(far.mean()) < 0.1);  // 256 waves leave 1 / sqrt(2 * 256) = 0.044 in the correlation of one field
}

BOOST_AUTO_TEST_CASE(thickness_and_strength_are_log_normal_with_their_own_fields) {
  for (const double coefficient : {0.1, 0.5}) {
    Moments thickness, strength, both;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
      const failure::IceProperties here =
          Variation(varied(coefficient, coefficient, seed)).at(properties(), {3.0, 4.0});
      const double h = here.thickness / properties().thickness;
      const double s = here.flexural_strength / properties().flexural_strength;
      BOOST_REQUIRE(h > 0.0);
      BOOST_REQUIRE(s > 0.0);
      thickness.add(h);
      strength.add(s);
      both.add((h - 1.0) * (s - 1.0));
    }
    const double error = 4.0 * coefficient / std::sqrt(1000.0);
    for (const Moments& m : {thickness, strength}) {
      BOOST_TEST(std::abs(m.mean() - 1.0) < error);
      // The standard error of a log-normal deviation is larger than of a normal one.
      BOOST_TEST(std::abs(std::sqrt(m.variance()) - coefficient) < (1.0 + 2.0 * coefficient) * error);
    }
    BOOST_TEST(std::abs(both.mean()) < coefficient * error);
  }
}

BOOST_AUTO_TEST_CASE(a_field_is_a_function_of_seed_and_place_alone) {
  const Variation one(varied(0.1, 0.1)), again(varied(0.1, 0.1)), other(varied(0.1, 0.1, 2));
  const Vec2 a{1.0, 2.0}, b{30.0, -4.0};
  const double at_b = again.at(properties(), b).thickness;
  BOOST_TEST(one.at(properties(), a).thickness == again.at(properties(), a).thickness);
  BOOST_TEST(one.at(properties(), b).thickness == at_b);
  BOOST_TEST(one.at(properties(), a).flexural_strength == again.at(properties(), a).flexural_strength);
  BOOST_TEST(one.at(properties(), a).thickness != other.at(properties(), a).thickness);
}

/// Over many edges, at one place and a correlation length on: within four standard errors of the law.
BOOST_AUTO_TEST_CASE(a_rough_first_edge_has_its_deviation_and_correlation) {
  constexpr int kEdges = 1000;
  constexpr double kDeviation = 0.2;
  const double of_root = 4.0 / std::sqrt(kEdges);
  Moments at_place, product;
  for (int seed = 1; seed <= kEdges; ++seed) {
    model::Case c = varied(0.0, 0.0, static_cast<std::uint64_t>(seed));
    c.field.edge_roughness = kDeviation;
    c.field.edge_correlation_length = kLength;
    const Variation variation(c);
    BOOST_TEST(!variation);  // thickness and strength are even
    const std::vector<Vec2> edge = variation.first_edge(3.0 * kLength);
    BOOST_REQUIRE(edge.size() == 25u);  // eight chords in a correlation length
    BOOST_TEST(edge.front().y == 1.5 * kLength);
    BOOST_TEST(edge.back().y == -1.5 * kLength);
    at_place.add(edge[4].x / kDeviation);
    product.add(edge[4].x * edge[12].x / (kDeviation * kDeviation));
  }
  BOOST_TEST(std::abs(at_place.mean()) < of_root);
  BOOST_TEST(std::abs(at_place.variance() - 1.0) < std::sqrt(2.0) * of_root);
  BOOST_TEST(std::abs(product.mean() - std::exp(-1.0)) < 1.1 * of_root);
}

BOOST_AUTO_TEST_CASE(each_seed_and_replicate_has_a_first_edge_of_its_own) {
  model::Case c = varied(0.0, 0.0);
  BOOST_TEST(Variation(c).first_edge(10.0).size() == 2u);  // straight
  c.field.edge_roughness = 0.2;
  const std::vector<Vec2> edge = Variation(c).first_edge(10.0);
  BOOST_TEST(edge.size() > 2u);
  BOOST_TEST((Variation(c).first_edge(10.0) == edge));
  c.random.replicate = 1;
  BOOST_TEST((Variation(c).first_edge(10.0) != edge));
}

BOOST_AUTO_TEST_CASE(a_field_without_variation_is_even_ice) {
  const Variation none(varied(0.0, 0.0)), hardly(varied(1e-9, 1e-9));
  BOOST_TEST(!none);
  BOOST_TEST(none.at(properties(), {1.0, 2.0}).thickness == properties().thickness);
  const failure::IceProperties here = hardly.at(properties(), {1.0, 2.0});
  BOOST_TEST(here.thickness == properties().thickness, boost::test_tools::tolerance(1e-8));
  BOOST_TEST(here.flexural_strength == properties().flexural_strength, boost::test_tools::tolerance(1e-8));
  BOOST_TEST(here.youngs_modulus == properties().youngs_modulus);
}

BOOST_AUTO_TEST_CASE(a_piece_has_the_means_over_itself_and_keeps_them_when_it_splits) {
  const model::Case c = varied(0.15, 0.1);
  const Variation variation(c);
  Field ice(c.field, properties(), variation);
  Plate& sheet = ice.level_ice(0);
  const Broken broken = ice.break_off(sheet, circle(sheet, {0.0, 1.0}, 2.0, 3), kFarAway, 0.01);
  BOOST_REQUIRE(broken.pieces.size() == 3u);
  for (const Plate& piece : broken.pieces) {
    // Against a fine grid.
    const geometry::Polygon outline = piece.outline().front();
    Moments thickness, strength;
    for (const geometry::Ring& part : geometry::convex_parts(outline)) {
      for (double x = 0.0; x < 2.0; x += 0.02) {
        for (double y = -1.0; y < 3.0; y += 0.02) {
          const auto inside = [&](std::size_t i) {
            const Vec2 from = geometry::metres(part[i]), to = geometry::metres(part[(i + 1) % part.size()]);
            return cross(to - from, Vec2{x, y} - from) > 0.0;
          };
          bool is_inside = true;
          for (std::size_t i = 0; i < part.size(); ++i) is_inside = is_inside && inside(i);
          if (!is_inside) continue;
          const failure::IceProperties here = variation.at(properties(), {x, y});
          thickness.add(here.thickness);
          strength.add(here.flexural_strength);
        }
      }
    }
    BOOST_TEST(piece.ice().thickness == thickness.mean(), boost::test_tools::tolerance(3e-3));
    BOOST_TEST(piece.ice().flexural_strength == strength.mean(), boost::test_tools::tolerance(3e-3));
    BOOST_TEST(piece.ice().thickness != properties().thickness);
  }
  const Plate& whole = broken.pieces[1];
  const geometry::Extent around = geometry::extent(whole.outline().front());
  const double middle = 0.5 * (around.lower.y + around.upper.y);
  const std::vector<Plate> parts = ice.split(whole, {0.0, middle}, {1.0, middle}, 0.0);
  BOOST_REQUIRE(parts.size() >= 2u);
  for (const Plate& part : parts) BOOST_TEST(part.ice().thickness == whole.ice().thickness);
}

/// The mean over the places of a grid of 0.15 m inside a convex outline.
double mean_on_grid(const Variation& variation, const geometry::Ring& outline, double reach) {
  Moments thickness;
  for (double x = -reach; x < reach; x += 0.15) {
    for (double y = -reach; y < reach; y += 0.15) {
      bool is_inside = true;
      for (std::size_t i = 0; i < outline.size() && is_inside; ++i) {
        const Vec2 from = geometry::metres(outline[i]), to = geometry::metres(outline[(i + 1) % outline.size()]);
        is_inside = cross(to - from, Vec2{x, y} - from) > 0.0;
      }
      if (is_inside) thickness.add(variation.at(properties(), {x, y}).thickness);
    }
  }
  return thickness.mean();
}

/// A hexagon of ten correlation lengths. The means of its six triangles at the middles of their sides alone have twice
/// the deviation: 0.38 of the field's, against 0.18.
BOOST_AUTO_TEST_CASE(the_mean_over_a_floe_of_many_correlation_lengths_is_the_mean_over_all_places) {
  const geometry::Ring hexagon = geometry::disc({0.0, 0.0}, 18.6, 6);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Variation variation(varied(0.15, 0.0, seed));
    const double mean = variation.mean(properties(), {hexagon, {}}).thickness;
    // The grid misses its border by 0.07 m at random: of 900 m2, that is 1e-4 of the mean.
    BOOST_TEST(mean == mean_on_grid(variation, hexagon, 19.0), boost::test_tools::tolerance(5e-4));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
