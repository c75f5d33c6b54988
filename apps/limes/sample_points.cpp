#include "sample_points.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "files.h"
#include "limes/core/text.h"
#include "limes/io/lines.h"

namespace limes::app {
namespace {

constexpr std::array<std::string_view, 4> column_names{"face", "corner", "u", "v"};

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.push_back(trim(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

class PointTable {
 public:
  PointTable(std::string file, const Topology& topology)
      : file_(std::move(file)), topology_(topology) {}

  void read_head(std::int64_t line, std::string_view text) {
    const auto names = split(text);
    num_columns_ = names.size();
    for (std::size_t c = 0; c < column_names.size(); ++c) {
      std::optional<std::size_t> found;
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] != column_names[c]) continue;
        if (found) throw error_at(file_, line, "column {} appears twice", column_names[c]);
        found = i;
      }
      if (!found)
        throw error_at(file_, line, "there is no column {}; the head must name face,corner,u,v",
                       column_names[c]);
      column_[c] = *found;
    }
  }

  [[nodiscard]] SamplePoint read_row(std::int64_t line, std::string_view text) const {
    const auto fields = split(text);
    if (fields.size() != num_columns_)
      throw error_at(file_, line, "{} fields; the head has {} columns", fields.size(),
                     num_columns_);
    std::array<double, 4> values{};
    for (std::size_t c = 0; c < values.size(); ++c) {
      const auto value = parse_real(fields[column_[c]]);
      if (!value)
        throw error_at(file_, line, "{} is {}; a number is right", column_names[c],
                       quote(fields[column_[c]]));
      values[c] = *value;
    }
    const SamplePoint point{
        FaceId(whole(line, values[0], 0, topology_.num_faces())), 0, {values[2], values[3]}, line};
    return checked(line, point, values[1]);
  }

 private:
  /// values must be a whole number in [0, end).
  [[nodiscard]] int whole(std::int64_t line, double value, std::size_t column, int end) const {
    if (value != std::floor(value))
      throw error_at(file_, line, "{} is {}; a whole number is right", column_names[column], value);
    if (value < 0 || value >= end)
      throw error_at(file_, line, "{} {} does not exist; {} is right", column_names[column], value,
                     end == 1 ? "0" : fmt::format("0 to {}", end - 1));
    return static_cast<int>(value);
  }

  [[nodiscard]] SamplePoint checked(std::int64_t line, SamplePoint point, double corner) const {
    const int face_size = topology_.face_size(point.face);
    point.corner = whole(line, corner, 1, face_size == 4 ? 1 : face_size);
    if (point.uv.minCoeff() < 0 || point.uv.maxCoeff() > 1)
      throw error_at(file_, line, "(u, v) = ({}, {}) lies outside face {}; 0 to 1 is inside",
                     point.uv[0], point.uv[1], point.face.value);
    return point;
  }

  std::string file_;
  const Topology& topology_;
  std::array<std::size_t, 4> column_{};
  std::size_t num_columns_ = 0;
};

}  // namespace

std::vector<SamplePoint> read_sample_points(const std::filesystem::path& file,
                                            const Topology& topology) {
  const std::string name = file.string();
  const std::string bytes = read_text_file(file);
  LineReader lines(checked_text(bytes, name));
  PointTable table(name, topology);
  std::vector<SamplePoint> points;
  bool head = true;
  while (lines.next()) {
    if (trim(lines.line()).empty()) continue;
    if (head)
      table.read_head(lines.number(), lines.line());
    else
      points.push_back(table.read_row(lines.number(), lines.line()));
    head = false;
  }
  if (head) throw InputError("{}: empty; the first line must name face,corner,u,v", name);
  return points;
}

}  // namespace limes::app
