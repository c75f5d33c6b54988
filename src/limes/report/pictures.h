#pragma once

#include "limes/mesh/mesh.h"
#include "limes/mesh/triangulate.h"
#include "limes/report/camera.h"
#include "limes/report/figure.h"
#include "limes/report/render.h"

namespace limes {

/// What a face of a control mesh means for the surface there. Of several that apply, the last.
enum class FaceCategory {
  regular,        ///< all vertices inside, of regular valence: a spline patch
  extraordinary,  ///< an inner vertex of another valence, or another number of corners
  boundary,       ///< a vertex on the boundary
  corner          ///< a boundary vertex with no other face
};

/// Regular is valence 4 and four corners, in meshes of triangles only valence 6 and three.
/// @throws InputError for a mesh that is no surface (see Adjacency)
[[nodiscard]] std::vector<FaceCategory> classify_faces(const Topology& topology);
/// Vertices of irregular valence: inside, and on the boundary where the number of faces is neither
/// that of a straight boundary (2; triangles 3) nor 1.
[[nodiscard]] std::vector<VertexId> extraordinary_vertices(const Topology& topology);

/// Every edge of the mesh once, but for those that only holes have.
[[nodiscard]] Lines edge_lines(const Topology& topology, std::span<const Vec3> points,
                               std::span<const FaceId> holes = {});

/// Common wishes for a picture. The size is an upper limit: pictures get the model's proportions.
struct PictureOptions {
  std::string title = {};
  std::string caption = {};
  PictureSize size{760, 560};
  double density = 2;
  /// Look along this direction, in perspective; without it straight from +z onto a plane model.
  std::optional<Vec3> direction = {};
  Vec3 up = Vec3(0, 0, 1);  ///< with a direction only
  bool axes = false;        ///< with a direction only: x, y, z beside the picture, as they are seen
};

/// (a) A control mesh: faces in the colours of their categories, dark edges, extraordinary vertices
/// marked, with a legend of what occurs. Faces tagged as holes are left open.
[[nodiscard]] Figure control_mesh_figure(const Mesh& mesh, const PictureOptions& options);

/// (b) A field on a triangulation.
struct FieldPicture {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<double> values;  ///< per point; NaN: no data
  std::string quantity;        ///< "σ_{xx}"
  std::string unit;            ///< "N/mm²"
  /// Empty: chosen by the values (scale_for), leaving out `outliers` of them at either end.
  std::optional<ColourScale> scale = {};
  double outliers = 0;
  Lines mesh_lines = {};  ///< drawn over the field, e.g. edge_lines(); may be empty
  Lines borders = {};     ///< drawn over these, e.g. the borders of parts; may be empty
  Lines behind = {};      ///< drawn where the field does not hide it; may be empty
  /// Per point, for the shading in space; empty: from the triangles. They change the colours by 6 % at most.
  std::vector<Vec3> normals = {};
};
/// With more faces than this, lines along their sides would hide the colours of a field.
inline constexpr int most_faces_with_sides = 20'000;
/// A field that may jump between faces: every corner of a face has a point of its own.
/// @param points  per vertex
/// @param values  per halfedge: at the corner where it starts
/// @param holes   faces to be left open; what they have in `points` and `values` still counts for the frame and the bar
[[nodiscard]] FieldPicture corner_field(const Topology& topology, std::span<const Vec3> points,
                                        std::vector<double> values,
                                        std::span<const FaceId> holes = {});
/// @param in_space  seen from any side: shaded faintly
[[nodiscard]] Scene field_scene(const FieldPicture& field, const ColourScale& scale, bool in_space);
[[nodiscard]] Figure field_figure(const FieldPicture& field, const PictureOptions& options);

/// (c) A shaded surface, with a control mesh around it where it is seen.
struct SurfacePicture {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<Vec3> normals = {};  ///< per point; empty: from the triangles
  Lines control_mesh = {};         ///< e.g. edge_lines(); may be empty
};
[[nodiscard]] Figure surface_figure(const SurfacePicture& surface, const PictureOptions& options);

/// The last step of all of them: a scene in a figure.
[[nodiscard]] Figure scene_figure(const Scene& scene, const PictureOptions& options);

}  // namespace limes
