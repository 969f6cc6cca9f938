// SPDX-License-Identifier: GPL-3.0-or-later
// Results come from others too: values that cannot have come from a run are refused before anyone works with them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <type_traits>

#include "brash/core/error.hpp"
#include "brash/io/result_columns.hpp"
#include "brash/io/results.hpp"
#include "brash/io/series.hpp"
#include "result_tables.hpp"

namespace brash::io {
namespace {

/// The range of the polygons' grid [m], and beyond it of floes that drift away.
constexpr double kFarthestNode = 8192.0;
constexpr double kFarthestFloe = 1e5;
constexpr int kMostWedges = 1000;

class Check {
 public:
  explicit Check(const NetcdfReader& file) : file_(file) {}

  /// Everything but loads and frames.
  void results(const model::RunResults& r) {
    rows("event", r.events);
    rows("split", r.splits);
    rows("floe", r.floes);
    for (const model::CrackEvent& event : r.events) {
      const bool cuts = event.breaking_length > 0.0 && event.breaking_length <= kFarthestNode && event.wedges >= 1 &&
                        event.wedges <= kMostWedges && is_near(event.at.x, kFarthestNode) &&
                        is_near(event.at.y, kFarthestNode);
      if (!cuts) file_.refuse(fmt::format("the crack at t = {} s has no place, radius or wedges", event.time));
    }
    for (const model::FloeRecord& floe : r.floes) {
      if (!floes_.insert(floe.id).second) file_.refuse(fmt::format("floe {} is there twice", floe.id));
      rings(fmt::format("floe {}", floe.id), floe.rings);
      pose(fmt::format("floe {}", floe.id), floe.birth_pose);
    }
    for (const model::CrackedSheet& sheet : r.cracked_sheets) rings("cracked_sheet", sheet.rings);
    rings("initial_sheet", r.initial_sheet);
    rings("final_sheet", r.final_sheet);
  }

  /// The next rows of the loads.
  void loads(const std::vector<model::LoadRow>& next) {
    rows("load", next, n_loads_);
    n_loads_ += next.size();
  }

  /// The next frame.
  void frame(const model::Frame& frame) {
    constexpr double kMostForce = 1e10;  // [N], far above the largest crushing force
    const std::string name = fmt::format("frame {}", n_frames_++);
    if (!std::isfinite(frame.time)) file_.refuse(name + " has no time");
    pose("the structure in " + name, frame.structure);
    for (const model::FloePose& floe : frame.floes) {
      const auto of = [&] { return fmt::format("floe {} in {}", floe.floe, name); };
      if (!floes_.contains(floe.floe)) file_.refuse(of() + " is not in the list of floes");
      if (!is_pose(floe.pose)) pose(of(), floe.pose);
      if (!is_near(floe.contact_force, kMostForce)) file_.refuse(of() + " has no contact force");
    }
  }

 private:
  static bool is_near(double value, double most) { return std::abs(value) <= most; }  // false for not a number

  template <typename Row>
  void rows(const char* of, const std::vector<Row>& rows, std::size_t first = 0) const {
    Columns<Row>::visit([&](const std::string& name, const char*, const std::string&, auto member) {
      for (std::size_t i = 0; i < rows.size(); ++i)
        if (!std::isfinite(static_cast<double>(member(rows[i]))))
          file_.refuse(fmt::format("{}{} of {} {} is not finite", Columns<Row>::prefix, name, of, first + i));
    });
  }

  void rings(const std::string& of, const std::vector<std::vector<Vec2>>& rings) const {
    for (const std::vector<Vec2>& ring : rings) {
      if (ring.size() < 3) file_.refuse(of + " has a ring of fewer than 3 nodes");
      for (const Vec2 node : ring)
        if (!is_near(node.x, kFarthestNode) || !is_near(node.y, kFarthestNode))
          file_.refuse(fmt::format("{} has a node at ({}, {}), beyond +-{} m", of, node.x, node.y, kFarthestNode));
    }
  }

  static bool is_pose(const Pose& pose) {
    const auto& [at, q] = pose;
    const bool is_there = is_near(at.x, kFarthestFloe) && is_near(at.y, kFarthestFloe) && is_near(at.z, kFarthestFloe);
    const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    // Attitudes are kept normalised far better than this tolerance, which refuses quaternions that are no rotation.
    return is_there && is_near(size - 1.0, 1e-3);
  }

  void pose(const std::string& of, const Pose& pose) const {
    if (!is_pose(pose)) file_.refuse(of + " has no place or no attitude");
  }

  const NetcdfReader& file_;
  std::set<std::int64_t> floes_{};
  std::size_t n_loads_ = 0, n_frames_ = 0;
};

/// The rows of a history.csv.
std::vector<model::LoadRow> rows_of_history(const std::string& path) {
  using LoadColumns = Columns<model::LoadRow>;
  const Series series = read_series(path);
  std::vector<model::LoadRow> rows(series.rows.size());
  LoadColumns::visit([&](const std::string& name, const char*, const std::string&, auto member) {
    const auto found = std::ranges::find(series.names, name);
    if (found == series.names.end()) {
      if (LoadColumns::is_optional(name)) return;
      throw InputError(Complaint{path, fmt::format("has no column '{}'", name), "the history.csv of a run",
                                 "give the folder of a run, or the history.csv that it wrote"});
    }
    const std::vector<double>& values = series.columns[static_cast<std::size_t>(found - series.names.begin())];
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (!std::isfinite(values[row]))
        throw InputError(Complaint{series.place(row), fmt::format("column '{}' has no value", name),
                                   "the history.csv of a run, which has each value", "run the case again"});
      auto& value = member(rows[row]);
      value = static_cast<std::remove_reference_t<decltype(value)>>(values[row]);
    }
  });
  return rows;
}

}  // namespace

std::vector<model::LoadRow> read_loads(const std::string& path) {
  return path.ends_with(".nc") ? read_results(path).loads : rows_of_history(path);
}

std::string read_case_of(const std::string& path) { return NetcdfReader(path).attribute("case"); }

model::RunResults read_results(const std::string& path) {
  std::vector<model::LoadRow> loads;
  std::vector<model::Frame> frames;
  model::RunResults results = read_results(path, all_of(loads, frames));
  results.loads = std::move(loads);
  results.frames = std::move(frames);
  return results;
}

model::RunResults read_results(const std::string& path, const ResultPieces& pieces) {
  const NetcdfReader file(path);
  file.length("time");  // a file of something else, or with an absurd size, is refused at once
  Check check(file);
  const ResultPieces checked{.loads =
                                 [&](std::vector<model::LoadRow>&& rows, std::size_t n) {
                                   check.loads(rows);
                                   pieces.loads(std::move(rows), n);
                                 },
                             .frame =
                                 [&](model::Frame&& frame) {
                                   check.frame(frame);
                                   pieces.frame(std::move(frame));
                                 }};
  return read_tables(file, checked, [&](const model::RunResults& others) { check.results(others); });
}

}  // namespace brash::io
