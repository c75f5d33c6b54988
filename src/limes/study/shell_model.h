#pragma once

#include <memory>
#include <string>
#include <vector>

#include "limes/fem/mitc4.h"
#include "limes/mesh/adjacency.h"
#include "limes/mesh/seams.h"
#include "limes/study/control_mesh.h"
#include "limes/subdiv/hanging_faces.h"

namespace limes {

/// A shell problem on its mesh of four-node elements: what was read, refined, placed, selected.
/// Unknown 6 n + i is displacement i of the vertices v with node[v] == n, 6 n + 3 + i their rotation
/// about axis i.
struct ShellModel {
  Problem problem;
  Mesh control;                          ///< as in the file
  std::unique_ptr<Mesh> mesh;            ///< points are the nodes; faces as in `faces`
  std::unique_ptr<Adjacency> adjacency;  ///< of *mesh

  /// Director at each corner of each face; one and the same around a smooth node.
  IdArray<HalfedgeId, Vec3> director;
  /// Nodes with one director: their rotation about it is no unknown. The others are on kinks.
  IdArray<VertexId, char> smooth;
  /// The vertex whose unknowns a vertex has: the lowest one tied to it by a seam, else itself.
  IdArray<VertexId, VertexId> node;
  /// Nodes inside a side of an element, whose unknowns follow from those of its ends (shell_hanging.h).
  IdArray<VertexId, char> hangs;
  std::vector<int> material_of_face;  ///< index in problem.materials
  double diagonal = 0;                ///< of the box around the nodes
  Vec3 centre = Vec3::Zero();         ///< of that box
  std::vector<std::string> remarks;

  /// The faces of *mesh: elements, in whose sides nodes hang.
  HangingFaces faces;

  [[nodiscard]] int num_unknowns() const { return 6 * mesh->points.size(); }
  /// Corner i of 4 of an element.
  [[nodiscard]] HalfedgeId corner(FaceId face, int i) const { return faces.corner(face, i); }
  [[nodiscard]] VertexId node_at(FaceId face, int i) const {
    return node[mesh->topology.corner(corner(face, i))];
  }
  [[nodiscard]] ShellQuad quad(FaceId face) const;
  [[nodiscard]] ShellSection section(FaceId face) const;
  /// Unknowns of an element.
  [[nodiscard]] ShellVector unknowns(FaceId face, const VectorX& u) const;
  /// Adds an element's vector at its place.
  void scatter(FaceId face, const ShellVector& element, VectorX& out) const;
};

/// Refines a control mesh, places nodes and directors, finds the materials.
///
/// Nodes are the limit points of the scheme, or refined halfway and put on the exact surface after
/// every level. Directors are the exact surface's normals, else the limit surface's, else (bilinear
/// and interpolatory schemes) means of the faces' normals between kinks.
/// @throws InputError for a mesh that cannot be refined, has faces that are no quads or degenerate
///         ones, and for faces with no material or two
[[nodiscard]] ShellModel build_shell_model(const Problem& problem, Mesh control);

/// The same for a mesh whose vertices are the nodes, as they are.
/// @param mesh     of quads
/// @param tied     its edges on seams
/// @param hanging  its vertices inside sides
/// @throws InputError as above
[[nodiscard]] ShellModel shell_model_on(const Problem& problem, Mesh mesh,
                                        const std::vector<TiedEdge>& tied,
                                        std::span<const HangingVertex> hanging = {});

/// @throws InputError for what no mesh can be made of for kind "mitc4": defects, holes, the scheme
void require_shell_control(const Problem& problem, const Mesh& control);

/// build_shell_model() for the mesh file that the problem names.
[[nodiscard]] ShellModel read_shell_model(const Problem& problem, const ModelOptions& options = {});

}  // namespace limes
