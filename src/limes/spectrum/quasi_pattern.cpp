#include "limes/spectrum/quasi_pattern.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "limes/core/error.h"
#include "limes/spectrum/pattern_code.h"
#include "limes/spectrum/star.h"
#include "limes/subdiv/drop_faces.h"
#include "limes/subdiv/edge_choice.h"
#include "limes/subdiv/quasi_smoothing.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

constexpr VertexId middle(0);
/// So often must a pattern come back.
constexpr int times = 3;

/// Only the faces of so many rings around the middle; numbers stay in order, the middle is 0.
Mesh cut_back(const Mesh& mesh, int rings) {
  const IdArray<VertexId, int> ring = rings_around(mesh.topology, middle, rings);
  std::vector<bool> drop(static_cast<std::size_t>(mesh.topology.num_faces()));
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const auto corners = mesh.topology.face(FaceId(f));
    drop[static_cast<std::size_t>(f)] =
        std::any_of(corners.begin(), corners.end(), [&](VertexId v) { return ring[v] > rings; });
  }
  return without_faces(mesh, drop);
}

/// The middle to the origin and the farthest vertex to a distance between 1/2 and 1: lengths keep their
/// order and their bits, but for the rounding of the shift.
void recentre(Mesh& mesh) {
  const Vec3 origin = mesh.points[middle];
  double reach = 0;
  for (Vec3& x : mesh.points) {
    x -= origin;
    reach = std::max(reach, x.norm());
  }
  int exponent = 0;
  std::frexp(reach, &exponent);
  for (Vec3& x : mesh.points)
    x *= std::ldexp(1.0, -exponent);
}

/// The mesh around the middle after some passes, and what the next one will do.
class Passes {
 public:
  Passes(const Mesh& mesh, const PatternOptions& options) : options_(options) { keep(mesh); }

  [[nodiscard]] int valence() const { return adjacency_->valence(middle); }
  [[nodiscard]] std::vector<int> code() const {
    return pattern_code(*adjacency_, middle, to_split_, options_.rings);
  }
  void advance() {
    Bisection step = bisect(*adjacency_, to_split_, FirstCorner::kept);
    Mesh fine;
    fine.points.resize(static_cast<std::size_t>(step.child.num_vertices()));
    quasi_smoothing(*adjacency_, step, {}, {}, mesh_.points.span(), fine.points.span());
    fine.topology = std::move(step.child);
    keep(fine);
  }

 private:
  void keep(const Mesh& mesh) {
    mesh_ = cut_back(mesh, options_.kept_rings);
    recentre(mesh_);
    adjacency_.emplace(mesh_.topology, Adjacency::Check::edges);
    to_split_ = longest_edges(*adjacency_, mesh_.points.span());
  }

  PatternOptions options_;
  Mesh mesh_;
  std::optional<Adjacency> adjacency_;  // of mesh_
  std::vector<EdgeId> to_split_;
};

std::vector<int> regular_code(int valence, int rings) {
  const Star star = control_star(find_scheme("quasi-four-eight"), valence, rings, {});
  const Adjacency adjacency(star.topology, Adjacency::Check::edges);
  return pattern_code(adjacency, middle, newest_vertex_edges(adjacency), rings);
}

/// The first place from which a sequence is to its end what it was a period before.
int start_of_period(const std::vector<std::vector<int>>& codes, int period) {
  int first = static_cast<int>(codes.size()) - period;
  const auto at = [&](int i) -> const auto& {
    return codes[static_cast<std::size_t>(i)];
  };
  while (first > 0 && at(first - 1) == at(first - 1 + period))
    --first;
  return first;
}

}  // namespace

QuasiPattern quasi_pattern(const Mesh& mesh, const PatternOptions& options) {
  LIMES_ASSERT(options.rings < options.kept_rings && options.num_passes >= 0);
  Passes passes(mesh, options);
  std::vector<std::vector<int>> codes{passes.code()};
  for (int pass = 1; pass <= options.num_passes; ++pass) {
    passes.advance();
    codes.push_back(passes.code());
  }
  QuasiPattern pattern;
  pattern.valence = passes.valence();
  const int count = static_cast<int>(codes.size());
  for (int period = 1; period * times < count && !pattern.repeats_after; ++period) {
    const int first = start_of_period(codes, period);
    if (count - first <= period * times) continue;
    pattern.repeats_after = first;
    pattern.period = period;
  }
  pattern.regular = pattern.period == 1 &&
                    has_valence(find_scheme("quasi-four-eight"), pattern.valence) &&
                    codes.back() == regular_code(pattern.valence, options.rings);
  return pattern;
}

}  // namespace limes
