#include "limes/subdiv/forest_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "limes/core/error.h"
#include "limes/subdiv/crease.h"
#include "limes/subdiv/split_sides.h"

namespace limes {
namespace {

/// Collects the faces of the mesh, with vertices of the forest.
class Pieces {
 public:
  void add(FaceId leaf, std::initializer_list<VertexId> corners) {
    corners_.insert(corners_.end(), corners);
    offsets_.push_back(static_cast<int>(corners_.size()));
    leaves_.push_back(leaf);
  }
  [[nodiscard]] const std::vector<VertexId>& corners() const { return corners_; }
  [[nodiscard]] const std::vector<int>& offsets() const { return offsets_; }
  [[nodiscard]] const std::vector<FaceId>& leaves() const { return leaves_; }

 private:
  std::vector<VertexId> corners_;
  std::vector<int> offsets_{0};
  std::vector<FaceId> leaves_;
};

/// A leaf's corners and the middles of its split sides, from corner number `first` on.
struct Turned {
  std::array<VertexId, 4> v, e;
};

Turned turned(std::span<const VertexId> corners, const std::array<VertexId, 4>& middles,
              int first) {
  Turned t;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    t.v[i] = corners[(i + static_cast<std::size_t>(first)) % corners.size()];
    t.e[i] = middles[(i + static_cast<std::size_t>(first)) % corners.size()];
  }
  return t;
}

/// The pattern of split sides turned so that it is the smallest number, and by how many corners.
std::pair<SideMask, int> turned_pattern(SideMask mask, unsigned size) {
  const SideMask all = (1U << size) - 1;
  std::pair<SideMask, int> best{mask, 0};
  for (unsigned k = 1; k < size; ++k)
    best = std::min(best, {((mask >> k) | (mask << (size - k))) & all, static_cast<int>(k)});
  return best;
}

/// @param centre  of the leaf; only for two adjacent and for four split sides
void cut_into_quads(FaceId leaf, const QuadCorners& corners, const ChildNodes& nodes, SideMask mask,
                    Pieces& out) {
  const auto [pattern, first] = turned_pattern(mask, 4);
  const auto [v, e] = turned(corners, nodes.sides, first);
  const VertexId c = nodes.centre;
  switch (pattern) {
    case 0b0000:
      return out.add(leaf, {v[0], v[1], v[2], v[3]});
    case 0b0101:
      out.add(leaf, {v[0], e[0], e[2], v[3]});
      return out.add(leaf, {e[0], v[1], v[2], e[2]});
    case 0b0011:  // a Y at corner 1
      out.add(leaf, {v[1], e[1], c, e[0]});
      out.add(leaf, {e[1], v[2], v[3], c});
      return out.add(leaf, {c, v[3], v[0], e[0]});
    case 0b1111:
      for (std::size_t i = 0; i < 4; ++i)
        out.add(leaf, {v[i], e[i], c, e[(i + 3) % 4]});
      return;
    default:
      LIMES_ASSERT(false);
  }
}

void cut_with_triangles(FaceId leaf, const QuadCorners& corners,
                        const std::array<VertexId, 4>& middles, SideMask mask, Pieces& out) {
  const auto [pattern, first] = turned_pattern(mask, 4);
  const auto [v, e] = turned(corners, middles, first);
  switch (pattern) {
    case 0b0000:
      return out.add(leaf, {v[0], v[1], v[2], v[3]});
    case 0b0001:
      out.add(leaf, {v[0], e[0], v[3]});
      out.add(leaf, {e[0], v[1], v[2]});
      return out.add(leaf, {e[0], v[2], v[3]});
    case 0b0101:
      out.add(leaf, {v[0], e[0], e[2], v[3]});
      return out.add(leaf, {e[0], v[1], v[2], e[2]});
    case 0b0011:
      out.add(leaf, {e[0], v[1], e[1]});
      out.add(leaf, {v[0], e[0], v[3]});
      out.add(leaf, {e[0], e[1], v[3]});
      return out.add(leaf, {e[1], v[2], v[3]});
    case 0b0111:
      out.add(leaf, {e[0], v[1], e[1]});
      out.add(leaf, {e[1], v[2], e[2]});
      out.add(leaf, {e[0], e[1], e[2]});
      return out.add(leaf, {v[0], e[0], e[2], v[3]});
    case 0b1111:
      for (std::size_t i = 0; i < 4; ++i)
        out.add(leaf, {v[i], e[i], e[(i + 3) % 4]});
      return out.add(leaf, {e[0], e[1], e[2], e[3]});
    default:
      LIMES_ASSERT(false);
  }
}

/// Red-green refinement [bank_sherman_weiser_1983]: green triangles, which may be thin, are not split
/// again, since they are no leaves.
void cut_into_triangles(const ForestNodes& nodes, FaceId leaf, std::span<const VertexId> corners,
                        const std::array<VertexId, 4>& middles, SideMask mask, Pieces& out) {
  const auto [pattern, first] = turned_pattern(mask, 3);
  const auto [v, e] = turned(corners, middles, first);
  const auto length = [&](VertexId a, VertexId b) {
    return (nodes.position(a) - nodes.position(b)).norm();
  };
  switch (pattern) {
    case 0b000:
      return out.add(leaf, {v[0], v[1], v[2]});
    case 0b001:
      out.add(leaf, {v[0], e[0], v[2]});
      return out.add(leaf, {e[0], v[1], v[2]});
    case 0b011: {
      out.add(leaf, {e[0], v[1], e[1]});
      // What rounding makes of equal lengths does not matter.
      const bool from_middle = length(e[0], v[2]) <= (1 + 1e-9) * length(v[0], e[1]);
      out.add(leaf, {v[0], e[0], from_middle ? v[2] : e[1]});
      return out.add(leaf, {from_middle ? e[0] : v[0], e[1], v[2]});
    }
    case 0b111:
      for (std::size_t i = 0; i < 3; ++i)
        out.add(leaf, {v[i], e[i], e[(i + 2) % 3]});
      return out.add(leaf, {e[0], e[1], e[2]});
    default:
      LIMES_ASSERT(false);
  }
}

void close_with_quads(Forest& forest, const std::vector<FaceId>& leaves,
                      std::vector<SideMask>& masks, Pieces& out) {
  add_sides_for_quads(forest, leaves, masks);
  std::vector<FaceId> cut;
  for (std::size_t i = 0; i < leaves.size(); ++i)
    if (masks[i] != 0) cut.push_back(leaves[i]);
  const std::vector<ChildNodes> nodes = forest.child_nodes(cut);
  std::size_t k = 0;
  for (std::size_t i = 0; i < leaves.size(); ++i)
    cut_into_quads(leaves[i], forest.quad(leaves[i]), masks[i] != 0 ? nodes[k++] : ChildNodes(),
                   masks[i], out);
}

std::array<VertexId, 4> middles_of(const Forest& forest, FaceId leaf, SideMask mask) {
  const auto v = forest.corners(leaf);
  std::array<VertexId, 4> middles;
  for (unsigned i = 0; i < v.size(); ++i)
    if ((mask & (1U << i)) != 0) middles[i] = forest.nodes().middle(v[i], v[(i + 1) % v.size()]);
  return middles;
}

/// Numbers of the mesh's vertices for those of the forest: the control mesh's first, as they are.
class Numbering {
 public:
  explicit Numbering(const Forest& forest)
      : number_(static_cast<std::size_t>(forest.nodes().size())) {
    for (int v = 0; v < forest.control().topology.num_vertices(); ++v)
      (void)of(VertexId(v));
  }
  VertexId of(VertexId node) {
    VertexId& v = number_[node];
    if (!v.valid()) {
      v = VertexId(nodes_.size());
      nodes_.push_back(node);
    }
    return v;
  }
  [[nodiscard]] const std::vector<VertexId>& nodes() const { return nodes_; }

