#pragma once

#include <string>
#include <vector>

#include "limes/mesh/mesh.h"
#include "limes/report/camera.h"
#include "limes/report/figure_grid.h"
#include "limes/report/scene.h"

/// How the gallery draws meshes: surfaces shaded smoothly but for sharp edges, marks over them.
namespace gallery {

/// Sharp edges and vertices, and the control mesh over a refined surface.
inline constexpr limes::Colour tag_colour = limes::palette::series[1];
inline constexpr limes::Colour control_colour = limes::palette::series[0];

enum class Normals {
  facets,  ///< every triangle its own: flat shading
  smooth   ///< shared by faces at a vertex that meet at less than sharp_angle degrees
};
inline constexpr double sharp_angle = 40;

[[nodiscard]] limes::Surface surface_of(const limes::Mesh& mesh, Normals normals);
/// Edges with a crease tag.
[[nodiscard]] limes::Lines tagged_edges(const limes::Mesh& mesh);
/// Vertices with a corner tag.
[[nodiscard]] limes::Markers tagged_vertices(const limes::Mesh& mesh);

/// Faces as they are with all edges and tags: a control mesh.
[[nodiscard]] limes::Scene control_scene(const limes::Mesh& mesh);
/// A refined mesh without its edges, with tags.
[[nodiscard]] limes::Scene surface_scene(const limes::Mesh& mesh);

/// What control_scene() and surface_scene() mark, for a legend; no more than occurs.
[[nodiscard]] std::vector<limes::LegendEntry> tag_legend(const limes::Mesh& mesh);

/// From where a row of pictures is seen, the same in all of them.
struct View {
  limes::Vec3 direction = limes::default_direction();
  limes::Vec3 up = limes::Vec3(0, 0, 1);
  limes::PictureSize size{280, 280};
  double density = 1.2;
};

/// A view of several scenes: the camera has the first one tightly in the picture.
class Viewer {
 public:
  Viewer(const limes::Scene& first, const View& view);
  [[nodiscard]] limes::Figure figure(const limes::Scene& scene, std::string title,
                                     std::string caption) const;

 private:
  View view_;
  limes::Camera camera_;
};

/// A plane mesh from above, as lines.
[[nodiscard]] limes::Figure plane_figure(const limes::Scene& scene, const View& view,
                                         std::string title, std::string caption);

}  // namespace gallery
