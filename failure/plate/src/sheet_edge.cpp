// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet_edge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brash::plate {

namespace {

using Polyline = std::vector<Vec2>;

/// Points closer than this are one, over l_c.
constexpr double kSamePoint = 1e-9;
/// The ends of loads and B lie within this distance of the edge, over l_c.
constexpr double kOnEdge = 2e-3;
/// Ends of loads and B closer than this are one, over l_c. Smaller gaps make tiny elements.
constexpr double kSamePlace = 2e-3;
/// Loads are made at least so long, over l_c.
constexpr double kShortestLoad = 0.01;
/// Next to a load, what may be left out is this share of its length and this share of the distance. The stress close to
/// a short contact follows the sides of its wedge: with eight times as much, one edge in thirty errs by 2 to 5 %.
constexpr double kContactShare = 0.03;
constexpr double kDistanceShare = 0.01;
/// Squares that differ by less than this factor are compared by their roots.
constexpr double kRounding = 1.0 + 1e-9;
/// Points of the edge between the two sides of a neck or a slot, at most.
constexpr std::size_t kPocket = 20;
/// Times that the tolerance is halved if the simplified edge touches itself.
constexpr int kHalvings = 12;

/// A place on a polyline: its segment, and its distance from the start along the line.
struct Station {
  std::size_t segment = 0;
  double along = 0.0;
  double off = std::numeric_limits<double>::infinity();  ///< distance of the projected point
  Vec2 place{};
};

std::vector<double> lengths_of(const Polyline& line) {
  std::vector<double> along{0.0};
  for (std::size_t i = 1; i < line.size(); ++i) along.push_back(along.back() + norm(line[i] - line[i - 1]));
  return along;
}

/// The point of a segment that is nearest to a place, with its share of the segment.
struct Foot {
  double share = 0.0;
  Vec2 place{};
};

Foot foot_on(Vec2 from, Vec2 to, Vec2 place) {
  const Vec2 step = to - from;
  const double share = std::clamp(dot(place - from, step) / dot(step, step), 0.0, 1.0);
  return {share, from + share * step};
}

Station project(const Polyline& line, const std::vector<double>& along, Vec2 place) {
  std::vector<double> square;
  square.reserve(line.size());
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 off = place - foot_on(line[i], line[i + 1], place).place;
    square.push_back(dot(off, off));
  }
  // Roots only where squares cannot show which is nearest.
  const double least = *std::min_element(square.begin(), square.end()) * kRounding;
  Station best;
  for (std::size_t i = 0; i < square.size(); ++i) {
    if (square[i] > least) continue;
    const Foot foot = foot_on(line[i], line[i + 1], place);
    const double off = norm(place - foot.place);
    if (off < best.off) best = {i, along[i] + foot.share * norm(line[i + 1] - line[i]), off, foot.place};
  }
  return best;
}

Station station_at(const Polyline& line, const std::vector<double>& along, double where) {
  where = std::clamp(where, 0.0, along.back());
  auto i = static_cast<std::size_t>(std::upper_bound(along.begin(), along.end(), where) - along.begin());
  i = std::clamp<std::size_t>(i, 1, line.size() - 1) - 1;
  return {i, where, 0.0, line[i] + (where - along[i]) * normalized(line[i + 1] - line[i])};
}

std::optional<std::string> fault_of(const Polyline& edge) {
  if (edge.size() < 2) return "the edge has fewer than two points";
  for (const Vec2 point : edge) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) return "the edge has a point that is not finite";
    if (point.y < edge.front().y || point.y > edge.back().y) return "the edge passes its own ends sideways";
  }
  return std::nullopt;
}

/// The loads as stretches of the line, from end to end.
struct Stretches {
  std::vector<std::pair<double, double>> loads;
  std::vector<double> marks;  ///< all ends, ascending, none closer than kSamePlace to another
};

