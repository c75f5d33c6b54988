// One control mesh, two surfaces. A chess rook whose edges carry sharpness tags is drawn as its
// control mesh, as the Catmull-Clark surface without the tags, and as the surface with them: sharp
// for the first subdivision steps and smooth afterwards, so that edges become narrow rounds.
//
//   chess_piece data/rook.obj FOLDER      writes FOLDER/chess-piece.png and .svg

#include <fmt/core.h>

#include <filesystem>
#include <iostream>

#include "limes/io/io.h"
#include "limes/limit/limit_surface.h"
#include "limes/report/figure_grid.h"
#include "limes/report/pictures.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"

namespace {

using namespace limes;

constexpr int steps = 3;  // of subdivision, before points and normals are taken from the limit
constexpr BoundaryRule boundary = BoundaryRule::edges;

/// Flat faces and their edges.
Scene control_mesh_scene(const Mesh& mesh) {
  Surface faces;
  faces.points = mesh.points.vector();
  faces.triangles = triangulate(mesh.topology, mesh.points.span()).triangles;
  Scene scene;
  scene.surfaces.push_back(std::move(faces));
  scene.lines.push_back(edge_lines(mesh.topology, mesh.points.span()));
  scene.lines.back().width = 0.9;
  return scene;
}

/// Exact points and normals of the limit surface at the corners of the refined faces. Every face
/// has corners of its own: at an infinitely sharp edge the faces beside it have different normals.
Surface limit_surface(const Mesh& mesh) {
  const Scheme& scheme = find_scheme("catmull-clark");
  const Mesh fine = refine(mesh, scheme, {steps, boundary});
  const LimitBasis basis(fine.topology, resolve_tags(Adjacency(fine.topology), fine.tags, boundary),
                         scheme);
  const LimitSurface limit(basis, fine.points.span());

  Surface surface;
  const std::array<Vec2, 4> corners{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
  for (int f = 0; f < fine.topology.num_faces(); ++f) {
    const int first = static_cast<int>(surface.points.size());
    for (const Vec2& uv : corners) {
      const SurfacePoint point = limit.evaluate(FaceId(f), 0, uv);
      surface.points.push_back(point.x);
      surface.normals.push_back(point.normal.value_or(Vec3::Zero()));  // none at a cusp
    }
    surface.triangles.push_back({first, first + 1, first + 2});
    surface.triangles.push_back({first, first + 2, first + 3});
  }
  return surface;
}

Scene limit_scene(const Mesh& mesh) {
  Scene scene;
  scene.surfaces.push_back(limit_surface(mesh));
  return scene;
}

Mesh without_sharpness(Mesh mesh) {
  mesh.tags.creases.clear();
  mesh.tags.corners.clear();
  return mesh;
}

/// All three with the same camera: the same scale, so that what subdivision shrinks looks smaller.
FigureGrid comparison(const Mesh& mesh) {
  const PictureSize size{268, 430};
  const Scene control = control_mesh_scene(mesh);
  const Camera camera = fit_camera(control, Vec3(-0.5, 0.85, -0.42), Vec3(0, 0, 1),
                                   static_cast<double>(size.width) / size.height);
  FigureGrid grid{.columns = 3, .title = "One control mesh, two surfaces"};
  const auto add = [&](const Scene& scene, const std::string& label) {
    Figure figure;
    figure.image = render(scene, camera, {.size = size});
    figure.caption = label;
    grid.figures.push_back(std::move(figure));
  };
  add(control, fmt::format("control mesh: {} faces", mesh.topology.num_faces()));
  add(limit_scene(without_sharpness(mesh)), "Catmull-Clark without tags");
  add(limit_scene(mesh), fmt::format("with {} semi-sharp edges", mesh.tags.creases.size()));
  return grid;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: chess_piece MESH.obj FOLDER\n";
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[2];
    std::filesystem::create_directories(folder);
    const Drawing picture = drawing(comparison(read_mesh(argv[1]).mesh));
    for (const char* name : {"chess-piece.png", "chess-piece.svg"}) {
      write_drawing(folder / name, picture);
      std::cout << (folder / name).string() << '\n';
    }
  } catch (const std::exception& error) {
    std::cerr << "chess_piece: " << error.what() << '\n';
    return 1;
  }
}
