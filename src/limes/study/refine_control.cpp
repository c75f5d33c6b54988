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
  const auto fail = [&](const std::string& place, const char* what) {
    fail_at(culprit({place, false, 0}, {problem.mesh.origin.of("scheme")}), "{}", what);
  };
  try {
    require_faces(control.topology, scheme);
    return refine(control, scheme, options);
  } catch (const FaceError& error) {
    fail(place_of(control, error.face(), file), error.what());
  } catch (const InputError& error) {
    fail(file, error.what());
  }
  return {};
}

}  // namespace limes
