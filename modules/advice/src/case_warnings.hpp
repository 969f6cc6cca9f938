// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/model/case.hpp"
#include "brash/model/warning.hpp"
#include "brash/simulation/setup.hpp"

namespace brash::advice {

using simulation::Setup;
using Warnings = std::vector<model::Warning>;

/// The body of a structure afloat; null for any other.
const model::FloatingBody* afloat(const model::Motion& motion);

/// Whether the source of a reference, in the user's words, is a test in a basin.
bool names_a_basin(std::string source);

/// Properties outside the measured ranges of ice, with the unit that was probably meant, of the floes of a file too;
/// strengths that may be swapped, ice that hardly floats, and a current faster than any among ice.
void add_ice_warnings(const model::Case& resolved, Warnings& warnings);

/// Files of openings, cracks and land that lie off the ice.
void add_idle_file_warnings(const Setup& setup, Warnings& warnings);
void add_left_out_warnings(const model::Case& resolved, Warnings& warnings);

/// A field of more floes than have been run.
void add_floe_number_warning(const model::Case& resolved, Warnings& warnings);

/// Ice that varies within a length over which the failure model takes it for even.
void add_variation_warnings(const Setup& setup, Warnings& warnings);

/// A structure that does not reach the ice, leaves it, or passes near its borders, which are fixed and rigid.
void add_field_warnings(const Setup& setup, Warnings& warnings);

/// A duration or a step that does not suit the case.
void add_time_warnings(const Setup& setup, Warnings& warnings);

/// Inputs far outside the range of the failure model, and ice of another Poisson's ratio.
void add_model_warnings(const Setup& setup, Warnings& warnings);

/// A vertical front, a motion that its steps, its spring or its path do not suit, and a structure afloat that is
/// lopsided, turns over or is not in balance.
void add_structure_warnings(const Setup& setup, Warnings& warnings);

/// Keys that differ from their defaults and do nothing, because another key was left out.
void add_idle_keys_warning(const model::Case& resolved, Warnings& warnings);

}  // namespace brash::advice
