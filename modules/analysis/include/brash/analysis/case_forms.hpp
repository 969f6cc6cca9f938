// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms for the numbers of a case, beside the forms in closed_forms.hpp.
#pragma once

#include <optional>
#include <tl/expected.hpp>

#include "brash/model/case.hpp"
#include "brash/standards/crushing.hpp"
#include "brash/standards/jeong.hpp"
#include "brash/standards/nevel.hpp"
#include "brash/standards/ridge.hpp"
#include "brash/standards/riska.hpp"

namespace brash::analysis {

/// Nevel's force on one of `wedges` wedges of a half disc of the ice of `resolved`, loaded over one thickness.
/// @returns NotApplicable for fewer than two wedges.
tl::expected<standards::NevelLoad, standards::NotApplicable> nevel_of(const model::Case& resolved, int wedges);

/// Crushing of the ice of `resolved` over the width of its structure, as if the face were vertical.
/// @param strength_coefficient  C_R [Pa], > 0.
tl::expected<standards::CrushingLoad, standards::NotApplicable> crushing_of(const model::Case& resolved,
                                                                            double strength_coefficient);

/// Compressive strength of the ice of `resolved` over the full width of its structure and the thickness [N].
double full_crushing_of(const model::Case& resolved);

/// Width and densities of `resolved` for a ridge; the ridge's own numbers are 0.
/// @returns NotApplicable for a face that slopes at the waterline.
tl::expected<standards::RidgeInput, standards::NotApplicable> ridge_input_of(const model::Case& resolved);

// Resistance of the hull of `resolved` at the structure's speed; nothing when the case has no section [hull].
std::optional<tl::expected<standards::RiskaLoad, standards::NotApplicable>> riska_of(const model::Case& resolved);
std::optional<tl::expected<standards::JeongLoad, standards::NotApplicable>> jeong_of(const model::Case& resolved);

/// Breaking length of the ice of `resolved` at rest under an even load on a straight edge [m].
double breaking_length_of(const model::Case& resolved);

}  // namespace brash::analysis
