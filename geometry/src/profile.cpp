// SPDX-License-Identifier: GPL-3.0-or-later
#include "profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "brash/geometry/point.hpp"

namespace brash::geometry {
namespace {

/// Sides that step back by no more than this count as parallel to the x axis [m]: vertices are rounded to the grid.
constexpr double kStepBack = 4 * kGridUnit;

/// Where B sits on the edges: the nearest segment and the nearest point of it.
struct Foot {
  std::size_t line = 0;
  std::size_t segment = 0;
  Vec2 point;
  double distance = std::numeric_limits<double>::infinity();
};

Foot nearest_to_origin(std::span<const std::vector<Vec2>> edges) {
  Foot best;
  for (std::size_t l = 0; l < edges.size(); ++l) {
    for (std::size_t i = 0; i + 1 < edges[l].size(); ++i) {
      const Vec2 a = edges[l][i], along = edges[l][i + 1] - a;
      const double length2 = dot(along, along);
      const double t = length2 > 0.0 ? std::clamp(-dot(a, along) / length2, 0.0, 1.0) : 0.0;
      const Vec2 foot = a + t * along;
      if (norm(foot) < best.distance) best = {l, i, foot, norm(foot)};
    }
  }
  return best;
}

/// A segment with the ice behind it (`is_front`) or before it, over low <= y <= high.
struct Segment {
  double low;
  double high;
  Vec2 at_low;
  Vec2 at_high;
  bool is_front;

  double depth(double y) const { return at_low.x + (y - at_low.y) / (at_high.y - at_low.y) * (at_high.x - at_low.x); }
};

/// Segments that a line along x can cross within the window, in the order of their low ends.
std::vector<Segment> segments_across(std::span<const std::vector<Vec2>> edges, double reach) {
  std::vector<Segment> segments;
  for (const std::vector<Vec2>& line : edges) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Vec2 a = line[i], b = line[i + 1];
      if (a.y == b.y || std::max(a.y, b.y) <= -reach || std::min(a.y, b.y) >= reach) continue;
      // Ice lies on the left: a segment that runs towards -y has it on its far side.
      if (b.y < a.y) segments.push_back({b.y, a.y, b, a, true});
      if (b.y > a.y) segments.push_back({a.y, b.y, a, b, false});
    }
  }
  std::sort(segments.begin(), segments.end(), [](const Segment& s, const Segment& t) { return s.low < t.low; });
  return segments;
}

/// The ends of all segments, the window and the centre line: between neighbours no segment begins, ends or crosses.
std::vector<double> stations_of(const std::vector<Segment>& segments, double reach) {
  std::vector<double> stations{-reach, 0.0, reach};
  for (const Segment& s : segments) {
    for (const double y : {s.low, s.high}) {
      if (std::abs(y) < reach) stations.push_back(y);
    }
  }
  std::sort(stations.begin(), stations.end());
  stations.erase(std::unique(stations.begin(), stations.end()), stations.end());
  return stations;
}

}  // namespace

void Profile::append(int side, Vec2 from, Vec2 to) {
  const double s0 = std::abs(from.y), s1 = std::min(std::abs(to.y), reach_);
  if (!(s0 < s1)) return;
  const double slope = (to.x - from.x) / (std::abs(to.y) - s0);
  // Depths beyond the window are held on its border: cut where the segment crosses it.
  const auto crossing = [&](double border) {
    return slope != 0.0 ? std::clamp(s0 + (border - from.x) / slope, s0, s1) : s0;
  };
  const auto [first, second] = std::minmax({crossing(0.0), crossing(reach_)});
  const std::array<double, 4> cuts{s0, first, second, s1};
  const auto depth = [&](double s) { return std::clamp(from.x + slope * (s - s0), 0.0, reach_); };
  for (int i = 0; i < 3; ++i) {
    if (cuts[i] < cuts[i + 1]) sides_[side].push_back({cuts[i], depth(cuts[i]), cuts[i + 1], depth(cuts[i + 1])});
  }
}

void Profile::close() {
  for (const int which : {0, 1}) {
    std::vector<Piece>& side = sides_[which];
    const std::vector<Piece>& other = sides_[1 - which];
    const double end = side.empty() ? 0.0 : side.back().s1;
    const double depth = !side.empty() ? side.back().x1 : (other.empty() ? 0.0 : other.front().x0);
    if (end < reach_) side.push_back({end, depth, reach_, depth});
  }
}

