#include "oracle/shapes.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "limes/io/io.h"

namespace limes::oracle {
namespace {

/// The shapes that are no surface, or use what OpenSubdiv itself has given up, with a piece of our
/// message. docs/theory/catmull-clark.md has the same table.
const std::map<std::string, std::string>& refused() {
  static const std::map<std::string, std::string> table{
      {"catmark_fan", "edge 7-8 has 3 faces"},
      {"catmark_gregory_test4", "vertex 4 joins faces that share no edge"},
      {"catmark_nonman_edge100", "edge 200-201 has 100 faces"},
      {"catmark_nonman_quadpole360", "face 1 uses vertex 4 twice"},
      {"catmark_nonman_quadpole64", "face 1 uses vertex 4 twice"},
      {"catmark_nonman_quadpole8", "face 1 uses vertex 4 twice"},
      {"catmark_square_hedit0", "hierarchical edits are not supported"},
      {"catmark_square_hedit1", "hierarchical edits are not supported"},
      {"catmark_square_hedit2", "hierarchical edits are not supported"},
      {"catmark_square_hedit3", "hierarchical edits are not supported"},
      {"catmark_square_hedit4", "hierarchical edits are not supported"},
      {"catmark_val2_nonman", "edge 0-1 has 4 faces"},
      {"loop_nonman_edge100", "edge 100-101 has 100 faces"},
      {"loop_nonman_verts", "vertex 1 joins faces that share no edge"},
      {"loop_val2_interior", "edge 10-11 has 4 faces"},
  };
  return table;
}

std::string rule_name(BoundaryRule rule) {
  switch (rule) {
    case BoundaryRule::none:
      return "none";
    case BoundaryRule::edges:
      return "edges";
    default:
      return "edges_and_corners";
  }
}

}  // namespace

std::string name_of(const Case& c) {
  return c.shape + "_" + rule_name(c.boundary);
}

void PrintTo(const Case& c, std::ostream* out) {
  *out << name_of(c);
}

std::vector<std::string> shapes_with(const std::string& prefix) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(LIMES_TEST_DATA_DIR "/opensubdiv")) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".obj" && name.rfind(prefix, 0) == 0) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string refusal_of(const std::string& shape) {
  const auto found = refused().find(shape);
  return found == refused().end() ? "" : found->second;
}

std::vector<Case> manifold_cases(const std::string& prefix) {
  std::vector<Case> cases;
  for (const std::string& shape : shapes_with(prefix))
    if (refusal_of(shape).empty())
      for (const BoundaryRule rule :
           {BoundaryRule::none, BoundaryRule::edges, BoundaryRule::edges_and_corners})
        cases.push_back({shape, rule});
  return cases;
}

Mesh read_shape(const std::string& shape) {
  return read_mesh(LIMES_TEST_DATA_DIR "/opensubdiv/" + shape + ".obj").mesh;
}

double size_of(const Mesh& mesh) {
  Vec3 low = mesh.points[VertexId(0)];
  Vec3 high = low;
  for (const Vec3& p : mesh.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

}  // namespace limes::oracle
