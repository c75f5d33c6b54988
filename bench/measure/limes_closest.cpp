// Closest points of a limit surface by limes.
//   --in FILE --scheme catmull-clark --queries N --threads T --repeats R
//   --places near (up to a tenth of the model's size from random points of the surface)
//          | box (anywhere in the box around the control points, enlarged by half)
#include <random>

#include "input.h"
#include "limes/limit/bulk_evaluator.h"
#include "limes/limit/closest_point.h"
#include "limes/subdiv/schemes.h"

using namespace bench;

namespace {

Eigen::AlignedBox3d box_of(const limes::Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const limes::Vec3& x : mesh.points)
    box.extend(x);
  return box;
}

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

limes::Vec3 anywhere(std::mt19937_64& random, const limes::Vec3& middle, const limes::Vec3& half) {
  limes::Vec3 x;
  for (int k = 0; k < 3; ++k)
    x[k] = middle[k] + uniform(random, -half[k], half[k]);
  return x;
}

std::vector<limes::Vec3> make_queries(const limes::Mesh& mesh, const limes::LimitBasis& basis,
                                      const std::string& places, std::size_t n) {
  const Eigen::AlignedBox3d box = box_of(mesh);
  std::mt19937_64 random(1998);
  std::vector<limes::Vec3> out;
  if (places == "box") {
    for (std::size_t i = 0; i < n; ++i)
      out.push_back(anywhere(random, box.center(), 0.75 * box.sizes()));
    return out;
  }
  if (places != "near") throw std::runtime_error("places: near or box");
  std::vector<limes::SurfaceLocation> where;
  for (const Location& l : random_locations(mesh.topology.num_faces(), n, false, false))
    where.push_back({limes::FaceId(l.face), 0, limes::Vec2(l.u, l.v)});
  limes::SurfaceValues values;
  limes::BulkEvaluator(basis, mesh.points.span()).evaluate(where, 0, values);
  const limes::Vec3 half = limes::Vec3::Constant(0.1 * box.diagonal().norm() / std::sqrt(3.0));
  for (const limes::Vec3& x : values.x)
    out.push_back(anywhere(random, x, half));
  return out;
}

void run(const Args& args) {
  const std::string in = args.get("in", "shape:torus:64:32");
  const limes::Mesh mesh = load_mesh(in);
  const limes::Scheme& scheme = limes::find_scheme(args.get("scheme", "catmull-clark"));
  const auto n = static_cast<std::size_t>(args.get("queries", 1000000));
  const std::string places = args.get("places", "near");
  use_threads(args.get("threads", 1));

  Timer timer;
  const limes::LimitBasis basis(mesh.topology, features_of(mesh), scheme);
  const limes::SurfaceTree tree(basis, mesh.points.span());
  const double build = timer.wall(), build_cpu = timer.cpu();
  const std::vector<limes::Vec3> queries = make_queries(mesh, basis, places, n);
  std::vector<double> wall, cpu;
  Centroid centroid;
  for (int r = 0; r < args.get("repeats", 1); ++r) {
    timer.restart();
    const std::vector<limes::ClosestHit> hits = limes::closest_points(tree, queries);
    wall.push_back(timer.wall());
    cpu.push_back(timer.cpu());
    centroid = {};
    for (const limes::ClosestHit& hit : hits)
      centroid.add(hit.point.x(), hit.point.y(), hit.point.z());
  }

  JsonLine line = first_fields(args, places, in, scheme);
  line.add("in_faces", mesh.topology.num_faces()).add("queries", n);
  line.add("seconds_build", build).add("seconds", median(wall));
  line.add("cpu_seconds_build", build_cpu).add("cpu_seconds", median(cpu));
  line.add("peak_rss", peak_rss()).add("checksum", centroid.checksum());
  args.require_all_read();
  line.print();
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("limes_closest", argc, argv, run);
}
