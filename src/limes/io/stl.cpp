#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "limes/core/text.h"
#include "limes/io/bytes.h"
#include "limes/io/chunk_writer.h"
#include "limes/io/io.h"
#include "limes/io/lines.h"
#include "limes/io/mesh_builder.h"

namespace limes {
namespace {

constexpr std::size_t header_size = 84;  // 80 bytes of text and the number of triangles
constexpr std::size_t record_size = 50;  // normal, three corners, two bytes of attributes

/// Gives equal positions equal numbers, in order of appearance. -0 equals 0; nothing else is near.
class Welder {
 public:
  explicit Welder(MeshBuilder& builder) : builder_(builder) {}

  std::int64_t vertex(const Vec3& x) {
    const Key key{bits(x[0]), bits(x[1]), bits(x[2])};
    const auto [entry, is_new] = vertices_.try_emplace(key, builder_.num_points());
    if (is_new) builder_.add_point(x[0], x[1], x[2]);
    return entry->second;
  }

 private:
  using Key = std::array<std::uint64_t, 3>;
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::uint64_t h = 0;
      for (const std::uint64_t part : key)
        h = (std::rotl(h, 23) ^ part) * 0x9e3779b97f4a7c15U;
      return static_cast<std::size_t>(h ^ (h >> 32U));
    }
  };
  static std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x); }

  MeshBuilder& builder_;
  std::unordered_map<Key, int, Hash> vertices_;  // looked up only, never walked through
};

class StlReader {
 public:
  StlReader(std::string_view bytes, std::string_view file)
      : file_(file), bytes_(bytes), builder_(file, 0), welder_(builder_) {}

  MeshFile read();

 private:
  void read_binary();
  void read_text();
  void read_facet(WordReader& words);
  Vec3 read_triple(WordReader& words) const;
  void add_triangle(std::int64_t line);
  void expect(WordReader& words, std::string_view keyword) const;

  std::string_view file_, bytes_;
  MeshBuilder builder_;
  Welder welder_;
  std::vector<std::int64_t> corners_;  // of the facet being read
  std::int64_t num_corners_ = 0;
};

std::size_t triangle_count(std::string_view bytes) {
  return bytes.size() < header_size ? 0 : load_number<std::uint32_t>(bytes.data() + 80);
}

/// Binary files that begin with "solid" are common: their size tells, or a NUL byte near the start.
MeshFile StlReader::read() {
  const std::size_t announced = header_size + record_size * triangle_count(bytes_);
  std::string_view start = bytes_.substr(0, 512);
  start.remove_prefix(std::min(start.find_first_not_of(" \t\r\n\xef\xbb\xbf"), start.size()));
  const bool text =
      to_lower(start.substr(0, 5)) == "solid" && start.find('\0') == std::string_view::npos;
  if (bytes_.size() >= header_size &&
      (bytes_.size() == announced || (!text && bytes_.size() > announced))) {
    read_binary();
  } else if (text) {
    read_text();
  } else if (bytes_.size() >= header_size) {
    throw InputError("{}: {} triangles announced; the file is too short for them", file_,
                     triangle_count(bytes_));
  } else {
    throw InputError("{}: no STL file; it begins with 'solid' or has a header of 84 bytes", file_);
  }
  builder_.add_remark(0, fmt::format("{} corners welded to {} vertices by equal position",
                                     num_corners_, builder_.num_points()));
  return {builder_.build(), builder_.remarks()};
}

void StlReader::read_binary() {
  const std::size_t count = triangle_count(bytes_);
  for (std::size_t t = 0; t < count; ++t) {
    const char* const record = bytes_.data() + header_size + record_size * t;
    corners_.clear();
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      const char* const at = record + 12 * corner;
      const Vec3 x(load_number<float>(at), load_number<float>(at + 4), load_number<float>(at + 8));
      if (!x.allFinite()) throw InputError("{}: triangle {}: coordinates are not finite", file_, t);
      corners_.push_back(welder_.vertex(x));
    }
    add_triangle(0);
  }
  const std::size_t rest = bytes_.size() - header_size - record_size * count;
  if (rest > 0)
    builder_.add_remark(0, fmt::format("{} bytes after the last triangle ignored", rest));
}

