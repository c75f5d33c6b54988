#include "limes/io/obj_tags.h"

#include <algorithm>
#include <array>
#include <utility>

#include "limes/core/text.h"
#include "limes/io/lines.h"

namespace limes {
namespace {

/// Which of the creases lie on an edge of the mesh. Looks once at every side of every face.
std::vector<bool> creases_on_edges(const std::vector<CreaseTag>& creases, const Topology& mesh) {
  using Edge = std::pair<VertexId, VertexId>;
  std::vector<Edge> wanted;
  for (const CreaseTag& c : creases)
    wanted.push_back(std::minmax(c.a, c.b));
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  std::vector<bool> found(wanted.size(), false);
  const auto index = [&](const Edge& edge) {
    return std::lower_bound(wanted.begin(), wanted.end(), edge) - wanted.begin();
  };
  for (int f = 0; f < mesh.num_faces() && !wanted.empty(); ++f) {
    const auto face = mesh.face(FaceId(f));
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Edge side = std::minmax(face[i], face[(i + 1) % face.size()]);
      const auto at = static_cast<std::size_t>(index(side));
      if (at < wanted.size() && wanted[at] == side) found[at] = true;
    }
  }
  std::vector<bool> result;
  for (const CreaseTag& c : creases)
    result.push_back(found[static_cast<std::size_t>(index(std::minmax(c.a, c.b)))]);
  return result;
}

/// Understands tag lines one after the other.
class Resolver {
 public:
  Resolver(std::string_view file, const std::vector<std::int64_t>& skipped_faces, const Mesh& mesh,
           MeshBuilder& builder)
      : file_(file), skipped_faces_(skipped_faces), mesh_(mesh), builder_(builder) {}

  void add(const ObjTag& tag);
  Tags finish();

 private:
  void add_crease(const ObjTag& tag);
  void add_corner(const ObjTag& tag);
  void add_hole(const ObjTag& tag);
  void set_boundary(const ObjTag& tag);
  bool choice(const ObjTag& tag, std::string_view yes, std::string_view no) const;
  VertexId vertex(const ObjTag& tag, std::size_t i) const;
  float sharpness(const ObjTag& tag, std::size_t i);
  void expect(bool condition, const ObjTag& tag, std::string_view right) const;

