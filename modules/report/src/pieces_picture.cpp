// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "brash/analysis/pieces.hpp"
#include "brash/report/pictures.hpp"
#include "chart.hpp"

namespace brash::report {
namespace {

using statistics::SizeFit;
using statistics::SizeLaw;
using Samples = std::vector<double>;

constexpr double kWidth = 380.0, kHeight = 300.0, kTop = 45.0;
constexpr const char* kNumber = "#1f4e79";
constexpr const char* kArea = "#b3261e";
constexpr std::array<const char*, 3> kColours{"#2e7d32", "#8e24aa", "#e65100"};

/// Pieces in the order of their size.
struct Sorted {
  Samples diameters, areas;
};

Sorted sorted(const analysis::PieceSizes& sizes) {
  std::vector<std::size_t> order(sizes.diameters.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return sizes.diameters[i]; });
  Sorted result;
  for (const std::size_t i : order) {
    result.diameters.push_back(sizes.diameters[i]);
    result.areas.push_back(sizes.areas[i]);
  }
  return result;
}

/// Logarithmic limits around all sizes.
ChartAxis axis_of_sizes(const Samples& diameters) {
  return {"mean caliper diameter [m]", diameters.front() / 1.15, diameters.back() * 1.15, true};
}

/// The share of pieces that a fit has above a size.
double share_above(const SizeFit& fit, double size, std::size_t n) {
  const double share = fit.law == SizeLaw::kPowerTail ? static_cast<double>(fit.n) / static_cast<double>(n) : 1.0;
  return share * fit.exceedance(size);
}

std::string share_of_larger(const Sorted& sizes, const analysis::PieceAnalysis& analysis) {
  constexpr int kPoints = 80;
  const std::size_t n = sizes.diameters.size();
  const ChartAxis x = axis_of_sizes(sizes.diameters);
  const double lowest = 0.5 / static_cast<double>(n);
  Chart chart(75.0, kTop, kWidth, kHeight, "share of larger pieces, by number", x, {"share", lowest, 1.6, true});
  for (std::size_t i = 0; i < n; ++i)
    chart.point(sizes.diameters[i], static_cast<double>(n - i) / static_cast<double>(n), kNumber, 2.0);
  double place = 0.0;
  for (const SizeFit& fit : analysis.fits) {
    Samples at, shares;
    const double from = fit.law == SizeLaw::kPowerTail ? fit.scale.value : x.lower;
    for (int i = 0; i <= kPoints; ++i) {
      const double size = from * std::pow(x.upper / from, static_cast<double>(i) / kPoints);
      const double share = share_above(fit, size, n);
      if (share < lowest) break;
      at.push_back(size);
      shares.push_back(share);
    }
    const char* colour = kColours[static_cast<std::size_t>(fit.law)];
    chart.line(at, shares, colour, 1.8);
    // The key is at the lower left, where the points never are.
    const double height = lowest * std::pow(1.6 / lowest, 0.05 + 0.06 * place);
    chart.words(x.lower * std::pow(x.upper / x.lower, 0.03), height,
                fmt::format("{}, p = {:.2g}", name_of(fit.law), fit.goodness.p_value), colour);
    place += 1.0;
  }
  return chart.svg();
}

std::string shares_in_smaller(const Sorted& sizes) {
  const double total = std::accumulate(sizes.areas.begin(), sizes.areas.end(), 0.0);
  const auto n = static_cast<double>(sizes.diameters.size());
  Samples x, number, area;
  double sum = 0.0;
  for (std::size_t i = 0; i < sizes.diameters.size(); ++i) {
    for (const bool after : {false, true}) {  // a stair
      if (after) sum += sizes.areas[i];
      x.push_back(sizes.diameters[i]);
      number.push_back((static_cast<double>(i) + (after ? 1.0 : 0.0)) / n);
      area.push_back(sum / total);
    }
  }
  const ChartAxis axis = axis_of_sizes(sizes.diameters);
  Chart chart(545.0, kTop, kWidth, kHeight, "share in smaller pieces", axis, {"share", 0.0, 1.0});
  chart.line(x, number, kNumber, 1.8);
  chart.line(x, area, kArea, 1.8);
  const double left = axis.lower * std::pow(axis.upper / axis.lower, 0.03);
  chart.words(left, 0.93, "of the number", kNumber);
  chart.words(left, 0.87, "of the area", kArea);
  return chart.svg();
}

}  // namespace

std::string pieces_picture(const analysis::PieceSizes& sizes, const analysis::PieceAnalysis& analysis) {
  const Sorted in_order = sorted(sizes);
  return svg_page(960.0, 395.0, share_of_larger(in_order, analysis) + shares_in_smaller(in_order));
}

}  // namespace brash::report
