#include "limes/subdiv/open_net.h"

#include <algorithm>
#include <utility>

#include "limes/core/error.h"
#include "limes/subdiv/crease.h"

namespace limes {
namespace {

/// Calls visit(edge, other end) for every edge at v, counter-clockwise.
template <class Visit>
void for_each_edge_at(const Adjacency& mesh, VertexId v, const Visit& visit) {
  const HalfedgeId start = mesh.ring_start(v);
  for (HalfedgeId h = start; h.valid();) {
    visit(mesh.edge(h), mesh.to(h));
    const HalfedgeId in = mesh.prev(h);
    h = mesh.twin(in);
    if (!h.valid()) visit(mesh.edge(in), mesh.from(in));
    if (h == start) break;
  }
}

}  // namespace

OpenNet::OpenNet(const Adjacency& mesh, const Features& features) : mesh_(&mesh) {
  find_curves(features);
  if (curve_.empty()) return;
  find_sectors();
  for (Sector& sector : sectors_)
    extrapolate(sector);
  build_net();
}

void OpenNet::find_curves(const Features& features) {
  const auto num_vertices = static_cast<std::size_t>(mesh_->topology().num_vertices());
  bool any = !features.edges.empty();
  for (int e = 0; e < mesh_->num_edges() && !any; ++e)
    any = mesh_->is_boundary(EdgeId(e));
  for (const SharpVertex& v : features.vertices)
    if (!is_infinite(v.sharpness))
      throw InputError(
          "corner {} has sharpness {}; vertices of an interpolating scheme are smooth or, from {} "
          "on, breakpoints",
          v.vertex.value, v.sharpness, infinite_sharpness);
  if (!any) return;

  curve_.resize(static_cast<std::size_t>(mesh_->num_edges()), 0);
  for (int e = 0; e < mesh_->num_edges(); ++e)
    curve_[EdgeId(e)] = mesh_->is_boundary(EdgeId(e)) ? 1 : 0;
  for (const SharpEdge& e : features.edges) {
    if (!is_infinite(e.sharpness))
      throw InputError(
          "crease {}-{} has sharpness {}; edges of an interpolating scheme are smooth or, from {} "
          "on, creases",
          mesh_->from(e.halfedge).value, mesh_->to(e.halfedge).value, e.sharpness,
          infinite_sharpness);
    curve_[mesh_->edge(e.halfedge)] = 1;
  }

  std::vector<int> count(num_vertices, 0);
  for (int e = 0; e < mesh_->num_edges(); ++e) {
    if (curve_[EdgeId(e)] == 0) continue;
    const HalfedgeId h = mesh_->halfedge(EdgeId(e));
    ++count[static_cast<std::size_t>(mesh_->from(h).value)];
    ++count[static_cast<std::size_t>(mesh_->to(h).value)];
  }
  for (int e = 0; e < mesh_->num_edges(); ++e) {
    const HalfedgeId h = mesh_->halfedge(EdgeId(e));
    const VertexId a = mesh_->from(h), b = mesh_->to(h);
    if (curve_[EdgeId(e)] != 0 && count[static_cast<std::size_t>(a.value)] == 1 &&
        count[static_cast<std::size_t>(b.value)] == 1)
      throw InputError(
          "crease {}-{} is a single edge inside the surface; a net cannot be cut along less than "
          "two",
          a.value, b.value);
  }
  breakpoint_.resize(num_vertices, 0);
  for (std::size_t v = 0; v < num_vertices; ++v)
    if (count[v] != 0 && count[v] != 2) breakpoint_.vector()[v] = 1;
  for (const SharpVertex& v : features.vertices)
    breakpoint_[v.vertex] = 1;
}

bool OpenNet::is_breakpoint(VertexId v) const {
  return breakpoint_[v] != 0;
}

VertexId OpenNet::next_on_curve(VertexId v, EdgeId edge) const {
  VertexId next;
  if (is_breakpoint(v)) return next;
  for_each_edge_at(*mesh_, v, [&](EdgeId e, VertexId other) {
    if (e != edge && curve_[e] != 0) next = other;
  });
  return next;
}

CurveEdge OpenNet::curve(HalfedgeId h) const {
  if (!on_curve(h)) return {};
  const EdgeId e = mesh_->edge(h);
  return {true, {next_on_curve(mesh_->from(h), e), next_on_curve(mesh_->to(h), e)}};
}

VertexId OpenNet::add_vertex(std::vector<Term> row) {
  rows_.push_back(std::move(row));
  return VertexId(std::int64_t{mesh_->topology().num_vertices()} +
                  static_cast<std::int64_t>(rows_.size()) - 1);
}

/// Every halfedge that runs along a curve, seen from its start, is the first of a sector. The first
/// sector at a vertex keeps it, the others get a copy.
void OpenNet::find_sectors() {
  const Topology& topology = mesh_->topology();
  corner_ = IdArray<HalfedgeId, VertexId>(
      std::vector<VertexId>(topology.corners().begin(), topology.corners().end()));
  IdArray<VertexId, char> has_sector(static_cast<std::size_t>(topology.num_vertices()), 0);
  for (int i = 0; i < topology.num_corners(); ++i) {
    Sector sector;
    sector.first = HalfedgeId(i);
    if (!on_curve(sector.first)) continue;
    sector.vertex = mesh_->from(sector.first);
    sector.copy =
        has_sector[sector.vertex] != 0 ? add_vertex({{sector.vertex, 1.0}}) : sector.vertex;
    has_sector[sector.vertex] = 1;
    for (HalfedgeId h = sector.first;; h = mesh_->twin(sector.last)) {
      corner_[h] = sector.copy;
      sector.last = mesh_->prev(h);
      if (on_curve(sector.last)) break;
    }
    sectors_.push_back(sector);
  }
}

void OpenNet::extrapolate(Sector& sector) {
  const VertexId p = sector.vertex;
  std::vector<VertexId> inner;
  for (HalfedgeId h = sector.first; mesh_->prev(h) != sector.last;) {
    h = mesh_->ring_next(h);
    inner.push_back(mesh_->to(h));
  }
  if (!inner.empty()) {
    std::vector<Term> row{{p, 2.0}};
    for (const VertexId q : inner)
      row.push_back({q, -1.0 / static_cast<double>(inner.size())});
    sector.over_first = sector.over_last = add_vertex(std::move(row));
    return;
  }
  const VertexId q = mesh_->to(sector.first), s = mesh_->from(sector.last);
  const VertexId r = mesh_->to(mesh_->next(sector.first));
  if (!is_breakpoint(p)) {
    sector.over_first = sector.over_last = add_vertex({{p, 2.0}, {r, -1.0}});
    return;
  }
  sector.over_first = add_vertex({{p, 2.0}, {s, -1.0}});
  sector.over_last = add_vertex({{p, 2.0}, {q, -1.0}});
  sector.between = add_vertex({{p, 3.0}, {q, -1.0}, {s, -1.0}});
}

void OpenNet::build_net() {
  // The sector that a halfedge of a curve reaches.
  IdArray<HalfedgeId, int> reaching(static_cast<std::size_t>(corner_.size()), -1);
  for (std::size_t i = 0; i < sectors_.size(); ++i)
    reaching[sectors_[i].last] = static_cast<int>(i);
  std::vector<VertexId> corners = corner_.vector();
  const auto add_face = [&](VertexId a, VertexId b, VertexId c, VertexId d) {
    corners.insert(corners.end(), {a, b, c, d});
  };
  for (const Sector& u : sectors_) {
    const Sector& v = sectors_[static_cast<std::size_t>(reaching[u.first])];
    add_face(v.copy, u.copy, u.over_first, v.over_last);
    if (u.between.valid()) add_face(u.copy, u.over_last, u.between, u.over_first);
  }
  topology_ = Topology(mesh_->topology().num_vertices() + static_cast<int>(rows_.size()), 4,
                       std::move(corners));
  net_.emplace(topology_, Adjacency::Check::edges);
}

void OpenNet::resolve(Stencil& stencil) const {
  if (rows_.empty()) return;
  const int num_vertices = mesh_->topology().num_vertices();
  const auto in_mesh = [&](std::int32_t id) { return id < num_vertices; };
  if (std::all_of(stencil.ids().begin(), stencil.ids().end(), in_mesh)) return;
  const auto row = [&](std::int32_t id) -> const std::vector<Term>& {
    return rows_[static_cast<std::size_t>(id - num_vertices)];
  };
  const auto is_plain = [&](const Stencil::Group& g) {
    const auto ids = stencil.ids(g);
    return std::all_of(ids.begin(), ids.end(),
                       [&](std::int32_t id) { return id < num_vertices || row(id).size() == 1; });
  };
  const bool plain = std::all_of(stencil.groups().begin(), stencil.groups().end(), is_plain);
  Stencil resolved;
  std::vector<VertexId> vertices;
  for (const Stencil::Group& g : stencil.groups()) {
    vertices.clear();
    for (const std::int32_t id : stencil.ids(g))
      if (plain)
        vertices.push_back(id < num_vertices ? VertexId(id) : row(id)[0].vertex);
      else if (id < num_vertices)
        resolved.add(g.weight, VertexId(id));
      else
        for (const Term& t : row(id))
          resolved.add(g.weight * t.weight, t.vertex);
    if (plain) resolved.add(g.weight, std::span<const VertexId>(vertices));
  }
  stencil = std::move(resolved);
}

}  // namespace limes