tl::expected<Stretches, std::string> stretches_of(const Polyline& line, const std::vector<double>& along,
                                                  const std::vector<EdgeLoad>& loads) {
  Stretches result;
  for (const EdgeLoad& load : loads) {
    const Station from = project(line, along, load.from);
    const Station to = project(line, along, load.to);
    if (!(from.off < kOnEdge && to.off < kOnEdge)) return tl::unexpected(std::string("a load lies off the edge"));
    if (from.along > to.along + kOnEdge) return tl::unexpected(std::string("a load runs against the edge"));
    const double widen = std::max(0.0, 0.5 * (kShortestLoad - (to.along - from.along)));
    double first = std::max(0.0, from.along - widen);
    double last = std::min(along.back(), to.along + widen);
    result.loads.emplace_back(first, last);
    result.marks.insert(result.marks.end(), {first, last});
  }
  std::sort(result.marks.begin(), result.marks.end());
  std::vector<double> apart;
  for (const double mark : result.marks) {
    if (apart.empty() || mark - apart.back() > kSamePlace) apart.push_back(mark);
  }
  result.marks = apart;
  // Each end takes the nearest mark.
  const auto snapped = [&](double end) {
    return *std::min_element(apart.begin(), apart.end(),
                             [&](double a, double b) { return std::abs(a - end) < std::abs(b - end); });
  };
  for (auto& [first, last] : result.loads) {
    first = snapped(first);
    last = snapped(last);
  }
  return result;
}

/// What simplification may do with a point.
enum class Mark : char { kFree, kLoad, kFixed };

/// A polyline under simplification.
struct Chain {
  Polyline points;
  std::vector<Mark> marked;

  void add(Vec2 point, Mark mark) {
    points.push_back(point);
    marked.push_back(mark);
  }
  void erase(std::size_t from, std::size_t to) {
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(from), points.begin() + static_cast<std::ptrdiff_t>(to));
    marked.erase(marked.begin() + static_cast<std::ptrdiff_t>(from), marked.begin() + static_cast<std::ptrdiff_t>(to));
  }
  Mark strongest(std::size_t from, std::size_t to) const {
    return *std::max_element(marked.begin() + static_cast<std::ptrdiff_t>(from),
                             marked.begin() + static_cast<std::ptrdiff_t>(to));
  }
};

class Simplifier {
 public:
  Simplifier(const LoadedSheet& sheet, EdgeTolerance tolerance) : sheet_(&sheet), tolerance_(tolerance) {
    for (const EdgeLoad& load : sheet.edge_loads)
      lengths_.push_back(std::max(kShortestLoad, norm(load.to - load.from)));
  }

  /// What may be left out at a place.
  double at(Vec2 place) const {
    double distance = norm(place);
    double feature = std::numeric_limits<double>::infinity();
    for (std::size_t l = 0; l < lengths_.size(); ++l) {
      const double off = distance_to_stretch(place, sheet_->edge_loads[l].from, sheet_->edge_loads[l].to);
      distance = std::min(distance, off);
      // Features as small as a contact matter next to it.
      feature = std::min(feature, kContactShare * lengths_[l] + kDistanceShare * off);
    }
    for (const PatchLoad& load : sheet_->patch_loads) distance = std::min(distance, norm(place - load.at));
    const double near = tolerance_.at_any_price ? tolerance_.near : std::min(tolerance_.near, feature);
    return scale_ * (near + tolerance_.growth * std::max(0.0, distance - 1.0));
  }

  void halve() { scale_ *= 0.5; }

  /// Appends the points of the line after the first that stay.
  void thin(const Polyline& line, Chain& kept) const {
    std::vector<double> tolerances;
    tolerances.reserve(line.size());
    for (const Vec2 point : line) tolerances.push_back(at(point));
    thin(line, tolerances, 0, line.size() - 1, kept);
  }

  /// Cuts ice off that hangs on a neck narrower than the tolerance, and closes slots that are as narrow as that
  /// throughout: the mesh would be as fine as they are. Ice lies on the right of the edge, so a tongue of ice turns
  /// clockwise and a slot of water does not.
  void cut_necks(Chain& chain) const {
    const Mark removable = tolerance_.at_any_price ? Mark::kLoad : Mark::kFree;
    for (std::size_t i = 0; i + 2 < chain.points.size(); ++i) {
      for (std::size_t j = std::min(i + kPocket, chain.points.size() - 1); j > i + 1; --j) {
        const auto& p = chain.points;
        const double narrow = std::min(at(p[i]), at(p[j]));
        // A point near a later stretch, or a point near an earlier one.
        const bool is_neck =
            distance_to_stretch(p[i], p[j - 1], p[j]) < narrow || distance_to_stretch(p[j], p[i], p[i + 1]) < narrow;
        if (!is_neck || chain.strongest(i + 1, j) > removable) continue;
        double length = 0.0;
        for (std::size_t k = i; k < j; ++k) length += norm(p[k + 1] - p[k]);
        if (area(p, i, j) > 0.5 * length * narrow && !tolerance_.at_any_price) continue;
        chain.erase(i + 1, j);
        break;
      }
    }
  }

