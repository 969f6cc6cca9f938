// SPDX-License-Identifier: GPL-3.0-or-later
// Load histories as the command has them: `brash stats`, `compare` and `design` on arrays, pandas and xarray.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "brash/analysis/design.hpp"
#include "brash/analysis/history_comparison.hpp"
#include "brash/analysis/history_statistics.hpp"
#include "brash/analysis/load_history.hpp"
#include "brash/analysis/resistance.hpp"
#include "brash/core/text.hpp"
#include "brash/io/series.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/rainflow.hpp"
#include "brash/statistics/spectrum.hpp"
#include "convert.hpp"
#include "notes.hpp"
#include "rooms.hpp"
#include "signals.hpp"

namespace brash::python {
namespace {

using analysis::LoadHistory;
using nlohmann::ordered_json;
using namespace py::literals;

constexpr double kLongest = 1e12;  // [s]

std::string path_of(const py::object& path) {
  return py::module_::import("os").attr("fspath")(path).cast<std::string>();
}

void require(bool allowed, const char* name, double value, const char* range) {
  if (!allowed) throw InputError(fmt::format("{}: {} is not allowed; {}", name, value, range));
}

/// Seconds: numbers as they are, dates and differences of times from the first one on. Dates of a time zone go through
/// UTC, in which no hour is missing or double.
py::object seconds(const py::object& times) {
  expect_no_mask(times, "times");
  const py::module_ numpy = py::module_::import("numpy");
  const bool has_zone = py::hasattr(times, "tz_convert") && py::hasattr(times, "tz") && !times.attr("tz").is_none();
  const py::object array = numpy.attr("asarray")(has_zone ? times.attr("tz_convert")(py::none()) : times);
  const auto kind = array.attr("dtype").attr("kind").cast<std::string>();
  if (kind != "M" && kind != "m") return array;
  if (numpy.attr("isnat")(array).attr("any")().cast<bool>())
    throw InputError("times: a date is missing (NaT); leave such rows out, as with history[history.index.notna()]");
  if (py::len(array) == 0) return numpy.attr("zeros")(0);
  return (array - array[py::int_(0)]).attr("astype")("timedelta64[ns]").attr("astype")("float64") / py::float_(1e9);
}

/// A text among the attributes of a history or its times, such as attrs["units"]; empty: none.
std::string attribute_of(const py::object& labelled, const char* name) {
  if (!py::hasattr(labelled, "attrs") || !py::isinstance<py::dict>(labelled.attr("attrs"))) return "";
  const py::object value = labelled.attr("attrs").attr("get")(name);
  return py::isinstance<py::str>(value) ? value.cast<std::string>() : "";
}

/// Numbers of rows are not times: whole numbers are taken as seconds only from an index that has a name.
void expect_times(const py::object& index) {
  if (!py::hasattr(index, "name") || !index.attr("name").is_none()) return;
  const auto kind = py::module_::import("numpy").attr("asarray")(index).attr("dtype").attr("kind").cast<std::string>();
  if (kind == "i" || kind == "u")
    throw InputError(Complaint{"history", "the index of the pandas.Series counts rows, and has no name",
                               "an index of times [s]", "table.set_index(\"time\")[\"Fx\"], or (times, values)"});
}

/// Times and values of a pandas.Series, an xarray.DataArray or a pair of arrays.
std::pair<py::object, py::object> times_and_values(const py::object& history) {
  if (py::hasattr(history, "coords") && py::hasattr(history, "dims")) {
    const py::object along = history.attr("coords")[history.attr("dims")[py::int_(0)]];
    const double factor = io::seconds_in(attribute_of(along, "units"), "history, units of the times");
    const py::object times = seconds(along.attr("values"));
    return {factor == 1.0 ? times : times * py::float_(factor), history.attr("values")};
  }
  if (py::hasattr(history, "to_numpy") && py::hasattr(history, "index")) {
    expect_times(history.attr("index"));
    return {seconds(history.attr("index")), history.attr("to_numpy")()};
  }
  if (py::isinstance<py::tuple>(history) && py::len(history) == 2)
    return {seconds(history[py::int_(0)]), history[py::int_(1)]};
  throw InputError(
      "history: a pandas.Series whose index is time [s], an xarray.DataArray along time, or a pair (times, values) is "
      "expected");
}

/// Numbers in different units are not put together.
void expect_same_unit(const LoadHistory& one, const LoadHistory& other) {
  if (one.unit.empty() || other.unit.empty() || one.unit == other.unit) return;
  throw InputError(Complaint{"histories",
                             fmt::format("'{}' is in '{}', and '{}' in '{}'", printable(one.column),
                                         printable(one.unit), printable(other.column), printable(other.unit)),
                             "one unit in all", "convert the values, and set attrs[\"units\"]"});
}

LoadHistory load_of(const py::object& history) {
  const auto [times, values] = times_and_values(history);
  const Array t = samples(times, "times"), x = samples(values, "values");
  if (t.size() != x.size()) throw InputError(fmt::format("history: {} times and {} values", t.size(), x.size()));
  LoadHistory load;
  load.column = py::hasattr(history, "name") && !history.attr("name").is_none()
                    ? py::str(history.attr("name")).cast<std::string>()
                    : "load";
  load.unit = attribute_of(history, "units");
  load.start = attribute_of(history, "start");
  for (py::ssize_t i = 0; i < t.size(); ++i) {
    if (std::isnan(x.data()[i])) {
      ++load.n_missing;
      continue;
    }
    load.history.times.push_back(t.data()[i]);
    load.history.values.push_back(x.data()[i]);
  }
  load.even = statistics::make_even(load.history);
  load.marker = analysis::missing_marker(load.history.values, 1.0);
  return load;
}

/// One history, or a list of histories. In a list, those without a unit have the unit of the others.
std::vector<LoadHistory> loads_of(const py::object& histories) {
  std::vector<LoadHistory> loads;
  if (!py::isinstance<py::list>(histories)) return {load_of(histories)};
  for (const py::handle one : histories) loads.push_back(load_of(py::reinterpret_borrow<py::object>(one)));
  if (loads.empty()) throw InputError("histories: the list is empty");
  const auto states_unit = [](const LoadHistory& load) { return !load.unit.empty(); };
  const auto first = std::ranges::find_if(loads, states_unit);
  if (first == loads.end()) return loads;
  for (LoadHistory& load : loads) {
    expect_same_unit(*first, load);
    load.unit = first->unit;
  }
  return loads;
}

py::object read(const py::object& path, const std::string& column, std::optional<double> start,
                std::optional<double> end, double dt, const std::string& as, const std::vector<double>& missing) {
  analysis::HistoryChoice choice;
  choice.column = column;
  choice.has_from = start.has_value();
  choice.from = start.value_or(0.0);
  choice.to = end;
  choice.dt = dt;
  choice.missing = missing;
  choice.notes = say_note;
  const std::string name = path_of(path);
  const LoadHistory load = unlocked([&] { return analysis::read_history(analysis::history_file(name), choice); });
  if (load.marker && PyErr_WarnEx(PyExc_UserWarning, analysis::marker_warning(load.marker).c_str(), 1) < 0)
    throw py::error_already_set();
  const py::array times = to_array(load.history.times), values = to_array(load.history.values);
  if (as == "numpy")
    return py::module_::import("brash").attr("History")(times, values, load.column, load.unit, load.start);
  if (as == "pandas") {
    const py::object index = py::module_::import("pandas").attr("Index")(times, "name"_a = "time");
    py::object series = py::module_::import("pandas").attr("Series")(values, "index"_a = index, "name"_a = load.column);
    series.attr("attrs")["units"] = load.unit;
    if (!load.start.empty()) series.attr("attrs")["start"] = load.start;
    return series;
  }
  if (as == "xarray") {
    const py::object in_seconds = py::make_tuple("time", times, py::dict("units"_a = "s"));
    py::dict attributes("units"_a = load.unit);
    if (!load.start.empty()) attributes["start"] = load.start;
    return py::module_::import("xarray").attr("DataArray")(values, "coords"_a = py::dict("time"_a = in_seconds),
                                                           "dims"_a = py::make_tuple("time"), "name"_a = load.column,
                                                           "attrs"_a = attributes);
  }
  throw InputError(fmt::format("as_: '{}' is not allowed; numpy, pandas or xarray", as));
}

statistics::ExtremeSettings extreme_settings(double return_period, double block, std::optional<double> threshold,
                                             std::optional<double> dead_band, bool extrapolate) {
  require(return_period > 0.0 && return_period < kLongest, "return_period", return_period, "in (0, 1e12) s");
  require(block >= 0.0 && block < kLongest, "block", block, "in (0, 1e12) s, or 0 for the default");
  if (threshold) require(std::isfinite(*threshold), "threshold", *threshold, "a finite load");
  if (dead_band) require(*dead_band >= 0.0 && *dead_band < 1e6, "dead_band", *dead_band, "in [0, 1e6) deviations");
  statistics::ExtremeSettings settings;
  settings.return_period = return_period;
  settings.block = block;
  settings.threshold = threshold;
  settings.dead_band = dead_band;
  settings.extrapolate = extrapolate;
  return settings;
}

py::object extremes(const py::object& histories, double return_period, double block, std::optional<double> threshold,
                    std::optional<double> dead_band, bool extrapolate) {
  return with_arguments_of("extremes", [&] {
    const auto settings = extreme_settings(return_period, block, threshold, dead_band, extrapolate);
    const std::vector<LoadHistory> loads = loads_of(histories);
    std::vector<statistics::ExtremeRecord> records;
    for (const LoadHistory& load : loads)
      records.push_back({&load.history, &load.even, statistics::autocorrelation_time(load.history, load.even).tau});
    return from_json(unlocked([&] {
      statistics::GoodnessOfFit goodness;
      ordered_json out;
      analysis::add_extremes(
          statistics::analyse_extremes(statistics::extreme_values(records, settings), settings, goodness), out);
      return out.dump();
    }));
  });
}

py::object stats(const py::object& history, double return_period, const std::vector<double>& exponents,
                 double frequency, bool extrapolate) {
  return with_arguments_of("stats", [&] {
    analysis::StatisticsSettings settings;
    settings.extremes = extreme_settings(return_period, 0.0, std::nullopt, std::nullopt, extrapolate);
    for (const double m : exponents) require(m >= 1.0 && m <= 20.0, "exponents", m, "from 1 to 20");
    require(frequency > 0.0 && frequency < 1e9, "frequency", frequency, "in (0, 1e9) Hz");
    settings.exponents = exponents;
    settings.frequency = frequency;
    const LoadHistory load = load_of(history);
    return from_json(unlocked([&] { return analysis::statistics_of(load, settings).dump(); }));
  });
}

py::dict events(const py::object& history, std::optional<double> dead_band) {
  return with_arguments_of("load_events", [&] {
    if (dead_band) require(*dead_band >= 0.0 && *dead_band < 1e6, "dead_band", *dead_band, "in [0, 1e6) deviations");
    const LoadHistory load = load_of(history);
    const statistics::Moments m = statistics::moments(load.history.values, load.even.weights);
    if (statistics::acts_downwards(m.mean, m.minimum, m.maximum) &&
        PyErr_WarnEx(PyExc_UserWarning, statistics::kNegativeMean, 1) < 0)
      throw py::error_already_set();
    const auto found = analysis::events_of(load, dead_band);
    py::dict out;
    const auto add = [&](const char* name, auto member) {
      std::vector<double> column;
      for (const statistics::LoadEvent& event : found) column.push_back(member(event));
      out[name] = to_array(std::span<const double>(column));
    };
    using Event = statistics::LoadEvent;
    add("start", [](const Event& e) { return e.start; });
    add("end", [](const Event& e) { return e.end; });
    add("peak_time", [](const Event& e) { return e.peak_time; });
    add("peak", [](const Event& e) { return e.peak; });
    add("impulse", [](const Event& e) { return e.impulse; });
    add("rise", [](const Event& e) { return e.rise(); });
    add("fall", [](const Event& e) { return e.fall(); });
    return out;
  });
}

py::dict spectrum(const py::object& history, double segment) {
  return with_arguments_of("spectrum", [&] {
    require(segment >= 0.0 && segment < kLongest, "segment", segment, "in (0, 1e12) s, or 0 for an eighth");
    const LoadHistory load = load_of(history);
    const auto found = unlocked([&] { return analysis::spectrum_of(load, segment); });
    if (!found) throw InputError("spectrum: the history or the segment is shorter than 16 samples");
    const statistics::Interval factors = statistics::spectrum_factors(*found);
    const py::array density = to_array(found->density);
    py::dict out;
    out["frequency"] = to_array(found->frequency);
    out["density"] = density;
    out["lower_95"] = density * py::float_(factors.lower);
    out["upper_95"] = density * py::float_(factors.upper);
    return out;
  });
}

py::tuple cycles(const py::object& values) {
  return with_arguments_of("rainflow", [&] {
    const Array array = samples(values, "samples");
    std::vector<double> ranges, means, counts;
    for (const statistics::Cycle& cycle : statistics::rainflow(span_of(array))) {
      ranges.push_back(cycle.range);
      means.push_back(cycle.mean);
      counts.push_back(cycle.count);
    }
    return py::make_tuple(to_array(std::span<const double>(ranges)), to_array(std::span<const double>(means)),
                          to_array(std::span<const double>(counts)));
  });
}

py::object compare(const py::object& run, const py::object& measured) {
  return with_arguments_of("compare", [&] {
    const std::vector<LoadHistory> first = loads_of(run), second = loads_of(measured);
    expect_same_unit(first.front(), second.front());
    return from_json(unlocked([&] { return analysis::compare_histories(first, second).dump(); }));
  });
}

/// Questions of `brash design`, from arguments that both calls share.
analysis::DesignSettings design_settings(const std::vector<double>& hours, const std::vector<double>& years,
                                         const std::vector<double>& exponents, double frequency) {
  analysis::DesignSettings asked;
  for (const double h : hours) require(h >= 1e-3 && h <= 1e9, "hours", h, "from 1e-3 to 1e9");
  for (const double y : years) require(y >= 0.1 && y <= 1e7, "years", y, "from 0.1 to 1e7");
  for (const double m : exponents) require(m >= 1.0 && m <= 20.0, "exponents", m, "from 1 to 20");
  require(frequency > 0.0 && frequency < 1e9, "frequency", frequency, "in (0, 1e9) Hz");
  asked.hours = hours;
  asked.years = years;
  asked.exponents = exponents;
  asked.frequency = frequency;
  return asked;
}

py::object design(const py::object& campaign, const std::string& column, const std::vector<double>& hours,
                  const py::object& scatter, const std::vector<double>& years, const std::vector<double>& exponents,
                  double frequency, const std::string& where) {
  return with_arguments_of("design", [&] {
    analysis::DesignSettings asked = design_settings(hours, years, exponents, frequency);
    analysis::HistoryChoice choice;
    choice.column = column;
    choice.notes = say_note;
    const std::string folder = path_of(campaign), table = scatter.is_none() ? "" : path_of(scatter);
    return from_json(unlocked([&] {
      const auto settings = analysis::read_campaign_histories(folder, choice, where);
      if (!table.empty()) asked.hours_a_year = analysis::read_scatter(table, settings);
      return analysis::design_of(settings, asked).json.dump();
    }));
  });
}

py::object return_levels(const py::dict& states, const std::vector<double>& years) {
  return with_arguments_of("return_levels", [&] {
    analysis::DesignSettings asked = design_settings({}, years, {}, 1.0);
    std::vector<analysis::SettingHistories> settings;
    for (const auto& [name, state] : states) {
      const auto pair = py::reinterpret_borrow<py::object>(state);
      if (!py::isinstance<py::tuple>(pair) || py::len(pair) != 2)
        throw InputError("return_levels: a state is (hours a year, a history or a list of them)");
      const auto hours = pair[py::int_(0)].cast<double>();
      require(hours >= 0.0 && hours <= 8784.0, "hours a year", hours, "from 0 to 8784");
      settings.push_back({py::str(name).cast<std::string>(), {}, loads_of(pair[py::int_(1)]), {}});
      asked.hours_a_year.push_back(hours);
    }
    if (settings.empty()) throw InputError("return_levels: one state at least");
    for (const analysis::SettingHistories& setting : settings)
      expect_same_unit(settings.front().replicates.front(), setting.replicates.front());
    return from_json(unlocked([&] { return analysis::design_of(settings, asked).json.dump(); }));
  });
}

/// The net thrust of a ship, if any of the arguments states it.
std::optional<analysis::NetThrust> net_thrust(std::optional<double> bollard_pull,
                                              std::optional<double> open_water_speed, const py::object& table) {
  if (bollard_pull.has_value() != open_water_speed.has_value() || (bollard_pull && !table.is_none()))
    throw InputError("resistance: bollard_pull and open_water_speed together, or thrust alone, or none of them");
  if (!table.is_none()) return analysis::NetThrust::from_table(path_of(table));
  if (!bollard_pull) return std::nullopt;
  require(*bollard_pull > 0.0, "bollard_pull", *bollard_pull, "above 0 N");
  require(*open_water_speed > 0.0, "open_water_speed", *open_water_speed, "above 0 m/s");
  return analysis::NetThrust::from_bollard_pull(*bollard_pull, *open_water_speed);
}

py::object resistance(const py::object& campaign, std::optional<double> bollard_pull,
                      std::optional<double> open_water_speed, const py::object& table, double at_speed) {
  return with_arguments_of("resistance", [&] {
    require(at_speed > 0.0, "at_speed", at_speed, "above 0 m/s");
    const auto thrust = net_thrust(bollard_pull, open_water_speed, table);
    const std::string folder = path_of(campaign);
    return from_json(unlocked([&] { return analysis::resistance_of(folder, thrust, at_speed).dump(); }));
  });
}

}  // namespace

void add_load_histories(py::module_& m) {
  m.def("read_history", &read, "path"_a, "column"_a = "", "start"_a = py::none(), "end"_a = py::none(), "dt"_a = 0.0,
        "as_"_a = "numpy", "missing"_a = std::vector<double>(),
        "One column of a CSV, netCDF or OpenFAST file (.out) against time [s], in SI: a History, which is a pair "
        "(times, values), a pandas.Series "
        "or an xarray.DataArray, from `start` on: with it, but for a run, whose samples are the ends of steps. The "
        "history of a run has its settling too: "
        "`statistics_from` of its summary says where its statistics begin. dt: step of a file without times. missing: "
        "values that stand for a missing one, "
        "in the file's unit. Dates become seconds after the first one, which is attrs[\"start\"].");
  m.def("load_events", &events, "history"_a, "dead_band"_a = py::none(),
        "Load events about the mean: a dict of arrays, shape (n,), that pandas.DataFrame takes. `impulse` is of the "
        "whole "
        "load from start to end, also of what lies below the mean. dead_band in deviations, left out from the noise "
        "floor. A history is a pandas.Series whose index is time [s], an xarray.DataArray along time, or (times, "
        "values).");
  m.def(
      "extremes", &extremes, "histories"_a, "return_period"_a, "block"_a = 0.0, "threshold"_a = py::none(),
      "dead_band"_a = py::none(), "extrapolate"_a = false,
      "Five laws of extremes with levels of `return_period` [s], and one recommended with its reason, as `brash stats "
      "--json`. A list of histories is pooled as replicates.");
  m.def("stats", &stats, "history"_a, "return_period"_a = 3600.0, "exponents"_a = std::vector<double>(),
        "frequency"_a = 1.0, "extrapolate"_a = false,
        "All that `brash stats --json` prints of a history, from its first sample on: a pandas.Series whose index is "
        "time [s], an xarray.DataArray along time, or (times, values).");
  m.def(
      "spectrum", &spectrum, "history"_a, "segment"_a = 0.0,
      "Welch's spectrum of a history, even or not, as `brash stats --spectrum` writes it: a dict of arrays, frequency "
      "[Hz] and density with its 95 % band. segment [s]: an eighth of the longest piece without one.");
  m.def("rainflow", &cycles, "samples"_a,
        "(ranges, means, counts) of the cycles by ASTM E1049, shape (n,) each; counts are 1 and 0.5.");
  m.def("compare", &compare, "run"_a, "measured"_a,
        "All that `brash compare --json` prints; a list of histories on a side are replicates. Different units, the "
        "attrs[\"units\"] of an xarray.DataArray, are refused.");
  m.def("design", &design, "campaign"_a, "column"_a = "Fx", "hours"_a = std::vector<double>{1.0},
        "scatter"_a = py::none(), "years"_a = std::vector<double>{1.0, 10.0, 50.0, 100.0},
        "exponents"_a = std::vector<double>(), "frequency"_a = 1.0, "where"_a = "",
        "Design loads of a campaign's folder, as `brash design --json`.");
  m.def("return_levels", &return_levels, "states"_a, "years"_a = std::vector<double>{1.0, 10.0, 50.0, 100.0},
        "Loads that are exceeded once in so many years, with 95 % intervals, as `annual` of `brash design --json`. "
        "states: {name: (hours a year, history or list of histories)}; a list is replicates. One Pareto shape is "
        "fitted to the peaks of all states. A history is a pandas.Series whose index is time [s], an xarray.DataArray "
        "along time, or (times, values).");
  m.def("resistance", &resistance, "campaign"_a, "bollard_pull"_a = py::none(), "open_water_speed"_a = py::none(),
        "thrust"_a = py::none(), "at_speed"_a = analysis::kThreeKnots,
        "Resistance of a ship from the folder of a campaign over thickness and speed, as `brash resistance --json`, in "
        "SI. With the bollard pull [N] and the speed in open water [m/s], or `thrust`, a CSV of both, also the speed "
        "that the thrust attains at each thickness, and the thickness at `at_speed` [m/s].");
}

}  // namespace brash::python
