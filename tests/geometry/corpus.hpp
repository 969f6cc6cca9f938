// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"

// The named degenerate cuts of tests/corpus, see the README there.
namespace brash::corpus {

struct Event {
  geometry::Ring region;  ///< Empty: release the detached parts.
  std::vector<geometry::Crack> cracks;
};

struct Case {
  std::string name;
  std::vector<geometry::Polygon> ice;
  std::vector<Event> events;
  std::vector<std::size_t> pieces;  ///< Expected of each event; empty: not stated.
  int parts = -1;
  int holes = -1;
};

/// Numbers like `12.5+3u` in grid units.
inline std::vector<std::int64_t> numbers(std::istringstream& line) {
  std::vector<std::int64_t> values;
  for (std::string word; line >> word && word[0] != '#';) {
    const bool has_units = word.back() == 'u';
    const std::size_t sign = has_units ? word.find_last_of("+-") : std::string::npos;
    const std::string metres = !has_units ? word : sign == std::string::npos ? "" : word.substr(0, sign);
    const std::string units = !has_units ? "" : sign == std::string::npos ? word : word.substr(sign);
    std::int64_t value = metres.empty() ? 0 : geometry::snap({std::stod(metres), 0.0}).x;
    if (has_units) value += std::stoll(units);
    values.push_back(value);
  }
  return values;
}

inline geometry::Ring ring_from(const std::vector<std::int64_t>& values) {
  geometry::Ring ring;
  for (std::size_t i = 0; i + 1 < values.size(); i += 2) {
    ring.push_back(geometry::Point::of_units(values[i], values[i + 1]));
  }
  return ring;
}

/// A disc whose vertices include the ends of its cracks: the angles of a fan are led to its nearest vertices.
inline Event disc_event(const std::vector<std::int64_t>& v, std::istringstream& rest, bool is_fan) {
  const Vec2 centre = geometry::metres(geometry::Point::of_units(v[0], v[1]));
  const double radius = geometry::metres(geometry::Point::of_units(v[2], 0)).x;
  int sides = 0;
  rest >> sides;
  Event event;
  double degrees = 0.0;
  if (!is_fan) {
    rest >> degrees;
    event.region = geometry::disc(centre, radius, sides, degrees * M_PI / 180.0);
    return event;
  }
  event.region = geometry::disc(centre, radius, sides);
  while (rest >> degrees) {
    const Vec2 end = centre + radius * Vec2{std::cos(degrees * M_PI / 180.0), std::sin(degrees * M_PI / 180.0)};
    event.cracks.push_back({geometry::Point::of_units(v[0], v[1]), geometry::snap(end)});
  }
  return event;
}

inline std::vector<Case> read(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::vector<Case> cases;
  for (std::string text; std::getline(file, text);) {
    std::istringstream line(text);
    std::string word;
    if (!(line >> word) || word[0] == '#') continue;
    if (word == "case") {
      line >> cases.emplace_back().name;
      continue;
    }
    Case& now = cases.at(cases.size() - 1);
    if (word == "ice") {
      now.ice.push_back({ring_from(numbers(line)), {}});
    } else if (word == "hole") {
      now.ice.back().holes.push_back(ring_from(numbers(line)));
    } else if (word == "region") {
      now.events.push_back({ring_from(numbers(line)), {}});
    } else if (word == "crack") {
      const geometry::Ring ends = ring_from(numbers(line));
      now.events.back().cracks.push_back({ends.at(0), ends.at(1)});
    } else if (word == "disc" || word == "fan") {
      std::string x, y, r;
      line >> x >> y >> r;
      std::istringstream three(x + " " + y + " " + r);
      now.events.push_back(disc_event(numbers(three), line, word == "fan"));
    } else if (word == "release") {
      now.events.push_back({});
    } else if (word == "expect") {
      line >> word;
      for (int n; line >> n;) {
        if (word == "pieces") now.pieces.push_back(static_cast<std::size_t>(n));
        if (word == "parts") now.parts = n;
        if (word == "holes") now.holes = n;
      }
    } else {
      throw std::runtime_error(path + ": unknown line: " + text);
    }
  }
  return cases;
}

inline std::vector<Case> read_all() {
  std::vector<Case> all;
  for (const char* name : {"touching", "topology", "units", "lattices"}) {
    for (Case& c : read(std::string(BRASH_SOURCE_DIR "/tests/corpus/") + name + ".txt")) all.push_back(std::move(c));
  }
  return all;
}

/// `c` with every point moved by `map`; a map that mirrors turns rings round. Expectations are dropped.
template <typename Map>
Case mapped(const Case& c, bool mirrors, Map map) {
  const auto map_ring = [&](geometry::Ring ring) {
    for (geometry::Point& p : ring) p = map(p);
    if (mirrors) std::reverse(ring.begin(), ring.end());
    return ring;
  };
  Case result{c.name, {}, {}, {}, -1, -1};
  for (const geometry::Polygon& polygon : c.ice) {
    geometry::Polygon& to = result.ice.emplace_back();
    to.outline = map_ring(polygon.outline);
    for (const geometry::Ring& hole : polygon.holes) to.holes.push_back(map_ring(hole));
  }
  for (const Event& event : c.events) {
    Event& to = result.events.emplace_back();
    to.region = map_ring(event.region);
    for (const geometry::Crack& crack : event.cracks) to.cracks.push_back({map(crack.from), map(crack.to)});
  }
  return result;
}

/// The case as written, mirrored, turned by 90 degrees, and with its events in reverse order.
inline std::vector<Case> variants(const Case& c) {
  std::vector<Case> all{c};
  all.push_back(mapped(c, true, [](geometry::Point p) { return geometry::Point::of_units(-p.x, p.y); }));
  all.back().name += ", mirrored";
  all.push_back(mapped(c, false, [](geometry::Point p) { return geometry::Point::of_units(-p.y, p.x); }));
  all.back().name += ", turned";
  all.push_back(mapped(c, false, [](geometry::Point p) { return p; }));
  all.back().name += ", reversed";
  std::reverse(all.back().events.begin(), all.back().events.end());
  return all;
}

}  // namespace brash::corpus
