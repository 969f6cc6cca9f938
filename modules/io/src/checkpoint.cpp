// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/io/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/version.hpp"
#include "result_tables.hpp"
#include "tables.hpp"

namespace brash::io {

namespace {

template <typename VectorOf, typename Visit>
void visit_vector(const std::string& name, const char* unit, const std::string& meaning, VectorOf of, Visit&& visit) {
  visit(
      name + "x", unit, meaning + ", x", [of](auto& row) -> auto& { return of(row).x; });
  visit(
      name + "y", unit, meaning + ", y", [of](auto& row) -> auto& { return of(row).y; });
  visit(
      name + "z", unit, meaning + ", z", [of](auto& row) -> auto& { return of(row).z; });
}

}  // namespace

template <>
struct Columns<model::FloePush> {
  static constexpr const char* dimension = "push";
  static constexpr const char* prefix = "push_";

  template <typename Visit>
  static void visit(Visit&& visit) {
    visit(
        "floe", "1", "floe_id of the pushed floe", [](auto& row) -> auto& { return row.floe; });
    visit(
        "other", "1", "floe_id of the pushing floe", [](auto& row) -> auto& { return row.other; });
    visit_vector(
        "force_", "N", "mean force", [](auto& row) -> auto& { return row.force; }, visit);
  }
};

template <>
struct Columns<model::CheckpointFloe> {
  static constexpr const char* dimension = "present";
  static constexpr const char* prefix = "present_";

  template <typename Visit>
  static void visit(Visit&& visit) {
    visit(
        "id", "1", "floe_id of the floe", [](auto& row) -> auto& { return row.id; });
    visit(
        "thickness", "m", "thickness", [](auto& row) -> auto& { return row.thickness; });
    visit(
        "peak_stress", "Pa", "largest compression so far", [](auto& row) -> auto& { return row.peak_stress; });
    visit_pose(
        "", visit, [](auto& row) -> auto& { return row.pose; });
    visit_vector(
        "linear_", "m s-1", "velocity", [](auto& row) -> auto& { return row.twist.linear; }, visit);
    visit_vector(
        "angular_", "rad s-1", "angular velocity", [](auto& row) -> auto& { return row.twist.angular; }, visit);
    constexpr std::array<const char*, 6> kNames{"xx", "yy", "zz", "xy", "yz", "zx"};
    for (std::size_t i = 0; i < kNames.size(); ++i)
      visit(
          std::string("stress_") + kNames[i], "Pa", "mean stress", [i](auto& row) -> auto& { return row.stress[i]; });
    visit_bearing(visit);
    visit(
        "slow_for", "s", "time since it became slow", [](auto& row) -> auto& { return row.rest.slow_for; });
    visit(
        "settled", "1", "whether it is fixed where it is", [](auto& row) -> auto& { return row.rest.settled; });
    visit_vector(
        "push_", "N", "change of the mean force of other floes since it was settled",
        [](auto& row) -> auto& { return row.rest.push; }, visit);
    visit_drag(visit);
  }

 private:
  template <typename Visit>
  static void visit_bearing(Visit&& visit) {
    visit_vector(
        "bearing_force_", "N", "mean force on the sheet", [](auto& row) -> auto& { return row.bearing.force; }, visit);
    visit(
        "bearing_thrust_x", "N", "mean normal force on the sheet in plan, x",
        [](auto& row) -> auto& { return row.bearing.thrust.x; });
    visit(
        "bearing_thrust_y", "N", "mean normal force on the sheet in plan, y",
        [](auto& row) -> auto& { return row.bearing.thrust.y; });
    visit(
        "bearing_weight", "N", "sum of their sizes", [](auto& row) -> auto& { return row.bearing.weight; });
    visit(
        "bearing_first_x", "N m", "their first moment, x", [](auto& row) -> auto& { return row.bearing.first.x; });
    visit(
        "bearing_first_y", "N m", "their first moment, y", [](auto& row) -> auto& { return row.bearing.first.y; });
    constexpr std::array<const char*, 3> kNames{"xx", "xy", "yy"};
    for (std::size_t i = 0; i < kNames.size(); ++i)
      visit(
          std::string("bearing_second_") + kNames[i], "N m2",
          "their second moment", [i](auto& row) -> auto& { return row.bearing.second[i]; });
  }

