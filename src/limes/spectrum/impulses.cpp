#include "limes/spectrum/impulses.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "limes/core/error.h"

namespace limes {
namespace {

/// The vertices within so many edges of one.
class Ball {
 public:
  explicit Ball(const Adjacency& mesh)
      : mesh_(&mesh), mark_(static_cast<std::size_t>(mesh.topology().num_vertices()), -1) {}

  const std::vector<VertexId>& around(VertexId centre, int distance) {
    found_ = {centre};
    mark_[centre] = centre.value;
    std::size_t begin = 0;
    for (int d = 0; d < distance; ++d)
      for (const std::size_t end = found_.size(); begin < end; ++begin)
        add_neighbours(found_[begin], centre.value);
    return found_;
  }

 private:
  void add(VertexId v, int mark) {
    if (mark_[v] == mark) return;
    mark_[v] = mark;
    found_.push_back(v);
  }
  void add_neighbours(VertexId v, int mark) {
    const HalfedgeId start = mesh_->ring_start(v);
    HalfedgeId h = start;
    do {
      add(mesh_->to(h), mark);
      add(mesh_->from(mesh_->prev(h)), mark);
      h = mesh_->ring_next(h);
    } while (h.valid() && h != start);
  }

  const Adjacency* mesh_;
  IdArray<VertexId, int> mark_;
  std::vector<VertexId> found_;
};

/// Vertices of one colour are more than `distance` edges apart.
std::vector<std::vector<VertexId>> colour_classes(const Adjacency& mesh, int distance) {
  Ball ball(mesh);
  IdArray<VertexId, int> colour(static_cast<std::size_t>(mesh.topology().num_vertices()), -1);
  std::vector<std::vector<VertexId>> classes;
  std::vector<bool> taken;
  for (int v = 0; v < mesh.topology().num_vertices(); ++v) {
    if (!mesh.ring_start(VertexId(v)).valid()) continue;
    taken.assign(classes.size() + 1, false);
    for (const VertexId w : ball.around(VertexId(v), distance))
      if (colour[w] >= 0) taken[static_cast<std::size_t>(colour[w])] = true;
    const auto free = std::find(taken.begin(), taken.end(), false) - taken.begin();
    if (static_cast<std::size_t>(free) == classes.size()) classes.emplace_back();
    colour[VertexId(v)] = static_cast<int>(free);
    classes[static_cast<std::size_t>(free)].push_back(VertexId(v));
  }
  return classes;
}

}  // namespace

SparseMatrix matrix_of_action(
    const Adjacency& mesh, int distance, int num_results,
    const std::function<void(std::span<const Vec3>, std::span<Vec3>)>& act) {
  const int num_vertices = mesh.topology().num_vertices();
  std::vector<Vec3> impulses(static_cast<std::size_t>(num_vertices)),
      results(static_cast<std::size_t>(num_results));
  std::vector<Triplet> entries;
  for (const std::vector<VertexId>& vertices : colour_classes(mesh, distance)) {
    std::fill(impulses.begin(), impulses.end(), Vec3::Zero());
    for (const VertexId v : vertices) {
      const double name = v.value + 1;
      impulses[static_cast<std::size_t>(v.value)] = Vec3(1, name, name * name);
    }
    act(impulses, results);
    for (int row = 0; row < num_results; ++row) {
      const Vec3& r = results[static_cast<std::size_t>(row)];
      if (r[0] == 0) continue;
      const double name = r[1] / r[0];
      LIMES_ASSERT(std::abs(r[2] / r[0] - name * name) < 1e-6 * name * name);  // one impulse only
      entries.emplace_back(row, static_cast<int>(std::lround(name)) - 1, r[0]);
    }
  }
  SparseMatrix matrix(num_results, num_vertices);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace limes
