// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement.hpp"

#include <algorithm>
#include <optional>

#include "overlap.hpp"
#include "planar_map.hpp"

namespace brash::geometry {

namespace {

Arrangement::Walk walk_from(HalfEdge start, const std::vector<Point>& nodes) {
  Arrangement::Walk walk;
  HalfEdge h = start;
  do {
    walk.push_back({nodes[h->source()->data()], nodes[h->target()->data()], sheet(h) != 0});
    h = h->next();
  } while (h != start);
  return walk;
}

/// The boundaries of the faces that are pieces by their label.
template <typename IsPiece>
std::vector<Arrangement::Piece> pieces_of(PlanarMap& map, const std::vector<Point>& nodes, IsPiece&& is_piece) {
  std::vector<Arrangement::Piece> pieces;
  for (const Face face : map.face_handles()) {
    if (!is_piece(face->data())) continue;
    Arrangement::Piece& piece = pieces.emplace_back(Arrangement::Piece{walk_from(face->outer_ccb(), nodes), {}});
    for (auto ccb = face->inner_ccbs_begin(); ccb != face->inner_ccbs_end(); ++ccb) {
      piece.holes.push_back(walk_from(*ccb, nodes));
    }
  }
  return pieces;
}

}  // namespace

struct Arrangement::Impl {
  Impl(const Noding& noded, const FreeEdges& free_edges)
      : noding(noded), boundary(free_edges), noded_map(noded.nodes(), noded.edges()), map(noded_map.map) {}

  Point from(HalfEdge h) const { return noding.nodes()[h->source()->data()]; }
  Point to(HalfEdge h) const { return noding.nodes()[h->target()->data()]; }
  bool is_new_sheet_edge(HalfEdge h) const;
  int ice_in(Face face) const;
  void check_faces() const;
  void check_vertices() const;

