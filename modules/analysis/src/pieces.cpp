// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "brash/analysis/tables.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/formats/maps.hpp"
#include "brash/geometry/caliper.hpp"
#include "brash/geometry/repair.hpp"
#include "brash/geometry/text.hpp"
#include "brash/io/file_names.hpp"
#include "brash/io/origin.hpp"
#include "brash/io/results.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/quantile.hpp"

namespace brash::analysis {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using statistics::Estimate;
using statistics::SizeFit;
using statistics::SizeLaw;

constexpr std::array<double, 7> kLevels{0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95};
constexpr double kRejected = 0.1;      // p below which Clauset, Shalizi and Newman rule a law out
constexpr std::size_t kThinTail = 50;  // a tail of fewer says little

PieceSizes sizes_of_run(const std::string& file, bool born) {
  PieceSizes sizes{
      fmt::format("floes {} of {}", born ? "ever born" : "afloat at the end", file), {}, {}, 0, io::origin_in(file)};
  const model::RunResults results = io::read_results(file);
  for (const model::FloeRecord& floe : results.floes) {
    if (!born && floe.end != model::FloeEnd::kAlive) {
      ++sizes.n_left_out;
    } else if (!floe.rings.empty()) {
      sizes.diameters.push_back(geometry::mean_caliper_diameter(geometry::ring(floe.rings.front())));
      sizes.areas.push_back(floe.area);
    }
  }
  // The large floes of a field are plates.
  if (io::read_case_of(file).find("[field]\nkind = \"floes\"") == std::string::npos) return sizes;
  for (const geometry::Polygon& plate : formats::polygons_of(born ? results.initial_sheet : results.final_sheet)) {
    sizes.diameters.push_back(geometry::mean_caliper_diameter(plate.outline));
    sizes.areas.push_back(geometry::area(plate).square_metres());
  }
  return sizes;
}

PieceSizes sizes_of_map(const std::string& file, const io::Notes& notes) {
  const auto read = geometry::read_shapes(read_characters(file, "a map (WKT or GeoJSON)", formats::kMostMebibytes));
  if (!read) formats::refuse_polygons(file, read.error().what);
  if (notes && !read->left_out.empty()) notes(fmt::format("{}: left out: {}", file, read->left_out));
  const geometry::Map& map = *read;
  const bool has_floes = std::ranges::any_of(map.features, [](const auto& f) { return f.kind == "floe"; });
  std::vector<geometry::Polygon> polygons;
  for (const geometry::Feature& f : map.features) {
    if (!has_floes || f.kind == "floe") polygons.push_back(f.polygon);
  }
  PieceSizes sizes = piece_sizes_of(polygons, fmt::format("{} of {}", has_floes ? "floes" : "polygons", file));
  sizes.n_left_out = map.features.size() - polygons.size();
  return sizes;
}

/// One sentence on the test of a fit.
std::string verdict(const SizeFit& fit) {
  const char* test = fit.law == SizeLaw::kPowerTail ? "Kolmogorov and Smirnov" : "Anderson and Darling";
  const double limit = fit.law == SizeLaw::kPowerTail ? kRejected : 0.05;
  if (fit.goodness.p_value <= limit)
    return fmt::format("rejected by {}: p = {:.2g}, at most {}", test, fit.goodness.p_value, limit);
  return fmt::format("not rejected by {}: p = {:.2g}", test, fit.goodness.p_value);
}

ordered_json fit_json(const SizeFit& fit) {
  constexpr std::array<std::array<const char*, 2>, 3> kNames{
      {{"median", "deviation_of_logarithm"}, {"scale", "shape"}, {"least_size", "exponent"}}};
  const auto& names = kNames[static_cast<std::size_t>(fit.law)];
  ordered_json out{{"law", name_of(fit.law)}, {"n", fit.n}};
  out[names[0]] = estimate_json(fit.scale);
  out[names[1]] = estimate_json(fit.shape);
  out["statistic"] = fit.goodness.statistic;
  out["p_value"] = fit.goodness.p_value;
  out["verdict"] = verdict(fit);
  if (fit.law == SizeLaw::kPowerTail && fit.n < kThinTail)
    out["warning"] =
        fmt::format("the tail holds {} pieces; fewer than {} say little about a power law", fit.n, kThinTail);
  return out;
}

ordered_json quantiles_json(const std::vector<double>& values) {
  ordered_json out;
  for (std::size_t i = 0; i < kLevels.size(); ++i) out[fmt::format("{:g}", kLevels[i])] = values[i];
  return out;
}

}  // namespace

PieceSizes piece_sizes_of(const std::vector<geometry::Polygon>& polygons, const std::string& source) {
  PieceSizes sizes{source, {}, {}, 0};
  // Pieces may overlap each other, but not themselves.
  if (const auto faults = geometry::own_faults_of(polygons); !faults.empty())
    throw InputError(
        Complaint{source, geometry::text_of(faults) + " (they count from 0)",
                  "closed outlines that do not cross themselves, holes inside them",
                  "draw the outlines again, or repair the file: brash crack --sheet FILE --repair -o NEW"});
  for (const geometry::Polygon& p : polygons) {
    sizes.diameters.push_back(geometry::mean_caliper_diameter(p.outline));
    sizes.areas.push_back(geometry::area(p).square_metres());
  }
  return sizes;
}

