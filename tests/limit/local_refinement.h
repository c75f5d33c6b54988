#pragma once

#include <array>
#include <optional>
#include <random>
#include <vector>

#include "limes/mesh/mesh.h"
#include "limes/subdiv/features.h"
#include "limes/subdiv/scheme.h"

namespace limes::test {

/// A mesh with resolved tags: what refinement and limits start from.
struct Model {
  Topology topology;
  Features features;
  std::vector<Vec3> points;
};

/// Tags with OpenSubdiv's default boundary rule unless told otherwise.
Model make_model(const Mesh& mesh, BoundaryRule boundary = BoundaryRule::edges);

/// Moves every point by up to amount in each direction, the same way every time.
void perturb(Mesh& mesh, double amount, unsigned seed = 1);

/// A point of the limit surface by plain refinement, the slow way that knows nothing of ring kinds:
/// two rings of faces around the face are cut out, refined, and again around the child that holds
/// (u, v), `levels` times; then the control face itself is taken for the surface.
/// For Chaikin creases the cut is three rings, as sharpness travels one ring a level.
Vec3 limit_by_refinement(const Model& model, const Scheme& scheme, FaceId face, int corner,
                         const Vec2& uv, int levels);

/// Derivatives in u and v the same way, for Catmull-Clark: after `levels` steps the face is regular, and those of the
/// uniform bicubic B-spline on the 16 points around it are scaled back. Points are kept relative to
/// the face, so that no digits are lost on the way. Nothing if the face is not regular by then.
std::optional<std::array<Vec3, 2>> tangents_by_refinement(const Model& model, const Scheme& scheme,
                                                          FaceId face, int corner, const Vec2& uv,
                                                          int levels);

}  // namespace limes::test
