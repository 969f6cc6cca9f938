// SPDX-License-Identifier: GPL-3.0-or-later
#include "result_tables.hpp"

#include <fmt/format.h>

#include <type_traits>

#include "result_columns.hpp"

namespace brash::io {
namespace {

using Rings = std::vector<std::vector<Vec2>>;

/// How a member is stored: flags as bytes, numbers as they are.
template <typename T>
struct Stored {
  using Type = T;
};
template <>
struct Stored<bool> {
  using Type = std::int8_t;
};
template <>
struct Stored<FloeEnd> {
  using Type = std::int8_t;
};

void add_flags(Meaning& meaning, FloeEnd) {
  meaning.flag_values = {0, 1, 2};
  meaning.more = {{"flag_meanings", "alive crushed outside"}};
}
template <typename T>
void add_flags(Meaning&, T) {}

template <typename Row>
void write_rows(NetcdfWriter& file, const std::vector<Row>& rows) {
  Columns<Row>::visit([&](const std::string& name, const char* unit, const std::string& meaning, auto member) {
    using Member = std::remove_cvref_t<decltype(member(rows.front()))>;
    std::vector<typename Stored<Member>::Type> values;
    values.reserve(rows.size());
    for (const Row& row : rows) values.push_back(static_cast<typename Stored<Member>::Type>(member(row)));
    Meaning described{unit, meaning};
    add_flags(described, Member{});
    file.variable(Columns<Row>::prefix + name, Columns<Row>::dimension, described, values);
  });
}

template <typename Row>
std::vector<Row> read_rows(const NetcdfReader& file) {
  std::vector<Row> rows(file.length(Columns<Row>::dimension));
  Columns<Row>::visit([&](const std::string& name, const char*, const std::string&, auto member) {
    using Member = std::remove_cvref_t<decltype(member(rows.front()))>;
    std::vector<typename Stored<Member>::Type> values;
    file.read(Columns<Row>::prefix + name, Columns<Row>::dimension, values);
    if constexpr (std::is_same_v<Member, FloeEnd>)
      for (const std::int8_t value : values)
        if (value < 0 || value > 2) file.refuse(fmt::format("{}{} has an unknown value", Columns<Row>::prefix, name));
    for (std::size_t i = 0; i < rows.size(); ++i) member(rows[i]) = static_cast<Member>(values[i]);
  });
  return rows;
}

/// Rings one after another: how many nodes each has, and the nodes.
struct FlatRings {
  std::vector<std::int32_t> node_counts;
  std::vector<double> x;
  std::vector<double> y;

