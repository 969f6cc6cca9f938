// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/report/live.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "brash/io/result_columns.hpp"

namespace brash::report {
namespace {

using nlohmann::ordered_json;
using Rings = std::vector<std::vector<Vec2>>;

/// Millimetres; attitudes in the same unit are half of that at 5 m.
constexpr double kPerUnit = 1e4;

std::int64_t rounded(double value) { return std::llround(kPerUnit * value); }

/// The columns of rows under the names of a report's blocks.
template <typename Row>
ordered_json columns(const std::vector<Row>& rows) {
  ordered_json out = ordered_json::object();
  io::Columns<Row>::visit([&](const std::string& name, const char*, const std::string&, auto member) {
    ordered_json& column = out[name] = ordered_json::array();
    for (const Row& row : rows) column.push_back(static_cast<double>(member(row)));
  });
  return out;
}

/// Rings as x, y, x, y, ... [0.1 mm].
ordered_json rings_json(const Rings& rings) {
  ordered_json out = ordered_json::array();
  for (const std::vector<Vec2>& ring : rings) {
    ordered_json& flat = out.emplace_back(ordered_json::array());
    for (const Vec2 node : ring) {
      flat.push_back(rounded(node.x));
      flat.push_back(rounded(node.y));
    }
  }
  return out;
}

/// A floe, its place and attitude [0.1 mm], its contact force [N].
ordered_json pose_json(const model::FloePose& at) {
  const auto& [p, q] = at.pose;
  return {at.floe,      rounded(p.x), rounded(p.y),
          rounded(p.z), rounded(q.w), rounded(q.x),
          rounded(q.y), rounded(q.z), std::llround(at.contact_force)};
}

ordered_json poses_json(const std::vector<model::Frame>& frames) {
  ordered_json out = ordered_json::array();
  for (const model::Frame& frame : frames) {
    ordered_json& poses = out.emplace_back(ordered_json::array());
    for (const model::FloePose& floe : frame.floes) poses.push_back(pose_json(floe));
  }
  return out;
}

ordered_json sheets_json(const model::RunResults& part) {
  ordered_json out = ordered_json::array();
  if (!part.initial_sheet.empty()) out.push_back({{"time", 0.0}, {"rings", rings_json(part.initial_sheet)}});
  for (const model::CrackedSheet& sheet : part.cracked_sheets)
    out.push_back({{"time", sheet.time}, {"rings", rings_json(sheet.rings)}});
  return out;
}

}  // namespace

std::string live_records(const model::RunResults& part, const std::vector<EndedFloe>& ended) {
  ordered_json outlines = ordered_json::array(), ends = ordered_json::array();
  for (const model::FloeRecord& floe : part.floes) outlines.push_back(rings_json(floe.rings));
  for (const EndedFloe& each : ended) ends.push_back({each.floe, each.time, static_cast<int>(each.end)});
  return ordered_json{
      {"load", columns(part.loads)},      {"event", columns(part.events)}, {"floe", columns(part.floes)},
      {"frame", columns(part.frames)},    {"outlines", outlines},          {"ended", ends},
      {"poses", poses_json(part.frames)}, {"sheets", sheets_json(part)}}
      .dump();
}

}  // namespace brash::report
