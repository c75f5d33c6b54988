#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "limes/limit/limit_surface.h"
#include "limes/subdiv/schemes.h"
#include "oracle/osd.h"
#include "oracle/shapes.h"

// Limit surfaces against OpenSubdiv: its masks at refined vertices, its patches at random points.

namespace limes::oracle {
namespace {

struct Parameter {
  FaceId face;
  int corner;
  Vec2 uv;
};

bool visible(const osd::Far::TopologyRefiner& refiner, int f) {
  return !refiner.GetLevel(0).IsFaceHole(f);
}

/// Parameters of the vertices of a refined level, found by following children down from each face.
class DyadicPoints {
 public:
  DyadicPoints(const osd::Far::TopologyRefiner& refiner, int level)
      : refiner_(refiner), last_(level) {}

  std::map<int, Parameter> of_face(int f) {
    found_.clear();
    const auto& base = refiner_.GetLevel(0);
    const auto v = base.GetFaceVertices(f);
    const FaceId face(f);
    if (refiner_.GetSchemeType() == osd::Sdc::SCHEME_LOOP) {
      descend(0, f,
              {{v[0], {face, 0, {0, 0}}}, {v[1], {face, 0, {1, 0}}}, {v[2], {face, 0, {0, 1}}}});
      return found_;
    }
    if (v.size() == 4) {
      descend(0, f,
              {{v[0], {face, 0, {0, 0}}},
               {v[1], {face, 0, {1, 0}}},
               {v[2], {face, 0, {1, 1}}},
               {v[3], {face, 0, {0, 1}}}});
      return found_;
    }
    const auto edges = base.GetFaceEdges(f);
    const auto children = base.GetFaceChildFaces(f);
    for (int i = 0; i < v.size(); ++i)
      descend(1, children[i],
              {{base.GetVertexChildVertex(v[i]), {face, i, {0, 0}}},
               {base.GetEdgeChildVertex(edges[i]), {face, i, {1, 0}}},
               {base.GetFaceChildVertex(f), {face, i, {1, 1}}},
               {base.GetEdgeChildVertex(edges[(i + v.size() - 1) % v.size()]), {face, i, {0, 1}}}});
    return found_;
  }

 private:
  void descend(int level, int face, const std::map<int, Parameter>& corners) {
    if (level == last_) {
      found_.insert(corners.begin(), corners.end());
      return;
    }
    const auto& mesh = refiner_.GetLevel(level);
    const auto v = mesh.GetFaceVertices(face);
    const auto edges = mesh.GetFaceEdges(face);
    std::map<int, Parameter> known;
    Parameter middle = corners.at(v[0]);
    middle.uv.setZero();
    for (int i = 0; i < v.size(); ++i) {
      const Parameter& a = corners.at(v[i]);
      const Parameter& b = corners.at(v[(i + 1) % v.size()]);
      known[mesh.GetVertexChildVertex(v[i])] = a;
      known[mesh.GetEdgeChildVertex(edges[i])] = {a.face, a.corner, (a.uv + b.uv) / 2};
      middle.uv += a.uv / 4;
    }
    if (v.size() == 4) known[mesh.GetFaceChildVertex(face)] = middle;
    const auto children = mesh.GetFaceChildFaces(face);
    for (int i = 0; i < children.size(); ++i) {
      std::map<int, Parameter> next;
      const auto child = refiner_.GetLevel(level + 1).GetFaceVertices(children[i]);
      for (int j = 0; j < child.size(); ++j)
        next[child[j]] = known.at(child[j]);
      descend(level + 1, children[i], next);
    }
  }

  const osd::Far::TopologyRefiner& refiner_;
  int last_;
  std::map<int, Parameter> found_;
};

class OpenSubdivLimit : public testing::TestWithParam<Case> {
 protected:
  OpenSubdivLimit()
      : mesh_(read_shape(GetParam().shape)),
        scheme_(find_scheme(GetParam().shape.starts_with("loop") ? "loop" : "catmull-clark")),
        basis_(mesh_.topology,
               resolve_tags(Adjacency(mesh_.topology), mesh_.tags, GetParam().boundary), scheme_),
        surface_(basis_, mesh_.points.span()) {}

