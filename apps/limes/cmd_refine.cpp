#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "curve_refinement.h"
#include "files.h"
#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/text.h"
#include "limes/curve/curve_scheme.h"
#include "limes/limit/star_masks.h"
#include "limes/subdiv/refine.h"
#include "limit_mesh.h"
#include "memory.h"
#include "run.h"
#include "size_plan.h"
#include "terminal.h"

namespace limes::app {
namespace {

struct RefineCommand {
  MeshOptions mesh;
  std::filesystem::path output;
  SchemeOptions scheme;
  RunOptions run;
  std::string levels;
  bool limit = false;

  void operator()() const;
};

/// What quasi-four-eight did that its mesh does not show, one line each.
std::vector<std::string> remarks_on(const QuasiRefinement& made) {
  std::vector<std::string> remarks;
  if (made.num_cut_faces > 0)
    remarks.push_back(fmt::format("faces that are no triangles, cut along short diagonals: {}",
                                  made.num_cut_faces));
  const std::vector<int>& unsplit = made.num_unsplit_faces;
  if (std::any_of(unsplit.begin(), unsplit.end(), [](int n) { return n > 0; }))
    remarks.push_back(
        fmt::format("faces left whole in steps 1 to {}, because all their edges were taken: {}",
                    unsplit.size(), fmt::join(unsplit, " ")));
  if (made.collapsed) remarks.emplace_back("the refined surface encloses no volume");
  return remarks;
}

Mesh refine_by_scheme(const Mesh& coarse, const SchemeChoice& choice, const RefineOptions& options,
                      std::vector<std::string>& remarks) {
  if (!choice.scheme->needs_positions) return refine(coarse, *choice.scheme, options);
  QuasiOptions quasi = choice.quasi;
  quasi.levels = options.levels;
  QuasiRefinement made = refine_quasi_four_eight(coarse, quasi);
  remarks = remarks_on(made);
  return std::move(made.mesh);
}

/// Says where the surface has no tangent plane with this tension.
void remark_on_surface(const Mesh& mesh, const SchemeChoice& choice, const std::string& file) {
  if (!has_tension(*choice.scheme)) return;
  const Adjacency adjacency(mesh.topology);
  const Features features =
      control_features(adjacency, mesh, *choice.scheme, choice.options_for(mesh, 0));
  IdArray<VertexId, char> on_crease(static_cast<std::size_t>(mesh.topology.num_vertices()), 0);
  for (const SharpEdge& e : features.edges)
    on_crease[adjacency.from(e.halfedge)] = on_crease[adjacency.to(e.halfedge)] = 1;
  std::map<int, std::size_t> count;  // of smooth inner vertices by valence
  for (int i = 0; i < mesh.topology.num_vertices(); ++i)
    if (const VertexId v(i);
        adjacency.ring_start(v).valid() && !adjacency.is_boundary(v) && on_crease[v] == 0)
      ++count[adjacency.valence(v)];
  for (const auto& [valence, vertices] : count)
    if (!star_tangents(*choice.scheme, features, valence))
      remark(fmt::format(
          "{}: with tension {} the surface is not smooth (C1) at the {} with {} edges", file,
          choice.tension, counted(vertices, "inner vertex", "inner vertices"), valence));
}

void RefineCommand::operator()() const {
  const Run current(run);
  const int num_levels = parse_whole_number("--levels", levels, 0);
  if (is_curve_scheme(scheme.scheme)) {
    if (limit) throw UsageError("--limit: {} has no such option", scheme.scheme);
    if (mesh.repair) throw UsageError("--repair: curves have nothing to repair");
    return refine_curves({mesh.file, output, scheme, num_levels}, run, current);
  }
  const SchemeChoice choice = choose_scheme(scheme);
  if (limit) require_limit(choice);
  check_mesh_output(output, run);
  Mesh coarse = num_levels > 0 || limit ? load_refinable_mesh(mesh) : load_mesh(mesh);
  if (choice.boundary) coarse.tags.boundary = choice.boundary;
  require_feasible(coarse.topology, *choice.scheme, num_levels,
                   {.limit_points = limit,
                    .vtu = to_lower(output.extension().string()) == ".vtu",
                    .steps_per_level = choice.quasi.split == QuasiSplit::normal ? 2 : 1},
                   current.memory_limit(), mesh.file.string());
  naming_file(mesh.file, coarse, [&] { remark_on_surface(coarse, choice, mesh.file.string()); });
  Mesh fine;
  std::vector<std::string> remarks;
  {
    const Progress progress(fmt::format("refining {}", mesh.file.string()));
    const RefineOptions options = choice.options_for(coarse, num_levels);
    if (limit)
      fine = naming_file(mesh.file, coarse,
                         [&] { return limit_mesh(coarse, *choice.scheme, options); });
    else if (num_levels > 0)
      fine = naming_file(mesh.file, coarse,
                         [&] { return refine_by_scheme(coarse, choice, options, remarks); });
    else
      fine = std::move(coarse);
  }
  for (const std::string& text : remarks)
    remark(fmt::format("{}: {}", mesh.file.string(), text));
  if (fine.topology.num_faces() == 0)
    throw InputError("{}: every face touches the boundary, no face is left", mesh.file.string());
  check_interrupt();
  save_mesh(output, fine);

  const int vertices = fine.topology.num_vertices();
  const int faces = fine.topology.num_faces();
  if (run.json)
    print_object({{"vertices", vertices},
                  {"faces", faces},
                  {"levels", num_levels},
                  {"seconds", current.seconds()},
                  {"peak_memory", peak_memory()}});
  else if (!is_standard_output(output))
    print(fmt::format("{}: {} vertices, {} faces\n", output.string(), vertices, faces));
}

}  // namespace

void add_refine(CLI::App& program) {
  const auto command = std::make_shared<RefineCommand>();
  CLI::App& app = *program.add_subcommand("refine", "Refine a mesh, or convert it");
  add_output_option(app, command->output, "Mesh to write: .obj, .off, .ply, .stl or .vtu");
  add_mesh_options(app, command->mesh);
  add_scheme_options(app, command->scheme);
  app.add_option("--levels", command->levels, "How many times; 0 only converts")
      ->required()
      ->option_text("N (required)")
      ->group(work_group);
  app.add_flag("--limit", command->limit, "Move the vertices to their places on the limit surface")
      ->group(work_group);
  add_run_options(app, command->run);
  app.footer(
      "Creases, corners, holes, groups and parts are carried to the finer mesh; .obj keeps "
      "them.\n\n"
      "  limes refine cube.obj -o fine.obj --scheme catmull-clark --levels 3\n"
      "  limes refine rook.obj -o rook.vtu --scheme catmull-clark --levels 2 --limit\n"
      "  limes refine polygon.obj -o curve.obj --scheme lane-riesenfeld:3 --levels 4");
  app.final_callback([command] { (*command)(); });
}

}  // namespace limes::app
