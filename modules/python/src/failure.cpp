// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "brash/analysis/closed_forms.hpp"
#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/failure/criterion.hpp"
#include "brash/failure/edge_break.hpp"
#include "brash/failure/edge_responses.hpp"
#include "brash/failure/response_model.hpp"
#include "case.hpp"
#include "convert.hpp"
#include "rooms.hpp"
#include "signals.hpp"

namespace brash::python {
namespace {

using failure::IceProperties;
using failure::ResponseModel;

/// Range of one argument; `open` leaves out the lower end.
struct Allowed {
  const char* name;
  double least;
  bool open;
  double most;
  bool closed = false;  ///< the upper end is allowed

  bool contains(double v) const { return (open ? v > least : v >= least) && (closed ? v <= most : v < most); }
};

constexpr double kAny = 1e300;
constexpr Allowed kDepth{"b_lc", -5.0, false, kAny};
constexpr Allowed kAngle{"theta", 0.0, false, kPi};
constexpr Allowed kMu1{"mu1", 0.0, true, kAny};
constexpr double kFastest = 50.0;  // as structure.speed [m/s]
constexpr Allowed kMu2{"mu2", -kAny, true, kAny};

/// Arguments of one vectorised call, broadcast against each other; every value checked.
template <std::size_t n>
class Columns {
 public:
  Columns(const std::array<py::object, n>& values, const std::array<Allowed, n>& allowed) {
    py::tuple arrays(n);
    for (std::size_t i = 0; i < n; ++i) arrays[i] = numbers(values[i], allowed[i].name);
    py::object broadcast;
    try {
      broadcast = py::module_::import("numpy").attr("broadcast_arrays")(*arrays);
    } catch (py::error_already_set& error) {
      if (!error.matches(PyExc_ValueError)) throw;
      std::string shapes;
      for (std::size_t i = 0; i < n; ++i)
        shapes += fmt::format("{}{} {}", i == 0 ? "" : ", ", allowed[i].name, shape_text(Array(arrays[i])));
      throw InputError("the shapes cannot be broadcast together: " + shapes);
    }
    std::size_t i = 0;
    for (const py::handle array : broadcast) columns_[i++] = ensured<Array>(array);
    for (i = 0; i < n; ++i) expect(span_of(columns_[i]), allowed[i]);
  }

  std::size_t size() const { return static_cast<std::size_t>(columns_[0].size()); }
  double at(std::size_t column, std::size_t row) const { return columns_[column].data()[row]; }
  /// An array of the common shape.
  template <typename T>
  py::array_t<T> like() const {
    return py::array_t<T>(std::vector<py::ssize_t>(columns_[0].shape(), columns_[0].shape() + columns_[0].ndim()));
  }

 private:
  static void expect(std::span<const double> values, const Allowed& a) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double v = values[i];
      if (a.contains(v)) continue;
      throw InputError(fmt::format("{}: value {} (number {}) is not allowed; must be {} {}{}{}", a.name, v, i,
                                   a.open ? ">" : ">=", a.least,
                                   a.most < kAny ? fmt::format(" and {} {}", a.closed ? "<=" : "<", a.most) : "",
                                   std::isfinite(v) ? "" : ", finite"));
    }
  }

  std::array<Array, n> columns_;
};

/// A named tuple type of the module, made once.
py::object named_tuple(py::module_& m, const char* name, const char* fields, const char* doc) {
  py::object type = py::module_::import("collections").attr("namedtuple")(name, fields);
  type.attr("__doc__") = doc;
  type.attr("__module__") = m.attr("__name__");
  m.attr(name) = type;
  return type;
}

