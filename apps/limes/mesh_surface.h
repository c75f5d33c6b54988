#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "limes/limit/limit_surface.h"
#include "options.h"

namespace limes::app {

/// The limit surface of a mesh under a scheme and boundary rule.
class MeshSurface {
 public:
  /// @param file  name of the mesh for messages
  /// @throws InputError if the scheme has no limit that can be evaluated
  MeshSurface(Mesh mesh, const SchemeChoice& choice, std::string_view file);

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const LimitSurface& surface() const { return surface_; }
  /// With BoundaryRule::none the faces at the boundary only shape the others.
  [[nodiscard]] bool has_surface(FaceId f) const {
    return dropped_.empty() || !dropped_[static_cast<std::size_t>(f.value)];
  }
  /// The faces that have surface to show: no holes, none that only shape the others.
  /// @throws InputError if there are none
  [[nodiscard]] std::vector<FaceId> visible_faces() const;

 private:
  std::string file_;
  Mesh mesh_;
  LimitBasis basis_;
  LimitSurface surface_;
  std::vector<bool> dropped_;
};

}  // namespace limes::app
