#include <fmt/format.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "commands.h"
#include "files.h"
#include "limes/core/interrupt.h"
#include "limes/core/text.h"
#include "limes/mesh/defects.h"
#include "limes/mesh/measure.h"
#include "terminal.h"

namespace limes::app {
namespace {

using Json = nlohmann::ordered_json;

struct InfoCommand {
  MeshOptions mesh;
  bool json = false;

  void operator()() const;
};

std::string name_of(BoundaryRule rule) {
  switch (rule) {
    case BoundaryRule::none:
      return "none";
    case BoundaryRule::edges:
      return "edges";
    case BoundaryRule::edges_and_corners:
      return "edges-and-corners";
  }
  return {};
}

std::string name_of(CreaseMethod method) {
  return method == CreaseMethod::chaikin ? "chaikin" : "uniform";
}

Json counts_json(const std::map<int, int>& counts) {
  Json object = Json::object();
  for (const auto& [valence, count] : counts)
    object[std::to_string(valence)] = count;
  return object;
}

Json tags_json(const Tags& tags) {
  return {{"creases", tags.creases.size()},
          {"corners", tags.corners.size()},
          {"holes", tags.holes.size()},
          {"boundary", tags.boundary ? Json(name_of(*tags.boundary)) : Json()},
          {"crease_method", name_of(tags.crease_method)},
          {"smooth_triangles", tags.smooth_triangles}};
}

Json names_json(const std::vector<FaceGroup>& groups) {
  Json object = Json::object();
  for (const FaceGroup& g : groups)
    object[g.name] = g.faces.size();
  return object;
}

Json defect_json(const Defect& defect) {
  Json faces = Json::array();
  Json vertices = Json::array();
  for (const FaceId f : defect.faces)
    faces.push_back(f.value);
  for (const VertexId v : defect.vertices)
    vertices.push_back(v.value);
  return {{"kind", limes::name_of(defect.kind)},
          {"faces", std::move(faces)},
          {"vertices", std::move(vertices)},
          {"line", defect.line},
          {"message", defect.message}};
}

void print_json(const Mesh& mesh, const MeshMeasure& m, const std::vector<Defect>& defects) {
  Json list = Json::array();
  for (const Defect& d : defects)
    list.push_back(defect_json(d));
  print_object({{"vertices", m.vertices},
                {"edges", m.edges},
                {"faces", m.faces},
                {"components", m.components},
                {"boundary_loops", m.boundary_loops},
                {"euler", m.euler},
                {"valence_interior", counts_json(m.valence_interior)},
                {"valence_boundary", counts_json(m.valence_boundary)},
                {"tags", tags_json(mesh.tags)},
                {"groups", names_json(mesh.groups)},
                {"parts", names_json(mesh.parts)},
                {"defects", std::move(list)}});
}

/// "3 x 12, 4 x 6": valence and number of vertices
std::string counts_text(const std::map<int, int>& counts) {
  std::string text;
  for (const auto& [valence, count] : counts)
    text += fmt::format("{}{} x {}", text.empty() ? "" : ", ", valence, count);
  return text.empty() ? "-" : text;
}

std::string tags_text(const Tags& tags) {
  std::string text = fmt::format("{} creases, {} corners, {} holes", tags.creases.size(),
                                 tags.corners.size(), tags.holes.size());
  if (tags.boundary) text += ", boundary " + name_of(*tags.boundary);
  if (tags.crease_method == CreaseMethod::chaikin) text += ", chaikin creases";
  if (tags.smooth_triangles) text += ", smooth triangles";
  return text;
}

std::string names_text(const char* label, const std::vector<FaceGroup>& groups) {
  std::string text;
  for (const FaceGroup& g : groups)
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", g.name,
                        counted(g.faces.size(), "face", "faces"));
  return text.empty() ? "" : fmt::format("{:<18}{}\n", label, text);
}

void print_text(const Mesh& mesh, const MeshMeasure& m, const std::vector<Defect>& defects) {
  std::string text = fmt::format(
      "vertices          {}\nedges             {}\nfaces             {}\ncomponents        {}\n"
      "boundary loops    {}\nEuler number      {}\ninterior valence  {}\nboundary valence  {}\n"
      "tags              {}\n",
      m.vertices, m.edges, m.faces, m.components, m.boundary_loops, m.euler,
      counts_text(m.valence_interior), counts_text(m.valence_boundary), tags_text(mesh.tags));
  text += names_text("groups", mesh.groups) + names_text("parts", mesh.parts);
  text += defects.empty() ? "defects           none\n" : "defects\n";
  for (const Defect& d : defects)
    text += fmt::format("  {}: {}{}\n", limes::name_of(d.kind), d.message,
                        d.line > 0 ? fmt::format(" (line {})", d.line) : "");
  print(text);
}

void InfoCommand::operator()() const {
  const Mesh loaded = load_mesh(mesh);
  const MeshMeasure measured = measure(loaded);
  check_interrupt();
  const std::vector<Defect> defects = find_defects(loaded);
  check_interrupt();
  json ? print_json(loaded, measured, defects) : print_text(loaded, measured, defects);
}

}  // namespace

void add_info(CLI::App& program) {
  const auto command = std::make_shared<InfoCommand>();
  CLI::App& app = *program.add_subcommand("info", "Describe a mesh and its defects");
  add_mesh_options(app, command->mesh);
  app.add_flag("--json", command->json, "Print one JSON object on standard output, nothing else")
      ->group(run_group);
  app.footer(
      "Valence is the number of edges at a vertex, '4 x 17' means 17 vertices of valence 4.\n"
      "Defects are no error here: the exit code is 0 for every mesh that can be read.\n\n"
      "  limes info rook.obj\n"
      "  limes info rook.obj --json");
  app.final_callback([command] { (*command)(); });
}

}  // namespace limes::app
