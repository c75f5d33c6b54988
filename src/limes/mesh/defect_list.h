#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "limes/mesh/defects.h"

namespace limes {

/// Gathers the defects of one mesh; keeps the first ten of each kind and counts the others.
class DefectList {
 public:
  explicit DefectList(const Mesh& mesh) : mesh_(mesh) {}

  /// Whether the next defect of the kind is listed in full; if not, add() only counts it.
  [[nodiscard]] bool has_room(DefectKind kind) const { return count(kind) < most; }
  void add(DefectKind kind, std::vector<FaceId> faces, std::vector<VertexId> vertices,
           std::string message) {
    ++counts_[static_cast<std::size_t>(kind)];
    if (count(kind) > most) return;
    std::sort(faces.begin(), faces.end());
    const bool repeats = kind == DefectKind::duplicate_face || kind == DefectKind::opposite_faces;
    const int line = faces.empty() ? 0 : line_of(repeats ? faces.back() : faces.front());
    defects_.push_back({kind, std::move(faces), std::move(vertices), line, std::move(message)});
  }
  /// In the file; 0: unknown.
  [[nodiscard]] int line_of(FaceId face) const {
    return mesh_.face_lines.empty() ? 0 : mesh_.face_lines[static_cast<std::size_t>(face.value)];
  }
  /// All of them, ordered by kind.
  [[nodiscard]] std::vector<Defect> take() {
    for (std::size_t k = 0; k < counts_.size(); ++k) {
      const auto kind = static_cast<DefectKind>(k);
      if (count(kind) > most)
        defects_.push_back(
            {kind,
             {},
             {},
             0,
             fmt::format("{} more of this kind: {}", count(kind) - most, name_of(kind))});
    }
    std::stable_sort(defects_.begin(), defects_.end(),
                     [](const Defect& a, const Defect& b) { return a.kind < b.kind; });
    return std::move(defects_);
  }

 private:
  static constexpr int most = 10;
  static constexpr std::size_t num_kinds =
      static_cast<std::size_t>(DefectKind::unused_vertices) + 1;
  [[nodiscard]] int count(DefectKind kind) const { return counts_[static_cast<std::size_t>(kind)]; }

  const Mesh& mesh_;
  std::vector<int> counts_ = std::vector<int>(num_kinds, 0);
  std::vector<Defect> defects_;
};

/// "3, 5, 7 and 12 more" for any ids.
template <class IdType>
[[nodiscard]] std::string list_ids(const std::vector<IdType>& ids) {
  constexpr std::size_t most = 8;
  std::vector<std::int32_t> shown;
  for (std::size_t i = 0; i < std::min(most, ids.size()); ++i)
    shown.push_back(ids[i].value);
  const std::string start = fmt::format("{}", fmt::join(shown, ", "));
  return ids.size() > most ? fmt::format("{} and {} more", start, ids.size() - most) : start;
}

/// Adds what has to do with positions: not_finite, coordinates, zero_area, one_point.
void add_geometric_defects(const Mesh& mesh, DefectList& out);

}  // namespace limes
