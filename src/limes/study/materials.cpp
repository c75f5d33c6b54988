#include "limes/study/materials.h"

#include <algorithm>

#include "limes/core/error.h"
#include "limes/study/selection.h"

namespace limes {

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
    const Selection chosen(mesh, adjacency, points, *settings.where, problem.file.string(),
                           settings.where_line);
    for (const FaceId f : chosen.faces()) {
      int& of_face = material[static_cast<std::size_t>(f.value)];
      if (of_face >= 0)
        throw InputError("{}:{}: face {} has two materials, here and in line {}",
                         problem.file.string(), settings.line, f.value,
                         problem.materials[static_cast<std::size_t>(of_face)].line);
      of_face = m;
    }
  }
  std::replace(material.begin(), material.end(), -1, rest);
  return material;
}

}  // namespace limes