std::optional<Profile> Profile::of_chain(std::span<const std::vector<Vec2>> edges, double reach) {
  const Foot foot = nearest_to_origin(edges);
  if (!std::isfinite(foot.distance)) return std::nullopt;
  const std::vector<Vec2>& chain = edges[foot.line];

  // From the foot towards +y (against the chain's sense) and towards -y to the window's sides. The line never steps
  // back; the chain may where depths are held on the window's border whatever it does: ahead of the tip line, as at the
  // cusps on both sides of B, or deeper than the window.
  const auto is_held = [&](double x0, double x1) { return std::max(x0, x1) <= 0.0 || std::min(x0, x1) >= reach; };
  const auto walk = [&](double sign, auto next_vertex) {
    std::vector<Vec2> points{foot.point};
    for (Vec2 at = foot.point; sign * points.back().y < reach;) {
      const Vec2* next = next_vertex();
      // A chain that ends in the window is whole only where no other edge could continue from there.
      if (next == nullptr && edges.size() == 1) break;
      if (next == nullptr) return std::vector<Vec2>{};
      const double furthest = points.back().y;
      const double behind = sign * (furthest - at.y);
      const double advance = sign * (next->y - furthest);
      if (advance <= 0.0) {
        if (advance < -kStepBack && !is_held(at.x, next->x)) return std::vector<Vec2>{};
        points.push_back({next->x, furthest});
      } else {
        // Where the chain comes past the furthest place again.
        const double x = at.x + behind / (behind + advance) * (next->x - at.x);
        if (behind > kStepBack && !is_held(at.x, x)) return std::vector<Vec2>{};
        points.push_back({x, furthest});
        points.push_back(*next);
      }
      at = *next;
    }
    return points;
  };
  // A closed chain continues past the point where it starts, once around.
  const bool is_closed = chain.size() > 2 && chain.front() == chain.back();
  const std::size_t n = is_closed ? chain.size() - 1 : chain.size();
  const std::size_t n_back = is_closed ? n : foot.segment + 1, n_on = is_closed ? n : n - foot.segment - 1;
  std::size_t back = 0, on = 0;
  std::vector<Vec2> left = walk(1.0, [&] { return back < n_back ? &chain[(foot.segment + n - back++) % n] : nullptr; });
  const std::vector<Vec2> right =
      walk(-1.0, [&] { return on < n_on ? &chain[(foot.segment + 1 + on++) % n] : nullptr; });
  if (left.empty() || right.empty()) return std::nullopt;

  Profile profile(reach);
  std::reverse(left.begin(), left.end());
  left.insert(left.end(), right.begin() + 1, right.end());
  profile.read(left);
  return profile;
}

void Profile::read(std::span<const Vec2> points) {
  // Where the line passes the centre line, both sides start.
  std::vector<Vec2> line;
  for (const Vec2 p : points) {
    if (!line.empty() && line.back().y > 0.0 && p.y < 0.0) {
      const Vec2 a = line.back();
      line.push_back({a.x + a.y / (a.y - p.y) * (p.x - a.x), 0.0});
    }
    line.push_back(p);
  }
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (line[i + 1].y < 0.0) add(1, line[i], line[i + 1]);
  }
  for (std::size_t i = line.size(); i-- > 1;) {
    if (line[i - 1].y > 0.0) add(0, line[i], line[i - 1]);
  }
  close();
}

void Profile::add(int side, Vec2 from, Vec2 to) {
  std::vector<Piece>& pieces = sides_[side];
  const double end = pieces.empty() ? 0.0 : pieces.back().s1;
  const double held = pieces.empty() ? std::clamp(from.x, 0.0, reach_) : pieces.back().x1;
  if (const double s = std::min(std::abs(from.y), reach_); s > end) pieces.push_back({end, held, s, held});
  append(side, from, to);
}

Profile Profile::of_envelope(std::span<const std::vector<Vec2>> edges, double reach) {
  const std::vector<Segment> segments = segments_across(edges, reach);
  const std::vector<double> stations = stations_of(segments, reach);

  // Sweep over y; in each strip the segment with the smallest x stands before the others.
  struct Strip {
    double low;
    double high;
    double at_low;
    double at_high;
  };
  std::vector<Strip> strips;
  std::vector<const Segment*> active;
  std::size_t next = 0;
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    const double low = stations[i], high = stations[i + 1], middle = 0.5 * (low + high);
    while (next < segments.size() && segments[next].low <= low) active.push_back(&segments[next++]);
    std::erase_if(active, [&](const Segment* s) { return s->high <= low; });
    const Segment* first = nullptr;
    double smallest = std::numeric_limits<double>::infinity();
    for (const Segment* s : active) {
      const double x = s->depth(middle);
      if (x < -reach || x >= smallest) continue;
      first = s;
      smallest = x;
    }
    if (first == nullptr) continue;
    // Ice that ends before any begins: the window's front is in the ice.
    if (first->is_front) {
      strips.push_back({low, high, first->depth(low), first->depth(high)});
    } else {
      strips.push_back({low, high, -reach, -reach});
    }
  }

  // From the centre line outwards; a strip without an edge holds the depth before it.
  Profile profile(reach);
  for (const Strip& s : strips) {
    if (s.low >= 0.0) profile.add(0, {s.at_low, s.low}, {s.at_high, s.high});
  }
  for (auto s = strips.rbegin(); s != strips.rend(); ++s) {
    if (s->high <= 0.0) profile.add(1, {s->at_high, s->high}, {s->at_low, s->low});
  }
  profile.close();
  return profile;
}

}  // namespace brash::geometry
