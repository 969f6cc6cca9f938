// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>

#include "brash/model/case_keys.hpp"
#include "checks.hpp"
#include "resolve.hpp"

namespace brash::io {
namespace {

void check_ice(const model::Case& c, Checks& checks) {
  checks.require(c.ice.density < c.water.density, {"ice", "density"}, {"water", "density"},
                 "ice that is not lighter than the water does not float",
                 fmt::format("less than water.density = {} kg m-3", c.water.density),
                 "lower ice.density or raise water.density");
  checks.require(2.0 * c.contact.margin < c.ice.thickness, {"contact", "margin"}, {"ice", "thickness"},
                 "leaves no body of the ice",
                 fmt::format("less than half of ice.thickness, {} m", c.ice.thickness / 2.0), "lower contact.margin");
}

void check_contact(const model::Case& c, Checks& checks) {
  checks.require(c.contact.restitution == 0.0 || c.contact.engine == model::ContactEngine::kBrash,
                 {"contact", "restitution"}, {"contact", "engine"}, "with engine = bullet contacts could give energy",
                 "0 with contact.engine = \"bullet\"", "take engine = \"brash\", or 0");
}

void check_water(const model::Case& c, Checks& checks) {
  const model::HydrodynamicsSection& h = c.hydrodynamics;
  checks.require(h.form_drag_along != model::FormDragAlong::kNormal || h.drag == model::DragLaw::kSurface,
                 {"hydrodynamics", "form_drag_along"}, {"hydrodynamics", "drag"},
                 "the drag law paper has one velocity for all faces", "normal with hydrodynamics.drag = \"surface\"",
                 "take drag = \"surface\", or form_drag_along = \"velocity\"");
  const bool plate = h.added_mass_law == model::AddedMassLaw::kPlate;
  checks.require(!plate || c.contact.engine == model::ContactEngine::kBrash, {"hydrodynamics", "added_mass_law"},
                 {"contact", "engine"}, "Bullet's bodies have the same mass in every direction",
                 "plate with contact.engine = \"brash\"",
                 "take this engine, or added_mass_law = \"isotropic\" or \"none\"");
}

/// Ice afloat keeps clear of the bed, and a path has no one velocity that the bed could share.
void check_bed(const model::Case& c, Checks& checks) {
  if (!c.water.depth) return;
  const Key depth{"water", "depth"};
  const double draught = c.ice.thickness * c.ice.density / c.water.density;
  checks.require(*c.water.depth > draught, depth, {"ice", "thickness"}, "the ice does not float: it reaches the bed",
                 fmt::format("more than the ice's draught, {:.6g} m", draught), "deepen the water or thin the ice");
  checks.require(c.contact.engine == model::ContactEngine::kBrash, depth, {"contact", "engine"},
                 "Bullet's contacts know no bed", "absent with contact.engine = \"bullet\"",
                 "take engine = \"brash\", or remove water.depth");
  checks.require(!model::has_path(c.structure) || c.structure.frame == model::MotionFrame::kStructureMoves,
                 {"structure.motion", "frame"}, {"structure.motion", "path"},
                 "a path has no one speed at which the bed could drift past the ice",
                 "structure-moves with a path and water.depth", "take structure-moves, or remove water.depth");
}

void check_rest(const model::Case& c, Checks& checks) {
  checks.require(c.failure.wedges[0] <= c.failure.wedges[1], {"failure", "wedges"}, {"failure", "wedges"},
                 "the least number is above the largest", "[least, largest] with least <= largest",
                 "swap the two numbers");
  checks.require(c.time.step <= c.time.duration, {"time", "step"}, {"time", "duration"},
                 "the step is longer than the run", fmt::format("at most time.duration = {} s", c.time.duration),
                 "lower time.step or raise time.duration");
  constexpr double kMostSteps = 1e8;  // their history alone takes 30 GB
  checks.require(c.time.duration / c.time.step <= kMostSteps, {"time", "duration"}, {"time", "step"},
                 fmt::format("takes {:.3g} steps", c.time.duration / c.time.step),
                 fmt::format("at most {:g} steps, {:.6g} s at this step", kMostSteps, kMostSteps * c.time.step),
                 "shorten the run or lengthen time.step");
  checks.require(c.output.statistics_from.value_or(0.0) < c.time.duration, {"output", "statistics_from"},
                 {"time", "duration"}, "the statistics would begin after the run",
                 fmt::format("less than time.duration = {} s", c.time.duration),
                 "lower output.statistics_from or raise time.duration");
  const model::FailureOptions takes = model::options_of(c.failure.model, !c.failure.file.empty());
  const std::string_view name = model::name_of(c.failure.model);
  checks.require(
      c.failure.order != model::CrackOrder::kRadialFirst || takes.radial_first, {"failure", "order"},
      {"failure", "model"}, fmt::format("the model {} cannot split the sheet", name),
      "radial-first with failure.model = \"plate\", \"plate-outline\", or \"superposition\" without failure.file",
      "take one of these models, or circumferential-first");
  checks.require(!c.failure.second_order || takes.second_order, {"failure", "second_order"}, {"failure", "model"},
                 fmt::format("the model {} is of first order", name),
                 "true with failure.model = \"superposition\", \"plate\" or \"plate-outline\"",
                 "take one of these models, or false");
  checks.require(!c.failure.joint_loads || takes.joint_loads, {"failure", "joint_loads"}, {"failure", "model"},
                 fmt::format("the model {} knows one load at a time", name),
                 "true with failure.model = \"plate-outline\"", "take this model, or false");
  checks.require(c.failure.edge != model::EdgeMotion::kDynamic || takes.moving_edge, {"failure", "edge"},
                 {"failure", "model"}, fmt::format("the model {} knows no edge that moves", name),
                 "dynamic with failure.model = \"plate-outline\"", "take this model, or static");
  checks.require(c.failure.judged != model::JudgedAt::kAnywhere || takes.knows_field, {"failure", "judged"},
                 {"failure", "model"}, fmt::format("the model {} knows no stress beside its centre line", name),
                 "anywhere with failure.model = \"plate-outline\"", "take this model, or centre-line");
  checks.require(c.failure.pattern != model::CrackPattern::kStress || takes.knows_field, {"failure", "pattern"},
                 {"failure", "model"}, fmt::format("the model {} knows no stress beside its centre line", name),
                 "stress with failure.model = \"plate-outline\"", "take this model, or disc");
  checks.require(c.failure.length_density != model::LengthDensity::kIce || takes.meta_model,
                 {"failure", "length_density"}, {"failure", "model"},
                 fmt::format("the model {} is a plate on water", name),
                 "ice with failure.model = \"network\" or \"deep-network\"", "take one of these models, or water");
  checks.require(c.failure.pressure != model::EdgePressure::kContact || takes.meta_model, {"failure", "pressure"},
                 {"failure", "model"}, fmt::format("the model {} needs the force on the edge", name),
                 "contact with failure.model = \"network\" or \"deep-network\"", "take one of these models, or edge");
  checks.require(c.failure.file.empty() || takes.file, {"failure", "file"}, {"failure", "model"},
                 fmt::format("the model {} reads no file", name),
                 "a file with failure.model = \"network\", \"deep-network\" or \"superposition\"",
                 "take one of these models, or remove failure.file");
  std::error_code ignored;
  checks.require(c.failure.file.empty() || std::filesystem::is_regular_file(c.failure.file, ignored),
                 {"failure", "file"}, {"failure", "file"}, fmt::format("there is no file {}", c.failure.file),
                 "a file, relative to the case file",
                 "correct the path, or remove the line to take the model that comes with the program");
}

}  // namespace

std::vector<Problem> cross_check(const model::Case& resolved, const CaseSource& source, FieldFiles files) {
  Checks checks(source);
  check_ice(resolved, checks);
  check_structure(resolved, checks);
  check_field(resolved, files, checks);
  check_hull(resolved, checks);
  check_contact(resolved, checks);
  check_water(resolved, checks);
  check_bed(resolved, checks);
  check_rest(resolved, checks);
  return checks.take();
}

}  // namespace brash::io
