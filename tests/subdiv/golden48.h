#pragma once

#include <string>
#include <vector>

#include "limes/mesh/mesh.h"

namespace limes::golden48 {

/// A mesh of tests/data/quasi48, with what is said of the step that made it.
struct State {
  Mesh mesh;
  std::vector<std::vector<int>> tagged_edges;  // lower vertex first, ascending
  std::vector<int> tagged_vertices;            // ascending
  int unsplit_faces = 0;
};
struct File {
  std::string name;
  State input;
  std::vector<std::pair<int, State>> after;  // number of steps, state
};

/// All files whose names start so.
[[nodiscard]] std::vector<File> read(const std::string& prefix);

}  // namespace limes::golden48
