#include <algorithm>
#include <set>
#include <string>

#include "limes/core/text.h"
#include "limes/io/chunk_writer.h"
#include "limes/io/io.h"

namespace limes {
namespace {

/// A name as it can stand in the file: blanks end a group's name, line ends end every name.
std::string file_name(const std::string& name, bool blanks_allowed) {
  std::string result = name.empty() ? "_" : name;
  for (char& c : result)
    if (c == '\n' || c == '\r' || c == '\0' || c == '\\' || (is_blank(c) && !blanks_allowed))
      c = '_';
  return result;
}

/// A run of faces of one group begins or ends at this face.
struct Change {
  int face;
  int group;
  bool begins;
};

std::vector<Change> changes_of(const std::vector<FaceGroup>& groups) {
  std::vector<Change> changes;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto& faces = groups[g].faces;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const int face = faces[i].value;
      const bool starts = i == 0 || faces[i - 1].value != face - 1;
      const bool stops = i + 1 == faces.size() || faces[i + 1].value != face + 1;
      if (starts) changes.push_back({face, static_cast<int>(g), true});
      if (stops) changes.push_back({face + 1, static_cast<int>(g), false});
    }
  }
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.face < b.face; });
  return changes;
}

/// Writes the 'o' or 'g' lines between the faces.
class NameLines {
 public:
  NameLines(const std::vector<FaceGroup>& groups, char keyword)
      : groups_(groups), keyword_(keyword), changes_(changes_of(groups)) {}

  void before_face(int face, ChunkWriter& out) {
    if (next_ == changes_.size() || changes_[next_].face != face) return;
    for (; next_ < changes_.size() && changes_[next_].face == face; ++next_) {
      const Change& change = changes_[next_];
      if (change.begins)
        active_.insert(change.group);
      else
        active_.erase(change.group);
    }
    out.print("{}", keyword_);
    for (const int group : active_)
      out.print(" {}", file_name(groups_[static_cast<std::size_t>(group)].name, keyword_ == 'o'));
    out.print("\n");
  }

 private:
  const std::vector<FaceGroup>& groups_;
  char keyword_;
  std::vector<Change> changes_;
  std::size_t next_ = 0;
  std::set<int> active_;
};

void write_faces(ChunkWriter& out, const Mesh& mesh) {
  NameLines parts(mesh.parts, 'o');
  NameLines groups(mesh.groups, 'g');
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    parts.before_face(f, out);
    groups.before_face(f, out);
    out.print("f");
    for (const VertexId v : mesh.topology.face(FaceId(f)))
      out.print(" {}", v.value + std::int64_t{1});
    out.print("\n");
  }
}

int boundary_number(BoundaryRule rule) {
  switch (rule) {
    case BoundaryRule::none:
      return 0;
    case BoundaryRule::edges_and_corners:
      return 1;
    case BoundaryRule::edges:
      return 2;
  }
  return 2;
}

void write_tags(ChunkWriter& out, const Tags& tags) {
  if (tags.boundary) out.print("t interpolateboundary 1/0/0 {}\n", boundary_number(*tags.boundary));
  if (tags.crease_method == CreaseMethod::chaikin) out.print("t creasemethod 0/0/1 chaikin\n");
  if (tags.smooth_triangles) out.print("t smoothtriangles 0/0/1 smooth\n");
  for (const CreaseTag& c : tags.creases)
    out.print("t crease 2/1/0 {} {} {}\n", c.a.value, c.b.value, c.sharpness);
  for (const CornerTag& c : tags.corners)
    out.print("t corner 1/1/0 {} {}\n", c.vertex.value, c.sharpness);
  for (const FaceId f : tags.holes)
    out.print("t hole 1/0/0 {}\n", f.value);
}

}  // namespace

void write_obj(const ByteSink& sink, const Mesh& mesh) {
  ChunkWriter out(sink);
  for (const Vec3& x : mesh.points)
    out.print("v {} {} {}\n", x[0], x[1], x[2]);
  write_faces(out, mesh);
  write_tags(out, mesh.tags);
  out.flush();
}

}  // namespace limes
