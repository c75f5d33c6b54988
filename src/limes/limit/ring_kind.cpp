#include "limes/limit/ring_kind.h"

#include <utility>

#include "limes/core/error.h"
#include "limes/limit/corner_tangents.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/split.h"

namespace limes {
namespace {

/// Reads rows of the refinement of a ring, by child vertex.
class ChildRows {
 public:
  ChildRows(const Adjacency& adjacency, const RefinementStep& step)
      : adjacency_(adjacency), step_(step), walk_(step.walk()) {}

  /// Appends row `row` with the weights of a child vertex of the quadrisection.
  void append(int row, VertexId child, std::vector<Triplet>& out) {
    step_.stencil(walk_, child, stencil_);
    append_stencil_row(row, stencil_, adjacency_.topology(), out);
  }

 private:
  const Adjacency& adjacency_;
  const RefinementStep& step_;
  NeighbourhoodWalk walk_;
  Stencil stencil_;
};

/// Left eigenvector of A for the eigenvalue 1, from row `start` of A^k as k grows.
VectorX limit_row(const SparseMatrix& A, int start) {
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Unit(A.cols(), start);
  // The second eigenvalue is below 0.66 for every valence and scheme.
  for (int k = 0; k < 400; ++k) {
    const Eigen::RowVectorXd next = row * A;
    const double change = (next - row).cwiseAbs().maxCoeff();
    row = next;
    if (change < 1e-18) break;
  }
  return row.transpose() / row.sum();
}

/// Takes the limit position out of every row: D - (D 1) limit^T.
void deflate(PatchGrid& D, const VectorX& limit) {
  const VectorX sums = D.rowwise().sum();
  D.noalias() -= sums * limit.transpose();
}

}  // namespace

int RingKinds::size() const {
  const std::lock_guard lock(mutex_);
  return static_cast<int>(entries_.size());
}

int RingKinds::kind_of(Ring ring) const {
  std::string key = ring_key(ring);
  const std::lock_guard lock(mutex_);
  const auto [it, added] = index_.try_emplace(std::move(key), static_cast<int>(entries_.size()));
  if (!added) return it->second;
  RingKind& kind = entries_.append().kind;
  kind.ring = std::move(ring);
  kind.patch = regular_patch(kind.ring, scheme_->patch);
  return it->second;
}

const RefinedKind& RingKinds::refine(int kind) const {
  // Two threads may build the same; the first to come keeps its own, which are the same bits.
  auto built = std::make_unique<const RefinedKind>(build_refined(kind));
  Entry& at = entry(kind);
  const std::lock_guard lock(mutex_);
  if (!at.owned) {
    at.owned = std::move(built);
    at.refined.store(at.owned.get(), std::memory_order_release);
  }
  return *at.owned;
}

RefinedKind RingKinds::build_refined(int index) const {
  const RingKind& kind = (*this)[index];
  RefinedKind refined;
  const Adjacency adjacency(kind.ring.topology, Adjacency::Check::edges);
  const RefinementStep step(adjacency, kind.ring.features, *scheme_);
  const Topology child_topology = step.child_topology();
  const Features child_features = step.child_features();
  const Adjacency child_adjacency(child_topology, Adjacency::Check::edges);
  const Sharpness child_sharpness(child_adjacency, child_features);
  ChildRows rows(adjacency, step);
  const FaceRange children = descendants(kind.ring.topology, FaceId(0), scheme_->split, 1);
  for (std::int64_t child = children.begin; child < children.end; ++child) {
    Ring ring =
        gather_ring(child_adjacency, child_features, child_sharpness, *scheme_, FaceId(child));
    std::vector<Triplet> entries;
    for (int row = 0; row < ring.num_controls; ++row)
      rows.append(row, ring.vertices[static_cast<std::size_t>(row)], entries);
    SparseMatrix A(ring.num_controls, kind.ring.num_controls);
    A.setFromTriplets(entries.begin(), entries.end());
    refined.children.push_back({kind_of(std::move(ring)), std::move(A)});
  }
  refined.self_similar = refined.children[0].kind == index;
  if (refined.self_similar) {
    refined.limit = limit_row(refined.children[0].A, 0);
    refined.tangents = corner_tangents(kind.ring, scheme_->patch, refined.children[0].A);
  }
  return refined;
}

const Tile& RingKinds::tile(int kind, const std::string& path) const {
  const std::lock_guard lock(tile_mutex_);
  return tile_locked(kind, path);
}

const Tile& RingKinds::tile_locked(int kind, const std::string& path) const {
  auto& tiles = entry(kind).tiles;
  const auto found = tiles.find(path);
  if (found != tiles.end()) return *found->second;
  auto made = std::make_unique<Tile>(make_tile(kind, path));
  return *(tiles[path] = std::move(made));
}

Tile RingKinds::make_tile(int index, const std::string& path) const {
  const RingKind& kind = (*this)[index];
  if (path.empty()) {
    LIMES_ASSERT(kind.patch.has_value());
    Tile tile{*kind.patch, kind.patch->row(corner_row(scheme_->patch)).transpose()};
    tile.D.rowwise() -= tile.limit.transpose();
    return tile;
  }
  const RefinedKind& refined = this->refined(index);
  const RefinedKind::Child& child = refined.children[static_cast<std::size_t>(path[0])];
  const Tile& below = tile_locked(child.kind, path.substr(1));
  Tile tile{below.D * child.A, child.A.transpose() * below.limit};
  // Whatever the rows' sums are, they are rounding: products would keep them while D shrinks.
  if (!refined.self_similar) {
    tile.D.col(0) -= tile.D.rowwise().sum();
    return tile;
  }
  if (child.kind != index) tile.D.rowwise() += (tile.limit - refined.limit).transpose();
  deflate(tile.D, refined.limit);
  tile.limit = refined.limit;
  return tile;
}

}  // namespace limes