  void add(const std::vector<Vec2>& ring) {
    node_counts.push_back(static_cast<std::int32_t>(ring.size()));
    for (const Vec2& node : ring) {
      x.push_back(node.x);
      y.push_back(node.y);
    }
  }
};

void write_flat(NetcdfWriter& file, const std::string& name, const std::string& frame, const FlatRings& flat) {
  file.variable(name + "_part_node_count", name + "_part", {"1", "number of nodes of each ring"}, flat.node_counts);
  file.variable(name + "_x", name + "_node", {"m", "nodes of the rings, x, " + frame, {{"axis", "X"}}}, flat.x);
  file.variable(name + "_y", name + "_node", {"m", "nodes of the rings, y, " + frame, {{"axis", "Y"}}}, flat.y);
}

Rings read_flat(const NetcdfReader& file, const std::string& name) {
  FlatRings flat;
  file.read(name + "_part_node_count", name + "_part", flat.node_counts);
  file.read(name + "_x", name + "_node", flat.x);
  file.read(name + "_y", name + "_node", flat.y);
  Rings rings;
  std::size_t next = 0;
  for (const std::int32_t count : flat.node_counts) {
    if (count < 0 || static_cast<std::size_t>(count) > flat.x.size() - next)
      file.refuse(name + ": the counts do not add up");
    std::vector<Vec2>& ring = rings.emplace_back();
    for (const std::size_t end = next + static_cast<std::size_t>(count); next < end; ++next)
      ring.push_back({flat.x[next], flat.y[next]});
  }
  if (next != flat.x.size()) file.refuse(name + ": the counts do not add up");
  return rings;
}

/// Outlines of floes as polygons of the CF conventions (1.8, Sec. 7.5), holes as interior rings.
void write_outlines(NetcdfWriter& file, const std::vector<FloeRecord>& floes) {
  FlatRings flat;
  std::vector<std::int32_t> ring_counts;
  std::vector<std::int32_t> node_counts;
  std::vector<std::int32_t> interior;
  for (const FloeRecord& floe : floes) {
    const std::size_t nodes_before = flat.x.size();
    for (std::size_t i = 0; i < floe.rings.size(); ++i) {
      flat.add(floe.rings[i]);
      interior.push_back(i == 0 ? 0 : 1);
    }
    ring_counts.push_back(static_cast<std::int32_t>(floe.rings.size()));
    node_counts.push_back(static_cast<std::int32_t>(flat.x.size() - nodes_before));
  }
  file.container("floe_outline", {"",
                                  "outlines of the floes, in their body frames",
                                  {{"geometry_type", "polygon"},
                                   {"node_count", "floe_node_count"},
                                   {"part_node_count", "floe_outline_part_node_count"},
                                   {"interior_ring", "floe_interior_ring"},
                                   {"node_coordinates", "floe_outline_x floe_outline_y"}}});
  file.variable("floe_node_count", "floe", {"1", "number of nodes of each floe"}, node_counts);
  file.variable("floe_part_count", "floe", {"1", "number of rings of each floe"}, ring_counts);
  write_flat(file, "floe_outline", "body frame", flat);
  file.variable("floe_interior_ring", "floe_outline_part", {"1", "1 for a hole"}, interior);
}

void read_outlines(const NetcdfReader& file, std::vector<FloeRecord>& floes) {
  Rings rings = read_flat(file, "floe_outline");
  std::vector<std::int32_t> ring_counts;
  file.read("floe_part_count", "floe", ring_counts);
  std::size_t next = 0;
  for (std::size_t i = 0; i < floes.size(); ++i)
    for (std::int32_t j = 0; j < ring_counts[i]; ++j) {
      if (next == rings.size()) file.refuse("floe_part_count: the counts do not add up");
      floes[i].rings.push_back(std::move(rings[next++]));
    }
  if (next != rings.size()) file.refuse("floe_part_count: the counts do not add up");
}

/// Poses frame after frame: a contiguous ragged array of the CF conventions.
void write_frames(NetcdfWriter& file, const std::vector<Frame>& frames) {
  std::vector<std::int32_t> counts;
  std::vector<FloePose> poses;
  for (const Frame& frame : frames) {
    counts.push_back(static_cast<std::int32_t>(frame.floes.size()));
    poses.insert(poses.end(), frame.floes.begin(), frame.floes.end());
  }
  write_rows(file, frames);
  file.variable("frame_pose_count", "frame", {"1", "number of poses of each frame", {{"sample_dimension", "pose"}}},
                counts);
  write_rows(file, poses);
}

std::vector<Frame> read_frames(const NetcdfReader& file) {
  std::vector<Frame> frames = read_rows<Frame>(file);
  const std::vector<FloePose> poses = read_rows<FloePose>(file);
  std::vector<std::int32_t> counts;
  file.read("frame_pose_count", "frame", counts);
  auto next = poses.begin();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (counts[i] < 0 || counts[i] > poses.end() - next) file.refuse("frame_pose_count: the counts do not add up");
    frames[i].floes.assign(next, next + counts[i]);
    next += counts[i];
  }
  if (next != poses.end()) file.refuse("frame_pose_count: the counts do not add up");
  return frames;
}

void write_rings(NetcdfWriter& file, const std::string& name, const Rings& rings) {
  FlatRings flat;
  for (const std::vector<Vec2>& ring : rings) flat.add(ring);
  write_flat(file, name, "sheet frame", flat);
}

}  // namespace

void write_tables(NetcdfWriter& file, const RunResults& results) {
  write_rows(file, results.loads);
  write_rows(file, results.events);
  write_rows(file, results.floes);
  write_outlines(file, results.floes);
  write_frames(file, results.frames);
  write_rings(file, "initial_sheet", results.initial_sheet);
  write_rings(file, "final_sheet", results.final_sheet);
}

RunResults read_tables(const NetcdfReader& file) {
  RunResults results;
  results.loads = read_rows<LoadRow>(file);
  results.events = read_rows<CrackEvent>(file);
  results.floes = read_rows<FloeRecord>(file);
  read_outlines(file, results.floes);
  results.frames = read_frames(file);
  results.initial_sheet = read_flat(file, "initial_sheet");
  results.final_sheet = read_flat(file, "final_sheet");
  return results;
}

}  // namespace brash::io
