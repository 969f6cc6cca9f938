// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <pybind11/functional.h>

#include "brash/statistics/extremes.hpp"
#include "brash/statistics/hypothesis.hpp"
#include "brash/statistics/intervals.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/peaks.hpp"
#include "brash/statistics/quantile.hpp"
#include "brash/statistics/random.hpp"
#include "brash/statistics/sobol.hpp"
#include "brash/statistics/spectrum.hpp"
#include "brash/statistics/summary.hpp"
#include "convert.hpp"
#include "rooms.hpp"
#include "values.hpp"

namespace brash::python {
namespace {

using namespace statistics;
using std::pair;

/// Calls `call` with the span of the array `values`, shape=(n,).
template <typename Call>
auto with_samples(const char* function, const py::object& values, Call call) {
  const Array array = samples(values, "samples");
  return with_arguments_of(function, [&] { return call(span_of(array)); });
}

/// A UserWarning. @throws what the program's filter makes of it.
void warn(const char* text) {
  if (PyErr_WarnEx(PyExc_UserWarning, text, 1) < 0) throw py::error_already_set();
}

py::tuple peaks_tuple(const std::vector<Peak>& peaks) {
  std::vector<double> values;
  py::array_t<std::int64_t> index(static_cast<py::ssize_t>(peaks.size()));
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    index.mutable_data()[i] = static_cast<std::int64_t>(peaks[i].index);
    values.push_back(peaks[i].value);
  }
  return py::make_tuple(index, to_array(values));
}

template <typename Fit>
Fit fitted(tl::expected<Fit, FitError> fit) {
  if (!fit) throw NotApplicable(fit.error().reason);
  return *std::move(fit);
}

/// All of Summary::visit(), and the number of samples.
void add_summary(py::module_& m) {
  py::class_<Summary> type(m, "Summary", "Statistics of an evenly sampled load history, in its unit; times in s.");
  type.def_readonly("n", &Summary::n);
  Summary::visit([&](const Statistic& of, auto member) { type.def_readonly(of.name, member); });
  type.def("__repr__", [](const Summary& s) {
    std::string text = fmt::format("<brash.Summary n={}", s.n);
    Summary::visit([&](const Statistic& of, auto member) {
      text += fmt::format(" {}={}", of.name, std::string(py::repr(py::cast(s.*member))));
    });
    return text + ">";
  });
}

void add_values(py::module_& m) {
  add_value<Interval>(m, "Interval", "Confidence interval.", pair("lower", &Interval::lower),
                      pair("upper", &Interval::upper));
  add_summary(m);
  add_value<Moments>(m, "Moments", "Moments of a sample.", pair("n", &Moments::n), pair("mean", &Moments::mean),
                     pair("variance", &Moments::variance), pair("skewness", &Moments::skewness),
                     pair("excess_kurtosis", &Moments::excess_kurtosis), pair("minimum", &Moments::minimum),
                     pair("maximum", &Moments::maximum));
  add_value<AutocorrelationTime>(m, "AutocorrelationTime", "Integrated autocorrelation time [s] and how it was found.",
                                 pair("tau", &AutocorrelationTime::tau), pair("window", &AutocorrelationTime::window),
                                 pair("converged", &AutocorrelationTime::converged));
  add_value<Estimate>(m, "Estimate", "A value with its confidence interval.", pair("value", &Estimate::value),
                      pair("interval", &Estimate::interval));
  add_value<Gumbel>(m, "Gumbel", "F(x) = exp(-exp(-(x - location)/scale)).", pair("location", &Gumbel::location),
                    pair("scale", &Gumbel::scale), pair("n", &Gumbel::n));
  add_value<GeneralisedPareto>(m, "GeneralisedPareto", "Excesses over a threshold, 1 - (1 + shape y/scale)^(-1/shape).",
                               pair("threshold", &GeneralisedPareto::threshold),
                               pair("scale", &GeneralisedPareto::scale), pair("shape", &GeneralisedPareto::shape));
  add_value<TestResult>(m, "TestResult", "Outcome of a test.", pair("statistic", &TestResult::statistic),
                        pair("p_value", &TestResult::p_value));
  add_value<MeanComparison>(m, "MeanComparison", "Difference of two means, its interval, and Welch's t test.",
                            pair("difference", &MeanComparison::difference),
                            pair("interval", &MeanComparison::interval), pair("test", &MeanComparison::test));
}

void add_histories(py::module_& m) {
  m.def(
      "summarise",
      [](const py::object& values, double dt) {
        return with_samples("summarise", values, [&](auto s) { return summarise(s, dt); });
      },
      py::arg("samples"), py::arg("dt"), "Summary of a stationary history; samples: shape (n,), n >= 2, every dt [s].");
  m.def(
      "moments",
      [](const py::object& values) { return with_samples("moments", values, [](auto s) { return moments(s); }); },
      py::arg("samples"), "samples: shape (n,), n >= 2.");
  m.def(
      "histogram",
      [](const py::object& values, std::size_t n_bins, double lower, double upper) {
        if (n_bins > 100'000'000) throw InputError(fmt::format("n_bins = {}: at most 1e8 are expected", n_bins));
        const Histogram h =
            with_samples("histogram", values, [&](auto s) { return histogram(s, n_bins, lower, upper); });
        const std::vector<double> counts(h.counts.begin(), h.counts.end());
        return py::make_tuple(to_array(counts), to_array(h.edges), h.n_outside);
      },
      py::arg("samples"), py::arg("n_bins"), py::arg("lower"), py::arg("upper"),
      "(counts, shape (n_bins,); edges, shape (n_bins + 1,); number of samples outside).");
  m.def(
      "quantiles",
      [](const py::object& values, const py::object& levels) {
        const Array at = samples(levels, "levels");
        for (const double level : span_of(at))
          if (!(level >= 0.0 && level <= 1.0))
            throw InputError(fmt::format("levels: {} is not allowed; in [0, 1]", level));
        return with_samples("quantiles", values, [&](auto s) {
          const std::vector<double> q = quantiles({s.begin(), s.end()}, span_of(at));
          return to_array(std::span<const double>(q));
        });
      },
      py::arg("samples"), py::arg("levels"), "Type 7; shape (n_levels,), empty without samples.");
  m.def(
      "autocorrelation",
      [](const py::object& values, std::size_t max_lag) {
        const auto rho = with_samples("autocorrelation", values, [&](auto s) { return autocorrelation(s, max_lag); });
        return to_array(std::span<const double>(rho));
      },
      py::arg("samples"), py::arg("max_lag"), "rho_0 = 1, rho_1, ...; shape (max_lag + 1,).");
  m.def(
      "autocorrelation_time",
      [](const py::object& values, double dt) {
        return with_samples("autocorrelation_time", values, [&](auto s) { return autocorrelation_time(s, dt); });
      },
      py::arg("samples"), py::arg("dt"), "Integrated, with Sokal's automatic window.");
  m.def(
      "welch_spectrum",
      [](const py::object& values, double dt, std::size_t segment) {
        const Spectrum s =
            with_samples("welch_spectrum", values, [&](auto x) { return welch_spectrum(x, dt, segment); });
        return py::make_tuple(to_array(s.frequency), to_array(s.density), s.degrees_of_freedom);
      },
      py::arg("samples"), py::arg("dt"), py::arg("segment"),
      "(frequency [Hz], density [N2/Hz], degrees of freedom of each density); shape (segment // 2 + 1,) each.");
}

void add_peaks(py::module_& m) {
  m.def(
      "peaks_above",
      [](const py::object& values, double threshold, std::size_t separation) {
        return peaks_tuple(with_samples("peaks_above", values,
                                        [&](auto s) { return statistics::peaks_above(s, threshold, separation); }));
      },
      py::arg("samples"), py::arg("threshold"), py::arg("separation") = 1,
      "(indices, values) of the largest sample of each excursion above the threshold; excursions closer than "
      "`separation` samples are one.");
  m.def(
      "peaks_between_crossings",
      [](const py::object& values, double level) {
        return peaks_tuple(with_samples("peaks_between_crossings", values,
                                        [&](auto s) { return statistics::peaks_between_crossings(s, level); }));
      },
      py::arg("samples"), py::arg("level"),
      "(indices, values) of the largest sample between two successive upward crossings of the level.");
  m.def(
      "block_maxima",
      [](const py::object& values, std::size_t block) {
        const auto maxima = with_samples("block_maxima", values, [&](auto s) { return block_maxima(s, block); });
        return to_array(std::span<const double>(maxima));
      },
      py::arg("samples"), py::arg("block"), "The largest of each `block` samples; an incomplete last one is left out.");
  m.def(
      "fit_gumbel",
      [](const py::object& values) {
        return with_samples("fit_gumbel", values, [](auto s) { return fitted(fit_gumbel(s)); });
      },
      py::arg("samples"), "Maximum likelihood for independent block maxima. Raises NotApplicable.");
  m.def(
      "fit_generalised_pareto",
      [](const py::object& values, double threshold) {
        return with_samples("fit_generalised_pareto", values,
                            [&](auto s) { return fitted(fit_generalised_pareto(s, threshold)); });
      },
      py::arg("samples"), py::arg("threshold"),
      "Maximum likelihood for independent peaks above the threshold. Raises NotApplicable.");
  m.def(
      "return_level",
      [](const Gumbel& fit, double return_period, double confidence) {
        warn(
            "return_level of a Gumbel fit: the law has a fixed shape, and its interval is too short where the maxima "
            "have "
            "another one (docs/theory/statistics.md, coverage); extremes() finds the shape");
        return with_arguments_of("return_level", [&] { return return_level(fit, return_period, confidence); });
      },
      py::arg("fit"), py::arg("return_period"), py::arg("confidence") = 0.95,
      "Level that the maximum of one block exceeds once in `return_period` blocks.");
  m.def(
      "return_level",
      [](const GeneralisedPareto& fit, double duration, double return_period, double confidence) {
        return with_arguments_of("return_level",
                                 [&] { return return_level(fit, duration, return_period, confidence); });
      },
      py::arg("fit"), py::arg("duration"), py::arg("return_period"), py::arg("confidence") = 0.95,
      "Level exceeded once in `return_period` [s] when the peaks were counted in `duration` [s].");
}

void add_intervals(py::module_& m) {
  m.def(
      "mean_interval",
      [](const py::object& values, double confidence) {
        return with_samples("mean_interval", values, [&](auto s) { return mean_interval(s, confidence); });
      },
      py::arg("samples"), py::arg("confidence") = 0.95, "Student's interval of the mean of independent values.");
  m.def(
      "batch_means_interval",
      [](const py::object& values, std::size_t n_batches, double confidence) {
        return with_samples("batch_means_interval", values,
                            [&](auto s) { return batch_means_interval(s, n_batches, confidence); });
      },
      py::arg("samples"), py::arg("n_batches"), py::arg("confidence") = 0.95,
      "Interval of the mean of a correlated history from the means of batches.");
  m.def(
      "bootstrap_interval",
      [](const py::object& values, const std::function<double(py::array_t<double>)>& statistic,
         std::size_t block_length, std::size_t n_resamples, double confidence, std::uint64_t seed) {
        RandomStream stream(seed, "python", 0, "bootstrap");
        return with_samples("bootstrap_interval", values, [&](auto s) {
          return bootstrap_interval(
              s, [&](std::span<const double> resample) { return statistic(to_array(resample)); },
              {.block_length = block_length, .n_resamples = n_resamples, .confidence = confidence}, stream);
        });
      },
      py::arg("samples"), py::arg("statistic"), py::arg("block_length") = 1, py::arg("n_resamples") = 1000,
      py::arg("confidence") = 0.95, py::arg("seed") = 1,
      "Interval of any statistic, a function of shape (m,) -> float, from the circular block bootstrap: each draw is "
      "compared with its own error (bootstrap-t). The statistic is called up to 41 (n_resamples + 1) times.");
}

void add_tests(py::module_& m) {
  m.def(
      "kendall",
      [](const py::object& x, const py::object& y) {
        const Array a = samples(x, "x"), b = samples(y, "y");
        return with_arguments_of("kendall", [&] { return kendall(span_of(a), span_of(b)); });
      },
      py::arg("x"), py::arg("y"), "Kendall's tau-b, two-sided; shape (n,) each.");
  m.def(
      "jonckheere_terpstra",
      [](const py::list& groups) {
        std::vector<std::vector<double>> values;
        for (const py::handle group : groups) {
          const Array array = samples(group, "groups");
          values.emplace_back(array.data(), array.data() + array.size());
        }
        return with_arguments_of("jonckheere_terpstra", [&] { return jonckheere_terpstra(values); });
      },
      py::arg("groups"), "Whether groups of values rise in the given order; a list of arrays with shape (n,).");
  m.def(
      "mann_whitney",
      [](const py::object& a, const py::object& b) {
        const Array first = samples(a, "a"), second = samples(b, "b");
        return with_arguments_of("mann_whitney", [&] { return mann_whitney(span_of(first), span_of(second)); });
      },
      py::arg("a"), py::arg("b"), "Whether one sample tends to larger values; two-sided.");
  m.def(
      "holm",
      [](const py::object& p_values) {
        const auto adjusted = with_samples("holm", p_values, [](auto p) { return holm(p); });
        return to_array(std::span<const double>(adjusted));
      },
      py::arg("p_values"), "Holm's adjustment for several hypotheses; shape (n,), order kept.");
  m.def(
      "compare_means",
      [](const Summary& a, const Summary& b, double confidence) {
        return with_arguments_of("compare_means", [&] { return compare_means(a, b, confidence); });
      },
      py::arg("a"), py::arg("b"), py::arg("confidence") = 0.95,
      "Two correlated histories, by their summaries: effective sample sizes take the place of counts.");
  m.def(
      "compare_means",
      [](const py::object& a, const py::object& b, double confidence) {
        const Array first = samples(a, "a"), second = samples(b, "b");
        return with_arguments_of("compare_means",
                                 [&] { return compare_means(span_of(first), span_of(second), confidence); });
      },
      py::arg("a"), py::arg("b"), py::arg("confidence") = 0.95, "Independent values, shape (n,) each.");
}

void add_designs(py::module_& m) {
  m.def(
      "sobol",
      [](std::size_t n, std::size_t dimension, std::uint64_t seed) {
        if (n < 1 || n > kMostSobolPoints)
          throw InputError(fmt::format("sobol: n = {} is not allowed; 1 to {}", n, kMostSobolPoints));
        if (dimension < 1 || dimension > kMostSobolDimensions)
          throw InputError(
              fmt::format("sobol: dimension = {} is not allowed; 1 to {}", dimension, kMostSobolDimensions));
        const std::vector<double> points = sobol(n, dimension, seed);
        return to_array(points).reshape({static_cast<py::ssize_t>(n), static_cast<py::ssize_t>(dimension)});
      },
      py::arg("n"), py::arg("dimension"), py::arg("seed") = 1,
      "The first n points of a Sobol sequence with a digital shift, in (0, 1); shape (n, dimension), dimension <= 40. "
      "More points continue the sequence.");
}

}  // namespace

void add_statistics(py::module_& m) {
  add_values(m);
  add_histories(m);
  add_peaks(m);
  add_intervals(m);
  add_tests(m);
  add_designs(m);
}

}  // namespace brash::python
