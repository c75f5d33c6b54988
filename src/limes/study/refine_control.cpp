#include "limes/study/refine_control.h"

#include "limes/core/error.h"
#include "limes/mesh/face_error.h"
#include "limes/study/control_mesh.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"

namespace limes {

Mesh refine_control(const Problem& problem, const Mesh& control, const RefineOptions& options) {
  const std::string file = mesh_path(problem).string();
  const Scheme& scheme = find_scheme(problem.mesh.scheme);
  const auto blamed = [&](const std::string& place) {
    return culprit({place, false, 0}, {problem.mesh.origin.of("scheme")});
  };
  try {
    require_faces(control.topology, scheme);
    return refine(control, scheme, options);
  } catch (const FaceError& error) {
    fail_with(blamed(place_of(control, error.face(), file)), error.what());
  } catch (const InputError& error) {
    fail_with(blamed(file), error.what());
  }
}

}  // namespace limes
