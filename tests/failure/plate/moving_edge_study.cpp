// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how far the responses of a moving edge are from those of finer and larger solutions:
// moving_edge_study b c theta [scale reach n_vectors [fine scale, reach, n_vectors]].
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "brash/core/constants.hpp"
#include "brash/plate/edge_responses.hpp"

namespace plate = brash::plate;

namespace {

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

plate::EdgeResponses solved(const plate::EdgeGeometry& geometry, const plate::EdgeOptions& options) {
  const double start = seconds();
  const auto edge = plate::MovingEdge::prepare(geometry, options);
  if (!edge) std::puts(edge.error().what.c_str()), std::exit(1);
  const double middle = seconds();
  const auto responses = edge->respond(geometry);
  if (!responses) std::puts(responses.error().what.c_str()), std::exit(1);
  std::printf("%d elements, %.2f s to prepare, %.2f s to respond\n", edge->n_elements(), middle - start,
              seconds() - middle);
  return *responses;
}

/// Errors at one time or at rest, relative to the largest value of each kind then [%].
void print_errors(double t, double w, double w_fine, double yy, double yy_fine, const double* xx, const double* xx_fine,
                  std::size_t n) {
  double most = 0.0, error = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    most = std::max(most, xx_fine[i]);
    error = std::max(error, std::abs(xx[i] - xx_fine[i]));
  }
  std::printf("%8.4f %10.6f %+7.2f %10.6f %+7.2f %10.6f %7.2f\n", t, w_fine, 100 * (w / w_fine - 1), yy_fine,
              100 * (yy / yy_fine - 1), most, 100 * error / most);
}

}  // namespace

int main(int argc, char** argv) {
  const auto number = [&](int i, double otherwise) { return argc > i ? std::atof(argv[i]) : otherwise; };
  plate::EdgeGeometry geometry{.depth = number(1, 0.0),
                               .contact_length = number(2, 0.3),
                               .angle = brash::radians(number(3, 0.0)),
                               .thickness = 0.1009};
  const auto options = [&](int first, double scale, double reach, int n) {
    return plate::EdgeOptions{.scale = number(first, scale),
                              .reach = number(first + 1, reach),
                              .n_vectors = static_cast<int>(number(first + 2, n))};
  };
  const auto coarse = solved(geometry, options(4, 0.0, 0.0, 0));
  const auto fine = solved(geometry, options(7, 0.6, 12.0, 400));
  std::puts("       t          w   err %        myy   err %        mxx   err %");
  const std::size_t n = fine.station.size();
  for (std::size_t i = 0; i < fine.time.size(); i += 2)
    print_errors(fine.time[i], coarse.deflection[i], fine.deflection[i], coarse.edge_moment[i], fine.edge_moment[i],
                 coarse.axis_moment_at(i), fine.axis_moment_at(i), n);
  print_errors(0.0, coarse.static_deflection, fine.static_deflection, coarse.static_edge_moment,
               fine.static_edge_moment, coarse.static_axis_moment.data(), fine.static_axis_moment.data(), n);
  return 0;
}
