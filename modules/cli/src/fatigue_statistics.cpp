// SPDX-License-Identifier: GPL-3.0-or-later
#include "fatigue_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brash/statistics/rainflow.hpp"

namespace brash::cli {
namespace {

using nlohmann::ordered_json;
using namespace statistics;

constexpr std::size_t kFewestStretches = 10;  // of an interval

/// The cycles of one piece of a history.
struct Piece {
  std::vector<Cycle> cycles;
  std::size_t samples = 0;
  double step = 0.0;  ///< [s]
};

std::vector<Piece> pieces_of(const std::vector<const LoadHistory*>& loads) {
  std::vector<Piece> pieces;
  for (const LoadHistory* load : loads)
    for (const auto samples : raw_pieces(load->history, load->even))
      pieces.push_back({rainflow(samples), samples.size(), load->even.sampling.step});
  return pieces;
}

/// Stretches of all pieces; lengths in seconds.
StretchDamages stretches_of(const std::vector<Piece>& pieces, double exponent, double stretch) {
  StretchDamages all;
  for (const Piece& piece : pieces) {
    const auto n = static_cast<std::size_t>(std::max(1.0, std::ceil(stretch / piece.step)));
    const StretchDamages some = damage_by_stretch(piece.cycles, exponent, piece.samples, n);
    all.damages.insert(all.damages.end(), some.damages.begin(), some.damages.end());
    for (const double length : some.lengths) all.lengths.push_back(length * piece.step);
  }
  return all;
}

ordered_json equivalent_load(const std::vector<Piece>& pieces, const std::vector<Cycle>& cycles, double exponent,
                             double stretch, double frequency) {
  const StretchDamages stretches = stretches_of(pieces, exponent, stretch);
  double damage = 0.0, duration = 0.0;
  for (const double d : stretches.damages) damage += d;
  for (const double length : stretches.lengths) duration += length;
  ordered_json out{{"exponent", exponent},
                   {"frequency", frequency},
                   {"equivalent_load", damage_equivalent_load(damage, exponent, duration, frequency)},
                   {"equivalent_load_95", {nullptr, nullptr}},
                   {"stretches", stretches.damages.size()},
                   {"unseen_damage", unseen_damage(cycles, exponent)}};
  if (stretches.damages.size() >= kFewestStretches && damage > 0.0) {
    RandomStream stream(1, "fatigue", 0, "bootstrap");
    const Interval rate = damage_rate_interval(stretches, 0.95, stream);
    const auto range = [&](double of_rate) { return std::pow(of_rate / frequency, 1.0 / exponent); };
    out["equivalent_load_95"] = {range(rate.lower), range(rate.upper)};
  }
  return out;
}

}  // namespace

ordered_json fatigue_json(const std::vector<const LoadHistory*>& loads, const std::vector<double>& exponents,
                          double stretch, double frequency) {
  ordered_json out = ordered_json::array();
  if (exponents.empty()) return out;
  const std::vector<Piece> pieces = pieces_of(loads);
  std::vector<Cycle> cycles;
  for (const Piece& piece : pieces) cycles.insert(cycles.end(), piece.cycles.begin(), piece.cycles.end());
  for (const double m : exponents) out.push_back(equivalent_load(pieces, cycles, m, stretch, frequency));
  return out;
}

std::string fatigue_text(const ordered_json& fatigue) {
  std::string text;
  for (const ordered_json& f : fatigue) {
    text += fmt::format("  equivalent load      {:.6g}   ", f["equivalent_load"].get<double>());
    text += f["equivalent_load_95"][0].is_null()
                ? std::string("no interval")
                : fmt::format("95 % interval [{:.6g}, {:.6g}]", f["equivalent_load_95"][0].get<double>(),
                              f["equivalent_load_95"][1].get<double>());
    text += fmt::format(", exponent {:g}, at {:g} Hz\n", f["exponent"].get<double>(), f["frequency"].get<double>());
    if (f["equivalent_load_95"][0].is_null() && f.contains("stretches"))
      text += fmt::format("    note: {} independent stretches are too few for an interval\n",
                          f["stretches"].get<std::size_t>());
    if (const double unseen = f.value("unseen_damage", 0.0); unseen > kMostUnseen)
      text += fmt::format(
          "    warning: about {:.0f} % of the damage in the long run is from cycles larger than any seen: the interval "
          "is too short\n",
          100.0 * unseen);
  }
  return text;
}

}  // namespace brash::cli
