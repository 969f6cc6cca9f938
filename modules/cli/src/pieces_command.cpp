// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <memory>

#include "brash/analysis/pieces.hpp"
#include "brash/core/input_file.hpp"
#include "brash/io/file_names.hpp"
#include "brash/report/pictures.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "messages.hpp"

namespace brash::cli {
namespace {

struct PiecesOptions {
  std::string file, picture;
  bool json = false, born = false;
};

void pieces(const PiecesOptions& options) {
  refuse_overwriting(options.picture, {options.file});
  io::refuse_replacing_results(options.picture);
  check_picture_name(options.picture);
  const analysis::PieceSizes sizes = analysis::read_piece_sizes(options.file, options.born, say_note);
  const analysis::PieceAnalysis analysis = analysis::analyse_pieces(sizes);
  if (!options.picture.empty()) write_picture(options.picture, report::pieces_picture(sizes, analysis));
  const nlohmann::ordered_json json = analysis::pieces_json(sizes, analysis);
  if (options.json)
    print_data(json.dump(2) + "\n");
  else
    print_text(analysis::pieces_text(json));
}

}  // namespace

void add_pieces_command(CLI::App& app) {
  auto options = std::make_shared<PiecesOptions>();
  CLI::App* command = app.add_subcommand("pieces", "Size distribution of the floes of a map or a run");
  command->add_option("file", options->file, "map (GeoJSON or WKT), run.nc, or the folder of a run")->required();
  command->add_option("-o,--output", options->picture, "picture to draw (SVG or PNG)");
  command->add_flag("--born", options->born, "of a run: every floe that was born; else those afloat at the end");
  command->add_flag("--json", options->json, "print JSON");
  command->footer(
      "Prints quantiles by number and by area, and fits with intervals and tests.\n"
      "Example: brash pieces pieces.geojson -o sizes.svg");
  command->callback([options] { pieces(*options); });
}

}  // namespace brash::cli