py::object respond(const ResponseModel& model, const py::object& type, const py::object& b_lc, const py::object& c_lc,
                   const py::object& theta, const py::object& mu1, const py::object& mu2,
                   const py::object& thickness_over_lc) {
  const py::object h = thickness_over_lc.is_none() ? py::float_(0.0) : thickness_over_lc;
  const Allowed thickness{"thickness_over_lc", 0.0, !thickness_over_lc.is_none(), kAny};
  const Columns<6> x({b_lc, c_lc, theta, mu1, mu2, h},
                     {kDepth, {"c_lc", 0.0, true, kAny}, kAngle, kMu1, kMu2, thickness});
  auto sigma = x.like<double>(), length = x.like<double>();
  auto in_range = x.like<bool>();
  double* const sigma_at = sigma.mutable_data();
  double* const length_at = length.mutable_data();
  bool* const in_range_at = in_range.mutable_data();
  without_gil(x.size(), [&](std::size_t i) {
    const auto y = model.respond({x.at(0, i), x.at(1, i), x.at(2, i), x.at(3, i), x.at(4, i)}, x.at(5, i));
    sigma_at[i] = y.sigma_over_p;
    length_at[i] = y.lbreak_over_lc;
    in_range_at[i] = y.in_range;
  });
  return type(sigma, length, in_range);
}

py::object assess(const failure::BendingCriterion& criterion, const py::object& type, const py::object& depth,
                  const py::object& contact_length, const py::object& angle, const py::object& mu1,
                  const py::object& mu2, const py::object& pressure) {
  const Columns<6> x({depth, contact_length, angle, mu1, mu2, pressure}, {Allowed{"depth", 0.0, false, kAny},
                                                                          {"contact_length", 0.0, true, kAny},
                                                                          {"angle", 0.0, false, kPi},
                                                                          kMu1,
                                                                          kMu2,
                                                                          {"pressure", 0.0, false, kAny}});
  auto fails = x.like<bool>(), in_range = x.like<bool>();
  auto sigma = x.like<double>(), length = x.like<double>();
  bool* const fails_at = fails.mutable_data();
  bool* const in_range_at = in_range.mutable_data();
  double* const sigma_at = sigma.mutable_data();
  double* const length_at = length.mutable_data();
  without_gil(x.size(), [&](std::size_t i) {
    const failure::Assessment y = criterion.assess({.depth = x.at(0, i),
                                                    .contact_length = x.at(1, i),
                                                    .angle = x.at(2, i),
                                                    .mu1 = x.at(3, i),
                                                    .mu2 = x.at(4, i),
                                                    .pressure = x.at(5, i)});
    fails_at[i] = y.fails;
    sigma_at[i] = y.sigma_max;
    length_at[i] = y.breaking_length;
    in_range_at[i] = !y.below_range && !y.above_range;
  });
  return type(fails, sigma, length, in_range);
}

py::object load_ratios(const py::object& type, const py::object& slope, const py::object& friction,
                       const py::object& heading) {
  const Columns<3> x(
      {slope, friction, heading},
      {Allowed{"slope", 0.0, true, kPi / 2, true}, {"friction", 0.0, false, kAny}, {"heading", -kAny, true, kAny}});
  auto horizontal = x.like<double>(), mu1 = x.like<double>(), mu2 = x.like<double>();
  for (std::size_t i = 0; i < x.size(); ++i) {
    const failure::LoadRatios y = failure::load_ratios(x.at(0, i), x.at(1, i), x.at(2, i));
    horizontal.mutable_data()[i] = y.horizontal;
    mu1.mutable_data()[i] = y.mu1;
    mu2.mutable_data()[i] = y.mu2;
  }
  return type(horizontal, mu1, mu2);
}

IceProperties ice_of(const Case& c) {
  return {.thickness = c.resolved.ice.thickness,
          .youngs_modulus = c.resolved.ice.youngs_modulus,
          .poisson_ratio = c.resolved.ice.poisson_ratio,
          .flexural_strength = c.resolved.ice.flexural_strength,
          .compressive_strength = c.resolved.ice.compressive_strength,
          .crushing_factor = c.resolved.ice.crushing_factor,
          .water_density = c.resolved.water.density,
          .length_density = c.resolved.failure.length_density == model::LengthDensity::kIce
                                ? std::optional(c.resolved.ice.density)
                                : std::nullopt};
}

