// SPDX-License-Identifier: GPL-3.0-or-later
// Errors and times of the fast sheet on random jagged edges: the numbers of docs/theory/fracture-of-the-edge.md.
//
//   sheet_study [cases] [first]     each is solved on the fast mesh and on the fine one

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "brash/plate/sheet.hpp"

namespace {

namespace plate = brash::plate;
using brash::Vec2;
using Random = std::mt19937_64;

double uniform(Random& random, double from, double to) {
  return from + (to - from) * std::generate_canonical<double, 53>(random);
}

/// An edge from which discs were broken out, as a polyline along y: bays with cusps between them.
std::vector<Vec2> broken_edge(Random& random) {
  struct Disc {
    Vec2 centre;
    double radius;
  };
  std::vector<Disc> discs;
  const int count = static_cast<int>(uniform(random, 6.0, 25.0));
  for (int i = 0; i < count; ++i) {
    discs.push_back({{uniform(random, -0.6, 0.3), uniform(random, -3.5, 3.5)}, uniform(random, 0.2, 1.1)});
  }
  std::vector<Vec2> edge;
  const double step = 2.0 * std::numbers::pi / 40.0;
  for (double y = -3.0; y <= 3.0; y += uniform(random, 0.2, 1.0) * step * 0.7) {
    double x = 0.0;
    for (const Disc& disc : discs) {
      const double half = disc.radius * disc.radius - (y - disc.centre.y) * (y - disc.centre.y);
      if (half > 0.0) x = std::max(x, disc.centre.x + std::sqrt(half));
    }
    edge.push_back({x, y});
    if (uniform(random, 0.0, 1.0) < 0.05) edge.push_back(edge.back() + Vec2{0.0, 1e-6});
  }
  return edge;
}

/// The edge in the frame of its chord between the points i and j, which is pressed.
std::vector<Vec2> in_frame_of(const std::vector<Vec2>& edge, std::size_t i, std::size_t j) {
  const Vec2 origin = 0.5 * (edge[i] + edge[j]);
  const Vec2 y = normalized(edge[j] - edge[i]);
  const Vec2 x{y.y, -y.x};
  std::vector<Vec2> before;
  std::vector<Vec2> after;
  for (std::size_t k = 0; k < edge.size(); ++k) {
    if (k > i && k < j) continue;
    const Vec2 p = edge[k] - origin;
    (k <= i ? before : after).push_back({dot(p, x), dot(p, y)});
  }
  const auto by_y = [](Vec2 a, Vec2 b) { return a.y < b.y; };
  before.erase(before.begin(), std::min_element(before.begin(), before.end(), by_y));
  after.erase(std::max_element(after.begin(), after.end(), by_y) + 1, after.end());
  before.insert(before.end(), after.begin(), after.end());
  for (Vec2& point : before) {
    point.y = std::clamp(point.y, before.front().y, before.back().y);
  }
  return before;
}

plate::LoadedSheet random_sheet(Random& random) {
  for (;;) {
    const auto edge = broken_edge(random);
    const auto i = static_cast<std::size_t>(uniform(random, 0.3, 0.7) * static_cast<double>(edge.size()));
    const double contact = 0.05 * std::pow(20.0, uniform(random, 0.0, 1.0));
    std::size_t j = i + 1;
    while (j + 1 < edge.size() && norm(edge[j] - edge[i]) < contact) ++j;
    plate::LoadedSheet sheet{.outline = in_frame_of(edge, i, j)};
    sheet.thickness = uniform(random, 0.06, 0.15);
    sheet.second_order = uniform(random, 0.0, 1.0) < 0.5;
    const double half = 0.5 * norm(edge[j] - edge[i]);
    const double force = half * uniform(random, 0.2, 1.0);
    const double mu1 = uniform(random, 0.3, 1.0);
    sheet.edge_loads.push_back({{0.0, -half}, {0.0, half}, {force, force * uniform(random, -0.1, 0.1)}, mu1 * force});
    const int others = static_cast<int>(uniform(random, 0.0, 4.0));
    const auto& line = sheet.outline;
    for (int k = 0; k < others; ++k) {
      const auto at = static_cast<std::size_t>(uniform(random, 0.0, 1.0) * static_cast<double>(line.size() - 1));
      const Vec2 along = line[at + 1] - line[at];
      const double length = norm(along);
      if (length < 0.02 || norm(line[at]) < half + 0.01 || norm(line[at + 1]) < half + 0.01) continue;
      const Vec2 inward{along.y / length, -along.x / length};
      const double push = uniform(random, 0.0, 0.6) * force;
      sheet.edge_loads.push_back({line[at], line[at + 1], push * inward, uniform(random, -0.3, 0.8) * push});
    }
    // Ice ahead of B for at least 1 l_c, else there is nothing to break.
    const auto meets = [&](Vec2 a, Vec2 b) {
      if ((a.y > 0.0) == (b.y > 0.0)) return false;
      const double x = a.x + (b.x - a.x) * a.y / (a.y - b.y);
      return x > 1e-6 && x < 1.0;
    };
    bool open = true;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) open = open && !meets(line[k], line[k + 1]);
    if (open && line.size() > 5) return sheet;
  }
}

