#pragma once

#include "limes/mesh/mesh.h"
#include "limes/subdiv/quasi_smoothing.h"

namespace limes {

// Quasi 4-8 subdivision of triangles [velho_quasi48]: every step puts vertices into the longest edges,
// then smooths. Topology depends on positions, and the boundary on normals: no matrix makes the
// step.

/// Which edges a step splits.
enum class QuasiSplit {
  longest,      ///< the longest, on any mesh (Algorithm 1)
  interleaved,  ///< those between vertices of valence 8, on a regular 4-8 mesh (section 2.2)
  normal        ///< all: two interleaved steps count as one
};

struct QuasiOptions {
  int levels = 1;  ///< steps, each with a smoothing; twice as many with QuasiSplit::normal
  QuasiSplit split = QuasiSplit::longest;
  QuasiSmoothingRules rules = {};
};

struct QuasiRefinement {
  Mesh mesh;
  int num_cut_faces = 0;  ///< of the control mesh: not triangles, cut before the first step
  std::vector<int> num_unsplit_faces;  ///< per step: their neighbours took all their edges
  bool collapsed = false;              ///< closed, and without the volume that the control mesh has
};

/// Uniform refinement with tags, holes, groups and parts. Sharp edges and vertices are the paper's tags,
/// as long as they are sharp.
/// @throws InputError for a mesh that cannot be refined, or is not regular where QuasiSplit asks for
///         that
[[nodiscard]] QuasiRefinement refine_quasi_four_eight(const Mesh& mesh,
                                                      const QuasiOptions& options);

}  // namespace limes