void add_failure_model(py::module_& m) {
  const py::object response = named_tuple(m, "Response", "sigma_over_p lbreak_over_lc in_range",
                                          "Arrays of the common shape: sigma_max/p [-], l_break/l_c [-], and False "
                                          "where an input was moved into the model's range.");
  py::class_<ResponseModel>(m, "FailureModel",
                            R"(A failure model without a case: the inputs of Eq. 17 in, its outputs out.

model: "network", "deep-network" or "superposition" (those that come with the program), "fem" (the plate is solved for
each row, about a third of a second), or the path of a model file.

>>> model = brash.FailureModel("network")
>>> model(b_lc=0.2, c_lc=np.linspace(0.05, 0.5, 10), theta=1.0, mu1=0.5, mu2=0.0).sigma_over_p)")
      .def(py::init(&failure::make_response_model), py::arg("model") = "network")
      .def(
          "__call__",
          [response](const ResponseModel& model, const py::object& b_lc, const py::object& c_lc,
                     const py::object& theta, const py::object& mu1, const py::object& mu2,
                     const py::object& thickness_over_lc) {
            return respond(model, response, b_lc, c_lc, theta, mu1, mu2, thickness_over_lc);
          },
          py::arg("b_lc"), py::arg("c_lc"), py::arg("theta"), py::arg("mu1"), py::arg("mu2"),
          py::arg("thickness_over_lc") = py::none(),
          "Arrays of any shapes that broadcast: b/l_c (negative: a bay), c/l_c > 0, theta in [0, pi) [rad], mu1 > 0, "
          "mu2, and h/l_c "
          "(left out: the value of the training rows; 0.1 for the plate). Returns a Response.");
}

model::FailureModel model_named(const std::string& name) {
  if (const auto known = model::named<model::FailureModel>(name)) return *known;
  throw InputError(Complaint{"model '" + name + "'", "is not a failure model",
                             "network, deep-network, superposition, plate, plate-outline, wedge", "take one of these"});
}

/// The case read again with another model, because `c` has lost the options that its own model does not take. Options
/// that the other one does not take are left out, and so is the file of the own model.
Case with_model(const Case& c, model::FailureModel model) {
  const model::FailureOptions takes = model::options_of(model, false);
  py::dict changes;
  changes["failure.model"] = std::string(model::name_of(model));
  changes["failure.file"] = "";
  if (!takes.second_order) changes["failure.second_order"] = false;
  if (!takes.radial_first) changes["failure.order"] = "circumferential-first";
  if (!takes.knows_field) changes["failure.judged"] = "centre-line", changes["failure.pattern"] = "disc";
  if (!takes.moving_edge) changes["failure.edge"] = "static";
  if (!takes.joint_loads) changes["failure.joint_loads"] = false;
  if (!takes.meta_model) changes["failure.pressure"] = "edge", changes["failure.length_density"] = "water";
  return with_changes(c, changes);
}

std::unique_ptr<failure::BendingCriterion> own_criterion(const Case& c) {
  const model::FailureSection& section = c.resolved.failure;
  return failure::make_criterion(section.model, section.file, ice_of(c),
                                 {.second_order = section.second_order,
                                  .radial_first = section.order == model::CrackOrder::kRadialFirst,
                                  .anywhere = section.judged == model::JudgedAt::kAnywhere,
                                  .trace_crack = section.pattern == model::CrackPattern::kStress,
                                  .keeps_pressure = section.small_contact == model::SmallContact::kKeepsPressure});
}

