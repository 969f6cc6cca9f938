// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a fault into a run: spoil_checkpoint FILE place|speed|ledger
#include <cstdlib>
#include <string_view>

#include "brash/io/checkpoint.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  brash::io::Checkpoint state = brash::io::read_checkpoint(argv[1]);
  const std::string_view fault = argv[2];
  if (fault == "place") state.floes.at(2).pose.position.x += 1000.0;
  if (fault == "speed") state.floes.at(2).twist.linear.z = 1e200;  // its drag exceeds all numbers
  if (fault == "ledger") std::swap(state.ledger.at("crushed"), state.ledger.at("floes"));  // still the right sum
  brash::io::write_checkpoint(argv[1], state);
}
