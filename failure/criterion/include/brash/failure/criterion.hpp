// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/model/choices.hpp"
#include "brash/model/records.hpp"

namespace brash::failure {

/// Ice and water as the failure criterion sees them; SI.
struct IceProperties {
  double thickness = 0.0;             ///< h [m]
  double youngs_modulus = 0.0;        ///< E [Pa]
  double poisson_ratio = 0.3;         ///< nu [-]
  double flexural_strength = 0.0;     ///< sigma_f [Pa]
  double compressive_strength = 0.0;  ///< sigma_c [Pa]
  double crushing_factor = 0.5;       ///< R of Eq. 15 [-]
  double water_density = 1025.0;      ///< rho_w [kg/m3]
  /// rho of Eq. 18 [kg/m3]; absent: the water's. Only the networks take another one.
  std::optional<double> length_density{};
};

/// l_c = (E h^3 / (12 rho g (1 - nu^2)))^(1/4) [m], Eq. 18 with IceProperties::length_density;
/// docs/theory/fracture-of-the-edge.md, (1).
double characteristic_length(const IceProperties& ice);

/// How much a load bends the ice at a distance along a straight edge, over the same load there [-].
/// @param distance  over l_c.
double share_at(double distance);

/// F_n = sigma_c A R [N] on a contact of area `area` [m2], Eq. 15.
double crushing_force(const IceProperties& ice, double area);

/// A cone's or plane's contact with the ice edge, split into the paper's components per unit normal contact force.
struct LoadRatios {
  double horizontal = 0.0;  ///< in-plane normal N over the contact's normal force [-]
  double mu1 = 0.0;         ///< P / N [-]
  double mu2 = 0.0;         ///< f / N on the ice, positive counter-clockwise along the structure's section [-]
};

/// Resolves a contact on a surface that slopes at `slope` from the horizontal and slides against the ice.
///
/// In the axes (plan normal into the ice, plan tangent counter-clockwise along the section, vertical as the ice is
/// pushed: down or up, the same numbers) the surface normal is n = (sin a, 0, cos a). The structure moves with
/// u = (cos H, sin H, 0), so it slips along s = u - (u n) n, and the ice gets n + mu s/|s| per unit normal force:
///
///     N = sin a + mu cos H cos^2 a / |s|,  P = cos a - mu cos H sin a cos a / |s|,  f = mu sin H / |s|,
///     |s| = sqrt(cos^2 H cos^2 a + sin^2 H).
///
/// At heading 0: mu1 = (cos a - mu sin a)/(sin a + mu cos a). Where mu would be more than |s| / (u n), the ice sticks:
/// friction is then as large as that, and the force lies along u, so P = 0. Without slip (a vertical wall met squarely)
/// there is no friction.
///
/// @param slope     a [rad], in (0, pi/2].
/// @param friction  mu [-], >= 0.
/// @param heading   H [rad]: direction of motion, counter-clockwise from the contact's plan normal (into the ice).
///                  On the port flank of a structure that moves along x (normal (0.6, 0.8)) it is negative.
/// @see docs/theory/fracture-of-the-edge.md, (N1)
LoadRatios load_ratios(double slope, double friction, double heading);

/// A load on the sheet near a contact, even along a stretch of the free edge or over a disc inside the ice. Frame of
/// LoadCase::outline.
struct SheetLoad {
  Vec2 from{}, to{};          ///< ends of a straight stretch of the outline, in its order [m]
  double radius = 0.0;        ///< > 0: of a disc around `from` instead [m]
  Vec2 in_plane{};            ///< [N]; only on the edge
  double out_of_plane = 0.0;  ///< [N], positive as the contact's own P
  /// Of the in-plane force about the edge, because it acts above or below mid-thickness [N m]. Positive where it bends
  /// the ice ahead as the contact's own P does.
  double moment = 0.0;
  /// Whether the criterion is asked about this load too, as the own one of another load case.
  bool has_verdict = true;
};

/// A sheet that moves, as one at rest under the same loads: its D is kept, its lengths and moments are not. All 1: at
/// rest. The membrane stress does not change.
struct SheetMotion {
  double length = 1.0;  ///< of the sheet at rest: its l_c over the ice's
  double stress = 1.0;  ///< its moments are this many times as large
  double radial = 1.0;  ///< its moment along the edge at B is this many times as large
};

/// The motion of an edge, as long as the sheet is whole and once a radial crack has split it.
/// @see docs/theory/fracture-of-the-edge.md
struct EdgeMotion {
  SheetMotion whole, split;
};

/// One contact, ready for the criterion.
struct LoadCase {
  double depth = 0.0;           ///< b [m]
  double contact_length = 0.0;  ///< c [m]
  double angle = 0.0;           ///< theta [rad]
  double mu1 = 0.0;             ///< P / N [-]
  double mu2 = 0.0;             ///< f / N [-]
  double pressure = 0.0;        ///< p = N / (c h) [Pa]; for a network it may be of another area
  /// The free edge around B for a criterion with needs_outline(), else empty [m]: from y < 0 to y > 0 in the frame of
  /// the middle of the tip edge (x into the ice, y along the tip edge), ice on its right. (0, -c/2) and (0, c/2) are
  /// points of it, one after the other. f acts along y.
  std::vector<Vec2> outline{};
  /// The loads on that edge that are to act together, the contact's own first. Empty: the contact's own load alone.
  std::vector<SheetLoad> loads{};
  EdgeMotion motion{};  ///< `plate-outline`
};

/// The answer of the criterion to a load case.
struct Assessment {
  bool fails = false;            ///< sigma_max > sigma_f
  double sigma_max = 0.0;        ///< largest principal stress [Pa]
  double breaking_length = 0.0;  ///< l_break [m]
  bool below_range = false;      ///< an input was clamped up to the model's range, or h / l_c lies outside it
  bool above_range = false;      ///< an input exceeds the model's range (and was clamped down)
  bool outline_refused = false;  ///< no edge, or a sheet that could not be solved; the answer holds for the trapezoid
  bool buckled = false;          ///< the plate buckles under N: it fails, stress and place are of first order
  bool split = false;            ///< a radial crack came first: stress and place belong to the split sheet
  /// The loads over those at which the ice would just fail, as if stresses grew in proportion [-]: above 1 it fails,
  /// unless no crack cuts it off. A bound from above where a radial crack may come first. `plate-outline`.
  double overload = 0.0;
  model::SheetSolves solves{};
  /// The circumferential crack along the stress, if the ice fails and BendingOptions::trace_crack asks for it: from one
  /// free edge to the other, frame of LoadCase::outline [m]. Empty where it does not reach the edge.
  std::vector<Vec2> crack{};
};

/// Says whether the ice fails in bending and how far in. Stateless after construction.
class BendingCriterion {
 public:
  virtual ~BendingCriterion() = default;
  /// @param load  depth >= 0, contact_length > 0, angle in [0, pi), mu1 > 0, pressure >= 0.
  virtual Assessment assess(const LoadCase& load) const = 0;
  /// The answer of `assess`, without stress and breaking length, if it is plain at a small price that `load` stays
  /// below half the strength. Nothing where only `assess` can show that.
  virtual std::optional<Assessment> dismiss(const LoadCase& /*load*/) const { return std::nullopt; }
  /// Whether an input exceeds the model's range. A shorter step of the structure may bring it back.
  virtual bool above_range(const LoadCase& /*load*/) const { return false; }
  /// Whether `assess` wants outline and loads of the load case besides its trapezoid.
  virtual bool needs_outline() const { return false; }
  /// The one h / l_c that its model was trained with; nothing where the model knows h / l_c or needs none.
  virtual std::optional<double> trained_thickness_over_lc() const { return std::nullopt; }
  /// Least and largest h / l_c that the model holds for; nothing for one without limits.
  virtual std::optional<std::pair<double, double>> thickness_over_lc_range() const { return std::nullopt; }
  /// The same criterion for other ice: it shares the model, so it costs little.
  virtual std::unique_ptr<BendingCriterion> for_ice(const IceProperties& ice) const = 0;
};

/// Options that go beyond the paper's criterion. docs/theory/fracture-of-the-edge.md, (4)
struct BendingOptions {
  /// The in-plane force N acts on the bent plate: `superposition`, `plate` and `plate-outline`. A plate that buckles
  /// under N fails.
  bool second_order = false;
  /// Where the edge stress on the other surface exceeds the strength, a radial crack splits the sheet along the centre
  /// line before it breaks circumferentially: `plate`, and `superposition` with the models that come with the program.
  bool radial_first = false;
  /// The stress is evaluated all over the sheet around B, not on the centre line alone: `plate-outline`.
  bool anywhere = false;
  /// Where quadratic elements find less than 0.8 of the strength, for a radial crack too, the sheet is not solved with
  /// cubic ones. Stress and breaking length are theirs then: `plate-outline`.
  bool coarse_first = false;
  /// Assessment::crack is wanted: `plate-outline`.
  bool trace_crack = false;
  /// A contact below the range keeps its pressure p in place of its force p c h: `network`, `deep-network` and
  /// `superposition`.
  bool keeps_pressure = false;
};

/// The criterion named `model`:
/// - `network`: Eq. 17 with the weights of `file`, the stress scaled by Eq. 19 from the training h/l_c. Inputs outside
///   the model's range are moved into it; below the smallest c the load keeps its total force p c h, or its pressure.
/// - `deep-network`: the same inputs and outputs by a larger network, which knows two humps of the stress.
/// - `superposition`: unit profiles interpolated between solved geometries, superposed exactly in mu1, mu2, E and h,
///   but for the h / l_c of the shear flexibility, which is moved into the model's range.
/// - `plate`: the floating plate solved for each load case (about a third of a second each). Where the superposition
///   that comes with the program knows h / l_c and says less than 80 % of the strength (less with options), it answers.
/// - `plate-outline`: the same on the load's outline, simplified to min(0.02 l_c, c/4); where it cannot be meshed, or
///   there is none, on the trapezoid. It needs no range. Not solved below a sixth of the strength, as above.
/// - `wedge`: narrow wedge as a tapered beam on water, cut off where it is c wide, loaded on that end; bending only,
///   whatever the depth b. It needs no range.
///
/// @param file  of the network (of either kind) or of the superposition; empty: the model that comes with the program,
/// see model_path().
/// @throws InputError for an unreadable file; for second_order or radial_first without a model for it. Others are idle.
std::unique_ptr<BendingCriterion> make_criterion(model::FailureModel model, const std::string& file,
                                                 const IceProperties& ice, const BendingOptions& options = {});

/// The model file that `make_criterion(model, file, ...)` reads; empty when that model reads none.
///
/// With an empty `file` it is `cone_<model>.json` in the folder that the environment variable BRASH_MODEL_PATH names,
/// else with the sources for a program in the build tree and in share/brash/models for an installed one.
std::string model_path(model::FailureModel model, const std::string& file);

}  // namespace brash::failure
