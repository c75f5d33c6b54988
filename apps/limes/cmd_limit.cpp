#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "files.h"
#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/text.h"
#include "limes/io/vtu.h"
#include "limes/limit/curved_cells.h"
#include "limes/mesh/measure.h"
#include "memory.h"
#include "mesh_surface.h"
#include "run.h"
#include "terminal.h"

namespace limes::app {
namespace {

struct LimitCommand {
  MeshOptions mesh;
  std::filesystem::path output;
  SchemeOptions scheme;
  RunOptions run;
  std::string cells = "lagrange";
  std::string tolerance = "1e-6";

  void operator()() const;
};

enum class CellKind { lagrange, bezier };

CellKind parse_cells(const std::string& name) {
  if (name == "lagrange") return CellKind::lagrange;
  if (name == "bezier") return CellKind::bezier;
  throw UsageError("--cells: there is no kind {}; known are lagrange, bezier", quote(name));
}

std::vector<double> flat(const std::vector<Vec3>& values) {
  std::vector<double> result;
  result.reserve(3 * values.size());
  for (const Vec3& x : values)
    result.insert(result.end(), {x[0], x[1], x[2]});
  return result;
}

VtkCell vtk_cell(CellKind kind, const CellShape& shape) {
  const bool bezier = kind == CellKind::bezier;
  if (shape.triangle) return bezier ? VtkCell::bezier_triangle : VtkCell::lagrange_triangle;
  return bezier ? VtkCell::bezier_quad : VtkCell::lagrange_quad;
}

void add_cells(const CurvedCells& cells, const CellShape& shape, VtkCell type, VtuGrid& grid) {
  const auto order =
      shape.triangle ? vtk_triangle_points(shape.degree) : vtk_quad_points(shape.degree);
  std::vector<std::int64_t> faces, corners;
  std::vector<std::int64_t> points(order.size());
  for (std::size_t c = 0; c < cells.cells.size(); ++c) {
    const auto first = static_cast<std::int64_t>(c) * shape.num_nodes();
    for (std::size_t k = 0; k < order.size(); ++k)
      points[k] = first + shape.node(order[k][0], order[k][1]);
    grid.add_cell(type, points);
    faces.push_back(cells.cells[c].face.value);
    corners.push_back(cells.cells[c].corner);
  }
  grid.cell_data.push_back({"face", 1, std::move(faces)});
  grid.cell_data.push_back({"corner", 1, std::move(corners)});
}

VtuGrid make_grid(CurvedCells cells, const CellShape& shape, CellKind kind) {
  if (kind == CellKind::bezier) {
    cells.points = bernstein_coefficients(shape, cells.points);
    cells.normals = bernstein_coefficients(shape, cells.normals);
    cells.mean = bernstein_coefficients(shape, cells.mean);
    cells.gauss = bernstein_coefficients(shape, cells.gauss);
  }
  VtuGrid grid;
  add_cells(cells, shape, vtk_cell(kind, shape), grid);
  grid.points = std::move(cells.points);
  grid.point_data.push_back({"normal", 3, flat(cells.normals)});
  grid.point_data.push_back({"mean_curvature", 1, std::move(cells.mean)});
  grid.point_data.push_back({"gauss_curvature", 1, std::move(cells.gauss)});
  return grid;
}

std::string summary(std::size_t num_cells, std::size_t num_exact, double deviation) {
  const std::string cells = counted(num_cells, "cell", "cells");
  if (num_exact == num_cells) return cells + ", all exact";
  return fmt::format("{}, {} of them exact; the others deviate by up to {:.2g}", cells, num_exact,
                     deviation);
}

void LimitCommand::operator()() const {
  const Run current(run);
  const SchemeChoice choice = choose_scheme(scheme);
  require_limit(choice);
  const CellKind kind = parse_cells(cells);
  const double relative = parse_positive("--tolerance", tolerance);
  check_output(output, run, {".vtu"});
  const MeshSurface surface(load_refinable_mesh(mesh), choice, mesh.file.string());
  const double diagonal = bounding_box(surface.mesh()).diagonal();
  CurvedCells curved;
  {
    const Progress progress(fmt::format("evaluating {}", mesh.file.string()));
    curved = curved_cells(surface.surface(), surface.visible_faces(), relative * diagonal);
  }
  check_interrupt();
  const std::size_t num_cells = curved.cells.size();
  const std::size_t num_exact = static_cast<std::size_t>(std::count_if(
      curved.cells.begin(), curved.cells.end(), [](const auto& cell) { return cell.exact; }));
  const double deviation = curved.deviation();
  write_vtu(output, make_grid(std::move(curved), cell_shape(choice.scheme->split), kind));
  if (deviation > relative * diagonal)
    remark(
        fmt::format("{}: cells deviate from the surface by up to {:.2g}, {:.2g} of the diagonal; "
                    "halving further would not help",
                    output.string(), deviation, deviation / diagonal));
  if (run.json)
    print_object({{"cells", num_cells},
                  {"exact_cells", num_exact},
                  {"deviation", deviation},
                  {"tolerance", relative * diagonal},
                  {"seconds", current.seconds()},
                  {"peak_memory", peak_memory()}});
  else if (!is_standard_output(output))
    print(fmt::format("{}: {}\n", output.string(), summary(num_cells, num_exact, deviation)));
}

}  // namespace

void add_limit(CLI::App& program) {
  const auto command = std::make_shared<LimitCommand>();
  CLI::App& app = *program.add_subcommand("limit", "The limit surface as curved cells");
  add_output_option(app, command->output, "File to write: .vtu");
  add_mesh_options(app, command->mesh);
  add_scheme_options(app, command->scheme);
  app.add_option("--cells", command->cells,
                 "lagrange: points on the surface (VTK type 70;\n"
                 "69 on the triangles of loop)\n"
                 "bezier: Bernstein coefficients (77; 76) [lagrange]")
      ->option_text("KIND")
      ->group(work_group);
  app.add_option("--tolerance", command->tolerance,
                 "Largest deviation around extraordinary vertices and\n"
                 "semi-sharp creases, as part of the diagonal [1e-6]")
      ->option_text("T")
      ->group(work_group);
  add_run_options(app, command->run);
  app.footer(
      "Cells are of degree 3 in both directions, of degree 4 on the triangles of loop.\n"
      "Point data: normal, mean_curvature, gauss_curvature as samples at the nodes, NaN where "
      "they\n"
      "do not exist. Cell data: face and corner, the control face a cell lies on. Every cell has\n"
      "points of its own. Holes are left out. ParaView shows curves after 'Nonlinear Subdivision\n"
      "Level' is raised.\n\n"
      "  limes limit cube.obj -o cube.vtu --scheme catmull-clark");
  app.final_callback([command] { (*command)(); });
}

}  // namespace limes::app
