// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/plate/plate.hpp"
#include "mesh.hpp"

namespace brash::plate {

class CondensedSystem;
class Field;

/// Floating plate in units of k = 1, l_c = 1, hence D = 1.
struct BendingProblem {
  double poisson_ratio = 0.3;
  double shear_stiffness = 0.0;                  ///< kappa G h l_c^2 / D
  double tip_line_load = 0.0;                    ///< P on the edges tagged kTip
  std::function<double(int triangle)> pressure;  ///< on the elements; empty for none
  const Field* in_plane_stress = nullptr;        ///< on the same mesh, per unit of `in_plane_load`; tension positive
  double in_plane_load = 0.0;                    ///< N / sqrt(k D); its stress acts on the slope of the bent plate
};

/// kappa G h l_c^2 / D = 5 (1 - nu) (l_c / h)^2 with Reissner's kappa = 5/6.
double shear_stiffness(double poisson_ratio, double thickness_over_lc);

/// Plane stress in units of E h / (1 - nu^2) = 1: stresses follow the loads whatever the unit.
struct MembraneProblem {
  double poisson_ratio = 0.3;
  std::vector<Vec2> tip_tractions;  ///< on the edges tagged kTip, one load case each
  bool antisymmetric = false;       ///< about the edges tagged kSymmetryY
};

/// A finite element solution: the unknowns of every element.
class Field {
 public:
  Field(const Mesh& mesh, int order, double poisson_ratio, Eigen::MatrixXd local, int first_row, int n_functions);

  const Mesh& mesh() const { return *mesh_; }
  int order() const { return order_; }

  /// (1 - nu) e + nu tr(e) 1 with e the symmetric gradient of the vector field: moments (positive where the surface
  /// that a positive P puts in tension on a cantilever is in tension) or membrane stress.
  Tensor2 tensor(int triangle, double xi, double eta) const;

  /// The deflection; bending only.
  double deflection(int triangle, double xi, double eta) const;

  /// Position of a point of the reference triangle.
  Vec2 place(int triangle, double xi, double eta) const;

 private:
  const Mesh* mesh_;
  int order_;
  double poisson_ratio_;
  Eigen::MatrixXd local_;
  int first_row_;    ///< of the vector field in `local_`
  int n_functions_;  ///< of each of its components
};

/// Reissner-Mindlin bending on the elements of that order. Free on every edge that is not one of symmetry.
tl::expected<Field, std::string> solve_bending(const Mesh& mesh, int order, const BendingProblem& problem);

/// The plate of a BendingProblem with its stiffness factorised. Local unknowns of every element, shape=(n_local,
/// n_elements): the deflection's nodal values, then the nodal values of the two rotations.
class BendingSystem {
 public:
  /// With the answer to the problem's own load.
  static tl::expected<BendingSystem, std::string> factorise(const Mesh& mesh, int order, const BendingProblem& problem);
  BendingSystem(BendingSystem&&) noexcept;
  BendingSystem& operator=(BendingSystem&&) noexcept;
  ~BendingSystem();

  /// The local unknowns under the problem's own load.
  const Eigen::MatrixXd& answer() const { return answer_; }
  /// The local unknowns under loads on the nodes of the deflection, shape=(n_lagrange, n_elements).
  Eigen::MatrixXd answer_to(const Eigen::MatrixXd& loads) const;

 private:
  explicit BendingSystem(std::unique_ptr<CondensedSystem> system);
  std::unique_ptr<CondensedSystem> system_;
  Eigen::MatrixXd answer_;
};

/// How the bent plate answers to an in-plane load n that acts on its slope: K w = f + n G w, with G the work of the
/// unit in-plane stress (compression positive), is w_0 + n w_1 + n^2 w_2 + ..., w_i = K^-1 G w_(i-1).
struct InPlaneSeries {
  std::vector<Field> terms;  ///< w_0, w_1, w_2
  double buckling_load =
      0.0;  ///< Rayleigh's quotient of w_1, an upper bound on the least n that makes K - n G singular
};

/// The series of `problem.in_plane_stress`, about `problem.in_plane_load` = 0.
tl::expected<InPlaneSeries, std::string> solve_in_plane_series(const Mesh& mesh, int order,
                                                               const BendingProblem& problem);

/// Plane stress; clamped on the edges tagged kFar. One field for each load case.
tl::expected<std::vector<Field>, std::string> solve_membrane(const Mesh& mesh, int order,
                                                             const MembraneProblem& problem);

}  // namespace brash::plate
