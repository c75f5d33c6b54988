#include "limes/study/leaf_selection.h"

#include <algorithm>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/text.h"

namespace limes {
namespace {
constexpr char untested = 2;
}  // namespace

Where parse_face_where(std::string_view text) {
  Where where = parse_where(text);
  if (where.kind == Where::Kind::boundary || where.kind == Where::Kind::vertex)
    throw InputError(
        "{} means vertices, not faces; a condition such as x > 0, group:NAME, part:NAME or all "
        "means faces",
        quote(where.text));
  return where;
}

LeafSelection::LeafSelection(const LocalRefinement& forest, std::string_view where)
    : where_(parse_face_where(where)) {
  const Mesh& control = forest.control();
  for (const VertexId v : control.topology.corners()) {
    box_.lower = box_.lower.cwiseMin(forest.position(v));
    box_.upper = box_.upper.cwiseMax(forest.position(v));
  }
  switch (where_.kind) {
    case Where::Kind::all:
      break;
    case Where::Kind::group:
    case Where::Kind::part: {
      roots_.assign(static_cast<std::size_t>(control.topology.num_faces()), false);
      const auto& groups = where_.kind == Where::Kind::group ? control.groups : control.parts;
      for (const FaceId f : faces_in_groups(groups, where_))
        roots_[static_cast<std::size_t>(f.value)] = true;
      break;
    }
    case Where::Kind::condition:
      condition_.emplace(where_.text, box_.diagonal());
      break;
    case Where::Kind::boundary:
    case Where::Kind::vertex:
      LIMES_ASSERT(false);
  }
  if (leaves(forest).empty()) fail(forest);
}

std::vector<FaceId> LeafSelection::leaves(const LocalRefinement& forest) {
  std::vector<FaceId> chosen;
  int since_check = 0;
  for (const FaceId f : forest.leaves()) {
    if (since_check++ % 4096 == 0) check_interrupt();
    const auto corners = forest.corners(f);
    const bool meant =
        condition_
            ? std::all_of(corners.begin(), corners.end(),
                          [&](VertexId v) { return holds_at(forest, v); })
            : roots_.empty() || roots_[static_cast<std::size_t>(forest.ancestry(f).root.value)];
    if (meant) chosen.push_back(f);
  }
  return chosen;
}

bool LeafSelection::holds_at(const LocalRefinement& forest, VertexId v) {
  if (v.value >= holds_.size())
    holds_.resize(static_cast<std::size_t>(forest.num_vertices()), untested);
  char& holds = holds_[v];
  if (holds == untested) holds = (*condition_)(forest.position(v)) ? 1 : 0;
  return holds == 1;
}

void LeafSelection::fail(const LocalRefinement& forest) const {
  if (!condition_) throw InputError("where = {}: the mesh has no face", quote(where_.text));
  std::vector<bool> counted(static_cast<std::size_t>(forest.num_vertices()), false);
  int met = 0;
  for (const FaceId f : forest.leaves())
    for (const VertexId v : forest.corners(f)) {
      const auto i = static_cast<std::size_t>(v.value);
      if (!counted[i] && (*condition_)(forest.position(v))) ++met;
      counted[i] = true;
    }
  if (met == 0)
    throw InputError("where = {} means no vertex; on the limit surface {}", quote(where_.text),
                     describe_extent(box_.lower, box_.upper));
  throw InputError(
      "where = {} means {} of the vertices but no face, of which it must mean all corners; widen "
      "it, "
      "or start from a finer mesh",
      quote(where_.text), met);
}

}  // namespace limes
