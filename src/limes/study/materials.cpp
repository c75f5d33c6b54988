#include "limes/study/materials.h"

#include <algorithm>

#include "limes/core/error.h"
#include "limes/problem/selection.h"

namespace limes {
namespace {

[[noreturn]] void fail_two_materials(FaceId face, const Place& second, const Place& first) {
  const Place& place = first.is_override ? first : second;
  fail_at(place, "face {} has two materials, here and in {}", face.value,
          spoken(first.is_override ? second : first));
}

}  // namespace

std::vector<int> materials_of_faces(const Problem& problem, const Mesh& mesh,
                                    const Adjacency& adjacency, std::span<const Vec3> points) {
  std::vector<int> material(static_cast<std::size_t>(mesh.topology.num_faces()), -1);
  int rest = -1;
  for (int m = 0; m < static_cast<int>(problem.materials.size()); ++m) {
    const MaterialSettings& settings = problem.materials[static_cast<std::size_t>(m)];
    if (!settings.where) {
      rest = m;
      continue;
    }
    const Place& place = settings.origin.of("where");
    const Selection chosen(mesh, adjacency, points, *settings.where, place);
    for (const FaceId f : chosen.faces()) {
      int& of_face = material[static_cast<std::size_t>(f.value)];
      if (of_face >= 0)
        fail_two_materials(f, place,
                           problem.materials[static_cast<std::size_t>(of_face)].origin.of("where"));
      of_face = m;
    }
  }
  std::replace(material.begin(), material.end(), -1, rest);
  return material;
}

void fail_no_material(const Problem& problem, FaceId face) {
  Place place{problem.file.string(), false, 0};
  for (const MaterialSettings& m : problem.materials)
    place = culprit(place, {m.origin.of("where")});
  fail_at(place, "face {} of the refined mesh has no material; give one without 'where'",
          face.value);
}

}  // namespace limes
