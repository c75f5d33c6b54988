#include <fmt/format.h>

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>

#include "commands.h"
#include "files.h"
#include "forest_size.h"
#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/text.h"
#include "limes/io/io.h"
#include "limes/limit/forest_limits.h"
#include "limes/study/leaf_selection.h"
#include "limes/study/surface_placement.h"
#include "limes/subdiv/bisection_forest.h"
#include "limes/subdiv/forest_mesh.h"
#include "limes/subdiv/forest_seams.h"
#include "memory.h"
#include "run.h"
#include "terminal.h"

namespace limes::app {
namespace {

/// What was refined, in how many rounds, and a mesh made of it.
struct Grown {
  int rounds = 0;
  std::vector<int> leaves_by_level;
  ForestMesh made;
};

/// What --surfaces says about a mesh.
struct ExactSurfaces {
  SurfaceSettings settings;
  std::vector<TiedEdge> seams;  ///< edges of the control mesh
  Placement placement;          ///< refers to the settings
};

using SplitLeaves = std::function<void(const std::vector<FaceId>&)>;

struct AdaptCommand {
  MeshOptions mesh;
  std::filesystem::path output, constraints, surfaces;
  SchemeOptions scheme;
  RunOptions run;
  std::string where, levels;
  std::string closure;
  bool bisect = false;

  void operator()() const;

