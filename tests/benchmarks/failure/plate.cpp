// SPDX-License-Identifier: GPL-3.0-or-later
// One plate: the time of its solution and its response, beside freefem.edp.
//
//   bench_plate b c theta h mu1 mu2 [fine]    lengths over l_c, theta in degrees; prints one JSON object
//
// `fine`: elements half as large, of order 4, in a sheet twice as wide: the reference of plate_study.

#include "brash/plate/plate.hpp"

#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>

#include "solve_at_order.hpp"

int main(int argc, char** argv) {
  namespace plate = brash::plate;
  std::array<double, 6> value{};
  if (argc < 7) return EXIT_FAILURE;
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = std::atof(argv[i + 1]);
  const auto [b, c, theta, h, mu1, mu2] = value;
  const plate::WedgePlate wedge{
      .depth = b, .contact_length = c, .angle = theta * std::numbers::pi / 180.0, .thickness = h};

  const std::clock_t start = std::clock();
  const auto profiles = argc > 7
                            ? plate::solve_at_order(wedge, {0.5 * plate::production_tip_size(wedge), 0.0, 4000.0}, 4)
                            : plate::solve(wedge);
  if (!profiles) return EXIT_FAILURE;
  const plate::Response response = plate::respond(*profiles, h, mu1, mu2);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  std::printf("{\"seconds\": %.4f, \"elements\": %d, \"sigma\": %.8f, \"place\": %.6f}\n", seconds,
              profiles->n_elements, response.sigma_over_p, response.lbreak_over_lc);
}
