// Limit evaluation by limes at random (face, u, v), the same places as osd_evaluate.
//   --in FILE --scheme catmull-clark --derivatives 0|1|2 --samples N --threads T --repeats R
//   --order random|sorted
//   --method bulk (BulkEvaluator) | point (LimitBasis, one point a call)
#include "input.h"
#include "limes/core/parallel.h"
#include "limes/limit/bulk_evaluator.h"
#include "limes/subdiv/schemes.h"

using namespace bench;

namespace {

/// Quadrants in the order of faces: a location's number is an index into this.
std::vector<limes::SurfaceLocation> quadrants_of(const limes::LimitBasis& basis) {
  std::vector<limes::SurfaceLocation> out;
  for (int f = 0; f < basis.topology().num_faces(); ++f)
    for (int k = 0; k < basis.num_quadrants(limes::FaceId(f)); ++k)
      out.push_back({limes::FaceId(f), k, limes::Vec2::Zero()});
  return out;
}

/// A first point in every quadrant, so that what is built when it is needed counts as set-up.
void evaluate_everywhere(const limes::BulkEvaluator& bulk, int order) {
  std::vector<limes::SurfaceLocation> places = quadrants_of(bulk.basis());
  for (limes::SurfaceLocation& p : places)
    p.uv = {0.4, 0.3};
  limes::SurfaceValues values;
  bulk.evaluate(places, order, values);
}

std::vector<limes::SurfaceLocation> random_places(const limes::LimitBasis& basis, std::size_t n,
                                                  bool sorted) {
  const std::vector<limes::SurfaceLocation> quadrants = quadrants_of(basis);
  std::vector<limes::SurfaceLocation> out;
  out.reserve(n);
  for (const Location& l : random_locations(static_cast<int>(quadrants.size()), n, false, sorted)) {
    out.push_back(quadrants[static_cast<std::size_t>(l.face)]);
    out.back().uv = {l.u, l.v};
  }
  return out;
}

void resize(limes::SurfaceValues& values, std::size_t n, int order) {
  values.x.resize(n);
  values.xu.resize(order >= 1 ? n : 0);
  values.xv.resize(order >= 1 ? n : 0);
  values.xuu.resize(order >= 2 ? n : 0);
  values.xuv.resize(order >= 2 ? n : 0);
  values.xvv.resize(order >= 2 ? n : 0);
}

/// The plain way: the basis functions of each point, times the control points of its face.
void evaluate_points(const limes::LimitBasis& basis, std::span<const limes::Vec3> points,
                     std::span<const limes::SurfaceLocation> places, int order,
                     limes::SurfaceValues& out) {
  resize(out, places.size(), order);
  const auto block = [&](std::int64_t begin, std::int64_t end) {
    limes::BasisAt at;
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
      const auto& [face, corner, uv] = places[i];
      basis.evaluate(face, corner, uv, order, at);
      const auto controls = basis.controls(face);
      const auto sum = [&](const auto& weights) {
        limes::Vec3 x = limes::Vec3::Zero();
        for (std::size_t k = 0; k < controls.size(); ++k)
          x += weights(static_cast<Eigen::Index>(k)) *
               points[static_cast<std::size_t>(controls[k].value)];
        return x;
      };
      out.x[i] = sum(at.N);
      if (at.dN.rows() > 0) {
        out.xu[i] = sum(at.dN.col(0));
        out.xv[i] = sum(at.dN.col(1));
      }
      if (at.ddN.rows() > 0) {
        out.xuu[i] = sum(at.ddN.col(0));
        out.xuv[i] = sum(at.ddN.col(1));
        out.xvv[i] = sum(at.ddN.col(2));
      }
    }
  };
  limes::for_each_block(static_cast<std::int64_t>(places.size()), 1024, block);
}

void run(const Args& args) {
  const std::string in = args.get("in", "shape:torus:64:32");
  const limes::Mesh mesh = load_mesh(in);
  const limes::Scheme& scheme = limes::find_scheme(args.get("scheme", "catmull-clark"));
  const std::string method = args.get("method", "bulk"), order = args.get("order", "random");
  const int derivatives = args.get("derivatives", 1);
  if (method != "bulk" && method != "point") throw std::runtime_error("unknown method " + method);
  if (derivatives < 0 || derivatives > 2) throw std::runtime_error("derivatives: 0, 1 or 2");
  const auto samples = static_cast<std::size_t>(args.get("samples", 1000000));
  use_threads(args.get("threads", 1));
  const std::int64_t rss_before = peak_rss();

  Timer timer;
  const limes::LimitBasis basis(mesh.topology, features_of(mesh), scheme);
  std::optional<limes::BulkEvaluator> bulk;
  limes::SurfaceJet jet;
  if (method == "bulk")
    bulk.emplace(basis, mesh.points.span())
        .evaluate({limes::FaceId(0), 0, limes::Vec2(0.4, 0.3)}, derivatives, jet);
  const double first_point = timer.cpu();
  if (bulk) evaluate_everywhere(*bulk, derivatives);
  const double build = timer.wall();
  const double build_cpu = timer.cpu();
  const std::int64_t rss_built = peak_rss();

  const auto places = random_places(basis, samples, order == "sorted");
  limes::SurfaceValues out;
  std::vector<double> wall, cpu;
  for (int r = 0; r <= args.get("repeats", 3); ++r) {  // the first pass is a warm-up
    timer.restart();
    if (bulk)
      bulk->evaluate(places, derivatives, out);
    else
      evaluate_points(basis, mesh.points.span(), places, derivatives, out);
    if (r == 0) continue;
    wall.push_back(timer.wall());
    cpu.push_back(timer.cpu());
  }

  JsonLine line = first_fields(args, method, in, scheme);
  line.add("order", order).add("in_faces", mesh.topology.num_faces());
  line.add("derivatives", derivatives).add("samples", samples).add("kinds", basis.kinds().size());
  line.add("seconds_build", build).add("seconds", median(wall));
  line.add("cpu_seconds_first_point", first_point);
  line.add("cpu_seconds_build", build_cpu).add("cpu_seconds", median(cpu));
  line.add("points_per_second", static_cast<double>(samples) / median(wall));
  line.add("points_per_cpu_second", static_cast<double>(samples) / median(cpu));
  line.add("rss_before", rss_before).add("rss_built", rss_built).add("peak_rss", peak_rss());
  line.add("checksum", checksum(out.x));
  args.require_all_read();
  line.print();
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("limes_evaluate", argc, argv, run);
}