  template <typename Visit>
  static void visit_drag(Visit&& visit) {
    visit(
        "drag_left", "m", "how far it may go on with its drag", [](auto& row) -> auto& { return row.kept_drag.left; });
    visit(
        "drag_sum", "kg s-1", "sum of its dampers", [](auto& row) -> auto& { return row.kept_drag.sum; });
    visit_vector(
        "drag_first_", "kg m s-1", "their first moment", [](auto& row) -> auto& { return row.kept_drag.first; }, visit);
    visit_vector(
        "drag_squares_", "kg m2 s-1", "their second moment xx, yy, zz",
        [](auto& row) -> auto& { return row.kept_drag.squares; }, visit);
    visit_vector(
        "drag_products_", "kg m2 s-1", "their second moment yz, zx, xy",
        [](auto& row) -> auto& { return row.kept_drag.products; }, visit);
    visit(
        "drag_rotation", "kg m2 s-1", "damper of its rotation",
        [](auto& row) -> auto& { return row.kept_drag.rotation; });
    visit_vector(
        "drag_skin_force_", "N", "skin friction, body frame",
        [](auto& row) -> auto& { return row.kept_drag.skin_force; }, visit);
    visit_vector(
        "drag_skin_moment_", "N m", "its moment", [](auto& row) -> auto& { return row.kept_drag.skin_moment; }, visit);
    visit(
        "drag_skin_power", "W", "its power", [](auto& row) -> auto& { return row.kept_drag.skin_power; });
    visit_vector(
        "drag_linear_", "m s-1", "velocity against the water at which its drag was taken, body frame",
        [](auto& row) -> auto& { return row.kept_drag.velocity.linear; }, visit);
    visit_vector(
        "drag_angular_", "rad s-1", "angular velocity at which its drag was taken, body frame",
        [](auto& row) -> auto& { return row.kept_drag.velocity.angular; }, visit);
  }
};

namespace {

using Json = nlohmann::json;

constexpr const char* kFormat = "brash-checkpoint-6";

/// The side of the grid, 2^-30 m, as a unit.
const NodeFrame kGrid{"9.313225746154785e-10 m", "sheet frame, exact"};

bool is_whole_number(const std::string& text) {
  const std::size_t first = text.starts_with('-') ? 1 : 0;
  return text.size() > first && text.find_first_not_of("0123456789", first) == std::string::npos;
}

std::vector<std::int64_t> body_numbers(const std::vector<model::CheckpointFloe>& floes, std::uint32_t BodyId::*part) {
  std::vector<std::int64_t> numbers;
  for (const model::CheckpointFloe& floe : floes) numbers.push_back(floe.body.*part);
  return numbers;
}

void read_body_numbers(const NetcdfReader& file, const std::string& name, std::vector<model::CheckpointFloe>& floes,
                       std::uint32_t BodyId::*part) {
  std::vector<std::int64_t> numbers;
  file.read(name, "present", numbers);
  for (std::size_t i = 0; i < floes.size(); ++i) floes[i].body.*part = static_cast<std::uint32_t>(numbers[i]);
}

/// A map kept as the JSON text of a global attribute.
template <typename Value>
std::map<std::string, Value> read_map(const NetcdfReader& file, const std::string& name) {
  try {
    return Json::parse(file.attribute(name)).get<std::map<std::string, Value>>();
  } catch (const Json::exception&) {
    file.refuse("the attribute " + name + " is no list of values");
  }
}

[[noreturn]] void refuse_file(const std::string& path, const std::string& what) {
  throw InputError(Complaint{path, what, "a checkpoint that this version of the program wrote",
                             "use an older checkpoint, or start the run again"});
}

/// The end of a checkpoint: the digest of all before it. HDF5 ignores what follows its own data, and does not survive
/// every damage to it.
constexpr const char* kSealMark = "brash-sha256:";

std::string seal_of(const std::string& bytes) { return kSealMark + sha256(bytes); }

/// The bytes of the sealed file `path`, without the seal.
std::string read_sealed(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse_file(path, "cannot be opened: " + std::generic_category().message(errno));
  // The end comes first: what has no seal there is not read into memory, however large it is.
  const std::size_t seal_size = seal_of("").size();
  std::string seal(seal_size, '\0');
  stream.seekg(-static_cast<std::streamoff>(seal_size), std::ios::end);
  const auto size = static_cast<std::size_t>(std::max(std::streamoff{0}, std::streamoff{stream.tellg()}));
  if (!stream.read(seal.data(), static_cast<std::streamsize>(seal_size)) || !seal.starts_with(kSealMark))
    refuse_file(path, "is no checkpoint, or was cut short");
  std::string bytes(size, '\0');
  stream.seekg(0);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size))) refuse_file(path, "cannot be read");
  if (seal != seal_of(bytes)) refuse_file(path, "is damaged: its bytes do not have the digest at its end");
  return bytes;
}

