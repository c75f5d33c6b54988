#include <gtest/gtest.h>

#ifdef LIMES_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <random>

#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"
#include "subdiv/zoo.h"

// What every scheme must do on every shape.

namespace limes {
namespace {

/// One step from a mesh, with what it refers to.
struct Step {
  Step(const Mesh& mesh, const Scheme& scheme)
      : topology(mesh.topology),
        adjacency(topology),
        features(resolve_tags(adjacency, mesh.tags, BoundaryRule::edges)),
        step(adjacency, features, scheme) {}
  std::vector<Vec3> apply(const std::vector<Vec3>& x) const {
    std::vector<Vec3> fine(static_cast<std::size_t>(step.num_child_vertices()));
    step.apply(x, fine);
    return fine;
  }
  Topology topology;
  Adjacency adjacency;
  Features features;
  RefinementStep step;
};

double size_of(const std::vector<Vec3>& points) {
  double size = 0;
  for (const Vec3& x : points)
    size = std::max(size, x.norm());
  return size;
}

class EveryScheme : public testing::TestWithParam<std::string> {
 protected:
  /// Calls body(mesh) for all shapes that the scheme takes and where it is a matrix.
  template <class Body>
  void on_every_shape(const Body& body) {
    int count = 0;
    for (const Shape& s : zoo()) {
      if (!scheme().linear || !fits(scheme(), s.mesh)) continue;
      SCOPED_TRACE(s.name);
      body(s.mesh);
      ++count;
    }
    EXPECT_TRUE(count > 0 || !scheme().linear);
  }
  [[nodiscard]] const Scheme& scheme() const { return find_scheme(GetParam()); }
};

TEST_P(EveryScheme, RowsSumToOne) {
  on_every_shape([&](const Mesh& mesh) {
    const SparseMatrix S = Step(mesh, scheme()).step.matrix();
    const VectorX sums = S * VectorX::Ones(S.cols());
    EXPECT_LE((sums - VectorX::Ones(S.rows())).cwiseAbs().maxCoeff(), 4e-15);
  });
}

TEST_P(EveryScheme, CommutesWithAffineMaps) {
  Mat3 L;
  L << 1.1, 0.3, -0.2, 0.4, 0.9, 0.5, -0.6, 0.1, 1.3;
  const Vec3 shift(3, -2, 5);
  const auto map = [&](std::vector<Vec3> points) {
    for (Vec3& x : points)
      x = L * x + shift;
    return points;
  };
  on_every_shape([&](const Mesh& mesh) {
    const Step s(mesh, scheme());
    const auto a = s.apply(map(mesh.points.vector()));
    const auto b = map(s.apply(mesh.points.vector()));
    for (std::size_t i = 0; i < a.size(); ++i)
      EXPECT_LE((a[i] - b[i]).norm(), 1e-14 * size_of(b));
  });
}

/// The matrix holds the same weights as the rules that move values: 4 ulp of the size.
TEST_P(EveryScheme, MatrixAgreesWithApply) {
  on_every_shape([&](const Mesh& mesh) {
    const Step s(mesh, scheme());
    const auto fine = s.apply(mesh.points.vector());
    const SparseMatrix S = s.step.matrix();
    const double ulp = size_of(mesh.points.vector()) * std::numeric_limits<double>::epsilon();
    for (int k = 0; k < 3; ++k) {
      VectorX x(S.cols());
      for (int v = 0; v < mesh.points.size(); ++v)
        x(v) = mesh.points[VertexId(v)](k);
      const VectorX y = S * x;
      for (std::size_t i = 0; i < fine.size(); ++i)
        EXPECT_LE(std::abs(y(static_cast<Eigen::Index>(i)) - fine[i](k)), 4 * ulp);
    }
  });
}

/// What a rule makes of a mesh that is 1 at one vertex and 0 elsewhere is a column of S, bit for bit. Only
/// catmull-clark adds weights by way of face points, in another order than S: some ulps of 1.
TEST_P(EveryScheme, MatrixHasTheBitsOfTheRules) {
  const double tolerance =
      GetParam() == "catmull-clark" ? 4 * std::numeric_limits<double>::epsilon() : 0;
  on_every_shape([&](const Mesh& mesh) {
    const Step s(mesh, scheme());
    const Eigen::SparseMatrix<double, Eigen::ColMajor> S = s.step.matrix();
    const int num = mesh.points.size();
    for (int v = 0; v < num; v += std::max(3, 3 * (num / 60))) {
      std::vector<Vec3> x(static_cast<std::size_t>(num), Vec3::Zero());
      for (int k = 0; k < std::min(3, num - v); ++k)
        x[static_cast<std::size_t>(v + k)](k) = 1;
      const auto fine = s.apply(x);
      for (int k = 0; k < std::min(3, num - v); ++k) {
        VectorX column = VectorX::Zero(S.rows());
        for (Eigen::SparseMatrix<double, Eigen::ColMajor>::InnerIterator it(S, v + k); it; ++it)
          column(it.row()) = it.value();
        for (std::size_t i = 0; i < fine.size(); ++i)
          ASSERT_LE(std::abs(column(static_cast<Eigen::Index>(i)) - fine[i](k)), tolerance) << i;
      }
    }
  });
}

TEST_P(EveryScheme, KeepsTheEulerNumber) {
  on_every_shape([&](const Mesh& mesh) {
    if (scheme().boundary == Boundary::shrinks && !is_closed(mesh)) return;
    const auto euler = [](const Topology& t) {
      return t.num_vertices() - Adjacency(t).num_edges() + t.num_faces();
    };
    const Mesh fine = refine(mesh, scheme(), {.levels = 2});
    EXPECT_EQ(euler(fine.topology), euler(mesh.topology));
  });
}

/// Six times the volume that a closed mesh with outward faces encloses.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const auto v = mesh.topology.face(FaceId(f));
    for (std::size_t i = 1; i + 1 < v.size(); ++i)
      sum += mesh.points[v[0]].dot(mesh.points[v[i]].cross(mesh.points[v[i + 1]]));
  }
  return sum;
}

