// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/meta_model/network.hpp"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"

namespace {

using namespace brash::meta_model;
namespace fs = std::filesystem;

/// Three hidden units with weights of no meaning, all different.
NetworkParameters parameters() {
  NetworkParameters p;
  p.features = {{{-0.6, 0.9}, {-1.5, 1.3}, {1.7, 1.2}, {-0.6, 1.0}, {0.03, 0.028}}};
  p.targets = {{{0.4, 1.2}, {0.5, 0.2}}};
  p.hidden = 3;
  for (int i = 0; i < p.hidden * kInputs; ++i) p.w1.push_back(std::sin(1.0 + i));
  p.b1 = {0.1, -0.2, 0.3};
  for (int i = 0; i < p.hidden * kOutputs; ++i) p.w2.push_back(std::cos(2.0 + i));
  p.b2 = {0.05, -0.07};
  p.range = {{0.0, 0.02, 0.0, 0.1, -0.3}, {2.0, 2.0, 2.6, 3.0, 0.3}};
  p.data_sha256 = "none";
  return p;
}

std::vector<Input> inputs(int n) {
  std::vector<Input> rows;
  for (int i = 0; i < n; ++i) {
    rows.push_back({0.13 * (i % 15), 0.02 + 0.17 * (i % 11), 0.2 * (i % 13), 0.1 + 0.4 * (i % 7), 0.1 * (i % 7) - 0.3});
  }
  return rows;
}

struct Folder {
  fs::path path = fs::temp_directory_path() / ("brash_network_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

std::string text_of(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// The model file with `from` replaced by `to` must be refused with a message that holds every one of `wanted`.
void expect_refusal(const std::string& from, const std::string& to, const std::vector<std::string>& wanted) {
  const Folder folder;
  const std::string file = folder.path / "model.json";
  Network(parameters()).write(file);
  std::string text = text_of(file);
  const auto at = text.find(from);
  BOOST_REQUIRE(at != std::string::npos);
  std::ofstream(file) << text.replace(at, from.size(), to);
  BOOST_CHECK_EXCEPTION(Network::read(file), brash::InputError, [&](const brash::InputError& error) {
    const std::string message = error.what();
    for (const std::string& part : wanted) BOOST_TEST(message.find(part) != std::string::npos, message);
    return message.find(file) != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(the_network_is_equation_17) {
  const NetworkParameters p = parameters();
  const Input x{0.7, 0.3, 1.1, 0.5, -0.2};
  const double z[] = {(std::log(0.7 + 0.1) + 0.6) / 0.9, (std::log(0.3) + 1.5) / 1.3,
                      (std::log(1.0 + 2.0 * 0.7 * std::tan(0.55) / 0.3) - 1.7) / 1.2, (std::log(0.5) + 0.6) / 1.0,
                      (0.04 - 0.03) / 0.028};
  double y[] = {p.b2[0], p.b2[1]};
  for (int j = 0; j < 3; ++j) {
    double a = p.b1[j];
    for (int i = 0; i < kInputs; ++i) a += p.w1[j * kInputs + i] * z[i];
    for (int k = 0; k < kOutputs; ++k) y[k] += p.w2[k * 3 + j] / (1.0 + std::exp(-a));
  }
  const Output output = Network(p).predict(x);
  // Round-off of the vectorised exponential.
  BOOST_TEST(output.sigma_over_p == std::exp(0.4 + 1.2 * y[0]), boost::test_tools::tolerance(1e-13));
  BOOST_TEST(output.lbreak_over_lc == 0.5 + 0.2 * y[1], boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(a_batch_and_single_rows_agree_bit_by_bit) {
  const Network network(parameters());
  for (const int n : {0, 1, 7, 8, 9, 100}) {
    const std::vector<Input> rows = inputs(n);
    std::vector<Output> outputs(rows.size());
    network.predict(rows, outputs);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Output single = network.predict(rows[i]);
      BOOST_TEST(single.sigma_over_p == outputs[i].sigma_over_p);
      BOOST_TEST(single.lbreak_over_lc == outputs[i].lbreak_over_lc);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_written_network_reads_back_bit_by_bit) {
  const Folder folder;
  const Network network(parameters());
  const std::string hash = network.write(folder.path / "model.json");
  const Network again = Network::read(folder.path / "model.json");
  for (const Input& row : inputs(50)) {
    BOOST_TEST(again.predict(row).sigma_over_p == network.predict(row).sigma_over_p);
    BOOST_TEST(again.predict(row).lbreak_over_lc == network.predict(row).lbreak_over_lc);
  }
  BOOST_TEST(again.write(folder.path / "again.json") == hash);
  BOOST_TEST(text_of(folder.path / "again.json") == text_of(folder.path / "model.json"));
  BOOST_TEST(again.parameters().data_sha256 == "none");
}

BOOST_AUTO_TEST_CASE(a_changed_model_file_is_refused_with_the_place_and_a_remedy) {
  expect_refusal("\"offset\": 1.7", "\"offset\": 1.8", {"/content_sha256", "brash failure train"});
  expect_refusal("\"format\": \"brash-network\"", "\"format\": \"other\"", {"/format", "brash-network"});
  expect_refusal("\"format_version\": 1", "\"format_version\": 2", {"/format_version", "reads 1"});
  expect_refusal("\"content_sha256\"", "\"no_hash\"", {"content_sha256", "missing"});
  expect_refusal("\"format_version\": 1,", "\"format_version\" 1,", {"is not JSON", "column"});
  expect_refusal("mu2^2", "mu2^3", {"/content_sha256"});
}

BOOST_AUTO_TEST_CASE(a_missing_model_file_is_refused) {
  BOOST_CHECK_THROW(Network::read("/nonexistent/model.json"), brash::InputError);
}

BOOST_AUTO_TEST_CASE(inputs_below_and_above_the_range_are_told_apart_and_clamped) {
  const Network network(parameters());
  BOOST_TEST(network.check({1.0, 1.0, 1.0, 1.0, 0.0}).inside());
  BOOST_TEST(network.check({1.0, 0.01, 1.0, 1.0, 0.0}).below);
  BOOST_TEST(!network.check({1.0, 0.01, 1.0, 1.0, 0.0}).above);
  BOOST_TEST(network.check({2.1, 1.0, 1.0, 1.0, 0.0}).above);
  const Input clamped = network.clamp({2.5, 0.01, 1.0, 5.0, -0.4});
  BOOST_TEST(clamped.b_lc == 2.0);
  BOOST_TEST(clamped.c_lc == 0.02);
  BOOST_TEST(clamped.theta == 1.0);
  BOOST_TEST(clamped.mu1 == 3.0);
  BOOST_TEST(clamped.mu2 == -0.3);
}

BOOST_AUTO_TEST_CASE(at_the_straight_edge_the_angle_has_no_effect_and_the_stress_is_even_in_mu2) {
  const Network network(parameters());
  const Output y = network.predict({0.0, 0.3, 0.2, 0.5, 0.2});
  BOOST_TEST(network.predict({0.0, 0.3, 2.5, 0.5, 0.2}).sigma_over_p == y.sigma_over_p);
  BOOST_TEST(network.predict({0.0, 0.3, 0.2, 0.5, -0.2}).sigma_over_p == y.sigma_over_p);
}

BOOST_AUTO_TEST_CASE(an_input_without_a_feature_breaks_the_contract) {
  const Network network(parameters());
  BOOST_CHECK_THROW(network.predict({0.5, 0.0, 1.0, 0.5, 0.0}), brash::ContractViolation);
  BOOST_CHECK_THROW(network.predict({0.5, 0.3, 1.0, -0.5, 0.0}), brash::ContractViolation);
  BOOST_CHECK_THROW(network.predict({0.5, 0.3, 3.2, 0.5, 0.0}), brash::ContractViolation);
}

BOOST_AUTO_TEST_CASE(parameters_of_the_wrong_shape_break_the_contract) {
  NetworkParameters p = parameters();
  p.w2.pop_back();
  BOOST_CHECK_THROW(Network{p}, brash::ContractViolation);
}

}  // namespace
