// SPDX-License-Identifier: GPL-3.0-or-later
// The file of a ProfileModel.
#include "brash/core/constants.hpp"
#include "json_file.hpp"
#include "profile_impl.hpp"

namespace brash::meta_model {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kProfileVersion = 3;
constexpr std::array<const char*, kGeometryInputs> kNames{"b_lc", "c_lc", "theta", "h_lc"};

std::array<double, kGeometryInputs> to_array(const Geometry& g) { return {g.b_lc, g.c_lc, g.theta, g.h_lc}; }

Json list_of(const VectorXd& values) { return std::vector<double>(values.data(), values.data() + values.size()); }

Json rows_of(const MatrixXd& matrix) {
  Json rows = Json::array();
  for (Index i = 0; i < matrix.rows(); ++i) rows.push_back(list_of(matrix.row(i)));
  return rows;
}

VectorXd read_vector(const Place& place, Index size) {
  const std::vector<double> values = place.numbers(static_cast<std::size_t>(size));
  return Eigen::Map<const VectorXd>(values.data(), size);
}

MatrixXd read_matrix(const Place& place, Index n_rows, Index n_columns) {
  const std::vector<double> values =
      place.matrix(static_cast<std::size_t>(n_rows), static_cast<std::size_t>(n_columns));
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(values.data(), n_rows, n_columns);
}

Json to_json(const Interpolant& c) {
  return {{"n_centres", c.centres.cols()}, {"offset", list_of(c.offset)},   {"factor", list_of(c.factor)},
          {"centres", rows_of(c.centres)}, {"weights", rows_of(c.weights)}, {"polynomial", rows_of(c.polynomial)}};
}

Json to_json(const FieldModel& field) {
  Json json = to_json(field.coefficients);
  json["n_modes"] = field.modes.cols();
  json["mean"] = list_of(field.mean);
  json["modes"] = rows_of(field.modes);
  return json;
}

Interpolant read_interpolant(const Place& place, Index n_features, Index n_values) {
  const auto n_centres = static_cast<Index>(place["n_centres"].count());
  Interpolant interpolant{.offset = read_vector(place["offset"], n_features),
                          .factor = read_vector(place["factor"], n_features),
                          .centres = read_matrix(place["centres"], n_features, n_centres),
                          .weights = read_matrix(place["weights"], n_values, n_centres),
                          .polynomial = read_matrix(place["polynomial"], n_values, n_polynomial_terms(n_features))};
  if (!(interpolant.factor.array() > 0.0).all()) place["factor"].refuse("must be > 0");
  return interpolant;
}

FieldModel read_field(const Place& place, Index n_features, Index n_components) {
  const auto n_modes = static_cast<Index>(place["n_modes"].count());
  const Index n_values = n_components * kProfileStations;
  return {.coefficients = read_interpolant(place, n_features, n_modes),
          .mean = read_vector(place["mean"], n_values),
          .modes = read_matrix(place["modes"], n_values, n_modes)};
}

void read_range(const Place& place, std::array<Geometry, 2>& range) {
  place.expect_size(kGeometryInputs);
  std::array<std::array<double, kGeometryInputs>, 2> ends{};
  for (std::size_t i = 0; i < kGeometryInputs; ++i) {
    place[i]["name"].expect_text(kNames[i]);
    ends[0][i] = place[i]["lower"].number();
    ends[1][i] = place[i]["upper"].number();
    if (ends[0][i] > ends[1][i]) place[i]["lower"].refuse("exceeds `upper`");
    if (ends[0][i] < 0.0) place[i]["lower"].refuse("must be >= 0");
  }
  for (const std::size_t i : {1, 3}) place[i]["lower"].positive();
  if (ends[1][2] >= kPi) place[std::size_t{2}]["upper"].refuse("must be below pi");
  for (std::size_t k = 0; k < 2; ++k) range[k] = {ends[k][0], ends[k][1], ends[k][2], ends[k][3]};
}

}  // namespace

std::string ProfileModel::write(const std::string& path) const {
  const Impl& m = *impl_;
  Json inputs = Json::array();
  const auto lower = to_array(m.range[0]), upper = to_array(m.range[1]);
  for (std::size_t i = 0; i < kGeometryInputs; ++i) {
    inputs.push_back({{"name", kNames[i]}, {"lower", lower[i]}, {"upper", upper[i]}});
  }
  return write_model(path, kProfileFormat, kProfileVersion,
                     {{"inputs", inputs},
                      {"data_sha256", m.data_sha256},
                      {"reach", m.reach},
                      {"n_stations", kProfileStations},
                      {"bending", to_json(m.bending)},
                      {"in_plane", to_json(m.in_plane)},
                      {"buckling", to_json(m.buckling)},
                      {"membrane", to_json(m.membrane)}},
                     -1);
}

ProfileModel ProfileModel::read(const std::string& path) {
  const Json model = read_model(path, kProfileFormat, kProfileVersion);
  const Place place(path, model, "");
  auto m = std::make_unique<Impl>();
  read_range(place["inputs"], m->range);
  m->data_sha256 = place["data_sha256"].text();
  m->reach = place["reach"].positive();
  if (place["n_stations"].count() != kProfileStations) {
    place["n_stations"].refuse(fmt::format("must be {}", kProfileStations));
  }
  m->bending = read_field(place["bending"], bending_features({}).size(), kBendingComponents);
  m->in_plane = read_field(place["in_plane"], bending_features({}).size(), kInPlaneComponents);
  m->buckling = read_interpolant(place["buckling"], bending_features({}).size(), 1);
  m->membrane = read_field(place["membrane"], membrane_features({}).size(), kMembraneComponents);
  return ProfileModel(std::move(m));
}

}  // namespace brash::meta_model
