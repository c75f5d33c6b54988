#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "files.h"
#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/text.h"
#include "limes/limit/forest_limits.h"
#include "limes/study/leaf_selection.h"
#include "limes/study/surface_placement.h"
#include "limes/subdiv/forest_mesh.h"
#include "limes/subdiv/forest_seams.h"
#include "memory.h"
#include "run.h"
#include "terminal.h"

namespace limes::app {
namespace {

/// A forest and in how many rounds it grew.
struct Grown {
  Forest forest;
  int rounds = 0;
};

/// What --surfaces says about a mesh.
struct ExactSurfaces {
  SurfaceSettings settings;
  std::vector<TiedEdge> seams;  ///< edges of the control mesh
  Placement placement;          ///< refers to the settings
};

struct AdaptCommand {
  MeshOptions mesh;
  std::filesystem::path output, constraints, surfaces;
  SchemeOptions scheme;
  RunOptions run;
  std::string where, levels;
  std::string closure = "conforming";

  void operator()() const;

 private:
  [[nodiscard]] Closure parse_closure() const;
  [[nodiscard]] Grown grow(const Mesh& control, const SchemeChoice& choice, SplitUnit unit,
                           const ExactSurfaces* exact, int rounds) const;
};

Closure AdaptCommand::parse_closure() const {
  if (closure == "conforming") return Closure::conforming;
  if (closure == "triangles") return Closure::triangles;
  if (closure == "hanging") return Closure::hanging;
  throw UsageError("--closure: there is no closure {}; known are conforming, triangles, hanging",
                   quote(closure));
}

int parse_levels(const std::string& levels) {
  const int rounds = parse_whole_number("--levels", levels, 0);
  if (rounds > Forest::max_level)
    throw UsageError("--levels: {} is more than {}, the most levels that a face can have", rounds,
                     Forest::max_level);
  return rounds;
}

SchemeChoice choose_adaptive_scheme(const SchemeOptions& options) {
  SchemeChoice choice = choose_scheme(options);
  require_limit(choice);
  if (choice.boundary == BoundaryRule::none)
    throw UsageError(
        "--boundary: rule none drops faces, which adapt does not; take edges or "
        "edges-and-corners");
  return choice;
}

void require_where(const std::string& where) {
  try {
    (void)parse_face_where(where);
  } catch (const InputError& error) {
    throw UsageError("--where: {}", error.what());
  }
}

/// Puts the vertices of the control mesh on their surfaces, and says how those of the forest get there.
std::unique_ptr<const ExactSurfaces> place_on_surfaces(const std::filesystem::path& file,
                                                       Mesh& control) {
  auto exact = std::make_unique<ExactSurfaces>();
  exact->settings = read_surfaces(file);
  exact->seams = seams_of(exact->settings, control);
  exact->placement = exact_placement(exact->settings, control);
  place_control(exact->settings, control);
  return exact;
}

Grown AdaptCommand::grow(const Mesh& control, const SchemeChoice& choice, SplitUnit unit,
                         const ExactSurfaces* exact, int rounds) const {
  Progress progress(fmt::format("refining {}", mesh.file.string()), rounds);
  const Scheme& used = *choice.scheme;
  Grown grown{Forest(control, used, choice.options_for(control, 0), unit,
                     has_exact_limit(used) && !exact ? forest_limits(used) : LimitsOf(),
                     exact ? exact->placement : Placement())};
  // Paths that join control faces with an odd number of split sides must not end at a seam.
  const bool all_at_first = exact && !exact->seams.empty() && unit == SplitUnit::families;
  LeafSelection selection(grown.forest, where);
  for (; grown.rounds < rounds; ++grown.rounds) {
    check_interrupt();
    const std::vector<FaceId> marked = selection.leaves(grown.forest);
    if (marked.empty()) break;
    grown.forest.refine(all_at_first && grown.rounds == 0 ? grown.forest.leaves() : marked);
    if (exact) match_seams(grown.forest, exact->seams);
    progress.advance();
  }
  return grown;
}

/// Leaves of a forest on each level.
std::vector<int> leaves_by_level(const Forest& forest) {
  std::vector<int> count;
  for (const FaceId f : forest.leaves()) {
    const auto level = static_cast<std::size_t>(forest.ancestry(f).level);
    if (count.size() <= level) count.resize(level + 1);
    ++count[level];
  }
  return count;
}

/// One row for each hanging vertex.
std::string to_csv(const std::vector<HangingVertex>& hanging) {
  std::string text = "vertex,end0,end1\n";
  for (const HangingVertex& h : hanging)
    text += fmt::format("{},{},{}\n", h.vertex.value, h.ends[0].value, h.ends[1].value);
  return text;
}

void remark_on_ancestry(const std::filesystem::path& output) {
  const std::string extension = to_lower(output.extension().string());
  if (extension != ".ply" && extension != ".vtu")
    remark(fmt::format("{}: keeps no root, level and path of the faces; .ply and .vtu do",
                       output.string()));
}

void AdaptCommand::operator()() const {
  const Run current(run);
  const int rounds = parse_levels(levels);
  const Closure kind = parse_closure();
  const SchemeChoice choice = choose_adaptive_scheme(scheme);
  if (!surfaces.empty() && choice.scheme->name != "linear")
    throw UsageError(
        "--surfaces: vertices start halfway between others, then go onto their surface; right is "
        "--scheme linear");
  require_where(where);
  check_mesh_output(output, run);
  if (!constraints.empty()) {
    if (kind != Closure::hanging)
      throw UsageError("--constraints: only --closure hanging leaves vertices inside sides");
    check_output(constraints, run, {".csv"});
  }
  Mesh control = load_refinable_mesh(mesh);
  const auto exact = surfaces.empty() ? nullptr : place_on_surfaces(surfaces, control);
  const SplitUnit unit = kind == Closure::conforming ? SplitUnit::families : SplitUnit::faces;
  Grown grown =
      naming_file(mesh.file, [&] { return grow(control, choice, unit, exact.get(), rounds); });
  if (grown.rounds < rounds)
    remark(fmt::format("{}: nothing was split from round {} on: no face is meant by {}",
                       mesh.file.string(), grown.rounds + 1, quote(where)));
  check_interrupt();
  const ForestMesh made = forest_mesh(grown.forest, kind);
  check_interrupt();
  if (!constraints.empty()) write_file(constraints, to_csv(made.hanging));
  save_mesh(output, made.mesh);
  remark_on_ancestry(output);

  const int vertices = made.mesh.topology.num_vertices();
  const int faces = made.mesh.topology.num_faces();
  const std::vector<int> leaves = leaves_by_level(grown.forest);
  if (run.json)
    print_object({{"vertices", vertices},
                  {"faces", faces},
                  {"leaves", grown.forest.leaves().size()},
                  {"leaves_by_level", leaves},
                  {"hanging_vertices", made.hanging.size()},
                  {"seconds", current.seconds()},
                  {"peak_memory", peak_memory()}});
  else if (!is_standard_output(output))
    print(fmt::format("{}: {} vertices, {} faces; leaves by level {}\n", output.string(), vertices,
                      faces, fmt::join(leaves, " ")));
}

}  // namespace

void add_adapt(CLI::App& program) {
  const auto command = std::make_shared<AdaptCommand>();
  CLI::App& app = *program.add_subcommand("adapt", "Refine a quad mesh in places");
  add_output_option(app, command->output,
                    "Mesh to write: .vtu or .ply, which keep ancestry;\n"
                    ".obj, .off or .stl");
  add_mesh_options(app, command->mesh);
  app.add_option("--constraints", command->constraints,
                 "Also write the vertices that hang and the ends of\ntheir sides: .csv")
      ->option_text("FILE")
      ->group(files_group);
  app.add_option("--surfaces", command->surfaces,
                 "Put the vertices on exact surfaces: the tables\n[geometry], [[curve]], [[seam]] "
                 "of a problem file; .toml")
      ->option_text("FILE")
      ->group(files_group);
  add_scheme_options(app, command->scheme);
  app.add_option("--where", command->where,
                 "Which faces to split: a condition in x y z that all\n"
                 "their corners satisfy, group:NAME, part:NAME or all")
      ->required()
      ->option_text("EXPR (required)")
      ->group(work_group);
  app.add_option("--levels", command->levels, "How many rounds")
      ->required()
      ->option_text("N (required)")
      ->group(work_group);
  app.add_option("--closure", command->closure,
                 "What happens where levels meet [conforming]\n"
                 "  conforming  quads only, no vertex inside a side\n"
                 "  triangles   triangles in the coarser face\n"
                 "  hanging     vertices inside sides remain")
      ->option_text("KIND")
      ->group(work_group);
  add_run_options(app, command->run);
  app.footer(
      "Schemes: catmull-clark, kobbelt, linear. Vertices lie on the limit surface of the mesh, or "
      "with\n--surfaces on exact ones. Faces "
      "that share a vertex differ by one level at most, so more is split than was asked for.\n\n"
      "  limes adapt torus.obj -o local.vtu --scheme kobbelt --where 'x > 0' --levels 3");
  app.final_callback([command] { (*command)(); });
}

}  // namespace limes::app
