#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "limes/core/error.h"
#include "limes/mesh/face_error.h"
#include "limes/problem/place.h"
#include "options.h"

namespace limes::app {

/// Reads a mesh, mends it if asked to, and says on standard error what was left out or changed.
[[nodiscard]] Mesh load_mesh(const MeshOptions& options);
/// The same for work that needs a mesh without defects.
[[nodiscard]] Mesh load_refinable_mesh(const MeshOptions& options);

/// Writes a mesh and says on standard error what the format could not keep.
void save_mesh(const std::filesystem::path& file, const Mesh& mesh);

/// Fails now rather than after the work: no such folder, wrong extension, no right to write, a file
/// that is standard output where --json will print.
/// @param extensions  those that are right, each with its dot; none: any
/// @param option      that names the file
/// @throws UsageError, OutputError
void check_output(const std::filesystem::path& file, const RunOptions& run,
                  const std::vector<std::string>& extensions = {},
                  std::string_view option = "--output");
/// The same for a file that holds a mesh.
void check_mesh_output(const std::filesystem::path& file, const RunOptions& run);
/// The same for a folder, which is made later if it does not exist; empty: there is none.
void check_output_folder(const std::filesystem::path& folder);

/// Does work on a mesh that came from a file, and names the file in what is wrong with the mesh.
template <class Work>
auto naming_file(const std::filesystem::path& file, const Work& work) {
  try {
    return work();
  } catch (const PlacedError&) {
    throw;
  } catch (const InputError& error) {
    throw InputError("{}: {}", file.string(), error.what());
  }
}

/// The same, naming also the line of the face that is wrong.
template <class Work>
auto naming_file(const std::filesystem::path& file, const Mesh& mesh, const Work& work) {
  return naming_file(file, [&] {
    try {
      return work();
    } catch (const FaceError& error) {
      throw PlacedError("{}: {}", place_of(mesh, error.face(), file.string()), error.what());
    }
  });
}

/// All bytes of a file. @throws InputError
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file);

}  // namespace limes::app
