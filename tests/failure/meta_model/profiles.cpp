// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/meta_model/profile_model.hpp"

namespace {

using namespace brash;
using namespace brash::meta_model;
namespace fs = std::filesystem;

/// A profile with a kink at the base line, of the plate's kind: a beam as wide as the load has spread, on water.
double bending(const Geometry& g, double x) {
  const double width = g.c_lc + 2.0 * std::min(x, g.b_lc) * std::tan(0.5 * g.theta) + std::max(x - g.b_lc, 0.0);
  return g.c_lc * x / width * std::exp(-x) * (1.0 + g.h_lc);
}

double buckling_load(const Geometry& g) { return 3.0 / g.c_lc / (1.0 + g.b_lc); }

ProfileSample sample(const Geometry& g) {
  ProfileSample s{g, {}};
  for (int i = 0; i <= 400; ++i) {
    const double x = 6.0 * std::pow(i / 400.0, 2);
    s.profiles.station.push_back(x);
    s.profiles.bending_xx.push_back(bending(g, x));
    s.profiles.bending_yy.push_back(0.1 * bending(g, x));
    s.profiles.normal_xx.push_back(-g.c_lc / (g.c_lc + x));
    s.profiles.normal_yy.push_back(0.3 * g.c_lc / (g.c_lc + 2.0 * x));
    s.profiles.tangential_xy.push_back(0.2 * g.c_lc * x / (g.c_lc + x));
    s.profiles.first_xx.push_back(1.5 * bending(g, x));
    s.profiles.first_yy.push_back(0.2 * bending(g, x));
    s.profiles.rest_xx.push_back(1.4 * bending(g, x));
    s.profiles.rest_yy.push_back(0.1 * bending(g, x));
  }
  s.profiles.buckling_load = buckling_load(g);
  return s;
}

Geometry geometry(int i) {
  const auto wave = [](double k) { return 0.5 + 0.5 * std::sin(k); };  // spreads the points, no lattice
  return {2.0 * wave(1.7 * i), 0.02 * std::pow(100.0, wave(2.9 * i + 1.0)), 2.6 * wave(4.1 * i + 2.0),
          0.05 + 0.1 * wave(5.3 * i)};
}

std::vector<ProfileSample> samples(int n) {
  std::vector<ProfileSample> all;
  for (int i = 0; i < n; ++i) all.push_back(sample(geometry(i)));
  // Straight edges: the same problem for every theta.
  for (const double theta : {0.0, 1.0, 2.6}) all.push_back(sample({0.0, 0.02, theta, 0.1}));
  return all;
}

double largest_error(const ProfileModel& model, const Geometry& g) {
  const Profiles p = model.predict(g);
  double error = 0.0;
  for (std::size_t i = 0; i < p.station.size(); ++i) {
    error = std::max(error, std::abs(p.bending_xx[i] - bending(g, p.station[i])));
  }
  return error;
}

BOOST_AUTO_TEST_CASE(the_model_passes_through_the_solved_geometries) {
  const ProfileModel model = ProfileModel::fit(samples(150), "none");
  // The modes that are left out have 1e-3 of the deviation of the scaled profiles in the root mean square; the worst
  // station of the worst geometry has up to ten times that.
  for (int i = 0; i < 150; ++i) BOOST_TEST(largest_error(model, geometry(i)) < 1e-2);
  BOOST_TEST(largest_error(model, {0.0, 0.02, 1.7, 0.1}) < 1e-2);
}

BOOST_AUTO_TEST_CASE(the_model_interpolates_between_them) {
  const ProfileModel model = ProfileModel::fit(samples(300), "none");
  double sum = 0.0;
  int n = 0;
  for (int i = 1000; i < 1050; ++i, ++n) sum += largest_error(model, model.clamp(geometry(i)));
  // Bending is up to 2 here; the mean error of the interpolation falls with the number of geometries (0.1 at 30).
  BOOST_TEST(sum / n < 0.04);
}

BOOST_AUTO_TEST_CASE(stations_increase_also_at_the_straight_edge_and_hold_the_base_line) {
  const ProfileModel model = ProfileModel::fit(samples(50), "none");
  for (const Geometry& g :
       {Geometry{0.0, 0.5, 1.0, 0.1}, Geometry{1e-8, 0.5, 1.0, 0.1}, Geometry{0.7, 0.5, 1.0, 0.1}}) {
    const Profiles p = model.predict(g);
    bool has_base_line = false;
    for (std::size_t i = 0; i < p.station.size(); ++i) {
      if (i > 0) BOOST_TEST(p.station[i] > p.station[i - 1]);
      has_base_line |= std::abs(p.station[i] - g.b_lc) < 1e-8;
    }
    BOOST_TEST(has_base_line);
    // As far beyond the base line as the sample with the deepest protrusion goes, b = 2 but for the spread of points.
    BOOST_TEST(p.station.back() - g.b_lc == 4.0, boost::test_tools::tolerance(0.01));
  }
}

BOOST_AUTO_TEST_CASE(a_written_model_reads_back_and_a_changed_one_is_refused) {
  const fs::path folder = fs::temp_directory_path() / ("brash_profiles_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const std::string file = folder / "profiles.json";
  const ProfileModel model = ProfileModel::fit(samples(50), "none");
  const std::string hash = model.write(file);
  const ProfileModel again = ProfileModel::read(file);
  BOOST_TEST(again.n_modes() == model.n_modes());
  BOOST_TEST(again.predict(geometry(3)).bending_xx == model.predict(geometry(3)).bending_xx);
  BOOST_TEST(again.write(file) == hash);
  BOOST_TEST(model_format(file) == kProfileFormat);
  BOOST_CHECK_THROW(Network::read(file), InputError);

  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  std::string changed = text.str();
  changed.replace(changed.find("\"none\""), 6, "\"more\"");
  std::ofstream(file) << changed;
  BOOST_CHECK_THROW(ProfileModel::read(file), InputError);
  fs::remove_all(folder);
}

BOOST_AUTO_TEST_CASE(a_written_model_whose_sides_turn_back_is_refused) {
  const fs::path folder = fs::temp_directory_path() / ("brash_profiles_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const std::string file = folder / "profiles.json";
  std::vector<ProfileSample> all = samples(50);
  all.push_back(sample({0.0, 0.02, 3.2, 0.1}));  // a straight edge fits, whatever its theta
  ProfileModel::fit(all, "none").write(file);
  BOOST_CHECK_EXCEPTION(ProfileModel::read(file), InputError, [](const InputError& error) {
    return std::string(error.what()).find("must be below pi") != std::string::npos;
  });
  fs::remove_all(folder);
}

std::string refusal_of(std::span<const ProfileSample> few) {
  try {
    ProfileModel::fit(few, "none");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

BOOST_AUTO_TEST_CASE(fewer_geometries_than_two_a_term_are_refused_and_h_counts_if_it_varies) {
  std::vector<ProfileSample> all;
  for (int i = 0; i < 42; ++i) all.push_back(sample(geometry(i)));
  // Five features have 21 terms, four 15.
  BOOST_TEST(refusal_of(all) == "");
  all.pop_back();
  BOOST_TEST(refusal_of(all).find("has 41 solved geometries that differ\n  allowed: at least 42, 2 for each term") !=
             std::string::npos);
  for (ProfileSample& s : all) s = sample({s.geometry.b_lc, s.geometry.c_lc, s.geometry.theta, 0.1});
  all.resize(30);
  BOOST_TEST(refusal_of(all) == "");
  all.back() = all.front();  // solved twice: one point
  BOOST_TEST(refusal_of(all).find("has 29 solved geometries that differ\n  allowed: at least 30") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(geometries_outside_the_range_are_told_and_clamped) {
  const ProfileModel model = ProfileModel::fit(samples(50), "none");
  const Geometry outside{3.0, 0.001, 1.0, 0.1};
  BOOST_TEST(model.check(outside).above);
  BOOST_TEST(model.check(outside).below);
  BOOST_TEST(model.check(model.clamp(outside)).inside());
  BOOST_CHECK_THROW(model.predict(outside), ContractViolation);
  BOOST_CHECK_THROW(ProfileModel::fit(std::span<const ProfileSample>(), ""), InputError);
}

}  // namespace
