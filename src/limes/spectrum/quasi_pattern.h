#pragma once

#include <optional>

#include "limes/mesh/mesh.h"

namespace limes {

// Quasi 4-8 subdivision chooses the edges that it splits by their lengths, so nothing says beforehand
// that the mesh around a vertex looks the same after every pass. [velho_quasi48] hopes for it
// ("quasi-stationary"); here it is looked at.

struct PatternOptions {
  int num_passes = 96;  ///< that are looked at
  int rings = 4;        ///< of faces around the vertex that make the pattern
  int kept_rings = 12;  ///< that are kept for the next pass; what is further out is cut off
};

/// What the passes of quasi-four-eight make of the mesh around a vertex.
struct QuasiPattern {
  int valence = 0;  ///< of the vertex after the last pass
  /// The pass after which the pattern, its next split edges included, is after every pass that follows
  /// what it was `period` passes before, turned about the vertex at most. Empty: not three times in a
  /// row within the passes that are looked at.
  std::optional<int> repeats_after;
  int period = 0;
  /// It is that of the regular 4-8 mesh with one vertex of this valence, and the edges opposite the newest
  /// vertices are split: what analyse() finds the eigenvalues of.
  bool regular = false;
};

/// Passes of the scheme itself (longest edges, bisection, smoothing) around vertex 0, which is moved back to
/// the origin after every pass; the mesh is scaled by powers of 2. Around it kept_rings rings of faces go on
/// to the next pass: the boundary that the cut leaves is at rest, and far enough from the pattern.
/// @param mesh  triangles in a plane; vertex 0 is not on their boundary
/// Precondition: rings < kept_rings.
[[nodiscard]] QuasiPattern quasi_pattern(const Mesh& mesh, const PatternOptions& options = {});

}  // namespace limes
