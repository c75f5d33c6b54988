#include "limes/io/obj_polylines.h"

#include <algorithm>

#include "limes/io/lines.h"

namespace limes {
namespace {

bool is_closed(const std::vector<std::int64_t>& vertices) {
  return vertices.size() > 2 && vertices.front() == vertices.back();
}

}  // namespace

void ObjPolylines::add(std::span<const std::int64_t> vertices, std::int64_t line) {
  if (!statements_.empty() && !is_closed(statements_.back().vertices) &&
      statements_.back().vertices.back() == vertices.front()) {
    auto& known = statements_.back().vertices;
    known.insert(known.end(), vertices.begin() + 1, vertices.end());
    statements_.back().line = line;
  } else {
    statements_.push_back({{vertices.begin(), vertices.end()}, line});
  }
}

std::vector<Polyline> ObjPolylines::build(std::string_view file,
                                          const IdArray<VertexId, Vec3>& points) const {
  if (statements_.empty())
    throw InputError("{}: no polylines; curve schemes refine 'l' lines, other schemes refine faces",
                     file);
  std::vector<Polyline> curves;
  for (const Statement& s : statements_) {
    const auto beyond = std::find_if(s.vertices.begin(), s.vertices.end(),
                                     [&](std::int64_t v) { return v >= points.size(); });
    if (beyond != s.vertices.end())
      throw error_at(file, s.line,
                     "vertex {} does not exist; the file has {} vertices, numbered from 1",
                     *beyond + 1, points.size());
    Polyline curve;
    curve.closed = is_closed(s.vertices);
    for (std::size_t i = 0; i + (curve.closed ? 1 : 0) < s.vertices.size(); ++i)
      curve.points.push_back(points[VertexId(s.vertices[i])]);
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace limes
