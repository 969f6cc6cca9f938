// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/io/case.hpp"
#include "resolve.hpp"
#include "toml_source.hpp"

namespace brash::io {

/// The problems of values that are each allowed but do not go together.
std::vector<Problem> cross_check(const model::Case& resolved, const CaseSource& source, FieldFiles files);

}  // namespace brash::io
