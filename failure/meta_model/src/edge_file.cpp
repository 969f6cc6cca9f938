// SPDX-License-Identifier: GPL-3.0-or-later
// The file of an EdgeResponseModel.
#include "brash/core/constants.hpp"
#include "edge_impl.hpp"
#include "json_file.hpp"

namespace brash::meta_model {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kEdgeVersion = 1;
constexpr std::array<const char*, kEdgeAxes> kNames{"b_lc", "theta", "c_lc", "h_lc"};

Json list_of(const VectorXd& values) { return std::vector<double>(values.begin(), values.end()); }

Json rows_of(const MatrixXd& matrix) {
  Json rows = Json::array();
  for (Index i = 0; i < matrix.rows(); ++i) rows.push_back(list_of(matrix.row(i)));
  return rows;
}

/// Modes have three decimals: so has their text.
Json to_json(const GridField& field) {
  const MatrixXd modes = field.modes.cast<double>().unaryExpr([](double v) { return std::round(1e3 * v) / 1e3; });
  return {{"n_modes", field.modes.cols()},
          {"mean", list_of(field.mean)},
          {"modes", rows_of(modes.transpose())},
          {"coefficients", rows_of(field.coefficients)}};
}

VectorXd read_vector(const Place& place, std::size_t size) {
  const std::vector<double> values = place.numbers(size);
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(size));
}

MatrixXd read_matrix(const Place& place, std::size_t n_rows, std::size_t n_columns) {
  const std::vector<double> values = place.matrix(n_rows, n_columns);
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(values.data(), static_cast<Index>(n_rows), static_cast<Index>(n_columns));
}

/// As many columns as the first row has, at least one.
MatrixXd read_columns(const Place& place, std::size_t n_rows) {
  place.expect_size(n_rows);
  const std::size_t n_columns = place[std::size_t{0}].size();
  if (n_columns == 0) place[std::size_t{0}].refuse("is empty");
  return read_matrix(place, n_rows, n_columns);
}

GridField read_field(const Place& place, std::size_t n_values, std::size_t n_points) {
  const std::size_t n_modes = place["n_modes"].count();
  return {.mean = read_vector(place["mean"], n_values),
          .modes = read_matrix(place["modes"], n_modes, n_values).transpose().cast<float>(),
          .coefficients = read_matrix(place["coefficients"], n_modes, n_points)};
}

/// Numbers that rise from `least` or more.
std::vector<double> read_rising(const Place& place, double least) {
  std::vector<double> values = place.numbers(place.size());
  if (values.empty()) place.refuse("is empty");
  if (values.front() < least) place[std::size_t{0}].refuse(fmt::format("must be at least {:g}", least));
  for (std::size_t i = 1; i < values.size(); ++i)
    if (!(values[i] > values[i - 1])) place[i].refuse("must be above the number before");
  return values;
}

}  // namespace

std::string EdgeResponseModel::write(const std::string& path) const {
  const Impl& m = *impl_;
  Json inputs = Json::array();
  for (std::size_t i = 0; i < kEdgeAxes; ++i) inputs.push_back({{"name", kNames[i]}, {"points", m.grid[i]}});
  return write_model(path, kEdgeFormat, kEdgeVersion,
                     {{"inputs", inputs},
                      {"split", m.has_split},
                      {"data_sha256", m.data_sha256},
                      {"time", m.time},
                      {"reach", m.reach},
                      {"n_stations", kEdgeStations},
                      {"stations", rows_of(m.stations)},
                      {"times", rows_of(m.times)},
                      {"moments", to_json(m.moments)},
                      {"motion", to_json(m.motion)},
                      {"membrane", to_json(m.membrane)}},
                     -1);
}

EdgeResponseModel EdgeResponseModel::read(const std::string& path) {
  constexpr double kLeastLength = 1e-6;
  const Json model = read_model(path, kEdgeFormat, kEdgeVersion);
  const Place place(path, model, "");
  auto m = std::make_unique<Impl>();
  const Place inputs = place["inputs"];
  inputs.expect_size(kEdgeAxes);
  for (std::size_t i = 0; i < kEdgeAxes; ++i) {
    inputs[i]["name"].expect_text(kNames[i]);
    m->grid[i] = read_rising(inputs[i]["points"], i < 2 ? 0.0 : kLeastLength);
  }
  if (m->grid[1].back() >= kPi) inputs[std::size_t{1}]["points"].refuse("must stay below pi");
  if (const Place split = place["split"]; !model.at("split").is_boolean()) split.refuse("must be true or false");
  m->has_split = model.at("split").get<bool>();
  m->data_sha256 = place["data_sha256"].text();
  m->time = read_rising(place["time"], kLeastLength);
  if (m->time.size() < 4) place["time"].refuse("has less than 4 times");
  m->reach = place["reach"].positive();
  if (place["n_stations"].count() != kEdgeStations)
    place["n_stations"].refuse(fmt::format("must be {}", kEdgeStations));
  const std::size_t n_times = m->time.size(), n_points = m->n_points();
  m->stations = read_columns(place["stations"], kEdgeStations);
  m->times = read_columns(place["times"], n_times + 1);
  m->moments = read_field(place["moments"], static_cast<std::size_t>(m->stations.cols() * m->times.cols()), n_points);
  m->motion = read_field(place["motion"], 2 * n_times + 2, n_points);
  m->membrane = read_field(place["membrane"], kEdgeStations + 1, m->n_outlines());
  m->prepare();
  return EdgeResponseModel(std::move(m));
}

}  // namespace brash::meta_model