struct Answer {
  double stress = 0.0;  ///< largest on the line ahead of B
  double place = 0.0;
  double tension = 0.0;  ///< largest principal stress on the other surface at B
  double seconds = 0.0;
  double mesh = 0.0, membrane = 0.0, bending = 0.0, recovery = 0.0;
  int n_elements = 0;
};

double principal(const plate::LoadedSheet& sheet, const plate::SheetState& state, double side) {
  const double a = side * 6.0 / (sheet.thickness * sheet.thickness);
  const double b = 1.0 / sheet.thickness;
  const double xx = a * state.moment.xx + b * state.membrane.xx;
  const double yy = a * state.moment.yy + b * state.membrane.yy;
  const double xy = a * state.moment.xy + b * state.membrane.xy;
  return 0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy);
}

bool answer(plate::LoadedSheet sheet, plate::Accuracy accuracy, Answer& result) {
  sheet.accuracy = accuracy;
  const std::clock_t start = std::clock();
  const auto solution = plate::solve(sheet);
  if (!solution) {
    std::printf("failed: %s\n", solution.error().what.c_str());
    return false;
  }
  const std::clock_t solved = std::clock();
  const auto profile = solution->along({0.0, 0.0}, {1.0, 0.0}, 3.0);
  const std::clock_t end = std::clock();
  for (std::size_t i = 0; i < profile.station.size(); ++i) {
    const double stress = principal(sheet, profile.state[i], 1.0);
    if (stress <= result.stress) continue;
    result.stress = stress;
    result.place = profile.station[i];
  }
  if (!profile.state.empty()) result.tension = principal(sheet, profile.state.front(), -1.0);
  result.seconds = static_cast<double>(end - start) / CLOCKS_PER_SEC;
  result.recovery = static_cast<double>(end - solved) / CLOCKS_PER_SEC;
  result.mesh = solution->times().mesh;
  result.membrane = solution->times().membrane;
  result.bending = solution->times().bending;
  result.n_elements = solution->n_elements();
  return true;
}

void print(const char* name, std::vector<double> values) {
  if (values.empty()) return;
  std::sort(values.begin(), values.end());
  const auto quantile = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  std::printf("%-30s median %9.2e  95 %% %9.2e  99 %% %9.2e  worst %9.2e\n", name, quantile(0.5), quantile(0.95),
              quantile(0.99), quantile(1.0));
}

}  // namespace

int main(int argc, char** argv) {
  const int n = argc > 1 ? std::atoi(argv[1]) : 200;
  const int first = argc > 2 ? std::atoi(argv[2]) : 0;
  std::vector<double> stress, place, tension, seconds, fine_seconds, elements, mesh, membrane, bending, recovery;
  for (int i = first; i < first + n; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const auto sheet = random_sheet(random);
    Answer fast, fine;
    if (!answer(sheet, plate::Accuracy::kFast, fast) || !answer(sheet, plate::Accuracy::kFine, fine)) {
      std::printf("%4d\n", i);
      continue;
    }
    stress.push_back(std::abs(fast.stress / fine.stress - 1.0));
    place.push_back(std::abs(fast.place - fine.place));
    tension.push_back(std::abs(fast.tension - fine.tension) / std::max(std::abs(fine.tension), fine.stress));
    for (auto [list, value] : {std::pair{&seconds, fast.seconds},
                               {&fine_seconds, fine.seconds},
                               {&mesh, fast.mesh},
                               {&membrane, fast.membrane},
                               {&bending, fast.bending},
                               {&recovery, fast.recovery},
                               {&elements, static_cast<double>(fast.n_elements)}}) {
      list->push_back(value);
    }
    std::printf(
        "%4d points %3zu loads %zu: stress %9.3e error %+.1e, place %.3f error %+.3f, at B %+.1e; %d and %d elements, "
        "%.1f and %.0f ms\n",
        i, sheet.outline.size(), sheet.edge_loads.size(), fine.stress, fast.stress / fine.stress - 1.0, fine.place,
        fast.place - fine.place, tension.back(), fast.n_elements, fine.n_elements, 1e3 * fast.seconds,
        1e3 * fine.seconds);
    std::fflush(stdout);
  }
  print("error of the stress", stress);
  print("error of its place / l_c", place);
  print("error at B", tension);
  print("elements", elements);
  print("seconds", seconds);
  print("  mesh", mesh);
  print("  membrane", membrane);
  print("  bending", bending);
  print("  recovery", recovery);
  print("seconds of the fine sheet", fine_seconds);
}