  std::string_view file_;
  const std::vector<std::int64_t>& skipped_faces_;
  const Mesh& mesh_;
  MeshBuilder& builder_;
  Tags tags_;
  std::vector<std::int64_t> crease_lines_;
};

void Resolver::expect(bool condition, const ObjTag& tag, std::string_view right) const {
  if (!condition) throw error_at(file_, tag.line, "tag {}: {}", quote(tag.name), right);
}

VertexId Resolver::vertex(const ObjTag& tag, std::size_t i) const {
  const std::int64_t number = tag.integers[i];
  const int n = mesh_.topology.num_vertices();
  if (number < 0 || number >= n)
    throw error_at(file_, tag.line,
                   "tag {}: vertex {} does not exist; tags count vertices from 0 to {}",
                   quote(tag.name), number, n - 1);
  return VertexId(number);
}

/// Value i, or the only value.
float Resolver::sharpness(const ObjTag& tag, std::size_t i) {
  const float value = tag.reals.size() == 1 ? tag.reals[0] : tag.reals[i];
  if (value >= 0) return value;
  builder_.add_remark(tag.line, "negative sharpness taken as 0");
  return 0;
}

/// Two vertices and a sharpness; or a chain of vertices with one sharpness or one per edge (as
/// RenderMan and early OpenSubdiv); or pairs with one sharpness per pair.
void Resolver::add_crease(const ObjTag& tag) {
  const std::size_t n = tag.integers.size();
  const std::size_t values = tag.reals.size();
  const bool pairs = n > 2 && n % 2 == 0 && values == n / 2;
  expect(n >= 2 && (values == 1 || values == n - 1 || pairs), tag,
         "a crease has two vertices and a sharpness, as in 't crease 2/1/0 0 1 2.5'");
  if (n > 2 && n % 2 == 0 && values == 1)
    builder_.add_remark(tag.line, "crease tag read as a chain of edges, not as pairs of vertices");
  const std::size_t step = pairs ? 2 : 1;
  for (std::size_t i = 0; i + 1 < n; i += step) {
    tags_.creases.push_back({vertex(tag, i), vertex(tag, i + 1), sharpness(tag, i / step)});
    crease_lines_.push_back(tag.line);
  }
}

void Resolver::add_corner(const ObjTag& tag) {
  const std::size_t n = tag.integers.size();
  expect(n >= 1 && (tag.reals.size() == 1 || tag.reals.size() == n), tag,
         "a corner has a vertex and a sharpness, as in 't corner 1/1/0 0 2.5'");
  for (std::size_t i = 0; i < n; ++i)
    tags_.corners.push_back({vertex(tag, i), sharpness(tag, i)});
}

void Resolver::add_hole(const ObjTag& tag) {
  const auto skipped = static_cast<std::int64_t>(skipped_faces_.size());
  const std::int64_t num_faces = mesh_.topology.num_faces() + skipped;
  for (const std::int64_t number : tag.integers) {
    if (number < 0 || number >= num_faces)
      throw error_at(file_, tag.line,
                     "tag 'hole': face {} does not exist; tags count faces from 0 to {}", number,
                     num_faces - 1);
    const auto at = std::lower_bound(skipped_faces_.begin(), skipped_faces_.end(), number);
    const bool exists = at == skipped_faces_.end() || *at != number;
    if (exists) tags_.holes.emplace_back(number - (at - skipped_faces_.begin()));
  }
}

void Resolver::set_boundary(const ObjTag& tag) {
  constexpr std::array rules{BoundaryRule::none, BoundaryRule::edges_and_corners,
                             BoundaryRule::edges};
  expect(tag.integers.size() == 1 && tag.integers[0] >= 0 && tag.integers[0] <= 2, tag,
         "one number is right: 0 (none), 1 (edges and corners) or 2 (edges)");
  tags_.boundary = rules[static_cast<std::size_t>(tag.integers[0])];
}

/// Whether the tag's word is `yes`; an error when it is neither.
bool Resolver::choice(const ObjTag& tag, std::string_view yes, std::string_view no) const {
  const bool known = tag.words.size() == 1 && (tag.words[0] == yes || tag.words[0] == no);
  if (!known)
    throw error_at(file_, tag.line, "tag {}: one word is right: '{}' or '{}'", quote(tag.name), no,
                   yes);
  return tag.words[0] == yes;
}

void Resolver::add(const ObjTag& tag) {
  if (tag.name == "crease") {
    add_crease(tag);
  } else if (tag.name == "corner") {
    add_corner(tag);
  } else if (tag.name == "hole") {
    add_hole(tag);
  } else if (tag.name == "interpolateboundary") {
    set_boundary(tag);
  } else if (tag.name == "creasemethod") {
    tags_.crease_method =
        choice(tag, "chaikin", "normal") ? CreaseMethod::chaikin : CreaseMethod::uniform;
  } else if (tag.name == "smoothtriangles") {
    tags_.smooth_triangles = choice(tag, "smooth", "catmark");
  } else if (tag.name.rfind("facevarying", 0) != 0) {  // texture coordinates are not read
    builder_.add_remark(tag.line, "unknown tag " + quote(tag.name) + " ignored");
  }
}

Tags Resolver::finish() {
  std::vector<CreaseTag> kept;
  const std::vector<bool> on_edge = creases_on_edges(tags_.creases, mesh_.topology);
  for (std::size_t i = 0; i < on_edge.size(); ++i) {
    if (on_edge[i])
      kept.push_back(tags_.creases[i]);
    else
      builder_.add_remark(crease_lines_[i], "crease between vertices that share no edge left out");
  }
  tags_.creases = std::move(kept);
  std::sort(tags_.holes.begin(), tags_.holes.end());
  tags_.holes.erase(std::unique(tags_.holes.begin(), tags_.holes.end()), tags_.holes.end());
  return std::move(tags_);
}

/// "i/f/s"; missing numbers are 0, as in "2/1".
std::array<std::int64_t, 3> parse_counts(std::string_view file, std::int64_t line,
                                         std::string_view text) {
  std::array<std::int64_t, 3> counts{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < 3 && !rest.empty(); ++i) {
    const std::size_t slash = std::min(rest.find('/'), rest.size());
    const auto count = parse_integer(rest.substr(0, slash));
    if (!count || *count < 0) break;
    counts[i] = *count;
    rest.remove_prefix(std::min(slash + 1, rest.size()));
    if (rest.empty()) return counts;
  }
  throw error_at(file, line, "tag counts {} are not understood; 't crease 2/1/0 0 1 2.5' is right",
                 quote(text));
}

void check_counts(std::string_view file, const ObjTag& tag,
                  const std::array<std::int64_t, 3>& counts, std::string_view arguments) {
  std::int64_t found = 0;
  while (!next_token(arguments).empty())
    ++found;
  // each count alone first: their sum may overflow
  const bool each =
      std::all_of(counts.begin(), counts.end(), [&](std::int64_t count) { return count <= found; });
  if (!each || counts[0] + counts[1] + counts[2] != found)
    throw error_at(file, tag.line, "tag {} announces {}/{}/{} values, the line has {}",
                   quote(tag.name), counts[0], counts[1], counts[2], found);
}

}  // namespace

ObjTag parse_obj_tag(std::string_view file, std::int64_t line, std::string_view text) {
  ObjTag tag{line, std::string(next_token(text)), {}, {}, {}};
  if (tag.name == "vertexedit" || tag.name == "edgeedit" || tag.name == "faceedit")
    throw error_at(file, line, "tag {}: hierarchical edits are not supported; remove them",
                   quote(tag.name));
  const auto counts = parse_counts(file, line, next_token(text));
  check_counts(file, tag, counts, text);
  for (std::int64_t i = 0; i < counts[0]; ++i) {
    const std::string_view token = next_token(text);
    const auto value = parse_integer(token);
    if (!value)
      throw error_at(file, line, "tag {}: {} is no whole number", quote(tag.name), quote(token));
    tag.integers.push_back(*value);
  }
  for (std::int64_t i = 0; i < counts[1]; ++i) {
    const std::string_view token = next_token(text);
    const auto value = parse_single(token);
    if (!value)
      throw error_at(file, line, "tag {}: {} is no finite number; write it like 2.5",
                     quote(tag.name), quote(token));
    tag.reals.push_back(*value);
  }
  for (std::int64_t i = 0; i < counts[2]; ++i)
    tag.words.emplace_back(next_token(text));
  return tag;
}

Tags resolve_obj_tags(std::string_view file, const std::vector<ObjTag>& lines,
                      const std::vector<std::int64_t>& skipped_faces, const Mesh& mesh,
                      MeshBuilder& builder) {
  Resolver resolver(file, skipped_faces, mesh, builder);
  for (const ObjTag& tag : lines)
    resolver.add(tag);
  return resolver.finish();
}

}  // namespace limes
