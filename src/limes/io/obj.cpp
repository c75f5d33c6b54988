#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "limes/core/text.h"
#include "limes/io/curves.h"
#include "limes/io/io.h"
#include "limes/io/line_mesh_reader.h"
#include "limes/io/obj_polylines.h"
#include "limes/io/obj_tags.h"

namespace limes {
namespace {

/// Named sets of faces in order of their first appearance.
class GroupTable {
 public:
  /// Index of the group of that name, new or known.
  int index(const std::string& name) {
    const auto [entry, is_new] = index_.try_emplace(name, static_cast<int>(groups_.size()));
    if (is_new) groups_.push_back({name, {}});
    return entry->second;
  }
  void add(int group, FaceId face) {
    groups_[static_cast<std::size_t>(group)].faces.push_back(face);
  }
  /// The groups that have faces.
  std::vector<FaceGroup> take() {
    std::erase_if(groups_, [](const FaceGroup& group) { return group.faces.empty(); });
    return std::move(groups_);
  }

 private:
  std::map<std::string, int> index_;
  std::vector<FaceGroup> groups_;
};

constexpr std::size_t most_groups = 64;
constexpr std::array<std::string_view, 9> ignored_keywords{"vt", "vn", "vp",  "usemtl", "mtllib",
                                                           "s",  "p",  "lod", "usemap"};

class ObjReader : LineMeshReader {
 public:
  ObjReader(std::string_view text, std::string_view file) : LineMeshReader(text, file, 1) {}

  MeshFile read();
  CurveFile read_curves();

 private:
  void read_line(std::string_view line);
  void read_polyline(std::string_view rest);
  void read_vertex(std::string_view rest);
  void read_face(std::string_view rest);
  void read_groups(std::string_view rest);
  void read_part(std::string_view rest);
  std::int64_t corner_vertex(std::string_view corner) const;
  std::string valid_name(std::string_view name);