 private:
  /// Appends the points after `first` up to `last` that stay.
  static void thin(const Polyline& line, const std::vector<double>& tolerances, std::size_t first, std::size_t last,
                   Chain& kept) {
    std::size_t farthest = first;
    double most = 1.0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = distance_to_stretch(line[i], line[first], line[last]) / tolerances[i];
      if (off > most) {
        most = off;
        farthest = i;
      }
    }
    if (farthest == first) {
      kept.add(line[last], Mark::kFree);
      return;
    }
    thin(line, tolerances, first, farthest, kept);
    thin(line, tolerances, farthest, last, kept);
  }

  static double area(const Polyline& line, std::size_t from, std::size_t to) {
    double twice = cross(line[to], line[from]);
    for (std::size_t i = from; i < to; ++i) twice += cross(line[i], line[i + 1]);
    return 0.5 * twice;
  }

  const LoadedSheet* sheet_;
  std::vector<double> lengths_;  ///< of the edge loads
  EdgeTolerance tolerance_;
  double scale_ = 1.0;
};

bool meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double abc = cross(b - a, c - a);
  const double abd = cross(b - a, d - a);
  const double cda = cross(d - c, a - c);
  const double cdb = cross(d - c, b - c);
  if (((abc > 0.0) != (abd > 0.0)) && ((cda > 0.0) != (cdb > 0.0))) return true;
  return distance_to_stretch(c, a, b) < kSamePoint || distance_to_stretch(d, a, b) < kSamePoint ||
         distance_to_stretch(a, c, d) < kSamePoint || distance_to_stretch(b, c, d) < kSamePoint;
}

bool touches_itself(const Polyline& line) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double left = std::min(line[i].x, line[i + 1].x);
    const double right = std::max(line[i].x, line[i + 1].x);
    const double low = std::min(line[i].y, line[i + 1].y);
    const double high = std::max(line[i].y, line[i + 1].y);
    for (std::size_t j = i + 2; j + 1 < line.size(); ++j) {
      const Vec2 c = line[j];
      const Vec2 d = line[j + 1];
      if (std::max(c.x, d.x) < left || std::min(c.x, d.x) > right || std::max(c.y, d.y) < low ||
          std::min(c.y, d.y) > high) {
        continue;
      }
      if (meet(line[i], line[i + 1], c, d)) return true;
    }
  }
  return false;
}

/// Moves the points that `thin` kept of a section so that bays stay as wide and cusps as thick as they were: as much
/// ice lies behind the section as before. Chords alone would make every bay smaller.
void keep_area(const Polyline& section, std::size_t first, Chain& chain) {
  auto& points = chain.points;
  // Twice the area to the left of each kept stretch that was ice or water before.
  std::vector<double> missing;
  std::size_t i = 0;
  for (std::size_t k = first; k + 1 < points.size(); ++k) {
    double twice = 0.0;
    for (; i + 1 < section.size() && !(section[i] == points[k + 1]); ++i) {
      twice += cross(section[i] - points[k], section[i + 1] - points[k]);
    }
    missing.push_back(twice);
  }
  const Polyline old(points.begin() + static_cast<std::ptrdiff_t>(first), points.end());
  for (std::size_t k = 1; k + 1 < old.size(); ++k) {
    const Vec2 before = old[k] - old[k - 1];
    const Vec2 after = old[k + 1] - old[k];
    const double length = norm(before) + norm(after);
    const Vec2 across = old[k + 1] - old[k - 1];
    if (!(norm(across) > 0.5 * length)) continue;  // a sharp tip stays
    // Two points share the area of the stretch between them, unless one of the two is fixed.
    const double area2 = (k == 1 ? 1.0 : 0.5) * missing[k - 1] + (k + 2 == old.size() ? 1.0 : 0.5) * missing[k];
    const double shift = area2 / length;
    points[first + k] = old[k] - shift * perpendicular(normalized(across));
  }
}

