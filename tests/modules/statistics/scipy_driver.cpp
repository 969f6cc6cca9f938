// SPDX-License-Identifier: GPL-3.0-or-later
// Reads samples as JSON from stdin and prints the results of the statistics room, for scipy_check.py to compare.
#include <iostream>
#include <nlohmann/json.hpp>
#include <vector>

#include "brash/statistics/extremes.hpp"
#include "brash/statistics/filter.hpp"
#include "brash/statistics/history.hpp"
#include "brash/statistics/hypothesis.hpp"
#include "brash/statistics/intervals.hpp"
#include "brash/statistics/laws.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/peaks.hpp"
#include "brash/statistics/quantile.hpp"
#include "brash/statistics/spectrum.hpp"
#include "brash/statistics/summary.hpp"

namespace {

using namespace brash::statistics;
using nlohmann::json;
using Samples = std::vector<double>;

json of(const Interval& i) { return json::array({i.lower, i.upper}); }
json of(const Estimate& e) { return {{"value", e.value}, {"interval", of(e.interval)}}; }
json of(const TestResult& t) { return {{"statistic", t.statistic}, {"p", t.p_value}}; }
json of(const MeanComparison& c) {
  return {{"difference", c.difference}, {"interval", of(c.interval)}, {"test", of(c.test)}};
}
json of(const std::vector<Peak>& peaks) {
  json out = json::array();
  for (const Peak& p : peaks) out.push_back(p.index);
  return out;
}

json one_history(const Samples& x, const json& in) {
  const double dt = in["dt"];
  const Moments m = moments(x);
  const Histogram h = histogram(x, 17, in["histogram"][0], in["histogram"][1]);
  const Spectrum even = welch_spectrum(x, dt, 256), odd = welch_spectrum(x, dt, 105);
  json out;
  out["moments"] = {m.mean, m.variance, m.skewness, m.excess_kurtosis, m.minimum, m.maximum};
  out["quantiles"] = quantiles(x, in["levels"].get<Samples>());
  out["histogram"] = {{"edges", h.edges}, {"counts", h.counts}, {"outside", h.n_outside}};
  out["spectrum_256"] = {{"frequency", even.frequency}, {"density", even.density}};
  out["spectrum_105"] = {{"frequency", odd.frequency}, {"density", odd.density}};
  out["spectrum_factors"] = of(spectrum_factors(even));
  out["degrees_of_freedom"] = even.degrees_of_freedom;
  out["autocorrelation"] = autocorrelation(x, 300);
  out["peaks_above"] = of(peaks_above(x, in["threshold"], in["separation"]));
  for (const auto& [name, phase] : {std::pair("zero", Phase::kZero), std::pair("causal", Phase::kCausal)})
    out["low_pass"][name] = low_pass(x, in["dt"], 3.0, phase);
  out["peaks_between"] = of(peaks_between_crossings(x, m.mean));
  out["block_maxima"] = block_maxima(x, 77);
  out["mean_interval"] = of(mean_interval(x, 0.9));
  out["batch_means"] = of(batch_means_interval(x, 13));
  return out;
}

json uneven_history(const json& in) {
  const History history{in["times"].get<Samples>(), in["values"].get<Samples>()};
  const EvenHistory even = make_even(history);
  const Moments m = moments(history.values, even.weights);
  std::vector<Samples> pieces;
  for (const auto piece : even.pieces(history)) pieces.emplace_back(piece.begin(), piece.end());
  const Spectrum spectrum = welch_spectrum(even.pieces(history), even.sampling.step, in["segment"].get<std::size_t>());
  const Summary summary = summarise(history, even);
  json gaps = json::array();
  for (const Gap& gap : even.sampling.gaps) gaps.push_back({gap.from, gap.to});
  return {{"step", even.sampling.step},
          {"even", even.sampling.even},
          {"gaps", gaps},
          {"weights", even.weights},
          {"duration", even.duration},
          {"pieces", pieces},
          {"moments", {m.mean, m.variance, m.skewness, m.excess_kurtosis}},
          {"summary", {summary.mean, summary.standard_deviation, summary.skewness}},
          {"quantiles", quantiles(history.values, even.weights, in["levels"].get<Samples>())},
          {"spectrum", {{"frequency", spectrum.frequency}, {"density", spectrum.density}}},
          {"autocorrelation", autocorrelation(even.pieces(history), 200)}};
}

json spectra(const Samples& a, const Samples& b, double dt) {
  const auto compared = compare_spectra(welch_spectrum(a, dt, 250), welch_spectrum(b, dt, 250)).value();
  return {{"ratio", compared.ratio},
          {"band", of(compared.band)},
          {"outside", compared.outside},
          {"shape_outside", compared.shape_outside},
          {"correlation", compared.shape_correlation},
          {"mean_frequency", {compared.mean_frequency_a, compared.mean_frequency_b}}};
}

json extremes(const json& in) {
  const auto gumbel = fit_gumbel(in["maxima"].get<Samples>()).value();
  json out;
  out["gumbel"] = {{"location", gumbel.location}, {"scale", gumbel.scale}, {"level", of(return_level(gumbel, 100.0))}};
  for (const auto& [name, sample] : in["peaks"].items()) {
    const auto pareto = fit_generalised_pareto(sample.get<Samples>(), in["pareto_threshold"]).value();
    out["pareto"][name] = {{"scale", pareto.scale},
                           {"shape", pareto.shape},
                           {"n", pareto.excesses.size()},
                           {"level", of(return_level(pareto, 1000.0, 5000.0))}};
  }
  return out;
}

/// Fits of all laws to one sample of maxima and one of peaks, with levels and Anderson and Darling's statistic.
json laws(const json& in) {
  const auto maxima = in["maxima"].get<Samples>(), peaks = in["law_peaks"].get<Samples>();
  const double origin = in["law_origin"];
  json out;
  GoodnessOfFit goodness;
  for (const Law law : {Law::kGumbel, Law::kGev, Law::kPareto, Law::kWeibull, Law::kRayleigh}) {
    const LawFit fit = fit_law(law, is_of_blocks(law) ? maxima : peaks, origin).value();
    const Distribution& d = fit.distribution;
    out[name_of(law)] = {{"location", d.location},
                         {"scale", d.scale},
                         {"shape", d.shape},
                         {"level", of(level_with_interval(fit, 1e-3))},
                         {"exceedance", d.exceedance(in["law_at"])},
                         {"anderson_darling", goodness.test(fit).statistic}};
  }
  return out;
}

json tests(const json& in) {
  json out;
  for (const auto& [name, pair] : in["pairs"].items())
    out["kendall"][name] = of(kendall(pair[0].get<Samples>(), pair[1].get<Samples>()));
  for (const auto& [name, pair] : in["samples"].items()) {
    const auto a = pair[0].get<Samples>(), b = pair[1].get<Samples>();
    out["means"][name] = of(compare_means(a, b));
    out["mann_whitney"][name] = of(mann_whitney(a, b));
    out["kolmogorov_smirnov"][name] = of(kolmogorov_smirnov(a, b));
  }
  out["jonckheere"] = of(jonckheere_terpstra(in["groups"].get<std::vector<Samples>>()));
  return out;
}

}  // namespace

int main() {
  const json in = json::parse(std::cin);
  const auto history = in["history"].get<Samples>();
  std::cout << json{{"history", one_history(history, in)},
                    {"uneven", uneven_history(in["uneven"])},
                    {"spectra", spectra(history, in["other"].get<Samples>(), in["dt"])},
                    {"extremes", extremes(in)},
                    {"laws", laws(in)},
                    {"tests", tests(in)}}
            << '\n';
}