/// The criterion of a case, or of the same case with another model.
std::unique_ptr<failure::BendingCriterion> criterion_of(const Case& c, const py::object& name) {
  const model::FailureModel model = name.is_none() ? c.resolved.failure.model : model_named(name.cast<std::string>());
  return own_criterion(model == c.resolved.failure.model ? c : with_model(c, model));
}

void add_criterion(py::module_& m) {
  const py::object assessment =
      named_tuple(m, "Assessment", "fails sigma_max breaking_length in_range",
                  "Arrays of the common shape: whether the ice fails, sigma_max [Pa], l_break [m], and False where an "
                  "input was moved into the model's range.");
  py::class_<failure::BendingCriterion>(m, "Criterion", R"(Whether the ice of a case fails in bending, and how far in.

The ice is at rest, whatever failure.edge of the case says; MovingEdge has the moving edge. It is even: ice.variation is
left out. The edge is a trapezoid with one load, without neighbours, for plate-outline too.

model: network, deep-network, superposition, plate, plate-outline or wedge, with those options of the case that it takes;
left out, that of the case.)")
      .def(py::init(&criterion_of), py::arg("case"), py::arg("model") = py::none())
      .def(
          "__call__",
          [assessment](const failure::BendingCriterion& criterion, const py::object& depth,
                       const py::object& contact_length, const py::object& angle, const py::object& mu1,
                       const py::object& mu2, const py::object& pressure) {
            return assess(criterion, assessment, depth, contact_length, angle, mu1, mu2, pressure);
          },
          py::arg("depth"), py::arg("contact_length"), py::arg("angle"), py::arg("mu1"), py::arg("mu2"),
          py::arg("pressure"),
          "Arrays of any shapes that broadcast: b >= 0 [m], c > 0 [m], theta in [0, pi) [rad], mu1 > 0, mu2, p >= 0 "
          "[Pa]. Returns an Assessment.");
}

/// A moving edge, the ice and water of a case, and the slope of its structure.
class MovingEdge {
 public:
  MovingEdge(const Case& c, const std::string& model)
      : ice_(ice_of(c)),
        mass_ratio_(failure::mass_ratio(ice_, c.resolved.ice.density)),
        slope_(analysis::waterline_slope(c.resolved)),
        friction_(c.resolved.ice.friction_structure),
        edges_(model) {
    if (!(slope_ < 0.5 * kPi))
      throw InputError(Complaint{"case", "has a vertical wall at the waterline, which does not bend the ice",
                                 "a structure that slopes", "take another case"});
  }

  py::object operator()(const py::object& type, const py::object& b_lc, const py::object& c_lc, const py::object& theta,
                        const py::object& speed, const py::object& mu1) const {
    const py::object ratio = mu1.is_none() ? py::float_(failure::load_ratios(slope_, friction_, 0.0).mu1) : mu1;
    const Columns<5> x({b_lc, c_lc, theta, speed, ratio}, {kDepth,
                                                           {"c_lc", 0.0, true, kAny},
                                                           {"theta", 0.0, false, kPi},
                                                           {"speed", 0.0, false, kFastest, true},
                                                           {"mu1", 0.0, true, kAny}});
    auto load = x.like<double>(), time = x.like<double>(), give = x.like<double>(), length = x.like<double>();
    auto radial = x.like<bool>(), in_range = x.like<bool>();
    double* const load_at = load.mutable_data();
    double* const time_at = time.mutable_data();
    double* const give_at = give.mutable_data();
    double* const length_at = length.mutable_data();
    bool* const radial_at = radial.mutable_data();
    bool* const in_range_at = in_range.mutable_data();
    const double l_c = failure::characteristic_length(ice_);
    plate::EdgeGeometry solved;  // speeds often vary fastest
    std::optional<failure::EdgeSource::Answer> answer;
    without_gil(x.size(), [&](std::size_t i) {
      const failure::EdgePush push{.speed = x.at(3, i),
                                   .slope = slope_,
                                   .friction = friction_,
                                   .mu1 = x.at(4, i),
                                   .contact_length = x.at(1, i) * l_c};
      const plate::EdgeGeometry wanted{.depth = x.at(0, i),
                                       .contact_length = x.at(1, i),
                                       .angle = x.at(2, i),
                                       .mass_ratio = mass_ratio_,
                                       .thickness = ice_.thickness / l_c};
      if (!answer || wanted != solved) answer = edges_.at(solved = wanted);
      const auto& [responses, inside] = *answer;
      const failure::EdgeBreak b = push.speed > 0.0 ? failure::break_edge(responses, ice_, push)
                                                    : failure::break_edge_at_rest(responses, ice_, push);
      load_at[i] = b.load;
      time_at[i] = b.time;
      give_at[i] = b.deflection;
      length_at[i] = b.breaking_length;
      radial_at[i] = b.radial_first;
      in_range_at[i] = inside;
    });
    return type(load, time, give, length, radial, in_range);
  }

