// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "brash/io/results.hpp"

namespace brash::io {

/// The columns of the rows that a run leaves. `visit(name, unit, meaning, member)` is called for each column, where
/// `member(row)` is a reference to the value in `row`: one list serves the writing and the reading of every format.
/// `dimension` and `prefix` belong to the netCDF variables.
template <typename Row>
struct Columns;

template <>
struct Columns<model::LoadRow> {
  static constexpr const char* dimension = "time";
  static constexpr const char* prefix = "";

  template <typename Visit>
  static void visit(Visit&& visit) {
    visit(
        "time", "s", "end of the step", [](auto& row) -> auto& { return row.time; });
    visit_wrench("", "total load on the structure", &model::LoadRow::total, visit);
    visit_wrench("crushing_", "crushing at the sheet's edge", &model::LoadRow::crushing, visit);
    visit_wrench("floe_normal_", "normal contact forces of floes", &model::LoadRow::floe_normal, visit);
    visit_wrench("floe_friction_", "friction of floes", &model::LoadRow::floe_friction, visit);
    visit_state(visit);
    visit_optional(visit);
  }

  /// A history has such a column only if some row of it has a value there: the structure turns, is a body or a hull
  /// with regions, or ice has come to the bed.
  static bool is_optional(std::string_view name) {
    bool found = false;
    visit_optional([&](const std::string& optional, const auto&...) { found = found || name == optional; });
    return found;
  }

 private:
  template <typename Visit>
  static void visit_wrench(const std::string& cause, const std::string& meaning, Wrench model::LoadRow::*w,
                           Visit&& visit) {
    visit(
        cause + "Fx", "N",
        meaning + ", force against the heading", [w](auto& row) -> auto& { return (row.*w).force.x; });
    visit(
        cause + "Fy", "N",
        meaning + ", force to starboard of the heading", [w](auto& row) -> auto& { return (row.*w).force.y; });
    visit(
        cause + "Fz", "N", meaning + ", force upwards", [w](auto& row) -> auto& { return (row.*w).force.z; });
    visit(
        cause + "Mx", "N m",
        meaning + ", moment about the axis of Fx", [w](auto& row) -> auto& { return (row.*w).moment.x; });
    visit(
        cause + "My", "N m",
        meaning + ", moment about the axis of Fy", [w](auto& row) -> auto& { return (row.*w).moment.y; });
    visit(
        cause + "Mz", "N m", meaning + ", moment about z", [w](auto& row) -> auto& { return (row.*w).moment.z; });
  }

  /// The column of a loss, for EnergyLosses::visit().
  static auto column_of_loss(auto& visit) {
    return [&visit](const char* cause, const char* meaning, double model::EnergyLosses::*loss) {
      visit(
          std::string("loss_") + cause, "J",
          std::string("energy lost since the start: ") + meaning, [loss](auto& row) -> auto& {
            return row.losses.*loss;
          });
    };
  }

  template <typename Visit>
  static void visit_energy(Visit&& visit) {
    visit(
        "birth_energy", "J", "energy that floes had at birth or gained unexplained in their first step",
        [](auto& row) -> auto& { return row.birth_energy; });
    visit(
        "removed_energy", "J",
        "energy of deleted floes, of brash, of floes that fall asleep, of ice that leaves a sheet",
        [](auto& row) -> auto& { return row.removed_energy; });
    model::EnergyLosses::visit_without_bed(column_of_loss(visit));
    visit(
        "energy_error", "J", "work that no other energy accounts for",
        [](auto& row) -> auto& { return row.energy_error; });
  }

