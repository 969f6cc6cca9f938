// SPDX-License-Identifier: GPL-3.0-or-later
#include "events.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>

#include "brash/core/constants.hpp"

namespace brash::benchmarks {

using namespace geometry;

namespace {

class Random {
 public:
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_{20240229};
};

Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace

Workload make_workload(std::int64_t n_vertices, int sides, std::size_t n_events) {
  Random random;
  // Edges of 0.3 m, but never so small a sheet that the events eat it.
  const double radius = std::max(60.0, 0.3 * static_cast<double>(n_vertices) / (2.0 * kPi));
  Workload workload;
  for (std::int64_t i = 0; i < n_vertices; ++i) {
    const double angle = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(n_vertices);
    workload.sheet.outline.push_back(snap((radius + random.uniform(-0.1, 0.1)) * direction(angle)));
  }
  const Polygon polygons[] = {workload.sheet};
  IceSheet sheet = IceSheet::from_polygons(polygons).value();
  while (workload.events.size() < n_events) {
    const auto chains = sheet.free_edge(radius * direction(random.uniform(0.0, 2.0 * kPi)), 6.0);
    if (chains.empty()) continue;
    const std::vector<Vec2>& chain = chains.front();
    const std::size_t i = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(chain.size() - 1)));
    const double along = random.uniform(0.0, 1.0);
    const Vec2 centre = chain[i] + along * (chain[i + 1] - chain[i]);
    const Vec2 ice = perpendicular(chain[i + 1] - chain[i]);
    Event event;
    event.region = disc(centre, random.uniform(0.5, 3.0), sides);
    const int n_cracks = 2 + static_cast<int>(random.uniform(0.0, 3.0));
    const double first = std::atan2(ice.y, ice.x) - 0.5 * kPi;
    for (int k = 1; k <= n_cracks; ++k) {
      const double turn = std::fmod(first + kPi * k / (n_cracks + 1) + 4.0 * kPi, 2.0 * kPi) / (2.0 * kPi);
      event.cracks.push_back({snap(centre), event.region[static_cast<std::size_t>(std::lround(turn * sides)) % sides]});
    }
    sheet.cut(event.region, event.cracks);
    sheet.release_detached();
    workload.events.push_back(std::move(event));
  }
  return workload;
}

std::vector<Ring> sectors(const Event& event) {
  std::vector<std::size_t> ends;
  for (const Crack& crack : event.cracks) {
    const auto at = std::find(event.region.begin(), event.region.end(), crack.to);
    ends.push_back(static_cast<std::size_t>(at - event.region.begin()));
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<Ring> rings;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    Ring& ring = rings.emplace_back(1, event.cracks.front().from);
    const std::size_t last = ends[(k + 1) % ends.size()];
    for (std::size_t i = ends[k];; i = (i + 1) % event.region.size()) {
      ring.push_back(event.region[i]);
      if (i == last) break;
    }
  }
  return rings;
}

std::size_t affordable(double microseconds, const Workload& workload) {
  return std::clamp<std::size_t>(static_cast<std::size_t>(1e6 / microseconds), 3, workload.events.size());
}

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace brash::benchmarks
