// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace brash::cli {

/// Adds `crack`: the geometry kernel alone.
void add_crack_command(CLI::App& app);
/// Adds `fit`: the trapezoid fit alone.
void add_fit_command(CLI::App& app);
/// Adds `pieces`: the size distribution of floes.
void add_pieces_command(CLI::App& app);

}  // namespace brash::cli
