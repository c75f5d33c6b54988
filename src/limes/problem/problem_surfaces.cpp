#include "limes/problem/problem_surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

#include "limes/core/error.h"
#include "limes/problem/problem_table.h"
#include "limes/problem/toml_document.h"

namespace limes::problem_file {
namespace {

using Kind = GeometrySettings::Kind;

/// A kind of surface, and which keys it has besides kind and part.
struct KindRow {
  std::string_view name;
  Kind kind;
  std::array<std::string_view, 4> needed, optional;  // filled from the front
};
constexpr std::array kinds{
    KindRow{"cylinder", Kind::cylinder, {"radius"}, {"point", "axis"}},
    KindRow{"sphere", Kind::sphere, {"radius"}, {"point"}},
    KindRow{"plane", Kind::plane, {"axis"}, {"point"}},
    KindRow{"cone", Kind::cone, {"angle"}, {"point", "axis"}},
    KindRow{"torus", Kind::torus, {"radius", "tube_radius"}, {"point", "axis"}},
    KindRow{"graph", Kind::graph, {"height"}, {}},
    KindRow{"formula", Kind::formula, {"zero"}, {}}};

bool contains(const std::array<std::string_view, 4>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Checks that a table has the keys that its kind needs, and none of other kinds.
const KindRow& kind_of(const TableReader& table) {
  std::string name;
  table.read("kind", name);
  const KindRow& row =
      *std::find_if(kinds.begin(), kinds.end(), [&](const KindRow& r) { return r.name == name; });
  for (const std::string_view needed : row.needed)
    if (!needed.empty() && !table.has(needed))
      fail_with(culprit(table.place(), {table.place("kind")}),
                fmt::format("[geometry] {} is missing; a {} needs it", needed, name));
  for (const Key& key : problem_keys())
    if (key.table == "geometry" && key.name != "kind" && key.name != "part" &&
        !contains(row.needed, key.name) && !contains(row.optional, key.name))
      refuse_keys(table, "geometry", {key.name}, fmt::format("a {}", name), table.place("kind"));
  return row;
}

GeometrySettings geometry_of(const TableReader& table) {
  GeometrySettings geometry;
  geometry.origin = table.origin();
  geometry.kind = kind_of(table).kind;
  if (table.has("part")) table.read("part", geometry.part.emplace());
  table.read("point", geometry.point);
  table.read("axis", geometry.axis);
  table.read("radius", geometry.radius);
  table.read("tube_radius", geometry.tube_radius);
  table.read("angle", geometry.angle);
  table.read("height", geometry.height);
  table.read("zero", geometry.zero);
  if (!(geometry.axis.norm() > 0))
    fail_with(table.place("axis"), "[geometry] axis has no direction; it must not be 0");
  if (geometry.kind == Kind::torus && !(geometry.tube_radius < geometry.radius))
    fail_with(
        culprit(table.place("tube_radius"), {table.place("radius")}),
        fmt::format("[geometry] tube_radius is {}; that of a torus without self-intersections is "
                    "less than its radius, {}",
                    geometry.tube_radius, geometry.radius));
  return geometry;
}

void add_geometry(const TableReader& table, SurfaceSettings& surfaces) {
  GeometrySettings geometry = geometry_of(table);
  const GeometrySettings* other = nullptr;
  if (!geometry.part && surfaces.geometry) other = &*surfaces.geometry;
  for (const GeometrySettings& g : surfaces.geometry_of_parts)
    if (g.part == geometry.part) other = &g;
  if (other)
    fail_with(table.place("part"),
              fmt::format("this [[geometry]] is for the same part as that of {}; a part has one",
                          spoken(other->origin.of("part"))));
  if (geometry.part)
    surfaces.geometry_of_parts.push_back(std::move(geometry));
  else
    surfaces.geometry = std::move(geometry);
}

CurveSettings curve_of(const TableReader& table) {
  CurveSettings curve;
  curve.origin = curve.surface.origin = table.origin();
  curve.surface.kind = Kind::formula;
  table.read("where", curve.where);
  table.read("zero", curve.surface.zero);
  return curve;
}

SeamSettings seam_of(const TableReader& table) {
  SeamSettings seam;
  seam.origin = table.origin();
  table.read("parts", seam.parts);
  if (seam.parts.size() < 2)
    fail_with(table.place("parts"), "[[seam]] parts has one part; a seam ties two or more");
  return seam;
}

}  // namespace

SurfaceSettings surfaces_in(const toml::table& document, const std::filesystem::path& file) {
  const std::string name = file.string();
  SurfaceSettings surfaces;
  surfaces.file = file;
  for (const TableReader& table : tables_of(document, "geometry", name))
    add_geometry(table, surfaces);
  for (const TableReader& table : tables_of(document, "curve", name))
    surfaces.curves.push_back(curve_of(table));
  for (const TableReader& table : tables_of(document, "seam", name))
    surfaces.seams.push_back(seam_of(table));
  return surfaces;
}

}  // namespace limes::problem_file

namespace limes {

SurfaceSettings parse_surfaces(std::string_view text, const std::filesystem::path& file) {
  using namespace problem_file;
  const toml::table document = parse_toml(text, file);
  const std::string name = file.string();
  (void)TableReader(document, Table{}, name);  // every table is known
  SurfaceSettings surfaces = surfaces_in(document, file);
  if (!surfaces.geometry && surfaces.geometry_of_parts.empty())
    fail_with({name}, "[geometry] is missing: an exact surface to place vertices on");
  return surfaces;
}

SurfaceSettings read_surfaces(const std::filesystem::path& file) {
  return parse_surfaces(read_toml_text(file), file);
}

}  // namespace limes