  template <typename Visit>
  static void visit_state(Visit&& visit) {
    visit(
        "kinetic_energy", "J", "kinetic energy of all floes, and of sheets that drift",
        [](auto& row) -> auto& { return row.kinetic_energy; });
    visit(
        "potential_energy", "J", "energy of all floes in gravity and buoyancy, against floating at rest",
        [](auto& row) -> auto& { return row.potential_energy; });
    visit(
        "work", "J", "work done by the structure since the start", [](auto& row) -> auto& { return row.work; });
    visit_energy(visit);
    visit(
        "area_sheet", "m2", "ledger: area of the ice sheet", [](auto& row) -> auto& { return row.area_sheet; });
    visit(
        "area_floes", "m2", "ledger: area of the floes", [](auto& row) -> auto& { return row.area_floes; });
    visit(
        "area_crushed", "m2", "ledger: area crushed by the structure",
        [](auto& row) -> auto& { return row.area_crushed; });
    visit(
        "area_deleted", "m2", "ledger: area of deleted floes", [](auto& row) -> auto& { return row.area_deleted; });
    visit(
        "area_brash", "m2", "ledger: area of pieces too small for a body",
        [](auto& row) -> auto& { return row.area_brash; });
    visit(
        "area_snap", "m2", "ledger: area moved by rounding to the grid",
        [](auto& row) -> auto& { return row.area_snap; });
    visit(
        "n_floes", "1", "number of floes", [](auto& row) -> auto& { return row.n_floes; });
    visit(
        "n_contacts", "1", "number of points at which floes press on the structure",
        [](auto& row) -> auto& { return row.n_contacts; });
    visit(
        "structure_x", "m", "place of the structure's origin along the sheet's x",
        [](auto& row) -> auto& { return row.structure.x; });
    visit(
        "structure_y", "m", "place of the structure's origin to port",
        [](auto& row) -> auto& { return row.structure.y; });
    visit(
        "structure_vx", "m s-1", "velocity of the structure's origin along the sheet's x, mean over the step",
        [](auto& row) -> auto& { return row.velocity.x; });
    visit(
        "structure_vy", "m s-1", "velocity of the structure's origin to port, mean over the step",
        [](auto& row) -> auto& { return row.velocity.y; });
  }

  template <typename Visit>
  static void visit_optional(Visit&& visit) {
    visit_motion(visit);
    model::RegionLoads::visit([&](const std::string& region, const std::string& meaning, std::size_t i) {
      visit_force("_" + region, "load on " + meaning, i, &model::RegionLoad::total, visit);
      visit_force("_" + region + "_crushing", "load of the sheet's edge on " + meaning, i, &model::RegionLoad::crushing,
                  visit);
      if (i < model::kHullRegions)
        visit(
            "covered_" + region, "1",
            "share of the wetted surface of " + meaning + " that floes cover", [i](auto& row) -> auto& {
              return row.regions[i].covered;
            });
    });
    visit_wrench("bed_", "load of the ice on the bed of the water", &model::LoadRow::bed, visit);
    model::EnergyLosses::visit_of_bed(column_of_loss(visit));
  }

  template <typename Visit>
  static void visit_force(const std::string& suffix, const std::string& meaning, std::size_t i,
                          Vec3 model::RegionLoad::*force, Visit&& visit) {
    const auto part = [&](const std::string& axis, const std::string& way, double Vec3::*along) {
      visit(
          "F" + (axis + suffix), "N", meaning + ", force " + way,
          [ i, force, along ](auto& row) -> auto& { return row.regions[i].*force.*along; });
    };
    part("x", "against the heading", &Vec3::x);
    part("y", "to starboard of the heading", &Vec3::y);
    part("z", "upwards", &Vec3::z);
  }

