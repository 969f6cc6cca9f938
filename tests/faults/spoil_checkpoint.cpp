// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a fault into a run: spoil_checkpoint FILE place|later|speed|ledger
#include <cstdlib>
#include <string_view>

#include "brash/io/checkpoint.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  brash::model::Checkpoint state = brash::io::read_checkpoint(argv[1]);
  const std::string_view fault = argv[2];
  if (fault == "place") state.floes.at(2).pose.position.x += 1000.0;
  if (fault == "later") {  // it leaves what a floe can reach, 100 m from the field, some steps from now
    state.floes.at(2).pose.position = {-99.9, 0.0, state.floes.at(2).pose.position.z};
    state.floes.at(2).twist = {{-1.0, 0.0, 0.0}, {}};
  }
  if (fault == "speed") state.floes.at(2).twist.linear.z = 1e200;  // its drag exceeds all numbers
  if (fault == "ledger") std::swap(state.ledger.at("crushed"), state.ledger.at("floes"));  // still the right sum
  brash::io::write_checkpoint(argv[1], state);
}
