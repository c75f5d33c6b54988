#include "limes/spectrum/rules.h"

#include <algorithm>
#include <cmath>

#include "limes/mesh/shapes.h"
#include "limes/spectrum/rule_site.h"

namespace limes {
namespace {

constexpr double equal = 1e-12;
/// Edges of a lattice around the middle: more than a rule and the steps before it see.
constexpr int lattice_reach = 8;

bool is_dual(const Scheme& scheme) {
  return scheme.split == Split::dual || scheme.split == Split::mid_edge;
}

bool is_four_eight(const Scheme& scheme) {
  return scheme.split == Split::four_eight || scheme.split == Split::longest_edges;
}

std::vector<double> sorted_weights(const std::vector<RuleWeight>& weights) {
  std::vector<double> sorted;
  for (const RuleWeight& w : weights)
    sorted.push_back(w.weight);
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

/// Equal weights, wherever they are: turned and mirrored rules are the same.
bool same_weights(const std::vector<RuleWeight>& a, const std::vector<RuleWeight>& b) {
  const std::vector<double> x = sorted_weights(a), y = sorted_weights(b);
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [](double s, double t) { return std::abs(s - t) < equal; });
}

/// Rules that differ, each with the steps in which it occurs.
class RuleCollection {
 public:
  explicit RuleCollection(const Scheme& scheme, double tension)
      : scheme_(&scheme), tension_(tension) {}

  /// The rules at the middle vertex of a lattice; what is as on the plane is left out elsewhere.
  void add(const Lattice& lattice, Rule::Place place) {
    for (int step = first_step(); step < first_step() + num_different_steps(*scheme_); ++step) {
      const RuleSite site(*scheme_, lattice, tension_, step);
      std::vector<VertexId> middles{lattice.middle};
      // The regular mesh has vertices of two kinds.
      if (is_four_eight(*scheme_) && place == Rule::Place::regular)
        middles.push_back(site.adjacency().to(site.adjacency().ring_start(lattice.middle)));
      for (const VertexId middle : middles) {
        for (const VertexId child : site.children_around(middle))
          add(on_lattice(site, child, middle, place), step + 1);
        if (place == Rule::Place::regular) add_mask(site, middle, step + 1);
      }
    }
  }

  /// Those around the middle of a star.
  void add(const LocalSubdivision& local) {
    const RuleSite site(*scheme_, local.star());
    const HalfedgeId spoke = local.walk().first_spoke();
    const std::vector<VertexId> children =
        local.star().around_face ? site.children_in(local.walk().adjacency().face(spoke))
                                 : site.children_around(local.walk().adjacency().from(spoke));
    std::vector<StarPlace> places(static_cast<std::size_t>(local.star().topology.num_vertices()),
                                  {-1, 0, 0});
    for (std::size_t i = 0; i < local.places().size(); ++i)
      places[static_cast<std::size_t>(local.vertices()[i].value)] = local.places()[i];
    for (const VertexId child : children) {
      Rule rule{Rule::Place::star, site.source(child).kind, {}, {}, {}};
      for (SparseMatrix::InnerIterator entry(site.matrix(), child.value); entry; ++entry)
        if (entry.value() != 0)
          rule.weights.push_back(
              {Vec2::Zero(), places[static_cast<std::size_t>(entry.col())], entry.value()});
      std::sort(rule.weights.begin(), rule.weights.end(),
                [](const RuleWeight& a, const RuleWeight& b) { return a.place < b.place; });
      add(std::move(rule), local.star().options.level + 1);
    }
  }

  /// The vertex that a single face with n corners gets.
  void add_polygon(int n) {
    Star star;
    Mesh polygon = shapes::polygon(n);
    star.topology = std::move(polygon.topology);
    star.points = polygon.points.vector();
    star.options.tension = tension_;
    const RuleSite site(*scheme_, star);
    for (const VertexId child : site.children_around(VertexId(0))) {
      if (site.source(child).kind != ChildVertex::Kind::face) continue;
      Rule rule{Rule::Place::face, ChildVertex::Kind::face, {}, {}, {}};
      for (SparseMatrix::InnerIterator entry(site.matrix(), child.value); entry; ++entry)
        rule.weights.push_back(
            {Vec2::Zero(), {0, 0, static_cast<int>(entry.col())}, entry.value()});
      add(std::move(rule), 1);
    }
  }

  SchemeRules result;