  bool only_curves_ = false;
  bool any_polyline_ = false;
  ObjPolylines polylines_;
  std::vector<ObjTag> tags_;
  std::int64_t face_statements_ = 0;
  std::vector<std::int64_t> skipped_faces_;
  std::vector<std::int64_t> corners_;  // of the face being read
  GroupTable groups_, parts_;
  std::vector<int> current_groups_;
  std::optional<int> current_part_;
  bool any_part_ = false;
};

/// The next word of a data line; a comment ends the line.
std::string_view next_word(std::string_view& rest) {
  const std::string_view word = next_token(rest);
  return word.empty() || word[0] == '#' ? std::string_view() : word;
}

MeshFile ObjReader::read() {
  while (lines_.next_joined())
    read_line(lines_.line());
  if (any_polyline_ && builder_.num_faces() == 0)
    throw InputError(
        "{}: polylines and no faces; schemes for curves (four-point, chaikin, lane-riesenfeld:D) "
        "refine "
        "them",
        file_);
  MeshFile result;
  result.mesh = builder_.build();
  result.mesh.tags = resolve_obj_tags(file_, tags_, skipped_faces_, result.mesh, builder_);
  result.mesh.groups = groups_.take();
  if (any_part_) result.mesh.parts = parts_.take();
  result.remarks = builder_.remarks();
  return result;
}

/// Faces, names and tags are no concern of curves.
CurveFile ObjReader::read_curves() {
  only_curves_ = true;
  while (lines_.next_joined())
    read_line(lines_.line());
  return {polylines_.build(file_, builder_.points()), builder_.remarks()};
}

void ObjReader::read_line(std::string_view line) {
  std::string_view rest = line;
  const std::string_view keyword = next_word(rest);
  if (keyword.empty()) return;
  if (only_curves_ && keyword != "v") {
    if (keyword == "l") read_polyline(rest);
    return;
  }
  if (keyword == "v") {
    read_vertex(rest);
  } else if (keyword == "f") {
    read_face(rest);
  } else if (keyword == "g") {
    read_groups(rest);
  } else if (keyword == "o") {
    read_part(rest);
  } else if (keyword == "t") {
    tags_.push_back(parse_obj_tag(file_, lines_.number(), rest));
  } else if (keyword == "l") {
    any_polyline_ = true;  // read_curves() is for them
  } else if (std::find(ignored_keywords.begin(), ignored_keywords.end(), keyword) ==
             ignored_keywords.end()) {
    builder_.add_remark(lines_.number(), "unknown keyword " + quote(keyword) + " ignored");
  }
}

/// x y z, then optionally a weight or a colour or both, which are checked and forgotten.
void ObjReader::read_vertex(std::string_view rest) {
  std::array<double, 7> values{};
  std::size_t count = 0;
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
    const auto value = parse_real(word);
    if (!value)
      throw error("coordinate {} is no finite number; write it like 1.5 or -2e-3", quote(word));
    if (count < values.size()) values[count] = *value;
    ++count;
  }
  if (count != 3 && count != 4 && count != 6 && count != 7)
    throw error(
        "a vertex with {} numbers; 3 coordinates are right, a weight and a colour may follow",
        count);
  if (count == 4 && values[3] != 1)
    builder_.add_remark(lines_.number(), "weight of a vertex ignored; all weigh the same");
  builder_.add_point(values[0], values[1], values[2]);
}

/// The vertex of a corner a, a/b, a//c or a/b/c, counted from 0.
std::int64_t ObjReader::corner_vertex(std::string_view corner) const {
  const std::size_t slash = std::min(corner.find('/'), corner.size());
  const auto number = parse_integer(corner.substr(0, slash));
  int parts = 1;
  for (std::size_t begin = slash; begin < corner.size(); ++parts) {
    const std::size_t end = std::min(corner.find('/', begin + 1), corner.size());
    const std::string_view part = corner.substr(begin + 1, end - begin - 1);
    if (!part.empty() && !parse_integer(part)) parts = 4;
    begin = end;
  }
  if (!number || parts > 3)
    throw error("corner {} is not understood; 7, 7/1, 7//2 and 7/1/2 are right", quote(corner));
  if (*number == 0) throw error("vertex 0 does not exist; vertices are numbered from 1");
  if (*number > 0) return *number - 1;
  if (*number < -std::int64_t{builder_.num_points()})
    throw error("relative vertex {} does not exist; {} vertices come before it", *number,
                builder_.num_points());
  return builder_.num_points() + *number;
}

void ObjReader::read_face(std::string_view rest) {
  corners_.clear();
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest))
    corners_.push_back(corner_vertex(word));
  const FaceId face(builder_.num_faces());
  if (builder_.add_face(corners_, lines_.number())) {
    if (!current_part_) current_part_ = parts_.index("default");
    parts_.add(*current_part_, face);
    for (const int group : current_groups_)
      groups_.add(group, face);
  } else {
    skipped_faces_.push_back(face_statements_);
  }
  ++face_statements_;
}

void ObjReader::read_polyline(std::string_view rest) {
  corners_.clear();
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest))
    corners_.push_back(corner_vertex(word));
  if (corners_.size() < 2)
    throw error("a polyline with {}; 2 or more are right",
                counted(corners_.size(), "vertex", "vertices"));
  polylines_.add(corners_, lines_.number());
}

/// Without a name: no group. Every face is stored once for each of its groups, so their number is
/// limited.
void ObjReader::read_groups(std::string_view rest) {
  current_groups_.clear();
  for (std::string_view word = next_token(rest); !word.empty(); word = next_token(rest)) {
    const int group = groups_.index(valid_name(word));
    if (std::find(current_groups_.begin(), current_groups_.end(), group) != current_groups_.end())
      continue;
    if (current_groups_.size() == most_groups)
      throw error("more than {} groups at once; a face can be in {} groups", most_groups,
                  most_groups);
    current_groups_.push_back(group);
  }
}

/// The name is the rest of the line and may contain blanks.
void ObjReader::read_part(std::string_view rest) {
  const std::string_view name = trim(rest);
  current_part_ = parts_.index(name.empty() ? "default" : valid_name(name));
  any_part_ = true;
}

std::string ObjReader::valid_name(std::string_view name) {
  std::string result(name);
  if (is_valid_utf8(name)) return result;
  builder_.add_remark(lines_.number(), "name is not UTF-8; foreign letters become '?'");
  for (char& c : result)
    if (static_cast<unsigned char>(c) >= 0x80) c = '?';
  return result;
}

}  // namespace

CurveFile read_obj_curves(std::string_view text, std::string_view file) {
  return ObjReader(text, file).read_curves();
}

MeshFile read_obj(std::string_view text, std::string_view file) {
  return ObjReader(text, file).read();
}

}  // namespace limes