  template <typename Visit>
  static void visit_motion(Visit&& visit) {
    const auto of_vector = [&](const char* name, const char* unit, const char* meaning, Vec3 model::LoadRow::*vector,
                               double Vec3::*part) {
      visit(
          std::string(name), unit, std::string(meaning),
          [ vector, part ](auto& row) -> auto& { return row.*vector.*part; });
    };
    visit(
        std::string("structure_z"), "m", std::string("height of the structure's origin"),
        [](auto& row) -> auto& { return row.height; });
    visit(
        std::string("structure_vz"), "m s-1",
        std::string("velocity of the structure's origin upwards, mean over the step"),
        [](auto& row) -> auto& { return row.rise; });
    of_vector("structure_roll", "rad", "turn about its own x, third, starboard down", &model::LoadRow::attitude,
              &Vec3::x);
    of_vector("structure_pitch", "rad", "turn about its own y, second, bow down", &model::LoadRow::attitude, &Vec3::y);
    of_vector("structure_heading", "rad", "turn about z, first, to port", &model::LoadRow::attitude, &Vec3::z);
    of_vector("structure_wx", "rad s-1", "angular velocity about the sheet's x, mean over the step",
              &model::LoadRow::spin, &Vec3::x);
    of_vector("structure_wy", "rad s-1", "angular velocity about the sheet's y, mean over the step",
              &model::LoadRow::spin, &Vec3::y);
    of_vector("structure_wz", "rad s-1", "angular velocity about z, mean over the step", &model::LoadRow::spin,
              &Vec3::z);
    model::BodyEnergy::visit([&](const char* name, const char* meaning, double model::BodyEnergy::*energy) {
      visit(
          std::string("body_") + name, "J",
          std::string("of the structure as a body: ") + meaning, [energy](auto& row) -> auto& {
            return row.body.*energy;
          });
    });
  }
};

constexpr bool is_nowhere(std::string_view) { return false; }

/// As Columns<Row>::visit, without the optional columns that no row uses.
/// @param is_before  whether a row before these uses the column of a name.
template <typename Row, typename Visit, typename IsBefore = bool (*)(std::string_view)>
void visit_used(const std::vector<Row>& rows, Visit&& visit, const IsBefore& is_before = &is_nowhere) {
  Columns<Row>::visit([&](const std::string& name, const char* unit, const std::string& meaning, auto member) {
    if constexpr (requires { Columns<Row>::is_optional(name); }) {
      const auto is_used = [&](const Row& row) { return member(row) != 0; };
      if (Columns<Row>::is_optional(name) && !is_before(name) && std::none_of(rows.begin(), rows.end(), is_used))
        return;
    }
    visit(name, unit, meaning, member);
  });
}

template <>
struct Columns<model::CrackEvent> {
  static constexpr const char* dimension = "event";
  static constexpr const char* prefix = "event_";