/// The line with its marks as points, thinned between them, straight under the loads.
Chain chain_of(const Polyline& line, const std::vector<double>& along, const Stretches& stretches,
               const Simplifier& simplifier) {
  Chain chain;
  chain.add(line.front(), Mark::kFixed);
  Station from = station_at(line, along, 0.0);
  const auto advance = [&](const Station& to, bool is_loaded, Mark mark) {
    if (to.along - from.along <= kSamePoint) {
      chain.points.back() = to.place;
    } else if (is_loaded) {
      chain.add(to.place, mark);
    } else {
      Polyline section{from.place};
      for (std::size_t i = from.segment + 1; i <= to.segment; ++i) section.push_back(line[i]);
      section.push_back(to.place);
      const std::size_t first = chain.points.size() - 1;
      simplifier.thin(section, chain);
      keep_area(section, first, chain);
    }
    chain.marked.back() = std::max(chain.marked.back(), mark);
    from = to;
  };
  const auto covers = [](double s) { return [s](const auto& load) { return load.first <= s && s <= load.second; }; };
  const Station foot = project(line, along, {0.0, 0.0});
  const double origin = foot.along;
  const auto& loads = stretches.loads;
  std::vector<double> marks = stretches.marks;
  const bool is_bare = foot.off < kOnEdge && std::none_of(loads.begin(), loads.end(), covers(origin));
  if (is_bare) marks.insert(std::upper_bound(marks.begin(), marks.end(), origin), origin);
  for (const double mark : marks) {
    const bool is_loaded = std::any_of(loads.begin(), loads.end(), covers(0.5 * (from.along + mark)));
    // The contact at B stays, and so does B where no load lies on it.
    const bool is_fixed = (is_bare && mark == origin) || std::any_of(loads.begin(), loads.end(), [&](const auto& load) {
                            return covers(mark)(load) && covers(origin)(load);
                          });
    advance(station_at(line, along, mark), is_loaded, is_fixed ? Mark::kFixed : Mark::kLoad);
  }
  advance({line.size() - 2, along.back(), 0.0, line.back()}, false, Mark::kFixed);
  simplifier.cut_necks(chain);
  return chain;
}

std::size_t index_of(const Polyline& line, Vec2 place) {
  std::size_t nearest = 0;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 off = line[i] - place;
    if (dot(off, off) > best * best * kRounding || !(norm(off) < best)) continue;
    best = norm(off);
    nearest = i;
  }
  return nearest;
}

/// Makes B a point of the edge where it lies on it.
void insert_origin(SheetEdge& edge) {
  const Station foot = project(edge.points, lengths_of(edge.points), {0.0, 0.0});
  if (foot.off > kOnEdge) return;
  std::size_t i = foot.segment;
  if (norm(edge.points[i]) > kSamePlace && norm(edge.points[i + 1]) > kSamePlace) {
    edge.points.insert(edge.points.begin() + static_cast<std::ptrdiff_t>(i) + 1, Vec2{});
    for (auto& [from, to] : edge.loads) {
      if (from > i) ++from;
      if (to > i) ++to;
    }
    edge.origin = i + 1;
    return;
  }
  if (norm(edge.points[i]) > norm(edge.points[i + 1])) ++i;
  edge.points[i] = {0.0, 0.0};
  edge.origin = i;
}

}  // namespace

double distance_to_stretch(Vec2 place, Vec2 from, Vec2 to) {
  const Vec2 along = to - from;
  const double length2 = dot(along, along);
  const double s = length2 > 0.0 ? std::clamp(dot(place - from, along) / length2, 0.0, 1.0) : 0.0;
  const Vec2 off = place - from - s * along;
  return std::sqrt(dot(off, off));
}

tl::expected<SheetEdge, std::string> simplified_edge(const LoadedSheet& sheet, EdgeTolerance tolerance) {
  if (const auto fault = fault_of(sheet.outline)) return tl::unexpected(*fault);
  Polyline line;
  for (const Vec2 point : sheet.outline) {
    if (line.empty() || norm(point - line.back()) > kSamePoint) line.push_back(point);
  }
  if (line.size() < 2) return tl::unexpected(std::string("the edge has fewer than two points"));
  const auto along = lengths_of(line);
  const auto stretches = stretches_of(line, along, sheet.edge_loads);
  if (!stretches) return tl::unexpected(stretches.error());

  Simplifier simplifier(sheet, tolerance);
  for (int attempt = 0; attempt <= kHalvings; ++attempt, simplifier.halve()) {
    SheetEdge edge{chain_of(line, along, *stretches, simplifier).points, {}, {}};
    const auto place = [&](double mark) { return index_of(edge.points, station_at(line, along, mark).place); };
    for (const auto& [first, last] : stretches->loads) {
      // A load that was cut off acts on the stretch next to it.
      const std::size_t start = std::min(place(first), edge.points.size() - 2);
      edge.loads.emplace_back(start, std::max(place(last), start + 1));
    }
    insert_origin(edge);
    if (!touches_itself(edge.points)) return edge;
  }
  return tl::unexpected(std::string("the edge touches itself"));
}

}  // namespace brash::plate