  const Noding& noding;
  const FreeEdges& boundary;
  NodedMap noded_map;
  PlanarMap& map;
};

Arrangement::Arrangement(const Noding& noding, const FreeEdges& boundary)
    : impl_(std::make_unique<Impl>(noding, boundary)) {
  cover_faces(impl_->map, &FaceLabel::region, region);
  // Outside the region edges are missing, so that a face there may hold ice and water.
  for (auto face = impl_->map.faces_begin(); face != impl_->map.faces_end(); ++face) {
    if (face->data().region == 1) face->data().ice = impl_->ice_in(face);
  }
  impl_->check_faces();
  impl_->check_vertices();
}

Arrangement::~Arrangement() = default;

/// The first free edge around one of the face's vertices shows whether it is ice, over cracks and the region's
/// boundary; a face where there is none at any vertex lies wholly in ice or in water.
int Arrangement::Impl::ice_in(Face face) const {
  int ice = FaceLabel::kUnknown;
  HalfEdge side;
  for_each_side(face, [&](HalfEdge h) {
    side = h;
    const HalfEdge first = h->next();
    HalfEdge out = first;
    while (ice == FaceLabel::kUnknown) {
      if (sheet(out) != 0) ice = sheet(out) > 0 ? 1 : 0;
      out = out->twin()->next();
      if (out == first) break;
    }
  });
  if (ice == FaceLabel::kUnknown) ice = is_in_ice(from(side), noding, noded_map.joined, boundary) ? 1 : 0;
  return ice;
}

/// Throws unless every face is covered by the region once or not at all, and ice inside it agrees with its edges.
void Arrangement::Impl::check_faces() const {
  for (HalfEdge h : map.edge_handles()) {
    const FaceLabel& left = h->face()->data();
    const FaceLabel& right = h->twin()->face()->data();
    const bool is_simple = left.region - right.region == region(h) && std::min(left.region, right.region) >= 0 &&
                           std::max(left.region, right.region) <= 1;
    BRASH_EXPECTS(is_simple, "the region is not simple", left.region, right.region, from(h).x, from(h).y);
    const bool is_left_right = left.region == 0 || sheet(h) == 0 || left.ice == (sheet(h) > 0 ? 1 : 0);
    const bool is_right_right = right.region == 0 || sheet(h) == 0 || right.ice == (sheet(h) > 0 ? 0 : 1);
    const bool is_parted = left.region == 0 || right.region == 0 || left.ice - right.ice == sheet(h);
    BRASH_EXPECTS(std::abs(sheet(h)) <= 1 && is_left_right && is_right_right && is_parted, sheet(h), left.ice,
                  right.ice, from(h).x, from(h).y);
  }
}

/// Throws unless ice and water take turns around every vertex at which all edges take part.
void Arrangement::Impl::check_vertices() const {
  for (const auto vertex : map.vertex_handles()) {
    const bool is_complete = noding.is_complete(vertex->data());
    int first = 0;
    int last = 0;
    auto in = vertex->incident_halfedges();
    const auto start = in;
    do {
      BRASH_EXPECTS(is_complete || region(in) == 0, to(in).x, to(in).y);
      if (!is_complete || sheet(in) == 0) continue;
      BRASH_EXPECTS(sheet(in) != last, "free edges do not take turns", to(in).x, to(in).y);
      last = sheet(in);
      if (first == 0) first = last;
    } while (++in != start);
    BRASH_EXPECTS(first == 0 || first != last, "free edges do not take turns", noding.nodes()[vertex->data()].x);
  }
}

Arrangement::Cracks Arrangement::drop_useless_cracks() {
  std::vector<Edge> splitting;
  std::vector<Edge> useless;
  for (const Edge h : impl_->noded_map.rightward) {
    if (!is_there(h) || !h->curve().data().is_crack) continue;
    const bool is_piece_left = h->face()->data().is_piece();
    if (is_piece_left != h->twin()->face()->data().is_piece()) continue;
    (is_piece_left && h->face() != h->twin()->face() ? splitting : useless).push_back(h);
  }
  Cracks cracks;
  for (const HalfEdge h : splitting) cracks.splitting.push_back({impl_->from(h), impl_->to(h)});
  if (useless.empty()) return cracks;
  std::vector<char> stays = impl_->noding.nodes_without_cracks();
  for (const HalfEdge h : splitting) stays[h->source()->data()] = stays[h->target()->data()] = 1;
  for (const Edge h : useless) {
    cracks.has_traces = cracks.has_traces || !stays[h->source()->data()] || !stays[h->target()->data()];
    if (!h->face()->data().is_piece()) continue;  // In water it may be part of the region's boundary too.
    impl_->noded_map.rightward[h->curve().data().number] = {};
    impl_->map.remove_edge(h);
  }
  return cracks;
}

std::vector<Arrangement::Piece> Arrangement::pieces() const {
  const auto is_piece = [](const FaceLabel& face) { return face.is_piece(); };
  return pieces_of(impl_->map, impl_->noding.nodes(), is_piece);
}

std::vector<Arrangement::Piece> Arrangement::overlap(const Noding& noding, const FreeEdges& boundary) {
  const std::vector<NodedEdge> edges = overlap_edges(noding, boundary);
  if (edges.empty()) return {};
  const auto step = [](HalfEdge h) { return sheet(h) + region(h); };
  NodedMap noded(noding.nodes(), edges);
  cover_faces(noded.map, &FaceLabel::ice, step);
  for (const HalfEdge h : noded.map.halfedge_handles()) {
    const int left = h->face()->data().ice;
    BRASH_EXPECTS(left == std::max(step(h), 0), "the region is not simple", left, step(h));
  }
  return pieces_of(noded.map, noding.nodes(), [](const FaceLabel& face) { return face.ice == 1; });
}

/// True for a half-edge of the free edge as it is after the region has gone.
bool Arrangement::Impl::is_new_sheet_edge(HalfEdge h) const {
  if (h->face()->data().region == 1) return false;
  return sheet(h) > 0 || (sheet(h) == 0 && h->twin()->face()->data().is_piece());
}

SheetChange Arrangement::sheet_change() const {
  const NodedMap& edges = impl_->noded_map;
  const auto is_new = [&](HalfEdge h) { return impl_->is_new_sheet_edge(h); };
  SheetChange result;
  FreeEdges::Change& change = result.change;
  change.removed.reserve(impl_->noding.active().size());
  change.added.reserve(edges.rightward.size());
  change.links.reserve(edges.rightward.size());
  std::vector<char> is_touched(impl_->noding.nodes().size(), 0);

  // Old edges that are still there stay; the others go.
  for (const Noding::ActiveEdge& e : impl_->noding.active()) {
    const Edge h = e.edge < 0 ? Edge{} : edges.along_edge(e.edge);
    if (is_there(h) && is_new(h)) {
      BRASH_EXPECTS(h->data() == kNoRef, impl_->from(h).x, impl_->from(h).y);
      h->set_data(e.id);
      continue;
    }
    const FreeEdges::Edge& gone = impl_->boundary.edge(e.id);
    change.removed.push_back(e.id);
    result.twice_area -= exact::cross(gone.from, gone.to);
    is_touched[e.from] = is_touched[e.to] = 1;
  }
  const auto for_each_new = [&](auto visit) {
    for (const Edge right : edges.rightward) {
      if (!is_there(right)) continue;
      if (is_new(right)) visit(right);
      if (is_new(right->twin())) visit(right->twin());
    }
  };
  for_each_new([&](Edge h) {
    if (h->data() != kNoRef) return;
    h->set_data(~static_cast<int>(change.added.size()));
    change.added.push_back({impl_->from(h), impl_->to(h)});
    result.twice_area += exact::cross(impl_->from(h), impl_->to(h));
    is_touched[h->source()->data()] = is_touched[h->target()->data()] = 1;
  });
  for_each_new([&](HalfEdge h) {
    if (is_touched[h->target()->data()]) change.links.push_back({h->data(), next_active(h, is_new)->data()});
  });
  return result;
}

namespace {

/// The half-edges with ice on their left alone, linked to loops.
template <typename HasIce>
FreeEdges::Change edges_with_ice(PlanarMap& map, const std::vector<Point>& nodes, HasIce&& has_ice) {
  FreeEdges::Change change;
  for (const Edge h : map.halfedge_handles()) {
    if (!has_ice(h)) continue;
    h->set_data(~static_cast<int>(change.added.size()));
    change.added.push_back({nodes[h->source()->data()], nodes[h->target()->data()]});
  }
  for (const HalfEdge h : map.halfedge_handles()) {
    if (has_ice(h)) change.links.push_back({h->data(), next_active(h, has_ice)->data()});
  }
  return change;
}

}  // namespace

tl::expected<FreeEdges::Change, OverlapError> boundary_of(const std::vector<Point>& nodes,
                                                          const std::vector<NodedEdge>& edges) {
  NodedMap noded(nodes, edges);
  cover_faces(noded.map, &FaceLabel::ice, sheet);
  const auto from = [&](HalfEdge h) { return nodes[h->source()->data()]; };
  // Of several faults the leftmost is reported.
  std::optional<OverlapError> fault;
  for (const HalfEdge h : noded.map.halfedge_handles()) {
    const int ice = h->face()->data().ice;
    if ((ice == 0 || ice == 1) || (fault && fault->at <= from(h))) continue;
    fault = {ice > 1 ? "ice overlaps" : "there is no ice for a hole", from(h)};
  }
  if (fault) return tl::unexpected(*fault);
  return edges_with_ice(noded.map, nodes, [](HalfEdge h) { return sheet(h) > 0; });
}

Coverage coverage_of(const std::vector<Point>& nodes, const std::vector<NodedEdge>& edges) {
  NodedMap noded(nodes, edges);
  cover_faces(noded.map, &FaceLabel::ice, sheet);
  Coverage coverage;
  for (const HalfEdge h : noded.map.halfedge_handles())
    if (const int times = h->face()->data().ice; times != 0)
      coverage.twice_areas[times] += exact::cross(nodes[h->source()->data()], nodes[h->target()->data()]);
  coverage.boundary = edges_with_ice(
      noded.map, nodes, [](HalfEdge h) { return h->face()->data().ice > 0 && h->twin()->face()->data().ice <= 0; });
  return coverage;
}

}  // namespace brash::geometry
