#include "limes/subdiv/regular_rules.h"

#include <array>
#include <span>
#include <vector>

#include "limes/subdiv/crease.h"

namespace limes {
namespace {

using Source = Stencil::Source;

constexpr std::array<VertexId, 4> neighbours{VertexId(1), VertexId(2), VertexId(3), VertexId(4)};
constexpr std::array<FaceId, 4> faces{FaceId(0), FaceId(1), FaceId(2), FaceId(3)};

VertexNeighbourhood vertex_on_line(std::span<const float> sharpness,
                                   std::span<const float> child_sharpness) {
  const std::size_t n = sharpness.size();
  return {VertexId(0),
          std::span(neighbours).first(n),
          std::span(faces).first(n == 4 ? 4 : n - 1),
          0.0F,
          0.0F,
          sharpness,
          child_sharpness};
}

EdgeNeighbourhood edge_on_line(float sharpness, bool boundary) {
  return {.ends = {VertexId(LineRules::self), VertexId(LineRules::next)},
          .faces = {FaceId(0), boundary ? FaceId() : FaceId(3)},
          .face_sizes = {4, boundary ? 0 : 4},
          .num_faces = boundary ? 1 : 2,
          .opposite = {},
          .sharpness = sharpness,
          .child_sharp = is_sharp(decayed(sharpness))};
}

/// Whether a stencil consists of groups of these sources and sizes, in this order.
struct Shape {
  Source source;
  std::size_t size;
};
bool has_shape(const Stencil& stencil, std::span<const Shape> shape) {
  if (stencil.groups().size() != shape.size()) return false;
  for (std::size_t g = 0; g < shape.size(); ++g) {
    const Stencil::Group& group = stencil.groups()[g];
    if (group.source != shape[g].source || stencil.ids(group).size() != shape[g].size) return false;
  }
  return true;
}

}  // namespace

std::optional<RegularMasks> regular_masks(const Scheme& scheme) {
  if (scheme.split != Split::quads || scheme.wide) return {};
  Stencil face;
  scheme.face_rule({FaceId(0), neighbours, {}}, {}, face);
  const LineRules smooth = line_rules(scheme, 0.0F, false);
  constexpr std::array<Shape, 1> face_shape{{{Source::vertex, 4}}};
  constexpr std::array<Shape, 2> edge_shape{{{Source::vertex, 2}, {Source::face_point, 2}}};
  constexpr std::array<Shape, 3> vertex_shape{
      {{Source::vertex, 1}, {Source::vertex, 4}, {Source::face_point, 4}}};
  if (!has_shape(face, face_shape) || !has_shape(smooth.edge, edge_shape) ||
      !has_shape(smooth.vertex, vertex_shape))
    return {};
  const auto weight = [](const Stencil& s, std::size_t g) { return s.groups()[g].weight; };
  return RegularMasks{weight(face, 0),          weight(smooth.edge, 0),   weight(smooth.edge, 1),
                      weight(smooth.vertex, 0), weight(smooth.vertex, 1), weight(smooth.vertex, 2)};
}

LineRules line_rules(const Scheme& scheme, float sharpness, bool boundary) {
  const float child = decayed(sharpness);
  const std::array<float, 4> edges{sharpness, 0.0F, sharpness, 0.0F};
  const std::array<float, 4> child_edges{child, 0.0F, child, 0.0F};
  const std::size_t n = boundary ? 3 : 4;
  LineRules rules;
  scheme.edge_rule(edge_on_line(sharpness, boundary), {}, rules.edge);
  scheme.vertex_rule(vertex_on_line(std::span(edges).first(n), std::span(child_edges).first(n)), {},
                     rules.vertex);
  return rules;
}

namespace {

/// Row of a vertex on a line among triangles whose ring starts at a place.
void write_triangle_vertex(const Scheme& scheme, float sharpness, bool boundary, int start,
                           Stencil& out) {
  const float child = decayed(sharpness);
  std::vector<VertexId> ends;
  std::vector<FaceId> ring_faces;
  std::vector<float> edges, child_edges;
  const int count = boundary ? 4 : 6;
  for (int k = 0; k < count; ++k) {
    const int place = boundary ? k : (start + k) % 6;  // less 1
    const bool on_line = place % 3 == 0;
    ends.emplace_back(1 + place);
    edges.push_back(on_line ? sharpness : 0.0F);
    child_edges.push_back(on_line ? child : 0.0F);
    if (k < (boundary ? 3 : 6)) ring_faces.emplace_back(k);
  }
  scheme.vertex_rule({VertexId(0), ends, ring_faces, 0.0F, 0.0F, edges, child_edges}, {}, out);
}

}  // namespace

std::optional<RegularTriangleMasks> regular_triangle_masks(const Scheme& scheme) {
  if (scheme.split != Split::triangles || scheme.wide) return {};
  const TriangleLineRules smooth = triangle_line_rules(scheme, 0.0F, false);
  constexpr std::array<Shape, 2> edge_shape{{{Source::vertex, 2}, {Source::vertex, 2}}};
  constexpr std::array<Shape, 2> vertex_shape{{{Source::vertex, 1}, {Source::vertex, 6}}};
  if (!has_shape(smooth.edge, edge_shape) || !has_shape(smooth.vertex[0], vertex_shape)) return {};
  const auto weight = [](const Stencil& s, std::size_t g) { return s.groups()[g].weight; };
  return RegularTriangleMasks{weight(smooth.edge, 0), weight(smooth.edge, 1),
                              weight(smooth.vertex[0], 0), weight(smooth.vertex[0], 1)};
}

TriangleLineRules triangle_line_rules(const Scheme& scheme, float sharpness, bool boundary) {
  TriangleLineRules rules;
  scheme.edge_rule({.ends = {VertexId(TriangleLineRules::self), VertexId(TriangleLineRules::next)},
                    .faces = {FaceId(0), boundary ? FaceId() : FaceId(5)},
                    .face_sizes = {3, boundary ? 0 : 3},
                    .num_faces = boundary ? 1 : 2,
                    .opposite = {VertexId(2), boundary ? VertexId() : VertexId(6)},
                    .sharpness = sharpness,
                    .child_sharp = is_sharp(decayed(sharpness))},
                   {}, rules.edge);
  for (int start = 0; start < 3; ++start)
    write_triangle_vertex(scheme, sharpness, boundary, start,
                          rules.vertex[static_cast<std::size_t>(start)]);
  return rules;
}

}  // namespace limes
