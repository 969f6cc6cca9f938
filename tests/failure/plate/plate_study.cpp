// SPDX-License-Identifier: GPL-3.0-or-later
// Errors and times of the production mesh over the parameter range: the numbers of docs/theory/fracture-of-the-edge.md.
//
//   plate_study [cases] [scale] [order]     cases over the whole range
//   plate_study corners [scale] [order]     corners and faces of the range, mu1 at both ends
//
// Each case is solved on the given mesh and on a reference: elements half as large, of order 4, a sheet twice as wide.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "brash/plate/plate.hpp"
#include "solve_at_order.hpp"

namespace {

namespace plate = brash::plate;

constexpr double kDegree = std::numbers::pi / 180.0;

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

plate::WedgePlate case_number(int i) {
  plate::WedgePlate wedge;
  wedge.depth = i % 8 == 0 ? 0.0 : 2.0 * halton(i, 2) * halton(i, 2);
  wedge.contact_length = 0.02 * std::pow(100.0, halton(i, 3));
  wedge.angle = halton(i, 5) * 150.0 * kDegree;
  wedge.thickness = 0.05 + 0.15 * halton(i, 7);
  return wedge;
}

/// Corners and faces of the range, shallow protrusions among them.
std::vector<plate::WedgePlate> corners() {
  std::vector<plate::WedgePlate> cases;
  for (const double b : {0.0, 0.003, 0.02, 0.05, 0.3, 2.0}) {
    for (const double c : {0.02, 0.1, 2.0}) {
      for (const double theta : {0.0, 60.0, 120.0, 150.0}) {
        if (b == 0.0 && theta > 0.0) continue;
        for (const double h : {0.05, 0.15}) {
          cases.push_back({.depth = b, .contact_length = c, .angle = theta * kDegree, .thickness = h});
        }
      }
    }
  }
  return cases;
}

struct Errors {
  std::vector<double> sigma, place, radial, root, seconds, elements;
  int off_plateau = 0;
};

/// One solved pair: production and reference.
struct Pair {
  plate::WedgePlate wedge;
  plate::UnitProfiles profiles, fine;
};

std::optional<Pair> solve_pair(Errors& errors, const plate::WedgePlate& wedge, double scale, int order) {
  const double tip = plate::production_tip_size(wedge);
  const std::clock_t start = std::clock();
  const auto profiles = plate::solve_at_order(wedge, {scale * tip, 0.0, 0.0}, order);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const auto fine = plate::solve_at_order(wedge, {0.5 * tip, 0.0, 4000.0}, 4);
  if (!profiles || !fine) {
    std::printf("b %.3f c %.3f theta %.1f failed: %s\n", wedge.depth, wedge.contact_length, wedge.angle / kDegree,
                (profiles ? fine : profiles).error().what.c_str());
    return std::nullopt;
  }
  errors.elements.push_back(profiles->n_elements);
  errors.seconds.push_back(seconds);
  return Pair{wedge, *profiles, *fine};
}

void add_loads(Errors& errors, const Pair& pair, double mu1, double mu2) {
  const auto& wedge = pair.wedge;
  const auto a = plate::respond(pair.profiles, wedge.thickness, mu1, mu2);
  const auto b = plate::respond(pair.fine, wedge.thickness, mu1, mu2);
  const bool on_plateau = a.lbreak_over_lc >= b.plateau_from && a.lbreak_over_lc <= b.plateau_to;
  errors.sigma.push_back(std::abs(a.sigma_over_p / b.sigma_over_p - 1.0));
  errors.place.push_back(std::abs(a.lbreak_over_lc - b.lbreak_over_lc));
  if (!on_plateau) ++errors.off_plateau;
  // The radial stress passes through zero: relative to p where it is less than that.
  errors.radial.push_back(std::abs(a.sigma_radial_over_p - b.sigma_radial_over_p) /
                          std::max(1.0, std::abs(b.sigma_radial_over_p)));
  if (wedge.depth > 0.0) errors.root.push_back(std::abs(a.sigma_root_over_p / b.sigma_root_over_p - 1.0));
  std::printf("b %.3f c %.3f theta %5.1f h %.3f mu1 %.2f mu2 %5.2f: sigma %8.4f error %.1e, place %.4f error %.1e%s, ",
              wedge.depth, wedge.contact_length, wedge.angle / kDegree, wedge.thickness, mu1, mu2, b.sigma_over_p,
              errors.sigma.back(), b.lbreak_over_lc, errors.place.back(), on_plateau ? "" : " (off the plateau)");
  std::printf("radial %8.3f error %.1e, %d elements, %.2f s\n", b.sigma_radial_over_p, errors.radial.back(),
              pair.profiles.n_elements, errors.seconds.back());
  std::fflush(stdout);
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
  const std::string which = argc > 1 ? argv[1] : "20";
  const double scale = argc > 2 ? std::atof(argv[2]) : 1.0;
  const int order = argc > 3 ? std::atoi(argv[3]) : 3;
  Errors errors;
  if (which == "corners") {
    for (const auto& wedge : corners()) {
      const auto pair = solve_pair(errors, wedge, scale, order);
      for (const double mu1 : {0.1, 3.0}) {
        if (pair) add_loads(errors, *pair, mu1, 0.3);
      }
    }
  } else {
    for (int i = 1; i <= std::stoi(which); ++i) {
      const auto pair = solve_pair(errors, case_number(i), scale, order);
      if (pair) add_loads(errors, *pair, 0.05 + 0.95 * halton(i, 11), 0.3 * (halton(i, 13) - 0.5));
    }
  }
  print("error of sigma", errors.sigma);
  print("error of place / l_c", errors.place);
  std::printf("%-28s %d of %zu\n", "place off the plateau", errors.off_plateau, errors.place.size());
  print("error of radial", errors.radial);
  print("error of root bound", errors.root);
  print("elements", errors.elements);
  print("seconds of one core", errors.seconds);
}