 private:
  IceProperties ice_;
  double mass_ratio_, slope_, friction_;
  failure::EdgeSource edges_;
};

void add_moving_edge(py::module_& m) {
  const py::object broken = named_tuple(
      m, "EdgeBreak", "load time deflection breaking_length radial_first in_range",
      "Arrays of the common shape: N at the circumferential crack [N], its time from the first touch [s], the "
      "deflection of B [m], l_break [m], whether a radial crack came first, and False where an input was moved into "
      "the model's range.");
  py::class_<MovingEdge>(m, "MovingEdge",
                         R"(How the structure of a case breaks the ice edge at some speed, with inertia and water.

The sheet stays whole after a radial crack, whatever failure.order of the case says. Its stress in the plane is static
and does not bend it further, whatever failure.second_order says.

model: path of a model file, or "fem" (plate and water are solved for each row, some seconds); left out, the model that
comes with the program.

>>> edge = brash.MovingEdge(case)
>>> edge(b_lc=0.0, c_lc=0.3, theta=0.0, speed=[0.0, 0.2, 1.2]).load)")
      .def(py::init<const Case&, const std::string&>(), py::arg("case"), py::arg("model") = "")
      .def(
          "__call__",
          [broken](const MovingEdge& edge, const py::object& b_lc, const py::object& c_lc, const py::object& theta,
                   const py::object& speed,
                   const py::object& mu1) { return edge(broken, b_lc, c_lc, theta, speed, mu1); },
          py::arg("b_lc"), py::arg("c_lc"), py::arg("theta"), py::arg("speed"), py::arg("mu1") = py::none(),
          "Arrays of any shapes that broadcast: b/l_c (negative: a bay), c/l_c > 0, theta in [0, pi) [rad], speed >= 0 "
          "[m/s] (0: "
          "the "
          "static plate), mu1 > 0 (left out: of the case's slope, met squarely). Returns an EdgeBreak.");
}

}  // namespace

void add_failure(py::module_& m) {
  add_failure_model(m);
  add_moving_edge(m);
  add_criterion(m);
  m.def(
      "characteristic_length", [](const Case& c) { return failure::characteristic_length(ice_of(c)); }, py::arg("case"),
      "l_c of the case's ice [m], Eq. 18.");
  const py::object ratios = named_tuple(m, "LoadRatios", "horizontal mu1 mu2",
                                        "Per unit normal contact force: the in-plane normal N, P/N and f/N.");
  m.def(
      "load_ratios",
      [ratios](const py::object& slope, const py::object& friction, const py::object& heading) {
        return load_ratios(ratios, slope, friction, heading);
      },
      py::arg("slope"), py::arg("friction"), py::arg("heading") = 0.0,
      "A contact on a surface that slopes at `slope` from the horizontal [rad], in (0, pi/2], and slides against the "
      "ice with friction >= 0; heading: direction of motion from the contact's plan normal [rad]. Arrays broadcast.");
}

}  // namespace brash::python
