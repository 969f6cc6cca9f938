// SPDX-License-Identifier: GPL-3.0-or-later
#include "floe_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/ice/floe_field.hpp"

namespace brash::ice {
namespace {

/// docs/theory/ice.md, (F2): P(size <= L) = (l^-a - L^-a) / (l^-a - m^-a) between the limits l and m, inverted.
double power_law(const model::FloeSizes& law, double share) {
  const double a = law.exponent, least = law.least.value(), largest = law.largest.value();
  if (a == 0.0) return least * std::pow(largest / least, share);
  const double span = 1.0 - std::pow(largest / least, -a);
  return least * std::pow(1.0 - share * span, -1.0 / a);
}

/// The mean of L^2 over the density a L^(-a - 1) / (l^-a - m^-a) between the limits l and m of (F2).
double mean_area_of_power_law(const model::FloeSizes& law) {
  const double a = law.exponent, least = law.least.value(), largest = law.largest.value();
  if (least == largest) return least * least;
  // The integral of L^(n - 1) from l to m, over l^n.
  const auto integral = [&](double n) {
    const double ratio = std::log(largest / least);
    return std::abs(n) * ratio < 1e-9 ? ratio : std::expm1(n * ratio) / n;
  };
  return least * least * integral(2.0 - a) / integral(-a);
}

double draw(const model::FloeSizes& law, statistics::RandomStream& random) {
  switch (law.kind) {
    case model::SizeLaw::kPowerLaw:
      return power_law(law, random.uniform());
    case model::SizeLaw::kLogNormal:
      return law.median.value() * std::exp(law.deviation * random.normal());  // ice.md, (F3)
    case model::SizeLaw::kList:
      return law.values[static_cast<std::size_t>(random.uniform_int(0, static_cast<int>(law.values.size()) - 1))];
  }
  BRASH_EXPECTS(false, static_cast<int>(law.kind));
  return 0.0;
}

}  // namespace

double mean_area(const model::FloeSizes& law) {
  switch (law.kind) {
    case model::SizeLaw::kPowerLaw:
      return mean_area_of_power_law(law);
    case model::SizeLaw::kLogNormal:
      return law.median.value() * law.median.value() * std::exp(2.0 * law.deviation * law.deviation);
    case model::SizeLaw::kList: {
      double sum = 0.0;
      for (const double size : law.values) sum += size * size;
      return sum / static_cast<double>(law.values.size());
    }
  }
  BRASH_EXPECTS(false, static_cast<int>(law.kind));
  return 0.0;
}

double stated_size(const model::FloeSizes& law) {
  if (law.kind == model::SizeLaw::kList) return law.values.front();
  return law.kind == model::SizeLaw::kPowerLaw ? law.least.value() : law.median.value();
}

double share_up_to(const model::FloeSizes& law, double size) {
  switch (law.kind) {
    case model::SizeLaw::kPowerLaw: {
      const double a = law.exponent, least = law.least.value(), largest = law.largest.value();
      if (size <= least) return 0.0;
      if (size >= largest) return 1.0;
      if (a == 0.0) return std::log(size / least) / std::log(largest / least);
      return (1.0 - std::pow(size / least, -a)) / (1.0 - std::pow(largest / least, -a));
    }
    case model::SizeLaw::kLogNormal:
      return 0.5 * std::erfc(-std::log(size / law.median.value()) / (law.deviation * std::sqrt(2.0)));
    case model::SizeLaw::kList:
      return static_cast<double>(std::ranges::count_if(law.values, [&](double v) { return v <= size; })) /
             static_cast<double>(law.values.size());
  }
  return 0.0;
}

std::optional<std::vector<double>> draw_areas(const model::FloeSizes& law, double area, std::size_t most,
                                              statistics::RandomStream& random) {
  std::vector<double> areas;
  for (double sum = 0.0; areas.size() <= most;) {
    const double size = draw(law, random), next = size * size;
    const bool is_nearer = sum + 0.5 * next <= area;  // with it than without it
    if (!is_nearer && !areas.empty()) return areas;
    areas.push_back(next);
    sum += next;
    if (!is_nearer) return areas;
  }
  return std::nullopt;
}

}  // namespace brash::ice
