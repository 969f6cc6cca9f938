// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/error.hpp"
#include "brash/training/network_training.hpp"
#include "profile_card.hpp"

namespace {

using namespace brash::meta_model;
using namespace brash::training;

/// A smooth law with the plate's trends: stress over orders of magnitude, even in mu2. Rows of a geometry differ in mu.
Sample sample(int geometry, int row) {
  const auto wave = [](double k) { return 0.5 + 0.5 * std::sin(k); };  // spreads the points, no lattice
  Sample s;
  s.geometry = geometry;
  s.input = {.b_lc = 2.0 * wave(1.7 * geometry),
             .c_lc = 0.02 * std::pow(100.0, wave(2.9 * geometry + 1.0)),
             .theta = 2.6 * wave(4.1 * geometry + 2.0),
             .mu1 = 0.1 * std::pow(30.0, wave(3.3 * geometry + 5.7 * row)),
             .mu2 = 0.3 * std::sin(2.3 * geometry + 7.9 * row)};
  const Input& x = s.input;
  const double width_ratio = 1.0 + 2.0 * x.b_lc * std::tan(0.5 * x.theta) / x.c_lc;
  s.output.sigma_over_p =
      5.0 * (x.mu1 + 0.3) * x.c_lc / (x.c_lc + 0.2 * width_ratio / (1.0 + x.b_lc)) * (1.0 + 2.0 * x.mu2 * x.mu2);
  s.output.lbreak_over_lc = 0.3 + 0.2 * std::tanh(x.b_lc) + 0.1 * std::log1p(x.c_lc);
  s.plateau_from = s.output.lbreak_over_lc - 0.1;
  s.plateau_to = s.output.lbreak_over_lc + 0.1;
  return s;
}

std::vector<Sample> samples(int n_geometries) {
  std::vector<Sample> rows;
  for (int g = 0; g < n_geometries; ++g) {
    for (int r = 0; r < 4; ++r) rows.push_back(sample(g, r));
  }
  return rows;
}

TrainingOptions quick() { return {.starts = 2, .max_iterations = 150, .patience = 25}; }

BOOST_AUTO_TEST_CASE(training_learns_a_smooth_law_on_geometries_it_never_saw) {
  const Trained trained = train(samples(150), quick());
  // Ten sigmoids represent this law to about 1 %; without learning the stress error would be of the order of 1.
  BOOST_TEST(trained.report.test.stress_rms < 0.04);
  BOOST_TEST(trained.report.test.length_rms < 0.02);
  BOOST_TEST(trained.report.test.length_on_plateau > 0.99);
  BOOST_TEST(trained.report.test.n_geometries == 23u);
  BOOST_TEST(trained.report.train.n_rows + trained.report.validation.n_rows + trained.report.test.n_rows == 600u);
}

BOOST_AUTO_TEST_CASE(no_geometry_is_in_two_parts_of_the_split) {
  const Trained trained = train(samples(60), quick());
  const TrainingReport& r = trained.report;
  // Rows divide as 4 per geometry in each part only when no geometry is divided; the parts add up to all geometries.
  for (const Errors* part : {&r.train, &r.validation, &r.test}) BOOST_TEST(part->n_rows == 4 * part->n_geometries);
  BOOST_TEST(r.train.n_geometries + r.validation.n_geometries + r.test.n_geometries == 60u);
}

BOOST_AUTO_TEST_CASE(the_same_seed_gives_the_same_network_and_another_seed_another) {
  const auto rows = samples(40);
  TrainingOptions options = quick();
  options.max_iterations = 20;
  const auto first = train(rows, options).network.parameters();
  BOOST_TEST(train(rows, options).network.parameters().w1 == first.w1);
  options.seed = 2;
  BOOST_TEST(train(rows, options).network.parameters().w1 != first.w1);
}

BOOST_AUTO_TEST_CASE(the_range_is_the_box_of_all_rows_and_the_stress_is_even_in_mu2) {
  const auto rows = samples(40);
  const Network network = train(rows, quick()).network;
  for (const Sample& s : rows) BOOST_TEST(network.check(s.input).inside());
  Input mirrored = rows[0].input;
  mirrored.mu2 = -mirrored.mu2;
  BOOST_TEST(network.predict(mirrored).sigma_over_p == network.predict(rows[0].input).sigma_over_p);
}

BOOST_AUTO_TEST_CASE(the_start_with_the_smallest_validation_loss_is_kept) {
  const Trained trained = train(samples(60), quick());
  const auto& starts = trained.report.starts;
  BOOST_REQUIRE(starts.size() == 4u);  // two of each network
  for (const std::size_t first : {0u, 2u}) {
    BOOST_REQUIRE(starts[first].kept != starts[first + 1].kept);
    const std::size_t best = starts[first].kept ? first : first + 1, other = 2 * first + 1 - best;
    BOOST_TEST(starts[best].validation_loss <= starts[other].validation_loss);
  }
}

BOOST_AUTO_TEST_CASE(separate_networks_share_no_hidden_unit_and_one_network_shares_all) {
  TrainingOptions options = quick();
  options.max_iterations = 20;
  const NetworkParameters two = train(samples(40), options).network.parameters();
  BOOST_REQUIRE(two.hidden == 20);
  for (int j = 0; j < 10; ++j) {
    BOOST_TEST(two.w2[j] != 0.0);
    BOOST_TEST(two.w2[10 + j] == 0.0);
    BOOST_TEST(two.w2[20 + j] == 0.0);
    BOOST_TEST(two.w2[30 + j] != 0.0);
  }
  options.separate = false;
  const NetworkParameters one = train(samples(40), options).network.parameters();
  BOOST_TEST(one.hidden == 10);
  for (const double weight : one.w2) BOOST_TEST(weight != 0.0);
}

BOOST_AUTO_TEST_CASE(too_few_geometries_or_an_unusable_row_are_refused) {
  BOOST_CHECK_THROW(train(samples(5), quick()), brash::InputError);
  auto rows = samples(40);
  rows[3].output.sigma_over_p = 0.0;
  BOOST_CHECK_THROW(train(rows, quick()), brash::InputError);
}

BOOST_AUTO_TEST_CASE(the_errors_of_a_known_network_are_those_of_its_rows) {
  const Network network = train(samples(40), quick()).network;
  auto rows = samples(20);
  for (Sample& s : rows) {
    const Output y = network.predict(s.input);
    s.output = {y.sigma_over_p / 1.1, y.lbreak_over_lc + 0.3};
    s.plateau_from = s.output.lbreak_over_lc - 0.1;
    s.plateau_to = s.output.lbreak_over_lc + 0.1;
  }
  const Errors e = errors(network, rows);
  // Round-off only: every row is predicted 10 % too high and 0.3 too short.
  BOOST_TEST(e.stress_bias == 0.1, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(e.stress_rms == 0.1, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(e.stress_max == 0.1, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(e.length_median == 0.3, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(e.length_on_plateau == 0.0);
}

BOOST_AUTO_TEST_CASE(the_model_card_states_hashes_range_errors_and_limits) {
  TrainingOptions options = quick();
  options.data_sha256 = "abc123";
  const Trained trained = train(samples(40), options);
  const std::string card = model_card(trained.network, trained.report, options,
                                      {"m.json", "def456", "d.nc", "m_errors.csv", "brash failure train d.nc"});
  for (const char* part : {"abc123", "def456", "m.json", "d.nc", "| theta [deg] |", "**Errors** on ", "m_errors.csv",
                           "    brash failure train d.nc\n", "**Not for**"}) {
    BOOST_TEST(card.find(part) != std::string::npos, part);
  }
  const std::string errors = error_table(trained.report);
  for (const char* part : {"\ntraining,all,", "\nvalidation,all,", "\ntest,all,", "\ntest,b < 0.25 l_c,"})
    BOOST_TEST(errors.find(part) != std::string::npos, part);
}

BOOST_AUTO_TEST_CASE(quantiles_of_errors_lie_between_the_rows) {
  const brash::plate::WedgePlate plate;
  const std::vector<JudgedRow> rows{{.plate = &plate, .sigma_over_p = 1.0, .stress_error = 0.02},
                                    {.plate = &plate, .sigma_over_p = 1.0, .stress_error = 0.01}};
  BOOST_TEST(summary(rows).find("stress error median 1.50 %, 95 % 1.95 %") != std::string::npos);
}

}  // namespace
