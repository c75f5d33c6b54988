#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "files.h"
#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/subdiv/coarsen.h"
#include "memory.h"
#include "run.h"
#include "terminal.h"

namespace limes::app {
namespace {

struct CoarsenCommand {
  MeshOptions mesh;
  std::filesystem::path output;
  RunOptions run;
  std::string tolerance = "1e-6";
  SchemeOptions scheme;

  void operator()() const;
};

CoarsenResult coarsened(const Mesh& mesh, const CoarsenOptions& options, const std::string& file) {
  const Progress progress(fmt::format("coarsening {}", file));
  return naming_file(file, mesh, [&] { return coarsen(mesh, options); });
}

void CoarsenCommand::operator()() const {
  const Run current(run);
  const double relative = parse_positive("--tolerance", tolerance);
  const SchemeChoice choice = choose_scheme(scheme);
  check_mesh_output(output, run);
  const std::string file = mesh.file.string();
  const Mesh fine = load_refinable_mesh(mesh);
  const CoarsenOptions options{
      .scheme = choice.scheme->name, .refine = choice.options_for(fine, 1), .tolerance = relative};
  const CoarsenResult result = coarsened(fine, options, file);
  for (const std::string& sentence : result.remarks)
    remark(fmt::format("{}: {}", file, sentence));
  check_interrupt();
  save_mesh(output, result.mesh);

  const int vertices = result.mesh.topology.num_vertices();
  const int faces = result.mesh.topology.num_faces();
  if (run.json)
    print_object({{"vertices", vertices},
                  {"faces", faces},
                  {"residual", result.residual},
                  {"seconds", current.seconds()},
                  {"peak_memory", peak_memory()}});
  else if (!is_standard_output(output))
    print(fmt::format("{}: {} vertices, {} faces; refined again it is {:.2g} away\n",
                      output.string(), vertices, faces, result.residual));
}

}  // namespace

void add_coarsen(CLI::App& program) {
  const auto command = std::make_shared<CoarsenCommand>();
  command->scheme.scheme = "catmull-clark";
  CLI::App& app =
      *program.add_subcommand("coarsen", "Undo one step of Catmull-Clark, Loop or kobbelt");
  add_output_option(app, command->output, "Mesh to write: .obj, .off, .ply, .stl or .vtu");
  add_mesh_options(app, command->mesh);
  app.add_option("--scheme", command->scheme.scheme, "Scheme of the step [catmull-clark]")
      ->option_text("NAME")
      ->group(scheme_group);
  add_tension_options(app, command->scheme);
  app.add_option("--tolerance", command->tolerance,
                 "Largest distance from a refined mesh, as part of the\ndiagonal [1e-6]")
      ->option_text("T")
      ->group(work_group);
  add_run_options(app, command->run);
  app.footer(
      "Vertices and faces may be numbered in any way. A mesh that no step of Catmull-Clark makes "
      "is\n"
      "refused, and so is one whose coarse mesh is not unique, as a refined cube.\n\n"
      "  limes coarsen fine.obj -o coarse.obj");
  app.final_callback([command] { (*command)(); });
}

}  // namespace limes::app
