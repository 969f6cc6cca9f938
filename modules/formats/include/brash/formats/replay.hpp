// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"
#include "brash/model/case.hpp"
#include "brash/model/records.hpp"
#include "brash/structure/hull.hpp"

namespace brash::formats {

/// A run as other programs draw it.
struct Replay {
  model::Case resolved;
  model::RunResults results;
  std::unique_ptr<const structure::Hull> hull;
};

/// Reads a run from its run.nc. Neither the failure model nor the files of the ice need be there.
/// @throws InputError when the file is not a run, or has polygons that cannot be drawn.
Replay read_replay(const std::string& run_file);

/// The sheets at the frames of a run, which stores them after each step with cracks: since then the structure's section
/// in the waterplane has been crushed. Each is cut on its own, for sheets that drift may overlap. Between frames the
/// path of the structure is not followed, so the channel's walls differ from the run's by less than it moves in a
/// frame.
class SheetReplay {
 public:
  explicit SheetReplay(const Replay& replay);

  /// The sheets at `frame`; frames in the order of time.
  std::vector<geometry::Polygon> at(const model::Frame& frame);

  /// Whether cracks changed the sheet between the last frame and the one before.
  bool has_cracked() const { return has_cracked_; }

 private:
  void take(std::span<const std::vector<Vec2>> rings);

  const Replay& replay_;
  std::vector<geometry::IceSheet> sheets_;
  std::size_t next_ = 0;  ///< of the cracked sheets
  bool has_cracked_ = false;
};

/// The thickness of a floe [m]; of files that do not have it, the level ice's.
double thickness_of(const model::FloeRecord& floe, const model::Case& resolved);

/// Polygons of rings [m] with the ice on their left, each outline followed by its holes.
std::vector<geometry::Polygon> polygons_of(std::span<const std::vector<Vec2>> rings);

}  // namespace brash::formats