  template <typename Visit>
  static void visit(Visit&& visit) {
    visit(
        "time", "s", "time of the break", [](auto& row) -> auto& { return row.time; });
    visit(
        "x", "m", "collision point B on the free edge, x", [](auto& row) -> auto& { return row.at.x; });
    visit(
        "y", "m", "collision point B on the free edge, y", [](auto& row) -> auto& { return row.at.y; });
    visit(
        "b", "m", "depth of the fitted trapezoid", [](auto& row) -> auto& { return row.depth; });
    visit(
        "c", "m", "contact length", [](auto& row) -> auto& { return row.contact_length; });
    visit(
        "theta", "rad", "opening angle of the fitted trapezoid", [](auto& row) -> auto& { return row.angle; });
    visit(
        "mu1", "1", "out-of-plane over in-plane normal force", [](auto& row) -> auto& { return row.mu1; });
    visit(
        "mu2", "1", "in-plane friction over in-plane normal force", [](auto& row) -> auto& { return row.mu2; });
    visit(
        "p", "Pa", "pressure on the contact", [](auto& row) -> auto& { return row.pressure; });
    visit(
        "sigma_max", "Pa", "largest principal stress where failure is checked",
        [](auto& row) -> auto& { return row.sigma_max; });
    visit(
        "l_break", "m", "breaking length", [](auto& row) -> auto& { return row.breaking_length; });
    visit(
        "wedges", "1", "number of wedges drawn", [](auto& row) -> auto& { return row.wedges; });
    visit(
        "in_range", "1", "1 when the failure model's inputs were in its range",
        [](auto& row) -> auto& { return row.in_range; });
    visit(
        "substeps", "1", "parts of the time step", [](auto& row) -> auto& { return row.substeps; });
    visit(
        "area_before", "m2", "area of the sheet before the break", [](auto& row) -> auto& { return row.area_before; });
    visit(
        "area_after", "m2", "area of the sheet after the break", [](auto& row) -> auto& { return row.area_after; });
    visit(
        "fit_error", "1", "error of the fitted trapezoid", [](auto& row) -> auto& { return row.fit_error; });
    visit(
        "pieces", "1", "number of pieces cut free", [](auto& row) -> auto& { return row.pieces; });
    visit(
        "tip_x", "m", "middle of the trapezoid's tip edge, x", [](auto& row) -> auto& { return row.tip.x; });
    visit(
        "tip_y", "m", "middle of the trapezoid's tip edge, y", [](auto& row) -> auto& { return row.tip.y; });
    visit(
        "towards_x", "1", "unit vector of the trapezoid's axis into the ice, x",
        [](auto& row) -> auto& { return row.towards.x; });
    visit(
        "towards_y", "1", "unit vector of the trapezoid's axis into the ice, y",
        [](auto& row) -> auto& { return row.towards.y; });
    visit(
        "pressing_floe", "1", "floe_id of the floe that broke the sheet; -1: the structure itself",
        [](auto& row) -> auto& { return row.pressing_floe; });
    visit(
        "t_break", "s", "time since the structure touched the edge; 0 where the edge does not move",
        [](auto& row) -> auto& { return row.edge_age; });
    visit(
        "w_edge", "m", "deflection of the edge as it is pushed; 0 where it does not move",
        [](auto& row) -> auto& { return row.edge_deflection; });
    visit(
        "thickness", "m", "thickness of the sheet at the contact", [](auto& row) -> auto& { return row.thickness; });
    visit(
        "flexural_strength", "Pa", "flexural strength of the sheet at the contact",
        [](auto& row) -> auto& { return row.flexural_strength; });
    visit(
        "overload", "1", "loads over those at which the ice just fails; 0: not known",
        [](auto& row) -> auto& { return row.overload; });
  }
};

template <>
struct Columns<model::SheetSplit> {
  static constexpr const char* dimension = "split";
  static constexpr const char* prefix = "split_";

  template <typename Visit>
  static void visit(Visit&& visit) {
    visit(
        "time", "s", "time at which a drifting sheet split", [](auto& row) -> auto& { return row.time; });
    visit(
        "x", "m", "beginning of the crack on the edge, x", [](auto& row) -> auto& { return row.at.x; });
    visit(
        "y", "m", "beginning of the crack on the edge, y", [](auto& row) -> auto& { return row.at.y; });
    visit(
        "towards_x", "1", "unit vector along the crack, x", [](auto& row) -> auto& { return row.towards.x; });
    visit(
        "towards_y", "1", "unit vector along the crack, y", [](auto& row) -> auto& { return row.towards.y; });
    visit(
        "length", "m", "length of the ice ahead along the crack", [](auto& row) -> auto& { return row.length; });
    visit(
        "breadth", "m", "twice the narrower side of the crack", [](auto& row) -> auto& { return row.breadth; });
    visit(
        "opening", "N", "pair of forces across the crack", [](auto& row) -> auto& { return row.opening; });
    visit(
        "push", "N", "force along the crack", [](auto& row) -> auto& { return row.push; });
    visit(
        "stress_intensity", "Pa m^0.5", "least stress intensity along the crack's path",
        [](auto& row) -> auto& { return row.stress_intensity; });
    visit(
        "thickness", "m", "thickness of the sheet", [](auto& row) -> auto& { return row.thickness; });
    visit(
        "area_before", "m2", "area of all sheets before", [](auto& row) -> auto& { return row.area_before; });
    visit(
        "area_after", "m2", "area of all sheets after", [](auto& row) -> auto& { return row.area_after; });
    visit(
        "pieces", "1", "parts of the sheet", [](auto& row) -> auto& { return row.pieces; });
  }
};

/// The seven numbers of a pose: place of the centre of mass, and unit quaternion from body to world.
template <typename Visit, typename PoseOf>
void visit_pose(const std::string& of, Visit&& visit, PoseOf pose) {
  visit(
      of + "x", "m", "place, x", [pose](auto& row) -> auto& { return pose(row).position.x; });
  visit(
      of + "y", "m", "place, y", [pose](auto& row) -> auto& { return pose(row).position.y; });
  visit(
      of + "z", "m", "place, z", [pose](auto& row) -> auto& { return pose(row).position.z; });
  visit(
      of + "qw", "1", "attitude, w of the quaternion", [pose](auto& row) -> auto& { return pose(row).rotation.w; });
  visit(
      of + "qx", "1", "attitude, x of the quaternion", [pose](auto& row) -> auto& { return pose(row).rotation.x; });
  visit(
      of + "qy", "1", "attitude, y of the quaternion", [pose](auto& row) -> auto& { return pose(row).rotation.y; });
  visit(
      of + "qz", "1", "attitude, z of the quaternion", [pose](auto& row) -> auto& { return pose(row).rotation.z; });
}

template <>
struct Columns<model::FloeRecord> {
  static constexpr const char* dimension = "floe";
  static constexpr const char* prefix = "floe_";

