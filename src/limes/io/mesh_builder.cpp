#include "limes/io/mesh_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "limes/core/error.h"

namespace limes {
namespace {
constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
}

void MeshBuilder::add_point(double x, double y, double z) {
  if (points_.size() == most) throw InputError("{}: more than {} vertices", file_, most);
  points_.push_back(Vec3(x, y, z));
}

bool MeshBuilder::add_face(std::span<const std::int64_t> corners, std::int64_t line) {
  if (corners.size() < 3) {
    remarks_.add(line, "face with fewer than 3 corners left out");
    ++num_small_faces_;
    return false;
  }
  if (static_cast<std::int64_t>(corners_.size() + corners.size()) > most)
    throw InputError("{}: more than {} face corners; split the model", file_, most);
  for (const std::int64_t v : corners) {
    if (v < 0 || v >= most) fail_vertex(v, line);
    corners_.emplace_back(v);
  }
  offsets_.push_back(static_cast<int>(corners_.size()));
  if (line > 0) lines_.push_back(static_cast<int>(std::min(line, most)));
  return true;
}

std::string MeshBuilder::where(std::int64_t line, int face) const {
  return line > 0 ? fmt::format("{}:{}", file_, line) : fmt::format("{}: face {}", file_, face);
}

void MeshBuilder::fail_vertex(std::int64_t vertex, std::int64_t line) const {
  throw InputError("{}: vertex {} does not exist; vertices are numbered from {}, at most to {}",
                   where(line, num_faces()), vertex + first_number_, first_number_,
                   most - 1 + first_number_);
}

void MeshBuilder::check_corners() const {
  const auto beyond = std::find_if(corners_.begin(), corners_.end(),
                                   [&](VertexId v) { return v.value >= num_points(); });
  if (beyond == corners_.end()) return;
  const int corner = static_cast<int>(beyond - corners_.begin());
  const auto next = std::upper_bound(offsets_.begin(), offsets_.end(), corner);
  const auto face = static_cast<std::size_t>(next - offsets_.begin() - 1);
  throw InputError("{}: vertex {} does not exist; the file has {} vertices, numbered from {}",
                   where(lines_.empty() ? 0 : lines_[face], static_cast<int>(face)),
                   beyond->value + std::int64_t{first_number_}, num_points(), first_number_);
}

Mesh MeshBuilder::build() {
  check_corners();
  if (num_faces() == 0)
    throw InputError("{}: no faces{}; a mesh needs at least one face with three corners", file_,
                     num_small_faces_ == 0 ? ""
                                           : fmt::format(" ({} with fewer than 3 corners left out)",
                                                         num_small_faces_));
  Mesh mesh;
  mesh.topology = Topology(num_points(), std::move(offsets_), std::move(corners_));
  mesh.points = std::move(points_);
  mesh.face_lines = std::move(lines_);
  return mesh;
}

}  // namespace limes
