// The same block of material modelled twice. Holes may be cut out of a grid as whole faces: then
// vertices with three faces appear on the boundary. Or holes and grains are set into rings of four
// quads: then all extraordinary vertices are inside and every boundary is regular. Subdivision
// isolates extraordinary vertices but keeps their number and kind, so the choice stays.
//
//   block_modelled_twice data/block.obj data/block_cut.obj FOLDER     writes FOLDER/block-meshes.*

#include <fmt/core.h>

#include <filesystem>
#include <iostream>

#include "limes/io/io.h"
#include "limes/mesh/adjacency.h"
#include "limes/report/figure_grid.h"
#include "limes/report/pictures.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"

namespace {

using namespace limes;

/// "57 faces; extraordinary: 34 inside, 0 on the boundary"
std::string summary(const Mesh& mesh) {
  const Adjacency adjacency(mesh.topology);
  int inside = 0;
  int boundary = 0;
  for (const VertexId v : extraordinary_vertices(mesh.topology))
    ++(adjacency.is_boundary(v) ? boundary : inside);
  return fmt::format("{} faces; extraordinary: {} inside, {} on the boundary",
                     mesh.topology.num_faces(), inside, boundary);
}

Figure mesh_figure(const Mesh& mesh, const std::string& title) {
  return control_mesh_figure(mesh, {.title = title, .caption = summary(mesh), .size = {400, 400}});
}

/// Control meshes above, the same after two steps below: one column per model.
FigureGrid comparison(const Mesh& rings, const Mesh& cut) {
  const auto refined = [](const Mesh& mesh) {
    return refine(mesh, find_scheme("catmull-clark"),
                  {.levels = 2, .boundary = mesh.tags.boundary.value_or(BoundaryRule::edges)});
  };
  FigureGrid grid{.columns = 2, .title = "A block of material, modelled twice"};
  grid.figures = {mesh_figure(rings, "Holes and grains set into rings"),
                  mesh_figure(cut, "Holes cut out as whole faces"),
                  mesh_figure(refined(rings), "After two steps"),
                  mesh_figure(refined(cut), "After two steps")};
  return grid;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: block_modelled_twice RINGS.obj CUT.obj FOLDER\n";
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[3];
    std::filesystem::create_directories(folder);
    const Drawing picture = drawing(comparison(read_mesh(argv[1]).mesh, read_mesh(argv[2]).mesh));
    for (const char* name : {"block-meshes.png", "block-meshes.svg"}) {
      write_drawing(folder / name, picture);
      std::cout << (folder / name).string() << '\n';
    }
  } catch (const std::exception& error) {
    std::cerr << "block_modelled_twice: " << error.what() << '\n';
    return 1;
  }
}
