#include "limes/subdiv/coarsen.h"
#include "limes/mesh/face_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/mesh/measure.h"
#include "limes/subdiv/coarsen_bound.h"
#include "limes/subdiv/coarsen_positions.h"
#include "limes/subdiv/coarsen_tags.h"
#include "limes/subdiv/crease.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/triangle_labels.h"

namespace limes {
namespace {

/// One way to read a component as a refined mesh.
struct Reading {
  int first_old;
  std::vector<VertexId> old_vertices;  // fine ids
  CoarsePositions positions;
  bool refused = false;  // by residual_bound(): no points, the residual is at least that large
};

class Coarsener {
 public:
  Coarsener(const Mesh& mesh, const CoarsenOptions& options)
      : mesh_(mesh),
        adjacency_(mesh.topology),
        features_(resolve_tags(adjacency_, mesh.tags, BoundaryRule::edges)),
        sharpness_(adjacency_, features_),
        labels_(adjacency_),
        triangle_origins_(static_cast<std::size_t>(mesh.topology.num_vertices()),
                          VertexOrigin::unknown),
        scheme_(find_scheme(options.scheme)),
        refine_(options.refine),
        size_(bounding_box(mesh).diagonal()),
        tolerance_(options.tolerance) {}

  CoarsenResult run() {
    require_possible();
    IdArray<VertexId, Vec3> old_points = mesh_.points;
    for (const auto& component : edge_components(adjacency_)) {
      check_interrupt();
      const Reading reading = read(component);
      (void)label(component, reading.first_old);  // the one that was found possible
      for (std::size_t i = 0; i < reading.old_vertices.size(); ++i)
        old_points[reading.old_vertices[i]] = reading.positions.points[i];
      result_.residual = std::max(result_.residual, reading.positions.residual);
    }
    assemble(old_points);
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool of_triangles() const { return scheme_.split == Split::triangles; }
  [[nodiscard]] std::string label(const std::vector<FaceId>& component, int first) {
    return of_triangles() ? label_triangles(adjacency_, component, first, triangle_origins_)
                          : labels_.label(component, first);
  }
  [[nodiscard]] const VertexOrigins& origins() const {
    return of_triangles() ? triangle_origins_ : labels_.origins();
  }
  [[nodiscard]] Unsplit unsplit_faces(const std::vector<FaceId>& faces, bool all_vertices) const {
    return of_triangles() ? unsplit_triangles(adjacency_, origins(), faces, all_vertices)
                          : unsplit(adjacency_, origins(), faces, all_vertices);
  }

  void require_possible() const {
    const Topology& t = mesh_.topology;
    bool boundary = false;
    for (int f = 0; f < t.num_faces(); ++f) {
      if (t.face_size(FaceId(f)) != (of_triangles() ? 3 : 4))
        throw FaceError(FaceId(f), "face {} has {} corners; a step of {} leaves {} only", f,
                        t.face_size(FaceId(f)), scheme_.name,
                        of_triangles() ? "triangles" : "quads");
      for (const VertexId v : t.face(FaceId(f)))
        boundary = boundary || adjacency_.is_boundary(v);
    }
    if (boundary && scheme_.boundary == Boundary::creases &&
        mesh_.tags.boundary == BoundaryRule::none)
      throw InputError(
          "the boundary rule is none: the faces that shaped the boundary are not in the mesh");
  }

  /// The best reading of a component: corner 0 of its first face old, as refine() numbers it, if
  /// that fits, else the one (of triangles the fourth has the first face in the middle) that the positions fit best.
  Reading read(const std::vector<FaceId>& component) {
    std::optional<Reading> best;
    std::array<std::string, 4> reasons;
    for (int first_old = 0; first_old < 4; ++first_old) {
      auto& reason = reasons[static_cast<std::size_t>(first_old)];
      reason = label(component, first_old);
      if (!reason.empty()) continue;
      auto reading = try_reading(component, first_old, reason);
      if (!reading) continue;
      const double found = reading->positions.residual;
      if (best && found >= 0.1 * best->positions.residual) continue;
      best = std::move(reading);
      if (found <= 1e-13 * size_) break;
    }
    if (!best)
      throw InputError("face {} and those around it are not refined: {}", component.front().value,
                       reasons[0]);
    require_fit(*best);
    return std::move(*best);
  }

  std::optional<Reading> try_reading(const std::vector<FaceId>& component, int first_old,
                                     std::string& reason) const {
    try {
      Unsplit coarse = unsplit_faces(component, false);
      const Adjacency adjacency(coarse.topology);
      const CoarseTags tags = coarse_tags(coarse, adjacency);
      reason = tags.misfit;
      if (!reason.empty()) return {};
      if (scheme_.interpolatory) {
        CoarsePositions positions = keep_positions(coarse, adjacency, tags.tags);
        return Reading{first_old, std::move(coarse.old_vertex), std::move(positions), false};
      }
      const Features features = resolve_tags(adjacency, tags.tags, boundary_rule());
      const ResidualBound bound = of_triangles() ? ResidualBound{}
                                                 : residual_bound(adjacency_, coarse, adjacency,
                                                                  features, mesh_.points.span());
      if (bound.distance > tolerance_ * size_)
        return Reading{first_old, {}, {{}, bound.distance, bound.worst, true}, true};
      CoarsePositions positions =
          solve_positions(adjacency_, coarse, adjacency, features, scheme_, mesh_.points.span());
      return Reading{first_old, std::move(coarse.old_vertex), std::move(positions), false};
    } catch (const InputError& error) {  // the coarse faces would make no surface
      reason = error.what();
      return {};
    }
  }

  [[nodiscard]] CoarsePositions keep_positions(const Unsplit& coarse, const Adjacency& adjacency,
                                               const Tags& tags) const {
    Mesh old;  // what control_features() looks at
    old.tags = tags;
    for (const VertexId v : coarse.old_vertex)
      old.points.push_back(mesh_.points[v]);
    const Features features = control_features(adjacency, old, scheme_, refine_);
    return kept_positions(adjacency_, coarse, adjacency, features, scheme_, mesh_.points.span());
  }

  void require_fit(const Reading& reading) const {
    const CoarsePositions& p = reading.positions;
    if (!(p.residual <= tolerance_ * size_))
      throw InputError(
          "not a refined mesh: vertex {} is {}{:.2g} away from where refinement would put it, "
          "{:.2g} of the diagonal (creases of sharpness 1 or less cannot be undone)",
          p.worst.value, reading.refused ? "at least " : "", p.residual, p.residual / size_);
    if (p.unique) return;
    std::vector<int> names;
    for (const VertexId v : reading.old_vertices)
      if (names.size() < 8) names.push_back(v.value);
    throw InputError(
        "the old positions of vertices {}{} are not unique: every vertex has three edges and every "
        "loop of edges is even, so moving them by +d and -d in turn leaves no trace after a step",
        fmt::join(names, ", "), reading.old_vertices.size() > names.size() ? ", ..." : "");
  }

  [[nodiscard]] BoundaryRule boundary_rule() const {
    return mesh_.tags.boundary.value_or(BoundaryRule::edges);
  }

  [[nodiscard]] CoarseTags coarse_tags(const Unsplit& coarse, const Adjacency& adjacency) const {
    CoarseTags result =
        coarsen_tags(adjacency_, features_, sharpness_, origins(), coarse, adjacency);
    result.tags.smooth_triangles = mesh_.tags.smooth_triangles;
    result.tags.boundary = mesh_.tags.boundary;
    if (mesh_.tags.boundary != BoundaryRule::edges_and_corners) return result;
    // refine() writes down the corners that this rule makes; they need no tag of their own
    std::erase_if(result.tags.corners, [&](const CornerTag& c) {
      return is_infinite(c.sharpness) && adjacency.is_boundary(c.vertex) &&
             adjacency.num_ring_faces(c.vertex) == 1;
    });
    return result;
  }

  void assemble(const IdArray<VertexId, Vec3>& old_points) {
    std::vector<FaceId> all;
    for (int f = 0; f < mesh_.topology.num_faces(); ++f)
      all.emplace_back(f);
    const Unsplit coarse = unsplit_faces(all, true);
    Mesh& out = result_.mesh;
    out.topology = coarse.topology;
    for (const VertexId v : coarse.old_vertex)
      out.points.push_back(old_points[v]);
    CoarseTags tags = coarse_tags(coarse, Adjacency(out.topology));
    LIMES_ASSERT(tags.misfit.empty());
    out.tags = std::move(tags.tags);
    if (!tags.remark.empty()) result_.remarks.push_back(tags.remark);
    out.tags.holes = shared_faces(coarse, mesh_.tags.holes, "hole tags", Partial::leave_out);
    for (const FaceGroup& g : mesh_.groups)
      out.groups.push_back({g.name, shared_faces(coarse, g.faces, fmt::format("group {}", g.name),
                                                 Partial::leave_out)});
    for (const FaceGroup& p : mesh_.parts)
      out.parts.push_back({p.name, shared_faces(coarse, p.faces, fmt::format("part {}", p.name),
                                                Partial::follow_first)});
  }

  /// What happens to a coarse face if a set holds only some of its children: it is left out, or goes
  /// with its first child.
  enum class Partial { leave_out, follow_first };

  /// Coarse faces whose children are all in a set.
  std::vector<FaceId> shared_faces(const Unsplit& coarse, const std::vector<FaceId>& fine,
                                   const std::string& what, Partial rule) {
    std::vector<bool> in(static_cast<std::size_t>(mesh_.topology.num_faces()), false);
    for (const FaceId f : fine)
      in[static_cast<std::size_t>(f.value)] = true;
    std::vector<FaceId> result;
    int split = 0;
    for (int f = 0; f < coarse.topology.num_faces(); ++f) {
      const int n = coarse.topology.face_size(FaceId(f));
      int count = 0;
      for (int i = 0; i < n; ++i)
        count += in[child(coarse, f, i)] ? 1 : 0;
      const bool chosen = rule == Partial::leave_out ? count == n : in[child(coarse, f, 0)];
      if (chosen) result.emplace_back(f);
      if (count > 0 && count < n) ++split;
    }
    if (split > 0)
      result_.remarks.push_back(
          fmt::format("{}: {} coarse faces have children inside and outside", what, split));
    return result;
  }

  static std::size_t child(const Unsplit& coarse, int f, int i) {
    return static_cast<std::size_t>(coarse.child[coarse.topology.halfedge(FaceId(f), i)].value);
  }

  const Mesh& mesh_;
  Adjacency adjacency_;
  Features features_;
  Sharpness sharpness_;
  QuadrisectionLabels labels_;      // of quads
  VertexOrigins triangle_origins_;  // of triangles
  const Scheme& scheme_;
  RefineOptions refine_;
  double size_, tolerance_;
  CoarsenResult result_{{}, 0.0, {}};
};

}  // namespace

CoarsenResult coarsen(const Mesh& mesh, const CoarsenOptions& options) {
  const Scheme& scheme = find_scheme(options.scheme);
  const bool solved = scheme.name == "catmull-clark" || scheme.name == "loop";
  if (!solved && !(scheme.interpolatory && is_quadrisection(scheme.split)))
    throw UsageError("coarsening undoes catmull-clark, loop and interpolatory schemes, not {}",
                     scheme.name);
  return Coarsener(mesh, options).run();
}

}  // namespace limes
