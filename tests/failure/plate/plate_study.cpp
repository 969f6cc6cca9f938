// SPDX-License-Identifier: GPL-3.0-or-later
// Errors and times of the production mesh over the parameter range: the numbers of docs/theory/failure.md.
//
//   plate_study [cases] [scale] [order] [half_width]
//
// Each case is solved with the given mesh and with a reference (elements 0.35 as large, order 4, sheet twice as wide).

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "brash/plate/plate.hpp"
#include "solve_at_order.hpp"

namespace {

namespace plate = brash::plate;

/// Number i of Halton's sequence in that base.
double halton(int i, int base) {
  double result = 0.0;
  double share = 1.0;
  for (; i > 0; i /= base) {
    share /= base;
    result += share * (i % base);
  }
  return result;
}

/// Element size at the tip relative to the production mesh.
plate::MeshOptions scaled(const plate::WedgePlate& wedge, double scale, double half_width) {
  return {scale * plate::production_tip_size(wedge), 0.0, half_width};
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void print(const char* name, const std::vector<double>& values) {
  std::printf("%-28s median %.2e  90 %% %.2e  worst %.2e\n", name, quantile(values, 0.5), quantile(values, 0.9),
              quantile(values, 1.0));
}

}  // namespace

int main(int argc, char** argv) {
  const int n_cases = argc > 1 ? std::atoi(argv[1]) : 20;
  const double scale = argc > 2 ? std::atof(argv[2]) : 1.0;
  const int order = argc > 3 ? std::atoi(argv[3]) : 3;
  const double half_width = argc > 4 ? std::atof(argv[4]) : 8.0;
  std::vector<double> sigma, place, radial, root, seconds, elements;
  for (int i = 1; i <= n_cases; ++i) {
    plate::WedgePlate wedge;
    wedge.depth = 2.0 * halton(i, 2) * halton(i, 2);
    wedge.contact_length = 0.02 * std::pow(100.0, halton(i, 3));
    wedge.angle = halton(i, 5) * 150.0 * std::numbers::pi / 180.0;
    wedge.thickness = 0.05 + 0.15 * halton(i, 7);
    const double mu1 = 0.05 + 0.95 * halton(i, 11);
    const double mu2 = 0.3 * (halton(i, 13) - 0.5);
    const auto start = std::chrono::steady_clock::now();
    const auto profiles = plate::solve_at_order(wedge, scaled(wedge, scale, half_width), order);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    const auto fine = plate::solve_at_order(wedge, scaled(wedge, 0.35, 16.0), 4);
    if (!profiles || !fine) {
      std::printf("case %d failed: %s\n", i, (profiles ? fine : profiles).error().what.c_str());
      continue;
    }
    const auto a = plate::respond(*profiles, wedge.thickness, mu1, mu2);
    const auto b = plate::respond(*fine, wedge.thickness, mu1, mu2);
    sigma.push_back(std::abs(a.sigma_over_p / b.sigma_over_p - 1.0));
    place.push_back(std::abs(a.lbreak_over_lc - b.lbreak_over_lc));
    radial.push_back(std::abs(a.sigma_radial_over_p / b.sigma_radial_over_p - 1.0));
    root.push_back(std::abs(a.sigma_root_over_p / b.sigma_root_over_p - 1.0));
    elements.push_back(profiles->n_elements);
    std::printf(
        "b %.4f c %.4f theta %5.1f h %.3f mu1 %.2f mu2 %5.2f | sigma %9.4f %9.4f  place %.4f %.4f  radial %8.3f %8.3f  "
        "root %8.2f %8.2f  n %d/%d  %.3f s\n",
        wedge.depth, wedge.contact_length, wedge.angle * 180.0 / std::numbers::pi, wedge.thickness, mu1, mu2,
        a.sigma_over_p, b.sigma_over_p, a.lbreak_over_lc, b.lbreak_over_lc, a.sigma_radial_over_p,
        b.sigma_radial_over_p, a.sigma_root_over_p, b.sigma_root_over_p, profiles->n_elements, fine->n_elements,
        seconds.back());
  }
  print("error of sigma", sigma);
  print("error of place / l_c", place);
  print("error of radial", radial);
  print("error of root bound", root);
  print("elements", elements);
  print("seconds", seconds);
}
