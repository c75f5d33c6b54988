#include "limes/problem/problem.h"

#include <fmt/format.h>

#include <algorithm>

#include "limes/core/error.h"
#include "limes/core/text.h"
#include "limes/problem/problem_overrides.h"
#include "limes/problem/problem_surfaces.h"
#include "limes/problem/problem_table.h"
#include "limes/problem/toml_document.h"

namespace limes {
namespace {

namespace fs = std::filesystem;
using namespace problem_file;

/// Of the keys' words; none: a list of what is fixed.
SupportKind support_kind(std::string_view name) {
  if (name == "clamped") return SupportKind::clamped;
  if (name == "supported") return SupportKind::supported;
  if (name == "symmetry") return SupportKind::symmetry;
  if (name == "diaphragm") return SupportKind::diaphragm;
  return SupportKind::listed;
}

struct NamedLoad {
  std::string_view name;
  LoadKind kind;
};
constexpr std::array load_kinds{NamedLoad{"force", LoadKind::force},
                                NamedLoad{"force_per_length", LoadKind::force_per_length},
                                NamedLoad{"force_per_area", LoadKind::force_per_area},
                                NamedLoad{"force_per_volume", LoadKind::force_per_volume},
                                NamedLoad{"pressure", LoadKind::pressure},
                                NamedLoad{"moment", LoadKind::moment},
                                NamedLoad{"source", LoadKind::source},
                                NamedLoad{"flux", LoadKind::flux}};

/// The tables of a document, one kind after the other.
class ProblemReader {
 public:
  ProblemReader(const toml::table& document, const fs::path& file)
      : document_(document), file_(file.string()) {
    problem_.file = file;
  }
  Problem read();

 private:
  [[nodiscard]] std::vector<TableReader> tables(std::string_view name) const {
    return tables_of(document_, name, file_);
  }
  void read_top();
  void read_mesh();
  void read_model();
  void read_surfaces();
  void read_materials();
  void read_periodic();
  void read_supports();
  void read_loads();
  void read_probes();
  void read_adapt();
  void check_adapt() const;
  void check_model() const;
  void check_conditions() const;
  void check_plane() const;
  void check_held() const;

