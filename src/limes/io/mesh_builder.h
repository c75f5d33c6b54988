#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "limes/io/io.h"
#include "limes/io/remarks.h"

namespace limes {

/// What all readers do alike: collect points and faces, leave out faces with fewer than three
/// corners, check every vertex number once all vertices are known, refuse empty meshes.
class MeshBuilder {
 public:
  /// @param first_number the format's number of the first vertex, for messages
  MeshBuilder(std::string_view file, int first_number) : file_(file), first_number_(first_number) {}

  void add_point(double x, double y, double z);
  /// @param corners vertices counted from 0; they may come later in the file
  /// @param line    1-based, 0 in binary files
  /// @return        whether the face was kept
  bool add_face(std::span<const std::int64_t> corners, std::int64_t line);
  void add_remark(std::int64_t line, std::string_view what) { remarks_.add(line, what); }

  [[nodiscard]] int num_points() const { return points_.size(); }
  [[nodiscard]] int num_faces() const { return static_cast<int>(offsets_.size()) - 1; }

  [[nodiscard]] const IdArray<VertexId, Vec3>& points() const { return points_; }
  /// Topology, points and face lines; called once, at the end.
  [[nodiscard]] Mesh build();
  [[nodiscard]] std::vector<std::string> remarks() const { return remarks_.sentences(); }

 private:
  [[noreturn]] void fail_vertex(std::int64_t vertex, std::int64_t line) const;
  void check_corners() const;
  [[nodiscard]] std::string where(std::int64_t line, int face) const;

  std::string file_;
  int first_number_;
  IdArray<VertexId, Vec3> points_;
  std::vector<int> offsets_ = {0};
  std::vector<VertexId> corners_;
  std::vector<int> lines_;
  std::int64_t num_small_faces_ = 0;
  Remarks remarks_{file_};
};

}  // namespace limes
