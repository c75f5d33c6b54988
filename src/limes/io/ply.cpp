#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "limes/core/text.h"
#include "limes/io/bytes.h"
#include "limes/io/chunk_writer.h"
#include "limes/io/io.h"
#include "limes/io/lines.h"
#include "limes/io/mesh_builder.h"
#include "limes/io/ply_header.h"

namespace limes {
namespace {

/// The values behind the header one after the other, all as doubles (which hold every PLY type).
class PlyValues {
 public:
  PlyValues(std::string_view bytes, std::string_view file, const PlyHeader& header)
      : file_(file),
        encoding_(header.encoding),
        data_(bytes.substr(header.size)),
        words_(data_, header.num_lines + 1) {}

  double next(PlyType type) {
    return encoding_ == PlyEncoding::ascii ? next_word() : next_binary(type);
  }
  /// Passes over values without looking at them.
  void skip(PlyType type, std::int64_t count);
  /// Whether anything follows the value read last.
  [[nodiscard]] bool any_left() {
    return encoding_ == PlyEncoding::ascii ? !words_.next().empty() : !data_.empty();
  }
  /// Line of the value read last; 0 in binary files.
  [[nodiscard]] std::int64_t line() const {
    return encoding_ == PlyEncoding::ascii ? words_.line() : 0;
  }
  void set_entry(std::string_view element, std::int64_t entry) {
    element_ = element, entry_ = entry;
  }

  template <class... Args>
  [[nodiscard]] InputError error(fmt::format_string<Args...> format, Args&&... args) const {
    if (encoding_ == PlyEncoding::ascii)
      return error_at(file_, words_.line(), format, std::forward<Args>(args)...);
    return InputError("{}: {} {}: {}", file_, element_, entry_,
                      fmt::format(format, std::forward<Args>(args)...));
  }

 private:
  double next_word();
  double next_binary(PlyType type);

  std::string_view file_;
  PlyEncoding encoding_;
  std::string_view data_;
  WordReader words_;
  std::string_view element_;
  std::int64_t entry_ = 0;
};

double PlyValues::next_word() {
  const std::string_view word = words_.next();
  if (word.empty()) throw error("the file ends here; a number expected");
  const auto value = parse_real(word);
  if (!value) throw error("{} is no finite number; write it like 1.5 or -2e-3", quote(word));
  return *value;
}

double PlyValues::next_binary(PlyType type) {
  const std::size_t size = size_of(type);
  if (data_.size() < size) throw error("the file ends inside it");
  const char* const bytes = data_.data();
  data_.remove_prefix(size);
  const std::endian order =
      encoding_ == PlyEncoding::binary_big_endian ? std::endian::big : std::endian::little;
  switch (type) {
    case PlyType::int8:
      return load_number<std::int8_t>(bytes, order);
    case PlyType::uint8:
      return load_number<std::uint8_t>(bytes, order);
    case PlyType::int16:
      return load_number<std::int16_t>(bytes, order);
    case PlyType::uint16:
      return load_number<std::uint16_t>(bytes, order);
    case PlyType::int32:
      return load_number<std::int32_t>(bytes, order);
    case PlyType::uint32:
      return load_number<std::uint32_t>(bytes, order);
    case PlyType::float32:
      return static_cast<double>(load_number<float>(bytes, order));
    case PlyType::float64:
      return load_number<double>(bytes, order);
  }
  return 0;
}

void PlyValues::skip(PlyType type, std::int64_t count) {
  if (encoding_ != PlyEncoding::ascii) {
    const auto available = static_cast<std::int64_t>(data_.size() / size_of(type));
    if (count > available) throw error("the file ends inside it");
    data_.remove_prefix(static_cast<std::size_t>(count) * size_of(type));
    return;
  }
  for (std::int64_t i = 0; i < count; ++i)
    if (words_.next().empty()) throw error("the file ends here; a number expected");
}

class PlyReader {
 public:
  PlyReader(std::string_view bytes, std::string_view file)
      : file_(file),
        header_(checked_header(bytes, file)),
        values_(bytes, file, header_),
        builder_(file, 0) {}

  MeshFile read();

 private:
  static PlyHeader checked_header(std::string_view bytes, std::string_view file);
  void read_vertices(const PlyElement& element);
  void read_faces(const PlyElement& element);
  void skip_element(const PlyElement& element);
  std::int64_t list_size(const PlyProperty& property);
  void skip_property(const PlyProperty& property);
  void read_corners(const PlyProperty& property);

