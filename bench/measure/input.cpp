#include "input.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "limes/io/io.h"
#include "mesh_io.h"

#ifdef LIMES_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace bench {
namespace {

limes::Mesh converted(const Mesh& mesh) {
  std::vector<int> offsets{0};
  for (const int size : mesh.face_sizes)
    offsets.push_back(offsets.back() + size);
  std::vector<limes::VertexId> corners;
  for (const int v : mesh.face_vertices)
    corners.emplace_back(v);
  limes::Mesh out;
  for (std::size_t i = 0; i < mesh.points.size(); i += 3)
    out.points.push_back({mesh.points[i], mesh.points[i + 1], mesh.points[i + 2]});
  out.topology = limes::Topology(mesh.num_vertices(), std::move(offsets), std::move(corners));
  return out;
}

}  // namespace

limes::Mesh load_mesh(const std::string& in) {
  if (in.rfind("shape:", 0) == 0) return converted(read_mesh(in));
  return limes::read_mesh(in).mesh;
}

std::string model_name(const std::string& in) {
  if (in.rfind("shape:", 0) == 0) return in.substr(6);
  return std::filesystem::path(in).stem().string();
}

limes::Features features_of(const limes::Mesh& mesh) {
  return features_of(mesh, limes::Adjacency(mesh.topology));
}

limes::Features features_of(const limes::Mesh& mesh, const limes::Adjacency& adjacency) {
  return limes::resolve_tags(adjacency, mesh.tags,
                             mesh.tags.boundary.value_or(limes::BoundaryRule::edges));
}

void use_threads(int threads) {
#ifdef LIMES_WITH_TBB
  static std::unique_ptr<tbb::global_control> control;
  control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  static_cast<std::size_t>(threads));
#else
  if (threads > 1) throw std::runtime_error("built without threads (TBB)");
#endif
}

double checksum(std::span<const limes::Vec3> points) {
  Centroid centroid;
  for (const limes::Vec3& x : points)
    centroid.add(x.x(), x.y(), x.z());
  return centroid.checksum();
}

double median(std::vector<double> values) {
  if (values.empty()) return NAN;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

JsonLine first_fields(const Args& args, const std::string& method, const std::string& in,
                      const limes::Scheme& scheme) {
  JsonLine line;
  line.add("library", "limes").add("method", method);
  line.add("scheme", std::string(scheme.name));
  line.add("model", model_name(in)).add("variant", "double," + method);
  line.add("threads", args.get("threads", 1));
  return line;
}

}  // namespace bench
