// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "brash/core/contract.hpp"
#include "free_edges.hpp"

namespace brash::geometry {

/// A run of edges that a change leaves alone, between two vertices that it touches.
struct FreeEdges::Stretch {
  int first = -1;
  int last = -1;
  int loop = -1;  ///< Its loop before the change.
  std::int64_t n_edges = 0;
  Int128 twice_area = 0;
  bool holds_loop = false;  ///< The longest stretch of its old loop: it may keep the loop's id.
};

namespace {

constexpr int kStartsStretch = 1;
constexpr int kEndsStretch = 2;
constexpr int kTraced = -2;  ///< Loop of an added edge between its trace and its naming.

}  // namespace

void FreeEdges::forget(int id) {
  Loop& loop = loops_[edges_[id].loop];
  --loop.n_edges;
  loop.twice_area -= exact::cross(edges_[id].from, edges_[id].to);
  free_edge(id);
}

std::vector<FreeEdges::Stretch> FreeEdges::stretches_of(const Change& change) {
  std::vector<Stretch> stretches;
  std::vector<int> ends;
  stretches.reserve(change.links.size());
  ends.reserve(change.links.size());
  for (const Link& link : change.links) {
    if (link.out >= 0) {
      stretches.push_back({link.out, -1, edges_[link.out].loop, 0, 0, false});
      BRASH_EXPECTS((edges_[link.out].mark & kStartsStretch) == 0, link.out);
      edges_[link.out].mark |= kStartsStretch;
    }
    if (link.in >= 0) {
      BRASH_EXPECTS((edges_[link.in].mark & kEndsStretch) == 0, link.in);
      edges_[link.in].mark |= kEndsStretch;
      ends.push_back(link.in);
    }
  }
  BRASH_EXPECTS(ends.size() == stretches.size(), ends.size(), stretches.size());
  measure(stretches);
  // The ends that no walk reached belong to the one stretch of their loop that was not walked.
  for (Stretch& stretch : stretches) {
    if (stretch.last >= 0) edges_[stretch.last].mark &= ~kEndsStretch;
  }
  for (Stretch& stretch : stretches) {
    if (stretch.last >= 0) continue;
    const auto end = std::find_if(ends.begin(), ends.end(), [&](int id) {
      return (edges_[id].mark & kEndsStretch) != 0 && edges_[id].loop == stretch.loop;
    });
    BRASH_EXPECTS(end != ends.end(), stretch.first, stretch.loop);
    stretch.last = *end;
    edges_[*end].mark &= ~kEndsStretch;
  }
  return stretches;
}

/// Finds the last edge, length and area of every stretch. All stretches of one loop are walked in step; when only one
/// is unfinished, the loop's totals and the one end that is left give the rest.
void FreeEdges::measure(std::vector<Stretch>& stretches) {
  std::stable_sort(stretches.begin(), stretches.end(),
                   [](const Stretch& a, const Stretch& b) { return a.loop < b.loop; });
  for (std::size_t begin = 0, end = 0; begin < stretches.size(); begin = end) {
    const int loop = stretches[begin].loop;
    while (end < stretches.size() && stretches[end].loop == loop) ++end;
    std::vector<std::pair<std::size_t, int>> walks;
    for (std::size_t i = begin; i < end; ++i) walks.emplace_back(i, stretches[i].first);
    std::int64_t rest = loops_[loop].n_edges;
    Int128 rest_area = loops_[loop].twice_area;
    while (walks.size() > 1) {
      std::size_t kept = 0;
      for (auto [i, at] : walks) {
        Stretch& stretch = stretches[i];
        ++stretch.n_edges;
        --rest;
        stretch.twice_area += exact::cross(edges_[at].from, edges_[at].to);
        if (edges_[at].mark & kEndsStretch) {
          stretch.last = at;
          rest_area -= stretch.twice_area;
          continue;
        }
        walks[kept++] = {i, edges_[at].next};
      }
      walks.resize(kept);
    }
    if (walks.size() == 1) {
      Stretch& longest = stretches[walks.front().first];
      longest.n_edges += rest;
      longest.twice_area = rest_area;
    }
    auto holder = std::max_element(stretches.begin() + begin, stretches.begin() + end,
                                   [](const Stretch& a, const Stretch& b) { return a.n_edges < b.n_edges; });
    holder->holds_loop = true;
  }
}

void FreeEdges::relabel(const Stretch& stretch, int loop) {
  int id = stretch.first;
  for (std::int64_t i = 0; i < stretch.n_edges; ++i) {
    edges_[id].loop = loop;
    id = edges_[id].next;
  }
}

/// Names the loops again: walks from run to run over the new links; the longest run that held a loop gives its name.
void FreeEdges::rebuild_loops(std::vector<Stretch>& stretches, const std::vector<int>& added) {
  for (std::size_t i = 0; i < stretches.size(); ++i) edges_[stretches[i].first].mark = static_cast<int>(i) + 1;
  const auto trace = [&](int start) {
    std::vector<int> members;
    std::vector<int> fresh;
    fresh.reserve(added.size());
    Loop loop{start, 0, 0};
    int id = start;
    do {
      if (edges_[id].mark > 0) {
        const int member = edges_[id].mark - 1;
        edges_[id].mark = 0;
        members.push_back(member);
        loop.n_edges += stretches[member].n_edges;
        loop.twice_area += stretches[member].twice_area;
        id = edges_[stretches[member].last].next;
      } else {
        BRASH_EXPECTS(edges_[id].loop < 0 && id >= 0, id, edges_[id].loop);
        edges_[id].loop = kTraced;
        fresh.push_back(id);
        ++loop.n_edges;
        loop.twice_area += exact::cross(edges_[id].from, edges_[id].to);
        id = edges_[id].next;
      }
    } while (id != start);
    int holder = -1;
    for (const int m : members) {
      if (stretches[m].holds_loop && (holder < 0 || stretches[m].n_edges > stretches[holder].n_edges)) holder = m;
    }
    const int name = holder >= 0 ? stretches[holder].loop : add_loop();
    loops_[name] = loop;
    if (loop.twice_area > 0) ++n_outlines_;
    for (const int m : members) {
      if (stretches[m].loop != name) relabel(stretches[m], name);
    }
    for (const int e : fresh) edges_[e].loop = name;
  };
  for (const Stretch& stretch : stretches) {
    if (edges_[stretch.first].mark > 0) trace(stretch.first);
  }
  for (const int id : added) {
    if (edges_[id].loop == -1) trace(id);
  }
}

void FreeEdges::apply(const Change& change) {
  // The loops that are touched; they are named again below.
  std::vector<int> touched;
  touched.reserve(change.removed.size() + change.links.size());
  for (const int id : change.removed) touched.push_back(edges_[id].loop);
  for (const Link& link : change.links) {
    if (link.in >= 0) touched.push_back(edges_[link.in].loop);
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  for (const int loop : touched) n_outlines_ -= loops_[loop].twice_area > 0 ? 1 : 0;

  for (const int id : change.removed) forget(id);
  std::vector<Stretch> stretches = stretches_of(change);
  for (const int loop : touched) loops_[loop] = Loop{};
  std::vector<int> added;
  added.reserve(change.added.size());
  for (const Directed& directed : change.added) added.push_back(add_edge(directed));
  for (const Link& link : change.links) {
    const int in = link.in >= 0 ? link.in : added[~link.in];
    const int out = link.out >= 0 ? link.out : added[~link.out];
    BRASH_EXPECTS(edges_[in].to == edges_[out].from, edges_[in].to.x, edges_[in].to.y);
    edges_[in].next = out;
    edges_[out].previous = in;
  }
  for (const int id : added) BRASH_EXPECTS(edges_[id].next >= 0 && edges_[id].previous >= 0, edges_[id].from.x);
  rebuild_loops(stretches, added);
  for (const int loop : touched) {
    if (loops_[loop].edge < 0) free_loops_.push_back(loop);
  }
}

}  // namespace brash::geometry
