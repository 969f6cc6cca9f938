// SPDX-License-Identifier: GPL-3.0-or-later
// The model of a moving edge on responses that are known in closed form.
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "brash/core/error.hpp"
#include "brash/meta_model/edge_responses.hpp"
#include "brash/meta_model/network.hpp"
#include "grid_axis.hpp"
#include "json_file.hpp"

namespace meta_model = brash::meta_model;
using meta_model::EdgeGeometry;
using meta_model::EdgeResponses;

namespace {

/// Smooth in all that a response depends on; the times follow the mass ratio as the model says.
EdgeResponses responses(const EdgeGeometry& g) {
  EdgeResponses r;
  const double factor =
      std::sqrt((g.mass_ratio + brash::plate::kMassShift) / (brash::plate::kUsualMass + brash::plate::kMassShift));
  const double size = std::log(1.0 + g.contact_length) * (1.0 + 0.3 * g.depth + 0.1 * g.angle + 0.2 * g.thickness);
  for (int i = 0; i <= 200; ++i) r.station.push_back(g.depth + 0.02 * i - g.depth * (1.0 - i / 200.0));
  const auto moment = [&](double x, double grown) { return size * grown * x * std::exp(-x); };
  for (int i = 0; i < 12; ++i) {
    const double t = 0.03 * std::pow(1.6, i);
    const double grown = t / (1.0 + t);
    r.time.push_back(factor * t);
    r.deflection.push_back(2.0 * size * grown);
    r.edge_moment.push_back(-size * grown);
    for (const double x : r.station) r.axis_moment.push_back(moment(x, grown));
  }
  r.static_deflection = 2.0 * size;
  r.static_edge_moment = -size;
  for (const double x : r.station) {
    r.static_axis_moment.push_back(moment(x, 1.0));
    r.axis_normal.push_back(-std::exp(-x));
  }
  r.edge_normal = -0.5;
  return r;
}

std::vector<meta_model::EdgeSample> samples(bool with_split) {
  std::vector<meta_model::EdgeSample> result;
  for (const bool split : {false, true}) {
    if (split && !with_split) break;
    for (const double b : {0.0, 0.2, 0.5, 0.9, 1.4})
      for (const double theta : {0.0, 0.5, 1.0, 1.5, 2.0})
        for (const double c : {0.1, 0.2, 0.4, 0.8, 1.6})
          for (const double h : {0.06, 0.14}) {
            if (b == 0.0 && theta > 0.0) continue;
            const EdgeGeometry g{b, c, theta, 0.88 * h, h, split};
            result.push_back({g, responses(g)});
          }
  }
  return result;
}

struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / ("brash_edges_" + std::to_string(::getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
};

double largest(const double* values, std::size_t n) {
  double most = 0.0;
  for (std::size_t i = 0; i < n; ++i) most = std::max(most, values[i]);
  return most;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_axis_of_five_points_reproduces_cubics) {
  const std::vector<double> points{-1.0, 0.2, 0.5, 1.7, 2.0};
  const meta_model::GridAxis axis(points);
  const auto f = [](double x) { return 1.0 - 2.0 * x + 0.5 * x * x + 0.3 * x * x * x; };
  for (const double x : {-1.0, -0.4, 0.2, 0.3, 1.1, 1.9, 2.0}) {
    const Eigen::VectorXd weights = axis.weights(x);
    double value = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) value += weights(static_cast<Eigen::Index>(i)) * f(points[i]);
    BOOST_TEST(std::abs(value - f(x)) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(an_axis_of_two_points_is_linear_and_one_of_one_point_is_constant) {
  const Eigen::VectorXd two = meta_model::GridAxis({1.0, 3.0}).weights(1.5);
  BOOST_TEST(two(0) == 0.75);
  BOOST_TEST(two(1) == 0.25);
  BOOST_TEST(meta_model::GridAxis({2.0}).weights(7.0)(0) == 1.0);
}

BOOST_AUTO_TEST_CASE(the_model_of_a_moving_edge_interpolates_its_samples_and_survives_its_file) {
  const Folder folder;
  const std::string file = (folder.path / "edge.json").string();
  meta_model::EdgeResponseModel::fit(samples(true), "data").write(file);
  const auto model = meta_model::EdgeResponseModel::read(file);
  for (const bool split : {false, true}) {
    const EdgeGeometry g{0.35, 0.3, 0.7, 0.09, 0.1, split};
    const EdgeResponses found = model.at(g), wanted = responses(g);
    BOOST_REQUIRE(found.time.size() == wanted.time.size());
    BOOST_TEST(std::abs(found.static_deflection / wanted.static_deflection - 1.0) < 0.005);
    for (std::size_t i = 0; i < found.time.size(); ++i) {
      BOOST_TEST(std::abs(found.time[i] / wanted.time[i] - 1.0) < 1e-4);
      BOOST_TEST(std::abs(found.deflection[i] / wanted.deflection[i] - 1.0) < 0.01);
      BOOST_TEST(std::abs(found.edge_moment[i] / wanted.edge_moment[i] - 1.0) < 0.02);
      BOOST_TEST(std::abs(largest(found.axis_moment_at(i), found.station.size()) /
                              largest(wanted.axis_moment_at(i), wanted.station.size()) -
                          1.0) < 0.01);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_straight_edge_has_no_station_twice) {
  const auto model = meta_model::EdgeResponseModel::fit(samples(false), "data");
  const EdgeResponses r = model.at({0.0, 0.3, 0.0, 0.09, 0.1, false});
  BOOST_TEST(r.station.front() == 0.0);
  for (std::size_t i = 1; i < r.station.size(); ++i) BOOST_TEST(r.station[i] > r.station[i - 1]);
}

BOOST_AUTO_TEST_CASE(inputs_outside_the_grid_are_told_and_moved_into_it) {
  const auto model = meta_model::EdgeResponseModel::fit(samples(false), "data");
  const EdgeGeometry outside{2.0, 0.05, 1.0, 0.09, 0.1, false};
  BOOST_TEST(model.check(outside).above);
  BOOST_TEST(model.check(outside).below);
  BOOST_TEST(model.check(model.clamp(outside)).inside());
}

BOOST_AUTO_TEST_CASE(a_grid_with_a_hole_is_refused) {
  auto holed = samples(false);
  holed.pop_back();
  BOOST_CHECK_EXCEPTION(meta_model::EdgeResponseModel::fit(holed, "data"), brash::InputError,
                        [](const brash::InputError& error) {
                          return std::string(error.what()).find("has no solution at b/l_c = 1.4") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_CASE(a_file_whose_sides_turn_back_is_refused) {
  const Folder folder;
  const std::string file = (folder.path / "edge.json").string();
  meta_model::EdgeResponseModel::fit(samples(false), "data").write(file);
  meta_model::Json model = meta_model::read_model(file, meta_model::kEdgeFormat, 1);
  model["inputs"][1]["points"].back() = 3.2;
  meta_model::write_model(file, meta_model::kEdgeFormat, 1, model, -1);
  BOOST_CHECK_EXCEPTION(meta_model::EdgeResponseModel::read(file), brash::InputError,
                        [](const brash::InputError& error) {
                          return std::string(error.what()).find("must stay below pi") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_CASE(a_file_that_was_changed_is_refused) {
  const Folder folder;
  const std::string file = (folder.path / "edge.json").string();
  meta_model::EdgeResponseModel::fit(samples(false), "data").write(file);
  std::string text;
  {
    std::ifstream stream(file);
    text.assign(std::istreambuf_iterator<char>(stream), {});
  }
  text.replace(text.find("\"reach\":"), 8, "\"reach\": 1");
  std::ofstream(file) << text;
  BOOST_CHECK_THROW(meta_model::EdgeResponseModel::read(file), brash::InputError);
}