PieceSizes read_piece_sizes(const std::string& path, bool born, const io::Notes& notes) {
  const fs::path file = io::file_in(path, {"run.nc"});
  if (born && file.extension() != ".nc")
    throw InputError(Complaint{path, "is a map, which knows no floes that are gone", "--born for a run",
                               "leave --born out, or give the run.nc of the run"});
  PieceSizes sizes = file.extension() == ".nc" ? sizes_of_run(file.string(), born) : sizes_of_map(file.string(), notes);
  if (sizes.areas.empty())
    throw InputError(Complaint{path, "has no pieces", "a map with floes, or a run that broke ice",
                               born ? "give another file" : "give another file, or --born for floes that are gone"});
  return sizes;
}

PieceAnalysis analyse_pieces(const PieceSizes& sizes) {
  PieceAnalysis analysis;
  const auto keep = [&](SizeLaw law, const tl::expected<SizeFit, statistics::FitError>& fit) {
    if (fit) return analysis.fits.push_back(*fit);
    analysis.not_fitted.push_back(fmt::format("{}: {}", name_of(law), fit.error().reason));
  };
  keep(SizeLaw::kLogNormal, statistics::fit_log_normal_sizes(sizes.diameters));
  keep(SizeLaw::kWeibull, statistics::fit_weibull_sizes(sizes.diameters));
  keep(SizeLaw::kPowerTail, statistics::fit_power_tail(sizes.diameters));
  return analysis;
}

ordered_json pieces_json(const PieceSizes& sizes, const PieceAnalysis& analysis) {
  const auto n = static_cast<double>(sizes.diameters.size());
  const auto [least, largest] = std::ranges::minmax(sizes.diameters);
  const bool has_spread = sizes.diameters.size() > 1;
  const double mean = std::accumulate(sizes.diameters.begin(), sizes.diameters.end(), 0.0) / n;
  const double total = std::accumulate(sizes.areas.begin(), sizes.areas.end(), 0.0);
  ordered_json out{
      {"source", sizes.source},
      {"n", sizes.diameters.size()},
      {"n_left_out", sizes.n_left_out},
      {"area", total},
      {"mean_area", total / n},
      {"size", "mean caliper diameter [m]"},
      {"mean", mean},
      {"standard_deviation",
       has_spread ? ordered_json(std::sqrt(statistics::moments(sizes.diameters).variance)) : ordered_json()},
      {"least", least},
      {"largest", largest}};
  add_origin(sizes.origin, out);
  out["quantiles_by_number"] = quantiles_json(statistics::quantiles(sizes.diameters, kLevels));
  out["quantiles_by_area"] = quantiles_json(statistics::quantiles_of_shares(sizes.diameters, sizes.areas, kLevels));
  out["fits"] = ordered_json::array();
  for (const SizeFit& fit : analysis.fits) out["fits"].push_back(fit_json(fit));
  out["not_fitted"] = analysis.not_fitted;
  return out;
}

std::string pieces_text(const ordered_json& json) {
  const auto number = [](const ordered_json& value) {
    return value.is_null() ? "-" : fmt::format("{:.5g}", value.get<double>());
  };
  std::string text = fmt::format("{} pieces: {}\n", json["n"].get<std::size_t>(), json["source"].get<std::string>());
  text += origin_text(json, "  ");
  if (json["n_left_out"] != 0)
    text += fmt::format("  left out             {}\n", json["n_left_out"].get<std::size_t>());
  text += fmt::format("  area                 {} m2 in all, {} m2 on average\n", number(json["area"]),
                      number(json["mean_area"]));
  text += fmt::format("  mean caliper diameter  mean {} m, deviation {} m, from {} m to {} m\n", number(json["mean"]),
                      number(json["standard_deviation"]), number(json["least"]), number(json["largest"]));
  text += "  quantile          by number [m]    by area [m]\n";
  for (const auto& [level, value] : json["quantiles_by_number"].items())
    text += fmt::format("  {:>6} %        {:>14} {:>14}\n", fmt::format("{:g}", 100.0 * std::stod(level)),
                        number(value), number(json["quantiles_by_area"][level]));
  for (const ordered_json& fit : json["fits"]) {
    text += fmt::format("  {} of {} pieces: {}\n", fit["law"].get<std::string>(), fit["n"].get<std::size_t>(),
                        fit["verdict"].get<std::string>());
    for (const auto& [name, value] : fit.items()) {
      if (!value.is_object()) continue;
      std::string words = name;
      std::ranges::replace(words, '_', ' ');
      text += fmt::format("    {:<22} {} [{}, {}]\n", words, number(value["value"]), number(value["interval_95"][0]),
                          number(value["interval_95"][1]));
    }
    if (fit.contains("warning")) text += fmt::format("    warning: {}\n", fit["warning"].get<std::string>());
  }
  for (const ordered_json& reason : json["not_fitted"])
    text += fmt::format("  not fitted: {}\n", reason.get<std::string>());
  return text;
}

}  // namespace brash::analysis
