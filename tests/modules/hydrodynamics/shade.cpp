// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <boost/test/unit_test.hpp>
#include <random>
#include <vector>

#include "brash/core/constants.hpp"
#include "shapes.hpp"
#include "surface_drag.hpp"

namespace {

using namespace brash;
using namespace brash::test;
using hydrodynamics::Lanes;
using hydrodynamics::open_shares;
using hydrodynamics::Vectors;

using Planes = std::vector<Plane>;

class Random {
 public:
  double operator()(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  Vec3 in_box(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
  Pose pose(double size) { return {in_box(size), turn(in_box(1.0) + Vec3{0.0, 0.0, 1.1}, (*this)(0.0, 2.0 * kPi))}; }

 private:
  std::mt19937_64 engine_{7};
};

/// A regular prism or cone frustum of `n` sides.
Planes frustum(std::size_t n, double radius, double height, double slope, const Pose& pose) {
  Planes planes;
  const auto add = [&](Vec3 normal, double offset) {
    const Vec3 turned = rotate(pose.rotation, normalized(normal));
    planes.push_back({turned, offset / norm(normal) + dot(turned, pose.position)});
  };
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(n);
    add({std::cos(angle), std::sin(angle), slope}, radius);
  }
  add({0.0, 0.0, 1.0}, 0.5 * height);
  add({0.0, 0.0, -1.0}, 0.5 * height);
  return planes;
}

/// (H8) as it is written.
double plain_share(Vec3 probe, const std::vector<Planes>& solids, double gap) {
  double held = 0.0;
  for (const Planes& solid : solids) held += std::clamp(0.5 - signed_distance(solid, probe) / gap, 0.0, 1.0);
  return std::max(0.0, 1.0 - held);
}

BOOST_AUTO_TEST_SUITE(shade)

BOOST_AUTO_TEST_CASE(the_share_of_the_stream_is_that_of_all_planes_of_all_neighbours) {
  Random random;
  int open = 0, partly = 0, closed = 0;
  for (int k = 0; k < 300; ++k) {
    const double gap = random(0.05, 0.5);
    std::vector<Planes> solids;
    for (int i = k % 13; i > 0; --i)
      solids.push_back(
          frustum(3 + static_cast<std::size_t>(k * i) % 9, random(0.2, 1.0), random(0.2, 1.0), 0.0, random.pose(2.0)));
    if (k % 2 == 0) solids.push_back(frustum(66, 6.0, 4.0, 1.0, {random.in_box(6.0), {}}));
    const Pose pose = random.pose(1.0);
    std::vector<Vectors> probes(1 + static_cast<std::size_t>(k) % 9);
    for (Vectors& four : probes) {
      const auto lanes = [&](double size) {
        return Lanes(random(-size, size), random(-size, size), random(-size, size), random(-size, size));
      };
      four = {lanes(1.0), lanes(1.0), lanes(0.3)};
    }
    std::vector<Lanes> shares(probes.size());
    const std::vector<Solid> neighbours(solids.begin(), solids.end());
    open_shares(probes, pose, neighbours, gap, shares);
    for (std::size_t i = 0; i < probes.size(); ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        const Vec3 probe = to_world(pose, {probes[i].x[j], probes[i].y[j], probes[i].z[j]});
        const double expected = plain_share(probe, solids, gap);
        BOOST_CHECK_SMALL(shares[i][j] - expected, 1e-12);  // rounding in 10 m / 0.05 m, and the sum of a dozen
        (expected == 1.0 ? open : expected == 0.0 ? closed : partly) += 1;
      }
  }
  BOOST_TEST(open > 1000);
  BOOST_TEST(partly > 300);
  BOOST_TEST(closed > 300);
}

BOOST_AUTO_TEST_CASE(without_neighbours_the_stream_is_free) {
  const std::array<Vectors, 1> probes{};
  std::array<Lanes, 1> share{0.0};
  open_shares(probes, {}, {}, 0.2, share);
  BOOST_TEST(share[0][3] == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
