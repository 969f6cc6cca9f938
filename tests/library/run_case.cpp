// SPDX-License-Identifier: GPL-3.0-or-later
// The validation case from C++ alone: no case file, no results, no netCDF.
#include <cstdio>
#include <cstdlib>

#include "brash/core/constants.hpp"
#include "brash/simulation/run.hpp"

int main(int argc, char** argv) {
  brash::model::Case c;
  c.name = "cone";  // keys the random streams
  c.ice.thickness = 0.33;
  c.ice.youngs_modulus = 0.35e9;
  c.ice.flexural_strength = 539e3;
  c.structure.shape = brash::model::Cone{
      .angle = brash::radians(61.4), .waterline_width = 13.6, .height = 9.08, .height_under_water = 5.68};
  c.structure.motion = brash::model::Towed{1.202};
  c.structure.start_distance = 7.0;
  c.field.length = c.field.width = 50.0;
  c.time.duration = argc > 1 ? std::atof(argv[1]) : 20.0;
  const brash::simulation::Run run = brash::simulation::run(c);
  std::printf("%.10g N mean over %.10g s, %d breaks\n", run.summary.mean_horizontal_whole, c.time.duration,
              run.summary.n_breaks);
}