 private:
  IdArray<VertexId, VertexId> number_;
  std::vector<VertexId> nodes_;
};

/// Cuts every leaf where its neighbours are split, or for vertices that hang leaves it as it is.
void cut_each(const Forest& forest, const std::vector<FaceId>& leaves,
              const std::vector<SideMask>& masks, Closure closure, Pieces& out) {
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const SideMask mask = closure == Closure::hanging ? 0U : masks[i];
    const std::array<VertexId, 4> middles = middles_of(forest, leaves[i], mask);
    if (forest.face_size() == 3)
      cut_into_triangles(forest.nodes(), leaves[i], forest.corners(leaves[i]), middles, mask, out);
    else
      cut_with_triangles(leaves[i], forest.quad(leaves[i]), middles, mask, out);
  }
}

std::vector<HangingVertex> hanging_vertices(const Forest& forest, const std::vector<FaceId>& leaves,
                                            const std::vector<SideMask>& masks,
                                            Numbering& numbering) {
  std::vector<HangingVertex> hanging;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const auto v = forest.corners(leaves[i]);
    const std::array<VertexId, 4> middles = middles_of(forest, leaves[i], masks[i]);
    for (std::size_t k = 0; k < v.size(); ++k)
      if (middles[k].valid())
        hanging.push_back(
            {numbering.of(middles[k]), {numbering.of(v[k]), numbering.of(v[(k + 1) % v.size()])}});
  }
  std::sort(hanging.begin(), hanging.end(),
            [](const HangingVertex& a, const HangingVertex& b) { return a.vertex < b.vertex; });
  return hanging;
}

