#pragma once

#include "witness/same_mesh.h"

namespace limes::witness {

// Subdivision by other libraries, in double precision.

PlainMesh openmesh_sqrt3(const Mesh& mesh, int levels);
PlainMesh openmesh_butterfly(const Mesh& mesh, int levels);
PlainMesh cgal_doo_sabin(const Mesh& mesh, int levels);
PlainMesh cgal_sqrt3(const Mesh& mesh, int levels);
PlainMesh cgal_loop(const Mesh& mesh, int levels);

}  // namespace limes::witness
