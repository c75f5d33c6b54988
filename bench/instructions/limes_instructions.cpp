// Small fixed runs for valgrind --tool=callgrind --collect-atstart=no. Only the named work is
// counted, not reading the input, and it runs in one thread whatever the machine has.
//   --run refine | set-up | evaluate | closest | assemble
#include <valgrind/callgrind.h>

#include <functional>
#include <map>

#include "input.h"
#include "limes/fem/laplace.h"
#include "limes/limit/bulk_evaluator.h"
#include "limes/limit/closest_point.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/uniform.h"

#ifdef LIMES_WITH_TBB
#include <tbb/task_arena.h>
#endif

using namespace bench;

namespace {

const limes::Scheme& catmull_clark() {
  return limes::find_scheme("catmull-clark");
}

limes::Mesh rook() {
  return load_mesh(LIMES_DATA_DIR "/rook.obj");
}

/// Counts what `work` does.
void counted(const std::function<void()>& work) {
  const auto collect = [&] {
    CALLGRIND_TOGGLE_COLLECT;
    work();
    CALLGRIND_TOGGLE_COLLECT;
  };
#ifdef LIMES_WITH_TBB
  // A room for one thread: how TBB cuts its ranges depends on the size of the room.
  tbb::task_arena arena(1);
  arena.execute(collect);
#else
  collect();
#endif
}

/// Three levels of the rook: 777 faces with creases and triangles become 49,024.
double refine() {
  const limes::Mesh mesh = rook();
  const limes::Features features = features_of(mesh);
  std::vector<limes::Vec3> fine;
  counted([&] {
    const limes::Adjacency adjacency(mesh.topology);
    limes::UniformRefinement refinement(adjacency, features, catmull_clark(), 3);
    std::vector<limes::VertexId> corners(4 * static_cast<std::size_t>(refinement.num_faces()));
    refinement.corners(corners);
    fine.resize(static_cast<std::size_t>(refinement.num_vertices()));
    refinement.positions(mesh.points.span(), fine);
  });
  return checksum(fine);
}

/// The tables of the rook's limit surface and a first point on every face.
double set_up() {
  const limes::Mesh mesh = rook();
  const limes::Features features = features_of(mesh);
  std::vector<limes::SurfaceLocation> middles;
  for (int f = 0; f < mesh.topology.num_faces(); ++f)
    middles.push_back({limes::FaceId(f), 0, limes::Vec2(0.4, 0.3)});
  limes::SurfaceValues values;
  counted([&] {
    const limes::LimitBasis basis(mesh.topology, features, catmull_clark());
    const limes::BulkEvaluator bulk(basis, mesh.points.span());
    bulk.evaluate(middles, 1, values);
  });
  return checksum(values.x);
}

/// 20,000 random points of the rook with first derivatives, tables being there.
double evaluate() {
  const limes::Mesh mesh = rook();
  const limes::LimitBasis basis(mesh.topology, features_of(mesh), catmull_clark());
  const limes::BulkEvaluator bulk(basis, mesh.points.span());
  std::vector<limes::SurfaceLocation> places;
  for (const Location& l : random_locations(mesh.topology.num_faces(), 20000, false, false))
    places.push_back({limes::FaceId(l.face), 0, limes::Vec2(l.u, l.v)});
  limes::SurfaceValues values;
  bulk.evaluate(places, 1, values);
  counted([&] { bulk.evaluate(places, 1, values); });
  return checksum(values.x);
}

/// Closest points of the rook from 500 places in the box around it.
double closest() {
  const limes::Mesh mesh = rook();
  const limes::LimitBasis basis(mesh.topology, features_of(mesh), catmull_clark());
  const limes::SurfaceTree tree(basis, mesh.points.span());
  Eigen::AlignedBox3d box;
  for (const limes::Vec3& x : mesh.points)
    box.extend(x);
  std::vector<limes::Vec3> queries;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Array3d t(i % 10, i / 10 % 10, i / 100);
    queries.emplace_back(box.min().array() +
                         (t + 0.5) / Eigen::Array3d(10, 10, 5) * box.sizes().array());
  }
  std::vector<limes::ClosestHit> hits;
  counted([&] { hits = limes::closest_points(tree, queries); });
  Centroid centroid;
  for (const limes::ClosestHit& hit : hits)
    centroid.add(hit.point.x(), hit.point.y(), hit.point.z());
  return centroid.checksum();
}

/// The H1 product on a pentagon of 320 quads around a vertex of valence 5.
double assemble() {
  const limes::SubdivisionSpace space(limes::shapes::disk(5, 8), catmull_clark(),
                                      limes::BoundaryRule::edges, {}, {});
  limes::SparseMatrix K;
  counted([&] { K = limes::laplace_matrix(space, 1); });
  return K.diagonal().sum();
}

void run(const Args& args) {
  const std::map<std::string, double (*)()> runs{{"refine", refine},
                                                 {"set-up", set_up},
                                                 {"evaluate", evaluate},
                                                 {"closest", closest},
                                                 {"assemble", assemble}};
  const auto found = runs.find(args.get("run", "refine"));
  args.require_all_read();
  if (found == runs.end()) throw std::runtime_error("unknown run");
  use_threads(1);
  JsonLine line;
  line.add("run", found->first).add("checksum", found->second());
  line.print();
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("limes_instructions", argc, argv, run);
}
