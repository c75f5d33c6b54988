#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "limes/mesh/mesh.h"

namespace limes::witness {

/// A mesh as other libraries hand it over.
struct PlainMesh {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;
};

/// Corners of a face, turned so that the lowest comes first.
inline std::vector<int> canonical(std::vector<int> face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

/// Why two meshes are not the same up to numbering, with positions within `tolerance`; empty if they
/// are. Vertices are matched by position.
inline std::string difference(const Mesh& ours, const PlainMesh& theirs, double tolerance) {
  if (static_cast<int>(theirs.points.size()) != ours.points.size())
    return fmt::format("{} vertices, not {}", theirs.points.size(), ours.points.size());
  std::vector<int> match(theirs.points.size());
  for (std::size_t i = 0; i < theirs.points.size(); ++i) {
    int best = 0;
    for (int v = 1; v < ours.points.size(); ++v)
      if ((ours.points[VertexId(v)] - theirs.points[i]).norm() <
          (ours.points[VertexId(best)] - theirs.points[i]).norm())
        best = v;
    const double gap = (ours.points[VertexId(best)] - theirs.points[i]).norm();
    if (gap > tolerance) return fmt::format("their vertex {} is {} away", i, gap);
    match[i] = best;
  }
  std::multiset<std::vector<int>> our_faces, their_faces;
  for (int f = 0; f < ours.topology.num_faces(); ++f) {
    std::vector<int> face;
    for (const VertexId v : ours.topology.face(FaceId(f)))
      face.push_back(v.value);
    our_faces.insert(canonical(face));
  }
  for (std::vector<int> face : theirs.faces) {
    for (int& v : face)
      v = match[static_cast<std::size_t>(v)];
    their_faces.insert(canonical(face));
  }
  return our_faces == their_faces ? "" : "faces differ";
}

}  // namespace limes::witness