  std::string_view file_;
  PlyHeader header_;
  PlyValues values_;
  MeshBuilder builder_;
  std::vector<std::int64_t> corners_;  // of the face being read
};

PlyHeader PlyReader::checked_header(std::string_view bytes, std::string_view file) {
  PlyHeader header = read_ply_header(bytes, file);
  if (header.encoding == PlyEncoding::ascii) static_cast<void>(checked_text(bytes, file));
  return header;
}

std::int64_t PlyReader::list_size(const PlyProperty& property) {
  const double size = values_.next(property.count_type);
  if (!(size >= 0 && size <= 4294967295.0 && size == std::floor(size)))
    throw values_.error("a list of {} values; 0 or more are right", size);
  return static_cast<std::int64_t>(size);
}

void PlyReader::skip_property(const PlyProperty& property) {
  values_.skip(property.type, property.is_list ? list_size(property) : 1);
}

void PlyReader::skip_element(const PlyElement& element) {
  if (element.properties.empty()) return;
  for (std::int64_t i = 0; i < element.count; ++i) {
    values_.set_entry(element.name, i);
    for (const PlyProperty& property : element.properties)
      skip_property(property);
  }
}

void PlyReader::read_vertices(const PlyElement& element) {
  const auto& properties = element.properties;
  std::vector<int> axis_of(properties.size(), -1);
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, static_cast<char>('x' + axis));
    const auto p = std::find_if(
        properties.begin(), properties.end(),
        [&](const PlyProperty& other) { return other.name == name && !other.is_list; });
    if (p == properties.end())
      throw InputError("{}: vertices have no property '{}'; x, y and z are needed", file_, name);
    axis_of[static_cast<std::size_t>(p - properties.begin())] = axis;
  }
  for (std::int64_t i = 0; i < element.count; ++i) {
    values_.set_entry("vertex", i);
    Vec3 x;
    for (std::size_t p = 0; p < properties.size(); ++p) {
      if (axis_of[p] < 0)
        skip_property(properties[p]);
      else
        x[axis_of[p]] = values_.next(properties[p].type);
    }
    if (!x.allFinite()) throw values_.error("coordinates are not finite");
    builder_.add_point(x[0], x[1], x[2]);
  }
}

void PlyReader::read_corners(const PlyProperty& property) {
  const std::int64_t size = list_size(property);
  corners_.clear();
  for (std::int64_t k = 0; k < size; ++k) {
    const double vertex = values_.next(property.type);
    if (!(std::abs(vertex) < 9e15 && vertex == std::floor(vertex)))
      throw values_.error("vertex {} is no whole number", vertex);
    corners_.push_back(static_cast<std::int64_t>(vertex));
  }
}

void PlyReader::read_faces(const PlyElement& element) {
  const auto is_corners = [](const PlyProperty& p) {
    return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
  };
  const auto& properties = element.properties;
  const auto corners = std::find_if(properties.begin(), properties.end(), is_corners);
  if (corners == properties.end())
    throw InputError("{}: faces have no list 'vertex_indices'", file_);
  for (std::int64_t i = 0; i < element.count; ++i) {
    values_.set_entry("face", i);
    std::int64_t line = 0;
    for (const PlyProperty& property : properties) {
      if (&property != &*corners) {
        skip_property(property);
        continue;
      }
      read_corners(property);
      line = values_.line();
    }
    builder_.add_face(corners_, line);
  }
}

MeshFile PlyReader::read() {
  for (const PlyElement& element : header_.elements) {
    if (element.name == "vertex")
      read_vertices(element);
    else if (element.name == "face")
      read_faces(element);
    else
      skip_element(element);
  }
  if (values_.any_left()) builder_.add_remark(0, "data after the last element ignored");
  return {builder_.build(), builder_.remarks()};
}

}  // namespace

MeshFile read_ply(std::string_view bytes, std::string_view file) {
  return PlyReader(bytes, file).read();
}

namespace {

/// PLY has no whole numbers of eight bytes: larger ones are written as doubles.
bool fits_int(const FaceField& field) {
  return std::all_of(field.values.begin(), field.values.end(),
                     [](std::int64_t x) { return x == static_cast<std::int32_t>(x); });
}

void write_field(const FaceField& field, bool as_int, std::size_t face, ChunkWriter& out) {
  if (as_int)
    out.number(static_cast<std::int32_t>(field.values[face]));
  else
    out.number(static_cast<double>(field.values[face]));
}

}  // namespace

void write_ply(const ByteSink& sink, const Mesh& mesh) {
  const int num_faces = mesh.topology.num_faces();
  int largest = 0;
  for (int f = 0; f < num_faces; ++f)
    largest = std::max(largest, mesh.topology.face_size(FaceId(f)));
  const bool short_lists = largest <= 255;
  ChunkWriter out(sink);
  out.print(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nelement face {}\n"
      "property list {} int vertex_indices\n",
      mesh.points.size(), num_faces, short_lists ? "uchar" : "uint");
  std::vector<bool> as_int;
  for (const FaceField& field : mesh.face_fields) {
    as_int.push_back(fits_int(field));
    out.print("property {} {}\n", as_int.back() ? "int" : "double", field.name);
  }
  out.print("end_header\n");
  for (const Vec3& x : mesh.points)
    for (int axis = 0; axis < 3; ++axis)
      out.number(x[axis]);
  for (int f = 0; f < num_faces; ++f) {
    const auto face = mesh.topology.face(FaceId(f));
    if (short_lists)
      out.number(static_cast<std::uint8_t>(face.size()));
    else
      out.number(static_cast<std::uint32_t>(face.size()));
    for (const VertexId v : face)
      out.number(v.value);
    for (std::size_t k = 0; k < as_int.size(); ++k)
      write_field(mesh.face_fields[k], as_int[k], static_cast<std::size_t>(f), out);
  }
  out.flush();
}

}  // namespace limes
