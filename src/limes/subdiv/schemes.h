#pragma once

#include <span>

#include "limes/subdiv/scheme.h"

namespace limes {

/// Every scheme there is; command line, documentation and tests iterate this list.
[[nodiscard]] std::span<const Scheme> all_schemes();

/// @throws UsageError for an unknown name, listing the known ones
[[nodiscard]] const Scheme& find_scheme(std::string_view name);

/// `linear` on triangles, each of which becomes four: what local refinement takes. It is no row of the
/// list, where `linear` makes quads of every face.
[[nodiscard]] const Scheme& linear_triangles();

// The rules, one file per scheme. A rule writes into a cleared stencil.

void catmull_clark_face(const FaceNeighbourhood& n, const RuleOptions& options, Stencil& out);
void catmull_clark_edge(const EdgeNeighbourhood& n, const RuleOptions& options, Stencil& out);
void catmull_clark_vertex(const VertexNeighbourhood& n, const RuleOptions& options, Stencil& out);

void loop_edge(const EdgeNeighbourhood& n, const RuleOptions& options, Stencil& out);
void loop_vertex(const VertexNeighbourhood& n, const RuleOptions& options, Stencil& out);

void linear_edge(const EdgeNeighbourhood& n, const RuleOptions& options, Stencil& out);
/// Also of other schemes whose old vertices stay.
void linear_vertex(const VertexNeighbourhood& n, const RuleOptions& options, Stencil& out);

void doo_sabin_corner(const FaceNeighbourhood& face, int corner, const RuleOptions& options,
                      Stencil& out);

void repeated_averaging_corner(const FaceNeighbourhood& face, int corner,
                               const RuleOptions& options, Stencil& out);

void sqrt3_face(const FaceNeighbourhood& face, const RuleOptions& options, Stencil& out);
void sqrt3_edge(const EdgeNeighbourhood& edge, const RuleOptions& options, Stencil& out);
void sqrt3_vertex(const VertexNeighbourhood& v, const RuleOptions& options, Stencil& out);

void four_eight_face(const FaceNeighbourhood& face, const RuleOptions& options, Stencil& out);
void four_eight_edge(const EdgeNeighbourhood& edge, const RuleOptions& options, Stencil& out);
void four_eight_vertex(const VertexNeighbourhood& v, const RuleOptions& options, Stencil& out);

void kobbelt_face(const FaceNeighbourhood& n, const RuleOptions& options, Stencil& out);
void kobbelt_edge(const EdgeNeighbourhood& n, const RuleOptions& options, Stencil& out);

void butterfly_edge(const EdgeNeighbourhood& edge, const RuleOptions& options, Stencil& out);

}  // namespace limes