  const toml::table& document_;
  std::string file_;
  Problem problem_;
};

void ProblemReader::read_top() {
  const TableReader top(document_, Table{}, file_);
  top.read("title", problem_.title);
  for (const TableReader& table : tables("units")) {
    table.read("length", problem_.units.length);
    table.read("force", problem_.units.force);
  }
}

void ProblemReader::read_mesh() {
  for (const TableReader& table : tables("mesh")) {
    MeshSettings& mesh = problem_.mesh;
    mesh.origin = table.origin();
    std::string file, placement, junctions;
    table.read("file", file);
    mesh.file = file;
    table.read("scheme", mesh.scheme);
    table.read("levels", mesh.levels);
    table.read("placement", placement);
    mesh.exact = placement == "exact";
    if (mesh.exact && !document_.contains("geometry"))
      fail_with(table.place("placement"), "placement 'exact' needs a [geometry]; it is missing");
    table.read("junctions", junctions);
    problem_.junctions = junctions == "tied";
    table.read("smooth_start", mesh.smooth_start);
    table.read("smoothing", mesh.smoothing);
    if (mesh.smooth_start > 0 && !document_.contains("geometry"))
      fail_with(table.place("smooth_start"),
                "[mesh] smooth_start slides vertices on a [geometry]; it is missing");
    if (mesh.smoothing > 0 && !mesh.exact && mesh.scheme != "kobbelt")
      fail_with(
          culprit(table.place("smoothing"), {table.place("placement"), table.place("scheme")}),
          "[mesh] smoothing slides vertices on a [geometry] (placement = \"exact\") or on the "
          "surface of the scheme \"kobbelt\"; here is neither");
  }
}

void ProblemReader::read_surfaces() {
  SurfaceSettings surfaces = surfaces_in(document_, problem_.file);
  surfaces.junctions = problem_.junctions;
  static_cast<SurfaceSettings&>(problem_) = std::move(surfaces);
  if (problem_.mesh.exact || problem_.mesh.smooth_start > 0) return;
  for (const TableReader& table : tables("curve"))
    fail_with(table.place(),
              "a [[curve]] places vertices; it needs [mesh] placement = \"exact\" or smooth_start");
}

void ProblemReader::read_model() {
  for (const TableReader& table : tables("model")) {
    ModelSettings& model = problem_.model;
    model.origin = table.origin();
    std::string kind, boundary, membrane;
    table.read("kind", kind);
    table.read("boundary", boundary);
    model.kind = kind == "mitc4"          ? ModelKind::mitc4
                 : kind == "poisson"      ? ModelKind::poisson
                 : kind == "plane-strain" ? ModelKind::plane_strain
                                          : ModelKind::plane_stress;
    table.read("shear_factor", model.shear_factor);
    table.read("kink_angle", model.kink_angle);
    table.read("membrane", membrane);
    table.read("drilling", model.drilling);
    model.assumed_membrane = membrane == "assumed";
    model.boundary = boundary == "phantom" ? FieldBoundary::phantom : FieldBoundary::free;
    table.read("kinks", model.kinks);
    table.read("quadrature_points", model.quadrature_points);
    table.read("quadrature_depth", model.quadrature_depth);
    if (model.kind == ModelKind::mitc4)
      refuse_keys(table, "model", {"boundary", "kinks", "quadrature_points", "quadrature_depth"},
                  "kind = \"mitc4\"", table.place("kind"));
    else
      refuse_keys(table, "model", {"shear_factor", "kink_angle", "membrane", "drilling"},
                  fmt::format("kind = \"{}\"", kind), table.place("kind"));
    if (model.kind == ModelKind::poisson)
      refuse_keys(table, "model", {"boundary", "kinks", "quadrature_depth"}, "kind = \"poisson\"",
                  table.place("kind"));
  }
}

void ProblemReader::read_materials() {
  const MaterialSettings* rest = nullptr;
  const Place& kind = problem_.model.origin.of("kind");
  const std::vector<TableReader> all = tables("material");
  problem_.materials.reserve(all.size());
  for (const TableReader& table : all) {
    MaterialSettings& material = problem_.materials.emplace_back();
    material.origin = table.origin();
    if (table.has("where")) table.read("where", material.where.emplace());
    table.read("young", material.young);
    table.read("poisson", material.poisson);
    table.read("thickness", material.thickness);
    table.read("conductivity", material.conductivity);
    if (problem_.model.kind == ModelKind::poisson) {
      refuse_keys(table, "material", {"young", "poisson", "thickness"}, "kind = \"poisson\"", kind);
    } else {
      refuse_keys(table, "material", {"conductivity"}, "elasticity", kind);
      for (const char* needed : {"young", "poisson"})
        if (!table.has(needed))
          fail_with(culprit(table.place(), {kind}),
                    fmt::format("{} {} is missing: {}", written(*find_table("material")), needed,
                                find_key("material", needed)->help));
    }
    if (material.where) continue;
    if (rest)
      fail_with(table.place(),
                fmt::format("this [[material]] has no where, like that of {}; one may be "
                            "without",
                            spoken(rest->origin.table)));
    rest = &material;
  }
}

void ProblemReader::read_periodic() {
  for (const TableReader& table : tables("periodic")) {
    PeriodicSettings& periodic = problem_.periodic.emplace();
    periodic.origin = table.origin();
    table.read("gradient", periodic.gradient);
    if (!(periodic.gradient.determinant() > 0))
      fail_with(
          table.place("gradient"),
          fmt::format("[periodic] gradient has the determinant {}; the deformation gradient of a "
                      "body has one > 0, [[1, 0], [0, 1]] is no deformation",
                      periodic.gradient.determinant()));
  }
}

void ProblemReader::read_supports() {
  for (const TableReader& table : tables("support")) {
    SupportSettings& support = problem_.supports.emplace_back();
    support.origin = table.origin();
    table.read("where", support.where);
    std::vector<std::string> fix;
    std::string kind, rotation;
    if (table.chosen_key() == "fix") table.read("fix", fix);
    constexpr std::array<std::string_view, 6> names{"ux", "uy", "uz", "rx", "ry", "rz"};
    for (std::size_t i = 0; i < names.size(); ++i)
      support.fix[i] = std::find(fix.begin(), fix.end(), names[i]) != fix.end();
    if (table.has("kind")) table.read("kind", kind);
    support.kind = table.has("value") ? SupportKind::value : support_kind(kind);
    table.read("value", support.value);
    table.read("rotation", rotation);
    support.hard = rotation == "hard";
    if (!rotation.empty() && support.kind != SupportKind::supported &&
        support.kind != SupportKind::diaphragm)
      fail_with(table.place("rotation"),
                "rotation belongs to kind = \"supported\" or \"diaphragm\"; remove it");
  }
}

void ProblemReader::read_loads() {
  for (const TableReader& table : tables("load")) {
    LoadSettings& load = problem_.loads.emplace_back();
    load.origin = table.origin();
    table.read("where", load.where);
    const std::string_view key = table.chosen_key();
    for (const NamedLoad& named : load_kinds)
      if (named.name == key) load.kind = named.kind;
    if (load.kind == LoadKind::pressure || load.kind == LoadKind::source ||
        load.kind == LoadKind::flux)
      table.read(key, load.value[0]);
    else
      table.read(key, load.value);
  }
}

void ProblemReader::read_probes() {
  for (const TableReader& table : tables("probe")) {
    ProbeSettings probe;
    probe.origin = table.origin();
    table.read("name", probe.name);
    table.read("at", probe.at);
    for (const ProbeSettings& other : problem_.probes)
      if (other.name == probe.name)
        fail_with(table.place("name"),
                  fmt::format("[[probe]] name {} is taken by that of {}", quote(probe.name),
                              spoken(other.origin.of("name"))));
    problem_.probes.push_back(std::move(probe));
  }
}

void ProblemReader::read_adapt() {
  for (const TableReader& table : tables("adapt")) {
    AdaptSettings& adapt = problem_.adapt.emplace();
    adapt.origin = table.origin();
    std::string estimator, mark, closure;
    table.read("estimator", estimator);
    if (estimator == "residual") adapt.estimator = EstimatorKind::residual;
    table.read("closure", closure);
    if (closure == "hanging") adapt.closure = Closure::hanging;
    table.read("mark", mark);
    adapt.mark = mark == "maximum"    ? MarkingKind::maximum
                 : mark == "fraction" ? MarkingKind::fraction
                                      : MarkingKind::doerfler;
    table.read("share", adapt.share);
    table.read("max_dofs", adapt.max_dofs);
    table.read("max_steps", adapt.max_steps);
    if (table.has("target_error")) table.read("target_error", adapt.target_error.emplace());
    if (table.has("max_seconds")) table.read("max_seconds", adapt.max_seconds.emplace());
    if (table.has("reference_energy"))
      table.read("reference_energy", adapt.reference_energy.emplace());
    table.read("reference_levels", adapt.reference_levels);
  }
}

/// That the other tables leave something to refine.
void ProblemReader::check_adapt() const {
  if (!problem_.adapt) return;
  const Origin &own = problem_.adapt->origin, &mesh = problem_.mesh.origin,
               &model = problem_.model.origin;
  const bool shell = problem_.model.kind == ModelKind::mitc4;
  if (problem_.periodic)
    fail_at(own.table, "a periodic cell cannot be refined adaptively yet; remove [adapt]");
  if (shell && problem_.mesh.scheme != "linear" && problem_.mesh.scheme != "kobbelt")
    fail_at(culprit(own.table, {mesh.of("scheme"), model.of("kind")}),
            "[adapt] takes shells whose nodes are vertices; right is [mesh] scheme = \"linear\" or "
            "\"kobbelt\"");
  if (problem_.mesh.smoothing > 0 && !problem_.mesh.exact)
    fail_at(culprit(own.table, {mesh.of("smoothing"), mesh.of("placement")}),
            "[adapt] smooths meshes on exact surfaces only; right is [mesh] smoothing = 0 or "
            "placement = \"exact\"");
  if (!shell && problem_.mesh.scheme != "linear")
    fail_at(culprit(own.table, {mesh.of("scheme"), model.of("kind")}),
            "[adapt] works on bilinear elements; right is [mesh] scheme = \"linear\"");
}

void ProblemReader::check_held() const {
  if (problem_.model.kind == ModelKind::poisson && problem_.supports.empty())
    fail_with({file_},
              "there is no [[support]]: the solution is known but for a constant; give its value "
              "somewhere");
  if (problem_.supports.empty() && !problem_.periodic)
    fail_with(
        {file_},
        "there is no [[support]]: nothing keeps the body in place; a plane body needs at least "
        "three fixed displacements");
}

/// Poisson's equation has supports and loads of its own.
void ProblemReader::check_conditions() const {
  const Place& kind = problem_.model.origin.of("kind");
  const bool poisson = problem_.model.kind == ModelKind::poisson;
  for (const SupportSettings& s : problem_.supports)
    if (poisson != (s.kind == SupportKind::value))
      fail_at(culprit(s.origin.override_or_table(), {kind}), "{}",
              poisson ? "Poisson's equation has no displacements; right is value"
                      : "[[support]] value is for [model] kind = \"poisson\"; use fix");
  for (const LoadSettings& load : problem_.loads)
    if (poisson != (load.kind == LoadKind::source || load.kind == LoadKind::flux))
      fail_at(culprit(load.origin.override_or_table(), {kind}), "{}",
              poisson ? "Poisson's equation has no forces; right is source or flux"
                      : "source and flux are for [model] kind = \"poisson\"; use forces");
}

/// Each model has keys that mean nothing to the other.
void ProblemReader::check_model() const {
  const Place& kind = problem_.model.origin.of("kind");
  const Origin& mesh = problem_.mesh.origin;
  check_conditions();
  if (problem_.model.kind == ModelKind::poisson) {
    if (problem_.mesh.scheme != "linear")
      fail_at(culprit(problem_.model.origin.table, {mesh.of("scheme"), kind}),
              "Poisson's equation is solved with bilinear elements; right is [mesh] scheme = "
              "\"linear\"");
    if (problem_.periodic)
      fail_at(culprit(problem_.periodic->origin.table, {kind}),
              "a periodic cell is one of elasticity; remove it");
  }
  if (problem_.model.kind == ModelKind::mitc4) {
    if (problem_.periodic)
      fail_at(culprit(problem_.periodic->origin.table, {kind}),
              "a periodic cell is plane; a shell has none, remove it");
    return;
  }
  if (problem_.mesh.smoothing > 0)
    fail_at(culprit(mesh.of("smoothing"), {kind}),
            "smoothing is for shells, [model] kind = \"mitc4\"; remove it");
  if (problem_.junctions)
    fail_at(culprit(mesh.of("junctions"), {kind}),
            "junctions are tied in shells, [model] kind = \"mitc4\"; remove the key");
  if (problem_.geometry || !problem_.geometry_of_parts.empty())
    fail_at(culprit((problem_.geometry ? *problem_.geometry : problem_.geometry_of_parts.front())
                        .origin.table,
                    {kind}),
            "[geometry] is for shells, [model] kind = \"mitc4\"; remove it");
  if (!problem_.seams.empty())
    fail_at(culprit(problem_.seams.front().origin.table, {kind}),
            "a [[seam]] is for shells, [model] kind = \"mitc4\"; remove it");
  check_plane();
}

/// That supports and loads are those of a plane body.
void ProblemReader::check_plane() const {
  const Place& kind = problem_.model.origin.of("kind");
  for (const SupportSettings& s : problem_.supports) {
    if (s.kind != SupportKind::listed && s.kind != SupportKind::value)
      fail_at(culprit(s.origin.of("kind"), {kind}),
              "[[support]] kind is for shells, [model] kind = \"mitc4\"; use fix");
    if (s.fix[3] || s.fix[4] || s.fix[5])
      fail_at(culprit(s.origin.of("fix"), {kind}),
              "plane models have no rotations; fix ux, uy or both");
  }
  for (const LoadSettings& load : problem_.loads)
    if (load.kind == LoadKind::moment)
      fail_at(culprit(load.origin.of("moment"), {kind}),
              "a moment is for shells, [model] kind = \"mitc4\"; use forces");
}

Problem ProblemReader::read() {
  read_top();
  read_mesh();
  read_model();
  read_surfaces();
  read_materials();
  read_periodic();
  read_supports();
  read_loads();
  read_probes();
  read_adapt();
  check_adapt();
  check_model();
  check_held();
  return std::move(problem_);
}

}  // namespace

const Place& place_of_value(const LoadSettings& load) {
  const auto named = std::find_if(load_kinds.begin(), load_kinds.end(),
                                  [&](const NamedLoad& n) { return n.kind == load.kind; });
  return load.origin.of(named->name);
}

Place place_of_supports(const Problem& problem) {
  Place place{problem.file.string(), false, 0};
  for (const SupportSettings& s : problem.supports)
    place = culprit(place, {s.origin.override_or_table()});
  return place;
}

Problem parse_problem(std::string_view text, const fs::path& file,
                      std::span<const std::string> overrides) {
  toml::table document = parse_toml(text, file);
  apply_overrides(document, overrides);
  Problem problem = ProblemReader(document, file).read();
  problem.values = listed_values(document);
  return problem;
}

Problem read_problem(const fs::path& file, std::span<const std::string> overrides) {
  return parse_problem(read_toml_text(file), file, overrides);
}

}  // namespace limes
