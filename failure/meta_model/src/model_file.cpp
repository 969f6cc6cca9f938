// SPDX-License-Identifier: GPL-3.0-or-later
// The model file: JSON with everything that Eq. 17 needs, and its own hash.
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/core/version.hpp"
#include "brash/meta_model/network.hpp"
#include "features.hpp"
#include "sha256.hpp"

namespace brash::meta_model {
namespace {

using Json = nlohmann::json;  // keys are sorted, so the text of equal content is equal

constexpr const char* kFormat = "brash-network";
constexpr int kFormatVersion = 1;
constexpr const char* kHashKey = "content_sha256";
constexpr std::array<const char*, kInputs> kInputNames{"b_lc", "c_lc", "theta", "mu1", "mu2"};
constexpr std::array<const char*, kInputs> kInputUnits{"1", "1", "rad", "1", "1"};

std::string content_hash(Json model) {
  model.erase(kHashKey);
  return sha256(model.dump());
}

template <std::size_t N>
Json to_json(const std::array<const char*, N>& names, const std::array<Normalisation, N>& normalisations) {
  Json list = Json::array();
  for (std::size_t i = 0; i < N; ++i) {
    list.push_back({{"value", names[i]}, {"offset", normalisations[i].offset}, {"factor", normalisations[i].factor}});
  }
  return list;
}

Json rows_of(const std::vector<double>& values, int n_columns) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < values.size(); i += n_columns) {
    rows.push_back(std::vector<double>(values.begin() + i, values.begin() + i + n_columns));
  }
  return rows;
}

Json to_json(const NetworkParameters& p) {
  Json inputs = Json::array();
  const auto lower = to_array(p.range.lower), upper = to_array(p.range.upper);
  for (int i = 0; i < kInputs; ++i) {
    inputs.push_back({{"name", kInputNames[i]}, {"unit", kInputUnits[i]}, {"lower", lower[i]}, {"upper", upper[i]}});
  }
  Json model{{"format", kFormat},
             {"format_version", kFormatVersion},
             {"program_version", kVersion},
             {"equation", "y = W2 S(W1 X + b1) + b2; S(a) = 1/(1 + exp(-a)); X, y: (value - offset)/factor"},
             {"inputs", inputs},
             {"features", to_json(kFeatureNames, p.features)},
             {"targets", to_json(kTargetNames, p.targets)},
             {"hidden", p.hidden},
             {"W1", rows_of(p.w1, kInputs)},
             {"b1", p.b1},
             {"W2", rows_of(p.w2, p.hidden)},
             {"b2", p.b2},
             {"thickness_over_lc", p.thickness_over_lc},
             {"data_sha256", p.data_sha256}};
  model[kHashKey] = content_hash(model);
  return model;
}

/// A value of the file together with where it stands, so that every message can say so.
class Place {
 public:
  Place(const std::string& file, const Json& value, std::string pointer)
      : file_(file), value_(value), pointer_(std::move(pointer)) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(fmt::format("{}: {}: {}; write the model again with `brash failure train`, or copy it again",
                                 file_, pointer_.empty() ? "/" : pointer_, what));
  }
  Place operator[](const char* key) const {
    if (!value_.is_object() || !value_.contains(key)) refuse(fmt::format("the key `{}` is missing", key));
    return {file_, value_.at(key), pointer_ + "/" + key};
  }
  Place operator[](std::size_t index) const { return {file_, value_.at(index), fmt::format("{}/{}", pointer_, index)}; }
  double number() const {
    if (!value_.is_number() || !std::isfinite(value_.get<double>())) refuse("must be a finite number");
    return value_.get<double>();
  }
  double positive() const {
    if (!(number() > 0.0)) refuse("must be > 0");
    return number();
  }
  std::string text() const {
    if (!value_.is_string()) refuse("must be a text");
    return value_.get<std::string>();
  }
  void expect_size(std::size_t size) const {
    if (!value_.is_array() || value_.size() != size) refuse(fmt::format("must be a list of {}", size));
  }
  void expect_text(const std::string& wanted) const {
    if (text() != wanted) refuse(fmt::format("is `{}`, must be `{}`", text(), wanted));
  }
  std::vector<double> numbers(std::size_t size) const {
    expect_size(size);
    std::vector<double> values;
    for (std::size_t i = 0; i < size; ++i) values.push_back((*this)[i].number());
    return values;
  }
  std::vector<double> matrix(std::size_t n_rows, std::size_t n_columns) const {
    expect_size(n_rows);
    std::vector<double> values;
    for (std::size_t i = 0; i < n_rows; ++i) {
      const auto row = (*this)[i].numbers(n_columns);
      values.insert(values.end(), row.begin(), row.end());
    }
    return values;
  }

 private:
  const std::string& file_;
  const Json& value_;
  std::string pointer_;
};

