// SPDX-License-Identifier: GPL-3.0-or-later
// The file of a ProfileModel.
#include "json_file.hpp"
#include "profile_impl.hpp"

namespace brash::meta_model {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr std::array<const char*, kGeometryInputs> kNames{"b_lc", "c_lc", "theta"};

std::array<double, kGeometryInputs> to_array(const Geometry& g) { return {g.b_lc, g.c_lc, g.theta}; }

Json rows_of(const MatrixXd& matrix) {
  Json rows = Json::array();
  for (Index i = 0; i < matrix.rows(); ++i) {
    const Eigen::VectorXd row = matrix.row(i);
    rows.push_back(std::vector<double>(row.data(), row.data() + row.size()));
  }
  return rows;
}

MatrixXd read_matrix(const Place& place, std::size_t n_rows, std::size_t n_columns) {
  const std::vector<double> values = place.matrix(n_rows, n_columns);
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(values.data(), static_cast<Index>(n_rows), static_cast<Index>(n_columns));
}

Eigen::Vector3d read_vector3(const Place& place) {
  const std::vector<double> v = place.numbers(kGeometryInputs);
  return {v[0], v[1], v[2]};
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
  place[std::size_t{1}]["lower"].positive();
  for (std::size_t k = 0; k < 2; ++k) range[k] = {ends[k][0], ends[k][1], ends[k][2]};
}

}  // namespace

std::string ProfileModel::write(const std::string& path) const {
  const Impl& m = *impl_;
  Json inputs = Json::array();
  const auto lower = to_array(m.range[0]), upper = to_array(m.range[1]);
  for (int i = 0; i < kGeometryInputs; ++i) {
    inputs.push_back({{"name", kNames[i]}, {"lower", lower[i]}, {"upper", upper[i]}});
  }
  return write_model(path, kProfileFormat,
                     {{"inputs", inputs},
                      {"thickness_over_lc", m.thickness_over_lc},
                      {"data_sha256", m.data_sha256},
                      {"reach", m.reach},
                      {"n_centres", m.centres.cols()},
                      {"n_modes", m.modes.cols()},
                      {"n_values", m.modes.rows()},
                      {"offset", std::vector<double>(m.offset.data(), m.offset.data() + kGeometryInputs)},
                      {"factor", std::vector<double>(m.factor.data(), m.factor.data() + kGeometryInputs)},
                      {"centres", rows_of(m.centres)},
                      {"weights", rows_of(m.weights)},
                      {"linear", rows_of(m.linear)},
                      {"mean", std::vector<double>(m.mean.data(), m.mean.data() + m.mean.size())},
                      {"modes", rows_of(m.modes)}},
                     -1);
}

ProfileModel ProfileModel::read(const std::string& path) {
  const Json model = read_model(path, kProfileFormat);
  const Place place(path, model, "");
  auto m = std::make_unique<Impl>();
  read_range(place["inputs"], m->range);
  m->thickness_over_lc = place["thickness_over_lc"].positive();
  m->data_sha256 = place["data_sha256"].text();
  m->reach = place["reach"].positive();
  const std::size_t n_centres = place["n_centres"].count(), n_modes = place["n_modes"].count();
  if (place["n_values"].count() != kProfileValues) {
    place["n_values"].refuse(fmt::format("must be {}", kProfileValues));
  }
  m->offset = read_vector3(place["offset"]);
  m->factor = read_vector3(place["factor"]);
  if (!(m->factor.array() > 0.0).all()) place["factor"].refuse("must be > 0");
  m->centres = read_matrix(place["centres"], kGeometryInputs, n_centres);
  m->weights = read_matrix(place["weights"], n_modes, n_centres);
  m->linear = read_matrix(place["linear"], n_modes, kGeometryInputs + 1);
  const std::vector<double> mean = place["mean"].numbers(kProfileValues);
  m->mean = Eigen::Map<const Eigen::VectorXd>(mean.data(), kProfileValues);
  m->modes = read_matrix(place["modes"], kProfileValues, n_modes);
  return ProfileModel(std::move(m));
}

}  // namespace brash::meta_model
