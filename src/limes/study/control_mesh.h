#pragma once

#include <filesystem>
#include <functional>

#include "limes/io/io.h"
#include "limes/problem/problem.h"

namespace limes {

struct ModelOptions {
  bool repair = false;  ///< mend what mesh/repair.h can mend
  /// Called with every control mesh before anything is made of it; throws to refuse its size.
  std::function<void(const Problem&, const Mesh&)> check_size = {};
};

/// The mesh file, meant from the problem file's folder.
[[nodiscard]] std::filesystem::path mesh_path(const Problem& problem);

/// The control mesh, cut along its junctions if these are tied, with remarks of the reader and on what was mended.
/// @throws InputError as read_mesh() and repair()
[[nodiscard]] MeshFile read_control_mesh(const Problem& problem, const ModelOptions& options);

}  // namespace limes
