#pragma once

#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTable.h>
#include <opensubdiv/far/topologyRefiner.h>

#include <array>
#include <memory>
#include <vector>

#include "limes/mesh/mesh.h"
#include "limes/subdiv/scheme.h"

namespace limes::oracle {

// OpenSubdiv, in double precision, on our meshes: refined levels, and its limit surface by deep
// feature-adaptive patches.

namespace osd = OpenSubdiv;

/// @throws std::runtime_error if OpenSubdiv rejects the mesh
std::unique_ptr<osd::Far::TopologyRefiner> make_refiner(const Mesh& mesh, const Scheme& scheme,
                                                        BoundaryRule boundary);

/// Refines uniformly; [k] are the positions of level k, [0] those of the mesh.
std::vector<std::vector<Vec3>> refine_uniformly(osd::Far::TopologyRefiner& refiner,
                                                const Mesh& mesh, int levels);

/// Limit positions of the vertices of the last level of a uniformly refined mesh, by the masks.
std::vector<Vec3> limit_of_last_level(const osd::Far::TopologyRefiner& refiner,
                                      const std::vector<Vec3>& last);

/// Two tangents at these vertices, by the masks.
std::array<std::vector<Vec3>, 2> tangents_of_last_level(const osd::Far::TopologyRefiner& refiner,
                                                        const std::vector<Vec3>& last);

/// Whether the limit mask at a vertex is exact. It is not while a crease there is semi-sharp, at a
/// dart (OpenSubdiv takes the smooth mask beside a sharp edge), and at an interior vertex of
/// valence 2 (it returns the vertex itself).
bool has_exact_limit(const osd::Far::TopologyLevel& level, int vertex);

/// Patches of the limit surface, isolated to OpenSubdiv's deepest level, 10.
class LimitPatches {
 public:
  LimitPatches(const Mesh& mesh, const Scheme& scheme, BoundaryRule boundary);

  struct Point {
    bool exists = false;   ///< false in holes
    bool regular = false;  ///< on a B-spline patch; otherwise an approximation next to a vertex
    Vec3 x, xu, xv, xuu, xuv, xvv;
  };
  /// Derivatives are with respect to the (u, v) passed in. OpenSubdiv's own are, in a face that is
  /// no quad, with respect to parameters in which a quadrant is half a unit wide; its second derivatives
  /// have the wrong sign on the triangles of loop that lie upside down.
  Point evaluate(FaceId f, int corner, const Vec2& uv) const;

 private:
  std::unique_ptr<osd::Far::TopologyRefiner> refiner_;
  std::unique_ptr<osd::Far::PatchTable> table_;
  std::unique_ptr<osd::Far::PatchMap> map_;
  std::vector<int> first_ptex_;
  std::vector<Vec3> points_;
  Topology topology_;
};

}  // namespace limes::oracle