template <std::size_t N>
void read_normalisations(const Place& place, const std::array<const char*, N>& names,
                         std::array<Normalisation, N>& normalisations) {
  place.expect_size(N);
  for (std::size_t i = 0; i < N; ++i) {
    place[i]["value"].expect_text(names[i]);
    normalisations[i] = {place[i]["offset"].number(), place[i]["factor"].positive()};
  }
}

void read_range(const Place& place, Range& range) {
  place.expect_size(kInputs);
  std::array<double, kInputs> lower{}, upper{};
  for (int i = 0; i < kInputs; ++i) {
    const Place input = place[static_cast<std::size_t>(i)];
    input["name"].expect_text(kInputNames[i]);
    input["unit"].expect_text(kInputUnits[i]);
    lower[i] = input["lower"].number();
    upper[i] = input["upper"].number();
    if (lower[i] > upper[i]) input["lower"].refuse("exceeds `upper`");
  }
  range = {to_input(lower), to_input(upper)};
  if (range.lower.b_lc < 0.0) place[std::size_t{0}]["lower"].refuse("must be >= 0");
  if (range.lower.c_lc <= 0.0) place[std::size_t{1}]["lower"].refuse("must be > 0");
  if (range.lower.theta < 0.0) place[std::size_t{2}]["lower"].refuse("must be >= 0");
  if (range.upper.theta >= kPi) place[std::size_t{2}]["upper"].refuse("must be below pi");
  if (range.lower.mu1 <= 0.0) place[std::size_t{3}]["lower"].refuse("must be > 0");
}

NetworkParameters to_parameters(const Place& place) {
  NetworkParameters p;
  read_range(place["inputs"], p.range);
  read_normalisations(place["features"], kFeatureNames, p.features);
  read_normalisations(place["targets"], kTargetNames, p.targets);
  const double hidden = place["hidden"].positive();
  constexpr double kMostHidden = 1e4;  // beyond any use; guards the conversion
  if (hidden != std::floor(hidden) || hidden > kMostHidden) place["hidden"].refuse("must be a whole number");
  p.hidden = static_cast<int>(hidden);
  const auto n = static_cast<std::size_t>(p.hidden);
  p.w1 = place["W1"].matrix(n, kInputs);
  p.b1 = place["b1"].numbers(n);
  p.w2 = place["W2"].matrix(kOutputs, n);
  p.b2 = place["b2"].numbers(kOutputs);
  p.thickness_over_lc = place["thickness_over_lc"].positive();
  p.data_sha256 = place["data_sha256"].text();
  return p;
}

Json parse(const std::string& path) {
  std::ifstream stream(path);
  std::stringstream text;
  if (!stream || !(text << stream.rdbuf())) {
    throw InputError(fmt::format("{}: cannot be read; give a model file written by `brash failure train`", path));
  }
  try {
    return Json::parse(text.str());
  } catch (const Json::parse_error& error) {
    throw InputError(fmt::format("{}: byte {}: is not JSON ({}); give a model file written by `brash failure train`",
                                 path, error.byte, error.what()));
  }
}

}  // namespace

Network Network::read(const std::string& path) {
  const Json model = parse(path);
  const Place place(path, model, "");
  place["format"].expect_text(kFormat);
  if (place["format_version"].number() != kFormatVersion) {
    place["format_version"].refuse(
        fmt::format("is {}, this program reads {}", place["format_version"].number(), kFormatVersion));
  }
  const std::string stated = place[kHashKey].text(), found = content_hash(model);
  if (stated != found) {
    place[kHashKey].refuse(fmt::format("is {}, but the content has {}: the file was changed", stated, found));
  }
  return Network(to_parameters(place));
}

std::string Network::write(const std::string& path) const {
  const Json model = to_json(parameters_);
  const std::string partial = fmt::format("{}.partial.{}", path, ::getpid());
  {
    std::ofstream stream(partial);
    stream << model.dump(1) << '\n';
    if (!stream.flush()) throw RunError(fmt::format("{}: cannot be written", partial));
  }
  if (std::rename(partial.c_str(), path.c_str()) != 0) throw RunError(fmt::format("{}: cannot be renamed", partial));
  return model.at(kHashKey).get<std::string>();
}

}  // namespace brash::meta_model