/// Triangles that welding collapsed are left out: their neighbours meet without them.
void StlReader::add_triangle(std::int64_t line) {
  num_corners_ += 3;
  const bool collapsed =
      corners_[0] == corners_[1] || corners_[1] == corners_[2] || corners_[2] == corners_[0];
  if (collapsed)
    builder_.add_remark(line, "triangle with two corners in one place left out");
  else
    builder_.add_face(corners_, line);
}

void StlReader::expect(WordReader& words, std::string_view keyword) const {
  const std::string_view word = words.next();
  if (to_lower(word) == keyword) return;
  throw error_at(file_, words.line(), "{}; '{}' expected",
                 word.empty() ? "the file ends here" : quote(word), keyword);
}

Vec3 StlReader::read_triple(WordReader& words) const {
  Vec3 x;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = words.next();
    const auto value = parse_real(word);
    if (!value)
      throw error_at(file_, words.line(),
                     "coordinate {} is no finite number; write it like 1.5 or -2e-3", quote(word));
    x[axis] = *value;
  }
  return x;
}

/// What follows "facet"; the normal is not looked at (some programs write NaN).
void StlReader::read_facet(WordReader& words) {
  expect(words, "normal");
  const std::int64_t line = words.line();
  for (int axis = 0; axis < 3; ++axis)
    static_cast<void>(words.next());
  expect(words, "outer");
  expect(words, "loop");
  corners_.clear();
  for (int corner = 0; corner < 3; ++corner) {
    expect(words, "vertex");
    corners_.push_back(welder_.vertex(read_triple(words)));
  }
  expect(words, "endloop");
  expect(words, "endfacet");
  add_triangle(line);
}

void StlReader::read_text() {
  WordReader words(checked_text(bytes_, file_));
  std::string_view word = words.next();
  while (to_lower(word) == "solid") {  // its name may be anything
    words.skip_line();
    for (word = words.next(); to_lower(word) == "facet"; word = words.next())
      read_facet(words);
    if (to_lower(word) != "endsolid")
      throw error_at(file_, words.line(), "{}; 'facet' or 'endsolid' expected",
                     word.empty() ? "the file ends here" : quote(word));
    words.skip_line();
    word = words.next();
  }
  if (!word.empty()) throw error_at(file_, words.line(), "{}; 'solid' expected", quote(word));
}

}  // namespace

MeshFile read_stl(std::string_view bytes, std::string_view file) {
  return StlReader(bytes, file).read();
}

void write_stl(const ByteSink& sink, const Mesh& mesh) {
  const Topology& topology = mesh.topology;
  int num_triangles = 0;
  for (int f = 0; f < topology.num_faces(); ++f)
    num_triangles += std::max(topology.face_size(FaceId(f)) - 2, 0);
  ChunkWriter out(sink);
  out.print("{:<80}", "binary STL");
  out.number(static_cast<std::uint32_t>(num_triangles));
  const auto write_point = [&](const Vec3& x) {
    for (int axis = 0; axis < 3; ++axis)
      out.number(static_cast<float>(x[axis]));
  };
  for (int f = 0; f < topology.num_faces(); ++f) {
    const auto face = topology.face(FaceId(f));
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const Vec3 &a = mesh.points[face[0]], &b = mesh.points[face[i]],
                 &c = mesh.points[face[i + 1]];
      const Vec3 normal = (b - a).cross(c - a);
      write_point(normal.stableNormalized());
      write_point(a);
      write_point(b);
      write_point(c);
      out.number(std::uint16_t{0});
    }
  }
  out.flush();
}

}  // namespace limes
