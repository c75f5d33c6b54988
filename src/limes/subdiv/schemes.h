#pragma once

#include <span>

#include "limes/subdiv/scheme.h"

namespace limes {

/// Every scheme there is; command line, documentation and tests iterate this list.
[[nodiscard]] std::span<const Scheme> all_schemes();

/// @throws UsageError for an unknown name, listing the known ones
[[nodiscard]] const Scheme& find_scheme(std::string_view name);

// The rules, one file per scheme. A rule writes into a cleared stencil.

void catmull_clark_face(const FaceNeighbourhood& n, Stencil& out);
void catmull_clark_edge(const EdgeNeighbourhood& n, const Features& features, Stencil& out);
void catmull_clark_vertex(const VertexNeighbourhood& n, Stencil& out);

void loop_edge(const EdgeNeighbourhood& n, const Features& features, Stencil& out);
void loop_vertex(const VertexNeighbourhood& n, Stencil& out);

void linear_edge(const EdgeNeighbourhood& n, const Features& features, Stencil& out);
void linear_vertex(const VertexNeighbourhood& n, Stencil& out);

}  // namespace limes
