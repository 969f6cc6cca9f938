// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "brash/analysis/history_statistics.hpp"
#include "brash/statistics/rainflow.hpp"

namespace brash::analysis {
namespace {

using nlohmann::ordered_json;
using namespace statistics;

constexpr std::size_t kFewestStretches = 10;  // of an interval
constexpr double kConfidence = 0.95;

/// The cycles of one piece of a history.
struct Piece {
  std::vector<Cycle> cycles;
  std::size_t samples = 0;
  double step = 0.0;  ///< [s]
};

/// Counts the samples of an uneven piece as on an even grid, so that stretches are cut by time.
void count_evenly(std::span<const double> times, Piece& piece) {
  const auto index = [&](double time) { return static_cast<std::size_t>((time - times.front()) / piece.step); };
  for (Cycle& cycle : piece.cycles) cycle.index = index(times[cycle.index]);
  piece.samples = index(times.back() + 0.5 * piece.step) + 1;
}

std::vector<Piece> pieces_of(const std::vector<const LoadHistory*>& loads) {
  std::vector<Piece> pieces;
  for (const LoadHistory* load : loads) {
    const EvenHistory& even = load->even;
    const Pieces samples = raw_pieces(load->history, even);
    for (std::size_t p = 0; p < samples.size(); ++p) {
      pieces.push_back({rainflow(samples[p]), samples[p].size(), even.sampling.step});
      if (!even.sampling.even)
        count_evenly(std::span(load->history.times).subspan(even.cuts[p], samples[p].size()), pieces.back());
    }
  }
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
  const double unseen = unseen_damage(cycles, exponent);
  ordered_json out{{"exponent", exponent},
                   {"frequency", frequency},
                   {"equivalent_load", damage_equivalent_load(damage, exponent, duration, frequency)},
                   {"equivalent_load_95", {nullptr, nullptr}},
                   {"stretches", stretches.damages.size()},
                   {"unseen_damage", unseen}};
  if (stretches.damages.size() >= kFewestStretches && damage > 0.0) {
    RandomStream stream(1, "fatigue", 0, "bootstrap");
    Interval rate = damage_rate_interval(stretches, kConfidence, stream);
    // Resamples hold no cycle larger than any seen.
    const double ratio = largest_damage_ratio(cycles, exponent, kConfidence);
    if (std::isfinite(ratio) || unseen > kMostUnseen) rate.upper = std::max(rate.upper, damage / duration * ratio);
    const auto range = [&](double of_rate) -> ordered_json {
      return std::isfinite(of_rate) ? ordered_json(std::pow(of_rate / frequency, 1.0 / exponent)) : nullptr;
    };
    out["equivalent_load_95"] = {range(rate.lower), range(rate.upper)};
  }
  return out;
}

std::string interval_text(const ordered_json& ends, double one) {
  return ends[0].is_null() ? "no interval" : "95 % interval " + ends_text(ends, one);
}

/// The warning of a record that lacks the cycles that do the damage; "" for one that has them.
std::string unseen_text(const ordered_json& f) {
  const double unseen = f.value("unseen_damage", 0.0);
  if (unseen <= kMostUnseen) return "";
  std::string text = fmt::format(
      "    warning: about {:.0f} % of the damage in the long run is from cycles larger than any seen", 100.0 * unseen);
  if (const ordered_json& ends = f["equivalent_load_95"]; !ends[0].is_null())
    text += ends[1].is_null() ? ": their tail may be heavier than an exponential one, so the interval has no upper end"
                              : ": the upper end holds if their tail is exponential or lighter";
  return text + "\n";
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

std::string fatigue_text(const ordered_json& fatigue, const TableUnit& unit) {
  std::string text;
  for (const ordered_json& f : fatigue) {
    text += fmt::format("  equivalent load      {:.6g}{}{}   ", f["equivalent_load"].get<double>() / unit.one,
                        unit.name.empty() ? "" : " ", unit.name);
    text += interval_text(f["equivalent_load_95"], unit.one);
    text += fmt::format(", exponent {:g}, at {:g} Hz\n", f["exponent"].get<double>(), f["frequency"].get<double>());
    if (f["equivalent_load_95"][0].is_null() && f.contains("stretches"))
      text += fmt::format("    note: {} independent stretches are too few for an interval\n",
                          f["stretches"].get<std::size_t>());
    text += unseen_text(f);
  }
  return text;
}

}  // namespace brash::analysis