 private:
  [[nodiscard]] Closure parse_closure() const;
  void require_bisection(const SchemeChoice& choice) const;
  [[nodiscard]] Grown grow(const Mesh& control, const SchemeChoice& choice, Closure kind,
                           const ExactSurfaces* exact, int rounds, const ForestSize& size) const;
  void grow(const LocalRefinement& forest, int rounds, const ForestSize& size,
            const SplitLeaves& split, Grown& grown) const;
  void save(const ForestMesh& made) const;
};

Closure AdaptCommand::parse_closure() const {
  if (closure.empty() || closure == "conforming") return Closure::conforming;
  if (closure == "triangles") return Closure::triangles;
  if (closure == "hanging") return Closure::hanging;
  throw UsageError("--closure: there is no closure {}; known are conforming, triangles, hanging",
                   quote(closure));
}

int parse_levels(const std::string& levels, int most) {
  const int rounds = parse_whole_number("--levels", levels, 0);
  if (rounds > most)
    throw UsageError("--levels: {} is more than {}, the most levels that a face can have", rounds,
                     most);
  return rounds;
}

SchemeChoice choose_adaptive_scheme(const SchemeOptions& options) {
  SchemeChoice choice = choose_scheme(options);
  require_limit(choice);
  if (choice.scheme->split == Split::four_eight)
    throw UsageError(
        "--scheme: {} has no limit points to place vertices at; --scheme linear --bisect splits "
        "the same way",
        choice.scheme->name);
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

/// Bisection moves no vertex and needs no closure.
void AdaptCommand::require_bisection(const SchemeChoice& choice) const {
  if (choice.scheme->patch != LimitPatch::bilinear)
    throw UsageError("--bisect: halves are placed by the scheme linear only, not by {}",
                     choice.scheme->name);
  if (!closure.empty() && closure != "conforming")
    throw UsageError(
        "--closure: bisection leaves nothing to close; with --bisect it is conforming");
  if (!surfaces.empty())
    throw UsageError("--surfaces: halves stay halfway between others; leave --bisect out");
}

/// Leaves of a forest on each level.
std::vector<int> leaves_by_level(const LocalRefinement& forest) {
  std::vector<int> count;
  for (const FaceId f : forest.leaves()) {
    const auto level = static_cast<std::size_t>(forest.ancestry(f).level);
    if (count.size() <= level) count.resize(level + 1);
    ++count[level];
  }
  return count;
}

void AdaptCommand::grow(const LocalRefinement& forest, int rounds, const ForestSize& size,
                        const SplitLeaves& split, Grown& grown) const {
  Progress progress(fmt::format("refining {}", mesh.file.string()), rounds);
  LeafSelection selection(forest, where);
  if (selection.means_all()) size.require_all(rounds);
  for (; grown.rounds < rounds; ++grown.rounds) {
    check_interrupt();
    const std::vector<FaceId> marked = selection.leaves(forest);
    if (marked.empty()) break;
    size.require_round(grown.rounds + 1, std::ssize(forest.leaves()), std::ssize(marked));
    split(marked);
    progress.advance();
  }
  check_interrupt();
  grown.leaves_by_level = leaves_by_level(forest);
}

/// That no face has come to a point or line on its surface.
void require_area(const ExactSurfaces& exact, const Forest& forest, const ForestMesh& made) {
  const auto of_control = geometry_of_faces(exact.settings, forest.control());
  const auto root = [&](FaceId f) {
    return forest.ancestry(made.leaves[static_cast<std::size_t>(f.value)]).root.value;
  };
  std::vector<const GeometrySettings*> geometry;
  for (int f = 0; f < made.mesh.topology.num_faces(); ++f)
    geometry.push_back(of_control[static_cast<std::size_t>(root(FaceId(f)))]);
  require_faces_with_area(made.mesh, geometry, [&](FaceId f) {
    return fmt::format("face {} of the refined mesh, in face {},", f.value, root(f));
  });
}

Grown AdaptCommand::grow(const Mesh& control, const SchemeChoice& choice, Closure kind,
                         const ExactSurfaces* exact, int rounds, const ForestSize& size) const {
  Grown grown;
  if (bisect) {
    BisectionForest forest(control);
    grow(
        forest, rounds, size, [&](const auto& marked) { forest.refine(marked); }, grown);
    grown.made = forest_mesh(forest);
    return grown;
  }
  const Scheme& used = *choice.scheme;
  Forest forest(control, used, choice.options_for(control, 0),
                kind == Closure::conforming ? SplitUnit::families : SplitUnit::faces,
                has_exact_limit(used) && !exact ? forest_limits(used) : LimitsOf(),
                exact ? exact->placement : Placement());
  // Paths that join control faces with an odd number of split sides must not end at a seam.
  const bool all_at_first = exact && !exact->seams.empty() && forest.unit() == SplitUnit::families;
  const auto split = [&](const std::vector<FaceId>& marked) {
    forest.refine(all_at_first && grown.rounds == 0 ? forest.leaves() : marked);
    if (exact) match_seams(forest, exact->seams);
  };
  grow(forest, rounds, size, split, grown);
  grown.made = forest_mesh(forest, kind);
  if (exact) require_area(*exact, forest, grown.made);
  return grown;
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

/// The mesh and, if asked for, its constraints: both or none.
void AdaptCommand::save(const ForestMesh& made) const {
  const Progress progress(fmt::format("writing {}", output.string()));
  AtomicFiles files;
  if (!constraints.empty()) files.add(constraints).write(to_csv(made.hanging));
  const std::vector<std::string> lost = write_mesh(output, made.mesh, files);
  files.commit();
  for (const std::string& sentence : lost)
    remark(sentence);
}

void AdaptCommand::operator()() const {
  const Run current(run);
  const int rounds = parse_levels(levels, bisect ? BisectionForest::max_level : Forest::max_level);
  const Closure kind = parse_closure();
  const SchemeChoice choice = choose_adaptive_scheme(scheme);
  if (!surfaces.empty() && choice.scheme->name != "linear")
    throw UsageError(
        "--surfaces: vertices start halfway between others, then go onto their surface; right is "
        "--scheme linear");
  if (bisect) require_bisection(choice);
  require_where(where);
  check_mesh_output(output, run);
  if (!constraints.empty()) {
    if (kind != Closure::hanging)
      throw UsageError("--constraints: only --closure hanging leaves vertices inside sides");
    check_output(constraints, run, {".csv"}, "--constraints");
  }
  Mesh control = load_refinable_mesh(mesh);
  const auto exact = surfaces.empty() ? nullptr : place_on_surfaces(surfaces, control);
  const ForestSize size(control.topology, *choice.scheme, bisect, current.memory_limit());
  const Grown grown = naming_file(
      mesh.file, control, [&] { return grow(control, choice, kind, exact.get(), rounds, size); });
  if (grown.rounds < rounds)
    remark(fmt::format("{}: nothing was split from round {} on: no face is meant by {}",
                       mesh.file.string(), grown.rounds + 1, quote(where)));
  check_interrupt();
  const ForestMesh& made = grown.made;
  save(made);
  remark_on_ancestry(output);

  const int vertices = made.mesh.topology.num_vertices();
  const int faces = made.mesh.topology.num_faces();
  const std::vector<int>& leaves = grown.leaves_by_level;
  if (run.json)
    print_object({{"vertices", vertices},
                  {"faces", faces},
                  {"leaves", std::accumulate(leaves.begin(), leaves.end(), 0)},
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
  CLI::App& app = *program.add_subcommand("adapt", "Refine a mesh in places");
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
                 "  conforming  quads only, of triangles triangles only;\n"
                 "              no vertex inside a side\n"
                 "  triangles   triangles in the coarser face\n"
                 "  hanging     vertices inside sides remain")
      ->option_text("KIND")
      ->group(work_group);
  app.add_flag("--bisect", command->bisect,
               "Halve triangles, which other faces are cut into\nfirst: 4-8 meshes, always "
               "conforming; linear only")
      ->group(work_group);
  add_run_options(app, command->run);
  app.footer(
      "Schemes: catmull-clark, kobbelt, linear for quads, loop, butterfly, linear for triangles.\n"
      "Vertices lie on the limit surface of the mesh, or with --surfaces on exact ones. Faces\n"
      "that share a vertex differ by one level at most, so more is split than was asked for.\n\n"
      "  limes adapt torus.obj -o local.vtu --scheme kobbelt --where 'x > 0' --levels 3");
  app.final_callback([command] { (*command)(); });
}

}  // namespace limes::app
