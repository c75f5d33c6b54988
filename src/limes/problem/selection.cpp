#include "limes/problem/selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "limes/core/error.h"
#include "limes/core/text.h"
#include "limes/problem/condition.h"
#include "limes/problem/expression.h"
#include "limes/problem/suggest.h"

namespace limes {
namespace {

VertexId parse_vertex(std::string_view word) {
  const auto number = parse_integer(word);
  if (!number || *number < 0 || *number > std::numeric_limits<std::int32_t>::max())
    throw InputError("{} is no vertex; they count from 0, as in vertex:12", quote(word));
  return VertexId(*number);
}

/// A word with a colon that is no formula: group:, part:, vertex: or a misspelt one of them.
std::optional<Where> parse_prefixed(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || text.find('?') < colon) return std::nullopt;
  const std::string_view prefix = trim(text.substr(0, colon));
  const std::string_view rest = trim(text.substr(colon + 1));
  Where where;
  where.text = text;
  if (prefix == "vertex") {
    where.kind = Where::Kind::vertex;
    where.vertex = parse_vertex(rest);
    return where;
  }
  if (prefix != "group" && prefix != "part") {
    constexpr std::array<std::string_view, 3> known{"group", "part", "vertex"};
    throw InputError("{} selects nothing; {}", quote(text), suggest(prefix, known));
  }
  if (rest.empty()) throw InputError("{} lacks a name after the colon", quote(text));
  where.kind = prefix == "group" ? Where::Kind::group : Where::Kind::part;
  where.name = rest;
  return where;
}

bool is_word(std::string_view text) {
  for (const char c : text)
    if (!(c >= 'a' && c <= 'z') && !(c >= 'A' && c <= 'Z')) return false;
  return true;
}

}  // namespace

Where parse_where(std::string_view text) {
  text = trim(text);
  constexpr std::array<std::string_view, 5> words{"all", "boundary", "group:NAME", "part:NAME",
                                                  "vertex:NUMBER"};
  if (text.empty())
    throw InputError("an empty text selects nothing; a condition such as x == 0, or \"all\", does");
  if (auto where = parse_prefixed(text)) return *where;
  Where where;
  where.text = text;
  if (text == "all") return where;
  where.kind = text == "boundary" ? Where::Kind::boundary : Where::Kind::condition;
  if (text == "boundary") return where;
  if (is_word(text))
    throw InputError("{} selects nothing; {}, or a condition such as x == 0", quote(text),
                     suggest(text, words));
  (void)Expression(text);
  return where;
}

std::vector<FaceId> faces_in_groups(const std::vector<FaceGroup>& groups, const Where& where) {
  const std::string_view kind = where.kind == Where::Kind::group ? "group" : "part";
  std::vector<FaceId> faces;
  for (const FaceGroup& group : groups)
    if (group.name == where.name) faces.insert(faces.end(), group.faces.begin(), group.faces.end());
  if (!faces.empty()) return faces;
  if (groups.empty())
    throw InputError("where = {} selects nothing: the mesh has no {}s", quote(where.text), kind);
  std::vector<std::string_view> names;
  for (const FaceGroup& group : groups)
    if (!group.faces.empty()) names.push_back(group.name);
  throw InputError("where = {} selects nothing: there is no face in a {} of that name; {}",
                   quote(where.text), kind, suggest(where.name, names));
}

Selection::Selection(const Mesh& mesh, const Adjacency& adjacency, std::span<const Vec3> points,
                     std::string_view where, Place place)
    : mesh_(&mesh),
      adjacency_(&adjacency),
      place_(std::move(place)),
      vertices_(static_cast<std::size_t>(mesh.topology.num_vertices()), false) {
  LIMES_ASSERT(points.size() == vertices_.size());
  try {
    where_ = parse_where(where);
  } catch (const InputError& error) {
    fail_at(place_, "where: {}", error.what());
  }
  switch (where_.kind) {
    case Where::Kind::all:
      for (std::size_t v = 0; v < vertices_.size(); ++v)
        vertices_[v] = used(v);
      break;
    case Where::Kind::boundary:
      select_boundary();
      break;
    case Where::Kind::group:
      select_group(mesh.groups);
      break;
    case Where::Kind::part:
      select_group(mesh.parts);
      break;
    case Where::Kind::vertex:
      select_vertex();
      break;
    case Where::Kind::condition:
      select_condition(points);
      break;
  }
}

void Selection::fail(const std::string& what) const {
  fail_at(place_, "where = {} {}", quote(where_.text), what);
}

bool Selection::used(std::size_t vertex) const {
  return adjacency_->ring_start(VertexId(static_cast<std::int64_t>(vertex))).valid();
}

void Selection::select_boundary() {
  bool any = false;
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    vertices_[v] = adjacency_->is_boundary(VertexId(static_cast<std::int64_t>(v)));
    any = any || vertices_[v];
  }
  if (!any) fail("selects nothing: the mesh has no boundary");
}

void Selection::select_group(const std::vector<FaceGroup>& groups) {
  faces_.assign(static_cast<std::size_t>(mesh_->topology.num_faces()), false);
  try {
    for (const FaceId f : faces_in_groups(groups, where_)) {
      faces_[static_cast<std::size_t>(f.value)] = true;
      for (const VertexId v : mesh_->topology.face(f))
        vertices_[static_cast<std::size_t>(v.value)] = true;
    }
  } catch (const InputError& error) {
    fail_at(place_, "{}", error.what());
  }
}

void Selection::select_vertex() {
  const int v = where_.vertex.value;
  const int count = mesh_->topology.num_vertices();
  if (v >= count)
    fail(fmt::format("does not exist: vertices count from 0 to {} after refinement", count - 1));
  if (!used(static_cast<std::size_t>(v))) fail("selects nothing: no face uses that vertex");
  vertices_[static_cast<std::size_t>(v)] = true;
}

void Selection::select_condition(std::span<const Vec3> points) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!used(v)) continue;
    low = low.cwiseMin(points[v]);
    high = high.cwiseMax(points[v]);
  }
  const Condition condition(where_.text, (high - low).norm());
  bool any = false;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!used(v)) continue;
    try {
      vertices_[v] = condition(points[v]);
    } catch (const InputError& error) {
      fail_at(place_, "{}", error.what());
    }
    any = any || vertices_[v];
  }
  if (!any)
    fail("selects no vertex; after refinement, on the limit surface, " +
         describe_extent(low, high));
}

std::vector<FaceId> Selection::faces() const {
  const Topology& topology = mesh_->topology;
  std::vector<FaceId> result;
  for (int f = 0; f < topology.num_faces(); ++f) {
    const auto corners = topology.face(FaceId(f));
    const bool selected =
        faces_.empty()
            ? std::all_of(corners.begin(), corners.end(),
                          [&](VertexId v) { return vertices_[static_cast<std::size_t>(v.value)]; })
            : faces_[static_cast<std::size_t>(f)];
    if (selected) result.emplace_back(f);
  }
  return result;
}

std::vector<HalfedgeId> Selection::boundary_edges() const {
  std::vector<HalfedgeId> result;
  for (int i = 0; i < mesh_->topology.num_corners(); ++i) {
    const HalfedgeId h(i);
    if (adjacency_->twin(h).valid()) continue;
    const bool selected = faces_.empty()
                              ? vertices_[static_cast<std::size_t>(adjacency_->from(h).value)] &&
                                    vertices_[static_cast<std::size_t>(adjacency_->to(h).value)]
                              : faces_[static_cast<std::size_t>(adjacency_->face(h).value)];
    if (selected) result.push_back(h);
  }
  return result;
}

}  // namespace limes
