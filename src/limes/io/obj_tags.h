#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "limes/io/mesh_builder.h"
#include "limes/mesh/mesh.h"

namespace limes {

/// One 't' line of an OBJ file: "t NAME i/f/s" announces i integers, f numbers and s words.
struct ObjTag {
  std::int64_t line;
  std::string name;
  std::vector<std::int64_t> integers;
  std::vector<float> reals;
  std::vector<std::string> words;
};

/// @param text the line after the 't'
/// @throws InputError for counts that do not fit the line and for hierarchical edits
[[nodiscard]] ObjTag parse_obj_tag(std::string_view file, std::int64_t line, std::string_view text);

/// The tags of a mesh. Tags count vertices and faces from 0 and may stand anywhere in the file, so
/// they are understood at the end.
/// @param skipped_faces numbers of the 'f' lines that made no face, ascending
/// @param builder       takes the remarks: creases on vertex pairs that are no edge, ...
[[nodiscard]] Tags resolve_obj_tags(std::string_view file, const std::vector<ObjTag>& lines,
                                    const std::vector<std::int64_t>& skipped_faces,
                                    const Mesh& mesh, MeshBuilder& builder);

}  // namespace limes
