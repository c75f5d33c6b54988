#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "limes/core/atomic_file.h"
#include "limes/mesh/mesh.h"

namespace limes {

/// A mesh as read, and what its reader left out or changed: one sentence each, with file and line.
struct MeshFile {
  Mesh mesh;
  std::vector<std::string> remarks;
};

/// Reads obj, off, ply or stl, chosen by the extension (upper or lower case).
/// Readers check syntax and numbers; whether the faces make a surface is for mesh/ to say.
/// @throws InputError "FILE:LINE: what is wrong; what would be right"
[[nodiscard]] MeshFile read_mesh(const std::filesystem::path& file);

/// Writes obj, off, ply, stl or vtu, chosen by the extension; the file appears complete or not at
/// all (core/atomic_file.h). Coordinates read back to the same doubles, except from stl (float).
/// Formats without tags get no hole faces, and no mesh of which nothing else is left.
/// @return what the format could not keep, one sentence each
/// @throws UsageError for an unknown extension, OutputError if the file cannot be written,
///         Interrupted (core/interrupt.h)
std::vector<std::string> write_mesh(const std::filesystem::path& file, const Mesh& mesh);
/// The same as one of several files, which appears when they are committed.
std::vector<std::string> write_mesh(const std::filesystem::path& file, const Mesh& mesh,
                                    AtomicFiles& files);

/// The readers on memory. `file` is the name that messages show.
[[nodiscard]] MeshFile read_obj(std::string_view text, std::string_view file);
[[nodiscard]] MeshFile read_off(std::string_view text, std::string_view file);
[[nodiscard]] MeshFile read_ply(std::string_view bytes, std::string_view file);
[[nodiscard]] MeshFile read_stl(std::string_view bytes, std::string_view file);

/// Receives a file piece by piece.
using ByteSink = std::function<void(std::string_view)>;

/// The writers on any sink. They write every face, hole or not.
void write_obj(const ByteSink& sink, const Mesh& mesh);
void write_off(const ByteSink& sink, const Mesh& mesh);
void write_ply(const ByteSink& sink, const Mesh& mesh);
void write_stl(const ByteSink& sink, const Mesh& mesh);
void write_vtu(const ByteSink& sink, const Mesh& mesh);

/// One row of the table behind `limes formats`. A format that cannot be read (written) has no
/// reader (writer).
struct Format {
  std::string_view name;
  std::string_view extension;  ///< with its dot
  MeshFile (*read)(std::string_view bytes, std::string_view file);
  void (*write)(const ByteSink& sink, const Mesh& mesh);
  bool tags;                ///< keeps creases, corners, holes, boundary rules
  bool names;               ///< keeps groups and parts
  std::string_view reads;   ///< what the reader takes and ignores
  std::string_view writes;  ///< what the writer puts down
};

extern const std::array<Format, 5> all_formats;

}  // namespace limes
