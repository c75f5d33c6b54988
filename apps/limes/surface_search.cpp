#include "surface_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>

#include "limes/core/atomic_file.h"
#include "limes/core/interrupt.h"
#include "limes/io/lines.h"
#include "limes/limit/closest_point.h"
#include "limes/limit/surface_ray.h"
#include "number_table.h"
#include "terminal.h"

namespace limes::app {
namespace {

constexpr std::array<std::string_view, 6> ray_columns{"x", "y", "z", "dx", "dy", "dz"};
const std::span<const std::string_view> point_columns = std::span(ray_columns).first(3);

Vec3 vector_at(std::span<const double> row, std::size_t first) {
  return {row[first], row[first + 1], row[first + 2]};
}

SurfaceTree tree_of(const MeshSurface& surface) {
  return {surface.surface().basis(), surface.mesh().points.span(), surface.visible_faces()};
}

/// Searches and writes piece by piece: search_rows(begin, end, text) appends the lines of rows.
template <class SearchRows>
void write_rows(const std::filesystem::path& output, std::string_view head, std::size_t num_rows,
                const SearchRows& search_rows) {
  constexpr std::size_t piece = 1 << 14;
  AtomicFile file(output);
  file.write(head);
  Progress progress("searching", static_cast<std::int64_t>(num_rows));
  for (std::size_t begin = 0; begin < num_rows; begin += piece) {
    check_interrupt();
    const std::size_t end = std::min(begin + piece, num_rows);
    fmt::memory_buffer text;
    search_rows(begin, end, text);
    file.write({text.data(), text.size()});
    progress.advance(static_cast<std::int64_t>(end - begin));
  }
  check_interrupt();
  file.commit();
}

/// face,corner,u,v,x,y,z and a comma
template <class Hit>
void append_place(const Hit& hit, fmt::memory_buffer& text) {
  fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},", hit.face.value, hit.corner,
                 hit.uv[0], hit.uv[1], hit.point[0], hit.point[1], hit.point[2]);
}

std::string_view side_name(RayHit::Side side) {
  switch (side) {
    case RayHit::Side::front:
      return "front";
    case RayHit::Side::back:
      return "back";
    case RayHit::Side::edge_on:
      break;
  }
  return "edge-on";
}

}  // namespace

std::size_t write_closest_points(const MeshSurface& surface, const std::filesystem::path& points,
                                 const std::filesystem::path& output) {
  const NumberTable table = read_number_table(points, point_columns);
  const SurfaceTree tree = tree_of(surface);
  const auto search_rows = [&](std::size_t begin, std::size_t end, fmt::memory_buffer& text) {
    std::vector<Vec3> queries;
    for (std::size_t i = begin; i < end; ++i)
      queries.push_back(vector_at(table.row(i), 0));
    for (const ClosestHit& hit : closest_points(tree, queries)) {
      append_place(hit, text);
      fmt::format_to(std::back_inserter(text), "{}\n", hit.distance);
    }
  };
  write_rows(output, "face,corner,u,v,x,y,z,distance\n", table.num_rows(), search_rows);
  return table.num_rows();
}

RayCount write_ray_hits(const MeshSurface& surface, const std::filesystem::path& rays,
                        const std::filesystem::path& output) {
  const NumberTable table = read_number_table(rays, ray_columns);
  for (std::size_t i = 0; i < table.num_rows(); ++i)
    if (vector_at(table.row(i), 3).isZero(0.0))
      throw error_at(rays.string(), table.lines[i], "(dx, dy, dz) is 0; a direction is right");
  const SurfaceTree tree = tree_of(surface);
  RayCount count{table.num_rows(), 0};
  const auto search_rows = [&](std::size_t begin, std::size_t end, fmt::memory_buffer& text) {
    std::vector<Ray> part(end - begin);
    for (std::size_t i = begin; i < end; ++i) {
      part[i - begin].origin = vector_at(table.row(i), 0);
      part[i - begin].direction = vector_at(table.row(i), 3);
    }
    for (const std::optional<RayHit>& hit : first_hits(tree, part)) {
      if (hit) {
        ++count.hits;
        append_place(*hit, text);
        fmt::format_to(std::back_inserter(text), "{},{}\n", hit->t, side_name(hit->side));
      } else {
        fmt::format_to(std::back_inserter(text), ",,,,,,,,\n");
      }
    }
  };
  write_rows(output, "face,corner,u,v,x,y,z,t,side\n", table.num_rows(), search_rows);
  return count;
}

}  // namespace limes::app