  Mesh mesh_;
  const Scheme& scheme_;
  LimitBasis basis_;
  LimitSurface surface_;
};

/// At all vertices of level 3 where OpenSubdiv's masks are exact (see has_exact_limit), taken deep
/// enough for semi-sharp creases to be gone where the shape's size allows it.
TEST_P(OpenSubdivLimit, EqualsMasksAtRefinedVertices) {
  const int level = 3;
  const int deepest = mesh_.topology.num_faces() > 100 ? 4 : 7;
  const auto refiner = make_refiner(mesh_, scheme_, GetParam().boundary);
  const auto positions = refine_uniformly(*refiner, mesh_, deepest);
  const auto limits = limit_of_last_level(*refiner, positions.back());
  const double tolerance = 1e-12 * size_of(mesh_);
  DyadicPoints points(*refiner, level);
  int compared = 0;
  int faces_visible = 0;
  for (int f = 0; f < mesh_.topology.num_faces(); ++f) {
    if (!visible(*refiner, f)) continue;
    ++faces_visible;
    for (const auto& [vertex, at] : points.of_face(f)) {
      int deep = vertex;
      for (int k = level; k < deepest; ++k)
        deep = refiner->GetLevel(k).GetVertexChildVertex(deep);
      if (!has_exact_limit(refiner->GetLevel(deepest), deep)) continue;
      ++compared;
      const Vec3 ours = surface_.position(at.face, at.corner, at.uv);
      const double error = (ours - limits[static_cast<std::size_t>(deep)]).norm();
      EXPECT_LE(error, tolerance) << "face " << f << " corner " << at.corner << " at "
                                  << at.uv.transpose();
      if (error > tolerance) return;
    }
  }
  EXPECT_TRUE(compared > 0 || faces_visible == 0);
}

/// At 50 random points: to rounding on OpenSubdiv's B-spline patches, whose surface is exact; to its
/// own accuracy on the patches that it puts next to extraordinary vertices at level 10.
TEST_P(OpenSubdivLimit, EqualsPatchesAtRandomPoints) {
  const auto refiner = make_refiner(mesh_, scheme_, GetParam().boundary);
  std::vector<int> faces;
  for (int f = 0; f < mesh_.topology.num_faces(); ++f)
    if (visible(*refiner, f)) faces.push_back(f);
  if (faces.empty()) GTEST_SKIP() << "every face touches the boundary";
  const LimitPatches patches(mesh_, scheme_, GetParam().boundary);
  const double size = size_of(mesh_);
  std::mt19937 random(1978);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto below = [&](std::size_t n) {
    return static_cast<std::size_t>(unit(random) * static_cast<double>(n));
  };
  int num_regular = 0;
  for (int i = 0; i < 50; ++i) {
    const FaceId f(faces[below(faces.size())]);
    const int corner = static_cast<int>(below(static_cast<std::size_t>(basis_.num_quadrants(f))));
    Vec2 uv(unit(random), unit(random));
    if (basis_.on_triangles() && uv.sum() > 1) uv = Vec2(1, 1) - uv;
    SCOPED_TRACE(testing::Message()
                 << "face " << f.value << " corner " << corner << " at " << uv.transpose());
    const LimitPatches::Point theirs = patches.evaluate(f, corner, uv);
    ASSERT_TRUE(theirs.exists);
    const SurfacePoint ours = surface_.evaluate(f, corner, uv);
    ASSERT_TRUE(ours.first && ours.second);
    num_regular += theirs.regular;
    const double tolerance = (theirs.regular ? 1e-12 : 1e-6) * size;
    EXPECT_LE((ours.x - theirs.x).norm(), tolerance) << theirs.regular;
    EXPECT_LE((ours.first->xu - theirs.xu).norm(), 10 * tolerance) << theirs.regular;
    EXPECT_LE((ours.first->xv - theirs.xv).norm(), 10 * tolerance);
    if (!theirs.regular) continue;
    EXPECT_LE((ours.second->xuu - theirs.xuu).norm(), 1e-9 * size);
    EXPECT_LE((ours.second->xuv - theirs.xuv).norm(), 1e-9 * size);
    EXPECT_LE((ours.second->xvv - theirs.xvv).norm(), 1e-9 * size);
  }
  EXPECT_GE(num_regular, 45) << "hardly any point was compared to rounding";
}

INSTANTIATE_TEST_SUITE_P(Shapes, OpenSubdivLimit, testing::ValuesIn(manifold_cases("catmark")),
                         [](const auto& c) { return name_of(c.param); });
INSTANTIATE_TEST_SUITE_P(Loop, OpenSubdivLimit, testing::ValuesIn(manifold_cases("loop")),
                         [](const auto& c) { return name_of(c.param); });

/// Where OpenSubdiv's tangent masks hold for loop: not beside a boundary or crease with four faces or
/// more on a side (docs/theory/loop.md).
bool has_exact_tangents(const osd::Far::TopologyLevel& level, int vertex) {
  if (!has_exact_limit(level, vertex)) return false;
  const auto rule = level.GetVertexRule(vertex);
  if (rule == osd::Sdc::Crease::RULE_SMOOTH) return true;
  if (rule != osd::Sdc::Crease::RULE_CREASE || !level.IsVertexBoundary(vertex)) return false;
  return level.GetVertexFaces(vertex).size() <= 3;
}

using OpenSubdivLoopLimit = OpenSubdivLimit;

/// The tangent planes at the vertices of level 2, by their normals.
TEST_P(OpenSubdivLoopLimit, EqualsTangentPlanesAtRefinedVertices) {
  const int level = 2;
  const auto refiner = make_refiner(mesh_, scheme_, GetParam().boundary);
  const auto positions = refine_uniformly(*refiner, mesh_, level);
  const auto [first, second] = tangents_of_last_level(*refiner, positions.back());
  DyadicPoints points(*refiner, level);
  int compared = 0;
  int faces_visible = 0;
  for (int f = 0; f < mesh_.topology.num_faces(); ++f) {
    if (!visible(*refiner, f)) continue;
    ++faces_visible;
    for (const auto& [vertex, at] : points.of_face(f)) {
      if (!has_exact_tangents(refiner->GetLevel(level), vertex)) continue;
      const Vec3& a = first[static_cast<std::size_t>(vertex)];
      const Vec3& b = second[static_cast<std::size_t>(vertex)];
      const Vec3 normal = a.cross(b);
      if (normal.norm() < 1e-6 * a.norm() * b.norm()) continue;
      const SurfacePoint ours = surface_.evaluate(at.face, at.corner, at.uv);
      SCOPED_TRACE(testing::Message()
                   << "face " << f << " at " << at.uv.transpose() << " vertex " << vertex);
      ASSERT_TRUE(ours.normal);
      EXPECT_LE((*ours.normal - normal.normalized()).norm(), 1e-9);
      ++compared;
    }
  }
  EXPECT_TRUE(compared > 0 || faces_visible == 0);
}

INSTANTIATE_TEST_SUITE_P(Loop, OpenSubdivLoopLimit, testing::ValuesIn(manifold_cases("loop")),
                         [](const auto& c) { return name_of(c.param); });

}  // namespace
}  // namespace limes::oracle
