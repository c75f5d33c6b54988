#include "limes/study/control_mesh.h"

#include <fmt/format.h>

#include "limes/core/error.h"
#include "limes/core/text.h"
#include "limes/mesh/junctions.h"
#include "limes/mesh/repair.h"

namespace limes {

std::filesystem::path mesh_path(const Problem& problem) {
  const std::filesystem::path& file = problem.mesh.file;
  return file.is_absolute() ? file : problem.file.parent_path() / file;
}

namespace {

void repair_file(MeshFile& file) {
  RepairResult repaired = repair(file.mesh);
  file.mesh = std::move(repaired.mesh);
  file.remarks.insert(file.remarks.end(), repaired.done.begin(), repaired.done.end());
}

/// @return whether it has junctions
bool cut_file(const std::string& name, MeshFile& file) {
  try {
    CutMesh cut = cut_junctions(file.mesh);
    file.mesh = std::move(cut.mesh);
    if (cut.num_edges > 0)
      file.remarks.push_back(
          fmt::format("{}: cut along {} with three faces or more, and tied there", name,
                      counted(static_cast<std::size_t>(cut.num_edges), "edge", "edges")));
    return cut.num_edges > 0;
  } catch (const InputError& error) {
    throw InputError("{}: {}", name, error.what());
  }
}

}  // namespace

MeshFile read_control_mesh(const Problem& problem, const ModelOptions& options) {
  MeshFile file = read_mesh(mesh_path(problem));
  if (options.repair) repair_file(file);
  const bool is_cut = problem.junctions && cut_file(mesh_path(problem).string(), file);
  if (is_cut && options.repair) repair_file(file);
  if (options.check_size) options.check_size(problem, file.mesh);
  return file;
}

}  // namespace limes
