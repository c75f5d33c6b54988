#include "sample_points.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "limes/io/lines.h"
#include "number_table.h"

namespace limes::app {
namespace {

constexpr std::array<std::string_view, 4> column_names{"face", "corner", "u", "v"};

/// Turns rows of numbers into points of a mesh's faces.
class PointChecker {
 public:
  PointChecker(std::string file, const Topology& topology, const Scheme& scheme)
      : file_(std::move(file)), topology_(topology), scheme_(scheme) {}

  [[nodiscard]] SamplePoint point(std::int64_t line, std::span<const double> row) const {
    SamplePoint point{
        FaceId(whole(line, row, 0, topology_.num_faces())), 0, {row[2], row[3]}, line};
    const int n = topology_.face_size(point.face);
    point.corner = whole(line, row, 1, n == regular_face_size(scheme_) ? 1 : n);
    if (!is_inside(point.uv))
      throw error_at(file_, line, "(u, v) = ({}, {}) lies outside face {}; {} is inside",
                     point.uv[0], point.uv[1], point.face.value,
                     on_triangles() ? "u, v >= 0, u + v <= 1" : "0 to 1");
    return point;
  }

 private:
  [[nodiscard]] bool on_triangles() const { return scheme_.split == Split::triangles; }
  [[nodiscard]] bool is_inside(const Vec2& uv) const {
    if (uv.minCoeff() < 0 || uv.maxCoeff() > 1) return false;
    // What rounding leaves of points on the third side is inside.
    return !on_triangles() || uv.sum() <= 1 + 4 * std::numeric_limits<double>::epsilon();
  }

  /// The value of a column, which must be a whole number in [0, end).
  [[nodiscard]] int whole(std::int64_t line, std::span<const double> row, std::size_t column,
                          int end) const {
    const double value = row[column];
    if (value != std::floor(value))
      throw error_at(file_, line, "{} is {}; a whole number is right", column_names[column], value);
    if (value < 0 || value >= end)
      throw error_at(file_, line, "{} {} does not exist; {} is right", column_names[column], value,
                     end == 1 ? "0" : fmt::format("0 to {}", end - 1));
    return static_cast<int>(value);
  }

  std::string file_;
  const Topology& topology_;
  const Scheme& scheme_;
};

}  // namespace

std::vector<SamplePoint> read_sample_points(const std::filesystem::path& file,
                                            const Topology& topology, const Scheme& scheme) {
  const NumberTable table = read_number_table(file, column_names);
  const PointChecker checker(file.string(), topology, scheme);
  std::vector<SamplePoint> points;
  points.reserve(table.num_rows());
  for (std::size_t i = 0; i < table.num_rows(); ++i)
    points.push_back(checker.point(table.lines[i], table.row(i)));
  return points;
}

}  // namespace limes::app
