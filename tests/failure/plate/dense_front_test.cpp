// SPDX-License-Identifier: GPL-3.0-or-later
#include "dense_front.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <vector>

namespace plate = brash::plate;

namespace {

/// A system of k unknowns that are eliminated and r others, in the two blocks of a front.
struct Split {
  Eigen::MatrixXd own, left;  ///< the right-hand side is the last row

  Split(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right, int k) {
    const Eigen::Index n = matrix.rows();
    Eigen::MatrixXd all(n + 1, n);
    all << matrix, right.transpose();
    own = all.leftCols(k);
    left = all.bottomRightCorner(n + 1 - k, n - k);
    left.bottomRows(1).setZero();  // the load of the others comes with the part that eliminates them
  }
};

/// Positive definite.
Eigen::MatrixXd random_matrix(int n, std::mt19937_64& random) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return number(random); });
  return a * a.transpose() + Eigen::MatrixXd::Identity(n, n);
}

BOOST_AUTO_TEST_SUITE(dense_front)

BOOST_AUTO_TEST_CASE(an_eliminated_front_has_the_solution_of_the_whole_system) {
  std::mt19937_64 random(1);
  for (int n = 1; n <= 23; ++n) {
    for (int k = 0; k <= n; k += 1 + n / 7) {
      const Eigen::MatrixXd matrix = random_matrix(n, random);
      const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(n, 1.0, 2.0);
      Split split(matrix, right, k);
      BOOST_REQUIRE(plate::eliminate(split.own.data(), k, split.left.data(), n - k));

      const Eigen::VectorXd solution = matrix.llt().solve(right);
      std::vector<double> unknowns(solution.data(), solution.data() + n);
      std::fill_n(unknowns.begin(), k, 0.0);
      plate::substitute(split.own.data(), k, n - k, unknowns.data());
      for (int i = 0; i < n; ++i) BOOST_TEST(std::abs(unknowns[static_cast<std::size_t>(i)] - solution(i)) < 1e-12);

      // The others alone have the remainder of the matrix and of the load.
      if (k == n) continue;
      const Eigen::MatrixXd rest = split.left.topRows(n - k).selfadjointView<Eigen::Lower>();
      const Eigen::VectorXd load = right.tail(n - k) + split.left.bottomRows(1).transpose();
      BOOST_TEST((rest.llt().solve(load) - solution.tail(n - k)).norm() < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_front_that_is_not_positive_definite_is_refused) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(9, 9);
  matrix(6, 6) = -1.0;
  Split early(matrix, Eigen::VectorXd::Ones(9), 8);
  BOOST_TEST(!plate::eliminate(early.own.data(), 8, early.left.data(), 1));
  Split late(matrix, Eigen::VectorXd::Ones(9), 6);  // the pivot belongs to the others
  BOOST_TEST(plate::eliminate(late.own.data(), 6, late.left.data(), 3));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
