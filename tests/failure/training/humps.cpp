// SPDX-License-Identifier: GPL-3.0-or-later
// The network of two humps: its formula, its file, its training.
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/meta_model/hump_network.hpp"
#include "brash/training/hump_training.hpp"

namespace {

using namespace brash::meta_model;
using namespace brash::training;
namespace fs = std::filesystem;

/// Weights of no meaning, all different; hidden layers of 2 and 3 units.
HumpParameters parameters() {
  HumpParameters p;
  p.features = {{{-0.6, 0.9}, {-1.5, 1.3}, {1.7, 1.2}, {-0.6, 1.0}, {0.03, 0.028}, {1.5, 1.2}}};
  p.hidden = {2, 3};
  double start = 0.0;
  for (auto* networks : {&p.stress, &p.place}) {
    for (LayeredNetwork& network : *networks) {
      network.target = {0.12 * start - 0.5, 0.7};
      for (std::size_t i = 0; i < n_weights(kHumpFeatures, p.hidden); ++i) {
        network.weights.push_back(std::sin(start + 1.3 * static_cast<double>(i)));
      }
      start += 0.7;
    }
  }
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

/// y of one layered network, written out plainly.
double by_hand(const HumpParameters& p, const LayeredNetwork& network, const Input& x) {
  std::vector<double> v{
      std::log(x.b_lc + 0.1), std::log(x.c_lc), std::log(1.0 + 2.0 * x.b_lc * std::tan(0.5 * x.theta) / x.c_lc),
      std::log(x.mu1),        x.mu2 * x.mu2,    std::log(1.0 + 2.0 * x.b_lc / x.c_lc)};
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = (v[i] - p.features[i].offset) / p.features[i].factor;
  std::size_t at = 0;
  for (const std::size_t units : {2, 3, 1}) {
    std::vector<double> next;
    for (std::size_t j = 0; j < units; ++j) {
      double a = network.weights[at + units * v.size() + j];
      for (std::size_t i = 0; i < v.size(); ++i) a += network.weights[at + j * v.size() + i] * v[i];
      next.push_back(units == 1 ? a : 1.0 / (1.0 + std::exp(-a)));
    }
    at += units * (v.size() + 1);
    v = next;
  }
  return network.target.offset + network.target.factor * v.front();
}

struct Folder {
  fs::path path = fs::temp_directory_path() / ("brash_humps_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

BOOST_AUTO_TEST_CASE(the_hump_with_the_larger_stress_answers) {
  const HumpParameters p = parameters();
  const HumpNetwork network(p);
  std::array<int, kHumps> wins{};
  for (const Input& x : inputs(60)) {
    const double near = by_hand(p, p.stress[0], x), far = by_hand(p, p.stress[1], x);
    const std::size_t hump = far > near ? 1 : 0;
    ++wins[hump];
    const Output y = network.predict(x);
    // Round-off of some dozen operations.
    BOOST_TEST(y.sigma_over_p == std::exp(std::max(near, far)), boost::test_tools::tolerance(1e-12));
    BOOST_TEST(y.lbreak_over_lc == std::max(0.0, std::exp(by_hand(p, p.place[hump], x)) - 0.03),
               boost::test_tools::tolerance(1e-11));
  }
  BOOST_TEST(wins[0] > 5);
  BOOST_TEST(wins[1] > 5);
}

BOOST_AUTO_TEST_CASE(a_row_alone_and_among_others_gets_the_same_bits) {
  const HumpNetwork network(parameters());
  const auto rows = inputs(21);
  std::vector<Output> together(rows.size());
  network.predict(rows, together);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Output alone = network.predict(rows[i]);
    BOOST_TEST(alone.sigma_over_p == together[i].sigma_over_p);
    BOOST_TEST(alone.lbreak_over_lc == together[i].lbreak_over_lc);
  }
}

BOOST_AUTO_TEST_CASE(a_model_file_gives_the_same_network_bit_by_bit) {
  const Folder folder;
  const std::string file = folder.path / "model.json";
  const HumpNetwork network(parameters());
  network.write(file);
  const auto again = read_network(file);
  for (const Input& x : inputs(20)) {
    BOOST_TEST(again->predict(x).sigma_over_p == network.predict(x).sigma_over_p);
    BOOST_TEST(again->predict(x).lbreak_over_lc == network.predict(x).lbreak_over_lc);
  }
  BOOST_CHECK_THROW(Network::read(file), brash::InputError);
}

BOOST_AUTO_TEST_CASE(a_model_file_that_was_changed_is_refused) {
  const Folder folder;
  const std::string file = folder.path / "model.json";
  HumpNetwork(parameters()).write(file);
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  std::string changed = text.str();
  const std::string from = "\"hidden\":[2,3]";
  BOOST_REQUIRE(changed.find(from) != std::string::npos);
  std::ofstream(file) << changed.replace(changed.find(from), from.size(), "\"hidden\":[3,2]");
  BOOST_CHECK_EXCEPTION(HumpNetwork::read(file), brash::InputError, [&](const brash::InputError& error) {
    return std::string(error.what()).find(file + ": /content_sha256") == 0;
  });
}

BOOST_AUTO_TEST_CASE(parameters_that_do_not_fit_together_are_a_contract_violation) {
  HumpParameters p = parameters();
  p.place[1].weights.pop_back();
  BOOST_CHECK_THROW(HumpNetwork{p}, brash::ContractViolation);
}

/// Two smooth humps, of which now one and now the other is the higher; the place jumps from 0.1 to 0.8.
std::vector<HumpSample> samples(int n) {
  std::vector<HumpSample> rows;
  for (int i = 0; i < n; ++i) {
    const auto at = [i](double step) { return std::fmod((i + 1) * step, 1.0); };
    const Input x{2.0 * at(0.8191725134), 0.05 + at(0.6710436067), 2.0 * at(0.5497004779), 0.2 + at(0.4503046119),
                  0.4 * at(0.3688760387) - 0.2};
    const double near = x.mu1 * std::sqrt(x.c_lc) / (1.0 + x.b_lc), far = 0.6 * x.mu1 * x.c_lc;
    const double near_place = 0.08 + 0.05 * x.c_lc, far_place = 0.7 + 0.1 * x.b_lc;
    rows.push_back({x,
                    {{{{near, near_place}, 0.9 * near_place, 1.1 * near_place},
                      {{far, far_place}, 0.9 * far_place, 1.1 * far_place}}}});
  }
  return rows;
}

HumpTrainingOptions quick() { return {.hidden = {5, 4}, .max_iterations = 60}; }

BOOST_AUTO_TEST_CASE(training_learns_two_humps_and_the_jump_between_them) {
  const HumpNetwork network = train_humps(samples(700), quick()).network;
  int n_far = 0, n_on_hump = 0, n_rows = 0;
  for (const HumpSample& s : samples(1400)) {  // of which every second one is new
    const std::size_t hump = s.humps[1].output.sigma_over_p > s.humps[0].output.sigma_over_p ? 1 : 0;
    const Hump& wanted = s.humps[hump];
    const Output y = network.predict(s.input);
    ++n_rows;
    n_far += static_cast<int>(hump);
    n_on_hump += y.lbreak_over_lc >= wanted.plateau_from && y.lbreak_over_lc <= wanted.plateau_to ? 1 : 0;
    BOOST_TEST(y.sigma_over_p == wanted.output.sigma_over_p, boost::test_tools::tolerance(0.05));
  }
  BOOST_TEST(n_far > n_rows / 10);
  BOOST_TEST(n_far < n_rows / 2);
  BOOST_TEST(n_on_hump > 0.98 * n_rows);  // the rest lies where the humps are nearly as high as each other
}

BOOST_AUTO_TEST_CASE(the_same_samples_give_the_same_weights) {
  HumpTrainingOptions options = quick();
  options.max_iterations = 5;
  const HumpParameters first = train_humps(samples(200), options).network.parameters();
  const HumpParameters again = train_humps(samples(200), options).network.parameters();
  options.seed = 2;
  const HumpParameters other = train_humps(samples(200), options).network.parameters();
  for (std::size_t hump = 0; hump < kHumps; ++hump) {
    BOOST_TEST(first.stress[hump].weights == again.stress[hump].weights, boost::test_tools::per_element());
    BOOST_TEST(first.place[hump].weights == again.place[hump].weights, boost::test_tools::per_element());
    BOOST_TEST(first.stress[hump].weights[0] != other.stress[hump].weights[0]);
  }
}

BOOST_AUTO_TEST_CASE(too_few_rows_are_refused) {
  BOOST_CHECK_EXCEPTION(train_humps(samples(50), quick()), brash::InputError, [](const brash::InputError& error) {
    return std::string(error.what()).find("45 rows cannot fix 64 weights") == 0;
  });
}

}  // namespace