  template <typename Visit>
  static void visit(Visit&& visit) {
    visit(
        "id", "1", "name of the floe", [](auto& row) -> auto& { return row.id; });
    visit(
        "area", "m2", "area of the floe's plan", [](auto& row) -> auto& { return row.area; });
    visit(
        "birth", "s", "time of birth", [](auto& row) -> auto& { return row.birth; });
    visit(
        "death", "s", "time of death, or the end of the run", [](auto& row) -> auto& { return row.death; });
    visit(
        "end", "1", "how the floe ended", [](auto& row) -> auto& { return row.end; });
    visit(
        "peak_stress", "Pa", "largest contact stress of the deletion criterion",
        [](auto& row) -> auto& { return row.peak_stress; });
    visit_pose(
        "birth_", visit, [](auto& row) -> auto& { return row.birth_pose; });
    visit(
        "parent", "1", "floe_id of the floe that it is a piece of; -1: of level ice",
        [](auto& row) -> auto& { return row.parent; });
    visit(
        "thickness", "m", "thickness of the floe", [](auto& row) -> auto& { return row.thickness; });
  }
};

template <>
struct Columns<model::CrackedSheet> {
  static constexpr const char* dimension = "cracked_sheet";
  static constexpr const char* prefix = "cracked_sheet_";

  template <typename Visit>
  static void visit(Visit&& visit) {
    visit(
        "time", "s", "time of the cracks", [](auto& row) -> auto& { return row.time; });
  }
};

template <>
struct Columns<model::Frame> {
  static constexpr const char* dimension = "frame";
  static constexpr const char* prefix = "frame_";

  template <typename Visit>
  static void visit(Visit&& visit) {
    visit(
        "time", "s", "time of the frame", [](auto& row) -> auto& { return row.time; });
    visit_pose(
        "structure_", visit, [](auto& row) -> auto& { return row.structure; });
  }
};

template <>
struct Columns<model::FloePose> {
  static constexpr const char* dimension = "pose";
  static constexpr const char* prefix = "pose_";

  template <typename Visit>
  static void visit(Visit&& visit) {
    visit(
        "floe", "1", "floe_id of the floe", [](auto& row) -> auto& { return row.floe; });
    visit_pose(
        "", visit, [](auto& row) -> auto& { return row.pose; });
    visit(
        "contact_force", "N", "sum of the magnitudes of the normal forces on the floe in the step before",
        [](auto& row) -> auto& { return row.contact_force; });
  }
};

}  // namespace brash::io