void check_values(const model::Checkpoint& checkpoint) {
  for (const auto& [name, value] : checkpoint.ledger) BRASH_EXPECTS(is_whole_number(value), name, value);
  for (const auto& [name, value] : checkpoint.numbers) BRASH_EXPECTS(std::isfinite(value), name, value);
}

}  // namespace

void write_checkpoint(const std::string& path, const model::Checkpoint& checkpoint) {
  check_values(checkpoint);
  NetcdfWriter file(path);
  file.attribute("format", kFormat);
  file.attribute("source", std::string("brash ") + kVersion);
  file.attribute("case_name", checkpoint.case_name);
  file.attribute("case", checkpoint.case_toml);
  file.attribute("ledger", Json(checkpoint.ledger).dump());
  file.attribute("counters", Json(checkpoint.counters).dump());
  file.attribute("numbers", Json(checkpoint.numbers).dump());
  write_polygons(file, "sheet", "sheet_polygon", kGrid, checkpoint.sheet);
  write_rows(file, checkpoint.floes);
  write_rows(file, checkpoint.pushes);
  file.variable("present_body_index", "present", {"1", "slot of the body"},
                body_numbers(checkpoint.floes, &BodyId::index));
  file.variable("present_body_generation", "present", {"1", "generation of the body"},
                body_numbers(checkpoint.floes, &BodyId::generation));
  std::vector<model::GridRings> outlines;
  for (const model::CheckpointFloe& floe : checkpoint.floes) outlines.push_back(floe.rings);
  write_polygons(file, "present_outline", "present", kGrid, outlines);
  write_tables(file, checkpoint.results);
  std::string bytes = file.finish();
  bytes += seal_of(bytes);
  write_file(path, bytes);
}

model::Checkpoint read_checkpoint(const std::string& path) {
  const NetcdfReader file(path, read_sealed(path));
  if (file.attribute("format") != kFormat) file.refuse("it is not a checkpoint of this version");
  model::Checkpoint checkpoint;
  checkpoint.case_name = file.attribute("case_name");
  checkpoint.case_toml = file.attribute("case");
  checkpoint.ledger = read_map<std::string>(file, "ledger");
  for (const auto& [name, value] : checkpoint.ledger)
    if (!is_whole_number(value)) file.refuse("ledger." + name + " is not a whole number");
  checkpoint.counters = read_map<std::int64_t>(file, "counters");
  checkpoint.numbers = read_map<double>(file, "numbers");
  checkpoint.sheet = read_polygons<model::GridPoint>(file, "sheet", "sheet_polygon");
  checkpoint.floes = read_rows<model::CheckpointFloe>(file);
  checkpoint.pushes = read_rows<model::FloePush>(file);
  read_body_numbers(file, "present_body_index", checkpoint.floes, &BodyId::index);
  read_body_numbers(file, "present_body_generation", checkpoint.floes, &BodyId::generation);
  std::vector<model::GridRings> outlines = read_polygons<model::GridPoint>(file, "present_outline", "present");
  for (std::size_t i = 0; i < outlines.size(); ++i) checkpoint.floes[i].rings = std::move(outlines[i]);
  checkpoint.results = read_tables(file);
  return checkpoint;
}

}  // namespace brash::io
