// SPDX-License-Identifier: GPL-3.0-or-later
// Names, order and meaning of the lines: OpenFAST's documentation of ServoDyn's structural control.
#include "brash/formats/openfast.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <utility>

namespace brash::formats {
namespace {

/// A line of an input file, its meaning after the name.
std::string line(const std::string& value, const char* name, const char* meaning) {
  return fmt::format("{:>12}  {:<24} - {}\n", value, name, meaning);
}

std::string heading(const char* text) {
  return fmt::format("---------------------- {} ----------------------\n", text);
}

/// Lines of devices that a prescribed load does not use.
std::string unused(std::span<const char* const> names, const char* value = "0") {
  std::string text;
  for (const char* const name : names) text += line(value, name, "not used");
  return text;
}

constexpr std::array kStart{"StC_X_DSP", "StC_Y_DSP", "StC_Z_DSP"};
constexpr std::array kStops{"StC_X_PSP", "StC_X_NSP", "StC_Y_PSP", "StC_Y_NSP", "StC_Z_PSP", "StC_Z_NSP"};
constexpr std::array kMasses{"StC_X_M", "StC_Y_M", "StC_Z_M"};
constexpr std::array kDevice{"StC_X_K",  "StC_Y_K",  "StC_Z_K",  "StC_X_C",  "StC_Y_C",  "StC_Z_C",
                             "StC_X_KS", "StC_Y_KS", "StC_Z_KS", "StC_X_CS", "StC_Y_CS", "StC_Z_CS"};
constexpr std::array kDamping{"StC_X_C_HIGH", "StC_X_C_LOW",   "StC_Y_C_HIGH",  "StC_Y_C_LOW",  "StC_Z_C_HIGH",
                              "StC_Z_C_LOW",  "StC_X_C_BRAKE", "StC_Y_C_BRAKE", "StC_Z_C_BRAKE"};
constexpr std::array kColumns{"L_X", "B_X", "area_X", "area_ratio_X", "headLossCoeff_X", "rho_X",
                              "L_Y", "B_Y", "area_Y", "area_ratio_Y", "headLossCoeff_Y", "rho_Y"};

/// Names and numbers that differ between the versions.
struct Dialect {
  const char* prescribed;  ///< the mode of a prescribed force
  const char* joint_mass;  ///< the name of the mass that several axes share
};
Dialect dialect_of(int version) { return version < 5 ? Dialect{"4", "StC_XY_M"} : Dialect{"6", "StC_Omni_M"}; }

/// A vector in load axes, which turn with the structure's heading, in OpenFAST's axes, which do not.
Vec3 without_heading(Vec3 v, double heading) {
  const double c = std::cos(heading), s = std::sin(heading);
  return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

std::string force_row(double time, Vec3 f, Vec3 m) {
  return fmt::format("{:.6f} {:.8e} {:.8e} {:.8e} {:.8e} {:.8e} {:.8e}\n", time, f.x, f.y, f.z, m.x, m.y, m.z);
}

}  // namespace

JoinedLoads joined(const std::vector<std::vector<model::LoadRow>>& replicates, double duration) {
  JoinedLoads all;
  double next = 0.0;
  for (const std::vector<model::LoadRow>& rows : replicates) {
    if (next >= duration) break;
    if (!all.loads.empty()) all.joints.push_back(next);
    ++all.n_used;
    const double begin = next - rows.front().time, step = rows[1].time - rows[0].time;
    for (model::LoadRow row : rows) {
      row.time += begin;
      if (row.time > duration + 1e-3 * step) return all;
      next = row.time + step;
      all.loads.push_back(row);
    }
  }
  return all;
}

std::string to_openfast_forces(std::span<const model::LoadRow> loads, const OpenFastOptions& options) {
  std::string text = "# Ice load of a brash run on its structure, for OpenFAST's structural control\n";
  text += "# X points as the ice drifts, Z upwards; moments about the point of application\n";
  text += fmt::format("# point from the structure's origin in the waterplane: {} {} {} m\n", options.point.x,
                      options.point.y, options.point.z);
  if (!options.joints.empty())
    text += fmt::format("# {} replicates of one state of the ice: the load jumps from one to the next at {:.9g} s\n",
                        options.joints.size() + 1, fmt::join(options.joints, ", "));
  text += "# time FX FY FZ MX MY MZ\n# (s) (N) (N) (N) (N-m) (N-m) (N-m)\n";
  double time = 0.0, step = 0.0;
  for (const model::LoadRow& row : loads) {
    const double next = row.time - options.from;
    if (next < 0.0) continue;
    step = next - std::exchange(time, next);
    const double share = time < options.ramp ? time / options.ramp : 1.0;
    const Vec3 f = share * without_heading(row.total.force, row.attitude.z);
    const Vec3 m = share * without_heading(row.total.moment, row.attitude.z) - cross(options.point, f);
    text += force_row(time, f, m);
  }
  return text + force_row(time + step, {}, {});
}

std::string to_openfast_structural_control(const std::string& forces_file, const OpenFastOptions& options) {
  const Dialect dialect = dialect_of(options.version);
  std::string text = "------- STRUCTURAL CONTROL (StC) INPUT FILE ----------------------------\n";
  text += "Ice load of a brash run, as a prescribed force and moment at one point\n";
  text += heading("SIMULATION CONTROL") + line("False", "Echo", "copy of this input in the output");
  text += heading("StC DEGREES OF FREEDOM");
  text += line(dialect.prescribed, "StC_DOF_MODE", "prescribed force and moment over time");
  text += unused(std::array{"StC_X_DOF", "StC_Y_DOF", "StC_Z_DOF"}, "False");
  text += heading("StC LOCATION");
  text += line(fmt::format("{}", options.point.x), "StC_P_X", "from the reference point of the component (m)");
  text += line(fmt::format("{}", options.point.y), "StC_P_Y", "the same for y (m)");
  const std::string level =
      fmt::format("the same for z (m); the still water of the ice run is at {}", -options.reference + 0.0);
  text += line(fmt::format("{}", options.point.z - options.reference), "StC_P_Z", level.c_str());
  text += heading("StC INITIAL CONDITIONS") + unused(kStart) + line("\"none\"", "StC_Z_PreLd", "not used");
  text += heading("StC CONFIGURATION") + unused(kStops);
  text += heading("StC MASS, STIFFNESS, & DAMPING") + unused(kMasses) + unused(std::array{dialect.joint_mass});
  text += unused(kDevice);
  text += heading("StC USER-DEFINED SPRING FORCES") + line("False", "Use_F_TBL", "not used");
  text += line("2", "NKInpSt", "rows of the table below");
  text += heading("StC SPRING FORCES TABLE");
  text += " X F_X Y F_Y Z F_Z\n (m) (N) (m) (N) (m) (N)\n -1 0 -1 0 -1 0\n 1 0 1 0 1 0\n";
  text += heading("StructCtrl CONTROL") + line("0", "StC_CMODE", "no control") + line("0", "StC_CChan", "not used");
  text += line("1", "StC_SA_MODE", "not used") + unused(kDamping);
  text += heading("TLCD") + unused(kColumns);
  text += heading("PRESCRIBED TIME SERIES");
  text += line("1", "PrescribedForcesCoordSys", "1: global coordinates");
  text += fmt::format("\"{}\"  PrescribedForcesFile  - time, FX, FY, FZ, MX, MY, MZ\n", forces_file);
  return text + "-------------------------------------------------------------------------------\n";
}

}  // namespace brash::formats
