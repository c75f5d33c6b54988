#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "commands.h"
#include "files.h"
#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"
#include "limes/core/text.h"
#include "limes/io/lines.h"
#include "limes/limit/bulk_evaluator.h"
#include "limes/limit/interpolatory_surface.h"
#include "memory.h"
#include "mesh_surface.h"
#include "run.h"
#include "sample_points.h"
#include "surface_search.h"
#include "terminal.h"

namespace limes::app {
namespace {

struct EvaluateCommand {
  MeshOptions mesh;
  std::filesystem::path at, closest, rays, output;  // one of the first three is given
  SchemeOptions scheme;
  RunOptions run;

  void operator()() const;
  void report(nlohmann::ordered_json counts, const Run& current) const;
};

constexpr std::string_view head =
    "x,y,z,xu,yu,zu,xv,yv,zv,xuu,yuu,zuu,xuv,yuv,zuv,xvv,yvv,zvv,nx,ny,nz,mean,gauss\n";

/// One line; what does not exist is an empty field.
void append_row(const SurfacePoint& p, fmt::memory_buffer& out) {
  const auto append = [&](const Vec3& x) {
    fmt::format_to(std::back_inserter(out), "{},{},{},", x[0], x[1], x[2]);
  };
  const auto skip = [&](std::size_t fields) {
    for (std::size_t i = 0; i < fields; ++i)
      out.push_back(',');
  };
  append(p.x);
  if (p.first) {
    append(p.first->xu);
    append(p.first->xv);
  } else {
    skip(6);
  }
  if (p.second) {
    append(p.second->xuu);
    append(p.second->xuv);
    append(p.second->xvv);
  } else {
    skip(9);
  }
  p.normal ? append(*p.normal) : skip(3);
  if (p.curvature)
    fmt::format_to(std::back_inserter(out), "{},{}", p.curvature->mean, p.curvature->gauss);
  else
    skip(1);
  out.push_back('\n');
}

/// Lines of a table for points [first, last) of a part, from values in bulk.
void append_rows(const LimitSurface& surface, std::span<const SurfaceLocation> part,
                 const SurfaceValues& values, std::size_t first, std::size_t last,
                 fmt::memory_buffer& out) {
  auto extraordinary = std::lower_bound(values.extraordinary.begin(), values.extraordinary.end(),
                                        static_cast<std::int64_t>(first));
  for (std::size_t i = first; i < last; ++i) {
    if (extraordinary != values.extraordinary.end() &&
        *extraordinary == static_cast<std::int64_t>(i)) {
      ++extraordinary;
      append_row(surface.evaluate(part[i].face, part[i].corner, part[i].uv), out);
    } else {
      append_row(ordinary_point(values.x[i], {values.xu[i], values.xv[i]},
                                {values.xuu[i], values.xuv[i], values.xvv[i]}),
                 out);
    }
  }
}

/// The same point by point.
void append_rows(const LimitSurface& surface, std::span<const SurfaceLocation> points,
                 fmt::memory_buffer& out) {
  for (const SurfaceLocation& p : points)
    append_row(surface.evaluate(p.face, p.corner, p.uv), out);
}

/// Evaluates piece by piece, so that memory does not grow with the number of points; several
/// threads write the lines of a piece.
/// @param prepare  of a piece: what append needs
/// @param append   (piece, first, last, text): the lines of points [first, last) of the piece
template <class Prepare, class Append>
void write_table(std::span<const SamplePoint> points, const std::filesystem::path& output,
                 const Prepare& prepare, const Append& append) {
  constexpr std::size_t piece = 1 << 14;
  constexpr std::size_t rows = 1 << 9;  // of one text
  AtomicFile file(output);
  file.write(head);
  Progress progress("evaluating", static_cast<std::int64_t>(points.size()));
  std::vector<SurfaceLocation> part;
  std::vector<fmt::memory_buffer> texts(piece / rows);
  for (std::size_t begin = 0; begin < points.size(); begin += piece) {
    check_interrupt();
    part.clear();
    for (const SamplePoint& p : points.subspan(begin, std::min(piece, points.size() - begin)))
      part.push_back({p.face, p.corner, p.uv});
    prepare(part);
    const std::size_t num_texts = (part.size() + rows - 1) / rows;
    for_each_block(
        static_cast<std::int64_t>(num_texts), 1, [&](std::int64_t first, std::int64_t last) {
          for (auto t = static_cast<std::size_t>(first); t < static_cast<std::size_t>(last); ++t) {
            texts[t].clear();
            append(part, t * rows, std::min(part.size(), (t + 1) * rows), texts[t]);
          }
        });
    for (std::size_t t = 0; t < num_texts; ++t)
      file.write({texts[t].data(), texts[t].size()});
    progress.advance(static_cast<std::int64_t>(part.size()));
  }
  check_interrupt();
  file.commit();
}

nlohmann::ordered_json write_values(const MeshSurface& surface, const std::filesystem::path& points,
                                    const std::filesystem::path& output) {
  const LimitBasis& basis = surface.surface().basis();
  const auto samples = read_sample_points(points, basis.topology(), basis.scheme());
  for (const SamplePoint& p : samples)
    if (!surface.has_surface(p.face))
      throw error_at(points.string(), p.line,
                     "face {} touches the boundary and has no surface with boundary rule none",
                     p.face.value);
  std::optional<BulkEvaluator> bulk;
  if (!basis.on_triangles()) bulk.emplace(basis, surface.mesh().points.span());
  SurfaceValues values;
  write_table(
      samples, output,
      [&](std::span<const SurfaceLocation> part) {
        if (bulk) bulk->evaluate(part, 2, values);
      },
      [&](std::span<const SurfaceLocation> part, std::size_t first, std::size_t last,
          fmt::memory_buffer& out) {
        if (bulk)
          append_rows(surface.surface(), part, values, first, last, out);
        else
          append_rows(surface.surface(), part.subspan(first, last - first), out);
      });
  return {{"points", samples.size()}};
}

/// The same for a scheme whose limit is no polynomial, point by point.
nlohmann::ordered_json write_interpolatory_values(const Mesh& mesh, const SchemeChoice& choice,
                                                  const std::filesystem::path& points,
                                                  const std::filesystem::path& output) {
  const auto samples = read_sample_points(points, mesh.topology, *choice.scheme);
  const Adjacency adjacency(mesh.topology);
  const Features features =
      control_features(adjacency, mesh, *choice.scheme, choice.options_for(mesh, 0));
  const InterpolatorySurface surface(adjacency, features, *choice.scheme, mesh.points.span());
  write_table(
      samples, output, [](std::span<const SurfaceLocation>) {},
      [&](std::span<const SurfaceLocation> part, std::size_t first, std::size_t last,
          fmt::memory_buffer& out) {
        for (std::size_t i = first; i < last; ++i)
          append_row(surface.evaluate(part[i].face, part[i].uv), out);
      });
  return {{"points", samples.size()}};
}

nlohmann::ordered_json write_hits(const MeshSurface& surface, const std::filesystem::path& rays,
                                  const std::filesystem::path& output) {
  const RayCount count = write_ray_hits(surface, rays, output);
  return {{"rays", count.rays}, {"hits", count.hits}};
}

void EvaluateCommand::operator()() const {
  const int given = !at.empty() + !closest.empty() + !rays.empty();
  if (given != 1)
    throw UsageError("{} of --at, --closest and --ray are given; one is right", given);
  const Run current(run);
  const SchemeChoice choice = choose_scheme(scheme);
  require_limit(choice);
  check_output(output, run);
  nlohmann::ordered_json counts;
  if (has_tension(*choice.scheme)) {
    if (at.empty())
      throw UsageError("--closest and --ray need a polynomial limit, which {} does not have",
                       choice.scheme->name);
    counts = write_interpolatory_values(load_refinable_mesh(mesh), choice, at, output);
    report(counts, current);
    return;
  }
  const MeshSurface surface(load_refinable_mesh(mesh), choice, mesh.file.string());
  if (!at.empty())
    counts = write_values(surface, at, output);
  else if (!closest.empty())
    counts = {{"points", write_closest_points(surface, closest, output)}};
  else
    counts = write_hits(surface, rays, output);
  report(counts, current);
}

void EvaluateCommand::report(nlohmann::ordered_json counts, const Run& current) const {
  if (run.json) {
    counts["seconds"] = current.seconds();
    counts["peak_memory"] = peak_memory();
    print_object(counts);
  } else if (!is_standard_output(output)) {
    std::string text = counted(counts.begin()->get<std::size_t>(), "point", "points");
    if (!rays.empty())
      text = counted(counts["rays"].get<std::size_t>(), "ray", "rays") + ", " +
             counted(counts["hits"].get<std::size_t>(), "hit", "hits");
    print(fmt::format("{}: {}\n", output.string(), text));
  }
}

}  // namespace

void add_evaluate(CLI::App& program) {
  const auto command = std::make_shared<EvaluateCommand>();
  CLI::App& app =
      *program.add_subcommand("evaluate", "Points, derivatives, curvature; closest points, rays");
  app.add_option("--at", command->at, "Where: a table with the columns face,corner,u,v")
      ->option_text("POINTS.csv")
      ->group(files_group);
  app.add_option(
         "--closest", command->closest,
         "Find the closest points of the surface\nto points: a table with the columns x,y,z")
      ->option_text("POINTS.csv")
      ->group(files_group);
  app.add_option("--ray", command->rays,
                 "Find where rays first meet the surface:\n"
                 "a table with the columns x,y,z,dx,dy,dz")
      ->option_text("RAYS.csv")
      ->group(files_group);
  add_output_option(app, command->output, "Table to write, one line per point");
  add_mesh_options(app, command->mesh);
  add_scheme_options(app, command->scheme);
  add_run_options(app, command->run);
  app.footer(
      "Faces count from 0 in the order of the file. On a quad corner is 0, (0,0) is its first "
      "corner,\n"
      "u runs towards the second, v towards the fourth. On another face corner k picks the "
      "quadrant\n"
      "at that corner: (0,0) there, u towards the next corner, v towards the previous one, (1,1) "
      "in\n"
      "the middle of the face. With loop corner is 0, u and v are the barycentric weights of the\n"
      "second and third corner. What does not exist at a point is an empty field.\n"
      "One of --at, --closest and --ray is needed. The last two write face,corner,u,v,x,y,z and\n"
      "distance, or t and side: a ray is (x,y,z) + t (dx,dy,dz), t >= 0; one that misses is a "
      "line\n"
      "of empty fields.\n\n"
      "  limes evaluate cube.obj --scheme catmull-clark --at points.csv -o values.csv");
  app.final_callback([command] { (*command)(); });
}

}  // namespace limes::app