TEST_P(EveryScheme, KeepsTheOrientation) {
  on_every_shape([&](const Mesh& mesh) {
    if (!is_closed(mesh)) return;
    EXPECT_GT(volume(mesh) * volume(refine(mesh, scheme(), {.levels = 2})), 0);
  });
}

/// Faces stay in their parts: every refined face is in one, and the parts lie side by side as before.
TEST_P(EveryScheme, HandsPartsDownToTheChildren) {
  on_every_shape([&](Mesh mesh) {
    const int half = mesh.topology.num_faces() / 2;
    mesh.parts = {{"a", {}}, {"b", {}}};
    for (int f = 0; f < mesh.topology.num_faces(); ++f)
      mesh.parts[f < half ? 0 : 1].faces.emplace_back(f);
    const Mesh fine = refine(mesh, scheme(), {.levels = 2});
    ASSERT_EQ(fine.parts.size(), 2U);
    std::vector<int> count(static_cast<std::size_t>(fine.topology.num_faces()), 0);
    for (const FaceGroup& part : fine.parts) {
      EXPECT_TRUE(std::is_sorted(part.faces.begin(), part.faces.end()));
      for (const FaceId f : part.faces)
        ++count[static_cast<std::size_t>(f.value)];
    }
    EXPECT_EQ(std::count(count.begin(), count.end(), 1), fine.topology.num_faces());
    EXPECT_TRUE(half == 0 || scheme().boundary == Boundary::shrinks ||
                !fine.parts[0].faces.empty());
  });
}

