#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

#include "limes/core/error.h"
#include "limes/io/io.h"
#include "limes/mesh/adjacency.h"
#include "limes/mesh/defects.h"
#include "limes/mesh/measure.h"
#include "limes/mesh/repair.h"

// Any bytes: a reader refuses them with an InputError or returns a mesh that everything that looks
// at meshes can take, and that its writer writes so that it reads back the same.

namespace limes {
namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

constexpr bool is_stl = LIMES_FUZZ_READER == read_stl;

/// A sound mesh must also have an adjacency with a ring around every vertex.
void check_topology(const Mesh& mesh) {
  static_cast<void>(measure(mesh));
  try {
    require_refinable(mesh, "fuzz");
  } catch (const InputError&) {
    return;
  }
  const Adjacency adjacency(mesh.topology);
  int corners = 0;
  for (int v = 0; v < mesh.topology.num_vertices(); ++v)
    corners += adjacency.num_ring_faces(VertexId(v));
  require(corners == mesh.topology.num_corners());
}

void check_repair(const Mesh& mesh) {
  RepairResult repaired;
  try {
    repaired = repair(mesh);
  } catch (const InputError&) {
    return;
  }
  for (const Defect& d : find_defects(repaired.mesh))
    require(d.kind != DefectKind::orientation && d.kind != DefectKind::non_manifold_vertex &&
            d.kind != DefectKind::tag && d.kind != DefectKind::unused_vertices);
  check_topology(repaired.mesh);
}

bool fits_single_precision(const Mesh& mesh) {
  for (const Vec3& x : mesh.points)
    if (x.cwiseAbs().maxCoeff() > static_cast<double>(std::numeric_limits<float>::max()))
      return false;
  return true;
}

void check_writing(const Mesh& mesh) {
  if (is_stl && !fits_single_precision(mesh)) return;
  std::string bytes;
  LIMES_FUZZ_WRITER([&](std::string_view piece) { bytes += piece; }, mesh);
  if (is_stl) return;  // rounding to single precision may collapse every triangle
  const Mesh back = LIMES_FUZZ_READER(bytes, "fuzz").mesh;
  require(back.topology == mesh.topology);
  require(back.points.vector() == mesh.points.vector());
  require(back.groups.size() <= mesh.groups.size());
  if (LIMES_FUZZ_READER != read_obj) return;
  require(back.tags.creases == mesh.tags.creases && back.tags.corners == mesh.tags.corners &&
          back.tags.holes == mesh.tags.holes);
}

}  // namespace
}  // namespace limes

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace limes;
  MeshFile file;
  try {
    file = LIMES_FUZZ_READER({reinterpret_cast<const char*>(data), size}, "fuzz");
  } catch (const InputError&) {
    return 0;
  }
  check_topology(file.mesh);  // from here on an exception is a finding
  check_repair(file.mesh);
  check_writing(file.mesh);
  return 0;
}
