#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>

#include "commands.h"
#include "files.h"
#include "limes/core/atomic_file.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"
#include "limes/core/text.h"
#include "limes/io/lines.h"
#include "memory.h"
#include "mesh_surface.h"
#include "run.h"
#include "sample_points.h"
#include "terminal.h"

namespace limes::app {
namespace {

struct EvaluateCommand {
  MeshOptions mesh;
  std::filesystem::path points, output;
  SchemeOptions scheme;
  RunOptions run;

  void operator()() const;
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

/// Evaluates piece by piece, so that memory does not grow with the number of points.
void write_table(const LimitSurface& surface, std::span<const SamplePoint> points,
                 const std::filesystem::path& output) {
  constexpr std::size_t piece = 1 << 14;
  AtomicFile file(output);
  file.write(head);
  Progress progress("evaluating", static_cast<std::int64_t>(points.size()));
  std::vector<SurfacePoint> values;
  for (std::size_t begin = 0; begin < points.size(); begin += piece) {
    check_interrupt();
    const auto part = points.subspan(begin, std::min(piece, points.size() - begin));
    values.resize(part.size());
    for_each_block(
        static_cast<std::int64_t>(part.size()), 64, [&](std::int64_t first, std::int64_t last) {
          for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
            values[i] = surface.evaluate(part[i].face, part[i].corner, part[i].uv);
        });
    fmt::memory_buffer text;
    for (const SurfacePoint& p : values)
      append_row(p, text);
    file.write({text.data(), text.size()});
    progress.advance(static_cast<std::int64_t>(part.size()));
  }
  check_interrupt();
  file.commit();
}

void EvaluateCommand::operator()() const {
  const Run current(run);
  const SchemeChoice choice = choose_scheme(scheme);
  check_output(output);
  const MeshSurface surface(load_refinable_mesh(mesh), choice, mesh.file.string());
  const auto samples = read_sample_points(points, surface.mesh().topology);
  for (const SamplePoint& p : samples)
    if (!surface.has_surface(p.face))
      throw error_at(points.string(), p.line,
                     "face {} touches the boundary and has no surface with boundary rule none",
                     p.face.value);
  write_table(surface.surface(), samples, output);
  if (run.json)
    print_object({{"points", samples.size()},
                  {"seconds", current.seconds()},
                  {"peak_memory", peak_memory()}});
  else if (!is_standard_output(output))
    print(fmt::format("{}: {}\n", output.string(), counted(samples.size(), "point", "points")));
}

}  // namespace

void add_evaluate(CLI::App& program) {
  const auto command = std::make_shared<EvaluateCommand>();
  CLI::App& app = *program.add_subcommand("evaluate", "Points, derivatives and curvature exactly");
  app.add_option("--at", command->points, "Where: a table with the columns face,corner,u,v")
      ->required()
      ->option_text("POINTS.csv (required)")
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
      "the middle of the face. What does not exist at a point is an empty field.\n\n"
      "  limes evaluate cube.obj --scheme catmull-clark --at points.csv -o values.csv");
  app.final_callback([command] { (*command)(); });
}

}  // namespace limes::app
