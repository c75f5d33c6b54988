#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "limes/core/text.h"
#include "limes/io/chunk_writer.h"
#include "limes/io/io.h"
#include "limes/io/line_mesh_reader.h"

namespace limes {
namespace {

class OffReader : LineMeshReader {
 public:
  OffReader(std::string_view text, std::string_view file) : LineMeshReader(text, file, 0) {}

  MeshFile read();

 private:
  std::string_view next_line(std::string_view expected);
  void skip_keyword(std::string_view& line) const;
  std::array<std::int64_t, 2> read_counts();
  void read_vertex();
  void read_face();
  void remark_rest();

  std::vector<std::int64_t> corners_;  // of the face being read
};

std::string_view without_comment(std::string_view line) {
  return trim(line.substr(0, line.find('#')));
}

/// The next line that is not empty, without its comment.
std::string_view OffReader::next_line(std::string_view expected) {
  while (lines_.next()) {
    const std::string_view line = without_comment(lines_.line());
    if (!line.empty()) return line;
  }
  throw error_at(file_, lines_.number() + 1, "the file ends here; {} expected", expected);
}

/// OFF, COFF, NOFF, STOFF and combinations: coordinates come first on a vertex line in all of
/// them. The keyword may be missing; then the counts come at once.
void OffReader::skip_keyword(std::string_view& line) const {
  std::string_view rest = line;
  const std::string_view keyword = next_token(rest);
  if (parse_integer(keyword)) return;
  std::string_view prefix = keyword;
  for (const std::string_view option : {"ST", "C", "N"})
    if (prefix.substr(0, option.size()) == option) prefix.remove_prefix(option.size());
  if (prefix != "OFF")
    throw error("{} cannot be read; OFF, COFF, NOFF, STOFF or the counts are right here",
                quote(keyword));
  line = trim(rest);
  if (next_token(rest) == "BINARY") throw error("binary OFF is not supported; save it as text");
}

/// Vertices and faces; the number of edges may follow and is ignored.
std::array<std::int64_t, 2> OffReader::read_counts() {
  constexpr std::string_view expected = "the numbers of vertices and faces";
  std::string_view line = next_line(expected);
  skip_keyword(line);
  if (line.empty()) line = next_line(expected);
  std::array<std::int64_t, 2> counts{};
  // the shortest lines are "0 0 0" and "0", with their line ends
  constexpr std::array<std::int64_t, 2> least_bytes{6, 2};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string_view token = next_token(line);
    const auto count = parse_integer(token);
    if (!count || *count < 0)
      throw error("count {} is wrong; {} are right", quote(token), expected);
    const auto bytes = static_cast<std::int64_t>(lines_.rest().size()) + 1;
    if (*count > bytes / least_bytes[i])
      throw error("{} {} announced; the file is too short for them", *count,
                  i == 0 ? "vertices" : "faces");
    counts[i] = *count;
  }
  return counts;
}

void OffReader::read_vertex() {
  std::string_view line = next_line("a vertex");
  std::array<double, 3> x{};
  for (double& value : x) {
    const std::string_view token = next_token(line);
    const auto number = parse_real(token);
    if (!number)
      throw error("coordinate {} is no finite number; three like 1.5 or -2e-3 are right",
                  quote(token));
    value = *number;
  }
  builder_.add_point(x[0], x[1], x[2]);
}

void OffReader::read_face() {
  std::string_view line = next_line("a face");
  const std::string_view first = next_token(line);
  const auto size = parse_integer(first);
  if (!size || *size < 0)
    throw error("number of corners {} is wrong; 4 0 1 2 3 is a right face", quote(first));
  corners_.clear();
  for (std::int64_t i = 0; i < *size; ++i) {
    const std::string_view token = next_token(line);
    if (token.empty()) throw error("a face with {} corners names only {}", *size, i);
    const auto vertex = parse_integer(token);
    if (!vertex) throw error("vertex {} is no whole number", quote(token));
    corners_.push_back(*vertex);
  }
  builder_.add_face(corners_, lines_.number());
}

void OffReader::remark_rest() {
  while (lines_.next())
    if (!without_comment(lines_.line()).empty()) {
      builder_.add_remark(lines_.number(), "lines after the last face ignored");
      return;
    }
}

MeshFile OffReader::read() {
  const auto [num_vertices, num_faces] = read_counts();
  for (std::int64_t i = 0; i < num_vertices; ++i)
    read_vertex();
  for (std::int64_t i = 0; i < num_faces; ++i)
    read_face();
  remark_rest();
  return {builder_.build(), builder_.remarks()};
}

}  // namespace

MeshFile read_off(std::string_view text, std::string_view file) {
  return OffReader(text, file).read();
}

void write_off(const ByteSink& sink, const Mesh& mesh) {
  ChunkWriter out(sink);
  out.print("OFF\n{} {} 0\n", mesh.points.size(), mesh.topology.num_faces());
  for (const Vec3& x : mesh.points)
    out.print("{} {} {}\n", x[0], x[1], x[2]);
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const auto face = mesh.topology.face(FaceId(f));
    out.print("{}", face.size());
    for (const VertexId v : face)
      out.print(" {}", v.value);
    out.print("\n");
  }
  out.flush();
}

}  // namespace limes
