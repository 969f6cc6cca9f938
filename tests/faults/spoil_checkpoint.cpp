// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a fault into a run: spoil_checkpoint FILE place|later|speed|ledger
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "brash/io/checkpoint.hpp"

namespace {

/// Of the third floe.
double& floe_cell(brash::model::Checkpoint& state, std::string_view column) {
  return std::get<std::vector<double>>(state.table("floe").column(column).values).at(2);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  brash::model::Checkpoint state = brash::io::read_checkpoint(argv[1]);
  const std::string_view fault = argv[2];
  if (fault == "place") floe_cell(state, "x") += 1000.0;
  if (fault == "later") {  // it leaves the reach of a floe, 100 m from the field, some steps from now, as fast as it is
    double& along = floe_cell(state, "linear_x");
    const double speed = std::hypot(along, floe_cell(state, "linear_y"), floe_cell(state, "linear_z"));
    along = -std::max(speed, 0.05);
    floe_cell(state, "linear_y") = floe_cell(state, "linear_z") = 0.0;
    floe_cell(state, "x") = -100.0 - 0.035 * along;
    floe_cell(state, "y") = 0.0;
  }
  if (fault == "speed") floe_cell(state, "linear_z") = 1e200;  // its drag exceeds all numbers
  if (fault == "ledger") {                                     // still the right sum
    brash::model::Table& ledger = state.table("ledger");
    std::swap(ledger.column("crushed").values, ledger.column("floes").values);
  }
  brash::io::write_checkpoint(argv[1], state);
}