 private:
  /// The positions of quasi-four-eight decide until the pattern repeats.
  [[nodiscard]] int first_step() const { return scheme_->needs_positions ? 1 : 0; }

  static Rule on_lattice(const RuleSite& site, VertexId child, VertexId middle, Rule::Place place) {
    Rule rule{place, site.source(child).kind, {}, {}, {}};
    for (const VertexId v : site.element(child))
      rule.element.push_back(site.point(v) - site.point(middle));
    for (SparseMatrix::InnerIterator entry(site.matrix(), child.value); entry; ++entry)
      if (entry.value() != 0)
        rule.weights.push_back(
            {site.point(VertexId(static_cast<int>(entry.col()))) - site.point(middle),
             {0, 0, 0},
             entry.value()});
    return rule;
  }

  static void add_step(std::vector<int>& steps, int step) {
    if (steps.empty() || steps.back() != step) steps.push_back(step);
  }

  void add(Rule rule, int step) {
    for (Rule& known : result.rules) {
      const bool comparable = known.place == rule.place || known.place == Rule::Place::regular;
      if (!comparable || known.kind != rule.kind || !same_weights(known.weights, rule.weights))
        continue;
      if (known.place == rule.place) add_step(known.steps, step);
      // As on the plane, unless there it is so in other steps only.
      if (known.place == rule.place ||
          std::find(known.steps.begin(), known.steps.end(), step) != known.steps.end())
        return;
    }
    rule.steps = {step};
    result.rules.push_back(std::move(rule));
  }

  void add_mask(const RuleSite& site, VertexId middle, int step) {
    RegularMask mask;
    for (int row = 0; row < site.matrix().rows(); ++row) {
      const double weight = site.matrix().coeff(row, middle.value);
      if (weight == 0) continue;
      mask.weights.push_back(
          {site.child_point(VertexId(row)) - site.point(middle), {0, 0, 0}, weight});
    }
    for (RegularMask& known : result.masks)
      if (same_weights(known.weights, mask.weights)) return add_step(known.steps, step);
    mask.steps = {step};
    result.masks.push_back(std::move(mask));
  }

  const Scheme* scheme_;
  double tension_;
};

}  // namespace

int num_different_steps(const Scheme& scheme) {
  if (scheme.split == Split::sqrt3) return 2;       // the boundary is cut every second time
  if (scheme.split == Split::four_eight) return 3;  // first faces, then edges in turn
  return 1;
}

int regular_valence(const Scheme& scheme) {
  if (is_dual(scheme)) return 4;
  if (is_four_eight(scheme)) return 8;
  return scheme.faces == FaceKind::triangles ? 6 : 4;
}

SchemeRules scheme_rules(const Scheme& scheme, double tension, const LocalSubdivision* local) {
  const int face_size = scheme.faces == FaceKind::triangles ? 3 : 4;
  RuleCollection all(scheme, tension);
  all.add(lattice(face_size, Region::plane, lattice_reach), Rule::Place::regular);
  if (local) {
    all.add(*local);
    if (scheme.faces == FaceKind::polygons && scheme.face_rule)
      all.add_polygon(local->num_sectors());
  }
  if (scheme.needs_positions) return std::move(all.result);
  if (scheme.boundary != Boundary::shrinks)
    all.add(lattice(face_size, Region::half_plane, lattice_reach), Rule::Place::boundary);
  if (!scheme.creases) return std::move(all.result);
  Lattice corner = lattice(face_size, Region::quadrant, lattice_reach);
  corner.mesh.tags.corners.push_back({corner.middle, infinite_sharpness});
  all.add(corner, Rule::Place::corner);
  Lattice crease = lattice(face_size, Region::plane, lattice_reach);
  add_crease(crease, CreaseLine::through);
  all.add(crease, Rule::Place::crease);
  Lattice dart = lattice(face_size, Region::plane, lattice_reach);
  add_crease(dart, CreaseLine::ends);
  all.add(dart, Rule::Place::dart);
  if (!scheme.interpolatory) {  // these know infinitely sharp edges only
    Lattice semi_sharp = lattice(face_size, Region::plane, lattice_reach);
    add_crease(semi_sharp, CreaseLine::through, 0.5F);
    all.add(semi_sharp, Rule::Place::semi_sharp);
  }
  Lattice point = lattice(face_size, Region::plane, lattice_reach);
  point.mesh.tags.corners.push_back({point.middle, infinite_sharpness});
  all.add(point, Rule::Place::sharp_vertex);
  return std::move(all.result);
}

}  // namespace limes
