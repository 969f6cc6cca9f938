// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "brash/geometry/polygon.hpp"

namespace brash::benchmarks {

/// Loops of a result [m]: outlines counter-clockwise, holes clockwise.
using Loops = std::vector<std::vector<Vec2>>;

/// Thrown where a library's own check of its input says no.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// `ice` without `region` as a library makes it; throws where the library fails.
using Difference = std::function<Loops(const std::vector<geometry::Polygon>& ice, const geometry::Ring& region)>;

struct Peer {
  std::string name;
  Difference difference;
};

/// The peers that are built in, each added by its own file.
std::vector<Peer>& peers();

struct Registration {
  Registration(const char* name, Difference difference) { peers().push_back({name, std::move(difference)}); }
};

/// Area of `ice` without `region` [m2]: exact, by CGAL, then rounded once.
double exact_area(const std::vector<geometry::Polygon>& ice, const geometry::Ring& region);
/// Area of the loops, exact likewise.
double exact_area(const Loops& loops);
/// True when no loop crosses or touches itself; exact.
bool are_simple(const Loops& loops);

}  // namespace brash::benchmarks
