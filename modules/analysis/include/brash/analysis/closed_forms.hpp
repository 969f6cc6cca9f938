// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "brash/model/case.hpp"
#include "brash/standards/croasdale.hpp"
#include "brash/standards/lindqvist.hpp"
#include "brash/standards/ralston.hpp"

namespace brash::analysis {

/// Croasdale's elastic beam for the structure and ice of `resolved`, without rubble on the slope.
tl::expected<standards::CroasdaleLoad, standards::NotApplicable> croasdale_of(const model::Case& resolved);

/// Ralston's plastic plate for the structure and ice of `resolved`; one layer of ice rides along the whole cone.
tl::expected<standards::RalstonLoad, standards::NotApplicable> ralston_of(const model::Case& resolved,
                                                                          standards::Yield yield);

/// Lindqvist's resistance of the hull of `resolved` at the structure's speed; nothing when the case has no hull.
std::optional<tl::expected<standards::LindqvistLoad, standards::NotApplicable>> lindqvist_of(
    const model::Case& resolved);

/// Closed-form loads that fit a case's structure, with components, inputs (SI) and source: a ship's resistance
/// (Lindqvist, Riska, Jeong); on a slope Croasdale, Ralston (cones), Nevel and crushing; on a wall crushing.
nlohmann::ordered_json closed_form_loads(const model::Case& resolved);

/// The same as text for a reader.
std::string loads_text(const nlohmann::ordered_json& loads);

/// The slope of the structure's surface at the waterline, ahead of it, from the horizontal [rad].
double waterline_slope(const model::Case& resolved);

}  // namespace brash::analysis
