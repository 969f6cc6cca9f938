// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <map>
#include <string>
#include <vector>

#include "brash/model/records.hpp"

namespace brash::python {

/// A floe at one time: its record and where it is.
struct FloeState {
  model::FloeRecord record;
  Pose pose;
};

/// One frame with the records of the floes in it.
struct FrameView {
  double time = 0.0;
  Pose structure;
  std::vector<FloeState> floes;
};

/// Looks the poses of `frame` up in the records.
FrameView view_of(const model::Frame& frame, const std::map<std::int64_t, model::FloeRecord>& records);

std::map<std::int64_t, model::FloeRecord> by_id(const std::vector<model::FloeRecord>& floes);

}  // namespace brash::python