std::vector<FaceGroup> handed_down(const std::vector<FaceGroup>& groups,
                                   const std::vector<std::vector<FaceId>>& faces_of_root) {
  std::vector<FaceGroup> all;
  for (const FaceGroup& g : groups) {
    FaceGroup& made = all.emplace_back();
    made.name = g.name;
    for (const FaceId root : g.faces) {
      const auto& faces = faces_of_root[static_cast<std::size_t>(root.value)];
      made.faces.insert(made.faces.end(), faces.begin(), faces.end());
    }
  }
  return all;
}

void hand_down_names(const Forest& forest, const Pieces& pieces, Mesh& mesh) {
  const Mesh& control = forest.control();
  std::vector<std::vector<FaceId>> faces(static_cast<std::size_t>(control.topology.num_faces()));
  for (std::size_t f = 0; f < pieces.leaves().size(); ++f)
    faces[static_cast<std::size_t>(forest.ancestry(pieces.leaves()[f]).root.value)].push_back(
        FaceId(f));
  mesh.groups = handed_down(control.groups, faces);
  mesh.parts = handed_down(control.parts, faces);
  for (const FaceId hole : control.tags.holes) {
    const auto& below = faces[static_cast<std::size_t>(hole.value)];
    mesh.tags.holes.insert(mesh.tags.holes.end(), below.begin(), below.end());
  }
}

void hand_down_tags(const Forest& forest, const Pieces& pieces, const std::vector<VertexId>& nodes,
                    Mesh& mesh) {
  const Tags& control = forest.control().tags;
  mesh.tags.boundary = control.boundary;
  mesh.tags.crease_method = control.crease_method;
  mesh.tags.smooth_triangles = control.smooth_triangles;
  IdArray<VertexId, float> corner(nodes.size(), 0.0F);
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const int level = forest.ancestry(pieces.leaves()[static_cast<std::size_t>(f)]).level;
    const auto face = mesh.topology.face(FaceId(f));
    for (std::size_t i = 0; i < face.size(); ++i) {
      const VertexId a = face[i], b = face[(i + 1) % face.size()];
      const VertexId from = nodes[static_cast<std::size_t>(a.value)];
      corner[a] = std::max(corner[a], forest.nodes().vertex_sharpness(level, from));
      const float s = forest.nodes().edge_sharpness(from, nodes[static_cast<std::size_t>(b.value)]);
      if (s > 0 && a < b) mesh.tags.creases.push_back({a, b, s});
    }
  }
  for (std::size_t v = 0; v < nodes.size(); ++v)
    if (corner[VertexId(v)] > 0) mesh.tags.corners.push_back({VertexId(v), corner[VertexId(v)]});
}

void add_ancestry(const Forest& forest, const Pieces& pieces, Mesh& mesh) {
  mesh.face_fields = {{"root", {}}, {"level", {}}, {"path", {}}};
  for (const FaceId leaf : pieces.leaves()) {
    const FaceAncestry a = forest.ancestry(leaf);
    mesh.face_fields[0].values.push_back(a.root.value);
    mesh.face_fields[1].values.push_back(a.level);
    mesh.face_fields[2].values.push_back(a.path);
  }
}

}  // namespace

ForestMesh forest_mesh(Forest& forest, Closure closure) {
  const std::vector<FaceId> leaves = forest.leaves();
  std::vector<SideMask> masks = sides_of_split_neighbours(forest, leaves);
  Pieces pieces;
  ForestMesh made;
  const bool by_quads = closure == Closure::conforming && forest.face_size() == 4;
  if (by_quads)
    close_with_quads(forest, leaves, masks, pieces);
  else
    cut_each(forest, leaves, masks, closure, pieces);
  Numbering numbering(forest);
  std::vector<VertexId> corners;
  corners.reserve(pieces.corners().size());
  for (const VertexId node : pieces.corners())
    corners.push_back(numbering.of(node));
  for (const VertexId node : numbering.nodes())
    made.mesh.points.push_back(forest.nodes().position(node));
  const int num_vertices = made.mesh.points.size();
  const bool mixed = closure == Closure::triangles && forest.face_size() == 4;
  made.mesh.topology = mixed ? Topology(num_vertices, pieces.offsets(), std::move(corners))
                             : Topology(num_vertices, forest.face_size(), std::move(corners));
  hand_down_names(forest, pieces, made.mesh);
  hand_down_tags(forest, pieces, numbering.nodes(), made.mesh);
  add_ancestry(forest, pieces, made.mesh);
  made.leaves = pieces.leaves();
  made.nodes = numbering.nodes();
  if (closure == Closure::hanging)
    made.hanging = hanging_vertices(forest, leaves, masks, numbering);
  return made;
}

}  // namespace limes