/// Tags of a refined mesh say all that is left of the sharpness: two steps are one step twice. Not
/// at the boundary of sqrt3, where every second step is another, nor for four-eight, whose first step is.
TEST_P(EveryScheme, TwoLevelsAreOneLevelTwice) {
  on_every_shape([&](const Mesh& mesh) {
    if (scheme().split == Split::four_eight) return;
    if (scheme().split == Split::sqrt3 && !is_closed(mesh)) return;
    const Mesh once = refine(mesh, scheme(), {.levels = 1});
    const Mesh twice = refine(once, scheme(), {.levels = 1});
    const Mesh both = refine(mesh, scheme(), {.levels = 2});
    EXPECT_EQ(twice.topology, both.topology);
    EXPECT_EQ(twice.points, both.points);
    EXPECT_EQ(twice.tags.creases, both.tags.creases);
    EXPECT_EQ(twice.tags.corners, both.tags.corners);
  });
}

#ifdef LIMES_WITH_TBB
TEST_P(EveryScheme, GivesTheSameBitsForOneAndTwoThreads) {
  const Mesh mesh = scheme().faces == FaceKind::triangles ? bumpy(shapes::icosahedron())
                                                          : bumpy(shapes::torus(40, 30));
  const auto with_threads = [&](std::size_t n) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, n);
    return refine(mesh, scheme(), {.levels = 3});
  };
  const Mesh one = with_threads(1);
  const Mesh two = with_threads(2);
  EXPECT_EQ(one.topology, two.topology);
  EXPECT_EQ(one.points, two.points);
}
#endif

/// A quarter turn about z and the mirror x = 0 map the refined cube onto itself.
TEST_P(EveryScheme, KeepsTheSymmetryOfACube) {
  if (!fits(scheme(), shapes::cube())) return;
  if (scheme().needs_positions) return;  // cuts the quads, and all of these cuts are ties
  const Mesh fine = refine(shapes::cube(), scheme(), {.levels = 3});
  const auto holds = [&](const auto& map) {
    for (const Vec3& x : fine.points) {
      const Vec3 image = map(x);
      if (std::none_of(fine.points.begin(), fine.points.end(),
                       [&](const Vec3& y) { return (y - image).norm() < 1e-14; }))
        return false;
    }
    return true;
  };
  EXPECT_TRUE(holds([](const Vec3& x) { return Vec3(-x.y(), x.x(), x.z()); }));
  EXPECT_TRUE(holds([](const Vec3& x) { return Vec3(-x.x(), x.y(), x.z()); }));
  EXPECT_TRUE(holds([](const Vec3& x) { return Vec3(x.y(), x.z(), x.x()); }));
}

TEST_P(EveryScheme, RefusesAMoebiusStrip) {
  try {
    (void)refine(shapes::moebius_strip(5), scheme(), {});
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("same direction"), std::string::npos) << error.what();
  }
}

TEST_P(EveryScheme, RefusesAFaceThatMeetsAVertexTwice) {
  Mesh mesh;
  mesh.topology = Topology(3, 4, {VertexId(0), VertexId(1), VertexId(0), VertexId(2)});
  mesh.points.resize(3, Vec3::Zero());
  EXPECT_THROW((void)refine(mesh, scheme(), {}), InputError);
}

TEST_P(EveryScheme, RefusesTwoFansAtAVertex) {
  Mesh mesh;
  std::vector<VertexId> corners;
  for (const int v : {0, 1, 2, 3, 0, 4, 5, 6})
    corners.emplace_back(v);
  mesh.topology = Topology(7, 4, corners);
  mesh.points.resize(7, Vec3::Zero());
  try {
    (void)refine(mesh, scheme(), {});
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("vertex 0 joins"), std::string::npos) << error.what();
  }
}

std::vector<std::string> scheme_names() {
  std::vector<std::string> names;
  for (const Scheme& s : all_schemes())
    names.emplace_back(s.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Schemes, EveryScheme, testing::ValuesIn(scheme_names()),
                         [](const auto& name) {
                           std::string id = name.param;
                           std::replace(id.begin(), id.end(), '-', '_');
                           return id;
                         });

TEST(Schemes, UnknownNameListsTheKnownOnes) {
  try {
    (void)find_scheme("catmul-clark");
    ADD_FAILURE();
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("catmull-clark"), std::string::npos);
  }
}

}  // namespace
}  // namespace limes
